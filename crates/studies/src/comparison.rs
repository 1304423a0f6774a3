//! How far a run is from the exact run of the same scene, for every number that is printed of it.

use pounding_solver::{Collision, Peak};

use crate::Outcome;

/// Errors of a run against the exact run of the same scene.
#[derive(Debug, Clone, PartialEq)]
pub struct RunErrors {
    /// Of every structure and wall, from the left.
    pub structures: Vec<StructureErrors>,
    /// Of every pair, from the left.
    pub pairs: Vec<PairErrors>,
}

/// Errors of what is printed of a structure; relative to the exact magnitude \[–\] where no unit is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StructureErrors {
    /// Of the peak displacement.
    pub displacement: f64,
    /// Of the instant of the peak displacement, absolute \[s\]; large where two peaks are nearly equal.
    pub displacement_time: f64,
    /// Of the peak restoring force (shear force of the structure).
    pub restoring_force: f64,
    /// Of the transferred momentum.
    pub momentum: f64,
}

/// Errors of what is printed of a pair; relative to the exact magnitude \[–\] where no unit is given.
///
/// Nothing where neither run has the quantity; infinite where only one has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairErrors {
    /// Whether the pair rests in contact in the exact run, and gets an impact in every step in this one: how many and how
    /// large depends on the step, so that but the time of the first is not compared.
    pub rests: bool,
    /// Number of collisions of the run and of the exact run.
    pub collisions: (usize, usize),
    /// Of the time of the first collision, absolute \[s\].
    pub first_time: Option<f64>,
    /// The same, relative to that time \[–\], or to 1 s where it is 0.
    pub first_time_relative: Option<f64>,
    /// Of the impulse of the first collision.
    pub first_impulse: Option<f64>,
    /// Of the largest impulse of a collision.
    pub largest_impulse: Option<f64>,
    /// Of the peak pounding force; nothing for impulsive contact.
    pub peak_force: Option<f64>,
}

/// A printed quantity, or all of them, whose error counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Transferred momentum of every structure.
    Momentum,
    /// Peak displacement of every structure.
    Displacement,
    /// Peak shear force of every structure and peak pounding force of every compliant pair.
    Force,
    /// Impulse of the first collision and largest impulse of every pair.
    Impulse,
    /// Time of the first collision of every pair, relative to that time.
    Time,
    /// All of these, and equal numbers of collisions.
    All,
}

impl RunErrors {
    /// Compares a run with the exact one.
    ///
    /// `walls` says of every structure whether it is a wall, which has no peaks of its own.
    pub fn between(run: &Outcome, exact: &Outcome, walls: &[bool]) -> Self {
        let momenta = (0..walls.len()).map(|index| exact.momentum.of(index));
        let largest = momenta.fold(0.0, f64::max);
        let structure = |(index, &wall): (usize, &bool)| {
            let momentum = exact.momentum.of(index);
            let (of_run, of_exact) = (run.peaks.of(index), exact.peaks.of(index));
            let peak = |run: Peak, exact: Peak| {
                if wall {
                    0.0
                } else {
                    relative(run.value, exact.value)
                }
            };
            StructureErrors {
                displacement: peak(of_run.displacement, of_exact.displacement),
                displacement_time: (of_run.displacement.time - of_exact.displacement.time).abs(),
                restoring_force: peak(of_run.restoring_force, of_exact.restoring_force),
                momentum: relative_to(
                    run.momentum.of(index),
                    momentum,
                    momentum.max(ZERO * largest),
                ),
            }
        };
        let pair = |index| PairErrors::between(&of_pair(run, index), &of_pair(exact, index));
        Self {
            structures: walls.iter().enumerate().map(structure).collect(),
            pairs: (0..walls.len().saturating_sub(1)).map(pair).collect(),
        }
    }

