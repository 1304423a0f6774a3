use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{
    ContactForce, Form, FreeImpact, FreePair, Hertz, HertzDamp, KelvinVoigt, KuwabaraKono,
    LinearSpring, ModifiedKelvin, ModifiedLinearViscoelastic, NonlinearViscoelastic, Overlap,
    PantWijeyewickrema, ParameterError, Stereomechanical, oscillator,
};

/// A contact law with its parameters, as a scene names it.
///
/// It is matched only while a pair touches.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ContactLaw {
    /// Velocity jump at an instant; see [`Stereomechanical`].
    Stereomechanical(Stereomechanical),
    /// Linear spring; see [`LinearSpring`].
    LinearSpring(LinearSpring),
    /// Hertz spring; see [`Hertz`].
    Hertz(Hertz),
    /// Linear spring and clamped dashpot; see [`KelvinVoigt`].
    KelvinVoigt(KelvinVoigt),
    /// Linear spring with a dashpot that acts on approach; see [`ModifiedLinearViscoelastic`].
    ModifiedLinearViscoelastic(ModifiedLinearViscoelastic),
    /// Hertz spring with a damper that acts on approach; see [`NonlinearViscoelastic`].
    NonlinearViscoelastic(NonlinearViscoelastic),
    /// Hertz spring times a factor of the rate; see [`HertzDamp`].
    HertzDamp(HertzDamp),
    /// Linear spring times a factor of the rate; see [`ModifiedKelvin`].
    ModifiedKelvin(ModifiedKelvin),
    /// Linear spring times a factor of the rate on approach; see [`PantWijeyewickrema`].
    PantWijeyewickrema(PantWijeyewickrema),
    /// Hertz spring with a damper that grows like √δ; see [`KuwabaraKono`].
    KuwabaraKono(KuwabaraKono),
}

/// Whether the formula of a law would pull, and is clamped at F = 0 instead.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clamp {
    /// It never pulls.
    Never,
    /// It would only where something else drives the pair apart faster than v₀/a; in no free impact.
    DrivenApart,
    /// It would at the end of every collision.
    EveryCollision,
}

impl FreeImpact {
    /// Integrates the collision of a free pair under a law.
    ///
    /// Returns `None` for an impulsive law, and where the damping is so strong that the return takes more than twenty thousand
    /// steps. Takes about a millisecond.
    pub fn of(law: &ContactLaw, pair: &FreePair) -> Option<Self> {
        Self::of_form(&law.form(pair.reduced_mass, pair.approach_speed)?, pair)
    }
}

impl ContactLaw {
    /// The law with so many times its stiffness, and its other parameters as they are: of laws whose damping is a ratio or a factor \[–\]
    /// the same restitution. The damping of [`KuwabaraKono`] grows with the stiffness; an impulsive law has none.
    #[must_use]
    pub fn stiffened(mut self, factor: f64) -> Self {
        match &mut self {
            Self::Stereomechanical(_) => {}
            Self::LinearSpring(law) => law.impact_stiffness *= factor,
            Self::Hertz(law) => law.impact_stiffness *= factor,
            Self::KelvinVoigt(law) => law.impact_stiffness *= factor,
            Self::ModifiedLinearViscoelastic(law) => law.impact_stiffness *= factor,
            Self::NonlinearViscoelastic(law) => law.impact_stiffness *= factor,
            Self::HertzDamp(law) => law.impact_stiffness *= factor,
            Self::ModifiedKelvin(law) => law.impact_stiffness *= factor,
            Self::PantWijeyewickrema(law) => law.impact_stiffness *= factor,
            Self::KuwabaraKono(law) => {
                law.impact_stiffness *= factor;
                law.impact_damping *= factor;
            }
        }
        self
    }

