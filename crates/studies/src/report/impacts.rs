//! `impacts.csv`: every collision, in the order in which they begin.

use pounding_solver::Collision;

use crate::tables::to_csv;
use crate::{Floors, Outcome};

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
pub(super) fn csv(floors: &Floors, outcome: &Outcome) -> String {
    let header = HEADER.map(String::from);
    let collisions = outcome.collisions.all().iter();
    let rows: Vec<Vec<String>> = collisions.map(|one| row(floors, one).into()).collect();
    to_csv(&header, &rows)
}

fn row(floors: &Floors, one: &Collision) -> [String; 11] {
    let [left, right] = floors.names(one.pair);
    let known = |value: Option<f64>| value.map_or_else(String::new, exact);
    [
        one.pair.to_string(),
        left,
        right,
        exact(one.start),
        exact(one.end),
        exact(one.end - one.start),
        known(one.approach_speed),
        exact(one.impulse),
        known(one.peak_force),
        known(one.peak_force_time),
        known(one.uncertainty),
    ]
}

/// The shortest digits that give the same number back: instants of bounces lie closer than any fixed number of them tells.
fn exact(value: f64) -> String {
    // A negative zero loses its sign.
    format!("{:?}", value + 0.0)
}
