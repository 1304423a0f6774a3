//! What a run costs: evaluations of a restoring force in a step of the central difference method that take as long.
//!
//! Counts of work, which are the same on every machine, with weights that were measured: processor time of sweeps of nearly the
//! same scene, with and without a ledger, of two to ten structures and of buildings of six and three storeys, elastic and hardening,
//! with impacts and with compliant laws. Times of runs are within a fifth of what they count for; long contacts of compliant laws take more.

use pounding_solver::Work;

use crate::accuracy::methods::is_compliant;
use crate::simulation::Simulation;
use crate::{EVALUATIONS_PER_PIECE, Method, Structure};

/// Where scenes go side by side by a stepping method, how many of them cost as much as one alone: 27 to 48, and 22 of buildings
/// (docs/performance.md).
const BESIDE: [f64; 2] = [40.0, 20.0];
/// What a ledger adds to an evaluation in a step: 0.5 to 0.8, and 0.3 in buildings.
const LEDGER_OF_STEP: f64 = 0.6;

/// How many times as much a piece of motion of the exact method costs with a ledger: 1.6 to 1.8.
pub const LEDGER_OF_PIECE: f64 = 1.7;

/// How a run goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Going {
    /// Alone, held to no law.
    Alone,
    /// Alone, with a ledger.
    Judged,
    /// Side by side with others.
    Beside,
}

/// The price of a piece of motion of the exact method, by the kind of row.
///
/// Without contact forces and without storeys a piece is a closed form (measured: 8 to 9), else a series: of the floors of a building
/// (20), of contact forces (pieces in contact take some 40; of all of a run 11 to 12, with storeys 21), or of the power of a Bouc–Wen
/// column (22 to 36, with storeys 32 to 42).
fn of_piece(prepared: &Simulation) -> u64 {
    let scene = prepared.scene();
    let storeys = scene.structures.iter().any(is_storeyed);
    match (storeys, prepared.yields_smoothly(), is_compliant(scene)) {
        (false, false, false) => EVALUATIONS_PER_PIECE,
        (false, false, true) => 12,
        (true, false, false) => 20,
        (true, false, true) => 22,
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
        Method::VelocityVerlet { .. } => 1.5,
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
    pub fn price(&self, work: Work, going: Going) -> f64 {
        let ledger = match going {
            Going::Judged => LEDGER_OF_PIECE,
            Going::Alone | Going::Beside => 1.0,
        };
        let of_piece = ledger * of_piece(self) as f64;
        let of_step = self.of_step(&self.method(), going);
        of_step * work.force_evaluations as f64 + of_piece * work.segments as f64
    }

    /// The price of a floor in a step of a method.
    fn of_step(&self, method: &Method, going: Going) -> f64 {
        let alone = of_evaluation(method);
        match going {
            Going::Alone => alone,
            Going::Judged => alone + LEDGER_OF_STEP,
            Going::Beside => {
                let storeys = self.scene().structures.iter().any(is_storeyed);
                alone / BESIDE[usize::from(storeys)]
            }
        }
    }

    /// What a run of the scene by its method will cost alone, roughly: by the exact method a piece of every floor from sample to
    /// sample.
    pub fn expected_price(&self) -> f64 {
        if self.method().time_step().is_some() {
            return self.price_of_steps(&self.method(), Going::Alone);
        }
        let samples = self.duration() / self.record().time_step();
        of_piece(self) as f64 * samples * self.floors().all().len() as f64
    }

    /// What a run will cost by an explicit method with this time step \[s\].
    pub fn price_of_steps(&self, method: &Method, going: Going) -> f64 {
        let steps = method.time_step().map_or(0.0, |step| self.duration() / step);
        self.of_step(method, going) * steps * self.floors().all().len() as f64
    }
}
