//! From a scene to a simulation: reads the record, and finds a method if the scene asks for an accuracy.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use pounding_motion::Accelerogram;

use crate::ground_motion::SharedMotion;
use crate::{Advice, Error, Goal, GroundMotion, Method, Origin, QuantityGroup, Scene, Simulation};

/// Options for making a simulation of a scene.
#[derive(Default)]
#[expect(missing_debug_implementations, reason = "what is told of progress is a closure")]
pub struct SimulationOptions<'a> {
    /// Folder for relative paths in the scene: that of its file.
    pub base: Option<&'a Path>,
    /// Ground motion that replaces the one of the scene, whose file is then not read.
    pub motion: Option<SharedMotion>,
    /// Whether to accept a time step beyond the limit of stability, and to report a run that breaks a law of mechanics in
    /// [`Simulation::review`]. Each gives a [`Warning`](crate::Warning) instead of an error.
    pub force: bool,
    /// Setting it ends the simulation's runs, and the runs that find its method.
    pub stop: Option<&'static AtomicBool>,
    /// Is called after each run that finds a method, as in [`Advice::of`].
    pub progress: Option<&'a (dyn Fn(usize) + Sync)>,
}

impl<'a, Folder: AsRef<Path> + ?Sized> From<&'a Folder> for SimulationOptions<'a> {
    fn from(base: &'a Folder) -> Self {
        Self {
            base: Some(base.as_ref()),
            ..Self::default()
        }
    }
}

impl Simulation {
    /// Checks a scene and reads its record; `options` may be the folder of the file that holds the scene.
    ///
    /// If the scene asks for an accuracy, it is run with every method ([`Advice::of`]), which takes about a second.
    ///
    /// # Errors
    /// [`Error`] if the record cannot be read, or if a value of the scene cannot be modelled. If the scene asks for an accuracy, also if
    /// its exact run fails.
    #[expect(single_use_lifetimes, reason = "stable Rust asks for its name here")]
    pub fn new<'a>(scene: &Scene, options: impl Into<SimulationOptions<'a>>) -> Result<Self, Error> {
        let SimulationOptions {
            base,
            motion,
            force,
            stop,
            progress,
        } = options.into();
        let patience = scene.budget.begin();
        let checked = scene.check_within(patience);
        checked.map_err(|refused| Error::in_scene(&scene.name, refused))?;
        let motion = if let Some(motion) = motion {
            motion
        } else {
            let base = base.unwrap_or_else(|| Path::new(""));
            GroundMotion::of(&scene.record, base, &scene.name)?.into()
        };
        let simulation = if let Method::Accuracy(error) = scene.method {
            let exact = Scene {
                method: Method::EXACT,
                ..scene.clone()
            };
            let goal = Goal {
                error,
                quantity: QuantityGroup::All,
            };
            let exact = Self::prepared(&exact, motion, stop, patience)?;
            let advice = Advice::of(&exact, goal, progress.unwrap_or(&|_| ()))?;
            exact.advised(advice)?
        } else {
            Self::prepared(scene, motion, stop, patience)?
        };
        if force { Ok(simulation) } else { simulation.enforced() }
    }

    /// Checks a scene that is shaken by a given record. The file that the scene names is not opened.
    ///
    /// # Errors
    /// Errors of [`Self::new`], except those of reading a file.
    pub fn with_record(scene: &Scene, record: Accelerogram) -> Result<Self, Error> {
        scene.check().map_err(|refused| Error::in_scene(&scene.name, refused))?;
        let origin = Origin {
            path: PathBuf::new(),
            sha256: String::new(),
            file: record,
        };
        let motion = GroundMotion::of_file(&scene.record, Arc::new(origin));
        let motion = motion.map_err(|refused| Error::in_scene(&scene.name, refused))?;
        Self::shaken(scene, motion.into())
    }

    /// Checks a scene that is shaken by a given ground motion, whatever its `record` says.
    ///
    /// # Errors
    /// Errors of [`Self::new`], except those of reading a file.
    pub fn shaken(scene: &Scene, motion: SharedMotion) -> Result<Self, Error> {
        Self::new(
            scene,
            SimulationOptions {
                motion: Some(motion),
                ..SimulationOptions::default()
            },
        )
    }
}
