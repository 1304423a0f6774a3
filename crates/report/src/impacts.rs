//! `impacts.csv`: every collision, in the order in which they begin.

use pounding_solver::Collision;

use pounding_scene::{Floors, RunResult};
use pounding_text::{Cell, csv_text};

const HEADER: [&str; 11] = [
    "pair",
    "left",
    "right",
    "start_s",
    "end_s",
    "duration_s",
    "approach_speed_m_per_s",
    "impulse_n_s",
    "peak_force_n",
    "peak_force_time_s",
    "start_uncertainty_s",
];

/// The file.
pub(super) fn csv(floors: &Floors, outcome: &RunResult) -> String {
    let collisions = outcome.collisions.all().iter();
    csv_text(&HEADER, collisions.map(|one| row(floors, one)))
}

fn row(floors: &Floors, one: &Collision) -> [Cell; 11] {
    let [left, right] = floors.names(one.pair);
    [
        one.pair.into(),
        left.into(),
        right.into(),
        exact(one.start),
        exact(one.end),
        exact(one.end - one.start),
        exact(one.approach_speed),
        exact(one.impulse),
        exact(one.peak_force),
        exact(one.peak_force_time),
        exact(one.uncertainty),
    ]
}

/// The shortest digits that give the number back: a fixed number of digits could not tell instants of bounces apart.
fn exact(value: impl Into<Option<f64>>) -> Cell {
    // A negative zero loses its sign.
    Cell::number(value, |value| format!("{:?}", value + 0.0))
}
