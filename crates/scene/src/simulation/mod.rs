//! From a checked scene to the leanest model, and its run.

mod advice;
pub(crate) mod floors;
mod model;
mod pair_outcome;
mod refused;
mod run;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::file::budget::Patience;
use crate::file::check;
use crate::ground_motion::SharedMotion;
use crate::settings::in_setting;
use crate::simulation::floors::{Floor, Floors};
use crate::simulation::refused::of_model;
use crate::{Error, Method, Origin, Scene};
use pounding_motion::Record;
use pounding_solver::{AnyRow, Budget, Clock, Integrator};
use pounding_text::Refused;

pub use advice::{Advice, Goal, QuantityGroup, StepSizes, Trial};
pub(crate) use pair_outcome::LEANS;
pub use pair_outcome::PairOutcome;
pub use run::{Audited, Balance, Extras, RunResult};

/// A checked scene, ready to run: the leanest row that models it, its record, clock and integrator.
#[derive(Debug, Clone)]
pub struct Simulation {
    /// The scene; where it asks for an accuracy, with the method found for it.
    scene: Scene,
    /// How that method was found.
    advice: Option<Advice>,
    /// Whether it runs though its time step or its results are refused.
    forced: bool,
    /// Why its time step is refused.
    unstable: Option<Refused>,
    floors: Floors,
    row: AnyRow,
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

impl Simulation {
    /// Gives a row of structures of one storey under the same motion other numbers of structures and contacts, which is all that
    /// `change` may set; the bits are those of the scene prepared anew. Nothing where they are refused: then this is of no more use,
    /// and preparing the scene says why. `duration_s` is what the scene says.
    pub fn renumber(&mut self, duration_s: Option<f64>, change: impl FnOnce(&mut Scene) -> Option<()>) -> Option<()> {
        let scene = &mut self.scene;
        scene.duration_s = duration_s;
        change(scene)?;
        scene.check().ok()?;
        let duration = scene.duration_under(self.record.duration());
        scene.duration_s = Some(duration);
        scene.check_method().ok()?;
        check::free_limit(scene).ok()?;
        self.floors.renumber(scene);
        model::renumber(&mut self.row, scene, &self.floors).ok()?;
        self.clock = scene.method.clock(duration);
        Some(())
    }

    /// A checked scene under a ground motion, whose method is known; [forced](crate::Options::force) or refused where its time step is beyond
    /// the limit of stability.
    pub(crate) fn prepared(
        scene: &Scene,
        motion: SharedMotion,
        stop: Option<&'static AtomicBool>,
        patience: Patience,
    ) -> Result<Self, Error> {
        let in_scene = |refused| Error::in_scene(&scene.name, refused);
        let duration = scene.duration_within(motion.record.duration(), patience);
        let scene = &Scene {
            duration_s: Some(duration.map_err(in_scene)?),
            ..scene.clone()
        };
        scene.check_method().map_err(in_scene)?;
        let (floors, row) = modelled(scene, patience).map_err(in_scene)?;
        let prepared = Self {
            scene: scene.clone(),
            advice: None,
            forced: true,
            unstable: check::free_limit(scene).err(),
            floors,
            row,
            record: motion.record,
            scale: motion.scale,
            origin: motion.origin,
            clock: scene.method.clock(scene.duration()),
            integrator: scene.method.integrator(),
            stop,
        };
        let settings = prepared.integrator.check();
        settings.map_err(|error| prepared.ended(error))?;
        patience.look().map_err(in_scene)?;
        Ok(prepared)
    }

    /// With the method that was found for its accuracy.
    pub(crate) fn advised(self, advice: Advice) -> Result<Self, Error> {
        let mut prepared = self.with_method(advice.best().method)?;
        prepared.advice = Some(advice);
        Ok(prepared)
    }

    /// Not forced: refused where its time step is beyond the limit of stability.
    pub(crate) fn enforced(mut self) -> Result<Self, Error> {
        self.forced = false;
        self.stable()
    }

    /// The same scene modelled in full, whatever it requires: columns that remember their yielding, and all neighbours as
    /// pairs. Its results are those of the lean model to the last bit, at more cost.
    ///
    /// # Errors
    /// Those of the lean model, which were found before.
    pub fn full(self) -> Result<Self, Error> {
        let (scene, floors) = (&self.scene, &self.floors);
        let row = model::full(scene, floors).map_err(|error| Error::in_scene(&scene.name, of_model(&error, scene, floors)))?;
        Ok(Self { row, ..self })
    }

    /// The same structures under the same record, with another method.
    ///
    /// # Errors
    /// [`Error`] when the method does not fit the scene, such as a time step beyond its stability limit.
    pub fn with_method(&self, other: Method) -> Result<Self, Error> {
        let prepared = self.with_any_method(other)?;
        prepared.stable()
    }

