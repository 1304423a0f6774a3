//! The scenes of some studies by another method, under the paper's record or a noisy one.

use crate::noise::Noise;
use crate::{Completed, Method, Prepared, Scene, StudyError, StudyFile};

/// Scenes of the paper by another method, ready to run under any record.
#[derive(Debug)]
pub(super) struct Scenes(Vec<Part>);

/// The scenes of one study.
#[derive(Debug)]
struct Part {
    file: StudyFile,
    prepared: Vec<Prepared>,
    /// Interval of the histories \[s\]; nothing where nobody looks at them.
    interval: Option<f64>,
}

impl Scenes {
    /// The scenes of the studies of these names, with the method that `method` makes of theirs.
    ///
    /// # Errors
    /// [`StudyError`] when a study is missing or a scene cannot be prepared.
    pub(super) fn of(
        completed: &[Completed],
        studies: &[&str],
        method: impl Fn(Method) -> Method,
    ) -> Result<Self, StudyError> {
        let part = |id: &&str| {
            let study = completed.iter().find(|study| study.file.id == **id);
            let study = study.ok_or_else(|| StudyError::MissingScene {
                study: (*id).into(),
                scene: "any".into(),
            })?;
            Part::of(study.file.clone(), &method)
        };
        studies.iter().map(part).collect::<Result<_, _>>().map(Self)
    }

    /// Runs every scene, under the paper's record or with noise on it.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the scenes.
    pub(super) fn run(&self, noise: Option<&Noise>) -> Result<Vec<Completed>, StudyError> {
        self.0.iter().map(|part| part.run(noise)).collect()
    }
}

impl Part {
    fn of(mut file: StudyFile, method: impl Fn(Method) -> Method) -> Result<Self, StudyError> {
        let interval = file.study.scenes.first();
        let interval = interval.and_then(|scene| self::interval(&file.id, scene));
        for scene in &mut file.study.scenes {
            scene.method = method(scene.method);
        }
        let prepare = |scene: &Scene| Prepared::new(scene, file.base());
        let prepared = file
            .study
            .scenes
            .iter()
            .map(prepare)
            .collect::<Result<_, _>>();
        let prepared = prepared.map_err(|error| error.in_file(&file.path))?;
        Ok(Self {
            file,
            prepared,
            interval,
        })
    }

    fn run(&self, noise: Option<&Noise>) -> Result<Completed, StudyError> {
        let mut prepared = self.prepared.clone();
        if let Some(noise) = noise {
            for scene in &mut prepared {
                *scene = scene.under(|record| noise.on(record))?;
            }
        }
        // Of thousands of noisy runs the ledger would take a third of the time: its verdict is asked on the record.
        let run = |scene: &Prepared| match noise {
            None => scene.run(self.interval),
            Some(_) => scene.run_unjudged(self.interval),
        };
        let outcomes = prepared.iter().map(run);
        let outcomes = outcomes.collect::<Result<_, _>>();
        Ok(Completed {
            outcomes: outcomes.map_err(|error| error.in_file(&self.file.path))?,
            file: self.file.clone(),
            prepared,
        })
    }
}

/// Interval of the histories that the claims look at \[s\]: of Tables 2 and 4 the end alone, of Fig. 15 all.
fn interval(id: &str, scene: &Scene) -> Option<f64> {
    match id {
        "table-2" | "table-4" => Some(scene.duration()),
        "figure-15" => scene.method.time_step(),
        _ => None,
    }
}
