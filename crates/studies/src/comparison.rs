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
    /// Of the peak drift of a storey on another floor; nothing where the drift is the displacement.
    pub drift: Option<f64>,
    /// Of the displacement at the end of the run, relative to the exact peak displacement: it may be next to nothing.
    pub last_displacement: f64,
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
}

/// A printed quantity, or all of them, whose error counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Transferred momentum of every structure.
    Momentum,
    /// Peak displacement of every floor, peak drift of every storey, and displacement at the end.
    Displacement,
    /// Peak absolute acceleration of every floor.
    Acceleration,
    /// Peak shear force of every structure and peak pounding force of every compliant pair.
    Force,
    /// Impulse of the first collision and largest impulse of every pair.
    Impulse,
    /// Time of the first collision of every pair, relative to that time.
    Time,
    /// All of these, and equal numbers of collisions.
    All,
}

/// A number that is printed of structures or pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Number {
    /// Transferred momentum of a structure.
    Momentum,
    /// Its peak displacement.
    Displacement,
    /// Peak drift of a storey on another floor.
    Drift,
    /// Its displacement at the end.
    LastDisplacement,
    /// Its peak absolute acceleration.
    Acceleration,
    /// Its peak shear force.
    ShearForce,
    /// Number of collisions of a pair.
    Collisions,
    /// Time of its first collision.
    FirstTouch,
    /// Impulse of its first collision.
    FirstImpulse,
    /// Largest impulse of a collision.
    LargestImpulse,
    /// Its peak pounding force.
    PoundingForce,
}

impl Number {
    /// Every printed number.
    pub const ALL: [Self; 11] = [
        Self::Momentum,
        Self::Displacement,
        Self::Drift,
        Self::LastDisplacement,
        Self::Acceleration,
        Self::ShearForce,
        Self::Collisions,
        Self::FirstTouch,
        Self::FirstImpulse,
        Self::LargestImpulse,
        Self::PoundingForce,
    ];

    /// Its name in text.
    pub fn words(self) -> &'static str {
        match self {
            Self::Momentum => "momentum",
            Self::Displacement => "displacement",
            Self::Drift => "storey drift",
            Self::LastDisplacement => "end displacement",
            Self::Acceleration => "acceleration",
            Self::ShearForce => "shear force",
            Self::Collisions => "collisions",
            Self::FirstTouch => "first touch",
            Self::FirstImpulse => "first impulse",
            Self::LargestImpulse => "largest impulse",
            Self::PoundingForce => "pounding force",
        }
    }

    /// The quantity that it belongs to.
    fn quantity(self) -> Quantity {
        match self {
            Self::Momentum => Quantity::Momentum,
            Self::Displacement | Self::Drift | Self::LastDisplacement => Quantity::Displacement,
            Self::Acceleration => Quantity::Acceleration,
            Self::ShearForce | Self::PoundingForce => Quantity::Force,
            Self::Collisions => Quantity::All,
            Self::FirstTouch => Quantity::Time,
            Self::FirstImpulse | Self::LargestImpulse => Quantity::Impulse,
        }
    }
}

impl RunErrors {
    /// Compares a run with the exact one.
    ///
    /// `walls` says of every floor whether it is a wall, which has no peaks of its own; with it comes the number of pairs.
    pub fn between(run: &Outcome, exact: &Outcome, (walls, n_pairs): (&[bool], usize)) -> Self {
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
                drift: of_run
                    .storey_drift
                    .zip(of_exact.storey_drift)
                    .map(|(run, exact)| peak(run, exact)),
                last_displacement: relative_to(
                    run.last.of(index),
                    exact.last.of(index),
                    of_exact.displacement.value.abs(),
                ),
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
        let pair = |index| {
            let of_pair =
                |outcome: &Outcome| outcome.collisions_of(index).copied().collect::<Vec<_>>();
            PairErrors::between(&of_pair(run), &of_pair(exact))
        };
        Self {
            structures: walls.iter().enumerate().map(structure).collect(),
            pairs: (0..n_pairs).map(pair).collect(),
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
            Number::Acceleration => structures(|errors| errors.acceleration),
            Number::ShearForce => structures(|errors| errors.restoring_force),
            Number::Collisions => pairs(|errors| errors.differ().then_some(f64::INFINITY)),
            Number::FirstTouch => pairs(|errors| errors.first_time_relative),
            Number::FirstImpulse => pairs(|errors| errors.first_impulse),
            Number::LargestImpulse => pairs(|errors| errors.largest_impulse),
            Number::PoundingForce => pairs(|errors| errors.peak_force),
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
        // Of an impulsive law only rest has a force, and only the exact method knows of rest.
        let impulsive = !run.is_empty() && run.iter().all(|one| one.peak_force.is_none());
        let rests = impulsive && exact.iter().any(|one| one.peak_force.is_some());
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
        }
    }
}

/// Part of a row's largest momentum below which one is zero: forces from both sides cancel but for rounding.
pub(crate) const ZERO: f64 = 1e-9;

/// A first touch before this instant \[s\] is at the start: its error is relative to 1 s.
pub(crate) const AT_ONCE: f64 = 1e-9;

/// Distance relative to a scale; 0 of equal numbers, infinite of what is not a number.
pub(crate) fn relative_to(run: f64, exact: f64, scale: f64) -> f64 {
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
pub(crate) fn relative(run: f64, exact: f64) -> f64 {
    relative_to(run, exact, exact.abs())
}
