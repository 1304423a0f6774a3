//! How far the results of a scene move with its record, and whether the two routes are as close as that allows.

use super::quantities::{MethodQuantity, Quantities, Run};
use crate::noise::Noise;
use pounding_reference::Response;
use pounding_scene::{RunErrors, Simulation, parallel};
use pounding_solver::Collision;

/// Relative change of the records, small enough that what a result does is proportional to it.
const CHANGE: f64 = 1e-9;
/// Number of records with independent changes of every sample.
const N_RECORDS: usize = 16;
/// What rounding leaves of a result that moves as much as its record \[–\].
const ROUNDING: f64 = 1e-15;

/// A result of two routes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Known {
    /// Condition number: the largest relative change of the result per relative change of the record.
    ///
    /// Infinite where a collision is missing under some of the records.
    pub(crate) condition: f64,
    /// Relative distance of the two routes; infinite where a collision is missing on one of them.
    pub(crate) distance: f64,
}

impl Known {
    /// The distance that is allowed \[–\]: what the element's tolerance leaves, or rounding of the record.
    pub(super) fn allowed(self, compliant: bool) -> f64 {
        self.allowed_from(if compliant { 1e-9 } else { 1e-12 })
    }

    /// The distance that is allowed \[–\], at least `floor`: rounding of the record.
    pub(crate) fn allowed_from(self, floor: f64) -> f64 {
        (self.condition * ROUNDING).max(floor)
    }

    /// Whether the two routes are as close as is allowed.
    pub(super) fn holds(self, compliant: bool) -> bool {
        self.distance <= self.allowed(compliant)
    }
}

/// One collision of a scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting {
    /// First instant \[s\] and impulse \[N·s\].
    pub(super) values: [f64; 2],
    pub(super) known: [Known; 2],
}

/// How well the results of one scene are known.
#[derive(Debug)]
pub(super) struct Knowledge {
    /// For each quantity, the worst structure; nothing where nothing collides.
    quantities: [Option<Known>; MethodQuantity::ALL.len()],
    /// The collisions of every pair in their order.
    pub(super) pairs: Vec<Vec<Meeting>>,
    /// Whether the two routes count the same collisions.
    pub(super) same_count: bool,
}

impl Knowledge {
    /// Runs the reference under its record and others near it, and holds it against the second route.
    ///
    /// # Errors
    /// The reason where a run of the reference fails.
    pub(super) fn measure(run: &Run<'_>, second: Option<&Response>) -> Result<Self, String> {
        let truth = Results::of(run)?;
        let records: Vec<_> = (0..=N_RECORDS).collect();
        let near = parallel::try_each(&records, |&index| {
            let prepared = under(run.prepared, CHANGE, index).map_err(|error| error.to_string())?;
            let run = Run {
                prepared: &prepared,
                ..*run
            };
            Results::of(&run)
        })?;
        let second = second.map(Results::of_second_route);
        let known = |distance: &dyn Fn(&Results) -> f64| Known {
            condition: near.iter().map(distance).fold(0.0, f64::max) / CHANGE,
            distance: second.as_ref().map_or(f64::INFINITY, distance),
        };
        let quantities = MethodQuantity::ALL.map(|quantity| {
            let distance = |other: &Results| {
                let distance = other.quantities.distance(&truth.quantities, quantity);
                distance.unwrap_or(0.0)
            };
            let present = |results: &Results| !results.quantities.values(quantity).is_empty();
            let any = present(&truth) || second.as_ref().is_some_and(present);
            any.then(|| known(&distance))
        });
        let meeting = |pair: usize, index: usize| {
            let values = truth.pairs[pair][index];
            let distance = |other: &Results, which: usize| {
                if other.pairs[pair].len() != truth.pairs[pair].len() {
                    return f64::INFINITY;
                }
                RunErrors::relative(other.pairs[pair][index][which], values[which])
            };
            Meeting {
                values,
                known: [0, 1].map(|which| known(&|other| distance(other, which))),
            }
        };
        let pairs = truth.pairs.iter().enumerate();
        let pairs = pairs.map(|(pair, met)| (0..met.len()).map(|k| meeting(pair, k)).collect());
        let count = second.as_ref().map(|second| second.quantities.n_collisions);
        Ok(Self {
            quantities,
            pairs: pairs.collect(),
            same_count: count == Some(truth.quantities.n_collisions),
        })
    }

    /// How well a quantity is known; nothing where nothing collides.
    pub(super) fn of(&self, quantity: MethodQuantity) -> Option<Known> {
        self.quantities[quantity as usize]
    }
}

/// The scene under a record near its own, number 0 to [`N_RECORDS`]: all samples changed by the same part, or each by a random one.
///
/// # Errors
/// [`pounding_scene::Error::Scene`] where a changed sample is not finite.
pub(crate) fn under(prepared: &Simulation, change: f64, index: usize) -> Result<Simulation, pounding_scene::Error> {
    prepared.under(|record| match index {
        0 => record.scaled(1.0 + change),
        _ => Noise::new(change, 0, index - 1).on(record),
    })
}

/// What is compared of one run: its quantities, and time and impulse of every collision of every pair.
struct Results {
    quantities: Quantities,
    pairs: Vec<Vec<[f64; 2]>>,
}

impl Results {
    fn of(run: &Run<'_>) -> Result<Self, String> {
        let (outcome, _) = run.recorded()?;
        let mut pairs = vec![Vec::new(); run.prepared.pairs().len()];
        for Collision { pair, start, impulse, .. } in outcome.collisions.all() {
            pairs[*pair].push([*start, *impulse]);
        }
        Ok(Self {
            quantities: Quantities::of(&outcome, run.scene.structures.len()),
            pairs,
        })
    }

    fn of_second_route(response: &Response) -> Self {
        let of_pair = |met: &Vec<pounding_reference::Collision>| met.iter().map(|met| [met.start, met.impulse]).collect();
        Self {
            quantities: Quantities::of_second_route(response),
            pairs: response.collisions.iter().map(of_pair).collect(),
        }
    }
}
