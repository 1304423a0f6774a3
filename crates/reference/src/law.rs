//! The contact laws, each written out from its source.
//!
//! δ is the deformation, δ̇ its rate, v₀ the rate at the first touch. The sources are those that the laws of
//! `pounding_contact` name.

use pounding_contact::ContactLaw;

/// What happens while they touch.
#[derive(Debug, Clone, Copy)]
pub(super) enum Law {
    /// A velocity jump.
    Impulsive { restitution: f64 },
    /// A force.
    Compliant(Force),
}

/// A compliant law for one pair; k and β are stiffnesses \[N/m\], \[N/m^1.5\].
#[derive(Debug, Clone, Copy)]
pub(super) enum Force {
    /// kδ.
    LinearSpring { k: f64 },
    /// β δ^1.5.
    Hertz { beta: f64 },
    /// kδ + cδ̇, never below 0; c = 2 ξ̄ √(k m).
    KelvinVoigt { k: f64, c: f64 },
    /// kδ + cδ̇ on approach, kδ after it; c = 2 ξ̄ √(k m).
    ModifiedLinearViscoelastic { k: f64, c: f64 },
    /// β δ^1.5 + c δ^(1/4) δ̇ on approach, β δ^1.5 after it; c = 2 ξ̄ √(β m).
    NonlinearViscoelastic { beta: f64, c: f64 },
    /// β δ^1.5 (1 + aδ̇/v₀), never below 0.
    HertzDamp { beta: f64, a: f64 },
    /// kδ (1 + aδ̇/v₀), never below 0.
    ModifiedKelvin { k: f64, a: f64 },
    /// kδ (1 + aδ̇/v₀) on approach, kδ after it.
    PantWijeyewickrema { k: f64, a: f64 },
    /// β δ^1.5 + A √δ δ̇, never below 0.
    KuwabaraKono { beta: f64, big_a: f64 },
}

/// A touching pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touching {
    /// δ \[m\].
    pub deformation: f64,
    /// δ̇ \[m/s\].
    pub rate: f64,
    /// v₀ \[m/s\], not below [`pounding_contact::SLOWEST_APPROACH`].
    pub approach_speed: f64,
}

impl Law {
    pub(super) fn of(law: ContactLaw, reduced_mass: f64) -> Self {
        let damping = |ratio: f64, stiffness: f64| 2.0 * ratio * (stiffness * reduced_mass).sqrt();
        Self::Compliant(match law {
            ContactLaw::Stereomechanical(law) => {
                return Self::Impulsive {
                    restitution: law.restitution,
                };
            }
            ContactLaw::LinearSpring(law) => Force::LinearSpring {
                k: law.impact_stiffness,
            },
            ContactLaw::Hertz(law) => Force::Hertz {
                beta: law.impact_stiffness,
            },
            ContactLaw::KelvinVoigt(law) => Force::KelvinVoigt {
                k: law.impact_stiffness,
                c: damping(law.impact_damping_ratio, law.impact_stiffness),
            },
            ContactLaw::ModifiedLinearViscoelastic(law) => Force::ModifiedLinearViscoelastic {
                k: law.impact_stiffness,
                c: damping(law.impact_damping_ratio, law.impact_stiffness),
            },
            ContactLaw::NonlinearViscoelastic(law) => Force::NonlinearViscoelastic {
                beta: law.impact_stiffness,
                c: damping(law.impact_damping_ratio, law.impact_stiffness),
            },
            ContactLaw::HertzDamp(law) => Force::HertzDamp {
                beta: law.impact_stiffness,
                a: law.impact_damping_factor,
            },
            ContactLaw::ModifiedKelvin(law) => Force::ModifiedKelvin {
                k: law.impact_stiffness,
                a: law.impact_damping_factor,
            },
            ContactLaw::PantWijeyewickrema(law) => Force::PantWijeyewickrema {
                k: law.impact_stiffness,
                a: law.impact_damping_factor,
            },
            ContactLaw::KuwabaraKono(law) => Force::KuwabaraKono {
                beta: law.impact_stiffness,
                big_a: law.impact_damping,
            },
        })
    }
}

impl Force {
    /// Whether the damper acts after the approach, too: the formula then has to be kept from pulling.
    pub(super) fn is_damped_throughout(self) -> bool {
        match self {
            Self::KelvinVoigt { .. }
            | Self::HertzDamp { .. }
            | Self::ModifiedKelvin { .. }
            | Self::KuwabaraKono { .. } => true,
            Self::LinearSpring { .. }
            | Self::Hertz { .. }
            | Self::ModifiedLinearViscoelastic { .. }
            | Self::NonlinearViscoelastic { .. }
            | Self::PantWijeyewickrema { .. } => false,
        }
    }

