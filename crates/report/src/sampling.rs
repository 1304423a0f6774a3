//! At which instants a results folder has the state of every structure.

use pounding_scene::Simulation;

/// More rows than this a file of histories does not get: tools open a file of this size without asking.
const MOST_ROWS: usize = 20_000;

/// Longest interval for a method without steps \[s\]: a collision of buildings lasts some 10 ms, and would fall between two samples of most
/// records.
const LONGEST: f64 = 0.0025;

/// The instants: 0, one interval, two intervals, up to the end of the run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sampling {
    /// Interval \[s\].
    pub(super) interval: f64,
    /// How it follows from method and record, in words.
    pub(super) words: &'static str,
}

impl Sampling {
    /// The sampling of a run: its time steps, or else whole parts of the record's; coarser if that would be too many rows.
    pub(super) fn of(prepared: &Simulation) -> Self {
        let duration = prepared.duration();
        if let Some(step) = prepared.method().time_step() {
            let every = (duration / step / MOST_ROWS as f64 - 1e-9).ceil().max(1.0);
            let words = if every > 1.0 {
                "a whole number of time steps, so that there are at most 20 000 rows"
            } else {
                "every time step"
            };
            return Self {
                interval: step * every,
                words,
            };
        }
        let of_record = prepared.record().time_step();
        let interval = of_record / (of_record / LONGEST - 1e-9).ceil().max(1.0);
        let every = (duration / interval / MOST_ROWS as f64 - 1e-9).ceil().max(1.0);
        let words = if every > 1.0 {
            "a multiple of a part of the record's time step, so that there are at most 20 000 rows"
        } else if interval < of_record {
            "a whole part of the record's time step, at most 2.5 ms"
        } else {
            "the record's time step"
        };
        Self {
            interval: interval * every,
            words,
        }
    }
}
