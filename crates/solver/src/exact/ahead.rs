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
    /// When it turns on the way.
    pub(super) turn: Option<Turn>,
}

/// A turn on the way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turn {
    pub(super) time: f64,
    /// State at the end of the way there, and at the start of the way on: its acceleration differs by rounding.
    pub(super) before: State,
    pub(super) after: State,
}

impl Ahead {
    /// The same on a clock that shows less.
    pub(super) fn set_back(&mut self, by: f64) {
        self.end -= by;
        if let Some(turn) = &mut self.turn {
            turn.time -= by;
        }
    }

    /// Whether the way goes on from here after a turn that changed nothing.
    pub(super) fn goes_on(&self, time: f64, state: &State) -> bool {
        let turns = |turn: Turn| turn.time.total_cmp(&time).is_eq();
        state.velocity == 0.0 && self.turn.is_some_and(turns)
    }
}
