//! The work that grounds which move towards each other do through contact.

use super::Ledger;
use crate::{Path, Span, State};

impl Ledger<'_> {
    /// Books and returns half the work of grounds that move towards each other, done through the compliant contact of a left
    /// structure and its right neighbour over a span of one of them.
    ///
    /// Of a step it is the impulse times what they came closer by over its duration.
    pub(super) fn opened(&mut self, span: &Span<'_>, left: usize) -> f64 {
        let Some(travel) = &self.travel else {
            return 0.0;
        };
        let nodes = [left, left + 1];
        let on_left = span.structure == left;
        let force = |state: &State| {
            if on_left {
                -state.force_from_right
            } else {
                state.force_from_left
            }
        };
        let impulse = if on_left {
            -span.impulse_from_right
        } else {
            span.impulse_from_left
        };
        if impulse == 0.0 {
            return 0.0;
        }
        let work = match span.path {
            Path::Cubic(_) => {
                let [start, end] = [span.start_time, span.end_time]
                    .map(|time| travel.opening(nodes, time).displacement);
                impulse * ((end - start) / span.duration())
            }
            Path::Series(_) | Path::Flight(_) => {
                let power = |time: f64, state: &State| {
                    [force(state) * travel.opening(nodes, time).velocity]
                };
                let [work] = span.integrate(power);
                work
            }
        };
        self.accounts[span.structure].open_contact(0.5 * work);
        0.5 * work
    }
}
