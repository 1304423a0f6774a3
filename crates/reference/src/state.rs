/// A sum, and its rounding error.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sum {
    pub high: f64,
    pub low: f64,
}

impl Sum {
    pub(super) fn of(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// The sum with another term.
    pub(super) fn plus(self, term: f64) -> Self {
        let sum = self.high + term;
        let part = sum - self.high;
        Self {
            high: sum,
            low: self.low + ((self.high - (sum - part)) + (term - part)),
        }
    }

    /// The sum with a product; only the product of both rounding errors is lost.
    pub(super) fn plus_product(self, one: Self, other: Self) -> Self {
        let product = one.high * other.high;
        let lost = one.high.mul_add(other.high, -product);
        let mut sum = self.plus(product);
        sum.low += lost + (one.high * other.low + one.low * other.high);
        sum
    }

    /// This sum minus another sum.
    pub(super) fn less(self, other: Self) -> Self {
        let mut sum = self.plus(-other.high);
        sum.low -= other.low;
        sum
    }

    pub(super) fn rounded(self) -> f64 {
        self.high + self.low
    }
}

/// The vector of unknowns, each with its rounding error.
#[derive(Debug, Clone, Default)]
pub(super) struct State {
    /// The unknowns.
    pub high: Vec<f64>,
    /// Rounding errors of the unknowns, to be added to them.
    pub low: Vec<f64>,
}

impl State {
    pub(super) fn zero(n_unknowns: usize) -> Self {
        Self {
            high: vec![0.0; n_unknowns],
            low: vec![0.0; n_unknowns],
        }
    }

    pub(super) fn set(&mut self, index: usize, value: f64) {
        self.high[index] = value;
        self.low[index] = 0.0;
    }

    pub(super) fn copy_from(&mut self, other: &Self) {
        self.high.copy_from_slice(&other.high);
        self.low.copy_from_slice(&other.low);
    }

    /// Sets an unknown to its value in `from` plus an increment, without rounding: many small steps would otherwise accumulate it.
    pub(super) fn add(&mut self, from: &Self, index: usize, increment: f64) {
        let sum = Sum::of(from.high[index]).plus(from.low[index] + increment);
        self.put_sum(index, sum);
    }

    /// An unknown with its rounding error.
    pub(super) fn sum(&self, index: usize) -> Sum {
        Sum {
            high: self.high[index],
            low: self.low[index],
        }
    }

    /// Sets an unknown to a sum with its rounding error.
    pub(super) fn put_sum(&mut self, index: usize, Sum { high, low }: Sum) {
        (self.high[index], self.low[index]) = (high, low);
    }

    /// Difference of two unknowns, including their rounding errors.
    pub(super) fn difference(&self, one: usize, other: usize) -> f64 {
        (self.high[one] - self.high[other]) + (self.low[one] - self.low[other])
    }
}

/// Recent bounces of a pair.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Bounces {
    /// Instant of the last impact \[s\].
    pub last: f64,
    /// Previous impacts, each within the shortest time of the next one.
    pub count: u32,
}
