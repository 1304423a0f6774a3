//! Sums over the collisions of a pair in lanes.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::PairSums;
use super::books::{Books, Push};
use super::number::{Lanes, Mask};

/// Collisions of a pair so far, counted as in [`Collisions`](pounding_solver::Collisions).
pub(super) struct SceneSum<S: Simd> {
    collisions: Lanes<S>,
    /// Sum of the impulses of the collisions that have ended \[N·s\].
    impulse: Lanes<S>,
    /// Largest impulse of these collisions \[N·s\].
    largest_impulse: Lanes<S>,
    /// Largest pounding force of a compliant pair \[N\].
    peak_force: Lanes<S>,
    /// Lanes with a compliant collision in progress, and its impulse so far \[N·s\].
    open: Mask<S>,
    current: Lanes<S>,
    /// Pounding force and overlap at the node before.
    force: Lanes<S>,
    overlapped: Mask<S>,
    /// Books of compliant contact.
    pub(super) books: Books<S>,
}

impl<S: Simd> SceneSum<S> {
    #[inline(always)]
    pub(super) fn new(simd: S) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let nowhere = Mask::splat(simd, false);
        Self {
            collisions: zero,
            impulse: zero,
            largest_impulse: zero,
            peak_force: zero,
            open: nowhere,
            current: zero,
            force: zero,
            overlapped: nowhere,
            books: Books::new(simd),
        }
    }

    /// Whether, in some lane, a compliant collision may not have ended or an overlap remains.
    #[inline(always)]
    pub(super) fn lingers(&self) -> bool {
        Lanes::any(self.open | self.overlapped)
    }

    /// Force of a compliant pair at the node before \[N\].
    #[inline(always)]
    pub(super) fn last(&self) -> Lanes<S> {
        self.force
    }

    /// Adds the step of a compliant pair to a node; `overlaps` marks the lanes that overlap there.
    #[inline(always)]
    pub(super) fn follow(&mut self, push: Push<S>, overlaps: Mask<S>) {
        let Push { force, impulse, .. } = push;
        let zero = force.like(0.0);
        self.books.follow(push);
        // A clamped force releases neighbours that still overlap, and may push again; others have parted.
        let goes_on = self.open & self.overlapped;
        let ends = self.open & !self.overlapped;
        if Lanes::any(ends) {
            self.impulse = Number::select(ends, self.impulse + self.current, self.impulse);
            self.largest_impulse = self.with_current(ends);
            self.current = Number::select(ends, zero, self.current);
            self.books.close(ends);
        }
        let acts = (self.force + force).exceeds(zero);
        let begins = acts & !goes_on;
        // In the ledger, neighbours that touch again at once have a single collision.
        self.books.doubt(begins & ends);
        let one = zero.like(1.0);
        self.collisions = Number::select(begins, self.collisions + one, self.collisions);
        self.open = goes_on | acts;
        self.current = self.current + impulse;
        self.peak_force = self.peak_force.max(force);
        self.force = force;
        self.overlapped = overlaps;
    }

    /// Adds impulses \[N·s\]; 0 in lanes without an impact.
    #[inline(always)]
    pub(super) fn strike(&mut self, impulse: Lanes<S>) {
        let zero = impulse.like(0.0);
        let hit = impulse.exceeds(zero);
        self.collisions = self.collisions + Number::select(hit, zero.like(1.0), zero);
        self.impulse = Number::select(hit, self.impulse + impulse, self.impulse);
        self.largest_impulse = self.largest_impulse.max(impulse);
    }

    /// The largest impulse, including the present collisions in these lanes.
    #[inline(always)]
    fn with_current(&self, lanes: Mask<S>) -> Lanes<S> {
        let largest = self.largest_impulse.max(self.current);
        Number::select(lanes, largest, self.largest_impulse)
    }

    /// Results of a lane.
    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> PairSums {
        let impulse = Number::select(self.open, self.impulse + self.current, self.impulse);
        PairSums {
            collisions: self.collisions.lane(lane),
            impulse: impulse.lane(lane),
            largest_impulse: self.with_current(self.open).lane(lane),
            peak_force: self.peak_force.lane(lane),
            closing: None,
        }
    }
}
