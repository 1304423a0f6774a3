//! Scenes of the paper's studies by another method, under the paper's record, a noisy one or any other.

use crate::noise::Noise;
use crate::{Completed, StudyError, StudyFile};
use pounding_motion::{Record, Refused};
use pounding_scene::{Error, Extras, Method, Scene, Simulation};

/// Scenes of the paper by another method, ready to run under any record.
#[derive(Debug)]
pub(crate) struct Scenes(Vec<StudyScenes>);

/// The scenes of one study.
#[derive(Debug)]
struct StudyScenes {
    file: StudyFile,
    prepared: Vec<Simulation>,
    /// Interval of the recorded histories \[s\], at most the length of a run. `None` if no claim reads them.
    looked_at: Option<f64>,
}

/// Interval of the histories that the claims read \[s\]. Claims on Tables 2 and 4 read only the end, claims on Fig. 15 every step.
fn looked_at(file: &StudyFile) -> Option<f64> {
    match &*file.id {
        "table-2" | "table-4" => Some(AT_THE_END),
        "figure-15" => file.study.scenes.first()?.method.time_step(),
        _ => None,
    }
}

/// An interval of histories that is longer than any run \[s\].
const AT_THE_END: f64 = f64::INFINITY;

impl Scenes {
    /// The scenes of the named studies, each with its method replaced by `method`.
    ///
    /// # Errors
    /// [`StudyError`] if a study is missing or a scene cannot be prepared.
    pub(crate) fn of(files: &[&StudyFile], studies: &[&str], method: impl Fn(Method) -> Method) -> Result<Self, StudyError> {
        let part = |id: &&str| {
            let file = files.iter().find(|file| file.id == **id);
            let file = file.ok_or_else(|| StudyError::no_scene_of(id))?;
            StudyScenes::of((*file).clone(), &method)
        };
        studies.iter().map(part).collect::<Result<_, _>>().map(Self)
    }

    /// Replaces each scene by `turned` of it, with the same name, and puts it under another record. The end of every run is kept.
    ///
    /// # Errors
    /// [`StudyError`] if a scene cannot be modelled.
    pub(crate) fn shaken(&self, record: &Record, turned: impl Fn(&Scene) -> Scene) -> Result<Self, StudyError> {
        let part = |part: &StudyScenes| part.shaken(record, &turned);
        self.0.iter().map(part).collect::<Result<_, _>>().map(Self)
    }

    /// Doubles the length of every run; the loads end where the scenes did. The paper's totals are of such runs.
    ///
    /// # Errors
    /// [`StudyError`] if a scene cannot be modelled.
    pub(crate) fn running_on(&self) -> Result<Self, StudyError> {
        let parts = self.0.iter().map(StudyScenes::running_on);
        parts.collect::<Result<_, _>>().map(Self)
    }

    /// All prepared scenes.
    pub(crate) fn prepared(&self) -> impl Iterator<Item = &Simulation> {
        self.0.iter().flat_map(|part| &part.prepared)
    }

    /// Runs every scene under its record, or under its record with noise.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the scenes.
    pub(crate) fn run(&self, noise: Option<&Noise>) -> Result<Vec<Completed>, StudyError> {
        self.0.iter().map(|part| part.run(noise)).collect()
    }
}

impl StudyScenes {
    /// Prepares the scenes of a study in their order.
    fn prepared(
        file: StudyFile,
        looked_at: Option<f64>,
        mut prepare: impl FnMut(usize, &Scene) -> Result<Simulation, Error>,
    ) -> Result<Self, StudyError> {
        let scenes = file.study.scenes.iter().enumerate();
        let prepared = scenes.map(|(index, scene)| prepare(index, scene)).collect::<Result<_, _>>();
        let prepared = prepared.map_err(|error| error.in_file(&file.path))?;
        Ok(Self { file, prepared, looked_at })
    }

    fn of(mut file: StudyFile, method: impl Fn(Method) -> Method) -> Result<Self, StudyError> {
        let (looked_at, base) = (looked_at(&file), file.base().to_path_buf());
        for scene in &mut file.study.scenes {
            scene.method = method(scene.method);
        }
        Self::prepared(file, looked_at, |_, scene| Simulation::new(scene, &*base))
    }

    fn shaken(&self, record: &Record, turned: impl Fn(&Scene) -> Scene) -> Result<Self, StudyError> {
        let mut file = self.file.clone();
        for scene in &mut file.study.scenes {
            *scene = turned(scene);
        }
        let looked_at = self.looked_at.unwrap_or(AT_THE_END);
        Self::prepared(file, Some(looked_at), |index, scene| {
            self.prepared[index].variant(scene, record.clone())
        })
    }

    fn running_on(&self) -> Result<Self, StudyError> {
        let mut file = self.file.clone();
        for (scene, prepared) in file.study.scenes.iter_mut().zip(&self.prepared) {
            scene.duration_s = Some(2.0 * prepared.duration());
        }
        Self::prepared(file, self.looked_at, |index, scene| {
            let prepared = &self.prepared[index];
            let record = ended(prepared.record(), prepared.duration());
            prepared.variant(scene, record.map_err(|refused| Error::in_scene(&scene.name, refused))?)
        })
    }

    fn run(&self, noise: Option<&Noise>) -> Result<Completed, StudyError> {
        let mut prepared = self.prepared.clone();
        if let Some(noise) = noise {
            for scene in &mut prepared {
                *scene = scene.under(|record| noise.on(record))?;
            }
        }
        let run = |scene: &Simulation| {
            let interval = self.looked_at.map(|interval| interval.min(scene.duration()));
            if let Some(program) = self.file.study.program_of(scene.scene()) {
                return program.run(scene, interval);
            }
            // The ledger would take nearly half the time of thousands of noisy runs, so only the run without noise is judged.
            if noise.is_none() {
                return scene.run(interval);
            }
            let asked = Extras {
                interval,
                closings: false,
                ..Extras::default()
            };
            scene.run_unjudged(asked)
        };
        let outcomes = prepared.iter().map(run).collect::<Result<_, _>>();
        Ok(Completed {
            outcomes: outcomes.map_err(|error| error.in_file(&self.file.path))?,
            file: self.file.clone(),
            prepared,
        })
    }
}

/// The record cut at `duration` \[s\], with one zero sample after it.
fn ended(record: &Record, duration: f64) -> Result<Record, Refused> {
    let step = record.time_step();
    let is_shaken = |(index, _): &(usize, &f64)| *index as f64 * step <= duration * (1.0 + 1e-9);
    let samples = record.samples().iter().enumerate().take_while(is_shaken);
    let samples = samples.map(|(_, sample)| *sample).chain([0.0]).collect();
    Record::new(step, samples, record.source())
}
