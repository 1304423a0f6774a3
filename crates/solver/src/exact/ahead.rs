//! The flight of a structure to the next sample.

use crate::{Flight, State};

/// The flight of a structure to the next sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ahead {
    pub(super) flight: Flight,
    /// Instant of the sample \[s\].
    pub(super) end: f64,
    /// State there, and the hysteretic part of its force.
    pub(super) state: State,
    pub(super) hysteretic_force: f64,
    /// What its acceleration does not exceed on the way \[m/s²\].
    pub(super) acceleration: f64,
}

impl Ahead {
    /// The same on a clock that shows less.
    pub(super) fn set_back(&mut self, by: f64) {
        self.end -= by;
    }
}
