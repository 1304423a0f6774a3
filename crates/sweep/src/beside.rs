//! Runs of a sweep in lanes, if its method and outputs allow it.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::Sweep;
use super::output::Output;
use crate::side_by_side::{alone_because, side_by_side};
use pounding_lanes::{PairSums, SceneSums};
use pounding_scene::{Floor, FloorQuantity, PairOutcome, PairQuantity, Quantity, RunValues, Simulation};
use pounding_solver::Pair;

impl Sweep {
    /// Results of prepared scenes, if they could run in lanes.
    pub(super) fn beside(&self, ready: &[(u64, Box<Simulation>)]) -> Option<SceneSums> {
        if !self.asks_for_tallies() {
            return None;
        }
        let scenes: Vec<_> = ready.iter().map(|(_, prepared)| &**prepared).collect();
        catch_unwind(AssertUnwindSafe(|| side_by_side(&scenes, self.closings)))
            .ok()
            .flatten()
    }

    /// Whether lanes know all requested numbers: only peaks and sums.
    pub(super) fn asks_for_tallies(&self) -> bool {
        self.untallied().is_none() && self.limit().is_none()
    }

    /// The first number that only a run alone has.
    fn untallied(&self) -> Option<&Output> {
        self.outputs.iter().find(|output| tallied(output.quantity).is_none())
    }

    /// The limit of cost above which runs are given up, if only a run alone has it.
    fn limit(&self) -> Option<&'static str> {
        let budget = self.scene.get("budget");
        let is_named = |name: &&str| {
            let cost = budget.and_then(|budget| budget.get(name));
            cost.is_some_and(|cost| !cost.is_null())
        };
        ["pieces", "seconds"].into_iter().find(is_named)
    }

    /// Why all runs must run alone, which takes many times as long; `None` if they can run in lanes.
    pub fn alone_because(&self) -> Option<String> {
        if let Some(output) = self.untallied() {
            return Some(format!(
                "`{}` among the `outputs` is not known side by side",
                output.quantity.about().name
            ));
        }
        if let Some(limit) = self.limit() {
            return Some(format!("`{limit}` of the `budget` is that of a run alone"));
        }
        let typical = self.plan.typical();
        let typical = self.prepared(self.motions.longest(), &typical, &mut self.scene.clone());
        alone_because(&typical.ok()?).map(String::from)
    }

    /// Fills the numbers of a scene in the order of the columns, and their least scales, which stay empty if no number has one. Returns
    /// false if there are none: a run alone then shows why.
    pub(super) fn tell(
        &self,
        prepared: &Simulation,
        tallies: &SceneSums,
        scene: usize,
        numbers: &mut Vec<f64>,
        least: &mut Vec<f64>,
    ) -> bool {
        if !tallies.is_told(scene) || (self.verdict && tallies.is_doubted(scene)) {
            return false;
        }
        for output in &self.outputs {
            let (number, counts_as) = output.severest(|place| {
                let quantity = output.asked_of(prepared.floors(), place);
                let one = One {
                    prepared,
                    tallies,
                    scene,
                    place,
                };
                let number = tallied(quantity).and_then(|take| take(&one));
                (number.unwrap_or(f64::NAN), one.least(quantity))
            });
            numbers.push(number);
            if self.closings {
                least.push(counts_as);
            }
        }
        true
    }
}

/// A floor or a pair of one of these scenes.
struct One<'a> {
    prepared: &'a Simulation,
    tallies: &'a SceneSums,
    scene: usize,
    place: usize,
}

/// How to take a number from the sums of lanes; `None` if the place has no such number.
type Take = fn(&One<'_>) -> Option<f64>;

/// The numbers that runs side by side know. Any other is that of a run alone.
const TALLIED: &[(Quantity, Take)] = &[
    (Quantity::Floor(FloorQuantity::PeakDisplacementM), |one| {
        let displacement = one.tallies.displacement(one.scene, one.place);
        (!one.floor().is_wall()).then_some(displacement)
    }),
    (Quantity::Floor(FloorQuantity::PeakDriftM), |one| {
        one.floor().is_upper().then_some(one.drift())
    }),
    (Quantity::Floor(FloorQuantity::Ductility), |one| one.floor().ductility(one.drift())),
    (Quantity::Floor(FloorQuantity::DriftRatio), |one| {
        one.floor().drift_ratio(one.drift())
    }),
    (Quantity::Pair(PairQuantity::Collisions), |one| Some(one.sums().collisions)),
    (Quantity::Pair(PairQuantity::LargestImpulseNS), |one| {
        one.touches().then_some(one.sums().largest_impulse)
    }),
    (Quantity::Pair(PairQuantity::PeakForceN), |one| {
        let has_force = one.touches() && one.pair().law.is_compliant();
        has_force.then_some(one.sums().peak_force)
    }),
    (Quantity::Pair(PairQuantity::TotalImpulseNS), |one| Some(one.sums().impulse)),
    (Quantity::Pair(PairQuantity::LeastOpeningM), |one| {
        Some(PairOutcome::opening_after(one.pair().gap(), one.sums().closing?, one.touches()))
    }),
];

/// How runs side by side tell a number, if they do.
fn tallied(quantity: Quantity) -> Option<Take> {
    let found = TALLIED.iter().find(|(known, _)| *known == quantity);
    found.map(|(_, take)| *take)
}

impl One<'_> {
    fn floor(&self) -> &Floor {
        &self.prepared.floors().all()[self.place]
    }

    fn drift(&self) -> f64 {
        self.tallies.drift(self.scene, self.place)
    }

    fn pair(&self) -> &Pair {
        &self.prepared.pairs()[self.place]
    }

    fn sums(&self) -> PairSums {
        self.tallies.pair(self.scene, self.place)
    }

    fn touches(&self) -> bool {
        self.sums().collisions > 0.0
    }

    /// What a number counts as at least.
    fn least(&self, quantity: Quantity) -> f64 {
        if quantity != PairQuantity::LeastOpeningM.into() {
            return 0.0;
        }
        let peak = |floor| self.tallies.displacement(self.scene, floor).abs();
        RunValues::LEAST_PART * peak(self.pair().left()).max(peak(self.pair().right()))
    }
}
