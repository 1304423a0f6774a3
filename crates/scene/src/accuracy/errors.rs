//! How far a run is from the exact run of the same scene, for every number that is printed of it.
//!
//! A [`Number`] is what an accuracy promises; here stands how the error of each is measured. Left out are the instants of
//! peaks, which jump where two peaks are nearly equal, and the terms of the energy.

use pounding_solver::{Collision, Pair, Peak};

use crate::simulation::LEANS;
use crate::{Number, PairOutcome, Quantity, RunResult, Simulation};

/// Part of a peak \[–\] below which what is left of it is measured by this part: it may be next to nothing itself.
pub const LEAST_PART: f64 = 0.05;

/// How errors are measured, and what is not, in words.
pub const MEASURE: &str = "each relative to the exact number; residuals and least openings below 5 % of the peak to 5 % of \
                           it, times of touching below 0.25 s to 0.25 s. Times of peaks and energies are left out";

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
    /// Of the peak drift of a storey on another floor; nothing where the drift is the displacement.
    pub drift: Option<f64>,
    /// Of the displacement at the end of the run, relative to itself or to [`LEAST_PART`] of the exact peak displacement,
    /// whichever is more.
    pub last_displacement: f64,
    /// Of the drift at the end of a storey on another floor, by its peak drift likewise; nothing where the drift is the
    /// displacement.
    pub last_drift: Option<f64>,
    /// Of the peak absolute acceleration.
    pub acceleration: f64,
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
    /// The same, relative to that time \[–\], or to 1 s where it is the start.
    pub first_time_relative: Option<f64>,
    /// Of the impulse of the first collision.
    pub first_impulse: Option<f64>,
    /// Of the largest impulse of a collision.
    pub largest_impulse: Option<f64>,
    /// Of the peak pounding force; nothing for impulsive contact.
    pub peak_force: Option<f64>,
    /// Of the sum of all impulses.
    pub total_impulse: Option<f64>,
    /// Of the time for which they touch, relative to itself or to 0.25 s, whichever is more.
    pub touching: Option<f64>,
    /// Of the least opening, relative to itself or to [`LEAST_PART`] of the larger exact peak displacement of both
    /// neighbours, whichever is more; nothing where a run did not record closings.
    pub least_opening: Option<f64>,
}

impl PairErrors {
    /// Compares what happened to a pair, by its index, in a run and in the exact one.
    fn of([run, exact]: [&RunResult; 2], (index, pair): (usize, &Pair)) -> Self {
        let of_pair =
            |outcome: &RunResult| outcome.collisions_of(index).copied().collect::<Vec<_>>();
        let opening = |outcome: &RunResult| {
            let opening = outcome.least_opening(pair, &outcome.of_pair(index))?;
            Some(opening.0)
        };
        let peaks = [pair.left, pair.right].map(|node| exact.peaks.of(node).displacement.value);
        let least = LEAST_PART * peaks[0].abs().max(peaks[1].abs());
        Self {
            least_opening: opening(run)
                .zip(opening(exact))
                .map(|(run, exact)| relative_to(run, exact, exact.abs().max(least))),
            ..Self::between(&of_pair(run), &of_pair(exact))
        }
    }
}

