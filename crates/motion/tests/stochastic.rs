//! The stochastic motion: its spectrum, its seeds, and how the ground is left.

use std::f64::consts::TAU;

use pounding_motion::{Envelope, GroundFilter, Record, StochasticMotion, Strength};

/// The usual envelope of these tests.
const ENVELOPE: Envelope = Envelope::Jennings {
    strong_from: 4.0,
    strong_until: 14.0,
    decay: 0.3,
};

fn motion(ground: GroundFilter, envelope: Envelope, seed: u64) -> StochasticMotion {
    StochasticMotion {
        ground,
        strength: Strength::WhiteNoise(0.01),
        envelope,
        cutoff: 20.0,
        duration: 40.0,
        time_step: 0.02,
        seed,
    }
}

fn record(motion: &StochasticMotion) -> Record {
    motion.record().expect("valid settings")
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

const GROUNDS: [GroundFilter; 3] = [GroundFilter::FIRM, GroundFilter::MEDIUM, GroundFilter::SOFT];

/// The density in the form of the books, with powers of frequencies.
fn density(ground: &GroundFilter, w: f64) -> f64 {
    let square = |x: f64| x * x;
    let (wg, zg) = (ground.angular_frequency, ground.damping_ratio);
    let (wf, zf) = (
        ground.high_pass_angular_frequency,
        ground.high_pass_damping_ratio,
    );
    let kanai_tajimi = (square(square(wg)) + square(2.0 * zg * wg * w))
        / (square(wg * wg - w * w) + square(2.0 * zg * wg * w));
    let clough_penzien = square(w * w) / (square(wf * wf - w * w) + square(2.0 * zf * wf * w));
    0.01 * kanai_tajimi * clough_penzien
}

// By construction, and for every seed: 2π S T is the energy of a term over the duration T.
#[test]
fn reference_the_stationary_motion_has_the_target_density_at_every_frequency() {
    for ground in GROUNDS {
        let record = record(&motion(ground.clone(), Envelope::Constant, 3));
        let spacing = TAU / 40.0;
        for term in [1, 2, 5, 17, 95, 300, 799, 800, 801, 900] {
            let w = f64::from(term) * spacing;
            let found = energy(record.samples(), 0.02, w) / (TAU * 40.0);
            let wanted = if term <= 800 {
                density(&ground, w)
            } else {
                0.0
            };
            assert!((found - wanted).abs() < 1e-12, "{term}: {found} {wanted}");
        }
        let square: f64 = record.samples()[1..]
            .iter()
            .map(|sample| sample * sample)
            .sum();
        let wanted: f64 = (1..=800)
            .map(|term| 2.0 * density(&ground, f64::from(term) * spacing) * spacing)
            .sum();
        assert!(
            (square / 2000.0 / wanted - 1.0).abs() < 1e-12,
            "{square} {wanted}"
        );
    }
}

/// The mean over n seeds of an energy that is nearly exponentially distributed scatters by 1/√n of itself; of 48 such
/// means the farthest is beyond 4.5 of that in one choice of seeds of 3 000.
#[test]
fn reference_the_mean_spectrum_under_the_envelope_is_the_target_spread_by_the_envelope() {
    let n_seeds = 200_u16;
    for ground in GROUNDS {
        let spacing = TAU / 40.0;
        let envelope: Vec<f64> = (0..=2000)
            .map(|step| ENVELOPE.at(0.02 * f64::from(step)))
            .collect();
        let records: Vec<Record> = (0..n_seeds)
            .map(|seed| record(&motion(ground.clone(), ENVELOPE, seed.into())))
            .collect();
        for index in 0..16 {
            let w = spacing * (3.0 + 1.37 * f64::from(index * index));
            let sum: f64 = records
                .iter()
                .map(|record| energy(record.samples(), 0.02, w))
                .sum();
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
            assert!(
                apart < 4.5,
                "{ground:?} at {w} rad/s: {found} against {wanted}"
            );
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
                ..motion(GroundFilter::FIRM, Envelope::Constant, seed.into())
            };
            record(&short).samples()[317]
        })
        .collect();
    let n = f64::from(n_seeds);
    let spacing = TAU / 20.0;
    let variance: f64 = (1..=400)
        .map(|term| 2.0 * density(&GroundFilter::FIRM, f64::from(term) * spacing) * spacing)
        .sum();
    let moment = |power: i32| {
        let scaled = values.iter().map(|value| value / variance.sqrt());
        scaled
            .map(|value| libm::pow(value, f64::from(power)))
            .sum::<f64>()
            / n
    };
    // Deviations of the moments of a standard normal variable: 1, √2, √15, √96 over √n.
    for (power, wanted, deviation) in [
        (1, 0.0, 1.0_f64),
        (2, 1.0, 2.0),
        (3, 0.0, 15.0),
        (4, 3.0, 96.0),
    ] {
        let apart = (moment(power) - wanted).abs() * (n / deviation).sqrt();
        assert!(apart < 4.0, "moment {power}: {}", moment(power));
    }
}

