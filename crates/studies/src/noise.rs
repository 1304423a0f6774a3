//! A record with seeded noise.

use std::f64::consts::TAU;

use pounding_motion::{Record, Refused};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// State that every stream of random numbers starts from; nothing depends on its value.
const SEED: u128 = 0x0123_4567_89ab_cdef_0011_2233_4455_6677;

/// Relative noise for the samples of a record: normally distributed, independent from sample to sample.
///
/// Level and run alone choose the random sequence, so all scenes of a run have the same record. A finding that compares two scenes
/// therefore compares them under one earthquake.
#[derive(Debug, Clone)]
pub(crate) struct Noise {
    /// Standard deviation \[–\].
    sigma: f64,
    /// Number of the random sequence.
    stream: u128,
}

impl Noise {
    /// The noise of run number `run` with standard deviation `sigma` \[–\]; `level` is the index of this deviation in its list.
    pub(crate) fn new(sigma: f64, level: usize, run: usize) -> Self {
        let stream = ((level as u128) << 64) | run as u128;
        Self { sigma, stream }
    }

    /// The record with every sample `a` replaced by `a·(1 + σξ)`, ξ standard normal.
    ///
    /// # Errors
    /// [`Refused`] if a noisy sample is not finite. The error names the sample.
    pub(crate) fn on(&self, record: &Record) -> Result<Record, Refused> {
        let mut random = Pcg64::new(SEED, self.stream);
        let mut samples = Vec::with_capacity(record.samples().len() + 1);
        for pair in record.samples().chunks(2) {
            let normals = two_normals(&mut random);
            let noisy = |(sample, normal): (&f64, f64)| sample * (1.0 + self.sigma * normal);
            samples.extend(pair.iter().zip(normals).map(noisy));
        }
        Record::new(record.time_step(), samples, record.source())
    }
}

/// Two independent standard normal numbers (the transform of Box and Muller).
fn two_normals(random: &mut Pcg64) -> [f64; 2] {
    // In (0, 1]: the logarithm needs a number above zero.
    let radius = (-2.0 * libm::log(1.0 - uniform(random))).sqrt();
    let angle = TAU * uniform(random);
    [radius * libm::cos(angle), radius * libm::sin(angle)]
}

/// A uniform number in [0, 1), a multiple of 2⁻⁵³.
pub(crate) fn uniform(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noisy(sigma: f64, level: usize, run: usize) -> Vec<f64> {
        let record = Record::new(0.01, vec![2.0; 20_001], "").expect("a record");
        let noisy = Noise::new(sigma, level, run).on(&record);
        noisy.expect("finite noise").samples().to_vec()
    }

    #[test]
    fn reference_noise_is_standard_normal() {
        let normals: Vec<f64> = noisy(0.5, 1, 7).iter().map(|sample| sample - 2.0).collect();
        let n = normals.len() as f64;
        let moment = |power| normals.iter().map(|x: &f64| libm::pow(*x, power)).sum::<f64>() / n;
        // Five standard errors of each moment of n normal numbers.
        let within = |found: f64, wanted: f64, variance: f64| (found - wanted).abs() <= 5.0 * (variance / n).sqrt();
        assert!(within(moment(1.0), 0.0, 1.0), "mean {}", moment(1.0));
        assert!(within(moment(2.0), 1.0, 2.0), "variance {}", moment(2.0));
        assert!(within(moment(3.0), 0.0, 15.0), "skewness {}", moment(3.0));
        assert!(within(moment(4.0), 3.0, 96.0), "kurtosis {}", moment(4.0));
        let neighbours = normals.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>() / n;
        assert!(within(neighbours, 0.0, 1.0), "neighbours {neighbours}");
    }

    #[test]
    fn limit_noise_depends_on_level_and_run_only() {
        assert_eq!(noisy(1e-3, 1, 2), noisy(1e-3, 1, 2), "the same twice");
        assert_ne!(noisy(1e-3, 1, 2), noisy(1e-3, 2, 1), "another stream");
        assert_eq!(noisy(0.0, 1, 2), vec![2.0; 20_001], "no noise changes nothing");
    }
}
