use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require_damping, require_restitution, require_stiffness};
use crate::form::{Action, Form};
use crate::given::given;
use crate::linear_spring::linear;
use crate::{Calibration, oscillator};

/// Modified linear viscoelastic element: a linear spring, and a dashpot that acts on approach only.
///
/// Approach (δ̇ > 0): F = kδ + cδ̇ with c = 2ξ̄ √(k m), m the reduced mass; restitution: F = kδ. The force never pulls.
/// Source: S. Mahmoud and R. Jankowski, *Iran. J. Sci. Technol.* 35 (2011) 51.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Words")]
#[schemars(with = "Words")]
pub struct ModifiedLinearViscoelastic {
    /// Impact stiffness k \[N/m\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m")]
    pub impact_stiffness: f64,
    /// Impact damping ratio ξ̄ \[–\], ≥ 0.
    pub impact_damping_ratio: f64,
}

given!(
    ModifiedLinearViscoelastic,
    "impact_stiffness_n_per_m",
    impact_damping_ratio,
    ModifiedLinearViscoelastic::calibrated
);

impl ModifiedLinearViscoelastic {
    /// The element of this stiffness \[N/m\] for an e in (0, 1\].
    ///
    /// The literature's formula is ξ̄ = (1−e²)/(e (e(π−2) + 2)).
    ///
    /// # Errors
    /// [`ParameterError`] for a stiffness or an e out of range.
    pub fn calibrated(
        impact_stiffness: f64,
        restitution: f64,
        calibration: Calibration,
    ) -> Result<Self, ParameterError> {
        require_restitution(restitution)?;
        let impact_damping_ratio = match calibration {
            Calibration::Literature => {
                let e = restitution;
                (1.0 - e * e) / (e * (e * (std::f64::consts::PI - 2.0) + 2.0))
            }
            Calibration::Exact => oscillator::ratio(restitution),
        };
        let law = Self {
            impact_stiffness,
            impact_damping_ratio,
        };
        law.check().map(|()| law)
    }

    /// The force as a form, for a reduced mass \[kg\].
    pub fn form(&self, reduced_mass: f64) -> Form {
        let critical = 2.0 * (self.impact_stiffness * reduced_mass).sqrt();
        let damping = self.impact_damping_ratio * critical;
        linear(self.impact_stiffness, damping, Action::Approach)
    }

    /// Coefficient of restitution \[–\] delivered to a free pair, exactly: e = exp(−ξ̄ acos ξ̄/√(1−ξ̄²)).
    pub fn restitution(&self) -> f64 {
        oscillator::given_back(self.impact_damping_ratio)
    }

    /// Part of the kinetic energy \[–\] of a free pair that the spring holds at the largest deformation.
    pub(crate) fn stored(&self) -> f64 {
        self.restitution() * self.restitution()
    }

    /// Checks k > 0 and ξ̄ ≥ 0, both finite.
    ///
    /// # Errors
    /// [`ParameterError`] for the first parameter out of range.
    pub fn check(&self) -> Result<(), ParameterError> {
        require_stiffness("impact_stiffness_n_per_m", self.impact_stiffness)?;
        require_damping("impact_damping_ratio", self.impact_damping_ratio)
    }
}
