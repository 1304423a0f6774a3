//! Runs of a sweep in lanes, if its method and outputs allow it.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::Sweep;
use super::output::Output;
use crate::side_by_side::{alone_because, side_by_side};
use pounding_lanes::SceneSums;
use pounding_scene::{Floor, FloorQuantity, LEAST_PART, PairQuantity, Quantity, Simulation, least_opening};

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
        let is_tallied = |output: &Output| match output.quantity {
            Quantity::Floor(quantity) => matches!(
                quantity,
                FloorQuantity::PeakDisplacementM | FloorQuantity::PeakDriftM | FloorQuantity::Ductility | FloorQuantity::DriftRatio
            ),
            Quantity::Pair(quantity) => matches!(
                quantity,
                PairQuantity::Collisions
                    | PairQuantity::LargestImpulseNS
                    | PairQuantity::PeakForceN
                    | PairQuantity::TotalImpulseNS
                    | PairQuantity::LeastOpeningM
            ),
        };
        self.outputs.iter().find(|output| !is_tallied(output))
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
            return Some(format!("`{}` among the `outputs` is not known side by side", output.word));
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
        (tallies, scene): (&SceneSums, usize),
        (numbers, least): (&mut Vec<f64>, &mut Vec<f64>),
    ) -> bool {
        if !tallies.is_told(scene) || (self.verdict && tallies.is_doubted(scene)) {
            return false;
        }
        for output in &self.outputs {
            let (number, counts_as) = match output.quantity {
                Quantity::Floor(asked) => output.severest(|place| {
                    let floor = &prepared.floors().all()[place];
                    let asked = output.asked_of(floor, asked);
                    (of_floor(floor, (tallies, scene, place), asked), 0.0)
                }),
                Quantity::Pair(asked) => output.severest(|pair| of_pair(prepared, (tallies, scene), pair, asked)),
            };
            numbers.push(number);
            if self.closings {
                least.push(counts_as);
            }
        }
        true
    }
}

/// A number of a floor of a scene; NaN if it has none.
fn of_floor(floor: &Floor, (tallies, scene, index): (&SceneSums, usize, usize), asked: FloorQuantity) -> f64 {
    let drift = || tallies.drift(scene, index);
    let none = f64::NAN;
    match asked {
        FloorQuantity::PeakDisplacementM if !floor.is_wall() => tallies.displacement(scene, index),
        FloorQuantity::PeakDriftM if floor.is_upper() => drift(),
        FloorQuantity::Ductility => floor.ductility(drift()).unwrap_or(none),
        FloorQuantity::DriftRatio => floor.drift_ratio(drift()).unwrap_or(none),
        FloorQuantity::PeakDisplacementM
        | FloorQuantity::PeakDisplacementTimeS
        | FloorQuantity::PeakShearForceN
        | FloorQuantity::PeakDriftM
        | FloorQuantity::ResidualDisplacementAtEndM
        | FloorQuantity::ResidualDriftAtEndM
        | FloorQuantity::PeakAccelerationMPerS2
        | FloorQuantity::TransferredMomentumNS => none,
    }
}

/// A number of a pair of a scene (NaN if it has none), and its least scale.
fn of_pair(prepared: &Simulation, (tallies, scene): (&SceneSums, usize), index: usize, asked: PairQuantity) -> (f64, f64) {
    let pair = &prepared.pairs()[index];
    let tally = tallies.pair(scene, index);
    let touches = tally.collisions > 0.0;
    let has_force = touches && pair.law.is_compliant();
    let none = f64::NAN;
    let number = match asked {
        PairQuantity::Collisions => tally.collisions,
        PairQuantity::TotalImpulseNS => tally.impulse,
        PairQuantity::LargestImpulseNS if touches => tally.largest_impulse,
        PairQuantity::PeakForceN if has_force => tally.peak_force,
        PairQuantity::LeastOpeningM => {
            let peak = |floor| tallies.displacement(scene, floor).abs();
            let counts_as = LEAST_PART * peak(pair.left()).max(peak(pair.right()));
            let opening = |closing| least_opening(pair.gap(), closing, touches);
            return (tally.closing.map_or(none, opening), counts_as);
        }
        PairQuantity::LargestImpulseNS
        | PairQuantity::PeakForceN
        | PairQuantity::FirstStartS
        | PairQuantity::FirstImpulseNS
        | PairQuantity::TouchingS => none,
    };
    (number, 0.0)
}
