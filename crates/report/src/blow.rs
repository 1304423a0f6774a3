//! How hard pairs of floors touch.

use std::cmp::Ordering;

use pounding_scene::RunResult;

/// How hard a pair of floors touches: a force tells it best, of impacts the speed of approach, and the impulse where a method knows neither.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Blow {
    /// Peak force \[N\].
    pub force: Option<f64>,
    /// Largest approach speed \[m/s\].
    pub speed: Option<f64>,
    /// Largest impulse \[N·s\].
    pub impulse: f64,
    /// Index of the pair.
    pub pair: usize,
}

impl Blow {
    /// Of every pair that touches, the hardest first.
    pub fn all(outcome: &RunResult) -> Vec<Self> {
        let mut pairs: Vec<usize> = outcome.collisions.all().iter().map(|one| one.pair).collect();
        pairs.sort_unstable();
        pairs.dedup();
        let blow = |pair: usize| {
            let of_pair = outcome.of_pair(pair);
            let speeds = outcome.collisions_of(pair);
            Some(Self {
                force: of_pair.peak_force.map(|force| force.value),
                speed: speeds.filter_map(|one| one.approach_speed).reduce(f64::max),
                impulse: of_pair.largest?.impulse,
                pair,
            })
        };
        let mut all: Vec<Self> = pairs.into_iter().filter_map(blow).collect();
        all.sort_by(|one, other| other.partial_cmp(one).unwrap_or(Ordering::Equal));
        all
    }
}