impl RunErrors {
    /// Compares a run of a scene with the exact one.
    pub fn between(run: &RunResult, exact: &RunResult, prepared: &Simulation) -> Self {
        let walls = prepared.walls();
        let last = |outcome: &RunResult, index: usize, below: Option<usize>| {
            let below = below.map_or(0.0, |below| outcome.last.of(below));
            outcome.last.of(index) - below
        };
        let left_over = |index: usize, below: Option<usize>, peak: f64| {
            let [run, exact] = [run, exact].map(|outcome| last(outcome, index, below));
            relative_to(run, exact, exact.abs().max(LEAST_PART * peak.abs()))
        };
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
            let drifts = of_run.storey_drift.zip(of_exact.storey_drift);
            let below = prepared.floors().below(index);
            let left_over_drift = |below| left_over(index, Some(below), of_exact.drift().value);
            StructureErrors {
                displacement: peak(of_run.displacement, of_exact.displacement),
                drift: drifts.map(|(run, exact)| peak(run, exact)),
                last_displacement: left_over(index, None, of_exact.displacement.value),
                last_drift: below.map(left_over_drift),
                acceleration: peak(run.accelerations[index], exact.accelerations[index]),
                displacement_time: (of_run.displacement.time - of_exact.displacement.time).abs(),
                restoring_force: peak(of_run.restoring_force, of_exact.restoring_force),
                momentum: relative_to(
                    run.momentum.of(index),
                    momentum,
                    momentum.max(ZERO * largest),
                ),
            }
        };
        let pair = |of: (usize, &Pair)| PairErrors::of([run, exact], of);
        Self {
            structures: walls.iter().enumerate().map(structure).collect(),
            pairs: prepared.pairs().iter().enumerate().map(pair).collect(),
        }
    }

    /// Largest relative error of a quantity \[–\], and of what; infinite where the numbers of collisions differ or only
    /// one of the runs has the quantity.
    pub fn largest(&self, quantity: Quantity) -> (f64, &'static str) {
        Number::ALL
            .into_iter()
            .filter(|number| quantity == Quantity::All || number.quantity() == quantity)
            .map(|number| (self.of(number), number.words()))
            .fold(
                (0.0, ""),
                |largest, next| {
                    if next.0 > largest.0 { next } else { largest }
                },
            )
    }

    /// Largest relative error of a printed number, over all structures or pairs \[–\].
    pub fn of(&self, number: Number) -> f64 {
        let structures = |error: fn(&StructureErrors) -> f64| {
            self.structures.iter().map(error).fold(0.0, f64::max)
        };
        let pairs = |error: fn(&PairErrors) -> Option<f64>| {
            self.pairs.iter().filter_map(error).fold(0.0, f64::max)
        };
        match number {
            Number::Momentum => structures(|errors| errors.momentum),
            Number::Displacement => structures(|errors| errors.displacement),
            Number::Drift => structures(|errors| errors.drift.unwrap_or(0.0)),
            Number::LastDisplacement => structures(|errors| errors.last_displacement),
            Number::LastDrift => structures(|errors| errors.last_drift.unwrap_or(0.0)),
            Number::Acceleration => structures(|errors| errors.acceleration),
            Number::ShearForce => structures(|errors| errors.restoring_force),
            Number::Collisions => pairs(|errors| errors.differ().then_some(f64::INFINITY)),
            Number::FirstTouch => pairs(|errors| errors.first_time_relative),
            Number::FirstImpulse => pairs(|errors| errors.first_impulse),
            Number::LargestImpulse => pairs(|errors| errors.largest_impulse),
            Number::PoundingForce => pairs(|errors| errors.peak_force),
            Number::TotalImpulse => pairs(|errors| errors.total_impulse),
            Number::Touching => pairs(|errors| errors.touching),
            Number::LeastOpening => pairs(|errors| errors.least_opening),
        }
    }
}

impl PairErrors {
    /// Whether the run and the exact run have different numbers of collisions, where these can be compared.
    pub fn differ(&self) -> bool {
        !self.rests && self.collisions.0 != self.collisions.1
    }

    fn between(run: &[Collision], exact: &[Collision]) -> Self {
        let error = |value: fn(&[Collision]) -> Option<f64>, measure: fn(f64, f64) -> f64| match (
            value(run),
            value(exact),
        ) {
            (None, None) => None,
            (Some(run), Some(exact)) => Some(measure(run, exact)),
            (Some(_), None) | (None, Some(_)) => Some(f64::INFINITY),
        };
        let start: fn(&[Collision]) -> Option<f64> = |all| all.first().map(|first| first.start);
        // Of an impulsive law only rest lasts; a stepping method tells it from bounces where e = 0.
        let impulsive = !run.is_empty() && run.iter().all(|one| one.peak_force.is_none());
        let lasts = |all: &[Collision]| all.iter().any(|one| one.end > one.start);
        let rests = impulsive && lasts(exact) && !lasts(run);
        let [of_run, of_exact] = [run, exact].map(PairOutcome::of);
        let unless_resting = |error: Option<f64>| error.filter(|_| !rests);
        Self {
            rests,
            collisions: (run.len(), exact.len()),
            first_time: error(start, |run, exact| (run - exact).abs()),
            first_time_relative: error(start, |run, exact| {
                relative_to(run, exact, if exact < AT_ONCE { 1.0 } else { exact })
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
            total_impulse: unless_resting(Some(relative(
                of_run.total_impulse,
                of_exact.total_impulse,
            ))),
            touching: unless_resting(Some(relative_to(
                of_run.touching,
                of_exact.touching,
                of_exact.touching.max(LEANS),
            ))),
            least_opening: None,
        }
    }
}

/// Part of a row's largest momentum below which one is zero: forces from both sides cancel but for rounding.
pub const ZERO: f64 = 1e-9;

/// A first touch before this instant \[s\] is at the start: its error is relative to 1 s.
pub const AT_ONCE: f64 = 1e-9;

/// Distance relative to a scale; 0 of equal numbers, infinite of what is not a number.
pub fn relative_to(run: f64, exact: f64, scale: f64) -> f64 {
    let distance = (run - exact).abs();
    if distance == 0.0 {
        return 0.0;
    }
    let relative = distance / scale;
    if relative.is_nan() {
        f64::INFINITY
    } else {
        relative
    }
}

/// Distance relative to the exact magnitude; infinite where that is 0 and the other is not.
pub fn relative(run: f64, exact: f64) -> f64 {
    relative_to(run, exact, exact.abs())
}
