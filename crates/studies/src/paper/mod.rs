//! What is of the paper alone: the program that gave its numbers.

mod combinations;
mod program;
mod slips;

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::converged::Quantities;
use crate::{Completed, Prepared, PublishedValues, Structure, StudyError};
pub use program::{Impacts, Joined, Length, Loads, Program, Shared, Start};

/// That a study's scenes are run by the paper's [`Program`], and with which of its two starts.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Programs {
    /// Names of the scenes that use the first load; the others skip it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub first_load_used: Vec<String>,
}

impl Programs {
    /// The program that gives the printed numbers of a scene.
    pub fn of(&self, scene: &str) -> Program {
        Program::printed(if self.first_load_used.iter().any(|name| name == scene) {
            Start::FirstLoadUsed
        } else {
            Start::FirstLoadSkipped
        })
    }
}

/// Whether the program can run a scene: structures of one storey that begin at rest, all shaken at once, with a time step that divides
/// that of the record.
pub(crate) fn can_run(prepared: &Prepared) -> bool {
    let scene = prepared.scene();
    let at_rest = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => {
            sdof.initial_displacement_m == 0.0 && sdof.initial_velocity_m_per_s == 0.0
        }
        Structure::Building(_) | Structure::Wall => false,
    };
    let parts = scene.method.time_step();
    let parts = parts.map(|step| prepared.record().time_step() / step);
    let divides = |parts: f64| parts > 0.5 && (parts - parts.round()).abs() < 1e-9;
    scene.structures.iter().all(at_rest) && scene.arrivals_s.is_none() && parts.is_some_and(divides)
}

/// What each choice of the program is worth, and what all combinations of them give, by their paths in the results folder.
///
/// # Errors
/// [`StudyError`] when scenes do not give what their table shows, or the figure cannot be drawn.
pub(crate) fn files(
    completed: &[Completed],
    published: &PublishedValues,
    exact: &Quantities,
) -> Result<BTreeMap<PathBuf, Vec<u8>>, StudyError> {
    let slips = slips::Slips::new(completed, exact, published.values())?;
    let mut files = slips.files()?;
    let combinations = combinations::combinations(completed, published)?;
    files.insert("paper/combinations.csv".into(), combinations.into_bytes());
    Ok(files)
}
