use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require, require_damping, require_stiffness};
use crate::form::{Action, Form, Power, Term};
use crate::free_impact::restitution;
use crate::{FreePair, search};

/// Viscoelastic Hertz contact of Kuwabara and Kono, F = max(0, β̄ δ^1.5 + A √δ δ̇).
///
/// Without the clamp it would pull at the end of every collision. Its restitution depends on the approach speed: slow
/// collisions are more elastic, and e → 1 like v₀^(1/5). Source: G. Kuwabara and K. Kono, *Jpn. J. Appl. Phys.* 26 (1987)
/// 1230.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KuwabaraKono {
    /// Impact stiffness β̄ \[N/m^1.5\], > 0.
    #[serde(rename = "impact_stiffness_n_per_m1_5")]
    pub impact_stiffness: f64,
    /// Impact damping A \[N·s/m^1.5\], ≥ 0.
    #[serde(rename = "impact_damping_n_s_per_m1_5")]
    pub impact_damping: f64,
}

/// Damping up to which a calibration looks, in units of the free pair; it delivers e = 1.3e-4.
const MOST: f64 = 256.0;

impl KuwabaraKono {
    /// The law of this stiffness \[N/m^1.5\] that delivers an e of 0.001 to 1 to a free pair, found numerically.
    ///
    /// The literature gives A from the material, not from e. Takes some milliseconds.
    ///
    /// # Errors
    /// [`ParameterError`] for a stiffness or an e out of range.
    pub fn calibrated(
        impact_stiffness: f64,
        asked: f64,
        pair: &FreePair,
    ) -> Result<Self, ParameterError> {
        let within = (0.001..=1.0).contains(&asked);
        require(within, "restitution", asked, "0.001 to 1")?;
        // e depends on A/unit alone.
        let unit = Self::unit(impact_stiffness, pair);
        let delivered = |damping: f64| {
            let law = Self {
                impact_stiffness,
                impact_damping: damping * unit,
            };
            restitution(&law.form(), pair).unwrap_or(0.0)
        };
        // Against the undamped impact integrated in the same way: e = 1 then needs no damping to the last bit.
        let elastic = delivered(0.0);
        let lacking = |damping: f64| asked * elastic - delivered(damping);
        let mut most = 1.0;
        while lacking(most) < 0.0 && most < MOST {
            most *= 2.0;
        }
        let law = Self {
            impact_stiffness,
            impact_damping: unit * search::root(0.0, most, lacking),
        };
        law.check().map(|()| law)
    }

    /// A \[N·s/m^1.5\] of the order of the spring for this pair: β̄ L/v₀ with m v₀² = β̄ L^2.5.
    fn unit(impact_stiffness: f64, pair: &FreePair) -> f64 {
        let speed = pair.approach_speed;
        let length = libm::pow(pair.reduced_mass * speed * speed / impact_stiffness, 0.4);
        impact_stiffness * length / speed
    }

    /// The force as a form.
    pub fn form(&self) -> Form {
        Form {
            spring: Term {
                coefficient: self.impact_stiffness,
                power: Power::ThreeHalves,
            },
            damper: Term {
                coefficient: self.impact_damping,
                power: Power::Half,
            },
            action: Action::Both,
        }
    }

    /// Checks β̄ > 0 and A ≥ 0, both finite.
    ///
    /// # Errors
    /// [`ParameterError`] for the first parameter out of range.
    pub fn check(&self) -> Result<(), ParameterError> {
        require_stiffness("impact_stiffness_n_per_m1_5", self.impact_stiffness)?;
        require_damping("impact_damping_n_s_per_m1_5", self.impact_damping)
    }
}
