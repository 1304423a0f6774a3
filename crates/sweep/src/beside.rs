//! Runs of a sweep side by side, where its method and outputs let them.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::Sweep;
use pounding_scene::{
    FloorQuantity, LEAST_PART, PairQuantity, Quantity, Simulation, least_opening, side_by_side,
};
use pounding_solver::SceneSums;

impl Sweep {
    /// What happened in scenes that are ready, where they could run side by side.
    pub(super) fn beside(&self, ready: &[(u64, Box<Simulation>)]) -> Option<SceneSums> {
        if !self.asks_for_tallies() {
            return None;
        }
        let scenes: Vec<_> = ready.iter().map(|(_, prepared)| &**prepared).collect();
        catch_unwind(AssertUnwindSafe(|| side_by_side(&scenes, self.closings)))
            .ok()
            .flatten()
    }

    /// Whether runs side by side know all that is asked for: no more than peaks and sums.
    pub(super) fn asks_for_tallies(&self) -> bool {
        let structures = &self.outputs.structures;
        let of_structures = structures.iter().all(|one| {
            matches!(
                one,
                FloorQuantity::PeakDisplacementM
                    | FloorQuantity::PeakDriftM
                    | FloorQuantity::Ductility
                    | FloorQuantity::DriftRatio
            )
        });
        let of_pairs = self.outputs.pairs.iter().all(|one| {
            matches!(
                one,
                PairQuantity::Collisions
                    | PairQuantity::LargestImpulseNS
                    | PairQuantity::PeakForceN
                    | PairQuantity::TotalImpulseNS
                    | PairQuantity::LeastOpeningM
            )
        });
        of_structures && of_pairs && !self.is_limited()
    }

    /// Whether runs are given up above a cost that is named: pieces and seconds are those of a run alone.
    fn is_limited(&self) -> bool {
        let budget = self.scene.get("budget");
        let named = |name: &str| budget?.get(name).filter(|cost| !cost.is_null());
        ["pieces", "seconds"]
            .into_iter()
            .any(|name| named(name).is_some())
    }

    /// What each of the columns holds.
    pub(super) fn quantities(&self) -> Vec<Quantity> {
        let of_floor = self.outputs.structures.iter().copied().map(Quantity::from);
        let of_pair = self.outputs.pairs.iter().copied().map(Quantity::from);
        let floors = self.row.floors.iter().flat_map(|_| of_floor.clone());
        let pairs = self.row.pairs.iter().flat_map(|_| of_pair.clone());
        floors.chain(pairs).collect()
    }

    /// The numbers of one of these scenes in the order of the columns, and what they count as at least, which stays empty where none of them
    /// does; false where they are none, and a run alone says why.
    pub(super) fn tell(
        &self,
        prepared: &Simulation,
        (tallies, scene): (&SceneSums, usize),
        (numbers, least): (&mut Vec<f64>, &mut Vec<f64>),
    ) -> bool {
        let none = f64::NAN;
        if !tallies.is_told(scene) || (self.verdict && tallies.is_doubted(scene)) {
            return false;
        }
        for (index, floor) in prepared.floors().all().iter().enumerate() {
            let (displacement, drift) = (
                tallies.displacement(scene, index),
                tallies.drift(scene, index),
            );
            numbers.extend(self.outputs.structures.iter().map(|asked| match asked {
                FloorQuantity::PeakDisplacementM if !floor.is_wall() => displacement,
                FloorQuantity::PeakDriftM if floor.is_upper() => drift,
                FloorQuantity::Ductility => floor.ductility(drift).unwrap_or(none),
                FloorQuantity::DriftRatio => floor.drift_ratio(drift).unwrap_or(none),
                FloorQuantity::PeakDisplacementM
                | FloorQuantity::PeakDisplacementTimeS
                | FloorQuantity::PeakShearForceN
                | FloorQuantity::PeakDriftM
                | FloorQuantity::ResidualDisplacementAtEndM
                | FloorQuantity::ResidualDriftAtEndM
                | FloorQuantity::PeakAccelerationMPerS2
                | FloorQuantity::TransferredMomentumNS => none,
            }));
        }
        if self.closings {
            least.resize(numbers.len(), 0.0);
        }
        for (index, pair) in prepared.pairs().iter().enumerate() {
            if self.closings {
                let peak = |floor| tallies.displacement(scene, floor).abs();
                let part = LEAST_PART * peak(pair.left).max(peak(pair.right));
                least.extend(self.outputs.pairs.iter().map(|asked| {
                    let is_opening = matches!(asked, PairQuantity::LeastOpeningM);
                    if is_opening { part } else { 0.0 }
                }));
            }
            let tally = tallies.pair(scene, index);
            let touches = tally.collisions > 0.0;
            let has_force = touches && pair.law.is_compliant();
            let opening = |closing| least_opening(pair.gap, closing, touches);
            numbers.extend(self.outputs.pairs.iter().map(|asked| match asked {
                PairQuantity::Collisions => tally.collisions,
                PairQuantity::TotalImpulseNS => tally.impulse,
                PairQuantity::LargestImpulseNS if touches => tally.largest_impulse,
                PairQuantity::PeakForceN if has_force => tally.peak_force,
                PairQuantity::LeastOpeningM => tally.closing.map_or(none, opening),
                PairQuantity::LargestImpulseNS
                | PairQuantity::PeakForceN
                | PairQuantity::FirstStartS
                | PairQuantity::FirstImpulseNS
                | PairQuantity::TouchingS => none,
            }));
        }
        true
    }
}
