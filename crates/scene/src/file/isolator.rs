//! Isolators below the lowest floor of a building, in the words of their makers.

use pounding_text::Refused;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choice::Choice;
use super::columns::{Columns, positive};

/// Isolators of a storey, all of them together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Isolator {
    /// Lead-rubber bearings: a bilinear loop.
    LeadRubber {
        /// Force at zero displacement Q \[N\], > 0.
        strength_n: f64,
        /// Stiffness after yielding K₂ \[N/m\], > 0.
        stiffness_after_n_per_m: f64,
        /// Displacement at which the lead yields `D_y` \[m\], > 0.
        yield_displacement_m: f64,
    },
    /// Friction pendulums: a force µW, and the pendulum's stiffness W/R under the weight W above.
    FrictionPendulum {
        /// Radius R of the sliding surface \[m\], > 0.
        radius_m: f64,
        /// Coefficient of friction µ \[–\], > 0.
        friction: f64,
        /// Displacement at which they slide \[m\], ≥ 0; 0.001 by default. With 0 they stick, and only the exact method takes them.
        #[serde(default = "slides")]
        yield_displacement_m: f64,
    },
    /// Rubber bearings, elastic.
    Rubber {
        /// Stiffness \[N/m\], > 0.
        stiffness_n_per_m: f64,
    },
}

fn slides() -> f64 {
    1e-3
}

impl Choice for Isolator {
    const EXAMPLES: &'static [&'static str] = &[
        r#"{"lead_rubber": {"strength_n": 8e5, "stiffness_after_n_per_m": 6e6, "yield_displacement_m": 0.012}}"#,
        r#"{"friction_pendulum": {"radius_m": 2.5, "friction": 0.05}}"#,
        r#"{"rubber": {"stiffness_n_per_m": 8e6}}"#,
    ];
}

impl Isolator {
    /// The loop of the isolators as columns, under the weight above \[N\].
    pub(super) fn columns(self, weight: f64) -> Result<Columns, Refused> {
        let place = |kind: &str, field: &str| format!("isolator.{kind}.{field}");
        match self {
            Self::LeadRubber {
                strength_n,
                stiffness_after_n_per_m,
                yield_displacement_m,
            } => {
                let of = |field: &str, value| positive(place("lead_rubber", field), value);
                Ok(bilinear(
                    of("strength_n", strength_n)?,
                    of("stiffness_after_n_per_m", stiffness_after_n_per_m)?,
                    of("yield_displacement_m", yield_displacement_m)?,
                ))
            }
            Self::FrictionPendulum {
                radius_m,
                friction,
                yield_displacement_m,
            } => {
                let of = |field: &str, value| positive(place("friction_pendulum", field), value);
                let after = weight / of("radius_m", radius_m)?;
                let strength = weight * of("friction", friction)?;
                if yield_displacement_m == 0.0 {
                    return Ok(Columns {
                        friction_n: Some(strength),
                        ..Columns::elastic(after)
                    });
                }
                let yields_at =
                    of("yield_displacement_m", yield_displacement_m).map_err(|refused| refused.allowed("a finite number >= 0"))?;
                Ok(bilinear(strength, after, yields_at))
            }
            Self::Rubber { stiffness_n_per_m } => {
                let stiffness = positive(place("rubber", "stiffness_n_per_m"), stiffness_n_per_m)?;
                Ok(Columns::elastic(stiffness))
            }
        }
    }
}

/// The stiffness before yielding is that after it plus the strength over the displacement at yielding.
fn bilinear(strength: f64, after: f64, yields_at: f64) -> Columns {
    let before = after + strength / yields_at;
    Columns {
        yield_force_n: Some(before * yields_at),
        hardening_ratio: Some(after / before),
        ..Columns::elastic(before)
    }
}
