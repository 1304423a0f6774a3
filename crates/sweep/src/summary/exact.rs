//! Mean and deviation of numbers by integers of any length, rounded once.

use num_bigint::{BigInt, BigUint};

use super::octaves::{Octave, Octaves};

/// Exponent of the unit: numbers are whole multiples of 2 to this power, squares of 2 to twice this power.
const LEAST_EXPONENT: i64 = -1074;
/// The bit before the fraction of a normal number.
const LEADING: u128 = 1 << 52;

/// Sums of numbers and of their squares.
pub(super) struct Sums {
    count: u64,
    /// Sum in multiples of the unit.
    sum: BigInt,
    /// Sum of squares in multiples of the squared unit.
    squares: BigUint,
}

impl Sums {
    pub(super) fn of(numbers: &Octaves) -> Self {
        let mut sums = Self {
            count: 0,
            sum: BigInt::default(),
            squares: BigUint::default(),
        };
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
        let (low, carried) = octave.squares;
        let squares = (BigUint::from(carried) << 128_u32) + low;
        // (leading + fraction)², summed.
        let squares = squares + (2 * leading) * &fractions + BigUint::from(leading) * leading * count;
        let sum = BigInt::from(fractions + BigUint::from(leading) * count) << shift;
        self.count += count;
        self.sum += if is_negative { -sum } else { sum };
        self.squares += squares << (2 * shift);
    }

    /// The sums of numbers and of squares.
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
        // n Σx² − (Σx)², which is not negative.
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
    let shift = 64 - bits(number) + bits(by) - 1;
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
