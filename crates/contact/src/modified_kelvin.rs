use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require_damping, require_restitution, require_stiffness};
use crate::form::{Action, Form, Power, Term};
use crate::given::given;
use crate::{Calibration, approach_damper};

/// Modified Kelvin element: a linear spring times a factor of the rate, F = max(0, kδ (1 + a δ̇/v₀)), v₀ the approach
/// speed.
///
/// In a free impact the factor stays above 0; the clamp acts where something else drives the pair apart faster than v₀/a.
/// Slower touches count as touches at 1 mm/s. Source: K. Ye, L. Li and H. Zhu, *Earthquake Engng Struct. Dyn.* 38
/// (2009) 1135.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Words")]
#[schemars(with = "Words")]
pub struct ModifiedKelvin {
    /// Impact stiffness k \[N/m\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m")]
    pub impact_stiffness: f64,
    /// Impact damping factor a \[–\], ≥ 0.
    pub impact_damping_factor: f64,
}

given!(
    ModifiedKelvin,
    "impact_stiffness_n_per_m",
    impact_damping_factor,
    ModifiedKelvin::calibrated
);

impl ModifiedKelvin {
    /// The element of this stiffness \[N/m\] for an e in (0, 1\].
    ///
    /// The literature's formula is a = 3(1−e)/(2e).
    ///
    /// # Errors
    /// [`ParameterError`] for a stiffness or an e out of range.
    pub fn calibrated(
        impact_stiffness: f64,
        restitution: f64,
        calibration: Calibration,
    ) -> Result<Self, ParameterError> {
        require_restitution(restitution)?;
        let law = Self {
            impact_stiffness,
            impact_damping_factor: match calibration {
                Calibration::Literature => 1.5 * (1.0 - restitution) / restitution,
                Calibration::Exact => approach_damper::factor(restitution),
            },
        };
        law.check().map(|()| law)
    }

    /// The force as a form, for an approach speed \[m/s\].
    pub fn form(&self, approach_speed: f64) -> Form {
        let spring = Term {
            coefficient: self.impact_stiffness,
            power: Power::One,
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

    /// Checks k > 0 and a ≥ 0, both finite.
    ///
    /// # Errors
    /// [`ParameterError`] for the first parameter out of range.
    pub fn check(&self) -> Result<(), ParameterError> {
        require_stiffness("impact_stiffness_n_per_m", self.impact_stiffness)?;
        require_damping("impact_damping_factor", self.impact_damping_factor)
    }
}
