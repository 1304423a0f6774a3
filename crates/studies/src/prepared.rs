//! From a checked scene to the leanest model, and its run.

use std::path::Path;

use pounding_contact::ContactLaw;
use pounding_motion::{Record, RecordError};
use pounding_solver::{
    CentralDifference, Clock, Collisions, Elastic, ElastoPlastic, Exact, Excitation, Hht,
    Histories, Integrator, Ledger, ModelError, MoreauJean, Newmark, Node, Pair, Peaks,
    PiecewiseLinear, Recorder, Rk4, Row, RunError, TransferredMomentum, Verlet, Work,
};

use crate::advice::{Advice, Goal, advise};
use crate::second_route::{self, Fineness, Response, SecondRouteError};
use crate::{Method, Quantity, RecordUse, Scene, SceneError, Structure, StudyError, check};

/// A checked scene, ready to run: the leanest row that models it, its record, clock and integrator.
#[derive(Debug, Clone)]
pub struct Prepared {
    /// The scene; where it asks for an accuracy, with the method found for it.
    scene: Scene,
    /// How that method was found.
    advice: Option<Advice>,
    model: Model,
    record: Record,
    clock: Clock,
    integrator: Integrator,
}

/// The row with the columns it needs: decided once per run.
#[derive(Debug, Clone)]
enum Model {
    Elastic(Row<Elastic>),
    /// Elastic structures among yielding ones get an infinite yield force.
    ElastoPlastic(Row<ElastoPlastic>),
}

/// What a run leaves behind.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Peaks of every structure.
    pub peaks: Peaks,
    /// Collisions of every pair.
    pub collisions: Collisions,
    /// Transferred momentum of every structure.
    pub momentum: TransferredMomentum,
    /// Histories of every structure, where asked for.
    pub histories: Option<Histories>,
    /// What the run cost.
    pub work: Work,
}

impl Prepared {
    /// Checks a scene and reads its record; `base` is the folder of the file that holds the scene.
    ///
    /// A scene that asks for an accuracy is run with every method ([`advise`]), which takes a second or so.
    ///
    /// # Errors
    /// [`StudyError`] when the record cannot be read or a value of the scene cannot be modelled; of a scene that asks
    /// for an accuracy, also when its exact run ends early.
    pub fn new(scene: &Scene, base: &Path) -> Result<Self, StudyError> {
        let in_scene = |source| StudyError::Scene {
            scene: scene.name.clone(),
            source,
        };
        check::scene(scene).map_err(in_scene)?;
        let record = load(&scene.record, base, in_scene)?;
        let model = model(scene).map_err(|error| in_scene(SceneError::of_model(error, scene)))?;
        let Method::Accuracy(error) = scene.method else {
            let (integrator, clock) = method(scene);
            return Ok(Self {
                scene: scene.clone(),
                advice: None,
                model,
                record,
                clock,
                integrator,
            });
        };
        let mut exact = scene.clone();
        exact.method = Method::EXACT;
        let (integrator, clock) = method(&exact);
        let exact = Self {
            scene: exact,
            advice: None,
            model,
            record,
            clock,
            integrator,
        };
        let quantity = Quantity::All;
        let advice = advise(&exact, Goal { error, quantity }, &|| ())?;
        let mut chosen = exact.with_method(advice.best().method)?;
        chosen.advice = Some(advice);
        Ok(chosen)
    }

