//! Random numbers of a scene that depend on seed and scene number only.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use crate::noise::uniform;

/// The random numbers of one scene.
#[derive(Debug)]
pub(super) struct Random(Pcg64);

impl Random {
    /// The random numbers of scene number `index` of a campaign.
    pub(super) fn new(seed: u64, index: usize) -> Self {
        Self(Pcg64::new(u128::from(seed), index as u128))
    }

    /// A uniform number from `low` to `high`.
    pub(super) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * uniform(&mut self.0)
    }

    /// A number whose logarithm is uniform; `low` > 0.
    pub(super) fn log_within(&mut self, low: f64, high: f64) -> f64 {
        low * libm::pow(high / low, uniform(&mut self.0))
    }

    /// True with this probability.
    pub(super) fn chance(&mut self, probability: f64) -> bool {
        uniform(&mut self.0) < probability
    }

    /// A whole number below `n`, which is small and > 0.
    pub(super) fn below(&mut self, n: usize) -> usize {
        let whole = self.within(0.0, n as f64);
        (0..n).rfind(|&one| one as f64 <= whole).unwrap_or(0)
    }

    /// A random element of a list that is not empty.
    pub(super) fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// A seed for another generator.
    pub(super) fn seed(&mut self) -> u64 {
        self.0.next_u64() >> 32
    }
}
