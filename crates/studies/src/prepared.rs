//! From a checked scene to the leanest model, and its run.

use std::path::Path;

use pounding_motion::Record;
use pounding_solver::{
    CentralDifference, Clock, Collisions, Damping as SolverDamping, Elastic, ElastoPlastic,
    Excitation, Histories, Integrator, ModelError, Newmark, Node, Pair, Peaks, Recorder,
    RestoringForce, Row, RunError, TransferredMomentum, Work,
};

use crate::{Damping, Method, RecordUse, Scene, SceneError, Sdof, Structure, StudyError};

/// A checked scene, ready to run: the leanest row that models it, its record, clock and integrator.
#[derive(Debug, Clone)]
pub struct Prepared {
    name: String,
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
        check(scene).map_err(in_scene)?;
        let record = load(&scene.record, base, in_scene)?;
        let (integrator, clock) = method(scene);
        let model = model(scene).map_err(|error| in_scene(error.into()))?;
        Ok(Self {
            name: scene.name.clone(),
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
        let in_scene = |source| StudyError::Run {
            scene: self.name.clone(),
            source,
        };
        if let Some(interval) = interval {
            let (peaks, collisions, momentum) = base;
            let mut recorder = (
                peaks,
                collisions,
                momentum,
                Histories::new(n, interval, duration),
            );
            let work = self.integrate(&mut recorder).map_err(in_scene)?;
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
            let work = self.integrate(&mut recorder).map_err(in_scene)?;
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

    /// Runs the scene with any recorder.
    fn integrate<R: Recorder>(&self, recorder: &mut R) -> Result<Work, RunError> {
        let excitation = Excitation::new(self.record.time_step(), self.record.samples())
            .expect("a record has samples and a time step > 0");
        match &self.model {
            Model::Elastic(row) => self.integrator.run(row, excitation, self.clock, recorder),
            Model::ElastoPlastic(row) => self.integrator.run(row, excitation, self.clock, recorder),
        }
    }
}

/// Refuses a value that is not `valid`.
fn require(
    valid: bool,
    place: String,
    found: f64,
    allowed: &'static str,
) -> Result<(), SceneError> {
    if valid && found.is_finite() {
        Ok(())
    } else {
        Err(SceneError::OutOfRange {
            place,
            found,
            allowed,
        })
    }
}

const POSITIVE: &str = "a finite number > 0";
const NOT_NEGATIVE: &str = "a finite number >= 0";
const FINITE: &str = "a finite number";

fn check(scene: &Scene) -> Result<(), SceneError> {
    let record = &scene.record;
    let gravity = record.gravity_m_per_s2;
    require(
        gravity > 0.0,
        "record.gravity_m_per_s2".into(),
        gravity,
        POSITIVE,
    )?;
    require(true, "record.scale".into(), record.scale, FINITE)?;
    let dt = scene.method.time_step();
    require(dt > 0.0, "method.time_step_s".into(), dt, POSITIVE)?;
    let steps = scene.duration_s / dt;
    require(
        scene.duration_s > 0.0 && (steps - steps.round()).abs() <= 1e-6 && steps < 1e9,
        "duration_s".into(),
        scene.duration_s,
        "a whole number of time steps (method.time_step_s), at least 1 and fewer than 1e9",
    )?;
    if scene.structures.is_empty() {
        return Err(SceneError::NoStructures);
    }
    for (index, structure) in scene.structures.iter().enumerate() {
        if let Structure::Sdof(structure) = structure {
            check_structure(index, structure)?;
        }
    }
    let Some(contacts) = &scene.contacts else {
        return Ok(());
    };
    let (n_structures, allowed) = (scene.structures.len(), scene.structures.len() - 1);
    if contacts.len() != allowed {
        return Err(SceneError::ContactCount {
            found: contacts.len(),
            allowed,
            n_structures,
        });
    }
    for (index, contact) in contacts.iter().enumerate() {
        require(
            contact.gap_m >= 0.0,
            format!("contacts[{index}].gap_m"),
            contact.gap_m,
            NOT_NEGATIVE,
        )?;
        contact
            .law
            .check()
            .map_err(|error| SceneError::OutOfRange {
                place: format!("contacts[{index}].law.{}", error.parameter),
                found: error.found,
                allowed: error.allowed,
            })?;
    }
    Ok(())
}

fn check_structure(index: usize, structure: &Sdof) -> Result<(), SceneError> {
    let place = |field: &str| format!("structures[{index}].{field}");
    let Sdof {
        mass_kg: m,
        stiffness_n_per_m: k,
        ..
    } = *structure;
    require(m > 0.0, place("mass_kg"), m, POSITIVE)?;
    require(k > 0.0, place("stiffness_n_per_m"), k, POSITIVE)?;
    match structure.damping {
        Damping::Ratio(ratio) => {
            require(ratio >= 0.0, place("damping.ratio"), ratio, NOT_NEGATIVE)?;
        }
        Damping::Rayleigh {
            alpha_per_s,
            beta_s,
        } => {
            require(
                alpha_per_s >= 0.0,
                place("damping.rayleigh.alpha_per_s"),
                alpha_per_s,
                NOT_NEGATIVE,
            )?;
            require(
                beta_s >= 0.0,
                place("damping.rayleigh.beta_s"),
                beta_s,
                NOT_NEGATIVE,
            )?;
        }
    }
    if let Some(force) = structure.yield_force_n {
        require(force > 0.0, place("yield_force_n"), force, POSITIVE)?;
    }
    require(
        true,
        place("initial_displacement_m"),
        structure.initial_displacement_m,
        FINITE,
    )?;
    require(
        true,
        place("initial_velocity_m_per_s"),
        structure.initial_velocity_m_per_s,
        FINITE,
    )
}

fn load(
    record: &RecordUse,
    base: &Path,
    in_scene: impl Fn(SceneError) -> StudyError,
) -> Result<Record, StudyError> {
    let path = base.join(&record.file);
    let text = match std::fs::read(&path) {
        Ok(text) => text,
        Err(source) => return Err(StudyError::Unreadable { path, source }),
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
        Method::CentralDifference { start, .. } => {
            Integrator::CentralDifference(CentralDifference { start })
        }
        Method::Newmark { beta, gamma, .. } => Integrator::Newmark(Newmark { beta, gamma }),
    };
    let time_step = scene.method.time_step();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "checked: 0 < n < 1e9"
    )]
    let n_steps = (scene.duration_s / time_step).round() as usize;
    (integrator, Clock { time_step, n_steps })
}

impl Sdof {
    /// Damping coefficient c \[N·s/m\].
    pub fn damping_coefficient(&self) -> f64 {
        self.damping
            .to_solver()
            .coefficient(self.mass_kg, self.stiffness_n_per_m)
    }

    /// Damping ratio ζ \[–\] of the elastic structure.
    pub fn damping_ratio(&self) -> f64 {
        self.damping
            .to_solver()
            .ratio(self.mass_kg, self.stiffness_n_per_m)
    }

    /// Natural period T = 2π√(m/k) \[s\].
    pub fn period(&self) -> f64 {
        2.0 * std::f64::consts::PI * (self.mass_kg / self.stiffness_n_per_m).sqrt()
    }
}

impl Damping {
    fn to_solver(self) -> SolverDamping {
        match self {
            Self::Ratio(ratio) => SolverDamping::Ratio(ratio),
            Self::Rayleigh {
                alpha_per_s,
                beta_s,
            } => SolverDamping::Rayleigh {
                alpha: alpha_per_s,
                beta: beta_s,
            },
        }
    }
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

fn row<Column: RestoringForce>(
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
