//! Compared quantities, six of them and a count, and the runs that give them.

use crate::listed::listed;
use pounding_reference::Response;
use pounding_scene::{ComparedMethod, Method, RunErrors, RunResult, RunValues, Scene, Simulation};
use pounding_solver::{Ledger, Work};

listed! {
    /// A quantity in which methods are compared. The texts are its name in tables, and name in figures and unit for an impulsive and a
    /// compliant contact.
    pub(crate) enum MethodQuantity { texts: (&'static str, [&'static str; 2], [&'static str; 2]);
        FirstTime = ("time_of_first_collision", ["Time of first collision"; 2], ["s"; 2]),
        FirstImpulse = ("impulse_of_first_collision", ["Impulse of first collision"; 2], ["N·s"; 2]),
        Momentum = ("transferred_momentum", ["Transferred momentum"; 2], ["N·s"; 2]),
        ContactPeak = ("peak_pounding_force_or_impulse", ["Peak impulse", "Peak pounding force"], ["N·s", "N"]),
        Displacement = ("peak_displacement", ["Peak displacement"; 2], ["m"; 2]),
        Shear = ("peak_shear_force", ["Peak shear force"; 2], ["N"; 2]),
    }
}

impl MethodQuantity {
    /// Name in tables.
    pub(crate) fn key(self) -> &'static str {
        self.texts().0
    }

    /// Name in figures; a compliant contact has a peak force, an impulsive one a peak impulse.
    pub(crate) fn words(self, compliant: bool) -> &'static str {
        self.texts().1[usize::from(compliant)]
    }

    /// SI unit.
    pub(crate) fn unit(self, compliant: bool) -> &'static str {
        self.texts().2[usize::from(compliant)]
    }
}

/// The quantities of a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Quantities {
    /// For each quantity one value, or one per structure; empty if nothing collides.
    values: [Vec<f64>; MethodQuantity::ALL.len()],
    /// Number of collisions of all pairs; impacts for an impulsive law.
    pub(crate) n_collisions: usize,
}

impl Quantities {
    /// The quantities of a run of `n_structures` structures.
    pub(crate) fn of(outcome: &RunResult, n_structures: usize) -> Self {
        let met = outcome.collisions.all().iter().map(|one| (one.start, one.impulse, one.peak_force));
        let moved = (0..n_structures).map(|index| {
            let peaks = outcome.peaks.of(index);
            [outcome.momentum.of(index), peaks.displacement.value, peaks.restoring_force.value]
        });
        Self::new(&met.collect::<Vec<_>>(), moved)
    }

    /// The quantities of the second route.
    pub(crate) fn of_second_route(response: &Response) -> Self {
        let met = response
            .collisions
            .iter()
            .flatten()
            .map(|one| (one.start, one.impulse, one.peak_force));
        let moved = response.structures.iter();
        let moved = moved.map(|one| [one.transferred_momentum, one.displacement.value, one.restoring_force.value]);
        Self::new(&met.collect::<Vec<_>>(), moved)
    }

    /// The quantities from start, impulse and peak force of every collision, and from momentum, peak displacement and peak shear force of
    /// every structure.
    fn new(met: &[(f64, f64, Option<f64>)], moved: impl Iterator<Item = [f64; 3]>) -> Self {
        let first = met.iter().min_by(|one, other| one.0.total_cmp(&other.0));
        let peak = met.iter().map(|(_, impulse, force)| force.unwrap_or(*impulse)).reduce(f64::max);
        let moved: Vec<_> = moved.collect();
        let one = |value: Option<f64>| value.into_iter().collect();
        let all = |which: usize| moved.iter().map(|of| of[which].abs()).collect();
        let values = MethodQuantity::ALL.map(|quantity| match quantity {
            MethodQuantity::FirstTime => one(first.map(|first| first.0)),
            MethodQuantity::FirstImpulse => one(first.map(|first| first.1)),
            MethodQuantity::ContactPeak => one(peak),
            MethodQuantity::Momentum if met.is_empty() => Vec::new(),
            MethodQuantity::Momentum => moved.iter().map(|of| of[0]).collect(),
            MethodQuantity::Displacement => all(1),
            MethodQuantity::Shear => all(2),
        });
        Self {
            values,
            n_collisions: met.len(),
        }
    }

    /// Values of a quantity: one, or one for each structure from the left; empty if nothing collides.
    pub(crate) fn values(&self, quantity: MethodQuantity) -> &[f64] {
        &self.values[quantity as usize]
    }

    /// Largest relative distance from other quantities over the structures \[–\].
    ///
    /// The distance of a first collision at t = 0 is relative to 1 s. It is infinite if a collision or a hit structure is missing in one of
    /// the two, and `None` if both have no collision.
    pub(crate) fn distance(&self, truth: &Self, quantity: MethodQuantity) -> Option<f64> {
        let (found, wanted) = (self.values(quantity), truth.values(quantity));
        if found.len() != wanted.len() {
            return Some(f64::INFINITY);
        }
        let largest = wanted.iter().copied().fold(0.0, f64::max);
        let scale = |wanted: f64| match quantity {
            MethodQuantity::FirstTime if wanted < RunValues::AT_ONCE => 1.0,
            MethodQuantity::Momentum => wanted.max(RunValues::ZERO * largest),
            MethodQuantity::FirstTime
            | MethodQuantity::FirstImpulse
            | MethodQuantity::ContactPeak
            | MethodQuantity::Displacement
            | MethodQuantity::Shear => wanted.abs(),
        };
        let pairs = found.iter().zip(wanted);
        let distances = pairs.map(|(found, wanted)| RunErrors::relative_to(*found, *wanted, scale(*wanted)));
        distances.reduce(f64::max)
    }
}

/// Results of a run, or the reason why it failed.
pub(super) type Ended<'a> = Result<(Quantities, Ledger<'a>, Work), String>;

/// A run of one method on one scene before it starts.
#[derive(Debug)]
pub(super) struct MethodRun<'a> {
    pub(super) scene: &'a Scene,
    pub(super) prepared: &'a Simulation,
    pub(super) contender: &'static ComparedMethod,
    pub(super) setting: f64,
}

impl<'a> MethodRun<'a> {
    pub(super) fn outcome(&self) -> Ended<'a> {
        let (outcome, ledger) = self.recorded()?;
        let quantities = Quantities::of(&outcome, self.scene.structures.len());
        Ok((quantities, ledger, outcome.work))
    }

    /// Runs and returns the result with its ledger. Fails with a reason if the run ends early.
    ///
    /// The verdict of the ledger is a column of the table.
    pub(super) fn recorded(&self) -> Result<(RunResult, Ledger<'a>), String> {
        let recorded = self.prepared.recorded_by(self.method());
        recorded.map_err(|error| error.to_string())
    }

    pub(super) fn method(&self) -> Method {
        (self.contender.method)(self.setting)
    }
}
