use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require_damping, require_restitution, require_stiffness};
use crate::form::{Action, Form, Power, Term};
use crate::given::given;
use crate::{Calibration, approach_damper};

/// Element of Pant and Wijeyewickrema: a linear spring, and on approach a factor of the rate.
///
/// Approach (δ̇ > 0): F = kδ (1 + a δ̇/v₀), v₀ the approach speed; restitution: F = kδ. The force never pulls. Slower
/// touches count as touches at 1 mm/s. Source: D. R. Pant and A. C. Wijeyewickrema, *Earthquake Engng Struct. Dyn.* 41 (2012) 1709.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Words")]
#[schemars(with = "Words")]
pub struct PantWijeyewickrema {
    /// Impact stiffness k \[N/m\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m")]
    pub impact_stiffness: f64,
    /// Impact damping factor a \[–\], ≥ 0.
    pub impact_damping_factor: f64,
}

given!(
    PantWijeyewickrema,
    "impact_stiffness_n_per_m",
    impact_damping_factor,
    PantWijeyewickrema::calibrated
);

impl PantWijeyewickrema {
    /// The element of this stiffness \[N/m\] for an e in (0, 1\].
    ///
    /// The literature's formula is a = 3(1−e²)/(2e²).
    ///
    /// # Errors
    /// [`ParameterError`] for a stiffness or an e out of range.
    pub fn calibrated(
        impact_stiffness: f64,
        restitution: f64,
        calibration: Calibration,
    ) -> Result<Self, ParameterError> {
        require_restitution(restitution)?;
        let square = restitution * restitution;
        let law = Self {
            impact_stiffness,
            impact_damping_factor: match calibration {
                Calibration::Literature => 1.5 * (1.0 - square) / square,
                Calibration::Exact => approach_damper::factor_on_approach(restitution),
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
        approach_damper::form(spring, factor, approach_speed, Action::Approach)
    }

    /// Coefficient of restitution \[–\] delivered to a free pair, exactly: e² = 2 [1/a − ln(1+a)/a²].
    pub fn restitution(&self) -> f64 {
        self.stored().sqrt()
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
