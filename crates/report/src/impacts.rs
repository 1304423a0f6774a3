//! Every collision of a run, in the order in which they begin: as a table for people, and as `impacts.csv`.

use pounding_scene::Floors;
use pounding_solver::Collision;
use pounding_text::{Cell, Table, Unit, digits, instant, short};

/// A table of collisions; `heading` stands above the names of the floors.
pub fn collision_table<'a>(
    floors: &'a Floors,
    collisions: impl Iterator<Item = &'a Collision>,
    heading: String,
) -> Table<'a, &'a Collision> {
    let thousandths = |value: f64| short(1e-3 * value);
    Table::of(collisions)
        .shown(heading, |one| floors.names(one.pair).join(" – "))
        .column("pair", |one| one.pair)
        .column("left", |one| floors.names(one.pair)[0].clone())
        .column("right", |one| floors.names(one.pair)[1].clone())
        .both("start_s", ("Start", "s"), |one| exact(one.start), |one| digits(one.start))
        .column("end_s", |one| exact(one.end))
        .both(
            "duration_s",
            ("Duration", "ms"),
            |one| exact(lasts(one)),
            |one| short(1e3 * lasts(one)),
        )
        .both(
            "approach_speed_m_per_s",
            ("Approach speed", "m/s"),
            |one| exact(one.approach_speed),
            |one| one.approach_speed.map(short),
        )
        .both(
            "impulse_n_s",
            ("Impulse", "kN·s"),
            |one| exact(one.impulse),
            move |one| thousandths(one.impulse),
        )
        .both(
            "peak_force_n",
            ("Peak force", "kN"),
            |one| exact(one.peak_force),
            |one| one.peak_force.map(|force| Unit::POUNDING_FORCE.text_of(force, 1.0)),
        )
        .both(
            "peak_force_time_s",
            ("at", "s"),
            |one| exact(one.peak_force_time),
            |one| one.peak_force_time.map(instant),
        )
        .column("start_uncertainty_s", |one| exact(one.uncertainty))
}

/// Duration of a collision \[s\].
fn lasts(one: &Collision) -> f64 {
    one.end - one.start
}

/// The shortest digits that give the number back: a fixed number of digits could not tell instants of bounces apart.
fn exact(value: impl Into<Option<f64>>) -> Cell {
    // A negative zero loses its sign.
    Cell::number(value, |value| format!("{:?}", value + 0.0))
}
