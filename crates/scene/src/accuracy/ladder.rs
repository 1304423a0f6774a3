//! The settings on which methods are tried, what a run on them costs, and what "from there on" means.

use crate::Scene;
use crate::accuracy::methods::{COMPARED_METHODS, ComparedMethod, Knob, is_compliant};
use pounding_solver::{Exact, Work};
use serde::{Deserialize, Serialize};

/// Time steps and tolerances, each falling.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ladder {
    /// Time steps of the stepping methods \[s\], falling; each a whole part of every scene's duration.
    pub time_steps_s: Vec<f64>,
    /// Tolerances of the exact method \[–\], falling; the last one is the reference.
    pub tolerances: Vec<f64>,
}

impl Ladder {
    /// Steps for a scene, halved from the longest one \[s\] while a run has no more than so many steps of structures;
    /// the exact method at its finest.
    pub(crate) fn halved(scene: &Scene, longest: f64, most: f64) -> Self {
        let duration = scene.duration();
        // The longest, or the next shorter step of which the duration is a whole number.
        let first = (duration / longest - 1e-6).ceil().max(1.0);
        let per_run = crate::file::check::n_floors(scene) as f64;
        let numbers = std::iter::successors(Some(first), |n_steps| Some(2.0 * n_steps));
        let numbers = numbers.take_while(|n_steps| n_steps * per_run <= most);
        Self {
            time_steps_s: numbers.map(|n_steps| duration / n_steps).collect(),
            tolerances: vec![Exact::default().tolerance],
        }
    }
}

/// The methods on a scene, each with its settings.
pub fn entries<'a>(scene: &'a Scene, ladder: &'a Ladder) -> impl Iterator<Item = (&'static ComparedMethod, f64)> + 'a {
    let entering = COMPARED_METHODS.iter().filter(|contender| contender.enters(scene));
    entering.flat_map(|contender| {
        let settings = match contender.knob {
            Knob::TimeStep => &ladder.time_steps_s[..],
            Knob::Tolerance if is_compliant(scene) => &ladder.tolerances[..],
            Knob::Tolerance => &ladder.tolerances[ladder.tolerances.len() - 1..],
        };
        settings.iter().map(move |setting| (contender, *setting))
    })
}

/// The work that methods are compared by: force evaluations and pieces of motion of a structure.
pub fn cost(work: Work) -> u64 {
    work.force_evaluations + work.segments
}

/// Force evaluations that take as long as a piece of motion of the exact method: `cargo xtask bench` measures 2 to 9.
pub const EVALUATIONS_PER_PIECE: u64 = 9;

/// What a run costs, in force evaluations of equal time.
pub fn price(work: Work) -> u64 {
    work.force_evaluations + EVALUATIONS_PER_PIECE * work.segments
}
