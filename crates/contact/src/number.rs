//! The number type of formulas: a single scene, or several scenes in lanes.
//!
//! Everything generic over [`Number`] is always inlined: lane instructions may appear only inside the function that has checked that the
//! machine supports them.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// The number of a single scene (`f64`), or the numbers of several scenes in lanes.
///
/// Formulas that are generic over it are written once for both. A lane gets exactly the bits that its scene gets alone: every operation is
/// that of `f64`, lane by lane. A choice computes both sides and takes one ([`Self::select`]). Before a side that is costly and rarely
/// needed, ask [`Self::any`].
pub trait Number:
    Copy + std::fmt::Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The answer to a question: yes or no for every lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// This value in every lane.
    #[must_use]
    fn like(self, value: f64) -> Self;

    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Whether this is greater than another number; no if either is NaN.
    fn exceeds(self, other: Self) -> Self::Mask;

    /// Whether any lane says yes.
    fn any(mask: Self::Mask) -> bool;

    /// The first value for lanes in which the mask says yes, else the second.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

impl Number for f64 {
    type Mask = bool;

    #[inline(always)]
    fn like(self, value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn exceeds(self, other: Self) -> bool {
        self > other
    }

    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}
