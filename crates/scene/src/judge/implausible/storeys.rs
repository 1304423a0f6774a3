//! Implausible values of the storeys of a building, alone and compared with each other.

use pounding_solver::Mode;

use super::Doubts;
use crate::{Building, Columns};
use pounding_text::{digits, percent, short, two_digits};

/// Usual drift ratios at which columns yield \[–\]: from stiff walls to isolators under a low crawl space.
const YIELDS: std::ops::RangeInclusive<f64> = 5e-4..=0.05;
/// Largest usual ratio of the stiffnesses of the stiffest and the softest storey \[–\]: isolators are some tens of times softer than the
/// building above.
const STIFFER: f64 = 200.0;

/// Largest usual displacement \[m\] and velocity \[m/s\] at the start: those of the strongest shaking.
const FARTHEST: f64 = 2.0;
const FASTEST: f64 = 5.0;

/// Notes implausible heights, stiffnesses, yielding and periods of a building.
pub(super) fn doubt(index: usize, building: &Building, doubts: &mut Doubts) {
    let place = |field: &str| format!("structures[{index}].building{field}");
    let stiffest = building.storeys.iter();
    let stiffest = stiffest.map(|one| one.columns.stiffness_n_per_m);
    let stiffest = stiffest.fold(0.0, f64::max);
    for (storey, one) in building.storeys.iter().enumerate() {
        let place = |field: &str| place(&format!(".storeys[{storey}].{field}"));
        if let Some(height) = one.height_m {
            doubts.unless_far(
                (0.2..=30.0).contains(&height),
                height / 3.0,
                place("height_m"),
                format!("{} m", digits(height)),
                "0.2 to 30 m for a storey",
            );
        }
        let stiffness = one.columns.stiffness_n_per_m;
        doubts.unless_far(
            stiffness * STIFFER >= stiffest,
            stiffest / stiffness,
            place("stiffness_n_per_m"),
            format!("{} N/m, where another storey has {} N/m", short(stiffness), short(stiffest)),
            "a storey no more than 200 times softer than others",
        );
        doubt_the_start(place, one.initial_displacement_m, one.initial_velocity_m_per_s, doubts);
        if one.capacities.isolation_layer != Some(true) {
            doubt_the_yielding(&place("yield_drift_ratio"), &one.columns, one.height_m, doubts);
        }
    }
    doubt_the_period(index, building, doubts);
    ask_for_isolators(index, building, doubts);
}

/// Asks whether a lowest storey that looks like isolators stands for them: limits of columns do not hold for it then.
fn ask_for_isolators(index: usize, building: &Building, doubts: &mut Doubts) {
    let told = building.storeys.first().and_then(|one| one.capacities.isolation_layer);
    let Some((period, softer)) = building.looks_isolated().filter(|_| told.is_none()) else {
        return;
    };
    doubts.unless(
        false,
        format!("structures[{index}].building.storeys[0]"),
        format!(
            "a storey {} times softer than the next, with a period of {} s under the building, judged as columns",
            two_digits(softer),
            two_digits(period)
        ),
        "`isolator`, or `isolation_layer = true`, if it stands for isolators, `isolation_layer = false` if it does not",
    );
}

/// Notes an initial displacement \[m\] or velocity \[m/s\] that no earthquake causes.
pub(super) fn doubt_the_start(place: impl Fn(&str) -> String, displacement: f64, velocity: f64, doubts: &mut Doubts) {
    doubts.unless(
        displacement.abs() <= FARTHEST,
        place("initial_displacement_m"),
        format!("{} m", short(displacement)),
        "up to 2 m; it is in metres",
    );
    doubts.unless(
        velocity.abs() <= FASTEST,
        place("initial_velocity_m_per_s"),
        format!("{} m/s", short(velocity)),
        "up to 5 m/s",
    );
}

/// Notes columns that yield at an unusual part of their height, however the yielding is given.
pub(super) fn doubt_the_yielding(place: &str, columns: &Columns, height: Option<f64>, doubts: &mut Doubts) {
    let Some((force, height)) = columns.yield_force_n.zip(height) else {
        return;
    };
    let ratio = force / columns.stiffness_n_per_m / height;
    doubts.unless_far(
        YIELDS.contains(&ratio),
        ratio / 5e-3,
        place,
        format!("columns that yield at a drift of {} of their height", percent(ratio)),
        "0.05 % to 5 %; yield_force_n and yield_displacement_m decide it as well",
    );
}

/// Notes a long period of a building with few storeys: a mass or a stiffness is wrong by a power of ten.
fn doubt_the_period(index: usize, building: &Building, doubts: &mut Doubts) {
    let modes = building.modes();
    let Some(period) = modes.first().map(Mode::period) else {
        return;
    };
    let n = building.storeys.len();
    // Isolated buildings reach four seconds, whatever their height. Another note covers every period above ten seconds.
    let longest = 4.0 + 0.2 * n as f64;
    doubts.unless(
        period <= longest || period > 10.0,
        format!("structures[{index}].building"),
        format!("a first period of {} s with {n} storeys", short(period)),
        "about 0.1 s for a storey, up to 4 s on isolators; masses and stiffnesses decide it",
    );
}
