//! What a run of a scene may cost before it is given up.

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use pounding_solver::Budget;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use pounding_text::{RefusalKind, Refused};

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
    /// Longest time of a run \[s\], > 0, and of what prepares it, which depends on the machine; if left out both may take as long as they
    /// take.
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

    /// Begins to prepare a run.
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

/// Until when what comes before a run may take, and how long that is \[s\]; `None` for ever.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Patience(Option<(Instant, f64)>);

impl Patience {
    /// That of whoever waits for ever.
    pub(crate) const ENDLESS: Self = Self(None);

    /// Ends a preparation that takes longer. Look wherever work grows with the row.
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
