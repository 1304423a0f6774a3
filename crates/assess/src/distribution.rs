//! Quantiles of numbers over many events, and bounds of a probability.

use std::collections::BTreeMap;

use serde::Serialize;

/// A sample is an event beside one of the neighbours that the row may have: the numbers of the event and of the neighbour. All runs of a
/// sample are dependent: both directions of a motion, and all components of a record.
pub type Case = [usize; 2];

/// A number over several samples, in rising order.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Distribution(Vec<f64>);

impl Distribution {
    /// Least number of samples that have quantiles. EN 1998-1, 4.3.3.4.3 (3), takes the mean of as many, and the largest of fewer.
    pub const ENOUGH: usize = 7;

    /// The largest number of each case; `None` if there are no numbers.
    pub fn of_cases(numbers: impl IntoIterator<Item = (Case, f64)>) -> Option<Self> {
        let mut largest: BTreeMap<Case, f64> = BTreeMap::new();
        for (case, number) in numbers {
            let so_far = largest.entry(case).or_insert(number);
            *so_far = so_far.max(number);
        }
        Self::of(largest.into_values())
    }

    /// Sorts numbers; `None` if there are none. NaN counts as the largest.
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        (!sorted.is_empty()).then_some(Self(sorted))
    }

    /// The numbers in rising order; at least one.
    pub fn sorted(&self) -> &[f64] {
        &self.0
    }

    /// Least number that at least this part of all numbers, 0 to 1, does not exceed.
    pub fn quantile(&self, part: f64) -> f64 {
        let n = self.0.len();
        let rank = (1..=n).find(|rank| *rank as f64 >= part * n as f64);
        self.0[rank.unwrap_or(n) - 1]
    }

    /// Least number that half of the numbers do not exceed.
    pub fn median(&self) -> f64 {
        self.quantile(0.5)
    }

    /// Least number that 84 % of the numbers do not exceed: one standard deviation above the median of a normal distribution.
    pub fn p84(&self) -> f64 {
        self.quantile(0.84)
    }

    /// Arithmetic mean.
    pub fn mean(&self) -> f64 {
        self.0.iter().sum::<f64>() / self.0.len() as f64
    }

    /// Whether quantiles of so many numbers mean anything.
    pub fn has_quantiles(&self) -> bool {
        self.0.len() >= Self::ENOUGH
    }

    /// The number that counts: [`Self::p84`], and the largest of fewer than [`Self::ENOUGH`] numbers.
    pub fn upper(&self) -> f64 {
        if self.has_quantiles() { self.p84() } else { self.largest() }
    }

    /// The largest number.
    pub fn largest(&self) -> f64 {
        self.0[self.0.len() - 1]
    }

    /// Counts the numbers that are larger than a limit.
    pub fn count_above(&self, number: f64) -> usize {
        self.0.iter().filter(|one| **one > number).count()
    }

    /// Standard deviation of the natural logarithms of all numbers > 0 \[–\]; `None` if there are fewer than two such numbers.
    pub fn dispersion(&self) -> Option<f64> {
        let logs: Vec<f64> = self.0.iter().filter(|one| **one > 0.0).map(|one| libm::log(*one)).collect();
        let n = logs.len() as f64;
        let mean = logs.iter().sum::<f64>() / n;
        let squares: f64 = logs.iter().map(|log| (log - mean) * (log - mean)).sum();
        (logs.len() > 1).then(|| (squares / (n - 1.0)).sqrt())
    }
}

/// Ratio of the largest second number of every case to its largest first number \[–\]: runs of a case are one sample, so that the peaks of its
/// runs are compared, not run with run. Equal numbers have the ratio 1, also if both are 0; ratios that are not finite are left out.
pub(crate) fn ratios_of_cases(numbers: impl IntoIterator<Item = (Case, [f64; 2])>) -> Vec<(Case, f64)> {
    let mut largest: BTreeMap<Case, [f64; 2]> = BTreeMap::new();
    for (case, both) in numbers {
        let so_far = largest.entry(case).or_insert(both);
        *so_far = [so_far[0].max(both[0]), so_far[1].max(both[1])];
    }
    let ratio = |(case, [first, second]): (Case, [f64; 2])| {
        let equal = first.to_bits() == second.to_bits();
        (case, if equal { 1.0 } else { second / first })
    };
    largest.into_iter().map(ratio).filter(|(_, ratio)| ratio.is_finite()).collect()
}

/// Deviation that a standard normal variable exceeds in 2.5 % of the cases on either side \[–\].
const TWO_SIDED_95: f64 = 1.959_963_984_540_054;

/// Returns the 95 % bounds \[–\] of the probability of an event that occurred in `count` of `of` > 0 independent cases (E. B. Wilson, *J.
/// Am. Stat. Assoc.* 22 (1927) 209). The bounds stay between 0 and 1, and differ even if the event occurred never or always.
pub fn wilson(count: u64, of: u64) -> (f64, f64) {
    wilson_of(count as f64 / of as f64, of)
}

/// Returns the [bounds](wilson) of a probability whose estimate is `share`, of `of` > 0 independent samples. Runs of one sample may differ, so
/// that the share need not be a whole number of samples.
pub fn wilson_of(share: f64, of: u64) -> (f64, f64) {
    let (n, z) = (of as f64, TWO_SIDED_95);
    let whole = 1.0 + z * z / n;
    let centre = (share + z * z / (2.0 * n)) / whole;
    let half = z / whole * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
    // The share lies between the bounds. Rounding may put a bound on the wrong side of 0 or 1.
    ((centre - half).clamp(0.0, share), (centre + half).clamp(share, 1.0))
}

#[cfg(test)]
mod tests {
    use super::{Distribution, TWO_SIDED_95, wilson};

    #[test]
    fn reference_what_is_enough_for_a_part() {
        let ten = Distribution::of((1..=10).rev().map(f64::from)).expect("ten numbers");
        let parts = [0.0, 0.5, 0.84, 0.9, 0.95, 1.0].map(|part| ten.quantile(part));
        let all = [ten.median(), ten.p84(), ten.largest()];
        assert_eq!(format!("{parts:?} {all:?}"), "[1.0, 5.0, 9.0, 9.0, 10.0, 10.0] [5.0, 9.0, 10.0]");
        assert_eq!([0.5, 9.0, 10.0].map(|number| ten.count_above(number)), [10, 1, 0]);
        assert_eq!(Distribution::of([]), None);
    }

    /// The logarithms of e⁻¹, 1 and e are −1, 0 and 1; their standard deviation is 1. A zero has no logarithm.
    #[test]
    fn reference_dispersion() {
        let e = std::f64::consts::E;
        let found = Distribution::of([1.0, e, 1.0 / e, 0.0]).and_then(|all| all.dispersion());
        assert!((found.expect("three numbers") - 1.0).abs() < 1e-12);
        assert_eq!(Distribution::of([2.0, 0.0]).and_then(|all| all.dispersion()), None);
    }

    /// Bounds solve (p − share)² = z² p (1 − p)/n, from which Wilson derived them.
    #[test]
    fn reference_wilson_bounds_solve_their_equation() {
        for (count, of) in [(0, 10), (3, 10), (50, 300), (300, 300)] {
            let share = count as f64 / of as f64;
            let (low, high) = wilson(count, of);
            assert!(low <= share && share <= high);
            for bound in [low, high] {
                let squared = (bound - share) * (bound - share);
                let z = TWO_SIDED_95;
                let allowed = z * z * bound * (1.0 - bound) / of as f64;
                assert!((squared - allowed).abs() < 1e-15, "{count} of {of}: {bound}");
            }
        }
    }
}
