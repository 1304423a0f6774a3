//! Mean and deviation of numbers, from whole numbers of any length, each rounded once.
//!
//! The sums of an octave fit into 192 bits. Sums over all octaves do not: numbers reach from 2⁻¹⁰⁷⁴ to 2¹⁰²⁴. Sums of two floating-point
//! numbers need twice the code, and lose numbers below 2⁻¹⁰⁶ of the largest. Sums in blocks of runs would depend on the blocks, and parts
//! could be merged in one order only.

use num_bigint::{BigInt, BigUint};

use super::octaves::{Octave, Octaves, Wide};

/// Numbers are whole multiples of 2 to this power, squares of 2 to twice this power.
const LEAST_EXPONENT: i64 = -1074;
/// The bit before the fraction of a normal number.
const LEADING: u64 = 1 << 52;

/// Sums of numbers and of their squares.
#[derive(Default)]
pub(super) struct Sums {
    count: u64,
    /// In multiples of the smallest number.
    sum: BigInt,
    /// In multiples of its square.
    squares: BigUint,
}

impl Sums {
    pub(super) fn of(numbers: &Octaves) -> Self {
        let mut sums = Self::default();
        for (is_negative, exponent, octave) in numbers.each() {
            sums.add(is_negative, exponent, octave);
        }
        sums
    }

    fn add(&mut self, is_negative: bool, exponent: u32, octave: &Octave) {
        let count = octave.count();
        // Subnormal numbers have no leading bit.
        let leading = if exponent == 0 { 0 } else { LEADING };
        let shift = exponent.max(1) - 1;
        let fractions = BigUint::from(octave.sum);
        let Wide { low, high } = octave.squares;
        // (leading + fraction)², summed.
        let squares = (BigUint::from(high) << 128_u32) + low + BigUint::from(2 * leading) * &fractions;
        let squares = squares + BigUint::from(leading) * leading * count;
        let sum = BigInt::from(fractions + BigUint::from(leading) * count) << shift;
        self.count += count;
        self.sum += if is_negative { -sum } else { sum };
        self.squares += squares << (2 * shift);
    }

    /// The sums of the numbers and of their squares.
    #[cfg(test)]
    pub(super) fn digits(&self) -> (&BigInt, &BigUint) {
        (&self.sum, &self.squares)
    }

    /// The mean; `None` without numbers.
    pub(super) fn mean(&self) -> Option<f64> {
        let (mean, exponent) = rounded(self.sum.magnitude(), &self.count.into())?;
        let mean = scaled(mean, exponent + LEAST_EXPONENT);
        Some(if self.sum < BigInt::default() { -mean } else { mean })
    }

    /// The standard deviation, with n − 1; `None` for fewer than two numbers.
    pub(super) fn deviation(&self) -> Option<f64> {
        let n = BigUint::from(self.count);
        let sum = self.sum.magnitude();
        // n Σx² − (Σx)² is not negative.
        let scatter = &n * &self.squares - sum * sum;
        let divisor = &n * BigUint::from(self.count.checked_sub(1)?);
        let (variance, exponent) = rounded(&scatter, &divisor)?;
        // The root of an even power of two is a power of two.
        let odd = exponent.rem_euclid(2);
        let variance = scaled(variance, odd);
        Some(scaled(variance.sqrt(), (exponent - odd) / 2 + LEAST_EXPONENT))
    }
}

/// A quotient to 53 bits, and the power of two by which to multiply it; `None` for a division by zero.
fn rounded(number: &BigUint, by: &BigUint) -> Option<(f64, i64)> {
    if *by == BigUint::default() {
        return None;
    }
    let bits = |number: &BigUint| i64::try_from(number.bits()).expect("it fits into memory");
    // A quotient of 63 or 64 bits.
    let shift = 63 - bits(number) + bits(by);
    let (left, right) = (shift.max(0).unsigned_abs(), (-shift).max(0).unsigned_abs());
    let (number, by) = (number << left, by << right);
    let quotient = &number / &by;
    let is_exact = &quotient * &by == number;
    let digits = u64::try_from(quotient).expect("at most 64 bits");
    // The remainder only decides ties.
    Some(((digits | u64::from(!is_exact)) as f64, -shift))
}

/// A number times a power of two.
fn scaled(number: f64, exponent: i64) -> f64 {
    let bounded = exponent.clamp(-10_000, 10_000);
    libm::scalbn(number, i32::try_from(bounded).expect("it is bounded"))
}
