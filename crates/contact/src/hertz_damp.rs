use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require_damping, require_restitution, require_stiffness};
use crate::form::{Action, Form, Power, Term};
use crate::given::given;
use crate::{Calibration, approach_damper};

/// Hertz-damp: a Hertz spring times a factor of the rate, F = max(0, β̄ δ^1.5 (1 + a δ̇/v₀)), v₀ the approach speed.
///
/// One force with four [`HertzDampFormula`]s for a. In a free impact the factor stays above 0; the clamp acts where
/// something else drives the pair apart faster than v₀/a. Slower touches count as
/// touches at 1 mm/s.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Words")]
#[schemars(with = "Words")]
pub struct HertzDamp {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m1_5")]
    pub impact_stiffness: f64,
    /// Impact damping factor a \[–\], ≥ 0.
    pub impact_damping_factor: f64,
}

given!(
    HertzDamp,
    "impact_stiffness_n_per_m1_5",
    impact_damping_factor,
    |k, e, calibration| { HertzDamp::calibrated(k, e, (calibration, HertzDampFormula::HertzDamp)) }
);

/// Formulas of the literature for the factor a of [`HertzDamp`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum HertzDampFormula {
    /// a = ¾(1−e²): H. M. Lankarani and P. E. Nikravesh, *J. Mech. Des.* 112 (1990) 369; for pounding S. Muthukumar and
    /// R. `DesRoches`, *Earthquake Engng Struct. Dyn.* 35 (2006) 811.
    HertzDamp,
    /// a = 8(1−e)/(5e): K. Ye, L. Li and H. Zhu, *Earthquake Engng Struct. Dyn.* 38 (2009) 1135; P. Flores et al.,
    /// *Multibody Syst. Dyn.* 25 (2011) 357.
    CorrectedHertzDamp,
    /// a = 3(1−e)/2: K. H. Hunt and F. R. E. Crossley, *J. Appl. Mech.* 42 (1975) 440.
    HuntCrossley,
    /// a = (1−e²)/e: Y. Gonthier et al., *Multibody Syst. Dyn.* 11 (2004) 209.
    Gonthier,
}

impl HertzDampFormula {
    /// Factor a \[–\] for an e in (0, 1\].
    pub fn factor(self, restitution: f64) -> f64 {
        let e = restitution;
        match self {
            Self::HertzDamp => 0.75 * (1.0 - e * e),
            Self::CorrectedHertzDamp => 1.6 * (1.0 - e) / e,
            Self::HuntCrossley => 1.5 * (1.0 - e),
            Self::Gonthier => (1.0 - e * e) / e,
        }
    }
}

impl HertzDamp {
    /// The law of this stiffness \[N/m^1.5\] that delivers an e in (0, 1\], or is to do so by a formula.
    ///
    /// # Errors
    /// [`ParameterError`] for a stiffness or an e out of range.
    pub fn calibrated(
        impact_stiffness: f64,
        restitution: f64,
        (calibration, formula): (Calibration, HertzDampFormula),
    ) -> Result<Self, ParameterError> {
        require_restitution(restitution)?;
        let law = Self {
            impact_stiffness,
            impact_damping_factor: match calibration {
                Calibration::Literature => formula.factor(restitution),
                Calibration::Exact => approach_damper::factor(restitution),
            },
        };
        law.check().map(|()| law)
    }

    /// The force as a form, for an approach speed \[m/s\].
    pub fn form(&self, approach_speed: f64) -> Form {
        let spring = Term {
            coefficient: self.impact_stiffness,
            power: Power::ThreeHalves,
        };
        let factor = self.impact_damping_factor;
        approach_damper::form(spring, factor, approach_speed, Action::Both)
    }

    /// Coefficient of restitution \[–\] delivered to a free pair, exactly: the e of a(1+e) = ln[(1+a)/(1−ea)].
    pub fn restitution(&self) -> f64 {
        approach_damper::restitution(self.impact_damping_factor)
    }

    /// Part of the kinetic energy \[–\] of a free pair that the spring holds at the largest deformation.
    pub(crate) fn stored(&self) -> f64 {
        approach_damper::stored(self.impact_damping_factor)
    }

    /// Checks β̄ > 0 and a ≥ 0, both finite.
    ///
    /// # Errors
    /// [`ParameterError`] for the first parameter out of range.
    pub fn check(&self) -> Result<(), ParameterError> {
        require_stiffness("impact_stiffness_n_per_m1_5", self.impact_stiffness)?;
        require_damping("impact_damping_factor", self.impact_damping_factor)
    }
}
