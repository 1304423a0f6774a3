//! From a checked scene to the leanest model, and its run.

mod advice;
mod collapse;
pub(crate) mod dampers;
pub(crate) mod floors;
mod longest_blow;
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
use pounding_solver::{AnyRow, Budget, Clock, Elastic, Integrator, LinkLaw, Node};
use pounding_text::Refused;

pub use advice::{Advice, Goal, MethodTrial, QuantityGroup, StepSizes};

pub use collapse::Collapse;
pub use pair_outcome::PairOutcome;
pub use run::{AuditedRun, EnergyBalance, Extras, RunResult};

/// A checked scene, ready to run: the leanest row that models it, its record, clock and integrator.
#[derive(Debug, Clone)]
pub struct Simulation {
    /// The scene. If it asks for an accuracy, it has the method that was found.
    scene: Scene,
    /// Runs by which that method was found.
    advice: Option<Advice>,
    /// Whether it runs even if its time step or its results are refused.
    forced: bool,
    /// Refusal of its time step.
    unstable: Option<Refused>,
    floors: Floors,
    row: AnyRow,
    record: Arc<Record>,
    /// Product of all factors on the source of the record \[–\].
    scale: f64,
    /// File of the record; `None` for a record from a formula.
    origin: Option<Arc<Origin>>,
    clock: Clock,
    integrator: Integrator,
    /// Setting it ends its runs.
    stop: Option<&'static AtomicBool>,
}

impl Simulation {
    /// Changes numbers of structures and contacts, which is all that `change` may set, in a row of structures of one storey under the same
    /// motion. The results have the bits of a scene that is prepared anew. `duration_s` is the duration in the scene. Returns `None` if the
    /// numbers are refused. The simulation must not be used then; preparing the scene gives the refusal.
    pub fn renumber(&mut self, duration_s: Option<f64>, change: impl FnOnce(&mut Scene) -> Option<()>) -> Option<()> {
        let scene = &mut self.scene;
        scene.duration_s = duration_s;
        change(scene)?;
        scene.check().ok()?;
        let duration = scene.duration_under(self.record.duration());
        scene.duration_s = Some(duration);
        scene.check_method().ok()?;
        check::free_limit(scene).ok()?;
        self.floors.renumber(scene).ok()?;
        model::renumber(&mut self.row, scene, &self.floors).ok()?;
        check::linked_limit(scene, &self.row).ok()?;
        self.clock = scene.method.clock(duration);
        Some(())
    }

    /// Makes a simulation of a checked scene with a known method under a ground motion. A time step beyond the limit of stability is kept
    /// as a refusal.
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
            unstable: check::free_limit(scene).and_then(|()| check::linked_limit(scene, &row)).err(),
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

    /// Takes the method that was found for the accuracy of the scene.
    pub(crate) fn advised(self, advice: Advice) -> Result<Self, Error> {
        let mut prepared = self.with_method(advice.best().method)?;
        prepared.advice = Some(advice);
        Ok(prepared)
    }

    /// Refuses a time step beyond the limit of stability.
    pub(crate) fn enforced(mut self) -> Result<Self, Error> {
        self.forced = false;
        self.stable()
    }

    /// Models the scene in full: with columns that remember yielding, and with all neighbours as pairs. The results have the bits of the
    /// lean model, at more cost.
    ///
    /// # Errors
    /// Errors of the lean model, which were found before.
    pub fn full(self) -> Result<Self, Error> {
        let (scene, floors) = (&self.scene, &self.floors);
        let row = model::full(scene, floors).map_err(|error| Error::in_scene(&scene.name, of_model(&error, scene, floors)))?;
        Ok(Self { row, ..self })
    }

    /// Returns the simulation with another method.
    ///
    /// # Errors
    /// [`Error`] if the method does not fit the scene, such as a time step beyond its stability limit.
    pub fn with_method(&self, other: Method) -> Result<Self, Error> {
        let prepared = self.with_any_method(other)?;
        prepared.stable()
    }

    /// Returns the simulation of another scene under a given record, which is not processed again.
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

    /// Returns the simulation of another row of structures under the same motion. The duration is the one that the row asks for.
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

    /// Returns the simulation with every building alone. The indices of floors in the row stay.
    ///
    /// # Errors
    /// Errors of the model with its pairs, which were found before.
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

