//! From a checked scene to the leanest model, and its run.

use std::path::Path;

use pounding_motion::{Record, RecordError};
use pounding_solver::{
    CentralDifference, Clock, Collisions, Elastic, ElastoPlastic, Exact, Excitation, Hht,
    Histories, Integrator, ModelError, MoreauJean, Newmark, Node, Pair, Peaks, PiecewiseLinear,
    Recorder, Rk4, Row, RunError, TransferredMomentum, Verlet, Work,
};

use crate::second_route::{self, Fineness, Response, SecondRouteError};
use crate::{Method, RecordUse, Scene, SceneError, Structure, StudyError, check};

/// A checked scene, ready to run: the leanest row that models it, its record, clock and integrator.
#[derive(Debug, Clone)]
pub struct Prepared {
    name: String,
    /// Names of the structures and walls.
    structures: Vec<String>,
    /// Name of the method, as scene files spell it.
    method: &'static str,
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
    /// # Errors
    /// [`StudyError`] when the record cannot be read or a value of the scene cannot be modelled.
    pub fn new(scene: &Scene, base: &Path) -> Result<Self, StudyError> {
        let in_scene = |source| StudyError::Scene {
            scene: scene.name.clone(),
            source,
        };
        check::scene(scene).map_err(in_scene)?;
        let record = load(&scene.record, base, in_scene)?;
        let (integrator, clock) = method(scene);
        let model = model(scene).map_err(|error| in_scene(SceneError::of_model(error, scene)))?;
        let names = scene.structures.iter().map(Structure::name);
        Ok(Self {
            name: scene.name.clone(),
            structures: names.map(String::from).collect(),
            method: scene.method.name(),
            model,
            record,
            clock,
            integrator,
        })
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
            scene: self.name.clone(),
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
        let (n, pairs) = match &self.model {
            Model::Elastic(row) => (row.nodes().len(), row.pairs()),
            Model::ElastoPlastic(row) => (row.nodes().len(), row.pairs()),
        };
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

    /// Runs the scene with any recorder.
    fn integrate<R: Recorder>(&self, recorder: &mut R) -> Result<Work, StudyError> {
        let excitation = self.excitation();
        match &self.model {
            Model::Elastic(row) => self.integrator.run(row, excitation, self.clock, recorder),
            Model::ElastoPlastic(row) => self.integrator.run(row, excitation, self.clock, recorder),
        }
        .map_err(|error| self.ended(error))
    }

    fn excitation(&self) -> Excitation<'_> {
        Excitation::new(self.record.time_step(), self.record.samples())
            .expect("a record has samples and a time step > 0")
    }

    /// Says in the words of the scene why a run ended early.
    fn ended(&self, source: RunError) -> StudyError {
        let scene = self.name.clone();
        let concerned = match source {
            RunError::Setting {
                setting,
                found,
                allowed,
            } => {
                let place = format!("method.{}.{setting}", self.method);
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
        let name = |index: usize| (index, self.structures[index].clone());
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
