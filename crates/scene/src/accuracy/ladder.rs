//! The time steps and tolerances with which methods are tried, and the cost of their runs.

use crate::Scene;
use crate::accuracy::methods::{ComparedMethod, MethodSetting};
use pounding_solver::{Exact, Work};
use serde::{Deserialize, Serialize};

/// Time steps and tolerances, each falling.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ladder {
    /// Time steps of the stepping methods \[s\], falling. The duration of every scene is a whole number of each.
    pub time_steps_s: Vec<f64>,
    /// Tolerances of the exact method \[–\], falling; the last one is the reference.
    pub tolerances: Vec<f64>,
}

impl Ladder {
    /// Halves time steps for a scene from the longest one \[s\], while a run has at most `most` steps of structures. The exact method has
    /// its finest tolerance.
    pub(crate) fn halved(scene: &Scene, longest: f64, most: f64) -> Self {
        let duration = scene.duration();
        // The longest step, or the next shorter one that divides the duration.
        let first = (duration / longest - 1e-6).ceil().max(1.0);
        let per_run = crate::file::check::n_floors(scene) as f64;
        let numbers = std::iter::successors(Some(first), |n_steps| Some(2.0 * n_steps));
        let numbers = numbers.take_while(|n_steps| n_steps * per_run <= most);
        Self {
            time_steps_s: numbers.map(|n_steps| duration / n_steps).collect(),
            tolerances: vec![Exact::default().tolerance],
        }
    }

    /// The methods for a scene, each with its settings.
    pub fn entries<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = (&'static ComparedMethod, f64)> + 'a {
        let entering = ComparedMethod::ALL.iter().filter(|contender| contender.enters(scene));
        entering.flat_map(|contender| {
            let settings = match contender.knob {
                MethodSetting::TimeStep => &self.time_steps_s[..],
                MethodSetting::Tolerance if scene.is_compliant() => &self.tolerances[..],
                MethodSetting::Tolerance => &self.tolerances[self.tolerances.len() - 1..],
            };
            settings.iter().map(move |setting| (contender, *setting))
        })
    }
}

impl ComparedMethod {
    /// Number of force evaluations that take as long as a piece of motion of the exact method: `cargo xtask bench` measures 2 to 9.
    pub const EVALUATIONS_PER_PIECE: u64 = 9;

    /// Work by which methods are compared: force evaluations plus pieces of motion of a structure.
    pub fn cost(work: Work) -> u64 {
        work.force_evaluations + work.segments
    }

    /// Cost of a run in force evaluations of equal time.
    pub fn price(work: Work) -> u64 {
        work.force_evaluations + Self::EVALUATIONS_PER_PIECE * work.segments
    }
}