    /// The same structures under the same record, with another method.
    ///
    /// # Errors
    /// [`StudyError`] when the method does not fit the scene, such as a time step beyond its stability limit.
    pub(crate) fn with_method(&self, other: Method) -> Result<Self, StudyError> {
        let mut scene = self.scene.clone();
        scene.method = other;
        check::check_method(&scene).map_err(|source| StudyError::Scene {
            scene: scene.name.clone(),
            source,
        })?;
        let (integrator, clock) = method(&scene);
        Ok(Self {
            scene,
            advice: None,
            model: self.model.clone(),
            record: self.record.clone(),
            clock,
            integrator,
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

    /// The method that runs.
    pub(crate) fn method(&self) -> Method {
        self.scene.method
    }

    /// Duration of the run \[s\].
    pub(crate) fn duration(&self) -> f64 {
        self.scene.duration_s
    }

    /// Of every structure, from the left, whether it is a wall.
    pub fn walls(&self) -> Vec<bool> {
        let structures = self.scene.structures.iter();
        structures
            .map(|structure| matches!(structure, Structure::Wall))
            .collect()
    }

    /// Whether a pair touches by impulses.
    pub(crate) fn has_impulsive_contact(&self) -> bool {
        let mut contacts = self.scene.contacts.iter().flatten();
        contacts.any(|contact| matches!(contact.law, ContactLaw::Stereomechanical(_)))
    }

    /// The record as the scene uses it: in m/s², scaled, reversed.
    pub fn record(&self) -> &Record {
        &self.record
    }

    /// The same scene under a record that `change` makes of its own.
    ///
    /// # Errors
    /// [`StudyError::Scene`] when `change` refuses.
    pub(crate) fn under(
        &self,
        change: impl FnOnce(&Record) -> Result<Record, RecordError>,
    ) -> Result<Self, StudyError> {
        let record = change(&self.record).map_err(|error| StudyError::Scene {
            scene: self.scene.name.clone(),
            source: error.into(),
        })?;
        Ok(Self {
            record,
            ..self.clone()
        })
    }

    /// Runs the scene; histories with a state every `interval` \[s\] only where asked for.
    ///
    /// # Errors
    /// [`StudyError::Run`] when the run ends early.
    pub fn run(&self, interval: Option<f64>) -> Result<Outcome, StudyError> {
        let (n, pairs) = (self.scene.structures.len(), self.pairs());
        let base = (
            Peaks::new(n),
            Collisions::new(n, pairs),
            TransferredMomentum::new(n),
        );
        let duration = self.clock.time(self.clock.n_steps);
        if let Some(interval) = interval {
            let (peaks, collisions, momentum) = base;
            let mut recorder = (
                peaks,
                collisions,
                momentum,
                Histories::new(n, interval, duration),
            );
            let work = self.integrate(&mut recorder)?;
            let (peaks, collisions, momentum, histories) = recorder;
            Ok(Outcome {
                peaks,
                collisions,
                momentum,
                histories: Some(histories),
                work,
            })
        } else {
            let mut recorder = base;
            let work = self.integrate(&mut recorder)?;
            let (peaks, collisions, momentum) = recorder;
            Ok(Outcome {
                peaks,
                collisions,
                momentum,
                histories: None,
                work,
            })
        }
    }

    /// Runs the scene, whatever its method, by the second route.
    ///
    /// # Errors
    /// [`SecondRouteError`] when the run ends early.
    pub fn second_route(&self, fineness: Fineness) -> Result<Response, SecondRouteError> {
        let excitation = self.excitation();
        let duration = self.clock.time(self.clock.n_steps);
        match &self.model {
            Model::Elastic(row) => second_route::run(row, excitation, duration, fineness),
            Model::ElastoPlastic(row) => second_route::run(row, excitation, duration, fineness),
        }
    }

    /// The pairs that can touch, from left to right.
    pub(crate) fn pairs(&self) -> &[Pair] {
        match &self.model {
            Model::Elastic(row) => row.pairs(),
            Model::ElastoPlastic(row) => row.pairs(),
        }
    }

    /// An empty ledger for a run of the scene.
    pub(crate) fn ledger(&self) -> Ledger<'_> {
        match &self.model {
            Model::Elastic(row) => Ledger::new(row, self.excitation()),
            Model::ElastoPlastic(row) => Ledger::new(row, self.excitation()),
        }
    }

    /// Runs the scene by any method, whatever its own is.
    pub(crate) fn run_by<R: Recorder>(
        &self,
        integrator: &Integrator,
        clock: Clock,
        recorder: &mut R,
    ) -> Result<Work, RunError> {
        let excitation = self.excitation();
        match &self.model {
            Model::Elastic(row) => integrator.run(row, excitation, clock, recorder),
            Model::ElastoPlastic(row) => integrator.run(row, excitation, clock, recorder),
        }
    }

    /// Runs the scene with any recorder.
    fn integrate<R: Recorder>(&self, recorder: &mut R) -> Result<Work, StudyError> {
        self.run_by(&self.integrator, self.clock, recorder)
            .map_err(|error| self.ended(error))
    }

    fn excitation(&self) -> Excitation<'_> {
        Excitation::new(self.record.time_step(), self.record.samples())
            .expect("a record has samples and a time step > 0")
    }

    /// Says in the words of the scene why a run ended early.
    fn ended(&self, source: RunError) -> StudyError {
        let scene = self.scene.name.clone();
        let concerned = match source {
            RunError::Setting {
                setting,
                found,
                allowed,
            } => {
                let place = format!("method.{}.{setting}", self.method().name());
                let source = SceneError::OutOfRange {
                    place,
                    found,
                    allowed,
                };
                return StudyError::Scene { scene, source };
            }
            RunError::Diverged { structure, .. } => structure..structure + 1,
            RunError::NotConverged { first, last, .. }
            | RunError::ImpulsesNotFound { first, last, .. } => first..last + 1,
            RunError::NoProgress { .. } | _ => 0..0,
        };
        let name = |index: usize| (index, self.scene.structures[index].name().to_string());
        StudyError::Run {
            scene,
            structures: concerned.map(name).collect(),
            source,
        }
    }
}

fn load(
    record: &RecordUse,
    base: &Path,
    in_scene: impl Fn(SceneError) -> StudyError,
) -> Result<Record, StudyError> {
    let path = base.join(&record.file);
    let text = match std::fs::read(&path) {
        Ok(text) => text,
        Err(source) => return Err(StudyError::NoRecord { path, source }),
    };
    let file =
        pounding_motion::read(&text).map_err(|source| StudyError::Record { path, source })?;
    let used = file
        .into_record(record.gravity_m_per_s2)
        .and_then(|read| read.scaled(record.scale))
        .map_err(|error| in_scene(error.into()))?;
    Ok(if record.reversed {
        used.reversed()
    } else {
        used
    })
}

fn method(scene: &Scene) -> (Integrator, Clock) {
    let integrator = match scene.method {
        Method::CentralDifference {
            start,
            impacts,
            contact_substeps,
            ..
        } => Integrator::CentralDifference(CentralDifference {
            start,
            impacts,
            contact_substeps,
        }),
        Method::Newmark { beta, gamma, .. } => Integrator::Newmark(Newmark { beta, gamma }),
        Method::Hht { alpha, .. } => Integrator::Hht(Hht { alpha }),
        Method::VelocityVerlet { impacts, .. } => Integrator::Verlet(Verlet { impacts }),
        Method::Rk4 { .. } => Integrator::Rk4(Rk4),
        Method::MoreauJean { theta, .. } => Integrator::MoreauJean(MoreauJean { theta }),
        Method::Exact {
            tolerance,
            simultaneous_impacts,
        } => Integrator::Exact(Exact {
            tolerance,
            simultaneous_impacts,
        }),
        Method::Accuracy(_) => unreachable!("the method for an accuracy is found before"),
    };
    // The exact method asks for the end only.
    let time_step = scene.method.time_step().unwrap_or(scene.duration_s);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "checked: 0 < n < 1e9"
    )]
    let n_steps = (scene.duration_s / time_step).round() as usize;
    (integrator, Clock { time_step, n_steps })
}

