//! The contact laws, each written from its source.
//!
//! δ is the deformation, δ̇ its rate, v₀ the rate at the first touch. The sources are those given for the laws of `pounding_contact`.

use pounding_contact::ContactLaw;

/// Contact law of a pair.
#[derive(Debug, Clone, Copy)]
pub(super) enum Law {
    /// Impulsive: a velocity jump.
    Impulsive { restitution: f64 },
    /// Compliant: a force.
    Compliant(Force),
}

/// A compliant law for a pair: a spring, with a damper beside it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Force {
    spring: Spring,
    damper: Damper,
    /// Whether the damper also acts after the approach: the formula may then pull and must be clamped.
    pub(super) is_damped_throughout: bool,
}

/// A spring without its damper.
#[derive(Debug, Clone, Copy)]
enum Spring {
    /// kδ; k in N/m.
    Linear(f64),
    /// β δ^1.5; β in N/m^1.5.
    Hertz(f64),
    /// `first` δ, and behind the deformation `bend` the stiffness `then`; N/m and m.
    Bent { first: f64, then: f64, bend: f64 },
}

/// Damper force in addition to a spring force S.
#[derive(Debug, Clone, Copy)]
enum Damper {
    /// No damper.
    None,
    /// cδ̇, beside a linear spring.
    Constant(f64),
    /// c δ^(1/4) δ̇ on approach, beside a Hertz spring.
    Quarter(f64),
    /// A √δ δ̇, beside a Hertz spring.
    Root(f64),
    /// S aδ̇/v₀.
    Factor(f64),
}

/// A touching pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touching {
    /// δ \[m\].
    pub deformation: f64,
    /// δ̇ \[m/s\].
    pub rate: f64,
    /// Whether a spring of two slopes is on its second one.
    pub bent: bool,
    /// v₀ \[m/s\], at least [`pounding_contact::SLOWEST_APPROACH`].
    pub approach_speed: f64,
}

impl Law {
    pub(super) fn of(mut law: ContactLaw, reduced_mass: f64) -> Self {
        let numbers: Vec<_> = law.parameters().iter().map(|(_, number)| **number).collect();
        let (k, last) = (numbers[0], numbers[numbers.len() - 1]);
        // c = 2 ξ̄ √(k m); for a Hertz spring with β̄ instead of k.
        let c = 2.0 * last * (k * reduced_mass).sqrt();
        let (spring, damper, is_damped_throughout) = match law {
            ContactLaw::Stereomechanical(_) => return Self::Impulsive { restitution: k },
            ContactLaw::LinearSpring(_) => (Spring::Linear(k), Damper::None, false),
            ContactLaw::Hertz(_) => (Spring::Hertz(k), Damper::None, false),
            ContactLaw::KelvinVoigt(_) => (Spring::Linear(k), Damper::Constant(c), true),
            ContactLaw::ModifiedLinearViscoelastic(_) => (Spring::Linear(k), Damper::Constant(c), false),
            ContactLaw::NonlinearViscoelastic(_) => (Spring::Hertz(k), Damper::Quarter(c), false),
            ContactLaw::HertzDamp(_) => (Spring::Hertz(k), Damper::Factor(last), true),
            ContactLaw::ModifiedKelvin(_) => (Spring::Linear(k), Damper::Factor(last), true),
            ContactLaw::PantWijeyewickrema(_) => (Spring::Linear(k), Damper::Factor(last), false),
            ContactLaw::KuwabaraKono(_) => (Spring::Hertz(k), Damper::Root(last), true),
            ContactLaw::TwoSlopes(law) => {
                let (then, bend) = (law.second_stiffness, law.second_from);
                (Spring::Bent { first: k, then, bend }, Damper::None, false)
            }
        };
        Self::Compliant(Force {
            spring,
            damper,
            is_damped_throughout,
        })
    }
}

impl Spring {
    /// The coefficient with which the force begins.
    fn stiffness(self) -> f64 {
        let (Self::Linear(k) | Self::Hertz(k) | Self::Bent { first: k, .. }) = self;
        k
    }
}

impl Force {
    /// Deformation at which a second slope begins \[m\]; `None` for other springs.
    pub(super) fn bend(self) -> Option<f64> {
        if let Spring::Bent { bend, .. } = self.spring {
            Some(bend)
        } else {
            None
        }
    }

    /// Formula of the force on approach \[N\].
    pub(super) fn on_approach(self, pair: Touching) -> f64 {
        // Trial steps may overshoot the parting.
        let delta = pair.deformation.max(0.0);
        let (root, v) = (delta.sqrt(), pair.rate);
        let spring = match self.spring {
            Spring::Linear(k) => k * delta,
            Spring::Hertz(beta) => beta * root * root * root,
            Spring::Bent { first, then, bend } if pair.bent => first * bend + then * (delta - bend),
            Spring::Bent { first, .. } => first * delta,
        };
        match self.damper {
            Damper::None => spring,
            Damper::Constant(c) => spring + c * v,
            Damper::Quarter(c) => spring + c * root.sqrt() * v,
            Damper::Root(big_a) => spring + big_a * root * v,
            Damper::Factor(a) => spring * (1.0 + a * v / pair.approach_speed),
        }
    }

    /// Formula of the force after the approach \[N\].
    pub(super) fn on_return(mut self, pair: Touching) -> f64 {
        if !self.is_damped_throughout {
            self.damper = Damper::None;
        }
        self.on_approach(pair)
    }

    /// Rate of the force times δ \[N·m/s\], in the formula of the approach. The factor δ removes the poles at the first touch.
    pub(super) fn rate_on_approach(self, pair: Touching, acceleration: f64) -> f64 {
        let delta = pair.deformation.max(0.0);
        let (root, v) = (delta.sqrt(), pair.rate);
        // The spring force, its power, and the rate of the spring force times δ.
        let (spring, n, rate) = match self.spring {
            Spring::Linear(k) => (k * delta, 1.0, k * delta * v),
            Spring::Hertz(beta) => (beta * root * delta, 1.5, 1.5 * beta * root * delta * v),
            Spring::Bent { first, then, .. } => {
                let stiffness = if pair.bent { then } else { first };
                (stiffness * delta, 1.0, stiffness * delta * v)
            }
        };
        let stiffness = self.spring.stiffness();
        match self.damper {
            Damper::None => rate,
            Damper::Constant(c) => (stiffness * v + c * acceleration) * delta,
            Damper::Quarter(c) => rate + c * root.sqrt() * (delta * acceleration + 0.25 * v * v),
            Damper::Root(big_a) => rate + big_a * root * (delta * acceleration + 0.5 * v * v),
            Damper::Factor(a) => {
                let a = a / pair.approach_speed;
                spring * (n * v * (1.0 + a * v) + delta * a * acceleration)
            }
        }
    }

    /// A number with the sign of the formula after the approach, smooth at δ = 0; 1 if the formula never pulls.
    pub(super) fn grip(self, pair: Touching) -> f64 {
        let (delta, v) = (pair.deformation, pair.rate);
        let stiffness = self.spring.stiffness();
        if !self.is_damped_throughout {
            return 1.0;
        }
        match self.damper {
            Damper::None | Damper::Quarter(_) => 1.0,
            Damper::Constant(c) | Damper::Root(c) => stiffness * delta + c * v,
            Damper::Factor(a) => pair.approach_speed + a * v,
        }
    }
}
