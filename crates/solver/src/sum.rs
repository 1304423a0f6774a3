//! Sums of many terms without loss of digits.

/// Sign, exponent and the first 26 digits of a number.
const COARSE: u64 = !0 << 27;

/// A number as a sum of two numbers with few digits: products of such numbers have no rounding.
pub(crate) fn split(number: f64) -> [f64; 2] {
    let coarse = f64::from_bits(number.to_bits() & COARSE);
    [coarse, number - coarse]
}

/// A sum, and its rounding error.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Sum {
    pub(crate) value: f64,
    pub(crate) rest: f64,
}

impl Sum {
    /// The sum with another term. The rounding error is found for either order of magnitude (D. E. Knuth).
    pub(crate) fn plus(self, term: f64) -> Self {
        let value = self.value + term;
        let taken = value - self.value;
        let lost = (self.value - (value - taken)) + (term - taken);
        Self {
            value,
            rest: self.rest + lost,
        }
    }

    /// The sum of a single number.
    pub(crate) fn of(value: f64) -> Self {
        Self { value, rest: 0.0 }
    }

    /// The sum with the product of two others. Only the product of both rounding errors is lost.
    pub(crate) fn plus_product(self, one: Self, other: Self) -> Self {
        let product = one.value * other.value;
        let ([a, b], [c, d]) = (split(one.value), split(other.value));
        let lost = (((a * c - product) + a * d) + b * c) + b * d;
        let mut sum = self.plus(product);
        sum.rest += lost + (one.value * other.rest + one.rest * other.value);
        sum
    }

    /// This sum minus another sum.
    pub(crate) fn less(self, other: Self) -> f64 {
        (self.value - other.value) + (self.rest - other.rest)
    }

    /// The sum as a single number.
    pub(crate) fn rounded(self) -> f64 {
        self.value + self.rest
    }
}
