//! Numbers over many runs, as an engineer asks of them.

use serde::Serialize;

/// A number over several runs, in rising order.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Distribution(Vec<f64>);

impl Distribution {
    /// Of some numbers, at least one; what is no number counts as the largest.
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        (!sorted.is_empty()).then_some(Self(sorted))
    }

    /// The numbers in rising order; at least one.
    pub fn sorted(&self) -> &[f64] {
        &self.0
    }

    /// The least of the numbers that at least this part of all, 0 to 1, do not exceed.
    pub fn quantile(&self, part: f64) -> f64 {
        let n = self.0.len();
        let rank = (1..=n).find(|rank| *rank as f64 >= part * n as f64);
        self.0[rank.unwrap_or(n) - 1]
    }

    /// The least number that half of them do not exceed.
    pub fn median(&self) -> f64 {
        self.quantile(0.5)
    }

    /// The least number that 84 % of them do not exceed: one standard deviation above the median of a normal distribution.
    pub fn p84(&self) -> f64 {
        self.quantile(0.84)
    }

    /// The largest number.
    pub fn largest(&self) -> f64 {
        self.0[self.0.len() - 1]
    }

    /// How many of them are larger than this.
    pub fn count_above(&self, number: f64) -> usize {
        self.0.iter().filter(|one| **one > number).count()
    }

    /// Standard deviation of the natural logarithms \[–\], of numbers > 0 alone; `None` of fewer than two such.
    pub fn dispersion(&self) -> Option<f64> {
        let logs: Vec<f64> = self.0.iter().filter(|one| **one > 0.0).map(|one| libm::log(*one)).collect();
        let n = logs.len() as f64;
        let mean = logs.iter().sum::<f64>() / n;
        let squares: f64 = logs.iter().map(|log| (log - mean) * (log - mean)).sum();
        (logs.len() > 1).then(|| (squares / (n - 1.0)).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::Distribution;

    #[test]
    fn reference_what_is_enough_for_a_part() {
        let ten = Distribution::of((1..=10).rev().map(f64::from)).expect("ten numbers");
        let parts = [0.0, 0.5, 0.84, 0.9, 0.95, 1.0].map(|part| ten.quantile(part));
        let all = [ten.median(), ten.p84(), ten.largest()];
        assert_eq!(format!("{parts:?} {all:?}"), "[1.0, 5.0, 9.0, 9.0, 10.0, 10.0] [5.0, 9.0, 10.0]");
        assert_eq!([0.5, 9.0, 10.0].map(|number| ten.count_above(number)), [10, 1, 0]);
        assert_eq!(Distribution::of([]), None);
    }

    /// Of e⁻¹, 1 and e the logarithms are −1, 0 and 1, whose standard deviation is 1; a zero has no logarithm.
    #[test]
    fn reference_dispersion() {
        let e = std::f64::consts::E;
        let found = Distribution::of([1.0, e, 1.0 / e, 0.0]).and_then(|all| all.dispersion());
        assert!((found.expect("three numbers") - 1.0).abs() < 1e-12);
        assert_eq!(Distribution::of([2.0, 0.0]).and_then(|all| all.dispersion()), None);
    }
}
