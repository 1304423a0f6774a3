//! Peaks of a floor and the storey below it, without sign.

use pounding_scene::{RunResult, Simulation};

/// Peaks of one floor and the storey below it, without sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloorPeaks {
    /// Drift of the storey \[m\].
    pub drift: f64,
    /// Shear force of the storey \[N\].
    pub shear: f64,
    /// Absolute acceleration of the floor \[m/s²\]. Impulsive impacts, whose acceleration has no bound, are left out.
    pub acceleration: f64,
}

impl FloorPeaks {
    /// Takes each number from one of two floors, as `one` chooses.
    pub(crate) fn each(self, other: Self, one: fn(f64, f64) -> f64) -> Self {
        Self {
            drift: one(self.drift, other.drift),
            shear: one(self.shear, other.shear),
            acceleration: one(self.acceleration, other.acceleration),
        }
    }
    /// Peaks of every floor of a run, in the order of the row.
    pub(crate) fn all(simulation: &Simulation, result: &RunResult) -> Vec<Self> {
        let of_floor = |floor: usize| {
            let peaks = result.peaks.of(floor);
            Self {
                drift: peaks.drift().value.abs(),
                shear: peaks.column_force().value.abs(),
                acceleration: result.accelerations[floor].value.abs(),
            }
        };
        (0..simulation.floors().all().len()).map(of_floor).collect()
    }
}
