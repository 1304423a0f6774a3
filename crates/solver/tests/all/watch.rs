//! Runs whose recorder is known at run time alone: every type of recorder would compile all methods for all columns anew.
use pounding_solver::{
    Clock, Excitation, Hysteretic, Impact, Integrator, Recorder, Row, RunError, Span, Touch, Work,
};

/// A [`Recorder`] without its constant, which trait objects cannot have.
trait Sees {
    fn sees_span(&mut self, span: &Span<'_>);
    fn sees_impact(&mut self, impact: &Impact);
    fn sees_touch(&mut self, touch: &Touch);
}

impl<R: Recorder> Sees for R {
    fn sees_span(&mut self, span: &Span<'_>) {
        self.span(span);
    }
    fn sees_impact(&mut self, impact: &Impact) {
        self.impact(impact);
    }
    fn sees_touch(&mut self, touch: &Touch) {
        self.touch(touch);
    }
}

/// Any recorder, with the constant that it had.
struct Any<'a, const READS_WEIGHED: bool>(&'a mut dyn Sees);

impl<const READS_WEIGHED: bool> Recorder for Any<'_, READS_WEIGHED> {
    const READS_WEIGHED: bool = READS_WEIGHED;

    fn span(&mut self, span: &Span<'_>) {
        self.0.sees_span(span);
    }
    fn impact(&mut self, impact: &Impact) {
        self.0.sees_impact(impact);
    }
    fn touch(&mut self, touch: &Touch) {
        self.0.sees_touch(touch);
    }
}

pub(crate) trait Watch {
    /// [`Integrator::run`], compiled twice per type of columns: for recorders that read weighed impulses and for others.
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
        if R::READS_WEIGHED {
            self.run(row, excitation, clock, &mut Any::<true>(recorder))
        } else {
            self.run(row, excitation, clock, &mut Any::<false>(recorder))
        }
    }
}
