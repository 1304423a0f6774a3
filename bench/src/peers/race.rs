//! All settings of all entrants in turn.

use std::time::Duration;

use super::entrants::{Entrant, OURS, entrants};
use super::environment::Worker;
use super::own;
use super::scenes::{Measured, SCENES, Scenes};
use crate::measure::{Outcome, median};

/// A setting of an entrant.
#[derive(Debug, Clone)]
pub(super) struct Rung {
    pub(super) setting: f64,
    pub(super) error: f64,
    seconds: Vec<f64>,
}

/// An entrant and its results.
#[derive(Debug, Clone)]
pub(super) struct EntrantRun {
    pub(super) entrant: Entrant,
    pub(super) rungs: Vec<Rung>,
}

/// All entrants on the scenes of a kind.
#[derive(Debug, Clone)]
pub(super) struct Raced {
    /// Name of the kind in tables.
    pub(super) law: &'static str,
    /// Title of its panel.
    pub(super) title: &'static str,
    pub(super) runs: Vec<EntrantRun>,
    /// CPU time of a scene that is the unit of all others \[s\].
    pub(super) unit: f64,
}

/// The time step \[s\] at which central differences in lanes are the unit.
const UNIT_STEP: f64 = 0.01;
/// Longest duration of the scenes; a ladder ends with the setting that exceeds it.
const LONGEST: Duration = Duration::from_secs(3);
/// Rounds over all settings, and the longest total duration of all rounds of a setting.
const ROUNDS: usize = 7;
const PATIENCE: Duration = Duration::from_secs(2);

impl Rung {
    /// Median CPU time of a scene \[s\].
    pub(super) fn seconds(&self) -> f64 {
        median(self.seconds.clone())
    }

    /// Duration of all measurements so far, plus another one \[s\].
    fn with_another(&self) -> f64 {
        let sum: f64 = self.seconds.iter().sum();
        SCENES as f64 * (sum + self.seconds())
    }
}

impl EntrantRun {
    /// CPU time and error of every setting with a finite error.
    pub(super) fn points(&self) -> Vec<(f64, f64)> {
        let finite = self.rungs.iter().filter(|rung| rung.error.is_finite());
        finite.map(|rung| (rung.seconds(), rung.error)).collect()
    }

    pub(super) fn is_ours(&self) -> bool {
        self.entrant.tool == OURS
    }
}

/// Measures a setting once.
fn measured(entrant: &Entrant, setting: f64, scenes: &Scenes<'_>, worker: &mut Worker) -> Outcome<Measured> {
    if entrant.tool == OURS {
        own::measured(scenes, entrant.method, setting)
    } else {
        worker.ask(entrant, setting, scenes.kind.names()[0])
    }
}

/// Runs all entrants on the scenes of a kind.
pub(super) fn run(scenes: &Scenes<'_>, worker: &mut Worker) -> Outcome<Raced> {
    let [law, title] = scenes.kind.names();
    let takes_part = |entrant: &Entrant| entrant.tool == OURS || worker.has(entrant.tool);
    let entrants: Vec<Entrant> = entrants(scenes.kind).filter(takes_part).collect();
    let mut runs = Vec::new();
    for entrant in entrants {
        let mut rungs = Vec::new();
        for &setting in entrant.knob.ladder() {
            let one = measured(&entrant, setting, scenes, &mut *worker)?;
            rungs.push(Rung {
                setting,
                error: scenes.error(&one.found),
                seconds: vec![one.seconds],
            });
            if one.seconds * SCENES as f64 > LONGEST.as_secs_f64() {
                break;
            }
        }
        println!("{}: {}, {} settings", law, entrant.label, rungs.len());
        runs.push(EntrantRun { entrant, rungs });
    }
    for _ in 1..ROUNDS {
        for run in &mut runs {
            for rung in &mut run.rungs {
                if rung.with_another() < PATIENCE.as_secs_f64() {
                    let one = measured(&run.entrant, rung.setting, scenes, &mut *worker)?;
                    rung.seconds.push(one.seconds);
                }
            }
        }
    }
    let unit = runs.iter().find(|run| run.entrant.method == own::LANES);
    let unit = unit.and_then(|run| {
        let step = |rung: &&Rung| rung.setting.total_cmp(&UNIT_STEP).is_eq();
        run.rungs.iter().find(step)
    });
    Ok(Raced {
        law,
        title,
        unit: unit.ok_or("lanes have no time step that is the unit")?.seconds(),
        runs,
    })
}
