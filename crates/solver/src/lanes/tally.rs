//! What is counted of the collisions of a pair, side by side.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::number::{Lanes, Mask};

/// Collisions of a pair so far, as [`Collisions`](crate::Collisions) counts them.
pub(super) struct Tally<S: Simd> {
    pub(super) collisions: Lanes<S>,
    /// Sum of the impulses of the collisions that have ended \[N·s\].
    impulse: Lanes<S>,
    /// Largest pounding force of a compliant pair \[N\].
    pub(super) peak_force: Lanes<S>,
    /// Where a compliant collision goes on, and its impulse so far \[N·s\].
    open: Mask<S>,
    current: Lanes<S>,
    /// Pounding force, and overlap, at the node before.
    force: Lanes<S>,
    overlapped: Mask<S>,
}

impl<S: Simd> Tally<S> {
    #[inline(always)]
    pub(super) fn new(simd: S) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let nowhere = Mask::splat(simd, false);
        Self {
            collisions: zero,
            impulse: zero,
            peak_force: zero,
            open: nowhere,
            current: zero,
            force: zero,
            overlapped: nowhere,
        }
    }

    /// Whether a compliant collision of some lane may not have ended, or does an overlap.
    #[inline(always)]
    pub(super) fn lingers(&self) -> bool {
        Lanes::any(self.open | self.overlapped)
    }

    /// Takes the force of a compliant pair at a node \[N\], and where it overlaps there; `half_step` is half a time step \[s\].
    #[inline(always)]
    pub(super) fn follow(&mut self, force: Lanes<S>, overlaps: Mask<S>, half_step: f64) {
        let zero = force.like(0.0);
        // A clamped force lets go of neighbours that overlap, and may push again; others have parted.
        let goes_on = self.open & self.overlapped;
        let ends = self.open & !self.overlapped;
        if Lanes::any(ends) {
            self.impulse = Number::select(ends, self.impulse + self.current, self.impulse);
            self.current = Number::select(ends, zero, self.current);
        }
        let sum = self.force + force;
        let acts = sum.exceeds(zero);
        let begins = acts & !goes_on;
        let one = zero.like(1.0);
        self.collisions = Number::select(begins, self.collisions + one, self.collisions);
        self.open = goes_on | acts;
        self.current = self.current + zero.like(half_step) * sum;
        self.peak_force = self.peak_force.max(force);
        self.force = force;
        self.overlapped = overlaps;
    }

    /// Takes impulses \[N·s\]; 0 where there is none.
    #[inline(always)]
    pub(super) fn strike(&mut self, impulse: Lanes<S>) {
        let zero = impulse.like(0.0);
        let hit = impulse.exceeds(zero);
        self.collisions = self.collisions + Number::select(hit, zero.like(1.0), zero);
        self.impulse = Number::select(hit, self.impulse + impulse, self.impulse);
    }

    /// Sum of the impulses of all collisions \[N·s\].
    #[inline(always)]
    pub(super) fn impulse(&self) -> Lanes<S> {
        Number::select(self.open, self.impulse + self.current, self.impulse)
    }
}
