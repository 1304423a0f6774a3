use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require_damping, require_restitution, require_stiffness};
use crate::form::{Action, Form};
use crate::given::given;
use crate::linear_spring::linear;
use crate::{Calibration, oscillator};

/// Kelvin–Voigt element: a linear spring beside a linear dashpot, clamped so that it never pulls.
///
/// F = max(0, kδ + cδ̇) with c = 2ξ̄ √(k m), m the reduced mass. Without the clamp the dashpot would pull at the end of every
/// collision; with it, more comes back than the literature's formula says. Source: S. A. Anagnostopoulos, *Earthquake
/// Engng Struct. Dyn.* 16 (1988) 443.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Words")]
#[schemars(with = "Words")]
pub struct KelvinVoigt {
    /// Impact stiffness k \[N/m\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m")]
    pub impact_stiffness: f64,
    /// Impact damping ratio ξ̄ \[–\], ≥ 0.
    pub impact_damping_ratio: f64,
}

given!(
    KelvinVoigt,
    "impact_stiffness_n_per_m",
    impact_damping_ratio,
    KelvinVoigt::calibrated
);

impl KelvinVoigt {
    /// The element of this stiffness \[N/m\] for an e in (0, 1\].
    ///
    /// The literature's formula ξ̄ = −ln e/√(π² + ln² e) is that of a dashpot that may pull.
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
                let decrement = libm::log(restitution).abs();
                let pi = std::f64::consts::PI;
                decrement / (pi * pi + decrement * decrement).sqrt()
            }
            Calibration::Exact => oscillator::ratio(restitution.sqrt()),
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
        linear(self.impact_stiffness, damping, Action::Both)
    }

    /// Coefficient of restitution \[–\] delivered to a free pair, exactly: e = exp(−2ξ̄ acos ξ̄/√(1−ξ̄²)).
    ///
    /// The force falls to zero twice as late as the deformation peaks, and is clamped from there to the parting.
    pub fn restitution(&self) -> f64 {
        let given_back = oscillator::given_back(self.impact_damping_ratio);
        given_back * given_back
    }

    /// Part of the kinetic energy \[–\] of a free pair that the spring holds at the largest deformation.
    pub(crate) fn stored(&self) -> f64 {
        self.restitution()
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
