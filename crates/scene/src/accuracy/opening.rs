//! From a scene to a simulation: its record is read, and where it asks for an accuracy, a method is found.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use pounding_motion::Accelerogram;

use crate::accuracy::search::advise;
use crate::ground_motion::SharedMotion;
use crate::simulation::in_scene;
use crate::{Error, Goal, GroundMotion, Method, Origin, QuantityGroup, Scene, Simulation};

/// How a scene becomes a simulation.
#[derive(Default)]
#[expect(missing_debug_implementations, reason = "what is told of progress is a closure")]
pub struct Options<'a> {
    /// The folder that the scene names its record from; that of the file which holds the scene.
    pub base: Option<&'a Path>,
    /// The ground motion instead of the one that the scene names, of which nothing is read then.
    pub motion: Option<SharedMotion>,
    /// Whether a time step beyond the limit of stability is taken, and [`Simulation::review`] reports a run that breaks a law of
    /// mechanics; both with a [`Warning`](crate::Warning) instead of an error.
    pub force: bool,
    /// Whoever sets it ends the simulation's runs, and those that find its method.
    pub stop: Option<&'static AtomicBool>,
    /// Is told of the runs that find a method, as by [`advise`].
    pub progress: Option<&'a (dyn Fn(usize) + Sync)>,
}

impl<'a, Folder: AsRef<Path> + ?Sized> From<&'a Folder> for Options<'a> {
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
    /// A scene that asks for an accuracy is run with every method ([`advise`]), which takes a second or so.
    ///
    /// # Errors
    /// [`Error`] when the record cannot be read or a value of the scene cannot be modelled; of a scene that asks for an
    /// accuracy, also when its exact run fails.
    #[expect(single_use_lifetimes, reason = "stable Rust asks for its name here")]
    pub fn new<'a>(scene: &Scene, options: impl Into<Options<'a>>) -> Result<Self, Error> {
        let Options {
            base,
            motion,
            force,
            stop,
            progress,
        } = options.into();
        let patience = scene.budget.begin();
        let checked = scene.check_within(patience);
        checked.map_err(|source| in_scene(scene, source))?;
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
            let advice = advise(&exact, goal, progress.unwrap_or(&|_| ()))?;
            exact.advised(advice)?
        } else {
            Self::prepared(scene, motion, stop, patience)?
        };
        if force { Ok(simulation) } else { simulation.enforced() }
    }

    /// The same, shaken with a record at hand; the file that the scene names is not opened.
    ///
    /// # Errors
    /// Those of [`Self::new`] but of reading.
    pub fn with_record(scene: &Scene, record: Accelerogram) -> Result<Self, Error> {
        scene.check().map_err(|source| in_scene(scene, source))?;
        let origin = Origin {
            path: PathBuf::new(),
            sha256: String::new(),
            file: record,
        };
        let motion = GroundMotion::of_file(&scene.record, Arc::new(origin));
        let motion = motion.map_err(|source| in_scene(scene, source))?;
        Self::shaken(scene, motion.into())
    }

    /// The same, shaken by a ground motion at hand, whatever its `record` names.
    ///
    /// # Errors
    /// Those of [`Self::new`] but of reading.
    pub fn shaken(scene: &Scene, motion: SharedMotion) -> Result<Self, Error> {
        Self::new(
            scene,
            Options {
                motion: Some(motion),
                ..Options::default()
            },
        )
    }
}
