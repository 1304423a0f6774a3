#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use crate::Number;

/// The form of every compliant law: F = K δ^n + C δ^κ δ̇, never below 0. A second slope adds K₂ (δ − d) beyond a deformation d.
///
/// A law gives K, C and the powers. C already contains the reduced mass and the approach speed of the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Form<N = f64> {
    /// Spring: K \[N/m^n\] and n.
    pub spring: Term<N>,
    /// Damper: C \[N·s/m^(1+κ)\] and κ.
    pub damper: Term<N>,
    /// When the damper acts.
    pub action: Action,
    /// The second slope of a linear spring without a damper, if the law has one.
    pub second: Option<Slope<N>>,
}

/// A stiffness that a spring gains beyond a deformation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slope<N = f64> {
    /// The deformation \[m\], > 0.
    pub from: N,
    /// The stiffness that is added \[N/m\]; negative if the second slope is softer.
    pub added: N,
}

/// Force of a compliant law and its consistent tangents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce<N = f64> {
    /// Pounding force F \[N\], ≥ 0; the left structure gets −F, the right one +F.
    pub force: N,
    /// ∂F/∂δ \[N/m\].
    pub stiffness: N,
    /// ∂F/∂δ̇ \[N·s/m\].
    pub damping: N,
}

/// A coefficient times a power of the deformation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term<N = f64> {
    /// The coefficient, ≥ 0.
    pub coefficient: N,
    /// The power.
    pub power: Power,
}

/// Powers of the deformation in the laws of the literature.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Power {
    /// 0.
    Zero,
    /// 1/4.
    Quarter,
    /// 1/2.
    Half,
    /// 1.
    One,
    /// 3/2.
    ThreeHalves,
}

/// When a damper acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// While approaching and while parting.
    Both,
    /// While approaching (δ̇ > 0) only.
    Approach,
}

impl Power {
    /// The power as a number.
    pub const fn value(self) -> f64 {
        match self {
            Self::Zero => 0.0,
            Self::Quarter => 0.25,
            Self::Half => 0.5,
            Self::One => 1.0,
            Self::ThreeHalves => 1.5,
        }
    }

    /// This power of x ≥ 0, computed from products and square roots.
    #[inline(always)]
    pub fn of<N: Number>(self, x: N) -> N {
        match self {
            Self::Zero => x.like(1.0),
            Self::Quarter => x.sqrt().sqrt(),
            Self::Half => x.sqrt(),
            Self::One => x,
            Self::ThreeHalves => x * x.sqrt(),
        }
    }
}

impl<N: Number> Term<N> {
    /// Value at a deformation ≥ 0.
    #[inline(always)]
    pub fn at(&self, deformation: N) -> N {
        self.coefficient * self.power.of(deformation)
    }
}

impl Term {
    /// No force.
    pub const NONE: Self = Self::new(0.0, Power::Zero);

    /// A coefficient ≥ 0 times a power of the deformation.
    pub const fn new(coefficient: f64, power: Power) -> Self {
        Self { coefficient, power }
    }

    /// Deformation ≥ 0 \[m\] at which the term has a given value ≥ 0. The term must not be constant.
    pub fn deformation(&self, value: f64) -> f64 {
        libm::pow(value / self.coefficient, 1.0 / self.power.value())
    }
}

impl<N: Number> Slope<N> {
    /// The force that the slope adds \[N\], and its stiffness \[N/m\].
    #[inline(always)]
    pub fn at(&self, deformation: N) -> (N, N) {
        let (zero, beyond) = (deformation.like(0.0), deformation.exceeds(self.from));
        let force = self.added * (deformation - self.from);
        (N::select(beyond, force, zero), N::select(beyond, self.added, zero))
    }
}

impl<N: Number> Form<N> {
    /// The force before the clamp \[N\]. It is negative if the law would pull.
    #[inline(always)]
    pub fn unclamped(&self, deformation: N, rate: N) -> N {
        let force = self.spring.at(deformation) + self.damping(deformation, rate) * rate;
        self.second.map_or(force, |second| force + second.at(deformation).0)
    }

    /// The force at δ > 0 \[N\]; 0 if the law would pull.
    #[inline(always)]
    pub fn force(&self, deformation: N, rate: N) -> N {
        let (force, zero) = (self.unclamped(deformation, rate), rate.like(0.0));
        N::select(zero.exceeds(force), zero, force)
    }

    /// Force and tangents at δ > 0. All are 0 if the law would pull.
    #[inline(always)]
    pub fn respond(&self, deformation: N, rate: N) -> ContactForce<N> {
        let spring = self.spring.at(deformation);
        let damping = self.damping(deformation, rate);
        let mut force = spring + damping * rate;
        let power = |term: &Term<N>| deformation.like(term.power.value());
        let slope = power(&self.spring) * spring + power(&self.damper) * damping * rate;
        let mut stiffness = slope / deformation;
        if let Some(second) = &self.second {
            let (more, stiffer) = second.at(deformation);
            (force, stiffness) = (force + more, stiffness + stiffer);
        }
        let zero = deformation.like(0.0);
        let pushes = |number: N| N::select(zero.exceeds(force), zero, number);
        ContactForce {
            force: pushes(force),
            stiffness: pushes(stiffness),
            damping: pushes(damping),
        }
    }

    /// ∂F/∂δ̇ before the clamp.
    #[inline(always)]
    fn damping(&self, deformation: N, rate: N) -> N {
        let zero = rate.like(0.0);
        match self.action {
            Action::Both => self.damper.at(deformation),
            Action::Approach => {
                let approaches = rate.exceeds(zero);
                if N::any(approaches) {
                    N::select(approaches, self.damper.at(deformation), zero)
                } else {
                    zero
                }
            }
        }
    }
}

impl Form {
    /// A spring, and a damper that acts at these times.
    pub const fn new(spring: Term, damper: Term, action: Action) -> Self {
        Self {
            spring,
            damper,
            action,
            second: None,
        }
    }

    /// Deformation \[m\] at which the spring alone has a force ≥ 0 \[N\].
    pub fn deformation(&self, force: f64) -> f64 {
        match self.second {
            Some(Slope { from, added }) if force > self.spring.at(from) => {
                from + (force - self.spring.at(from)) / (self.spring.coefficient + added)
            }
            Some(_) | None => self.spring.deformation(force),
        }
    }

    /// Energy \[J\] that the spring alone holds at a force ≥ 0 \[N\].
    pub fn stored(&self, force: f64) -> f64 {
        let deformation = self.deformation(force);
        match self.second {
            Some(Slope { from, .. }) if deformation > from => {
                let first = self.spring.at(from);
                0.5 * (first * from + (first + force) * (deformation - from))
            }
            Some(_) | None => force * deformation / (self.spring.power.value() + 1.0),
        }
    }

    /// Force and tangents at δ ≤ 0 if the damper is a linear dashpot, else `None`; see [`crate::ContactLaw::before_touch`].
    pub(crate) fn before_touch(&self, deformation: f64, rate: f64) -> Option<ContactForce> {
        let (stiffness, damping) = (self.spring.coefficient, self.damper.coefficient);
        let force = stiffness * deformation + damping * rate;
        let jumps = self.damper.power == Power::Zero && self.spring.power == Power::One;
        (jumps && force > 0.0).then_some(ContactForce { force, stiffness, damping })
    }
}
