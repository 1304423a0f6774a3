//! How far the numbers of an exact run move with the data of its scene.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use super::compared::{ALLOWED, Stage, Two};
use super::numbers::Numbers;
use super::random::Random;
use super::written::rewritten;
use crate::research::work_precision::{Known, under};
use pounding_motion::Record;
use pounding_scene::{Extras, Scene, Simulation, SimulationOptions};

/// Relative changes of the data; the second where the first does not explain a distance. It is as small as rounding, so that what the
/// exact run itself rounds over many touches shows in it; and of a motion that bounces apart the first is too large to show by how much.
const CHANGES: [f64; 2] = [1e-12, 1e-15];
/// Records with other samples; more of them find a larger condition, and allow more.
const N_RECORDS: usize = 4;
/// Scenes with other structures, contacts and arrivals.
const N_SCENES: usize = 4;
/// Everything that is tried with a change: the scaled record and those above, and a record with its samples further apart, as if all
/// structures were faster.
const N_NEAR: usize = 1 + N_RECORDS + 1 + N_SCENES;

/// How far a number moves per relative change of the data: relative \[–\], of instants \[s\]; infinite where touches come and go.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Condition {
    /// By the larger change; by the smaller one where touches come and go by the larger.
    pub of_data: Option<f64>,
    /// By both.
    pub with_rounding: f64,
}

impl Condition {
    /// With what the next smaller change moves.
    fn also(self, moved: f64) -> Self {
        let known = self.of_data.filter(|known| known.is_finite());
        Self {
            of_data: Some(known.unwrap_or(moved)),
            with_rounding: known.map_or(moved, |known| known.max(moved)),
        }
    }
}

/// A scene in a folder, whose runs end when they are told to.
pub(super) fn stopped_by<'a>(base: &'a Path, stop: &'static AtomicBool) -> SimulationOptions<'a> {
    SimulationOptions {
        stop: Some(stop),
        ..base.into()
    }
}

/// A scene whose data are changed.
pub(super) struct Data<'a> {
    pub prepared: &'a Simulation,
    pub scene: &'a Scene,
    /// The folder that its record is looked for from.
    pub base: &'a Path,
    /// What ends its runs.
    pub stop: &'static AtomicBool,
}

impl Data<'_> {
    /// How far every number of an exact run moves per relative change of the data. No further than it takes to allow all distances,
    /// where it does.
    pub(super) fn conditions(&self, truth: &Numbers, all: &[Two], begin: &dyn Fn(Stage)) -> Vec<Condition> {
        let mut found = vec![Condition::default(); all.len()];
        for change in CHANGES {
            let mut largest = vec![0.0_f64; all.len()];
            for index in 0..N_NEAR {
                if self.stop.load(Ordering::Relaxed) {
                    return found;
                }
                begin(Stage::Condition);
                match self.near(change, index, truth.largest_displacement()) {
                    Ok(near) => {
                        for (largest, two) in largest.iter_mut().zip(truth.beside(&near)) {
                            *largest = largest.max(two.distance / change);
                        }
                    }
                    Err(_) => largest.fill(f64::INFINITY),
                }
                let next = found.iter().zip(&largest);
                let next: Vec<_> = next.map(|(one, largest)| one.also(*largest)).collect();
                let explains = |(two, one): (&Two, &Condition)| {
                    two.distance <= ALLOWED || (one.with_rounding.is_finite() && two.distance <= allowed(two, one.with_rounding))
                };
                if all.iter().zip(&next).all(explains) {
                    return next;
                }
            }
            for (one, largest) in found.iter_mut().zip(largest) {
                *one = one.also(largest);
            }
        }
        found
    }

    /// The exact run with other data.
    fn near(&self, change: f64, index: usize, largest: f64) -> Result<Numbers, pounding_scene::Error> {
        let near = if index <= N_RECORDS {
            under(self.prepared, change, index)
        } else if index == N_RECORDS + 1 {
            self.stretched(change)
        } else {
            let scene = changed(self.scene, change, index, largest);
            Simulation::new(&scene, stopped_by(self.base, self.stop))
        }?;
        let outcome = near.run_unjudged(Extras::default())?;
        Ok(Numbers::of_exact(&near, &outcome))
    }

    /// The scene under its record with samples further apart.
    fn stretched(&self, change: f64) -> Result<Simulation, pounding_scene::Error> {
        self.prepared.under(|record| {
            let step = record.time_step() * (1.0 + change);
            Record::new(step, record.samples().to_vec(), record.source())
        })
    }
}

/// The scene with other structures, contacts and arrivals: as if all of them were written down with an error, gaps with one of the
/// largest displacement \[m\], too. What has no gap keeps having none: floors at rest would touch for the first time.
fn changed(scene: &Scene, change: f64, index: usize, largest: f64) -> Scene {
    let mut random = Random::new(0, index);
    let mut factor = || 1.0 + change * random.within(-1.0, 1.0);
    let mut scene = scene.clone();
    for contact in scene.contacts.iter_mut().flatten() {
        if contact.gap_m > 0.0 {
            let moved = contact.gap_m + largest * (factor() - 1.0);
            contact.gap_m = moved.max(0.5 * contact.gap_m);
        }
    }
    let mut each = |number: f64| {
        let is_choice = CHOICES.contains(&number);
        if is_choice { number } else { number * factor() }
    };
    rewritten(&scene, &["structures", "contacts", "arrivals_s"], &mut each)
}

/// Numbers that may stand for a choice: nothing, Bouc–Wen columns that unload straight, impacts without a loss.
const CHOICES: [f64; 3] = [0.0, 0.5, 1.0];

/// The distance of two numbers that their condition allows.
pub(super) fn allowed(two: &Two, condition: f64) -> f64 {
    let known = Known {
        condition,
        distance: two.distance,
    };
    known.allowed_from(ALLOWED)
}
