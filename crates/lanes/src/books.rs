//! Books of the compliant contact of pairs in lanes, for a verdict: no push may pull, and no collision may create energy.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::number::{Lanes, Mask};

/// Rounding between these sums and those of a [`Ledger`](pounding_solver::Ledger), relative to the energies. A scene this close to
/// violating a law is doubted, and decided by a run of the scene alone.
const ROUNDING: f64 = 1e-9;

/// The energy of the present collision, evaluated as in the ledger: impulses of a step times the mean of the rates at its ends.
pub(super) struct Books<S: Simd> {
    /// Impulse of the step before \[N·s\], and the approach rate at its start \[m/s\].
    impulse: Lanes<S>,
    rate: Lanes<S>,
    /// Steps with a push, and the energies taken from the structures and given back \[J\].
    n_steps: Lanes<S>,
    taken: Lanes<S>,
    given: Lanes<S>,
    doubtful: Mask<S>,
}

/// A step of a compliant pair.
#[derive(Clone, Copy)]
pub(super) struct Push<S: Simd> {
    /// Pounding force at its end \[N\].
    pub(super) force: Lanes<S>,
    /// Impulse \[N·s\].
    pub(super) impulse: Lanes<S>,
    /// Approach rate at its start \[m/s\].
    pub(super) rate: Lanes<S>,
}

impl<S: Simd> Books<S> {
    #[inline(always)]
    pub(super) fn new(simd: S) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        Self {
            impulse: zero,
            rate: zero,
            n_steps: zero,
            taken: zero,
            given: zero,
            doubtful: Mask::splat(simd, false),
        }
    }

    /// Books a step and, with the rate at its start, the energy of the step before.
    #[inline(always)]
    pub(super) fn follow(&mut self, push: Push<S>) {
        let zero = push.force.like(0.0);
        let work = self.impulse * zero.like(0.5) * (self.rate + push.rate);
        self.taken = self.taken + work.max(zero);
        self.given = self.given + (-work).max(zero);
        let pushed = self.impulse.differs(zero);
        self.n_steps = self.n_steps + Number::select(pushed, zero.like(1.0), zero);
        // Forces of different signs may have no impulse.
        self.doubtful = self.doubtful | zero.exceeds(push.force);
        (self.impulse, self.rate) = (push.impulse, push.rate);
    }

    /// Closes the books of collisions that have ended: an error of a single step out of n is the nth part.
    #[inline(always)]
    pub(super) fn close(&mut self, ended: Mask<S>) {
        let zero = self.taken.like(0.0);
        let allowed = self.taken + self.taken / self.n_steps;
        let gains = (self.given * zero.like(1.0 + ROUNDING)).exceeds(allowed);
        self.doubtful = self.doubtful | (ended & gains);
        self.taken = Number::select(ended, zero, self.taken);
        self.given = Number::select(ended, zero, self.given);
        self.n_steps = Number::select(ended, zero, self.n_steps);
    }

    /// Marks these lanes as doubtful.
    #[inline(always)]
    pub(super) fn doubt(&mut self, lanes: Mask<S>) {
        self.doubtful = self.doubtful | lanes;
    }

    /// Whether only a run of the scene alone can show that it obeys the laws of mechanics.
    #[inline(always)]
    pub(super) fn is_doubtful(&self, lane: usize) -> bool {
        self.doubtful.test(lane)
    }
}