    /// Another scene, shaken by a record at hand as it is.
    ///
    /// # Errors
    /// Refuses a value of the scene that cannot be modelled.
    pub fn variant(&self, scene: &Scene, record: Record) -> Result<Self, Error> {
        let in_scene = |refused| Error::in_scene(&scene.name, refused);
        scene.check().map_err(in_scene)?;
        let (floors, row) = modelled(scene, Patience::ENDLESS).map_err(in_scene)?;
        let varied = Self {
            scene: scene.clone(),
            floors,
            row,
            record: Arc::new(record),
            ..self.clone()
        };
        varied.with_any_method(scene.method)
    }

    /// The same motion under another row of structures, as it shakes this one, and for as long as that row asks for.
    ///
    /// # Errors
    /// Refuses a value of the row that cannot be modelled.
    pub fn under_row(&self, row: &Scene) -> Result<Self, Error> {
        let row = Scene {
            record: self.scene.record.clone(),
            duration_s: None,
            ..row.clone()
        };
        let duration_s = Some(row.duration_under(self.record.duration()));
        self.variant(&Scene { duration_s, ..row }, (*self.record).clone())
    }

    /// The same floors, none of which can touch another: every building alone. Places of floors in the row stay what they
    /// are.
    ///
    /// # Errors
    /// Those of the model with its pairs, which were found before.
    pub fn apart(&self) -> Result<Self, Error> {
        let scene = Scene {
            contacts: None,
            ..self.scene.clone()
        };
        let floors = self.floors.apart();
        let row = model::lean(&scene, &floors).map_err(|error| Error::in_scene(&scene.name, of_model(&error, &scene, &floors)))?;
        Ok(Self {
            scene,
            floors,
            row,
            ..self.clone()
        })
    }

    /// Refuses a time step beyond the limit of stability.
    fn stable(self) -> Result<Self, Error> {
        match self.unstable {
            Some(source) => Err(Error::in_scene(&self.scene.name, source)),
            None => Ok(self),
        }
    }

    /// The same structures under the same record, with another method, also with one that is unstable.
    ///
    /// # Errors
    /// [`Error`] when the duration is not a whole number of time steps.
    pub fn with_any_method(&self, other: Method) -> Result<Self, Error> {
        let mut scene = self.scene.clone();
        scene.method = other;
        scene.check_method().map_err(|source| Error::in_scene(&scene.name, source))?;
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
            row: self.row.clone(),
            record: self.record.clone(),
            scale: self.scale,
            origin: self.origin.clone(),
            stop: self.stop,
        })
    }

    /// The exact twin: the same structures under the same record, integrated by the exact method.
    ///
    /// # Errors
    /// [`Error`] when the duration is out of range.
    pub fn exact(&self) -> Result<Self, Error> {
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

    /// Why the time step is refused, in words, where it was [forced](crate::Options::force).
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
    pub fn set_stop(&mut self, stop: Option<&'static AtomicBool>) {
        self.stop = stop;
    }

    /// What a run may cost.
    pub fn budget(&self) -> Budget {
        self.scene.budget.of_run(self.stop)
    }

    /// Whether the scene was [forced](crate::Options::force).
    pub(crate) fn is_forced(&self) -> bool {
        self.forced
    }

    /// The time steps of its run; one for the exact method.
    pub fn clock(&self) -> Clock {
        self.clock
    }

    /// Returns the row that models it.
    pub fn row(&self) -> &AnyRow {
        &self.row
    }

    /// Returns the method that runs, as the solver knows it.
    pub fn integrator(&self) -> Integrator {
        self.integrator
    }

    /// The method that runs.
    pub fn method(&self) -> Method {
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
    pub fn yields_smoothly(&self) -> bool {
        matches!(self.row, AnyRow::Mixed(_))
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
    /// Refuses what `change` refuses.
    pub fn under(&self, change: impl FnOnce(&Record) -> Result<Record, Refused>) -> Result<Self, Error> {
        let record = change(&self.record);
        let record = record.map_err(|refused| Error::in_scene(&self.scene.name, in_setting("record", refused)))?;
        Ok(Self {
            record: Arc::new(record),
            ..self.clone()
        })
    }
}

/// The floors of a checked scene, and the leanest row of them.
fn modelled(scene: &Scene, patience: Patience) -> Result<(Floors, AnyRow), Refused> {
    let floors = Floors::of(scene)?;
    patience.look()?;
    let row = model::lean(scene, &floors).map_err(|error| of_model(&error, scene, &floors))?;
    patience.look()?;
    Ok((floors, row))
}
