//! This project's methods, timed like the others.

use std::hint::black_box;
use std::time::Duration;

use cpu_time::ProcessTime;
use pounding_lanes::{ExactSideBySide, SceneSums, SideBySide};
use pounding_solver::{Elastic, Hysteretic, Row};

use super::scenes::{Answers, IN_LANES, Measured, Rows, SCENES, Scenes, clock, solved};
use crate::measure::Outcome;
use crate::scenes::Beside;
use crate::setting::{STEPPING, exact, recorded};

/// Names of the methods in tables.
pub(super) const LANES: &str = "central_difference_in_lanes";
pub(super) const EXACT: &str = "exact";
pub(super) const EXACT_LANES: &str = "exact_in_lanes";

/// Least duration of a measurement; shorter runs are repeated, as in `worker.py`.
const LEAST: Duration = Duration::from_millis(20);

/// Runs the scenes by a method at a setting and measures the CPU time of a scene.
pub(super) fn measured(scenes: &Scenes<'_>, method: &str, setting: f64) -> Outcome<Measured> {
    match (method, &scenes.rows) {
        (LANES, Rows::Structures(rows)) => in_lanes(scenes, rows, setting),
        (LANES, Rows::Towers(rows)) => in_lanes(scenes, rows, setting),
        (EXACT_LANES, Rows::Structures(rows)) => exact_in_lanes(scenes, rows, setting),
        (EXACT, Rows::Structures(rows)) => Ok(alone(scenes, rows, setting)),
        (EXACT, Rows::Towers(rows)) => Ok(alone(scenes, rows, setting)),
        _ => Err(format!("{method} does not run these scenes; name one of those in own.rs").into()),
    }
}

/// Runs full vectors of scenes: those that are compared, and others like them.
fn in_lanes<Column: Beside>(scenes: &Scenes<'_>, rows: &[Row<Column>], time_step: f64) -> Outcome<Measured> {
    let clock = clock(time_step);
    let together = SideBySide::new(STEPPING, scenes.excitation, clock)?;
    let rows: Vec<_> = rows.iter().collect();
    Ok(beside(scenes, |sums| {
        together.run(Column::rows(&rows), &[clock.n_steps; IN_LANES], sums);
    }))
}

/// Runs full vectors of scenes by the exact method, which uses only the end of a clock.
fn exact_in_lanes(scenes: &Scenes<'_>, rows: &[Row<Elastic>], tolerance: f64) -> Outcome<Measured> {
    // The smallest tolerance of lanes; with impacts it changes nothing.
    let settings = exact(tolerance.max(1e-12));
    let together = ExactSideBySide::new(settings, scenes.excitation, recorded())?;
    let rows: Vec<_> = rows.iter().enumerate().collect();
    Ok(beside(scenes, |sums| {
        sums.begin(rows.len(), 2, 1);
        together.run(&rows, sums);
    }))
}

/// CPU time and results of a run of all scenes in lanes. A scene without results has no error to compare.
fn beside(scenes: &Scenes<'_>, mut run: impl FnMut(&mut SceneSums)) -> Measured {
    let mut tallies = SceneSums::default();
    let seconds = timed(|| {
        run(&mut tallies);
        black_box(&tallies);
    });
    let found = |scene: usize| -> Answers {
        if scene >= tallies.len() || !tallies.is_told(scene) {
            return [f64::NAN; 3];
        }
        let [left, right] = scenes.tops.map(|top| tallies.displacement(scene, top).abs());
        let impulses = (0..scenes.n_pairs).map(|pair| tallies.pair(scene, pair).impulse);
        [left, right, impulses.sum()]
    };
    Measured {
        seconds: seconds / IN_LANES as f64,
        found: (0..SCENES).map(found).collect(),
    }
}

/// Runs scene after scene by the exact method, each with its recorders.
fn alone<Column: Hysteretic>(scenes: &Scenes<'_>, rows: &[Row<Column>], tolerance: f64) -> Measured {
    let mut found = Vec::new();
    let seconds = timed(|| {
        let one = |row| {
            let solved = solved(row, scenes.tops, scenes.excitation, tolerance);
            solved.map_or([f64::NAN; 3], |one| one.0)
        };
        found = rows[..SCENES].iter().map(one).collect();
    });
    Measured {
        seconds: seconds / SCENES as f64,
        found,
    }
}

/// CPU time of a run \[s\], after an untimed run; short runs are repeated.
fn timed(mut run: impl FnMut()) -> f64 {
    run();
    let start = ProcessTime::now();
    let mut runs = 0;
    while runs == 0 || start.elapsed() < LEAST {
        run();
        runs += 1;
    }
    start.elapsed().as_secs_f64() / f64::from(runs)
}
