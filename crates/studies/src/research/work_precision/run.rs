//! A run of one method on one scene.

use pounding_scene::{ComparedMethod, Method, RunResult, Scene, Simulation};
use pounding_solver::{Ledger, Work};

use super::quantities::Quantities;

/// What a run leaves behind, or why it failed.
pub(super) type Ended<'a> = Result<(Quantities, Ledger<'a>, Work), String>;

/// A run of one method on one scene, to be done.
#[derive(Debug)]
pub(super) struct Run<'a> {
    pub(super) scene: &'a Scene,
    pub(super) prepared: &'a Simulation,
    pub(super) contender: &'static ComparedMethod,
    pub(super) setting: f64,
}

impl<'a> Run<'a> {
    pub(super) fn outcome(&self) -> Ended<'a> {
        let (outcome, ledger) = self.recorded()?;
        let quantities = Quantities::of(&outcome, self.scene.structures.len());
        Ok((quantities, ledger, outcome.work))
    }

    /// The outcome of the run, and its ledger; fails with the reason where it ends early.
    ///
    /// The verdict of the ledger is a column of the table.
    pub(super) fn recorded(&self) -> Result<(RunResult, Ledger<'a>), String> {
        let recorded = self.prepared.recorded_by(self.method());
        recorded.map_err(|error| error.to_string())
    }

    pub(super) fn method(&self) -> Method {
        (self.contender.method)(self.setting)
    }
}
