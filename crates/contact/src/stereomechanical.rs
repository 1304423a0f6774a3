use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{ParameterError, require};

/// Stereomechanical impact: momentum is kept, the relative velocity is turned round and multiplied by e.
///
/// Source: the paper, equation (4); W. Goldsmith, *Impact* (1960). The law delivers the restitution asked for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stereomechanical {
    /// Coefficient of restitution e \[–\], 0 (plastic) ..= 1 (elastic).
    pub restitution: f64,
}

impl Stereomechanical {
    /// Impulse \[N·s\] that turns an approach at `rate` δ̇ \[m/s\] into a separation at e·δ̇.
    ///
    /// Precondition: `rate` > 0; a pair that separates does not collide.
    pub fn impulse(&self, rate: f64, reduced_mass: f64) -> f64 {
        (1.0 + self.restitution) * reduced_mass * rate
    }

    /// Checks 0 ≤ e ≤ 1.
    ///
    /// # Errors
    /// [`ParameterError`] for an e outside that range.
    pub fn check(&self) -> Result<(), ParameterError> {
        require(
            (0.0..=1.0).contains(&self.restitution),
            "restitution",
            self.restitution,
            "0 to 1",
        )
    }
}
