//! Vectors of numbers, by the names of the instructions that work on them.

#![expect(
    unsafe_code,
    reason = "instructions are called by name: that is the point of the loop by hand"
)]
#![expect(
    clippy::inline_always,
    reason = "instructions exist only inside the function that found the machine to have them"
)]

use std::arch::x86_64 as cpu;

/// Instructions of this machine, and what they do: there is a value of a type only where the machine has them.
pub(super) trait Vectors: Copy {
    /// As many numbers as a register has room for.
    type Vector: Copy;
    type Mask: Copy;
    const LANES: usize;

    fn all(self, number: f64) -> Self::Vector;
    /// The first [`Self::LANES`] numbers, which there have to be.
    fn load(self, numbers: &[f64]) -> Self::Vector;
    fn store(self, vector: Self::Vector, numbers: &mut [f64]);
    fn add(self, one: Self::Vector, other: Self::Vector) -> Self::Vector;
    fn sub(self, one: Self::Vector, other: Self::Vector) -> Self::Vector;
    fn mul(self, one: Self::Vector, other: Self::Vector) -> Self::Vector;
    fn div(self, one: Self::Vector, other: Self::Vector) -> Self::Vector;
    fn max(self, one: Self::Vector, other: Self::Vector) -> Self::Vector;
    fn min(self, one: Self::Vector, other: Self::Vector) -> Self::Vector;
    fn sqrt(self, vector: Self::Vector) -> Self::Vector;
    fn abs(self, vector: Self::Vector) -> Self::Vector;
    /// Where the one is as large as the other, or larger.
    fn reaches(self, one: Self::Vector, other: Self::Vector) -> Self::Mask;
    fn exceeds(self, one: Self::Vector, other: Self::Vector) -> Self::Mask;
    fn or(self, one: Self::Mask, other: Self::Mask) -> Self::Mask;
    fn and(self, one: Self::Mask, other: Self::Mask) -> Self::Mask;
    fn any(self, mask: Self::Mask) -> bool;
    /// The one where the mask holds, the other where it does not.
    fn select(self, mask: Self::Mask, one: Self::Vector, other: Self::Vector) -> Self::Vector;
    /// What runs with these instructions.
    fn run<T>(self, what: impl FnOnce() -> T) -> T;
}

/// AVX-512 and AVX2, of a machine that was asked.
#[derive(Debug, Clone, Copy)]
pub(super) struct Avx512(());
#[derive(Debug, Clone, Copy)]
pub(super) struct Avx2(());

impl Avx512 {
    pub(super) fn here() -> Option<Self> {
        std::is_x86_feature_detected!("avx512f").then_some(Self(()))
    }
}

impl Avx2 {
    pub(super) fn here() -> Option<Self> {
        std::is_x86_feature_detected!("avx2").then_some(Self(()))
    }
}

macro_rules! operations {
    ($($name:ident($($argument:ident: $of:ident),+) -> $result:ty = $does:expr;)+) => {
        $(
            #[inline(always)]
            fn $name(self, $($argument: Self::$of),+) -> $result {
                // SAFETY: a value of this type says that the machine has the instructions.
                unsafe { $does }
            }
        )+
    };
}

macro_rules! vectors {
    ($machine:ty, $feature:literal, $vector:ty, $mask:ty, $lanes:literal,
     [$set:path, $load:path, $store:path], { $($plain:item)* }, { $($operations:tt)+ }) => {
        impl Vectors for $machine {
            type Vector = $vector;
            type Mask = $mask;
            const LANES: usize = $lanes;

            #[inline(always)]
            fn all(self, number: f64) -> $vector {
                // SAFETY: a value of this type says that the machine has the instructions.
                unsafe { $set(number) }
            }

            #[inline(always)]
            fn load(self, numbers: &[f64]) -> $vector {
                let numbers = &numbers[..$lanes];
                // SAFETY: the machine has the instructions, and there are as many numbers.
                unsafe { $load(numbers.as_ptr()) }
            }

            #[inline(always)]
            fn store(self, vector: $vector, numbers: &mut [f64]) {
                let numbers = &mut numbers[..$lanes];
                // SAFETY: the machine has the instructions, and there is room.
                unsafe { $store(numbers.as_mut_ptr(), vector) }
            }

            $($plain)*

            operations! { $($operations)+ }

            #[inline(always)]
            fn run<T>(self, what: impl FnOnce() -> T) -> T {
                #[target_feature(enable = $feature)]
                fn run<T>(what: impl FnOnce() -> T) -> T {
                    what()
                }
                // SAFETY: a value of this type says that the machine has the instructions.
                unsafe { run(what) }
            }
        }
    };
}

