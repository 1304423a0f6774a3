//! A run of a scene by the paper's program.

use pounding_motion::Record;
use pounding_scene::{RunResult, Simulation};
use pounding_solver::OnRow;
use pounding_solver::{Clock, Hysteretic, Recorder, Recorders, Row, RunError, TransferredMomentum, Work};

use super::choices::Program;
use super::stepping::Run;

impl Program {
    /// Runs a scene at the time step of its method; histories with a state every `interval` \[s\] where asked for. It says nothing of
    /// accelerations of floors.
    ///
    /// # Errors
    /// [`pounding_scene::Error::Run`] when the run diverges.
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
    /// The steps that are loaded.
    clock: Clock,
    /// Is told what pairs do, each for itself.
    seen: R,
    /// Is told the forces that act.
    momentum: &'a mut TransferredMomentum,
}

impl<R: Recorder> OnRow for ProgramRun<'_, R> {
    type Output = Result<(), RunError>;

    fn on<Column: Hysteretic>(mut self, row: &Row<Column>) -> Self::Output {
        let run = Run::new(self.program, row, self.clock.time_step);
        run.run(self.record, self.clock, (&mut self.seen, self.momentum))
    }
}
