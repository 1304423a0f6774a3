//! The price of accuracy: every method on every scene over a ladder of time steps or tolerances.
//!
//! The truth is the exact method at its smallest tolerance. Only the digits in which a second, independent route agrees with it count, so
//! no error is smaller than the distance of the two. Work is the number of evaluations of restoring forces, plus the number of pieces of
//! motion that power series carry.

mod condition;
mod figures;
mod measure;
mod pareto;
mod quantities;
mod table;
mod timing;

use crate::files::{Files, in_folder};
use crate::{Completed, StudyError};
use pounding_scene::{Ladder, Scene};
use std::path::PathBuf;

pub(crate) use condition::{Known, under};
use measure::Race;
pub(crate) use quantities::{MethodQuantity, Quantities};
pub use timing::Timed;

/// The runs of a trade study with the reference for their errors.
#[derive(Debug)]
pub struct Trade {
    races: Vec<Race>,
    path: PathBuf,
}

impl Trade {
    /// Runs every method on every scene of a study. Calls `done` after each run.
    ///
    /// The methods that the scenes name are ignored. A run that fails is kept with its reason.
    ///
    /// # Errors
    /// [`StudyError`] if the ladder does not fit the scenes, or if there is no reference.
    pub fn measure(completed: &Completed, ladder: &Ladder, done: &(dyn Fn() + Sync)) -> Result<Self, StudyError> {
        check(completed, ladder)?;
        let races = measure::races(completed, ladder, done)?;
        Ok(Self {
            races,
            path: completed.file.path.clone(),
        })
    }

    /// Number of calls of `done` by [`Self::measure`].
    pub(crate) fn n_runs(scenes: &[Scene], ladder: &Ladder) -> usize {
        scenes.iter().map(|scene| ladder.entries(scene).count()).sum()
    }

    /// Tables and figures by their paths in the results folder.
    ///
    /// # Errors
    /// [`StudyError::Plot`] if a figure cannot be drawn.
    pub fn files(&self) -> Result<Files, StudyError> {
        let tables = [
            ("reference.csv", table::references(&self.races)),
            ("collisions.csv", table::collisions(&self.races)),
            ("trade.csv", table::runs(&self.races)),
            ("pareto.csv", pareto::table(&self.races)),
            ("exact-or-stepping.csv", pareto::exact_or_stepping(&self.races)),
        ];
        let mut files = in_folder("trade", tables.map(|(name, text)| (name, text.into_bytes())));
        files.extend(in_folder("trade", figures::all(&self.races, &self.path)?));
        Ok(files)
    }
}

/// Refuses a ladder that does not fit the scenes.
fn check(completed: &Completed, ladder: &Ladder) -> Result<(), StudyError> {
    let falls = |values: &[f64]| {
        let positive = values.iter().all(|value| value.is_finite() && *value > 0.0);
        positive && !values.is_empty() && values.windows(2).all(|pair| pair[0] > pair[1])
    };
    let words = |values: &[f64]| format!("{values:?}");
    if !falls(&ladder.tolerances) || ladder.tolerances.iter().any(|value| !(1e-16..=1e-3).contains(value)) {
        return Err(completed.refuse(
            "output.trade.tolerances",
            words(&ladder.tolerances),
            "one or more falling numbers of 1e-3 to 1e-16",
        ));
    }
    let fits = |scene: &Scene, time_step: f64| {
        let steps = scene.duration() / time_step;
        (steps - steps.round()).abs() <= 1e-6 && steps < 1e9
    };
    let scenes = &completed.file.study.scenes;
    let fit = ladder.time_steps_s.iter().all(|dt| scenes.iter().all(|scene| fits(scene, *dt)));
    if !falls(&ladder.time_steps_s) || !fit {
        return Err(completed.refuse(
            "output.trade.time_steps_s",
            words(&ladder.time_steps_s),
            "one or more falling numbers > 0, each a whole part of every scene's duration",
        ));
    }
    Ok(())
}
