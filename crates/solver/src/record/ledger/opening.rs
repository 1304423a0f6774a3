//! Work through contact of grounds that move towards each other.

use super::Ledger;
use crate::span::{Push, value};
use crate::{Path, Relation, Span, State};

impl Ledger<'_> {
    /// Books and returns a floor's share of the work of grounds that move towards each other, through the compliant contact of a pair over
    /// a span.
    ///
    /// For a step it is the impulse times the mean opening rate.
    pub(super) fn opened(&mut self, span: &Span<'_>, push: usize) -> f64 {
        let push = &span.pushes[push];
        if push.impulse == 0.0 {
            return 0.0;
        }
        let relation = self.contacts[push.pair].relation();
        let work = self.opening_work(span, push, relation, is_alone(span, push));
        self.accounts[span.structure].open_contact(work);
        work
    }

    /// A floor's share of the work of grounds that move towards each other, through the force between two points over a span.
    pub(super) fn opening_work(&self, span: &Span<'_>, push: &Push<'_>, relation: Relation, alone: bool) -> f64 {
        let Some(travel) = &self.travel else {
            return 0.0;
        };
        let nodes = relation.points().map(crate::Point::floor);
        let work = match span.path {
            Path::Cubic(_) => {
                let [start, end] = [span.start_time, span.end_time].map(|time| travel.opening(nodes, time).displacement);
                push.impulse * ((end - start) / span.duration())
            }
            Path::Series(_) | Path::Flight(_) => {
                let force = force_of(span, push, alone);
                let power = |time: f64, state: &State| [force(time, state) * travel.opening(nodes, time).velocity];
                let [work] = span.integrate(power);
                work
            }
        };
        let own = push.given(1.0);
        let part = opening_part(relation.pushes().map(|(_, part)| part), own);
        part * work
    }
}

/// A floor's share of the work of both grounds, from its part of the force and the parts of all floors of the pair. The floors on each side
/// share half of the work.
pub(super) fn opening_part(parts: impl Iterator<Item = f64>, own: f64) -> f64 {
    let on_side = parts.filter(|part| (*part < 0.0) == (own < 0.0));
    0.5 * own.abs() / on_side.map(f64::abs).sum::<f64>()
}

/// Work of a push on its floor \[J\]. `together` is the work of all pushes on this side.
pub(super) fn work_of(span: &Span<'_>, push: &Push<'_>, together: f64) -> f64 {
    if is_alone(span, push) {
        return together;
    }
    match span.path {
        Path::Cubic(_) => {
            let mean = 0.5 * (span.start.velocity + span.end.velocity);
            mean * push.given(push.impulse)
        }
        Path::Series(_) | Path::Flight(_) => {
            let force = force_of(span, push, false);
            let [work] = span.integrate(|time, state| [push.given(force(time, state)) * state.velocity]);
            work
        }
    }
}

/// Force of a pair or a link at an instant and a state within a span that is known between its ends \[N\]. The state has the force of a
/// pair that is alone.
pub(super) fn force_of<'a>(span: &'a Span<'_>, push: &'a Push<'_>, is_alone: bool) -> impl Fn(f64, &State) -> f64 {
    move |time, state| match span.path {
        Path::Series(series) if !is_alone => value(push.series, series.x(time)),
        Path::Series(_) | Path::Cubic(_) | Path::Flight(_) if push.on_left => -state.force_from_right,
        Path::Series(_) | Path::Cubic(_) | Path::Flight(_) => state.force_from_left,
    }
}

/// Whether the pair is the only one that pushes the floor to this side, and the floor carries all of its force.
fn is_alone(span: &Span<'_>, push: &Push<'_>) -> bool {
    let on_side = span.pushes.iter().filter(|other| other.on_left == push.on_left);
    push.part >= 1.0 && on_side.count() == 1
}
