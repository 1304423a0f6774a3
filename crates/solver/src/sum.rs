//! Sums of many terms.

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

    /// What it is more than another one.
    pub(crate) fn less(self, other: Self) -> f64 {
        (self.value - other.value) + (self.rest - other.rest)
    }

    /// As one number.
    pub(crate) fn rounded(self) -> f64 {
        self.value + self.rest
    }
}
