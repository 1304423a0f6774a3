//! Numbers of several scenes in lanes.
//!
//! Loops over lanes are written out: a closure that is not inlined cannot use lane instructions.

use std::fmt;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use fearless_simd::prelude::*;
use pounding_contact::Number;

/// Scenes in a number on the machine with the widest vectors. Other machines use the first of them.
///
/// The number of lanes matches the registers of the machine: with eight lanes everywhere, runs on AVX2 take 1.2 to 1.4 times as long.
pub(super) const MOST_LANES: usize = 8;

/// A number of as many scenes as a vector has lanes.
#[derive(Clone, Copy)]
pub(super) struct Lanes<S: Simd>(S::f64s);

/// Yes or no for every lane.
#[derive(Clone, Copy)]
pub(super) struct Mask<S: Simd>(S::mask64s);

impl<S: Simd> Lanes<S> {
    /// Lanes of this machine.
    pub(super) const N: usize = {
        assert!(<S::f64s as SimdBase<S>>::LEN <= MOST_LANES, "more lanes than arrays over them have");
        <S::f64s as SimdBase<S>>::LEN
    };

    /// A value in every lane.
    #[inline(always)]
    pub(super) fn splat(simd: S, value: f64) -> Self {
        Self(S::f64s::splat(simd, value))
    }

    /// A value for each lane.
    #[inline(always)]
    pub(super) fn new(simd: S, values: &[f64; MOST_LANES]) -> Self {
        Self(S::f64s::from_slice(simd, &values[..Self::N]))
    }

    /// The value of each lane.
    #[inline(always)]
    pub(super) fn values(&self) -> &[f64] {
        self.0.as_slice()
    }

    /// The value of a lane.
    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> f64 {
        self.0.as_slice()[lane]
    }

    /// Sets the value of a lane.
    #[inline(always)]
    pub(super) fn set(&mut self, lane: usize, value: f64) {
        self.0.as_mut_slice()[lane] = value;
    }

    /// The proof that the machine has the instructions.
    #[inline(always)]
    pub(super) fn token(self) -> S {
        self.0.token()
    }

    /// The lesser of two numbers.
    #[inline(always)]
    pub(super) fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }

    /// The larger of two numbers.
    #[inline(always)]
    pub(super) fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }

    /// Lanes with different values, including those in which either is NaN.
    #[inline(always)]
    pub(super) fn differs(self, other: Self) -> Mask<S> {
        Mask(!self.0.simd_eq(other.0))
    }

    /// Lanes in which this is at least another value.
    #[inline(always)]
    pub(super) fn reaches(self, other: Self) -> Mask<S> {
        Mask(self.0.simd_ge(other.0))
    }
}

impl<S: Simd> Mask<S> {
    /// Yes in every lane, or no in every lane.
    #[inline(always)]
    pub(super) fn splat(simd: S, yes: bool) -> Self {
        Self(S::mask64s::splat(simd, yes))
    }

    /// A bit for every lane, the first lane lowest.
    #[inline(always)]
    pub(super) fn bits(self) -> u64 {
        self.0.to_bitmask()
    }

    /// Whether a lane says yes.
    #[inline(always)]
    pub(super) fn test(self, lane: usize) -> bool {
        (self.bits() >> lane) & 1 == 1
    }
}

impl<S: Simd> BitAnd for Mask<S> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl<S: Simd> BitOr for Mask<S> {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl<S: Simd> Not for Mask<S> {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}

impl<S: Simd> fmt::Debug for Lanes<S> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.values().fmt(formatter)
    }
}

macro_rules! lane_by_lane {
    ($($operator:ident $name:ident)+) => {$(
        impl<S: Simd> $operator for Lanes<S> {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self(self.0.$name(other.0))
            }
        }
    )+};
}
lane_by_lane!(Add add Sub sub Mul mul Div div);

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Simd> Number for Lanes<S> {
    type Mask = Mask<S>;

    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self::splat(self.token(), value)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    fn exceeds(self, other: Self) -> Mask<S> {
        Mask(self.0.simd_gt(other.0))
    }

    #[inline(always)]
    fn any(mask: Mask<S>) -> bool {
        mask.0.any_true()
    }

    #[inline(always)]
    fn select(mask: Mask<S>, yes: Self, no: Self) -> Self {
        Self(mask.0.select(yes.0, no.0))
    }
}
