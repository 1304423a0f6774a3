//! What a run costs: evaluations of a restoring force in a step of the central difference method that take as long.
//!
//! Counts of work, which are the same on every machine, with weights that were measured: processor time of sweeps of nearly the
//! same scene, with and without a ledger, of 1, 3 and 10 storeys, two and five buildings, all columns, apart, with impacts and
//! with the viscoelastic element. Most of these times are within a third of the weight; five elastic structures with the viscoelastic
//! element and no ledger took twice as long.

use pounding_solver::Work;

use crate::accuracy::methods::is_compliant;
use crate::simulation::Simulation;
use crate::{EVALUATIONS_PER_PIECE, Method, Structure};

/// Where scenes go side by side by a stepping method, how many of them cost as much as one alone: 29 to 60 (docs/performance.md).
const BESIDE: f64 = 40.0;

/// The price of a piece of motion of the exact method, by the kind of row.
///
/// Without contact forces and without storeys a piece is a closed form, else a series: of the floors of a building (measured: 14
/// to 21), of contact forces (pieces in contact take some 40; of all of a run 14 to 38, with storeys 17 to 27), or of the power of
/// a Bouc–Wen column (22 to 36, with storeys 32 to 42).
fn of_piece(prepared: &Simulation) -> u64 {
    let scene = prepared.scene();
    let storeys = scene.structures.iter().any(is_storeyed);
    match (storeys, prepared.yields_smoothly(), is_compliant(scene)) {
        (false, false, false) => EVALUATIONS_PER_PIECE,
        (false, false, true) => 20,
        (true, false, false) => 16,
        (true, false, true) => 24,
        (false, true, _) => 28,
        (true, true, _) => 36,
    }
}

fn is_storeyed(structure: &Structure) -> bool {
    matches!(structure, Structure::Building(building) if building.storeys.len() > 1)
}

/// The price of an evaluation of a restoring force in a step of a method.
fn of_evaluation(method: &Method) -> f64 {
    match method {
        // It keeps velocities at nodes, and looks where gaps close.
        Method::VelocityVerlet { .. } => 1.2,
        // Its four evaluations share the books of a step.
        Method::Rk4 { .. } => 0.7,
        Method::CentralDifference { .. }
        | Method::Newmark { .. }
        | Method::Hht { .. }
        | Method::MoreauJean { .. }
        | Method::Exact { .. }
        | Method::Accuracy(_) => 1.0,
    }
}

impl Simulation {
    /// What a piece of motion of the exact method costs in this scene, in force evaluations of equal time.
    pub fn evaluations_per_piece(&self) -> u64 {
        of_piece(self)
    }

    /// What a run of the scene by its method has cost.
    pub fn price(&self, work: Work) -> f64 {
        let evaluations = of_evaluation(&self.method()) * work.force_evaluations as f64;
        evaluations + (of_piece(self) * work.segments) as f64
    }

    /// What a run of the scene by its method will cost alone, roughly: by the exact method a piece of every floor from sample to
    /// sample.
    pub fn expected_price(&self) -> f64 {
        if self.method().time_step().is_some() {
            return self.price_of_steps(&self.method(), false);
        }
        let samples = self.duration() / self.record().time_step();
        of_piece(self) as f64 * samples * self.floors().all().len() as f64
    }

    /// What a run will cost by an explicit method with this time step \[s\], alone or side by side with others.
    pub fn price_of_steps(&self, method: &Method, beside: bool) -> f64 {
        let steps = method
            .time_step()
            .map_or(0.0, |step| self.duration() / step);
        let alone = of_evaluation(method) * steps * self.floors().all().len() as f64;
        if beside { alone / BESIDE } else { alone }
    }
}
