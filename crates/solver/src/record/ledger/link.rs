//! Energy and impulse of links.

use super::opening::force_of;
use super::{Ledger, LedgerError};
use crate::{Link, Path, Push, Relation, Span};

/// Difference of impulses that rounding explains, relative to the sum of their magnitudes.
const ROUNDING: f64 = 1e-9;

/// Energy and impulse of a link.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LinkTerms {
    /// Energy taken from the floors, ∫ F·δ̇ dt \[J\], including the energy still stored.
    pub energy: f64,
    /// Impulse on the right end \[N·s\], positive to the right; on the left end if the right one is on the ground, with the other sign.
    pub impulse: f64,
}

/// Account of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LinkAccount {
    relation: Relation,
    energy: f64,
    /// Impulses on both ends, and the sums of their magnitudes \[N·s\].
    impulses: [f64; 2],
    magnitude: f64,
}

impl LinkAccount {
    pub(super) fn new(link: &Link) -> Self {
        Self {
            relation: link.relation,
            energy: 0.0,
            impulses: [0.0; 2],
            magnitude: 0.0,
        }
    }

    /// Whether each end is on a floor.
    fn has_two(&self) -> bool {
        self.relation.points().into_iter().all(|point| point.parts().next().is_some())
    }

    pub(super) fn terms(&self) -> LinkTerms {
        let [left, right] = self.impulses;
        LinkTerms {
            energy: self.energy,
            impulse: if self.relation.right.parts().next().is_some() {
                right
            } else {
                -left
            },
        }
    }

    /// Checks that both ends have opposite impulses.
    pub(super) fn balanced(&self, link: usize) -> Result<(), LedgerError> {
        let [left, right] = self.impulses;
        if !self.has_two() || (left + right).abs() <= ROUNDING * self.magnitude {
            return Ok(());
        }
        Err(LedgerError::LinkImbalance { link, left, right })
    }
}

impl Ledger<'_> {
    /// Books the action of a link on a floor over a span.
    pub(super) fn link(&mut self, span: &Span<'_>, push: &Push<'_>) {
        let impulse = push.given(push.impulse);
        let work = match span.path {
            Path::Cubic(_) => 0.5 * (span.start.velocity + span.end.velocity) * impulse,
            Path::Series(_) | Path::Flight(_) => {
                let force = force_of(span, push, false);
                let [work] = span.integrate(|time, state| [push.given(force(time, state)) * state.velocity]);
                work
            }
        };
        let opening = self.opening_work(span, push, self.links[push.pair].relation, false);
        let account = &mut self.accounts[span.structure];
        account.link(impulse, work);
        account.open_link(opening);
        let link = &mut self.links[push.pair];
        link.energy += opening - work;
        link.impulses[usize::from(!push.on_left)] += impulse;
        link.magnitude += impulse.abs();
    }
}
