//! Mean and deviation of numbers, from the whole sums of their octaves.
//!
//! The sums of an octave are exact, whatever the order of its numbers. Octaves are joined in order of their size, in sums of two numbers
//! with 106 bits. Equal numbers therefore give equal bytes, however threads, shards and parts cut the runs. Sums in blocks of runs would
//! depend on the blocks, and parts could be merged in one order only.

use super::octaves::{Octave, Octaves, Wide};

/// Exponent of the unit: numbers are whole multiples of 2 to this power.
const LEAST_EXPONENT: i32 = -1074;
/// The bit before the fraction of a normal number.
const LEADING: u64 = 1 << 52;

/// Mean and scatter of numbers, both over 2 to the power of `exponent`, or its square: squares of large and small numbers would not fit.
pub(super) struct Moments {
    /// Number of numbers; at most 1e15, which `f64` holds.
    count: f64,
    mean: Sum,
    /// Sum of the squares of deviations from the mean.
    scatter: Sum,
    exponent: i32,
}

impl Moments {
    pub(super) fn of(numbers: &Octaves) -> Self {
        let octaves = || {
            numbers
                .each()
                .map(|(is_negative, exponent, octave)| Centred::of(is_negative, exponent, octave))
        };
        let count = numbers.count() as f64;
        let top = octaves().map(|octave| octave.shift).max().unwrap_or(0);
        let mut sum = Sum::default();
        for octave in octaves() {
            sum = sum.plus(octave.sum(octave.scale(top)));
        }
        let mean = sum.over(count);
        let mut scatter = Sum::default();
        for octave in octaves() {
            scatter = scatter.plus(octave.scatter(octave.scale(top), mean));
        }
        Self {
            count,
            mean,
            scatter,
            exponent: top + LEAST_EXPONENT,
        }
    }

    /// The mean; `None` without numbers.
    pub(super) fn mean(&self) -> Option<f64> {
        (self.count >= 1.0).then(|| libm::scalbn(self.mean.value, self.exponent))
    }

    /// The standard deviation, with n − 1; `None` for fewer than two numbers.
    pub(super) fn deviation(&self) -> Option<f64> {
        (self.count >= 2.0).then(|| {
            let variance = self.scatter.over(self.count - 1.0).value;
            libm::scalbn(variance.sqrt(), self.exponent)
        })
    }
}

/// The numbers of an octave about a whole number between them, in whole multiples of 2 to the power of `shift` units.
struct Centred {
    sign: f64,
    shift: i32,
    count: f64,
    /// The whole number: their mean, rounded down.
    centre: Sum,
    /// Sum of the distances to the centre, each with its sign; less than the number of numbers.
    rest: f64,
    /// Sum of their squares.
    squares: Sum,
}

impl Centred {
    fn of(is_negative: bool, exponent: u32, octave: &Octave) -> Self {
        let count = u128::from(octave.count());
        let (centre, rest) = (octave.sum / count, octave.sum % count);
        // Σ(f − c)² = Σf² − c (Σf + r) for Σf = n c + r.
        let squares = octave.squares.less_product(octave.sum + rest, centre);
        // Subnormal numbers have no leading bit.
        let leading = if exponent == 0 { 0 } else { LEADING };
        Self {
            sign: if is_negative { -1.0 } else { 1.0 },
            shift: i32::try_from(exponent.max(1) - 1).expect("an exponent has 11 bits"),
            count: count as f64,
            centre: Sum::one((centre + u128::from(leading)) as f64),
            rest: rest as f64,
            squares: Sum::whole(squares),
        }
    }

    /// Its unit over that of the largest octave; 0 if it is too small to count.
    fn scale(&self, top: i32) -> f64 {
        self.sign * libm::scalbn(1.0, self.shift - top)
    }

    /// The sum of its numbers.
    fn sum(&self, scale: f64) -> Sum {
        let centres = self.centre.times(Sum::one(self.count));
        centres.plus(Sum::one(self.rest)).scaled(scale)
    }

    /// Σ(x − μ)² = Σ(x − c)² + 2 r (c − μ) + n (c − μ)².
    fn scatter(&self, scale: f64, mean: Sum) -> Sum {
        let away = self.centre.scaled(scale).plus(mean.scaled(-1.0));
        let first = away.times(Sum::one(self.rest)).scaled(2.0 * scale);
        let second = away.times(away).times(Sum::one(self.count));
        self.squares.scaled(scale * scale).plus(first).plus(second)
    }
}

/// A number as a sum of two; the second is the rounding error of the first.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    value: f64,
    rest: f64,
}

impl Sum {
    fn one(value: f64) -> Self {
        Self { value, rest: 0.0 }
    }

    /// A whole number, by words of 32 bits; of the upper 64 bits, fewer than 53 are used.
    fn whole(Wide { low, high }: Wide) -> Self {
        const WORD: u128 = 1 << 32;
        let words = [96, 64, 32, 0].map(|shift| (low >> shift) % WORD);
        let next = |sum: Self, word: u128| sum.scaled(WORD as f64).plus(Self::one(word as f64));
        words.into_iter().fold(Self::one(high as f64), next)
    }

    /// A sum whose first number is the larger one, with the rounding error of adding both.
    fn tidy(value: f64, rest: f64) -> Self {
        let sum = value + rest;
        Self {
            value: sum,
            rest: rest - (sum - value),
        }
    }

    /// Two numbers of any size, without loss (D. E. Knuth).
    fn added(one: f64, other: f64) -> Self {
        let value = one + other;
        let taken = value - one;
        Self {
            value,
            rest: (one - (value - taken)) + (other - taken),
        }
    }

    fn plus(self, other: Self) -> Self {
        let (sum, rests) = (Self::added(self.value, other.value), Self::added(self.rest, other.rest));
        let sum = Self::tidy(sum.value, sum.rest + rests.value);
        Self::tidy(sum.value, sum.rest + rests.rest)
    }

    fn times(self, other: Self) -> Self {
        let product = self.value * other.value;
        let lost = self.value.mul_add(other.value, -product);
        Self::tidy(product, lost + (self.value * other.rest + self.rest * other.value))
    }

    fn over(self, by: f64) -> Self {
        let quotient = self.value / by;
        let left = (-quotient).mul_add(by, self.value) + self.rest;
        Self::tidy(quotient, left / by)
    }

    /// The sum times a power of two.
    fn scaled(self, scale: f64) -> Self {
        Self {
            value: self.value * scale,
            rest: self.rest * scale,
        }
    }
}