vectors!(
    Avx512, "avx512f", cpu::__m512d, cpu::__mmask8, 8,
    [cpu::_mm512_set1_pd, cpu::_mm512_loadu_pd, cpu::_mm512_storeu_pd],
    {
        // Masks are plain numbers, which have no instructions of AVX-512F.
        #[inline(always)]
        fn or(self, one: cpu::__mmask8, other: cpu::__mmask8) -> cpu::__mmask8 {
            one | other
        }
        #[inline(always)]
        fn and(self, one: cpu::__mmask8, other: cpu::__mmask8) -> cpu::__mmask8 {
            one & other
        }
        #[inline(always)]
        fn any(self, mask: cpu::__mmask8) -> bool {
            mask != 0
        }
    },
    {
        add(one: Vector, other: Vector) -> Self::Vector = cpu::_mm512_add_pd(one, other);
        sub(one: Vector, other: Vector) -> Self::Vector = cpu::_mm512_sub_pd(one, other);
        mul(one: Vector, other: Vector) -> Self::Vector = cpu::_mm512_mul_pd(one, other);
        div(one: Vector, other: Vector) -> Self::Vector = cpu::_mm512_div_pd(one, other);
        max(one: Vector, other: Vector) -> Self::Vector = cpu::_mm512_max_pd(one, other);
        min(one: Vector, other: Vector) -> Self::Vector = cpu::_mm512_min_pd(one, other);
        sqrt(vector: Vector) -> Self::Vector = cpu::_mm512_sqrt_pd(vector);
        abs(vector: Vector) -> Self::Vector = cpu::_mm512_abs_pd(vector);
        reaches(one: Vector, other: Vector) -> Self::Mask =
            cpu::_mm512_cmp_pd_mask::<{ cpu::_CMP_GE_OQ }>(one, other);
        exceeds(one: Vector, other: Vector) -> Self::Mask =
            cpu::_mm512_cmp_pd_mask::<{ cpu::_CMP_GT_OQ }>(one, other);
        select(mask: Mask, one: Vector, other: Vector) -> Self::Vector =
            cpu::_mm512_mask_mov_pd(other, mask, one);
    }
);

vectors!(
    Avx2, "avx2", cpu::__m256d, cpu::__m256d, 4,
    [cpu::_mm256_set1_pd, cpu::_mm256_loadu_pd, cpu::_mm256_storeu_pd],
    {},
    {
        add(one: Vector, other: Vector) -> Self::Vector = cpu::_mm256_add_pd(one, other);
        sub(one: Vector, other: Vector) -> Self::Vector = cpu::_mm256_sub_pd(one, other);
        mul(one: Vector, other: Vector) -> Self::Vector = cpu::_mm256_mul_pd(one, other);
        div(one: Vector, other: Vector) -> Self::Vector = cpu::_mm256_div_pd(one, other);
        max(one: Vector, other: Vector) -> Self::Vector = cpu::_mm256_max_pd(one, other);
        min(one: Vector, other: Vector) -> Self::Vector = cpu::_mm256_min_pd(one, other);
        sqrt(vector: Vector) -> Self::Vector = cpu::_mm256_sqrt_pd(vector);
        abs(vector: Vector) -> Self::Vector = cpu::_mm256_andnot_pd(cpu::_mm256_set1_pd(-0.0), vector);
        reaches(one: Vector, other: Vector) -> Self::Mask =
            cpu::_mm256_cmp_pd::<{ cpu::_CMP_GE_OQ }>(one, other);
        exceeds(one: Vector, other: Vector) -> Self::Mask =
            cpu::_mm256_cmp_pd::<{ cpu::_CMP_GT_OQ }>(one, other);
        or(one: Mask, other: Mask) -> Self::Mask = cpu::_mm256_or_pd(one, other);
        and(one: Mask, other: Mask) -> Self::Mask = cpu::_mm256_and_pd(one, other);
        any(mask: Mask) -> bool = cpu::_mm256_movemask_pd(mask) != 0;
        select(mask: Mask, one: Vector, other: Vector) -> Self::Vector =
            cpu::_mm256_blendv_pd(other, one, mask);
    }
);
