//! Scenes of a survey and the ground motions that shake them.

use crate::research::other_motions::motions_of;
use crate::{BeyondSettings, StudyError, StudyFile};
use pounding_scene::{GroundMotion, Method, RunResult, Scene, Sdof, SharedMotion, Simulation, Structure, parallel};
use std::path::Path;

/// A ground motion in one direction, and how long it shakes \[s\].
#[derive(Debug, Clone)]
pub(super) struct Case {
    pub(super) name: String,
    pub(super) reversed: bool,
    motion: SharedMotion,
    duration: f64,
}

impl Case {
    /// The motions of a list in both directions, as recorded and then reversed.
    ///
    /// # Errors
    /// [`StudyError`] for a motion that cannot be read.
    pub(super) fn listed(settings: &BeyondSettings, path: &Path) -> Result<Vec<Self>, StudyError> {
        let both = |motion| [false, true].map(|reversed| (reversed, Clone::clone(motion)));
        let motions = motions_of(settings, path)?;
        let cases = motions.iter().flat_map(both).map(|(reversed, motion)| {
            let record = motion.directed(reversed);
            Self {
                name: motion.name,
                reversed,
                duration: motion.duration,
                motion: GroundMotion {
                    record,
                    scale: 1.0,
                    origin: None,
                }
                .into(),
            }
        });
        Ok(cases.collect())
    }

    /// A motion as it is, of which two of the longest periods of a scene are waited for.
    pub(super) fn of_motion(name: String, motion: SharedMotion, duration: f64) -> Self {
        Self {
            name,
            reversed: false,
            motion,
            duration,
        }
    }

    /// The same, every acceleration multiplied by a factor.
    ///
    /// # Errors
    /// Names the scene, for a factor that leaves no finite numbers.
    pub(super) fn scaled(&self, factor: f64) -> Result<Self, StudyError> {
        let motion = self.motion.scaled(factor);
        let motion = motion.map_err(|mut refused| {
            refused.place_mut().scene = Some(self.name.clone());
            pounding_scene::Error::Refused(refused)
        })?;
        Ok(Self { motion, ..self.clone() })
    }

    pub(super) fn direction(&self) -> &'static str {
        if self.reversed { "reversed" } else { "as recorded" }
    }

    /// A scene under this motion, by the exact method.
    ///
    /// # Errors
    /// Those of [`Simulation::new`] but of reading.
    pub(super) fn prepared(&self, scene: &Scene) -> Result<Simulation, pounding_scene::Error> {
        let scene = Scene {
            duration_s: Some(self.duration),
            method: Method::EXACT,
            ..scene.clone()
        };
        Simulation::shaken(&scene, self.motion.clone())
    }

    /// The run of a scene under this motion, by the exact method.
    ///
    /// # Errors
    /// Those of [`Self::prepared`] and [`Simulation::run`].
    pub(super) fn run(&self, scene: &Scene) -> Result<Response, StudyError> {
        let prepared = self.prepared(scene)?;
        Ok(Response::of(&prepared.run(None)?, scene.structures.len()))
    }
}

/// What a survey wants of a run of structures of one storey.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Response {
    /// Peak displacement of every structure, without sign \[m\].
    pub(super) peaks: Vec<f64>,
    /// Sum of the impulses of all collisions \[N·s\].
    pub(super) impulse: f64,
    /// Largest pounding force \[N\]; 0 where contact is impulsive.
    pub(super) force: f64,
    /// Number of collisions.
    pub(super) collisions: usize,
}

impl Response {
    pub(super) fn of(outcome: &RunResult, n_structures: usize) -> Self {
        let all = outcome.collisions.all();
        let peak = |index| outcome.peaks.of(index).displacement.value.abs();
        let forces = all.iter().filter_map(|one| one.peak_force);
        Self {
            peaks: (0..n_structures).map(peak).collect(),
            impulse: all.iter().map(|one| one.impulse).sum(),
            force: forces.fold(0.0, f64::max),
            collisions: all.len(),
        }
    }
}

/// A structure of one storey of a scene.
///
/// # Panics
/// On another kind of structure: [`rows`] refuses it.
pub(super) fn sdof(scene: &mut Scene, index: usize) -> &mut Sdof {
    match &mut scene.structures[index] {
        Structure::Sdof(sdof) => sdof,
        Structure::Building(_) | Structure::Wall => {
            unreachable!("a row of structures of one storey")
        }
    }
}

/// A structure with another natural period \[s\] at the same mass.
pub(super) fn set_period(sdof: &mut Sdof, period: f64) {
    let omega = std::f64::consts::TAU / period;
    sdof.stiffness_n_per_m = sdof.mass_kg * omega * omega;
}

/// The scenes of a study where all are rows of so many structures of one storey, with contacts.
///
/// # Errors
/// [`StudyError::Study`] for another scene.
pub(super) fn rows(file: &StudyFile, n_structures: usize) -> Result<&[Scene], StudyError> {
    let scenes = &file.study.scenes;
    let fits = |scene: &&Scene| {
        let of_one_storey = |structure: &Structure| matches!(structure, Structure::Sdof(_));
        scene.structures.len() == n_structures && scene.structures.iter().all(of_one_storey) && scene.contacts.is_some()
    };
    match scenes.iter().find(|scene| !fits(scene)) {
        None => Ok(scenes),
        Some(other) => Err(StudyError::Study {
            path: file.path.clone(),
            place: "scenes",
            found: format!("\"{}\"", other.name),
            allowed: "rows of structures of one storey with contacts, as many as the survey needs",
        }),
    }
}

/// A scene with all gaps of one width \[m\].
pub(super) fn with_gap(scene: &Scene, gap: f64) -> Scene {
    let mut scene = scene.clone();
    for contact in scene.contacts.iter_mut().flatten() {
        contact.gap_m = gap;
    }
    scene
}

/// What a function makes of everything, in the order of it, or the first error in that order.
pub(super) fn each<T: Sync, R: Send>(all: &[T], make: impl Fn(&T) -> Result<R, StudyError> + Send + Sync) -> Result<Vec<R>, StudyError> {
    parallel::try_each(all, make)
}
