//! Samples of the unit cube; each is found from its index alone.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use sobol::params::JoeKuoD6;
use sobol::{Sobol, SobolParams};

use super::file::{SampleMethod, Samples};
use super::permutation::Permutation;

/// Streams of random numbers from a seed: for the samples, and for the scrambling of a method.
const OF_SAMPLES: u128 = 1;
const OF_SCRAMBLING: u128 = 2;

/// Bits of a coordinate.
const BITS: usize = u64::BITS as usize;

/// Points in the unit cube with a coordinate for each sampled axis.
#[derive(Debug, Clone)]
pub(super) struct Sampler {
    samples: Samples,
    n_axes: usize,
    method: Scrambled,
}

/// Data of a method that are made once from the seed.
#[derive(Debug, Clone)]
enum Scrambled {
    /// Independent numbers.
    Random,
    /// For every axis, the direction numbers and a shift.
    Sobol(Vec<(Vec<u64>, u64)>),
    /// For every axis, the order of its strata.
    LatinHypercube(Vec<Permutation>),
}

/// Most axes of a Sobol sequence.
pub(super) fn most_sobol_axes() -> usize {
    JoeKuoD6::minimal().max_dims()
}

/// A point, and the random numbers after it.
#[derive(Debug, Default)]
pub(super) struct SamplePoint {
    pub(super) coordinates: Vec<f64>,
    /// The index of the next point, with the generator at this position: runs are consecutive, and a jump costs more than a point.
    ahead: Option<(u64, Pcg64)>,
}

impl Sampler {
    /// A sampler for this many axes, for Sobol points at most [`most_sobol_axes`]. There is at least one sample.
    pub(super) fn new(samples: Samples, n_axes: usize) -> Self {
        let mut random = Pcg64::new(u128::from(samples.seed), OF_SCRAMBLING);
        let method = match samples.method {
            SampleMethod::Random => Scrambled::Random,
            SampleMethod::Sobol => Scrambled::Sobol(scrambled_sobol(n_axes, &mut random)),
            SampleMethod::LatinHypercube => {
                let axes = (0..n_axes).map(|_| Permutation::new(samples.count, &mut random));
                Scrambled::LatinHypercube(axes.collect())
            }
        };
        Self { samples, n_axes, method }
    }

    /// Writes the coordinates of the point `index`, each > 0 and < 1.
    pub(super) fn point(&self, index: u64, SamplePoint { coordinates, ahead }: &mut SamplePoint) {
        let to = coordinates;
        to.clear();
        match &self.method {
            Scrambled::Random => {
                let mut random = self.numbers_of(index, ahead);
                to.extend((0..self.n_axes).map(|_| inside(random.next_u64())));
                *ahead = Some((index + 1, random));
            }
            Scrambled::Sobol(axes) => {
                let coordinate = |(directions, shift): &(Vec<u64>, u64)| inside(shift ^ sobol_bits(directions, index));
                to.extend(axes.iter().map(coordinate));
            }
            Scrambled::LatinHypercube(axes) => {
                let mut random = self.numbers_of(index, ahead);
                let n = self.samples.count as f64;
                let largest = 1.0 - f64::EPSILON / 2.0;
                to.extend(axes.iter().map(|order| {
                    let stratum = order.at(index) as f64;
                    ((stratum + inside(random.next_u64())) / n).min(largest)
                }));
                *ahead = Some((index + 1, random));
            }
        }
    }

    /// The random numbers of a point, one for each axis: a piece of a common sequence, to which the generator jumps.
    fn numbers_of(&self, index: u64, ahead: &mut Option<(u64, Pcg64)>) -> Pcg64 {
        if let Some((_, random)) = ahead.take_if(|(next, _)| *next == index) {
            return random;
        }
        let mut random = Pcg64::new(u128::from(self.samples.seed), OF_SAMPLES);
        random.advance(u128::from(index) * self.n_axes as u128);
        random
    }
}