fn model(scene: &Scene) -> Result<Model, ModelError> {
    let yields = scene.structures.iter().any(|structure| match structure {
        Structure::Sdof(structure) => structure.yield_force_n.is_some(),
        Structure::Wall => false,
    });
    if yields {
        let column = |stiffness, yield_force: Option<f64>| ElastoPlastic {
            stiffness,
            yield_force: yield_force.unwrap_or(f64::INFINITY),
        };
        row(scene, column).map(Model::ElastoPlastic)
    } else {
        row(scene, |stiffness, _| Elastic { stiffness }).map(Model::Elastic)
    }
}

fn row<Column: PiecewiseLinear>(
    scene: &Scene,
    column: impl Fn(f64, Option<f64>) -> Column,
) -> Result<Row<Column>, ModelError> {
    let node = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => Node {
            initial_displacement: sdof.initial_displacement_m,
            initial_velocity: sdof.initial_velocity_m_per_s,
            ..Node::structure(
                sdof.mass_kg,
                sdof.damping_coefficient(),
                column(sdof.stiffness_n_per_m, sdof.yield_force_n),
            )
        },
        Structure::Wall => Node::wall(column(1.0, None)),
    };
    let contacts = scene.contacts.as_deref().unwrap_or_default();
    let pair = |(left, contact): (usize, &crate::Contact)| Pair {
        left,
        right: left + 1,
        gap: contact.gap_m,
        law: contact.law,
    };
    Row::new(
        scene.structures.iter().map(node).collect(),
        contacts.iter().enumerate().map(pair).collect(),
    )
}