#[test]
fn reference_the_same_bits_on_every_machine() {
    let record = record(&StochasticMotion {
        strength: Strength::Peak(3.0),
        ..motion(GroundFilter::MEDIUM, ENVELOPE, 1)
    });
    let samples = [1, 100, 500, 1000, 1999].map(|index| record.samples()[index]);
    insta::assert_snapshot!(format!("{samples:?}\n{}", record.source()));
}

#[test]
fn limit_a_seed_is_a_motion_and_another_seed_another() {
    let [one, again, other] =
        [1, 1, 2].map(|seed| record(&motion(GroundFilter::SOFT, ENVELOPE, seed)));
    assert_eq!(one, again);
    let product: f64 = one
        .samples()
        .iter()
        .zip(other.samples())
        .map(|(a, b)| a * b)
        .sum();
    let square: f64 = one.samples().iter().map(|a| a * a).sum();
    assert!((product / square).abs() < 0.5, "{product} {square}");
}

#[test]
fn limit_a_shorter_step_samples_the_same_motion() {
    let coarse = motion(GroundFilter::FIRM, Envelope::Constant, 9);
    let fine = StochasticMotion {
        time_step: 0.005,
        ..coarse.clone()
    };
    let (coarse, fine) = (record(&coarse), record(&fine));
    for (coarse, fine) in coarse
        .samples()
        .iter()
        .zip(fine.samples().iter().step_by(4))
    {
        assert!((coarse - fine).abs() < 1e-12, "{coarse} {fine}");
    }
}

#[test]
fn limit_four_times_the_noise_is_twice_the_motion() {
    let once = motion(GroundFilter::FIRM, ENVELOPE, 5);
    let more = StochasticMotion {
        strength: Strength::WhiteNoise(0.04),
        ..once.clone()
    };
    let (once, more) = (record(&once), record(&more));
    let twice = once.scaled(2.0).unwrap();
    for (twice, more) in twice.samples().iter().zip(more.samples()) {
        assert!((twice - more).abs() < 1e-14, "{twice} {more}");
    }
}

#[test]
fn limit_the_ground_is_left_at_rest_where_it_was() {
    for ground in GROUNDS {
        for seed in 0..50 {
            let record = record(&motion(ground.clone(), ENVELOPE, seed));
            let (moved, peaks) = (record.integrated(), record.measures());
            let (velocity, displacement) = (moved.velocity[2000], moved.displacement[2000]);
            assert!(velocity.abs() < 1e-12 * peaks.pgv, "{seed}: {velocity}");
            assert!(
                displacement.abs() < 1e-12 * peaks.pgd,
                "{seed}: {displacement}"
            );
        }
    }
}

#[test]
fn extreme_settings_that_cannot_be() {
    let error = |change: fn(&mut StochasticMotion)| {
        let mut motion = motion(GroundFilter::FIRM, ENVELOPE, 0);
        change(&mut motion);
        motion.record().expect_err("refused").to_string()
    };
    insta::assert_snapshot!(
        [
            error(|motion| motion.ground.angular_frequency = 0.0),
            error(|motion| motion.ground.damping_ratio = f64::NAN),
            error(|motion| motion.ground.high_pass_angular_frequency = -1.0),
            error(|motion| motion.ground.high_pass_damping_ratio = f64::INFINITY),
            error(|motion| motion.strength = Strength::Peak(-1.0)),
            error(|motion| motion.strength = Strength::WhiteNoise(f64::NAN)),
            error(|motion| motion.cutoff = 25.0),
            error(|motion| motion.cutoff = 0.02),
            error(|motion| motion.duration = 0.0),
            error(|motion| motion.duration = 1e6),
            error(|motion| motion.time_step = -0.01),
            error(|motion| {
                motion.envelope = Envelope::Jennings {
                    strong_from: 0.0,
                    strong_until: 1.0,
                    decay: 1.0,
                };
            }),
            error(|motion| {
                motion.envelope = Envelope::Jennings {
                    strong_from: 3.0,
                    strong_until: 2.0,
                    decay: 1.0,
                };
            }),
            error(|motion| {
                motion.envelope = Envelope::Jennings {
                    strong_from: 3.0,
                    strong_until: 4.0,
                    decay: 0.0,
                };
            }),
        ]
        .join("\n")
    );
}

#[test]
fn extreme_envelopes_of_few_samples_and_no_noise() {
    for (strong_from, decay) in [(1e-300, 1e300), (0.02, 1e5), (0.03, 1e5), (1e6, 1.0)] {
        let envelope = Envelope::Jennings {
            strong_from,
            strong_until: strong_from,
            decay,
        };
        let record = record(&motion(GroundFilter::SOFT, envelope, 0));
        assert_eq!(record.samples().len(), 2001);
    }
    let still = StochasticMotion {
        strength: Strength::WhiteNoise(0.0),
        ..motion(GroundFilter::FIRM, ENVELOPE, 0)
    };
    assert_eq!(record(&still).peak().1.to_string(), "0");
}
