//! A study whose scenes have run.

use crate::drivers::each;
use crate::program::Program;
use crate::{StudyError, StudyFile};
use pounding_scene::{RunResult, Scene, Simulation};

/// A study whose scenes have run, in the order of the study. There is at least one scene, except for
/// [`Output::Beyond`](crate::Output::Beyond).
#[derive(Debug)]
pub struct Completed {
    /// The study.
    pub file: StudyFile,
    /// Its prepared scenes.
    pub prepared: Vec<Simulation>,
    /// The result of each scene.
    pub outcomes: Vec<RunResult>,
}

impl Completed {
    /// Runs every scene of a study. Calls `done` after each scene.
    ///
    /// # Errors
    /// [`StudyError`] of the first scene that cannot be prepared or run.
    pub fn run(mut file: StudyFile, done: &(dyn Fn() + Sync)) -> Result<Self, StudyError> {
        let stepless = |scene: &&Scene| scene.method.time_step().is_none();
        if let Some(scene) = file.study.scenes.iter().find(stepless)
            && file.study.output.shows_steps()
        {
            let allowed = "methods with a time step, because this output shows single steps";
            return Err(file.refuse("scenes.method", format!("\"{}\" without a time step", scene.name), allowed));
        }
        let prepare = |scene| Simulation::new(scene, file.base()).map_err(|error| error.in_file(&file.path));
        let prepared = file.study.scenes.iter().map(prepare).collect::<Result<Vec<_>, _>>()?;
        let program = file.study.program.as_ref();
        let refusal = program.and_then(|program| program.refusal(&file.study.scenes, &prepared));
        if let Some((found, allowed)) = refusal {
            return Err(file.refuse("program", found, allowed));
        }
        // If a scene asks for an accuracy, tables and figures show the method that was found for it.
        for (scene, prepared) in file.study.scenes.iter_mut().zip(&prepared) {
            scene.method = prepared.method();
            scene.duration_s = prepared.scene().duration_s;
        }
        Self::of_prepared(file, prepared, |program| program, done)
    }

    /// Runs the study again with the program replaced by `change` of it, in the scenes that a program runs.
    ///
    /// # Errors
    /// [`StudyError`] of the first scene that cannot be run.
    pub(crate) fn by_program(&self, change: impl Fn(Program) -> Program + Sync) -> Result<Self, StudyError> {
        Self::of_prepared(self.file.clone(), self.prepared.clone(), change, &|| ())
    }

    fn of_prepared(
        file: StudyFile,
        prepared: Vec<Simulation>,
        change: impl Fn(Program) -> Program + Sync,
        done: &(dyn Fn() + Sync),
    ) -> Result<Self, StudyError> {
        let keeps_histories = file.study.output.needs_histories();
        let scenes: Vec<_> = prepared.iter().zip(&file.study.scenes).collect();
        let outcomes = each(&scenes, done, |(prepared, scene)| {
            let step = || scene.method.time_step().unwrap_or(prepared.record().time_step());
            let interval = keeps_histories.then(step);
            let outcome = match file.study.program_of(scene) {
                Some(program) => change(program).run(prepared, interval),
                None => prepared.run(interval),
            };
            outcome.map_err(|error| error.in_file(&file.path))
        });
        let outcomes = outcomes.into_iter().collect::<Result<_, _>>()?;
        Ok(Self { file, prepared, outcomes })
    }

    /// The scenes with their results.
    pub fn runs(&self) -> impl Iterator<Item = (&Scene, &RunResult)> {
        self.file.study.scenes.iter().zip(&self.outcomes)
    }

    /// The run of the scene with this name.
    pub fn of(&self, scene: &str) -> Option<(&Scene, &RunResult)> {
        self.runs().find(|(candidate, _)| candidate.name == scene)
    }

    /// An error about this study's file.
    pub(crate) fn refuse(&self, place: &'static str, found: String, allowed: &'static str) -> StudyError {
        self.file.refuse(place, found, allowed)
    }
}
