//! Condition: the sensitivity of a scene's results to its record, and whether the two routes are as close as it allows.

use super::quantities::{MethodQuantity, MethodRun, Quantities};
use crate::noise::Noise;
use pounding_reference::Response;
use pounding_scene::{RunErrors, Simulation, parallel};
use pounding_solver::Collision;

/// Relative change of the records, small enough for proportional changes of the results \[–\].
const CHANGE: f64 = 1e-9;
/// Number of records with independent changes of every sample.
const N_RECORDS: usize = 16;
/// Relative error by rounding of a result whose condition number is 1 \[–\].
const ROUNDING: f64 = 1e-15;

/// A result by two routes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Known {
    /// Condition number: the largest relative change of the result per relative change of the record.
    ///
    /// It is infinite if some of the changed records lose a collision.
    pub(crate) condition: f64,
    /// Relative distance of the two routes; infinite if only one of them has a collision.
    pub(crate) distance: f64,
}

impl Known {
    /// The allowed distance \[–\]: the tolerance of the contact element, or rounding of the record if that is larger.
    pub(super) fn allowed(self, compliant: bool) -> f64 {
        self.allowed_from(if compliant { 1e-9 } else { 1e-12 })
    }

    /// The allowed distance by rounding of the record \[–\], at least `floor`.
    pub(crate) fn allowed_from(self, floor: f64) -> f64 {
        (self.condition * ROUNDING).max(floor)
    }

    /// Whether the two routes are as close as allowed.
    pub(super) fn holds(self, compliant: bool) -> bool {
        self.distance <= self.allowed(compliant)
    }
}

/// One collision of a scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct KnownCollision {
    /// First instant \[s\] and impulse \[N·s\].
    pub(super) values: [f64; 2],
    pub(super) known: [Known; 2],
}

/// Reliability of the results of one scene.
#[derive(Debug)]
pub(super) struct Knowledge {
    /// For each quantity that of the worst structure; `None` if nothing collides.
    quantities: [Option<Known>; MethodQuantity::ALL.len()],
    /// The collisions of every pair in their order.
    pub(super) pairs: Vec<Vec<KnownCollision>>,
    /// Whether both routes have the same number of collisions.
    pub(super) same_count: bool,
}

impl Knowledge {
    /// Runs the reference under its record and under similar records, and compares it with the second route.
    ///
    /// # Errors
    /// The reason if a run of the reference fails.
    pub(super) fn measure(run: &MethodRun<'_>, second: Option<&Response>) -> Result<Self, String> {
        let truth = Results::of(run)?;
        let records: Vec<_> = (0..=N_RECORDS).collect();
        let near = parallel::try_each(&records, |&index| {
            let prepared = under(run.prepared, CHANGE, index).map_err(|error| error.to_string())?;
            let run = MethodRun {
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
            KnownCollision {
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

    /// Reliability of a quantity; `None` if nothing collides.
    pub(super) fn of(&self, quantity: MethodQuantity) -> Option<Known> {
        self.quantities[quantity as usize]
    }
}

/// The scene under similar record number `index`, 0 to [`N_RECORDS`]. Number 0 changes all samples by one factor, the others each sample by
/// a random factor.
///
/// # Errors
/// [`pounding_scene::Error::Scene`] if a changed sample is not finite.
pub(crate) fn under(prepared: &Simulation, change: f64, index: usize) -> Result<Simulation, pounding_scene::Error> {
    prepared.under(|record| match index {
        0 => record.scaled(1.0 + change),
        _ => Noise::new(change, 0, index - 1).on(record),
    })
}

/// Results of one run to compare: its quantities, and time and impulse of every collision of every pair.
struct Results {
    quantities: Quantities,
    pairs: Vec<Vec<[f64; 2]>>,
}

impl Results {
    fn of(run: &MethodRun<'_>) -> Result<Self, String> {
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
