//! From a checked scene to the leanest model, and its run.

mod columns;
mod model;
mod pair_outcome;
mod run;
mod side_by_side;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use pounding_motion::{Accelerogram, Record, RecordError};
use pounding_solver::{Budget, Clock, Integrator};

use crate::advice::{Advice, Goal, advise};
use crate::floors::{Floor, Floors};
use crate::ground_motion::SharedMotion;
use crate::{GroundMotion, Method, Origin, Quantity, Scene, SceneError, StudyError, check};
use model::Model;
pub(crate) use pair_outcome::LEANS;
pub use pair_outcome::PairOutcome;
pub(crate) use run::{Asked, Audited, Recorders};
pub use run::{Balance, Outcome};
pub(crate) use side_by_side::side_by_side;

/// A checked scene, ready to run: the leanest row that models it, its record, clock and integrator.
#[derive(Debug, Clone)]
pub struct Prepared {
    /// The scene; where it asks for an accuracy, with the method found for it.
    scene: Scene,
    /// How that method was found.
    advice: Option<Advice>,
    /// Whether it runs though its time step or its results are refused.
    forced: bool,
    /// Why its time step is refused.
    unstable: Option<SceneError>,
    floors: Floors,
    model: Model,
    record: Arc<Record>,
    /// What the source of the record was multiplied by.
    scale: f64,
    /// The file that the record came from; nothing for one from a formula.
    origin: Option<Arc<Origin>>,
    clock: Clock,
    integrator: Integrator,
    /// Whoever sets it ends its runs.
    stop: Option<&'static AtomicBool>,
}

impl Prepared {
    /// Checks a scene and reads its record; `base` is the folder of the file that holds the scene.
    ///
    /// A scene that asks for an accuracy is run with every method ([`advise`]), which takes a second or so.
    ///
    /// # Errors
    /// [`StudyError`] when the record cannot be read or a value of the scene cannot be modelled; of a scene that asks
    /// for an accuracy, also when its exact run fails.
    pub fn new(scene: &Scene, base: &Path) -> Result<Self, StudyError> {
        Self::watched(scene, base, &|_| ())
    }

