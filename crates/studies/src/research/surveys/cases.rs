//! Scenes of a survey with their ground motions.

use crate::research::other_motions::motions_of;
use crate::{BeyondSettings, StudyError, StudyFile};
use pounding_scene::{GroundMotion, Method, RunResult, Scene, Sdof, SharedMotion, Simulation, Structure};
use std::path::Path;

/// A ground motion in one direction, with the duration of its runs \[s\].
#[derive(Debug, Clone)]
pub(super) struct Case {
    pub(super) name: String,
    pub(super) reversed: bool,
    pub(super) motion: SharedMotion,
    pub(super) duration: f64,
}

impl Case {
    /// The motions of a list in both directions, as given before reversed.
    ///
    /// # Errors
    /// [`StudyError`] if a motion cannot be read.
    pub(super) fn listed(settings: &BeyondSettings, path: &Path) -> Result<Vec<Self>, StudyError> {
        let cases = motions_of(settings, path)?.into_iter().flat_map(|shaking| {
            [false, true].map(|reversed| {
                let motion = GroundMotion {
                    record: shaking.directed(reversed),
                    scale: 1.0,
                    origin: None,
                };
                Self {
                    name: shaking.name.clone(),
                    reversed,
                    motion: motion.into(),
                    duration: shaking.duration,
                }
            })
        });
        Ok(cases.collect())
    }

    /// The motion with every acceleration multiplied by a factor.
    ///
    /// # Errors
    /// [`StudyError`] if the factor makes a sample infinite. It names the scene.
    pub(super) fn scaled(&self, factor: f64) -> Result<Self, StudyError> {
        let motion = self.motion.scaled(factor);
        let motion = motion.map_err(|mut refused| {
            refused.place_mut().scene = Some(self.name.clone());
            pounding_scene::Error::Refused(refused)
        })?;
        Ok(Self { motion, ..self.clone() })
    }

    /// A scene under this motion, prepared for the exact method.
    ///
    /// # Errors
    /// Those of [`Simulation::new`], except errors of reading.
    pub(super) fn prepared(&self, scene: &Scene) -> Result<Simulation, pounding_scene::Error> {
        let scene = Scene {
            duration_s: Some(self.duration),
            method: Method::EXACT,
            ..scene.clone()
        };
        Simulation::shaken(&scene, self.motion.clone())
    }

    /// Runs a scene under this motion by the exact method.
    ///
    /// # Errors
    /// Those of [`Self::prepared`] and [`Simulation::run`].
    pub(super) fn run(&self, scene: &Scene) -> Result<Response, StudyError> {
        let prepared = self.prepared(scene)?;
        Ok(Response::of(&prepared.run(None)?, scene.structures.len()))
    }
}

/// The numbers of a run of one-storey structures that surveys use.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Response {
    /// Peak displacement of every structure, without sign \[m\].
    pub(super) peaks: Vec<f64>,
    /// Sum of the impulses of all collisions \[N·s\].
    pub(super) impulse: f64,
    /// Largest pounding force \[N\]; 0 if the contacts are impulsive.
    pub(super) force: f64,
    /// Number of collisions.
    pub(super) collisions: usize,
}

impl Response {
    pub(super) fn of(outcome: &RunResult, n_structures: usize) -> Self {
        let all = outcome.collisions.all();
        let peak = |index| outcome.peaks.of(index).displacement.value.abs();
        Self {
            peaks: (0..n_structures).map(peak).collect(),
            impulse: all.iter().map(|one| one.impulse).sum(),
            force: all.iter().filter_map(|one| one.peak_force).fold(0.0, f64::max),
            collisions: all.len(),
        }
    }
}

/// A one-storey structure of a scene.
///
/// # Panics
/// Panics on another kind of structure, which [`rows`] refuses.
pub(super) fn sdof(scene: &mut Scene, index: usize) -> &mut Sdof {
    match &mut scene.structures[index] {
        Structure::Sdof(sdof) => sdof,
        Structure::Building(_) | Structure::Wall => unreachable!("a row of structures of one storey"),
    }
}

/// Sets the natural period \[s\] at constant mass.
pub(super) fn set_period(sdof: &mut Sdof, period: f64) {
    let omega = std::f64::consts::TAU / period;
    sdof.stiffness_n_per_m = sdof.mass_kg * omega * omega;
}

/// The scenes of a study, if all are rows of `n_structures` one-storey structures with contacts.
///
/// # Errors
/// [`StudyError::Study`] for any other scene.
pub(super) fn rows(file: &StudyFile, n_structures: usize) -> Result<&[Scene], StudyError> {
    let scenes = &file.study.scenes;
    let of_one_storey = |structure: &Structure| matches!(structure, Structure::Sdof(_));
    let fits =
        |scene: &&Scene| scene.structures.len() == n_structures && scene.structures.iter().all(of_one_storey) && scene.contacts.is_some();
    let allowed = "rows of structures of one storey with contacts, as many as the survey needs";
    match scenes.iter().find(|scene| !fits(scene)) {
        None => Ok(scenes),
        Some(other) => Err(file.refuse("scenes", format!("\"{}\"", other.name), allowed)),
    }
}

/// The scene with a width for all gaps \[m\].
pub(super) fn with_gap(scene: &Scene, gap: f64) -> Scene {
    let mut scene = scene.clone();
    for contact in scene.contacts.iter_mut().flatten() {
        contact.gap_m = gap;
    }
    scene
}
