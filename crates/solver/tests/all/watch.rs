//! Runs whose recorder is known only at run time: otherwise every type of recorder would compile all methods for all columns.
use pounding_solver::{Clock, Excitation, Hysteretic, Impact, Integrator, Recorder, Row, RunError, Span, Touch, Work};

/// Any recorder.
struct Any<'a>(&'a mut dyn Recorder);

impl Recorder for Any<'_> {
    fn reads_weighed(&self) -> bool {
        self.0.reads_weighed()
    }
    fn span(&mut self, span: &Span<'_>) {
        self.0.span(span);
    }
    fn impact(&mut self, impact: &Impact) {
        self.0.impact(impact);
    }
    fn touch(&mut self, touch: &Touch) {
        self.0.touch(touch);
    }
}

pub(crate) trait Watch {
    /// [`Integrator::run`], compiled once per type of columns.
    fn watch<Column: Hysteretic, R: Recorder>(
        &self,
        row: &Row<Column>,
        excitation: Excitation<'_>,
        clock: Clock,
        recorder: &mut R,
    ) -> Result<Work, RunError>;
}

impl Watch for Integrator {
    fn watch<Column: Hysteretic, R: Recorder>(
        &self,
        row: &Row<Column>,
        excitation: Excitation<'_>,
        clock: Clock,
        recorder: &mut R,
    ) -> Result<Work, RunError> {
        self.run(row, excitation, clock, &mut Any(recorder))
    }
}
