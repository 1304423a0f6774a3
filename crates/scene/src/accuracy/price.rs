//! Cost of a run, in evaluations of a restoring force in a step of the central difference method that take the same time.
//!
//! Costs are counts of work, equal on every machine, times measured weights. The weights come from the processor time of sweeps over nearly
//! equal scenes. These scenes had ledgers or none, two to ten structures, buildings of three and six storeys, elastic and hardening
//! columns, impulsive and compliant laws. Times of runs are within a fifth of these costs; long contacts of compliant laws take more.

use pounding_solver::Work;

use crate::accuracy::methods::ComparedMethod;
use crate::simulation::Simulation;
use crate::{Method, Structure};

/// Number of scenes side by side that cost as much as one alone, by a stepping method: 27 to 48, and 22 for buildings
/// (docs/performance.md).
const BESIDE: [f64; 2] = [40.0, 20.0];
/// Cost that a ledger adds to an evaluation in a step: 0.5 to 0.8, and 0.3 in buildings.
const LEDGER_OF_STEP: f64 = 0.6;

/// How a scene is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunMode {
    /// Alone, without a ledger.
    Alone,
    /// Alone, with a ledger.
    Judged,
    /// Side by side with others.
    Beside,
}

impl RunMode {
    /// Factor by which a ledger increases the cost of a piece of motion of the exact method: 1.6 to 1.8.
    pub const LEDGER_OF_PIECE: f64 = 1.7;
}

/// Cost of a piece of motion of the exact method, by the kind of row.
///
/// Without contact forces and storeys, a piece is a closed form (8 to 9). Otherwise it is a series. For the floors of a building it costs
/// 20, for contact forces 11 to 12 on average and 40 in contact, for both 21. For a power of a Bouc–Wen column it costs 22 to 36, with
/// storeys 32 to 42.
fn of_piece(prepared: &Simulation) -> u64 {
    let scene = prepared.scene();
    let storeys = scene.structures.iter().any(is_storeyed);
    match (storeys, prepared.yields_smoothly(), scene.is_compliant()) {
        (false, false, false) => ComparedMethod::EVALUATIONS_PER_PIECE,
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

/// Cost of an evaluation of a restoring force in a step of a method.
fn of_evaluation(method: &Method) -> f64 {
    match method {
        // It keeps velocities at nodes, and checks where gaps close.
        Method::VelocityVerlet { .. } => 1.5,
        // Its four evaluations share the overhead of a step.
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
    /// Cost of a piece of motion of the exact method in this scene, in force evaluations of equal time.
    pub fn evaluations_per_piece(&self) -> u64 {
        of_piece(self)
    }

    /// Cost of a run of the scene with its method.
    pub fn price(&self, work: Work, going: RunMode) -> f64 {
        let ledger = match going {
            RunMode::Judged => RunMode::LEDGER_OF_PIECE,
            RunMode::Alone | RunMode::Beside => 1.0,
        };
        let of_piece = ledger * of_piece(self) as f64;
        let of_step = self.of_step(&self.method(), going);
        of_step * work.force_evaluations as f64 + of_piece * work.segments as f64
    }

    /// Cost of a floor in a step of a method.
    fn of_step(&self, method: &Method, going: RunMode) -> f64 {
        let alone = of_evaluation(method);
        match going {
            RunMode::Alone => alone,
            RunMode::Judged => alone + LEDGER_OF_STEP,
            RunMode::Beside => {
                let storeys = self.scene().structures.iter().any(is_storeyed);
                alone / BESIDE[usize::from(storeys)]
            }
        }
    }

    /// Rough cost of a run of the scene alone, before it begins. The exact method is taken to have a piece for every floor from sample to
    /// sample.
    pub fn expected_price(&self) -> f64 {
        if self.method().time_step().is_some() {
            return self.price_of_steps(&self.method(), RunMode::Alone);
        }
        let samples = self.duration() / self.record().time_step();
        of_piece(self) as f64 * samples * self.floors().all().len() as f64
    }

    /// Cost of a run with an explicit method at its time step, before it begins.
    pub fn price_of_steps(&self, method: &Method, going: RunMode) -> f64 {
        let steps = method.time_step().map_or(0.0, |step| self.duration() / step);
        self.of_step(method, going) * steps * self.floors().all().len() as f64
    }
}
