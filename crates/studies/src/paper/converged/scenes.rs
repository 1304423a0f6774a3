//! The scenes of some studies by another method, under the paper's record, a noisy one or any other.

use crate::noise::Noise;
use crate::{Completed, StudyError, StudyFile};
use pounding_motion::{Record, Refused};
use pounding_scene::{Extras, Method, Scene, Simulation, in_scene};

/// Scenes of the paper by another method, ready to run under any record.
#[derive(Debug)]
pub(crate) struct Scenes(Vec<Part>);

/// The scenes of one study.
#[derive(Debug)]
struct Part {
    file: StudyFile,
    prepared: Vec<Simulation>,
    looked_at: LookedAt,
}

/// The instants at which histories are kept for those who look at them.
#[derive(Debug, Clone, Copy)]
enum LookedAt {
    Never,
    End,
    /// An interval \[s\].
    Every(f64),
}

impl LookedAt {
    /// What the claims look at: of Tables 2 and 4 the end alone, of Fig. 15 all.
    fn of(id: &str, scenes: &[Scene]) -> Self {
        let step = scenes.first().and_then(|scene| scene.method.time_step());
        match (id, step) {
            ("table-2" | "table-4", _) => Self::End,
            ("figure-15", Some(step)) => Self::Every(step),
            _ => Self::Never,
        }
    }

    /// Interval of the histories \[s\] of a run of this duration \[s\].
    fn interval(self, duration: f64) -> Option<f64> {
        match self {
            Self::Never => None,
            Self::End => Some(duration),
            Self::Every(interval) => Some(interval),
        }
    }
}

impl Scenes {
    /// The scenes of the studies of these names, with the method that `method` makes of theirs.
    ///
    /// # Errors
    /// [`StudyError`] when a study is missing or a scene cannot be prepared.
    pub(crate) fn of(files: &[&StudyFile], studies: &[&str], method: impl Fn(Method) -> Method) -> Result<Self, StudyError> {
        let part = |id: &&str| {
            let file = files.iter().find(|file| file.id == **id);
            let file = file.ok_or_else(|| StudyError::MissingScene {
                study: (*id).into(),
                scene: "any".into(),
            })?;
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
    fn of(mut file: StudyFile, method: impl Fn(Method) -> Method) -> Result<Self, StudyError> {
        let looked_at = LookedAt::of(&file.id, &file.study.scenes);
        for scene in &mut file.study.scenes {
            scene.method = method(scene.method);
        }
        let prepare = |scene: &Scene| Simulation::new(scene, file.base());
        let prepared = file.study.scenes.iter().map(prepare).collect::<Result<_, _>>();
        let prepared = prepared.map_err(|error| error.in_file(&file.path))?;
        Ok(Self { file, prepared, looked_at })
    }

    fn shaken(&self, record: &Record, turned: impl Fn(&Scene) -> Scene) -> Result<Self, StudyError> {
        let mut file = self.file.clone();
        for scene in &mut file.study.scenes {
            *scene = turned(scene);
        }
        let pairs = self.prepared.iter().zip(&file.study.scenes);
        let prepared = pairs.map(|(prepared, scene)| prepared.variant(scene, record.clone()));
        let prepared = prepared.collect::<Result<_, _>>();
        let looked_at = match self.looked_at {
            LookedAt::Never | LookedAt::End => LookedAt::End,
            LookedAt::Every(interval) => LookedAt::Every(interval),
        };
        Ok(Self {
            prepared: prepared.map_err(|error| error.in_file(&file.path))?,
            file,
            looked_at,
        })
    }

    fn running_on(&self) -> Result<Self, StudyError> {
        let mut file = self.file.clone();
        let pairs = self.prepared.iter().zip(&mut file.study.scenes);
        let prepared = pairs.map(|(prepared, scene)| {
            let duration = prepared.duration();
            scene.duration_s = Some(2.0 * duration);
            let record = ended(prepared.record(), duration);
            prepared.variant(scene, record.map_err(|error| in_scene(scene, error))?)
        });
        let prepared = prepared.collect::<Result<_, _>>();
        Ok(Self {
            prepared: prepared.map_err(|error| error.in_file(&self.file.path))?,
            looked_at: self.looked_at,
            file,
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
            let interval = self.looked_at.interval(scene.duration());
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
        let outcomes = prepared.iter().map(run);
        let outcomes = outcomes.collect::<Result<_, _>>();
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
    let is_shaken = |index: &usize| *index as f64 * step <= duration * (1.0 + 1e-9);
    let samples = record.samples().iter().enumerate();
    let samples = samples.take_while(|(index, _)| is_shaken(index));
    let samples = samples.map(|(_, sample)| *sample).chain([0.0]).collect();
    Record::new(step, samples, record.source())
}