    /// The same; where a method has to be found, `done` is called as by [`advise`].
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn watched(
        scene: &Scene,
        base: &Path,
        done: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, StudyError> {
        Self::forcing(scene, base, done)?.enforced()
    }

    /// The same, but a time step beyond the limit of stability is taken, and [`Self::review`] reports a run that breaks a
    /// law of mechanics; both with a [`Warning`](crate::Warning).
    ///
    /// # Errors
    /// Those of [`Self::new`] but [`SceneError::Unstable`].
    pub fn forcing(
        scene: &Scene,
        base: &Path,
        done: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, StudyError> {
        check::scene(scene).map_err(|source| in_scene(scene, source))?;
        let motion = GroundMotion::of(&scene.record, base, &scene.name)?;
        Self::of_checked(scene, motion.into(), (done, None))
    }

    /// The same as [`Self::new`]; whoever sets `stop` ends its runs, and those that find its method.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub(crate) fn stopped_by(
        scene: &Scene,
        base: &Path,
        stop: Option<&'static AtomicBool>,
    ) -> Result<Self, StudyError> {
        check::scene(scene).map_err(|source| in_scene(scene, source))?;
        let motion = GroundMotion::of(&scene.record, base, &scene.name)?;
        Self::of_checked(scene, motion.into(), (&|_| (), stop))?.enforced()
    }

    /// Checks a scene that is shaken with a record at hand; the file that the scene names is not opened.
    ///
    /// # Errors
    /// Those of [`Self::new`] but of reading.
    pub fn with_record(scene: &Scene, record: Accelerogram) -> Result<Self, StudyError> {
        let in_scene = |source| in_scene(scene, source);
        check::scene(scene).map_err(in_scene)?;
        let origin = Origin {
            path: PathBuf::new(),
            sha256: String::new(),
            file: record,
        };
        let motion = GroundMotion::of_file(&scene.record, origin).map_err(in_scene)?;
        Self::of_checked(scene, motion.into(), (&|_| (), None))?.enforced()
    }

    /// Checks a scene that is shaken by a ground motion at hand, whatever its `record` names.
    ///
    /// # Errors
    /// Those of [`Self::new`] but of reading.
    pub(crate) fn shaken(scene: &Scene, motion: SharedMotion) -> Result<Self, StudyError> {
        check::scene(scene).map_err(|source| in_scene(scene, source))?;
        Self::of_checked(scene, motion, (&|_| (), None))?.enforced()
    }

    /// Gives a row of structures of one storey under the same motion other numbers of structures and contacts, which is all that
    /// `change` may set; the bits are those of the scene prepared anew. Nothing where they are refused: then this is of no more use,
    /// and preparing the scene says why. `duration_s` is what the scene says.
    pub(crate) fn renumber(
        &mut self,
        duration_s: Option<f64>,
        change: impl FnOnce(&mut Scene) -> Option<()>,
    ) -> Option<()> {
        let scene = &mut self.scene;
        scene.duration_s = duration_s;
        change(scene)?;
        check::scene(scene).ok()?;
        let duration = scene.duration_under(self.record.duration());
        scene.duration_s = Some(duration);
        check::check_method(scene).ok()?;
        check::free_limit(scene).ok()?;
        self.floors.renumber(scene);
        self.model.renumber(scene, &self.floors).ok()?;
        self.clock = scene.method.clock(duration);
        Some(())
    }

    /// Not forced: refused where its time step is beyond the limit of stability.
    fn enforced(mut self) -> Result<Self, StudyError> {
        self.forced = false;
        self.stable()
    }

    fn of_checked(
        scene: &Scene,
        SharedMotion {
            record,
            scale,
            origin,
        }: SharedMotion,
        (done, stop): (&(dyn Fn(usize) + Sync), Option<&'static AtomicBool>),
    ) -> Result<Self, StudyError> {
        let in_scene = |source| in_scene(scene, source);
        let duration = scene.duration_under(record.duration());
        let scene = &Scene {
            duration_s: Some(duration),
            ..scene.clone()
        };
        check::check_method(scene).map_err(in_scene)?;
        let (floors, model) = modelled(scene).map_err(in_scene)?;
        let quantity = Quantity::All;
        let (goal, method) = if let Method::Accuracy(error) = scene.method {
            (Some(Goal { error, quantity }), Method::EXACT)
        } else {
            (None, scene.method)
        };
        let mut prepared = Self {
            scene: scene.clone(),
            advice: None,
            forced: true,
            unstable: check::free_limit(scene).err(),
            floors,
            model,
            record,
            scale,
            origin,
            clock: method.clock(duration),
            integrator: method.integrator(),
            stop,
        };
        prepared.scene.method = method;
        let settings = prepared.integrator.check();
        settings.map_err(|error| prepared.ended(error))?;
        if let Some(goal) = goal {
            let advice = advise(&prepared, goal, done)?;
            prepared = prepared.with_method(advice.best().method)?;
            prepared.advice = Some(advice);
        }
        Ok(prepared)
    }

    /// The same scene modelled in full, whatever it requires: columns that remember their yielding, and all neighbours as
    /// pairs. Its results are those of the lean model to the last bit, at more cost.
    ///
    /// # Errors
    /// Those of the lean model, which were found before.
    pub fn full(self) -> Result<Self, StudyError> {
        let (scene, floors) = (&self.scene, &self.floors);
        let model = Model::full(scene, floors)
            .map_err(|error| in_scene(scene, SceneError::of_model(error, (scene, floors))))?;
        Ok(Self { model, ..self })
    }

    /// The same structures under the same record, with another method.
    ///
    /// # Errors
    /// [`StudyError`] when the method does not fit the scene, such as a time step beyond its stability limit.
    pub(crate) fn with_method(&self, other: Method) -> Result<Self, StudyError> {
        let prepared = self.with_any_method(other)?;
        prepared.stable()
    }

    /// Another scene, shaken by a record at hand as it is.
    ///
    /// # Errors
    /// [`StudyError::Scene`] when a value of the scene cannot be modelled.
    pub(crate) fn variant(&self, scene: &Scene, record: Record) -> Result<Self, StudyError> {
        let in_scene = |source| in_scene(scene, source);
        check::scene(scene).map_err(in_scene)?;
        let (floors, model) = modelled(scene).map_err(in_scene)?;
        let varied = Self {
            scene: scene.clone(),
            floors,
            model,
            record: Arc::new(record),
            ..self.clone()
        };
        varied.with_any_method(scene.method)
    }

    /// The same floors, none of which can touch another: every building alone. Places of floors in the row stay what they
    /// are.
    ///
    /// # Errors
    /// Those of the model with its pairs, which were found before.
    pub(crate) fn apart(&self) -> Result<Self, StudyError> {
        let scene = Scene {
            contacts: None,
            ..self.scene.clone()
        };
        let floors = self.floors.apart();
        let model = Model::new(&scene, &floors)
            .map_err(|error| in_scene(&scene, SceneError::of_model(error, (&scene, &floors))))?;
        Ok(Self {
            scene,
            floors,
            model,
            ..self.clone()
        })
    }

    /// Refuses a time step beyond the limit of stability.
    fn stable(self) -> Result<Self, StudyError> {
        match self.unstable {
            Some(source) => Err(in_scene(&self.scene, source)),
            None => Ok(self),
        }
    }

    /// The same structures under the same record, with another method, also with one that is unstable.
    ///
    /// # Errors
    /// [`StudyError`] when the duration is not a whole number of time steps.
    pub(crate) fn with_any_method(&self, other: Method) -> Result<Self, StudyError> {
        let mut scene = self.scene.clone();
        scene.method = other;
        check::check_method(&scene).map_err(|source| in_scene(&scene, source))?;
        let integrator = other.integrator();
        integrator.check().map_err(|error| self.ended(error))?;
        Ok(Self {
            clock: other.clock(scene.duration()),
            integrator,
            unstable: check::free_limit(&scene).err(),
            forced: self.forced,
            scene,
            advice: None,
            floors: self.floors.clone(),
            model: self.model.clone(),
            record: self.record.clone(),
            scale: self.scale,
            origin: self.origin.clone(),
            stop: self.stop,
        })
    }

    /// The exact twin: the same structures under the same record, integrated by the exact method.
    ///
    /// # Errors
    /// [`StudyError`] when the duration is out of range.
    pub fn exact(&self) -> Result<Self, StudyError> {
        self.with_method(Method::EXACT)
    }

    /// The scene; where it asks for an accuracy, with the method found for it.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// How the method was found, where the scene asks for an accuracy.
    pub fn advice(&self) -> Option<&Advice> {
        self.advice.as_ref()
    }

    /// Why the time step is refused, in words, where it was [forced](Self::forcing).
    pub fn refusal(&self) -> Option<String> {
        self.unstable.as_ref().map(ToString::to_string)
    }

    /// Of every structure and wall, from the left, the time step \[s\] from which on it grows without bound, though it touch
    /// nobody; nothing for a wall, and for a method without such a limit.
    pub fn critical_time_steps(&self) -> Vec<Option<f64>> {
        self.scene.critical_time_steps().collect()
    }

    /// Duration of the run \[s\].
    pub fn duration(&self) -> f64 {
        self.scene.duration()
    }

    /// Whoever sets `stop` ends its runs.
    pub(crate) fn set_stop(&mut self, stop: Option<&'static AtomicBool>) {
        self.stop = stop;
    }

    /// What a run may cost.
    pub(crate) fn budget(&self) -> Budget {
        self.scene.budget.of_run(self.stop)
    }

    /// Whether the scene was [forced](Self::forcing).
    pub(crate) fn is_forced(&self) -> bool {
        self.forced
    }

    /// The method that runs.
    pub(crate) fn method(&self) -> Method {
        self.scene.method
    }

    /// The floors and walls of its structures, in the order in which a run counts them.
    pub fn floors(&self) -> &Floors {
        &self.floors
    }

    /// Of every floor, whether it is a wall.
    pub fn walls(&self) -> Vec<bool> {
        self.floors.all().iter().map(Floor::is_wall).collect()
    }

    /// Whether some columns yield smoothly.
    pub(crate) fn yields_smoothly(&self) -> bool {
        matches!(self.model, Model::Mixed(_))
    }

    /// The record as the scene uses it: in m/s², scaled, reversed.
    pub fn record(&self) -> &Record {
        &self.record
    }

    /// What the source of the record was multiplied by, all scales together \[–\]; without the sign of a reversal.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The file that the record came from; nothing for one from a formula.
    pub fn origin(&self) -> Option<&Origin> {
        self.origin.as_deref()
    }

    /// The same scene under a record that `change` makes of its own.
    ///
    /// # Errors
    /// [`StudyError::Scene`] when `change` refuses.
    pub(crate) fn under(
        &self,
        change: impl FnOnce(&Record) -> Result<Record, RecordError>,
    ) -> Result<Self, StudyError> {
        let record = change(&self.record).map_err(|error| in_scene(&self.scene, error.into()))?;
        Ok(Self {
            record: Arc::new(record),
            ..self.clone()
        })
    }
}

/// The floors of a checked scene, and the leanest row of them.
fn modelled(scene: &Scene) -> Result<(Floors, Model), SceneError> {
    let floors = Floors::of(scene)?;
    let model = Model::new(scene, &floors)
        .map_err(|error| SceneError::of_model(error, (scene, &floors)))?;
    Ok((floors, model))
}

pub(crate) fn in_scene(scene: &Scene, source: SceneError) -> StudyError {
    StudyError::Scene {
        scene: scene.name.clone(),
        source,
    }
}