    /// Force on approach \[N\], as the formula has it.
    pub(super) fn on_approach(self, pair: Touching) -> f64 {
        // Trial steps may overshoot parting.
        let delta = pair.deformation.max(0.0);
        let (root, v) = (delta.sqrt(), pair.rate);
        let hertz = |beta: f64| beta * root * root * root;
        let factor = |a: f64| 1.0 + a * v / pair.approach_speed;
        match self {
            Self::LinearSpring { k } => k * delta,
            Self::Hertz { beta } => hertz(beta),
            Self::KelvinVoigt { k, c } | Self::ModifiedLinearViscoelastic { k, c } => {
                k * delta + c * v
            }
            Self::NonlinearViscoelastic { beta, c } => hertz(beta) + c * root.sqrt() * v,
            Self::HertzDamp { beta, a } => hertz(beta) * factor(a),
            Self::ModifiedKelvin { k, a } | Self::PantWijeyewickrema { k, a } => {
                k * delta * factor(a)
            }
            Self::KuwabaraKono { beta, big_a } => hertz(beta) + big_a * root * v,
        }
    }

    /// Force after the approach \[N\], as the formula has it.
    pub(super) fn on_return(self, pair: Touching) -> f64 {
        let elastic = match self {
            Self::ModifiedLinearViscoelastic { k, .. } | Self::PantWijeyewickrema { k, .. } => {
                Self::LinearSpring { k }
            }
            Self::NonlinearViscoelastic { beta, .. } => Self::Hertz { beta },
            Self::LinearSpring { .. }
            | Self::Hertz { .. }
            | Self::KelvinVoigt { .. }
            | Self::HertzDamp { .. }
            | Self::ModifiedKelvin { .. }
            | Self::KuwabaraKono { .. } => self,
        };
        elastic.on_approach(pair)
    }

    /// Rate of the force times δ \[N·m/s\], in the formula of the approach; that factor takes away the poles at first touch.
    pub(super) fn rate_on_approach(self, pair: Touching, acceleration: f64) -> f64 {
        let delta = pair.deformation.max(0.0);
        let (root, v) = (delta.sqrt(), pair.rate);
        let hertz = |beta: f64| 1.5 * beta * root * delta * v;
        // Of δⁿ (1 + aδ̇/v₀), divided by δ^(n−1).
        let product = |n: f64, a: f64| {
            let a = a / pair.approach_speed;
            n * v * (1.0 + a * v) + delta * a * acceleration
        };
        match self {
            Self::LinearSpring { k } => k * delta * v,
            Self::Hertz { beta } => hertz(beta),
            Self::KelvinVoigt { k, c } | Self::ModifiedLinearViscoelastic { k, c } => {
                (k * v + c * acceleration) * delta
            }
            Self::NonlinearViscoelastic { beta, c } => {
                hertz(beta) + c * root.sqrt() * (delta * acceleration + 0.25 * v * v)
            }
            Self::HertzDamp { beta, a } => beta * root * delta * product(1.5, a),
            Self::ModifiedKelvin { k, a } | Self::PantWijeyewickrema { k, a } => {
                k * delta * product(1.0, a)
            }
            Self::KuwabaraKono { beta, big_a } => {
                hertz(beta) + big_a * root * (delta * acceleration + 0.5 * v * v)
            }
        }
    }

    /// A number of the sign of the formula after the approach, smooth where δ vanishes; 1 where it never pulls.
    pub(super) fn grip(self, pair: Touching) -> f64 {
        let (delta, v) = (pair.deformation, pair.rate);
        match self {
            Self::KelvinVoigt { k, c } => k * delta + c * v,
            Self::HertzDamp { a, .. } | Self::ModifiedKelvin { a, .. } => {
                pair.approach_speed + a * v
            }
            Self::KuwabaraKono { beta, big_a } => beta * delta + big_a * v,
            Self::LinearSpring { .. }
            | Self::Hertz { .. }
            | Self::ModifiedLinearViscoelastic { .. }
            | Self::NonlinearViscoelastic { .. }
            | Self::PantWijeyewickrema { .. } => 1.0,
        }
    }
}
