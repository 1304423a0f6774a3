use crate::{
    CentralDifference, Clock, Exact, Excitation, Newmark, PiecewiseLinear, Recorder, Row, RunError,
    Work, central_difference, exact, newmark,
};

/// A method of time integration with its settings; one file each, one signature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Integrator {
    /// Central difference method, the paper's.
    CentralDifference(CentralDifference),
    /// Newmark's method.
    Newmark(Newmark),
    /// Event-driven integration with power series.
    Exact(Exact),
}

impl Integrator {
    /// Integrates a row from t = 0 to the end of the clock and reports to the recorder.
    ///
    /// # Errors
    /// [`RunError`] for a setting out of range, a response that is no longer finite, or an equilibrium not found.
    pub fn run<Column: PiecewiseLinear, R: Recorder>(
        &self,
        row: &Row<Column>,
        excitation: Excitation<'_>,
        clock: Clock,
        recorder: &mut R,
    ) -> Result<Work, RunError> {
        if !(clock.time_step.is_finite() && clock.time_step > 0.0) {
            return Err(RunError::Setting {
                setting: "time_step",
                found: clock.time_step,
                allowed: "a finite number > 0",
            });
        }
        match *self {
            Self::CentralDifference(settings) => {
                central_difference::run(settings, row, excitation, clock, recorder)
            }
            Self::Newmark(settings) => newmark::run(settings, row, excitation, clock, recorder),
            Self::Exact(settings) => exact::run(settings, row, excitation, clock, recorder),
        }
    }
}
