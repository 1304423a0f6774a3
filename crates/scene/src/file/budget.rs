//! Limits on the work of a run, and on its preparation.

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use pounding_solver::Budget;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use pounding_text::{RefusalKind, Refused};

/// Limits on the work of a run. A run that reaches a limit ends with an error. Other runs do not depend on the limits.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunBudget {
    /// Largest number of time steps times floors \[–\], > 0 and at most 1e9; 1e8 by default. Sub-steps count as if structures touched all
    /// the time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steps: Option<f64>,
    /// Largest number of pieces of the motion of floors in the exact method \[–\], > 0; 1e7 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pieces: Option<f64>,
    /// Longest time of a run, and of its preparation \[s\], > 0; no limit by default. It depends on the machine.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
}

/// Default of steps times floors. It bounds a run to some minutes, and its memory to 0.8 GB.
const STEPS: f64 = 1e8;

impl RunBudget {
    /// Largest number of time steps times floors.
    pub(crate) fn most_steps(&self) -> f64 {
        self.steps.unwrap_or(STEPS)
    }

    /// Converts the limits for the solver. Setting `stop` ends the run.
    pub(crate) fn of_run(&self, stop: Option<&'static AtomicBool>) -> Budget {
        Budget {
            pieces: self.pieces.unwrap_or(Budget::PIECES),
            seconds: self.seconds,
            stop,
        }
    }

    /// Starts the clock of a preparation.
    pub(crate) fn begin(&self) -> Patience {
        let until = |seconds| {
            let end = Instant::now().checked_add(Duration::try_from_secs_f64(seconds).ok()?)?;
            Some((end, seconds))
        };
        Patience(self.seconds.and_then(until))
    }

    pub(crate) fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}

/// Deadline of a preparation, and its length \[s\]; `None` for no deadline.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Patience(Option<(Instant, f64)>);

impl Patience {
    /// No deadline.
    pub(crate) const ENDLESS: Self = Self(None);

    /// Refuses to go on after the deadline. Call it wherever work grows with the row.
    pub(crate) fn look(self) -> Result<(), Refused> {
        match self.0 {
            Some((until, seconds)) if Instant::now() > until => {
                let seconds = pounding_text::plain(seconds);
                let over = Refused::at("budget.seconds").found(format!("{seconds}, which was over before the run began"));
                let over = over.allowed_is("what it takes to prepare the row");
                let over = over.help("make `budget.seconds` more, or take fewer structures or storeys");
                Err(over.kind(RefusalKind::Together))
            }
            _ => Ok(()),
        }
    }
}