    /// Returns the simulation without its links. The indices of floors in the row stay.
    ///
    /// # Errors
    /// Errors of the model with its links, which were found before.
    pub fn unlinked(&self) -> Result<Self, Error> {
        if self.scene.links.is_empty() {
            return Ok(self.clone());
        }
        let scene = Scene {
            links: Vec::new(),
            ..self.scene.clone()
        };
        let row =
            model::lean(&scene, &self.floors).map_err(|error| Error::in_scene(&scene.name, of_model(&error, &scene, &self.floors)))?;
        Ok(Self {
            scene,
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

    /// Returns the simulation with another method, even if it is unstable.
    ///
    /// # Errors
    /// [`Error`] if the duration is not a whole number of time steps.
    pub fn with_any_method(&self, other: Method) -> Result<Self, Error> {
        let mut scene = self.scene.clone();
        scene.method = other;
        scene.check_method().map_err(|source| Error::in_scene(&scene.name, source))?;
        let integrator = other.integrator();
        integrator.check().map_err(|error| self.ended(error))?;
        Ok(Self {
            clock: other.clock(scene.duration()),
            integrator,
            unstable: check::free_limit(&scene)
                .and_then(|()| check::linked_limit(&scene, &self.row))
                .err(),
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

    /// Returns the simulation with the exact method.
    ///
    /// # Errors
    /// [`Error`] if the duration is out of range.
    pub fn exact(&self) -> Result<Self, Error> {
        self.with_method(Method::EXACT)
    }

    /// The scene. If it asks for an accuracy, it has the method that was found.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Runs by which the method was found; `None` if the scene does not ask for an accuracy.
    pub fn advice(&self) -> Option<&Advice> {
        self.advice.as_ref()
    }

    /// Refusal of the time step, if the simulation was [forced](crate::SimulationOptions::force).
    pub fn refusal(&self) -> Option<String> {
        self.unstable.as_ref().map(ToString::to_string)
    }

    /// Critical time step of every structure and wall \[s\], from the left. Above it the response grows without bound even if nothing
    /// touches. `None` for a wall, and for a method without such a limit.
    pub fn critical_time_steps(&self) -> Vec<Option<f64>> {
        self.scene.critical_time_steps().collect()
    }

    /// Duration of the run \[s\].
    pub fn duration(&self) -> f64 {
        self.scene.duration()
    }

    /// Setting `stop` ends its runs.
    pub fn set_stop(&mut self, stop: Option<&'static AtomicBool>) {
        self.stop = stop;
    }

    /// Limits on the work of a run.
    pub fn budget(&self) -> Budget {
        self.scene.budget.of_run(self.stop)
    }

    /// Whether the simulation was [forced](crate::SimulationOptions::force).
    pub(crate) fn is_forced(&self) -> bool {
        self.forced
    }

    /// Time steps of a run; a single one for the exact method.
    pub fn clock(&self) -> Clock {
        self.clock
    }

    /// Returns the row that models it.
    pub fn row(&self) -> &AnyRow {
        &self.row
    }

    /// Returns the method for the solver.
    pub fn integrator(&self) -> Integrator {
        self.integrator
    }

    /// The method of a run.
    pub fn method(&self) -> Method {
        self.scene.method
    }

    /// Floors and walls, in the order of the row.
    pub fn floors(&self) -> &Floors {
        &self.floors
    }

    /// For every floor, whether it is a wall.
    pub fn walls(&self) -> Vec<bool> {
        self.floors.all().iter().map(Floor::is_wall).collect()
    }

    /// Whether some columns yield smoothly.
    pub fn yields_smoothly(&self) -> bool {
        matches!(self.row, AnyRow::Mixed(_))
    }

    /// Whether a motion that is twice as strong makes all responses twice as large while nothing touches: nothing yields, slips or hangs
    /// slack, nothing collapses under gravity, and all starts at rest.
    pub fn is_proportional(&self) -> bool {
        let AnyRow::Elastic(row) = &self.row else {
            return false;
        };
        let is_linear = |link: &pounding_solver::Link| matches!(link.law, LinkLaw::Spring(spring) if spring.yield_force.is_infinite());
        let rests = |node: &Node<Elastic>| node.initial_displacement == 0.0 && node.initial_velocity == 0.0;
        !self.floors.has_gravity() && row.links().iter().all(is_linear) && row.nodes().iter().all(rests)
    }

    /// The record as the scene uses it: in m/s², scaled, reversed.
    pub fn record(&self) -> &Record {
        &self.record
    }

    /// Product of all factors on the source of the record \[–\]; a reversal does not change its sign.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// File of the record; `None` for a record from a formula.
    pub fn origin(&self) -> Option<&Origin> {
        self.origin.as_deref()
    }

    /// Returns the simulation under a changed record.
    ///
    /// # Errors
    /// Refusals of `change`.
    pub fn under(&self, change: impl FnOnce(&Record) -> Result<Record, Refused>) -> Result<Self, Error> {
        let record = change(&self.record);
        let record = record.map_err(|refused| Error::in_scene(&self.scene.name, in_setting("record", refused)))?;
        Ok(Self {
            record: Arc::new(record),
            ..self.clone()
        })
    }
}

/// Finds the floors of a checked scene, and the leanest row of them.
fn modelled(scene: &Scene, patience: Patience) -> Result<(Floors, AnyRow), Refused> {
    let floors = Floors::of(scene)?;
    patience.look()?;
    let row = model::lean(scene, &floors).map_err(|error| of_model(&error, scene, &floors))?;
    patience.look()?;
    Ok((floors, row))
}
