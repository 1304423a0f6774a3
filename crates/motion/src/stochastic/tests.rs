//! The spectrum of the stochastic motion, with and without its envelope.

use std::f64::consts::TAU;

use super::StochasticMotion;
use crate::{Envelope, GroundFilter, Record};

/// Density of the white noise of these tests \[m²/s³\].
const NOISE: f64 = 0.01;

const GROUNDS: [GroundFilter; 3] = [GroundFilter::FIRM, GroundFilter::MEDIUM, GroundFilter::SOFT];

fn motion(ground: GroundFilter, seed: u64) -> StochasticMotion {
    StochasticMotion {
        ground,
        peak: 1.0,
        envelope: Envelope {
            strong_from: 4.0,
            strong_until: 14.0,
            decay: 0.3,
        },
        cutoff: 20.0,
        duration: 40.0,
        time_step: 0.02,
        seed,
    }
}

fn stationary(motion: &StochasticMotion) -> Vec<f64> {
    motion.check().expect("valid settings");
    motion.stationary(NOISE).expect("valid settings")
}

fn shaped(motion: &StochasticMotion, density: f64) -> Record {
    motion.shaped(density).expect("valid settings")
}

/// |Σ a exp(−iωt)|² Δt² of a record, last sample left out \[m²/s²\].
fn energy(samples: &[f64], time_step: f64, angular_frequency: f64) -> f64 {
    let (mut cosine, mut sine) = (0.0, 0.0);
    for (index, sample) in samples[..samples.len() - 1].iter().enumerate() {
        let angle = angular_frequency * index as f64 * time_step;
        cosine += sample * libm::cos(angle);
        sine += sample * libm::sin(angle);
    }
    (cosine * cosine + sine * sine) * time_step * time_step
}

/// The density in the form of the books, with powers of frequencies.
fn density(ground: &GroundFilter, w: f64) -> f64 {
    let square = |x: f64| x * x;
    let (wg, zg) = (ground.angular_frequency, ground.damping_ratio);
    let (wf, zf) = (ground.high_pass_angular_frequency, ground.high_pass_damping_ratio);
    let kanai_tajimi = (square(square(wg)) + square(2.0 * zg * wg * w)) / (square(wg * wg - w * w) + square(2.0 * zg * wg * w));
    let clough_penzien = square(w * w) / (square(wf * wf - w * w) + square(2.0 * zf * wf * w));
    NOISE * kanai_tajimi * clough_penzien
}

// By construction, for every seed: 2π S T is the energy of a term over the duration T.
#[test]
fn reference_the_stationary_motion_has_the_target_density_at_every_frequency() {
    for ground in GROUNDS {
        let samples = stationary(&motion(ground.clone(), 3));
        let spacing = TAU / 40.0;
        for term in [1, 2, 5, 17, 95, 300, 799, 800, 801, 900] {
            let w = f64::from(term) * spacing;
            let found = energy(&samples, 0.02, w) / (TAU * 40.0);
            let wanted = if term <= 800 { density(&ground, w) } else { 0.0 };
            assert!((found - wanted).abs() < 1e-12, "{term}: {found} {wanted}");
        }
        let square: f64 = samples[1..].iter().map(|sample| sample * sample).sum();
        let wanted: f64 = (1..=800)
            .map(|term| 2.0 * density(&ground, f64::from(term) * spacing) * spacing)
            .sum();
        assert!((square / 2000.0 / wanted - 1.0).abs() < 1e-12, "{square} {wanted}");
    }
}

