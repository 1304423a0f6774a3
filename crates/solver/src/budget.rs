//! The clock of a run, its work, and its limits: work, time, and a flag that stops it.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::RunError;

/// The fixed grid of a stepping run: nodes at i·Δt, i = 0..=n. The exact method uses only its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// Time step Δt \[s\], > 0.
    pub time_step: f64,
    /// Number of steps n; the run ends at n·Δt.
    pub n_steps: usize,
}

impl Clock {
    /// Time of node `step` \[s\].
    #[inline]
    pub fn time(&self, step: usize) -> f64 {
        step as f64 * self.time_step
    }
}

/// Cost of a run, in counts that are equal on every machine.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Time steps of the whole row. Sub-steps of structures are not counted here.
    pub steps: u64,
    /// Evaluations of a restoring force.
    pub force_evaluations: u64,
    /// Newton iterations, summed over structures that are alone and clusters that touch.
    pub newton_iterations: u64,
    /// Steps and sub-steps at whose end a pair overlaps, and impacts within them, summed over pairs.
    pub touching_steps: u64,
    /// Pieces of the motion of structures in power series.
    pub segments: u64,
    /// Events of the exact method: instants at which a piece ended.
    pub events: u64,
}

/// Limits of a run: work, time, and a flag that stops it.
///
/// A budget never changes a run that stays within it: the result has the same bits.
#[derive(Debug, Clone, Copy)]
pub struct Budget {
    /// Most pieces of the motion of floors in the exact method \[–\], ≥ 0. Pieces tried in the search for pairs at rest count as well.
    pub pieces: f64,
    /// Longest time of the run \[s\], ≥ 0; `None` for no limit. Only this limit depends on the machine.
    pub seconds: Option<f64>,
    /// Flag that ends the run within a fraction of a second once it is set.
    pub stop: Option<&'static AtomicBool>,
}

impl Budget {
    /// Ten million: the pieces of 1000 structures over 100 s of a record, and about 20 s of processor time in contact.
    ///
    /// The largest scenes of the studies need 1e5.
    pub const PIECES: f64 = 1e7;

    /// Whether the stop flag is set.
    pub fn is_stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }
}

impl Default for Budget {
    /// [`PIECES`](Self::PIECES) pieces, no limit of time, no stop flag.
    fn default() -> Self {
        Self {
            pieces: Self::PIECES,
            seconds: None,
            stop: None,
        }
    }
}

/// Steps and limits of a run.
#[derive(Debug, Clone, Copy)]
pub struct Course {
    /// Time step and end of the run.
    pub clock: Clock,
    /// Limits of the run.
    pub budget: Budget,
}

impl From<Clock> for Course {
    /// A run with the default budget.
    fn from(clock: Clock) -> Self {
        clock.within(Budget::default())
    }
}

impl Clock {
    /// A run on this clock with a budget.
    pub fn within(self, budget: Budget) -> Course {
        Course { clock: self, budget }
    }
}

/// Floor steps between two checks of the budget, approximately: some milliseconds for the slowest method.
const STEPS_BETWEEN: usize = 1 << 14;

/// Checks from time to time whether a run exceeds its budget. It starts with the run.
#[derive(Debug)]
pub(crate) struct Guard {
    budget: Budget,
    until: Option<Instant>,
    /// A step is checked if these bits of its number are zero.
    bits: usize,
}

impl Course {
    /// Starts the guard of a run in which each step costs as much as `floors_per_step` steps of a floor.
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
    /// Ends a run that exceeds its budget; call it at the start of each step.
    #[inline]
    pub(crate) fn step(&self, step: usize, clock: Clock) -> Result<(), RunError> {
        if step & self.bits == 0 {
            self.look(clock.time(step), 0)
        } else {
            Ok(())
        }
    }

    /// Ends a run that exceeds its budget after this many pieces.
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

    /// Ends a run that was stopped or takes too long. Call it in long computations at an instant, which long rows have.
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

    /// Whether this many pieces would exceed the budget.
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
