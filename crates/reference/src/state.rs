/// The vector of unknowns, each number with what rounding took from it.
#[derive(Debug, Clone, Default)]
pub(super) struct State {
    /// The unknowns.
    pub high: Vec<f64>,
    /// What to add to them; below their last digit.
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

    /// Becomes `from` plus an increment, without a loss: many small steps would otherwise round as often.
    pub(super) fn add(&mut self, from: &Self, index: usize, increment: f64) {
        self.put(index, from.high[index], from.low[index] + increment);
    }

    /// Makes an unknown another one plus an increment, without a loss.
    pub(super) fn copy(&mut self, from: usize, to: usize, increment: f64) {
        self.put(to, self.high[from], self.low[from] + increment);
    }

    /// Sets an unknown to a sum.
    fn put(&mut self, index: usize, base: f64, added: f64) {
        let sum = base + added;
        let part = sum - base;
        self.high[index] = sum;
        self.low[index] = (base - (sum - part)) + (added - part);
    }

    /// One unknown less another one, with what rounding took from both.
    pub(super) fn difference(&self, one: usize, other: usize) -> f64 {
        (self.high[one] - self.high[other]) + (self.low[one] - self.low[other])
    }
}

/// How often a pair has bounced just now.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Bounces {
    /// Instant of the last impact \[s\].
    pub last: f64,
    /// Impacts before it that were each within the shortest time of the next.
    pub count: u32,
}
