//! This project's methods, timed as the others are.

use std::hint::black_box;
use std::time::Duration;

use cpu_time::ProcessTime;
use pounding_lanes::{ExactSideBySide, RowsOf, SceneSums, SideBySide};
use pounding_solver::{CentralDifference, Exact, Hysteretic, Integrator, Row, SimultaneousImpacts};

use super::scenes::{Found, IN_LANES, Measured, Rows, SCENES, Scenes, clock, exact, solved};

/// Names of the methods in tables.
pub(super) const LANES: &str = "central_difference_in_lanes";
pub(super) const EXACT: &str = "exact";
pub(super) const EXACT_LANES: &str = "exact_in_lanes";

/// A measurement repeats what is shorter, as `worker.py` does.
const LEAST: Duration = Duration::from_millis(20);

/// Runs the scenes by a method at a setting and measures the CPU time of one.
pub(super) fn measured(
    scenes: &Scenes<'_>,
    method: &str,
    setting: f64,
) -> Result<Measured, String> {
    match method {
        LANES => in_lanes(scenes, setting),
        // The exact method keeps no time step; a clock says how long it runs.
        EXACT_LANES => exact_in_lanes(scenes, setting),
        EXACT => Ok(match &scenes.rows {
            Rows::Structures(rows) => alone(scenes, rows, exact(setting)),
            Rows::Towers(rows) => alone(scenes, rows, exact(setting)),
        }),
        _ => Err(format!(
            "{method}: no such method; name one of those in own.rs"
        )),
    }
}

/// Vectors full of scenes: those that are compared, and others like them.
fn in_lanes(scenes: &Scenes<'_>, time_step: f64) -> Result<Measured, String> {
    let clock = clock(time_step);
    let together = SideBySide::new(CentralDifference::default(), scenes.excitation, clock);
    let together = together.map_err(|error| error.to_string())?;
    let n_steps = [clock.n_steps; IN_LANES];
    let run = |rows: RowsOf<'_>| {
        beside(scenes, |tallies| {
            together.run(rows, &n_steps, tallies);
        })
    };
    Ok(match &scenes.rows {
        Rows::Structures(rows) => run(RowsOf::Elastic(&rows.iter().collect::<Vec<_>>())),
        Rows::Towers(rows) => run(RowsOf::Bilinear(&rows.iter().collect::<Vec<_>>())),
    })
}

/// The same by the exact method.
fn exact_in_lanes(scenes: &Scenes<'_>, tolerance: f64) -> Result<Measured, String> {
    let settings = Exact {
        // The least that lanes take; with impacts it changes nothing.
        tolerance: tolerance.max(1e-12),
        simultaneous_impacts: SimultaneousImpacts::Together,
    };
    let together = ExactSideBySide::new(settings, scenes.excitation, clock(0.02));
    let together = together.map_err(|error| error.to_string())?;
    let Rows::Structures(rows) = &scenes.rows else {
        return Err("the exact method runs towers one by one".into());
    };
    let rows: Vec<_> = rows.iter().enumerate().collect();
    Ok(beside(scenes, |tallies| {
        tallies.begin(rows.len(), (2, 1));
        together.run(&rows, tallies);
    }))
}

/// What a run of all scenes side by side takes and tells; a scene that it does not tell has no error that could be compared.
fn beside(scenes: &Scenes<'_>, mut run: impl FnMut(&mut SceneSums)) -> Measured {
    let mut tallies = SceneSums::default();
    let seconds = timed(|| {
        run(&mut tallies);
        black_box(&tallies);
    });
    let found = |scene: usize| -> Found {
        if scene >= tallies.len() || !tallies.is_told(scene) {
            return [f64::NAN; 3];
        }
        let [left, right] = scenes
            .tops
            .map(|top| tallies.displacement(scene, top).abs());
        let impulses = (0..scenes.n_pairs()).map(|pair| tallies.pair(scene, pair).impulse);
        [left, right, impulses.sum()]
    };
    Measured {
        seconds: seconds / IN_LANES as f64,
        found: (0..SCENES).map(found).collect(),
    }
}

/// One scene after the other, each with its recorders.
fn alone<Column: Hysteretic>(
    scenes: &Scenes<'_>,
    rows: &[Row<Column>],
    integrator: Integrator,
) -> Measured {
    let run = (integrator, clock(0.02));
    let mut found = Vec::new();
    let seconds = timed(|| {
        let one = |row| {
            let solved = solved(row, scenes.tops, scenes.excitation, run);
            solved.map_or([f64::NAN; 3], |one| one.0)
        };
        found = rows[..SCENES].iter().map(one).collect();
    });
    Measured {
        seconds: seconds / SCENES as f64,
        found,
    }
}

/// CPU time of a run \[s\], repeated where it is short, after one that is not timed.
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