/// A number > 0 and < 1 from random bits: the middle of one among 2⁵² equal parts, because a quantile may be infinite at both ends.
fn inside(bits: u64) -> f64 {
    ((bits >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
}

/// A coordinate of a Sobol point as a binary fraction.
fn sobol_bits(directions: &[u64], index: u64) -> u64 {
    let mut rest = index;
    let mut bits = 0;
    while rest != 0 {
        bits ^= directions[rest.trailing_zeros() as usize];
        rest &= rest - 1;
    }
    bits
}

/// Direction numbers of Joe and Kuo (SIAM J. Sci. Comput. 30 (2008) 2635–2654), each axis multiplied by a random lower triangular matrix,
/// and a random shift (Matoušek, J. Complexity 14 (1998) 527–556). Points remain even, and none is on an edge.
fn scrambled_sobol(n_axes: usize, random: &mut Pcg64) -> Vec<(Vec<u64>, u64)> {
    let directions = Sobol::<u64>::init_direction_vals(n_axes, BITS, &JoeKuoD6::minimal() as &dyn SobolParams<u32>);
    let scrambled = |mut directions: Vec<u64>| {
        let rows: Vec<u64> = (0..BITS).map(|place| row(place, random)).collect();
        for direction in &mut directions {
            let bit = |place: usize| u64::from((*direction & rows[place]).count_ones() & 1) << place;
            *direction = (0..BITS).map(bit).fold(0, |bits, bit| bits | bit);
        }
        (directions, random.next_u64())
    };
    directions.into_iter().map(scrambled).collect()
}

/// The row of a triangular matrix that makes the bit of a place: this bit, and random ones of those above it.
fn row(place: usize, random: &mut Pcg64) -> u64 {
    let own = 1_u64 << place;
    let above = !(own | (own - 1));
    own | (random.next_u64() & above)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn sampler(method: SampleMethod, count: u64, seed: u64) -> Sampler {
        Sampler::new(Samples { count, seed, method }, 3)
    }

    fn points(sampler: &Sampler, count: u64) -> Vec<Vec<f64>> {
        let point = |index| {
            let mut point = SamplePoint::default();
            sampler.point(index, &mut point);
            point.coordinates
        };
        (0..count).map(point).collect()
    }

    /// Index of the equal part, out of `parts`, that contains a number.
    fn part(x: f64, parts: u64) -> u64 {
        (0..parts).rev().find(|part| *part as f64 <= x * parts as f64).unwrap_or(0)
    }

    proptest! {
        #[test]
        fn limit_a_latin_hypercube_meets_every_stratum_once(count in 1_u64..200, seed: u64) {
            let points = points(&sampler(SampleMethod::LatinHypercube, count, seed), count);
            for axis in 0..3 {
                let mut strata: Vec<u64> = points.iter().map(|point| part(point[axis], count)).collect();
                strata.sort_unstable();
                prop_assert!(strata.into_iter().eq(0..count));
            }
        }

        /// 2ᵏ points of a Sobol sequence have one point in each of 2ᵏ equal intervals. On the first two axes they have one in each
        /// rectangle of 2ʲ by 2ᵏ⁻ʲ. This holds for any seed.
        #[test]
        fn limit_sobol_points_are_even(power in 0_u32..9, split in 0_u32..9, seed: u64) {
            let count = 1_u64 << power;
            let points = points(&sampler(SampleMethod::Sobol, count, seed), count);
            for axis in 0..3 {
                let mut strata: Vec<u64> = points.iter().map(|point| part(point[axis], count)).collect();
                strata.sort_unstable();
                prop_assert!(strata.into_iter().eq(0..count));
            }
            let wide = 1_u64 << split.min(power);
            let mut cells: Vec<u64> = points
                .iter()
                .map(|point| part(point[0], wide) * (count / wide) + part(point[1], count / wide))
                .collect();
            cells.sort_unstable();
            prop_assert!(cells.into_iter().eq(0..count));
        }

        #[test]
        fn limit_a_point_depends_on_its_index_alone(index in 0_u64..1_000_000_000, seed: u64) {
            for method in [SampleMethod::Random, SampleMethod::Sobol, SampleMethod::LatinHypercube] {
                let sampler = sampler(method, 1_000_000_000, seed);
                let (mut once, mut again) = (SamplePoint::default(), SamplePoint::default());
                sampler.point(index, &mut once);
                // After another point, and after the previous point.
                for before in [index / 2, index.saturating_sub(1)] {
                    sampler.point(before, &mut again);
                    sampler.point(index, &mut again);
                    prop_assert_eq!(&once.coordinates, &again.coordinates);
                }
                prop_assert!(once.coordinates.iter().all(|x| *x > 0.0 && *x < 1.0));
            }
        }
    }

    /// A point is a piece of a common sequence of numbers, point after point and axis after axis.
    #[test]
    fn limit_random_points_are_one_sequence() {
        let mut random = Pcg64::new(9, OF_SAMPLES);
        let sequence = (0..300).map(|_| inside(random.next_u64()));
        let points = points(&sampler(SampleMethod::Random, 100, 9), 100);
        assert!(points.into_iter().flatten().eq(sequence));
    }

    /// Without scrambling the points are those of the crate, in another order within each power of two.
    #[test]
    fn limit_sobol_points_are_those_of_the_crate() {
        const COUNT: usize = 256;
        let parameters = JoeKuoD6::minimal();
        let mut theirs: Vec<Vec<u64>> = Sobol::<u64>::new(5, &parameters).take(COUNT).collect();
        let parameters = &parameters as &dyn SobolParams<u32>;
        let directions = Sobol::<u64>::init_direction_vals(5, BITS, parameters);
        let point = |index| directions.iter().map(|axis| sobol_bits(axis, index)).collect();
        let mut ours: Vec<Vec<u64>> = (0..COUNT as u64).map(point).collect();
        theirs.sort();
        ours.sort();
        assert_eq!(ours, theirs);
    }

    /// Mean and variance of 100 000 numbers are those of a uniform distribution within five standard deviations, and neighbouring axes and
    /// points are not correlated.
    #[test]
    fn reference_random_points_are_uniform_and_independent() {
        let points = points(&sampler(SampleMethod::Random, 100_000, 3), 100_000);
        let n = points.len() as f64;
        let mean = |of: &dyn Fn(usize) -> f64| (1..points.len()).map(of).sum::<f64>() / n;
        for axis in 0..3 {
            let centred = |index: usize, axis: usize| points[index][axis] - 0.5;
            assert!(mean(&|index| centred(index, axis)).abs() < 5e-3);
            let variance = mean(&|index| centred(index, axis) * centred(index, axis));
            assert!((variance - 1.0 / 12.0).abs() < 2e-3, "{variance}");
            let beside = mean(&|index| centred(index, axis) * centred(index, (axis + 1) % 3));
            let before = mean(&|index| centred(index, axis) * centred(index - 1, axis));
            assert!(beside.abs() < 2e-3 && before.abs() < 2e-3, "{beside} {before}");
        }
    }
}
