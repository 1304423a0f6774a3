//! Choice of the runs to time.

use super::Trade;
use super::measure::{Entrant, Measured, Rung};
use super::pareto::{EXACT, STEPPING, cheapest};
use super::quantities::{MethodQuantity, MethodRun};
use super::table::setting;
use crate::{Completed, StudyError, StudyFile};
use pounding_scene::{ComparedMethod, Scene};
use pounding_solver::{RunError, Work};
use std::path::Path;

/// A run to time: the cheapest one of a method that is accurate enough, or its finest.
#[derive(Debug)]
pub struct Timed<'a> {
    /// Name of the scene.
    pub scene: &'a str,
    /// Name of the method.
    pub method: &'static str,
    /// Time step \[s\] or tolerance \[–\], as printed.
    pub setting: String,
    /// The largest relative error of all quantities \[–\].
    pub error: f64,
    /// Whether the run is accurate enough and stays so at smaller settings: 1e-6 for the exact method, 1e-2 for others.
    pub holds: bool,
    /// Number of force evaluations, plus number of pieces of motion that a power series carries.
    pub work: u64,
    /// Whether other runs are compared with it: true for the convergent central difference method.
    pub is_base: bool,
    run: MethodRun<'a>,
}

impl Timed<'_> {
    /// Runs the method and records the printed numbers, without the ledger.
    ///
    /// # Errors
    /// [`RunError`] if the run ends early.
    pub fn run(&self) -> Result<Work, RunError> {
        self.run.prepared.timed_by(self.run.method())
    }
}

impl Trade {
    /// Reads a trade study and measures its scenes of two structures that can touch under a record with shaking.
    ///
    /// # Errors
    /// [`StudyError`] if the study cannot be read or measured, or is not a trade study.
    pub fn of_two_structures(path: &Path) -> Result<(Completed, Self), StudyError> {
        let mut file = StudyFile::read(path)?;
        let wanted = |scene: &Scene| scene.structures.len() == 2 && scene.contacts.is_some() && scene.record.scale != 0.0;
        file.study.scenes.retain(wanted);
        let completed = Completed::run(file, &|| ())?;
        let ladder = completed
            .file
            .study
            .output
            .ladder()
            .ok_or_else(|| completed.refuse("output", "another".into(), "\"trade\" with a ladder"))?;
        let trade = Self::measure(&completed, ladder, &|| ())?;
        Ok((completed, trade))
    }

    /// For every scene and method the cheapest run for its error, or the finest that ended without a fault.
    ///
    /// `completed` is the study that was measured.
    pub fn timed<'a>(&'a self, completed: &'a Completed) -> Vec<Timed<'a>> {
        let scenes = completed.file.study.scenes.iter().zip(&completed.prepared);
        let mut timed = Vec::new();
        for (race, (scene, prepared)) in self.races.iter().zip(scenes) {
            for entrant in &race.entrants {
                let Some((rung, measured, holds)) = choose(entrant) else {
                    continue;
                };
                timed.push(Timed {
                    scene: &race.scene,
                    method: entrant.contender.key,
                    setting: setting(entrant.contender, rung.setting),
                    error: measured.worst(&MethodQuantity::ALL),
                    holds,
                    work: measured.cost(),
                    is_base: entrant.contender.key == ComparedMethod::RIVAL,
                    run: MethodRun {
                        scene,
                        prepared,
                        contender: entrant.contender,
                        setting: rung.setting,
                    },
                });
            }
        }
        timed
    }
}

/// The run of a method to time, its results, and whether it is accurate enough.
fn choose(entrant: &Entrant) -> Option<(&Rung, &Measured, bool)> {
    let exact = entrant.contender.key == ComparedMethod::REFERENCE;
    let allowed = if exact { EXACT } else { STEPPING };
    let accurate = cheapest(entrant, |measured| measured.worst(&MethodQuantity::ALL) <= allowed);
    let finest = || entrant.rungs.iter().rfind(|rung| rung.outcome.is_ok());
    let rung = accurate.map(|run| run.rung).or_else(finest)?;
    Some((rung, rung.outcome.as_ref().ok()?, accurate.is_some()))
}
