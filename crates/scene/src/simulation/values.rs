//! Every number that is printed of a run, by quantity and place.

use super::{PairOutcome, RunResult, Simulation};
use crate::{FloorQuantity, PairQuantity, Quantity};

/// A run beside the simulation that it is of: every number that is printed of it.
#[derive(Debug, Clone)]
pub struct Values<'a> {
    pub(crate) simulation: &'a Simulation,
    pub(crate) result: &'a RunResult,
    pairs: Vec<PairOutcome>,
}

impl RunResult {
    /// Every number that is printed of this run of a simulation.
    pub fn values<'a>(&'a self, simulation: &'a Simulation) -> Values<'a> {
        let pairs = 0..simulation.pairs().len();
        Values {
            simulation,
            result: self,
            pairs: pairs.map(|pair| self.of_pair(pair)).collect(),
        }
    }
}

impl Values<'_> {
    /// A number of a floor or a pair, by its place in the row, SI. `None` if it has no such number: a wall does not move, a pair that
    /// never touches has no first impulse.
    ///
    /// # Panics
    /// If the row has no such floor or pair.
    pub fn of(&self, quantity: impl Into<Quantity>, place: usize) -> Option<f64> {
        match quantity.into() {
            Quantity::Floor(quantity) => self.of_floor(quantity, place),
            Quantity::Pair(quantity) => self.of_pair(quantity, place),
        }
    }

    fn of_floor(&self, quantity: FloorQuantity, index: usize) -> Option<f64> {
        let floor = &self.simulation.floors().all()[index];
        if quantity == FloorQuantity::TransferredMomentumNS {
            return Some(self.result.momentum.of(index));
        }
        if floor.is_wall() {
            return None;
        }
        let peaks = self.result.peaks.of(index);
        // A negative zero loses its sign.
        let last = |index| self.result.last.of(index).displacement + 0.0;
        match quantity {
            FloorQuantity::PeakDisplacementM => Some(peaks.displacement.value),
            FloorQuantity::PeakDisplacementTimeS => Some(peaks.displacement.time),
            FloorQuantity::PeakShearForceN => Some(peaks.restoring_force.value),
            FloorQuantity::PeakDriftM => floor.is_upper().then_some(peaks.drift().value),
            FloorQuantity::ResidualDisplacementAtEndM => Some(last(index)),
            FloorQuantity::ResidualDriftAtEndM => {
                let below = self.simulation.floors().below(index)?;
                Some(last(index) - last(below))
            }
            FloorQuantity::PeakAccelerationMPerS2 => Some(self.result.accelerations[index].value),
            FloorQuantity::Ductility => floor.ductility(peaks.drift().value),
            FloorQuantity::DriftRatio => floor.drift_ratio(peaks.drift().value),
            FloorQuantity::TransferredMomentumNS => Some(self.result.momentum.of(index)),
        }
    }

    fn of_pair(&self, quantity: PairQuantity, index: usize) -> Option<f64> {
        let found = &self.pairs[index];
        match quantity {
            PairQuantity::Collisions => Some(found.collisions as f64),
            PairQuantity::FirstStartS => found.first.map(|first| first.start),
            PairQuantity::FirstImpulseNS => found.first.map(|first| first.impulse),
            PairQuantity::LargestImpulseNS => found.largest.map(|largest| largest.impulse),
            PairQuantity::PeakForceN => found.peak_force.map(|peak| peak.value),
            PairQuantity::TotalImpulseNS => Some(found.total_impulse),
            PairQuantity::TouchingS => Some(found.touching),
            PairQuantity::LeastOpeningM => {
                let pair = &self.simulation.pairs()[index];
                Some(self.result.least_opening(pair, found)?.0)
            }
        }
    }
}
