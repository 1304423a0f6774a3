//! A study whose scenes have run.

use crate::paper::Program;
use crate::{
    AtlasSettings, BeyondSettings, Edges, Ladder, Outcome, Output, Prepared, Scene, StudyError,
    StudyFile,
};

/// A study whose scenes have run, in the order of the study; there is at least one, but of [`Output::Beyond`].
#[derive(Debug)]
pub struct Completed {
    /// The study.
    pub file: StudyFile,
    /// Its scenes, prepared.
    pub prepared: Vec<Prepared>,
    /// What each scene left behind.
    pub outcomes: Vec<Outcome>,
}

impl Completed {
    /// Runs every scene of a study; `done` is called after each.
    ///
    /// # Errors
    /// [`StudyError`] of the first scene that cannot be prepared or run.
    pub fn run(mut file: StudyFile, done: &(dyn Fn() + Sync)) -> Result<Self, StudyError> {
        let stepless = |scene: &&Scene| scene.method.time_step().is_none();
        if let Some(scene) = file.study.scenes.iter().find(stepless)
            && file.study.output.shows_steps()
        {
            return Err(StudyError::Study {
                path: file.path.clone(),
                place: "scenes.method",
                found: format!("\"{}\" without a time step", scene.name),
                allowed: "methods with a time step, of which this output shows something",
            });
        }
        let prepared = file
            .study
            .scenes
            .iter()
            .map(|scene| {
                Prepared::new(scene, file.base()).map_err(|error| error.in_file(&file.path))
            })
            .collect::<Result<Vec<_>, _>>()?;
        let program = file.study.program.as_ref();
        let refusal = program.and_then(|program| program.refusal(&file.study.scenes, &prepared));
        if let Some((found, allowed)) = refusal {
            return Err(StudyError::Study {
                path: file.path.clone(),
                place: "program",
                found,
                allowed,
            });
        }
        // Where a scene asks for an accuracy, tables and figures show the method found for it.
        for (scene, prepared) in file.study.scenes.iter_mut().zip(&prepared) {
            scene.method = prepared.method();
            scene.duration_s = prepared.scene().duration_s;
        }
        Self::of_prepared(file, prepared, |program| program, done)
    }

    /// The same study with another program wherever one runs a scene.
    ///
    /// # Errors
    /// [`StudyError`] of the first scene that cannot be run.
    pub(crate) fn by_program(
        &self,
        change: impl Fn(Program) -> Program + Sync,
    ) -> Result<Self, StudyError> {
        Self::of_prepared(self.file.clone(), self.prepared.clone(), change, &|| ())
    }

    fn of_prepared(
        file: StudyFile,
        prepared: Vec<Prepared>,
        change: impl Fn(Program) -> Program + Sync,
        done: &(dyn Fn() + Sync),
    ) -> Result<Self, StudyError> {
        use rayon::prelude::*;
        let keeps_histories = file.study.output.needs_histories();
        let outcomes = prepared
            .par_iter()
            .zip(&file.study.scenes)
            .map(|(prepared, scene)| {
                let interval = keeps_histories.then(|| {
                    let of_record = prepared.record().time_step();
                    scene.method.time_step().unwrap_or(of_record)
                });
                let outcome = match file.study.program_of(scene) {
                    Some(program) => prepared.by_program(change(program), interval),
                    None => prepared.run(interval),
                };
                done();
                outcome.map_err(|error| error.in_file(&file.path))
            })
            .collect::<Vec<_>>();
        // Collected first: of several errors, the first in order is reported, not the first in time.
        let outcomes = outcomes.into_iter().collect::<Result<Vec<_>, _>>()?;
        Ok(Self {
            file,
            prepared,
            outcomes,
        })
    }

    /// Scenes with what they left behind.
    pub fn runs(&self) -> impl Iterator<Item = (&Scene, &Outcome)> {
        self.file.study.scenes.iter().zip(&self.outcomes)
    }

    /// The run of the scene with this name.
    pub fn of(&self, scene: &str) -> Option<(&Scene, &Outcome)> {
        self.runs().find(|(candidate, _)| candidate.name == scene)
    }

    /// An error about this study's file.
    pub(crate) fn refuse(
        &self,
        place: &'static str,
        found: String,
        allowed: &'static str,
    ) -> StudyError {
        StudyError::Study {
            path: self.file.path.clone(),
            place,
            found,
            allowed,
        }
    }
}

impl Output {
    /// The ladder of a trade study.
    pub(crate) fn ladder(&self) -> Option<&Ladder> {
        if let Self::Trade(ladder) = self {
            Some(ladder)
        } else {
            None
        }
    }

    /// What is pushed to the edge.
    pub(crate) fn edges(&self) -> Option<&Edges> {
        if let Self::Extremes(edges) = self {
            Some(edges)
        } else {
            None
        }
    }

    /// What an atlas of laws asks.
    pub(crate) fn atlas(&self) -> Option<&AtlasSettings> {
        if let Self::Laws(settings) = self {
            Some(settings)
        } else {
            None
        }
    }

    /// The ground motions beyond the paper's.
    pub(crate) fn beyond(&self) -> Option<&BeyondSettings> {
        if let Self::Beyond(settings) = self {
            Some(settings)
        } else {
            None
        }
    }

    /// Whether the output shows what happened step by step.
    fn needs_histories(&self) -> bool {
        match self {
            Self::Claims
            | Self::PoundingForcesTable { .. }
            | Self::DisplacementFigure
            | Self::PoundingFigure
            | Self::FirstCollisionFigure
            | Self::ShearForceFigure { .. } => true,
            Self::StructuresTable
            | Self::Trade(_)
            | Self::Laws(_)
            | Self::Extremes(_)
            | Self::Beyond(_)
            | Self::Survey(_)
            | Self::FirstCollisionTable
            | Self::TransferredMomentumTable
            | Self::TextTable { .. }
            | Self::RecordFigure
            | Self::LayoutFigure => false,
        }
    }

    /// Whether the output shows what a method did in a step, such as the force of an impact as impulse over time step.
    fn shows_steps(&self) -> bool {
        match self {
            Self::Claims
            | Self::PoundingForcesTable { .. }
            | Self::PoundingFigure
            | Self::FirstCollisionFigure => true,
            Self::DisplacementFigure
            | Self::ShearForceFigure { .. }
            | Self::StructuresTable
            | Self::Trade(_)
            | Self::Laws(_)
            | Self::Extremes(_)
            | Self::Beyond(_)
            | Self::Survey(_)
            | Self::FirstCollisionTable
            | Self::TransferredMomentumTable
            | Self::TextTable { .. }
            | Self::RecordFigure
            | Self::LayoutFigure => false,
        }
    }
}
