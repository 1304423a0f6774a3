//! The program behind the paper's numbers: a model of another program, not a method for users.

mod choices;
mod stepping;

use pounding_contact::ContactLaw;
use pounding_motion::Record;
use pounding_scene::{Method, RunResult, Scene, Simulation, Structure};
use pounding_solver::{Clock, Hysteretic, OnRow, Pair, Recorder, Recorders, Row, RunError, TransferredMomentum, Work};
use serde::{Deserialize, Serialize};

pub(crate) use choices::{Choice, Program, Start};
use stepping::Stepping;

/// Makes a study run by the paper's program: it runs the scenes that name the central difference method.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PapersProgram {
    /// Names of the scenes that use the first load; the others skip it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub first_load_used: Vec<String>,
}

impl PapersProgram {
    /// The program that gives the printed numbers of a scene; `None` if the scene names another method.
    pub(crate) fn of(&self, scene: &Scene) -> Option<Program> {
        let is_used = self.first_load_used.contains(&scene.name);
        let start = if is_used { Start::FirstLoadUsed } else { Start::FirstLoadSkipped };
        let stepped = matches!(scene.method, Method::CentralDifference { .. });
        stepped.then(|| Program::printed(start))
    }

    /// A part of a study that the program cannot run or does not know: the value found, and the values allowed.
    pub(crate) fn refusal(&self, scenes: &[Scene], prepared: &[Simulation]) -> Option<(String, &'static str)> {
        for name in &self.first_load_used {
            let runs = |scene: &Scene| scene.name == *name && self.of(scene).is_some();
            if !scenes.iter().any(runs) {
                let allowed = "in `first_load_used` names of scenes of the study by central differences";
                return Some((format!("\"{name}\""), allowed));
            }
        }
        let mut both = scenes.iter().zip(prepared);
        let (scene, _) = both.find(|(scene, prepared)| {
            let is_open = matches!(scene.method, Method::Accuracy(_));
            is_open || (self.of(scene).is_some() && !can_run(scene, prepared))
        })?;
        Some((
            format!("the scene \"{}\"", scene.name),
            "structures of one storey at rest, no walls, no arrivals, stereomechanical impact or the nonlinear viscoelastic element, and a \
             method with a time step that divides the record's, without sub-steps",
        ))
    }
}

fn can_run(scene: &Scene, prepared: &Simulation) -> bool {
    let at_rest = |structure: &Structure| match structure {
        Structure::Sdof(sdof) => sdof.initial_displacement_m == 0.0 && sdof.initial_velocity_m_per_s == 0.0,
        Structure::Building(_) | Structure::Wall => false,
    };
    let is_known = |pair: &Pair| matches!(pair.law, ContactLaw::Stereomechanical(_) | ContactLaw::NonlinearViscoelastic(_));
    let divides = |step: f64| {
        let parts = prepared.record().time_step() / step;
        parts > 0.5 && (parts - parts.round()).abs() < 1e-9
    };
    scene.structures.iter().all(at_rest)
        && scene.arrivals_s.is_none()
        && prepared.pairs().iter().all(is_known)
        && scene.method.contact_substeps() == 1
        && scene.method.time_step().is_some_and(divides)
}

impl Program {
    /// Runs a scene at the time step of its method, with histories at every `interval` \[s\] if there is one. Accelerations of floors are
    /// not recorded.
    ///
    /// # Errors
    /// [`pounding_scene::Error::Run`] if the run diverges.
    pub(crate) fn run(self, prepared: &Simulation, interval: Option<f64>) -> Result<RunResult, pounding_scene::Error> {
        prepared.recorded(interval, |recorders| {
            let Recorders {
                peaks,
                collisions,
                momentum,
                last,
                histories,
                ..
            } = recorders;
            let run = ProgramRun {
                program: self,
                record: prepared.record(),
                clock: prepared.clock(),
                seen: (peaks, collisions, last, histories),
                momentum,
            };
            prepared.on_row(run)?;
            Ok(Work::default())
        })
    }
}

/// A run of a row by the program.
struct ProgramRun<'a, R> {
    program: Program,
    record: &'a Record,
    /// The loaded steps.
    clock: Clock,
    /// The recorder of the pairs' actions, each pair by itself.
    seen: R,
    /// The recorder of the forces that act.
    momentum: &'a mut TransferredMomentum,
}

impl<R: Recorder> OnRow for ProgramRun<'_, R> {
    type Output = Result<(), RunError>;

    fn on<Column: Hysteretic>(mut self, row: &Row<Column>) -> Self::Output {
        let run = Stepping::new(self.program, row, self.clock.time_step);
        run.run(self.record, self.clock, &mut self.seen, self.momentum)
    }
}
