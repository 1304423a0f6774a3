//! Which runs are worth timing.

use super::Trade;
use super::measure::{Entrant, Measured, Rung};
use super::pareto::{EXACT, STEPPING, cheapest};
use super::quantities::{MethodQuantity, Run};
use super::table::setting;
use crate::{Completed, StudyError, StudyFile};
use pounding_scene::{ComparedMethod, Scene};
use pounding_solver::{RunError, Work};
use std::path::Path;

/// A run to be timed: that of a method which is just accurate enough, or its finest.
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
    /// Whether it is accurate enough, and stays so at smaller settings: 1e-6 for the exact method, 1e-2 for others.
    pub holds: bool,
    /// Force evaluations and pieces of structures carried by power series.
    pub work: u64,
    /// Whether others are compared with it: the convergent central difference method.
    pub is_base: bool,
    run: Run<'a>,
}

impl Timed<'_> {
    /// Runs the method and records what is printed of a run, without the ledger.
    ///
    /// # Errors
    /// [`RunError`] when the run ends early.
    pub fn run(&self) -> Result<Work, RunError> {
        self.run.prepared.timed_by(self.run.method())
    }
}

impl Trade {
    /// Reads a trade study and measures those of its scenes that have two structures which can touch, and a record
    /// that shakes them.
    ///
    /// # Errors
    /// [`StudyError`] where the study cannot be read or measured, or is none of a trade.
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

    /// For every scene and method the run that is cheapest for its error, or the finest that ended well.
    ///
    /// The completed study is the one that was measured.
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
                    run: Run {
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

/// The run of a method to be timed, what came out of it, and whether it is accurate enough.
fn choose(entrant: &Entrant) -> Option<(&Rung, &Measured, bool)> {
    let exact = entrant.contender.key == ComparedMethod::REFERENCE;
    let allowed = if exact { EXACT } else { STEPPING };
    let accurate = cheapest(entrant, |measured| measured.worst(&MethodQuantity::ALL) <= allowed);
    let finest = || entrant.rungs.iter().rfind(|rung| rung.outcome.is_ok());
    let rung = accurate.map(|(rung, _)| rung).or_else(finest)?;
    Some((rung, rung.outcome.as_ref().ok()?, accurate.is_some()))
}
