//! The scenes of some studies by another method, under the paper's record, a noisy one or any other.

use crate::noise::Noise;
use crate::{Completed, StudyError, StudyFile};
use pounding_motion::{Record, Refused};
use pounding_scene::{Error, Extras, Method, Scene, Simulation};

/// Scenes of the paper by another method, ready to run under any record.
#[derive(Debug)]
pub(crate) struct Scenes(Vec<Part>);

/// The scenes of one study.
#[derive(Debug)]
struct Part {
    file: StudyFile,
    prepared: Vec<Simulation>,
    /// Interval of the histories that are kept, if anybody looks at them \[s\]; at most a run.
    looked_at: Option<f64>,
}

/// Interval of the histories that the claims need of a study's scenes \[s\]: of Tables 2 and 4 the end alone, of Fig. 15 every step.
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
    /// The scenes of the studies of these names, with the method that `method` makes of theirs.
    ///
    /// # Errors
    /// [`StudyError`] when a study is missing or a scene cannot be prepared.
    pub(crate) fn of(files: &[&StudyFile], studies: &[&str], method: impl Fn(Method) -> Method) -> Result<Self, StudyError> {
        let part = |id: &&str| {
            let file = files.iter().find(|file| file.id == **id);
            let file = file.ok_or_else(|| StudyError::no_scene_of(id))?;
            Part::of((*file).clone(), &method)
        };
        studies.iter().map(part).collect::<Result<_, _>>().map(Self)
    }

    /// Each scene turned into another of the same name, under another record; the end of every run is kept.
    ///
    /// # Errors
    /// [`StudyError`] when a scene cannot be modelled.
    pub(crate) fn shaken(&self, record: &Record, turned: impl Fn(&Scene) -> Scene) -> Result<Self, StudyError> {
        let part = |part: &Part| part.shaken(record, &turned);
        self.0.iter().map(part).collect::<Result<_, _>>().map(Self)
    }

    /// The same with loads that end when the scenes do, and runs that go on for as long again: totals of the paper are of such runs.
    ///
    /// # Errors
    /// [`StudyError`] when a scene cannot be modelled.
    pub(crate) fn running_on(&self) -> Result<Self, StudyError> {
        let parts = self.0.iter().map(Part::running_on);
        parts.collect::<Result<_, _>>().map(Self)
    }

    /// The scenes, prepared.
    pub(crate) fn prepared(&self) -> impl Iterator<Item = &Simulation> {
        self.0.iter().flat_map(|part| &part.prepared)
    }

    /// Runs every scene, under its record or with noise on it.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the scenes.
    pub(crate) fn run(&self, noise: Option<&Noise>) -> Result<Vec<Completed>, StudyError> {
        self.0.iter().map(|part| part.run(noise)).collect()
    }
}

impl Part {
    /// The scenes of a study, prepared in their order.
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
            // Of thousands of noisy runs the ledger would take nearly half of the time: its verdict is asked on the record.
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

/// A record that ends after so long \[s\], and is zero a sample later.
fn ended(record: &Record, duration: f64) -> Result<Record, Refused> {
    let step = record.time_step();
    let is_shaken = |(index, _): &(usize, &f64)| *index as f64 * step <= duration * (1.0 + 1e-9);
    let samples = record.samples().iter().enumerate().take_while(is_shaken);
    let samples = samples.map(|(_, sample)| *sample).chain([0.0]).collect();
    Record::new(step, samples, record.source())
}