    /// Largest relative error of a quantity \[–\], and of what; infinite where the numbers of collisions differ or only
    /// one of the runs has the quantity.
    pub fn largest(&self, quantity: Quantity) -> (f64, &'static str) {
        let structures = self.structures.iter().flat_map(|errors| {
            [
                (Quantity::Momentum, errors.momentum, "momentum"),
                (Quantity::Displacement, errors.displacement, "displacement"),
                (Quantity::Force, errors.restoring_force, "shear force"),
            ]
        });
        let pairs = self.pairs.iter().flat_map(|errors| {
            let count = if errors.differ() { f64::INFINITY } else { 0.0 };
            let error = |value: Option<f64>| value.unwrap_or(0.0);
            [
                (Quantity::All, count, "collisions"),
                (
                    Quantity::Time,
                    error(errors.first_time_relative),
                    "first touch",
                ),
                (
                    Quantity::Impulse,
                    error(errors.first_impulse),
                    "first impulse",
                ),
                (
                    Quantity::Impulse,
                    error(errors.largest_impulse),
                    "largest impulse",
                ),
                (Quantity::Force, error(errors.peak_force), "pounding force"),
            ]
        });
        structures
            .chain(pairs)
            .filter(|(of, ..)| quantity == Quantity::All || *of == quantity)
            .map(|(_, error, name)| (error, name))
            .fold(
                (0.0, ""),
                |largest, next| {
                    if next.0 > largest.0 { next } else { largest }
                },
            )
    }
}

impl PairErrors {
    /// Whether the run and the exact run have different numbers of collisions, where these can be compared.
    pub fn differ(&self) -> bool {
        !self.rests && self.collisions.0 != self.collisions.1
    }

    fn between(run: &[&Collision], exact: &[&Collision]) -> Self {
        let error = |value: fn(&[&Collision]) -> Option<f64>, measure: fn(f64, f64) -> f64| match (
            value(run),
            value(exact),
        ) {
            (None, None) => None,
            (Some(run), Some(exact)) => Some(measure(run, exact)),
            (Some(_), None) | (None, Some(_)) => Some(f64::INFINITY),
        };
        let start: fn(&[&Collision]) -> Option<f64> = |all| all.first().map(|first| first.start);
        // Of an impulsive law only rest has a force, and only the exact method knows of rest.
        let impulsive = !run.is_empty() && run.iter().all(|one| one.peak_force.is_none());
        let rests = impulsive && exact.iter().any(|one| one.peak_force.is_some());
        let unless_resting = |error: Option<f64>| error.filter(|_| !rests);
        Self {
            rests,
            collisions: (run.len(), exact.len()),
            first_time: error(start, |run, exact| (run - exact).abs()),
            first_time_relative: error(start, |run, exact| {
                relative_to(run, exact, if exact > 0.0 { exact } else { 1.0 })
            }),
            first_impulse: unless_resting(error(
                |all| all.first().map(|first| first.impulse),
                relative,
            )),
            largest_impulse: unless_resting(error(
                |all| all.iter().map(|one| one.impulse).max_by(f64::total_cmp),
                relative,
            )),
            peak_force: unless_resting(error(
                |all| {
                    all.iter()
                        .filter_map(|one| one.peak_force)
                        .max_by(f64::total_cmp)
                },
                relative,
            )),
        }
    }
}

fn of_pair(outcome: &Outcome, pair: usize) -> Vec<&Collision> {
    let all = outcome.collisions.all().iter();
    all.filter(|collision| collision.pair == pair).collect()
}

/// Part of a row's largest momentum below which one is zero: forces from both sides cancel but for rounding.
const ZERO: f64 = 1e-9;

/// Distance relative to a scale; 0 of equal numbers.
fn relative_to(run: f64, exact: f64, scale: f64) -> f64 {
    let distance = (run - exact).abs();
    if distance == 0.0 {
        0.0
    } else {
        distance / scale
    }
}

/// Distance relative to the exact magnitude; infinite where that is 0 and the other is not.
pub(crate) fn relative(run: f64, exact: f64) -> f64 {
    relative_to(run, exact, exact.abs())
}