    /// Name as scene files spell it.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Stereomechanical(_) => "stereomechanical",
            Self::LinearSpring(_) => "linear_spring",
            Self::Hertz(_) => "hertz",
            Self::KelvinVoigt(_) => "kelvin_voigt",
            Self::ModifiedLinearViscoelastic(_) => "modified_linear_viscoelastic",
            Self::NonlinearViscoelastic(_) => "nonlinear_viscoelastic",
            Self::HertzDamp(_) => "hertz_damp",
            Self::ModifiedKelvin(_) => "modified_kelvin",
            Self::PantWijeyewickrema(_) => "pant_wijeyewickrema",
            Self::KuwabaraKono(_) => "kuwabara_kono",
        }
    }

    /// Checks the parameters against their valid range.
    ///
    /// # Errors
    /// [`ParameterError`] names the parameter, what was found and what is allowed.
    pub fn check(&self) -> Result<(), ParameterError> {
        match self {
            Self::Stereomechanical(law) => law.check(),
            Self::LinearSpring(law) => law.check(),
            Self::Hertz(law) => law.check(),
            Self::KelvinVoigt(law) => law.check(),
            Self::ModifiedLinearViscoelastic(law) => law.check(),
            Self::NonlinearViscoelastic(law) => law.check(),
            Self::HertzDamp(law) => law.check(),
            Self::ModifiedKelvin(law) => law.check(),
            Self::PantWijeyewickrema(law) => law.check(),
            Self::KuwabaraKono(law) => law.check(),
        }
    }

    /// The law, if it acts as an impulse.
    pub const fn impulsive(&self) -> Option<Stereomechanical> {
        if let Self::Stereomechanical(law) = self {
            Some(*law)
        } else {
            None
        }
    }

    /// Whether the law gives a force over time, and not an impulse.
    #[inline]
    pub const fn is_compliant(&self) -> bool {
        self.impulsive().is_none()
    }

    /// Whether the damper depends on the approach speed, as δ̇/v₀.
    pub const fn knows_approach_speed(&self) -> bool {
        match self {
            Self::HertzDamp(_) | Self::ModifiedKelvin(_) | Self::PantWijeyewickrema(_) => true,
            Self::Stereomechanical(_)
            | Self::LinearSpring(_)
            | Self::Hertz(_)
            | Self::KelvinVoigt(_)
            | Self::ModifiedLinearViscoelastic(_)
            | Self::NonlinearViscoelastic(_)
            | Self::KuwabaraKono(_) => false,
        }
    }

    /// Force and tangents of a compliant law while a pair touches; nothing for an impulsive one.
    ///
    /// Precondition: `overlap.deformation` > 0. Tangents jump at δ̇ = 0 and where the force is clamped, and may grow
    /// without bound as δ → 0.
    #[inline]
    pub fn respond(&self, overlap: &Overlap) -> Option<ContactForce> {
        // Its root is taken as the paper writes it: the last digits of the paper's tables depend on that.
        if let Self::NonlinearViscoelastic(law) = self {
            return Some(law.respond(overlap));
        }
        let form = self.form(overlap.reduced_mass, overlap.approach_speed)?;
        Some(form.respond(overlap.deformation, overlap.rate))
    }

    /// Force and tangents of a pair at δ ≤ 0 that a step is about to bring together, for a solver that iterates.
    ///
    /// A linear dashpot acts from the touch on: its force jumps there, and at the end of a step there may be no equilibrium
    /// either with it or without. kδ + cδ̇, clamped, goes through. Forces that begin at zero have nothing to go through.
    pub fn before_touch(&self, overlap: &Overlap) -> Option<ContactForce> {
        let form = self.form(overlap.reduced_mass, overlap.approach_speed)?;
        form.before_touch(overlap.deformation, overlap.rate)
    }

    /// The force of a compliant law as a form, for a reduced mass \[kg\] and an approach speed \[m/s\]; nothing for an
    /// impulsive one.
    pub fn form(&self, reduced_mass: f64, approach_speed: f64) -> Option<Form> {
        match self {
            Self::Stereomechanical(_) => None,
            Self::LinearSpring(law) => Some(law.form()),
            Self::Hertz(law) => Some(law.form()),
            Self::KelvinVoigt(law) => Some(law.form(reduced_mass)),
            Self::ModifiedLinearViscoelastic(law) => Some(law.form(reduced_mass)),
            Self::NonlinearViscoelastic(law) => Some(law.form(reduced_mass)),
            Self::HertzDamp(law) => Some(law.form(approach_speed)),
            Self::ModifiedKelvin(law) => Some(law.form(approach_speed)),
            Self::PantWijeyewickrema(law) => Some(law.form(approach_speed)),
            Self::KuwabaraKono(law) => Some(law.form()),
        }
    }

    /// Coefficient of restitution that the law delivers to a free pair, exactly \[–\].
    ///
    /// Laws with δ̇/v₀ deliver it from [`crate::SLOWEST_APPROACH`] on, and more to slower pairs.
    /// Nothing for [`KuwabaraKono`], whose e depends on the pair: [`crate::FreeImpact`] finds it.
    pub fn restitution(&self) -> Option<f64> {
        match self {
            Self::Stereomechanical(law) => Some(law.restitution),
            Self::LinearSpring(_) | Self::Hertz(_) => Some(1.0),
            Self::KelvinVoigt(law) => Some(law.restitution()),
            Self::ModifiedLinearViscoelastic(law) => Some(law.restitution()),
            Self::NonlinearViscoelastic(law) => Some(law.restitution()),
            Self::HertzDamp(law) => Some(law.restitution()),
            Self::ModifiedKelvin(law) => Some(law.restitution()),
            Self::PantWijeyewickrema(law) => Some(law.restitution()),
            Self::KuwabaraKono(_) => None,
        }
    }

    /// Whether the law's formula would pull and is clamped.
    pub fn clamp(&self) -> Clamp {
        let when = |damping: f64, clamp| if damping > 0.0 { clamp } else { Clamp::Never };
        match self {
            Self::Stereomechanical(_)
            | Self::LinearSpring(_)
            | Self::Hertz(_)
            | Self::ModifiedLinearViscoelastic(_)
            | Self::NonlinearViscoelastic(_)
            | Self::PantWijeyewickrema(_) => Clamp::Never,
            Self::HertzDamp(law) => when(law.impact_damping_factor, Clamp::DrivenApart),
            Self::ModifiedKelvin(law) => when(law.impact_damping_factor, Clamp::DrivenApart),
            Self::KelvinVoigt(law) => when(law.impact_damping_ratio, Clamp::EveryCollision),
            Self::KuwabaraKono(law) => when(law.impact_damping, Clamp::EveryCollision),
        }
    }

    /// Largest deformation δmax \[m\] of a free pair, where a closed form exists.
    pub fn max_deformation(&self, pair: &FreePair) -> Option<f64> {
        let stored = match self {
            Self::Stereomechanical(_) | Self::KuwabaraKono(_) => None,
            Self::LinearSpring(_) | Self::Hertz(_) => Some(1.0),
            Self::KelvinVoigt(law) => Some(law.stored()),
            Self::ModifiedLinearViscoelastic(law) => Some(law.stored()),
            Self::NonlinearViscoelastic(law) => Some(law.stored()),
            Self::HertzDamp(law) => Some(law.stored()),
            Self::ModifiedKelvin(law) => Some(law.stored()),
            Self::PantWijeyewickrema(law) => Some(law.stored()),
        };
        let form = self.form(pair.reduced_mass, pair.approach_speed)?;
        Some(pair.deformation(form.spring, stored?))
    }

    /// Largest force \[N\] in the collision of a free pair, where a closed form exists.
    pub fn peak_force(&self, pair: &FreePair) -> Option<f64> {
        let (stiffness, ratio) = match self {
            Self::LinearSpring(_) | Self::Hertz(_) => {
                let form = self.form(pair.reduced_mass, pair.approach_speed)?;
                return Some(form.spring.at(self.max_deformation(pair)?));
            }
            Self::KelvinVoigt(law) => (law.impact_stiffness, law.impact_damping_ratio),
            Self::ModifiedLinearViscoelastic(law) => {
                (law.impact_stiffness, law.impact_damping_ratio)
            }
            Self::Stereomechanical(_)
            | Self::NonlinearViscoelastic(_)
            | Self::HertzDamp(_)
            | Self::ModifiedKelvin(_)
            | Self::PantWijeyewickrema(_)
            | Self::KuwabaraKono(_) => return None,
        };
        let undamped = (stiffness * pair.reduced_mass).sqrt() * pair.approach_speed;
        Some(undamped * oscillator::peak_force(ratio))
    }
}
