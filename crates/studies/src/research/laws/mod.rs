//! The atlas of contact laws: the restitution that each law delivers in a free impact, by every method, and its results in the paper's
//! scenes.
//!
//! Laws are compared at one e, exactly calibrated, with one stiffness for linear springs and one for Hertz springs. The delivered e is that
//! of the exact method or of the law's own relation; the two agree within 1e-9.

mod dependence;
mod entry;
mod impacts;
mod restitution;
mod scenes;
mod time_step;

use crate::files::{Files, drawn, in_folder};
use crate::study::laws::AtlasSettings;
use crate::{Completed, StudyError};
use pounding_plot::Figure;
use pounding_scene::{Refused, Scene};
use std::path::PathBuf;

use entry::Entry;

/// The atlas: all questions to the laws, with their answers.
#[derive(Debug)]
pub struct Atlas {
    settings: AtlasSettings,
    path: PathBuf,
    entries: Vec<Entry>,
    asked: Vec<restitution::CalibratedLaw>,
    impacts: Vec<Option<impacts::Impact>>,
    ladders: Vec<time_step::MethodLadder>,
    played: Vec<scenes::Played>,
}

impl Atlas {
    /// Makes the atlas. Calls `done` after each run of a scene, and after each method with each law.
    ///
    /// The laws that the scenes name are ignored. A run that fails is kept with its reason.
    ///
    /// # Errors
    /// [`StudyError::Study`] if a law cannot be calibrated with these settings, or its impact cannot be followed.
    pub fn draw(completed: &Completed, settings: &AtlasSettings, done: &(dyn Fn() + Sync)) -> Result<Self, StudyError> {
        let refuse = |error: Refused| {
            let allowed = "masses, speed, stiffness and restitution that every law takes";
            completed.refuse("output.laws", error.to_string(), allowed)
        };
        let entries = Entry::all(settings).map_err(refuse)?;
        let impacts = impacts::collide(&entries, settings).map_err(refuse)?;
        Ok(Self {
            asked: restitution::ask(settings),
            ladders: time_step::climb(&entries, settings, done),
            played: scenes::play(completed, &entries, settings, done),
            settings: settings.clone(),
            path: completed.file.path.clone(),
            entries,
            impacts,
        })
    }

    /// Number of calls of `done` by [`Self::draw`].
    pub(crate) fn n_runs(scenes: &[Scene]) -> usize {
        scenes::n_runs(scenes) + time_step::n_ladders()
    }

    /// Tables and figures by their paths in the results folder.
    ///
    /// # Errors
    /// [`StudyError::Plot`] if a figure cannot be drawn.
    pub fn files(&self) -> Result<Files, StudyError> {
        let figures = self
            .figures()
            .into_iter()
            .map(|(name, figure)| Ok((name, drawn(&figure, &self.path)?)));
        let tables = self.tables().into_iter().map(|(name, text)| Ok((name, text.into_bytes())));
        let files: Vec<_> = tables.chain(figures).collect::<Result<_, StudyError>>()?;
        Ok(in_folder("laws", files))
    }

    fn tables(&self) -> [(&'static str, String); 6] {
        let (entries, settings) = (&self.entries, &self.settings);
        [
            ("restitution.csv", restitution::table(&self.asked)),
            ("approach-speed.csv", restitution::speeds(entries, settings)),
            ("free-impact.csv", impacts::table(entries, &self.impacts, settings)),
            ("time-step.csv", time_step::table(entries, &self.ladders)),
            ("scenes.csv", scenes::table(&self.played, entries)),
            ("dependence.csv", dependence::table(&self.played, entries)),
        ]
    }

    fn figures(&self) -> [(&'static str, Figure); 5] {
        let (entries, impacts) = (&self.entries, &self.impacts);
        [
            ("restitution.png", restitution::figure(&self.asked)),
            ("force-deformation.png", impacts::loops(entries, impacts)),
            ("force-time.png", impacts::histories(entries, impacts)),
            ("time-step.png", time_step::figure(entries, &self.ladders, &self.settings)),
            ("scenes.png", dependence::figure(&self.played, entries)),
        ]
    }
}
