//! Sums of many terms.

/// Sign, exponent and the first 26 digits of a number.
const COARSE: u64 = !0 << 27;

/// A number as two of few digits: products of such numbers have no rounding.
pub(crate) fn split(number: f64) -> [f64; 2] {
    let coarse = f64::from_bits(number.to_bits() & COARSE);
    [coarse, number - coarse]
}

/// A sum, and what its rounding left.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Sum {
    pub(crate) value: f64,
    pub(crate) rest: f64,
}

impl Sum {
    /// With one more term; what is lost is known whichever of the two is larger (D. E. Knuth).
    pub(crate) fn plus(self, term: f64) -> Self {
        let value = self.value + term;
        let taken = value - self.value;
        let lost = (self.value - (value - taken)) + (term - taken);
        Self {
            value,
            rest: self.rest + lost,
        }
    }

    /// Of one number.
    pub(crate) fn of(value: f64) -> Self {
        Self { value, rest: 0.0 }
    }

    /// With the product of two others; only the product of both rests is lost.
    pub(crate) fn plus_product(self, one: Self, other: Self) -> Self {
        let product = one.value * other.value;
        let ([a, b], [c, d]) = (split(one.value), split(other.value));
        let lost = (((a * c - product) + a * d) + b * c) + b * d;
        let mut sum = self.plus(product);
        sum.rest += lost + (one.value * other.rest + one.rest * other.value);
        sum
    }

    /// What it is more than another one.
    pub(crate) fn less(self, other: Self) -> f64 {
        (self.value - other.value) + (self.rest - other.rest)
    }

    /// As one number.
    pub(crate) fn rounded(self) -> f64 {
        self.value + self.rest
    }
}
