//! What a run may cost before it is given up, and who may end it.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::{Clock, RunError};

/// What a run may cost before it is given up, and who may end it.
///
/// It never changes a run that ends within it: the run has the same bits as without one.
#[derive(Debug, Clone, Copy)]
pub struct Budget {
    /// Most pieces of the motion of floors by the exact method \[–\], ≥ 0, with those that are tried to tell who rests.
    pub pieces: f64,
    /// Longest time that the run takes \[s\], ≥ 0; `None` for no limit. Unlike all else it depends on the machine.
    pub seconds: Option<f64>,
    /// Whoever sets it ends the run within a fraction of a second.
    pub stop: Option<&'static AtomicBool>,
}

impl Budget {
    /// Ten million: the pieces of 1000 structures over 100 s of a record, and some 20 s of a processor in contact.
    ///
    /// The largest scenes of the studies need 1e5.
    pub const PIECES: f64 = 1e7;

    /// Whether somebody wants runs to end.
    pub fn is_stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }
}

impl Default for Budget {
    /// Up to [`PIECES`](Self::PIECES), however long it takes; nobody ends it.
    fn default() -> Self {
        Self {
            pieces: Self::PIECES,
            seconds: None,
            stop: None,
        }
    }
}

/// How far a run goes, and what it may cost.
#[derive(Debug, Clone, Copy)]
pub struct Course {
    /// Its steps, and its end.
    pub clock: Clock,
    /// What it may cost.
    pub budget: Budget,
}

impl From<Clock> for Course {
    /// With the usual budget.
    fn from(clock: Clock) -> Self {
        clock.within(Budget::default())
    }
}

impl Clock {
    /// A run on this clock that may cost so much.
    pub fn within(self, budget: Budget) -> Course {
        Course { clock: self, budget }
    }
}

/// Steps of floors between two looks at the budget, about: some milliseconds by the slowest method.
const STEPS_BETWEEN: usize = 1 << 14;

/// Looks now and then whether a run is over its budget; begins with the run.
#[derive(Debug)]
pub(crate) struct Guard {
    budget: Budget,
    until: Option<Instant>,
    /// Looks at steps of which these bits are zero.
    bits: usize,
}

impl Course {
    /// Begins a run of which one step takes as long as so many steps of a floor.
    pub(crate) fn begin(&self, floors_per_step: usize) -> Guard {
        let steps = (STEPS_BETWEEN / floors_per_step.max(1)).max(1);
        let longest = |seconds| Instant::now().checked_add(Duration::try_from_secs_f64(seconds).ok()?);
        Guard {
            budget: self.budget,
            until: self.budget.seconds.and_then(longest),
            bits: (1 << steps.ilog2()) - 1,
        }
    }
}

impl Guard {
    /// Ends a run by steps before this one, where it is over its budget.
    #[inline]
    pub(crate) fn step(&self, step: usize, clock: Clock) -> Result<(), RunError> {
        if step & self.bits == 0 {
            self.look(clock.time(step), 0)
        } else {
            Ok(())
        }
    }

    /// Ends a run after so many pieces, where it is over its budget.
    pub(crate) fn look(&self, time: f64, pieces: u64) -> Result<(), RunError> {
        let allowed = self.budget.pieces;
        if self.budget.is_stopped() {
            return Err(RunError::Stopped { time });
        }
        if pieces as f64 > allowed {
            return Err(RunError::TooManyPieces { time, allowed });
        }
        self.wait(time)
    }

    /// Ends a run that somebody stops, or that takes too long, in the middle of what happens at an instant: in a long row that is much.
    #[inline]
    pub(crate) fn wait(&self, time: f64) -> Result<(), RunError> {
        if self.budget.is_stopped() {
            return Err(RunError::Stopped { time });
        }
        match (self.until, self.budget.seconds) {
            (Some(until), Some(seconds)) if Instant::now() > until => Err(RunError::TooLong { time, seconds }),
            _ => Ok(()),
        }
    }

    /// Whether that would end it.
    pub(crate) fn is_over(&self, pieces: u64) -> bool {
        self.look(0.0, pieces).is_err()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extreme_a_guard_looks_at_least_every_step() {
        let clock = Clock {
            time_step: 0.01,
            n_steps: 10,
        };
        for (floors, between) in [(0, 1 << 14), (1, 1 << 14), (3, 1 << 12), (1_000_000, 1)] {
            let guard = Course::from(clock).begin(floors);
            assert_eq!(guard.bits + 1, between, "{floors} floors");
        }
    }
}
