//! A run with its simulation, from which the table takes its values.

use std::sync::OnceLock;

use pounding_solver::{Peak, StructurePeaks, Widening};

use super::{FloorQuantity, Quantity, QuantityKind};
use crate::{Floor, MassDamping, PairOutcome, RunResult, Simulation};

/// A run with its simulation: gives every [`Quantity`].
#[derive(Debug, Clone)]
pub struct RunValues<'a> {
    pub(crate) simulation: &'a Simulation,
    pub(crate) result: &'a RunResult,
    pairs: Vec<PairOutcome>,
    /// Peak forces of dampers \[N\], found when one is asked for.
    dampers: OnceLock<Vec<f64>>,
}

impl RunResult {
    /// Gives every printed number of this run of a simulation.
    pub fn values<'a>(&'a self, simulation: &'a Simulation) -> RunValues<'a> {
        let pairs = 0..simulation.pairs().len();
        RunValues {
            simulation,
            result: self,
            pairs: pairs.map(|pair| self.of_pair(pair)).collect(),
            dampers: OnceLock::new(),
        }
    }
}

impl RunValues<'_> {
    /// Least magnitude of a residual or a least opening in a relative error, as a part of the peak \[–\]: the number itself may be close to
    /// 0.
    pub const LEAST_PART: f64 = 0.05;

    /// Least magnitude of a transferred momentum in a relative error, as a part of the row's largest \[–\]: forces from both sides may
    /// cancel up to rounding.
    pub const ZERO: f64 = 1e-9;

    /// A first touch before this instant is at the start \[s\]; its error is relative to 1 s.
    pub const AT_ONCE: f64 = 1e-9;

    /// Returns a number of a floor or a pair by its index in the row, SI. `None` if it does not exist: a wall does not move, and a pair
    /// that never touches has no first impulse.
    ///
    /// # Panics
    /// If the row has no such floor or pair.
    pub fn of(&self, quantity: impl Into<Quantity>, place: usize) -> Option<f64> {
        (quantity.into().about().of)(self, place)
    }

    /// Least magnitude that a relative error of a number is divided by; 0 for most numbers.
    ///
    /// # Panics
    /// If the row has no such floor or pair.
    pub fn least(&self, quantity: impl Into<Quantity>, place: usize) -> f64 {
        let about = quantity.into().about();
        if let QuantityKind::Residual(peak) = about.kind {
            self.part_of(peak, place)
        } else {
            (about.least)(self, place)
        }
    }

    /// Least magnitude of a number that may be close to 0, from its peak.
    pub(crate) fn part_of(&self, peak: impl Into<Quantity>, floor: usize) -> f64 {
        Self::LEAST_PART * self.of(peak, floor).unwrap_or(0.0).abs()
    }

    /// Least magnitude of a transferred momentum \[N·s\].
    pub(crate) fn least_momentum(&self) -> f64 {
        let floors = 0..self.simulation.floors().all().len();
        let momenta = floors.map(|floor| self.result.momentum.of(floor));
        Self::ZERO * momenta.fold(0.0, f64::max)
    }

    /// Returns a floor by its index.
    pub(crate) fn floor(&self, floor: usize) -> &Floor {
        &self.simulation.floors().all()[floor]
    }

    /// Whether a floor is not a wall.
    pub(crate) fn moves(&self, floor: usize) -> bool {
        !self.floor(floor).is_wall()
    }

    /// The floor below.
    pub(crate) fn below(&self, floor: usize) -> Option<usize> {
        self.simulation.floors().below(floor)
    }

    /// Natural period \[s\] and damping ratio; `None` for a wall.
    pub(crate) fn oscillation(&self, floor: usize) -> Option<(f64, f64)> {
        self.floor(floor).oscillation(self.simulation.scene())
    }

    /// Peaks of a floor; `None` for a wall.
    pub(crate) fn peaks(&self, floor: usize) -> Option<&StructurePeaks> {
        self.moves(floor).then(|| self.result.peaks.of(floor))
    }

    /// Peak absolute acceleration of a floor \[m/s²\]; `None` for a wall.
    pub(crate) fn acceleration(&self, floor: usize) -> Option<Peak> {
        self.moves(floor).then(|| self.result.accelerations[floor])
    }

    /// Displacement of a floor at the end \[m\].
    pub(crate) fn last(&self, floor: usize) -> f64 {
        // The sum removes the sign of a negative zero.
        self.result.last.of(floor).displacement + 0.0
    }

    /// Peak force of the damper of a storey \[N\]; `None` if it was not recorded.
    pub(crate) fn damper_force(&self, floor: usize) -> Option<f64> {
        let forces = self.dampers.get_or_init(|| self.simulation.damper_forces(self.result));
        forces.get(floor).copied()
    }

    /// The mass term of the damping of a building; `None` for all but its lowest storey.
    pub(crate) fn mass_damping(&self, floor: usize) -> Option<MassDamping> {
        let lowest = self.below(floor).is_none();
        let of = || self.simulation.mass_damping(self.result, self.floor(floor).structure);
        lowest.then(of).flatten()
    }

    /// Largest shear force \[N\] and bending moment \[N·m\] that the peak force of a pair puts into the column that is hit; `None` between floors,
    /// and for impacts without a force.
    pub(crate) fn column_forces(&self, pair: usize) -> Option<[f64; 2]> {
        let floors = self.simulation.floors();
        let forces = floors.column_of(&floors.facing()[pair])?.forces()?;
        let peak = self.pair(pair).peak_force?.value;
        Some(forces.map(|of_one| of_one * peak))
    }

    /// Collisions of a pair.
    pub(crate) fn pair(&self, pair: usize) -> &PairOutcome {
        &self.pairs[pair]
    }

    /// Least opening of the gap of a pair \[m\] and its instant \[s\]; `None` if closings were not asked for.
    pub(crate) fn opening(&self, pair: usize) -> Option<(f64, f64)> {
        self.result.least_opening(self.simulation, pair, &self.pairs[pair])
    }

    /// How far the sides of a pair moved away from each other; `None` if openings were not asked for.
    pub(crate) fn widening(&self, pair: usize) -> Option<Widening> {
        self.result.widening(self.simulation, pair)
    }

    /// Least magnitude of an opening in a relative error \[m\]: a part of the larger peak displacement of both floors.
    pub(crate) fn least_of_openings(&self, pair: usize) -> f64 {
        let pair = &self.simulation.pairs()[pair];
        let [left, right] = [pair.left(), pair.right()].map(|floor| self.part_of(FloorQuantity::PeakDisplacementM, floor));
        left.max(right)
    }
}