/// The mean over n seeds of an energy with a nearly exponential distribution scatters by 1/√n of itself. Of 48 such means the farthest is
/// beyond 4.5 of this in one choice of seeds out of 3 000.
#[test]
fn reference_the_mean_spectrum_under_the_envelope_is_the_target_spread_by_the_envelope() {
    let n_seeds = 200_u16;
    for ground in GROUNDS {
        let spacing = TAU / 40.0;
        let envelope: Vec<f64> = (0..=2000)
            .map(|step| motion(ground.clone(), 0).envelope.at(0.02 * f64::from(step)))
            .collect();
        let records: Vec<Record> = (0..n_seeds)
            .map(|seed| shaped(&motion(ground.clone(), seed.into()), NOISE))
            .collect();
        for index in 0..16 {
            let w = spacing * (3.0 + 1.37 * f64::from(index * index));
            let sum: f64 = records.iter().map(|record| energy(record.samples(), 0.02, w)).sum();
            let found = sum / f64::from(n_seeds);
            // Every term is spread by the spectrum of the envelope, to either side of zero.
            let wanted: f64 = (-800..=800)
                .filter(|&term| term != 0 && (f64::from(term) * spacing - w).abs() < 6.0)
                .map(|term| {
                    let at = f64::from(term) * spacing;
                    density(&ground, at) * spacing * energy(&envelope, 0.02, w - at)
                })
                .sum();
            let apart = (found / wanted - 1.0).abs() * f64::from(n_seeds).sqrt();
            assert!(apart < 4.5, "{ground:?} at {w} rad/s: {found} against {wanted}");
        }
    }
}

/// Over n seeds the mean square scatters by √(2/n) of itself, and the mean by √(1/n) of the deviation.
#[test]
fn reference_values_at_one_instant_are_normal_over_the_seeds() {
    let n_seeds = 1000_u16;
    let values: Vec<f64> = (0..n_seeds)
        .map(|seed| {
            let short = StochasticMotion {
                duration: 20.0,
                ..motion(GroundFilter::FIRM, seed.into())
            };
            stationary(&short)[317]
        })
        .collect();
    let n = f64::from(n_seeds);
    let spacing = TAU / 20.0;
    let variance: f64 = (1..=400)
        .map(|term| 2.0 * density(&GroundFilter::FIRM, f64::from(term) * spacing) * spacing)
        .sum();
    let moment = |power: i32| {
        let scaled = values.iter().map(|value| value / variance.sqrt());
        scaled.map(|value| libm::pow(value, f64::from(power))).sum::<f64>() / n
    };
    // Deviations of the moments of a standard normal variable: 1, √2, √15, √96 over √n.
    for (power, wanted, deviation) in [(1, 0.0, 1.0_f64), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)] {
        let apart = (moment(power) - wanted).abs() * (n / deviation).sqrt();
        assert!(apart < 4.0, "moment {power}: {}", moment(power));
    }
}

#[test]
fn limit_a_shorter_step_samples_the_same_motion() {
    let coarse = motion(GroundFilter::FIRM, 9);
    let fine = StochasticMotion {
        time_step: 0.005,
        ..coarse.clone()
    };
    let (coarse, fine) = (stationary(&coarse), stationary(&fine));
    for (coarse, fine) in coarse.iter().zip(fine.iter().step_by(4)) {
        assert!((coarse - fine).abs() < 1e-12, "{coarse} {fine}");
    }
}

#[test]
fn limit_four_times_the_noise_is_twice_the_motion() {
    let motion = motion(GroundFilter::FIRM, 5);
    let [once, more] = [NOISE, 4.0 * NOISE].map(|density| shaped(&motion, density));
    let twice = once.scaled(2.0).expect("small numbers");
    for (twice, more) in twice.samples().iter().zip(more.samples()) {
        assert!((twice - more).abs() < 1e-14, "{twice} {more}");
    }
}

#[test]
fn extreme_envelopes_of_few_samples_and_no_noise() {
    for (strong_from, decay) in [(1e-300, 1e300), (0.02, 1e5), (0.03, 1e5), (1e6, 1.0)] {
        let short = StochasticMotion {
            envelope: Envelope {
                strong_from,
                strong_until: strong_from,
                decay,
            },
            ..motion(GroundFilter::SOFT, 0)
        };
        assert_eq!(shaped(&short, NOISE).samples().len(), 2001);
    }
    let still = shaped(&motion(GroundFilter::FIRM, 0), 0.0);
    assert_eq!(still.peak().1.to_string(), "0");
}
