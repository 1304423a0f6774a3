//! Condition: the sensitivity of an exact run's numbers to the data of its scene.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use super::compared::{ALLOWED, Stage, Two};
use super::numbers::Numbers;
use super::random::Random;
use super::written::rewritten;
use crate::research::work_precision::{Known, under};
use pounding_motion::Record;
use pounding_scene::{Extras, Scene, Simulation, SimulationOptions};

/// Relative changes of the data \[–\]. The second is tried if the first does not explain a distance. It is as small as rounding, so it
/// shows the rounding that the exact run adds up over many touches. The first is too large for motions that diverge with every bounce.
const CHANGES: [f64; 2] = [1e-12, 1e-15];
/// Number of records with other samples; more of them find a larger condition and allow more.
const N_RECORDS: usize = 4;
/// Number of scenes with other structures, contacts and arrivals.
const N_SCENES: usize = 4;
/// Number of variants per change: a scaled record, those with other samples, one with its samples further apart, as if all structures were
/// faster, and the changed scenes.
const N_NEAR: usize = 1 + N_RECORDS + 1 + N_SCENES;

/// Change of a number per relative change of the data: relative \[–\], for instants \[s\]; infinite if touches come and go.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Condition {
    /// Change by the larger change of the data, or by the smaller one if touches come and go under the larger.
    pub of_data: Option<f64>,
    /// Largest change by both changes of the data.
    pub with_rounding: f64,
}

impl Condition {
    /// Includes `moved`, the change of the number under the next smaller change of the data.
    fn also(self, moved: f64) -> Self {
        let known = self.of_data.filter(|known| known.is_finite());
        Self {
            of_data: Some(known.unwrap_or(moved)),
            with_rounding: known.map_or(moved, |known| known.max(moved)),
        }
    }
}

/// Options for scenes in a folder whose runs end once `stop` is set.
pub(super) fn stopped_by<'a>(base: &'a Path, stop: &'static AtomicBool) -> SimulationOptions<'a> {
    SimulationOptions {
        stop: Some(stop),
        ..base.into()
    }
}

/// A scene whose data can be changed.
pub(super) struct Data<'a> {
    pub prepared: &'a Simulation,
    pub scene: &'a Scene,
    /// Folder that the name of the record is relative to.
    pub base: &'a Path,
    /// Flag that ends the runs.
    pub stop: &'static AtomicBool,
}

impl Data<'_> {
    /// The condition of every number of an exact run. The search ends as soon as it explains all distances.
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

    /// The exact run with variant `index` of the data.
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

    /// The scene under its record with the samples further apart.
    fn stretched(&self, change: f64) -> Result<Simulation, pounding_scene::Error> {
        self.prepared.under(|record| {
            let step = record.time_step() * (1.0 + change);
            Record::new(step, record.samples().to_vec(), record.source())
        })
    }
}

/// The scene with slightly changed structures, contacts and arrivals, as if all were written with an error. Gaps change by a part of the
/// largest displacement \[m\]. A gap of 0 stays 0: otherwise floors at rest would touch for the first time.
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
    rewritten(&scene, &["structures", "contacts", "arrivals_s", "links"], &mut each)
}

/// Numbers that stay, because they may mean a choice: zero, Bouc–Wen columns that unload along a straight line, impacts without loss.
const CHOICES: [f64; 3] = [0.0, 0.5, 1.0];

/// The allowed distance of two numbers with a condition.
pub(super) fn allowed(two: &Two, condition: f64) -> f64 {
    let known = Known {
        condition,
        distance: two.distance,
    };
    known.allowed_from(ALLOWED)
}
