//! What a run of a scene may cost before it is given up.

use std::sync::atomic::AtomicBool;

use pounding_solver::Budget;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a run may cost before it is given up; what ends within it has the same numbers without it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunBudget {
    /// Most time steps times floors \[–\], > 0 and at most 1e9, sub-steps counted as if structures touched all the time; 1e8 if
    /// left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steps: Option<f64>,
    /// Most pieces of the motion of floors by the exact method \[–\], > 0; 1e7 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pieces: Option<f64>,
    /// Longest time of a run \[s\], > 0, which depends on the machine; if left out it may take as long as it takes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
}

/// Steps times floors, which bound the time of a run and what it remembers: some minutes, and 0.8 GB.
const STEPS: f64 = 1e8;

impl RunBudget {
    /// Most time steps times floors.
    pub(crate) fn most_steps(&self) -> f64 {
        self.steps.unwrap_or(STEPS)
    }

    /// As the solver knows it; whoever sets `stop` ends the run.
    pub(crate) fn of_run(&self, stop: Option<&'static AtomicBool>) -> Budget {
        Budget {
            pieces: self.pieces.unwrap_or(Budget::PIECES),
            seconds: self.seconds,
            stop,
        }
    }

    pub(crate) fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}
