//! What a formula is written in: one scene, or several side by side.
//!
//! Everything generic over [`Number`] is inlined always: instructions on several lanes exist only inside the function that has
//! found the machine to have them.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A number of one scene (`f64`), or the same number of several scenes side by side (lanes).
///
/// Formulas that are generic over it are written once for both, and a lane gets the bits that its scene gets alone: every
/// operation is that of `f64`, lane by lane. A choice has both sides computed and takes one ([`Self::select`]); what costs much
/// and is seldom wanted is asked for first ([`Self::any`]).
pub trait Number:
    Copy + std::fmt::Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The answer to a question: of every lane yes or no.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// The same value in every lane of a number like this one.
    #[must_use]
    fn like(self, value: f64) -> Self;

    /// Without its sign.
    #[must_use]
    fn abs(self) -> Self;

    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Where this is more than another; nowhere where one of them is not a number.
    fn exceeds(self, other: Self) -> Self::Mask;

    /// Whether any lane says yes.
    fn any(mask: Self::Mask) -> bool;

    /// The first where the mask says yes, else the second.
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
