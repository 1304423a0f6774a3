//! The stochastic motion: its seeds, and the ground at its end.

use pounding_motion::{Envelope, GroundFilter, Record, StochasticMotion};

/// The usual envelope of these tests.
const ENVELOPE: Envelope = Envelope {
    strong_from: 4.0,
    strong_until: 14.0,
    decay: 0.3,
};

fn motion(ground: GroundFilter, seed: u64) -> StochasticMotion {
    StochasticMotion {
        ground,
        peak: 3.0,
        envelope: ENVELOPE,
        cutoff: 20.0,
        duration: 40.0,
        time_step: 0.02,
        seed,
    }
}

fn record(motion: &StochasticMotion) -> Record {
    motion.record().expect("valid settings")
}

const GROUNDS: [GroundFilter; 3] = [GroundFilter::FIRM, GroundFilter::MEDIUM, GroundFilter::SOFT];

#[test]
fn reference_the_same_bits_on_every_machine() {
    let record = record(&motion(GroundFilter::MEDIUM, 1));
    let samples = [1, 100, 500, 1000, 1999].map(|index| record.samples()[index]);
    insta::assert_snapshot!(format!("{samples:?}\n{}", record.source()));
}

#[test]
fn limit_a_seed_is_a_motion_and_another_seed_another() {
    let [one, again, other] = [1, 1, 2].map(|seed| record(&motion(GroundFilter::SOFT, seed)));
    assert_eq!(one, again);
    let product: f64 = one.samples().iter().zip(other.samples()).map(|(a, b)| a * b).sum();
    let square: f64 = one.samples().iter().map(|a| a * a).sum();
    assert!((product / square).abs() < 0.5, "{product} {square}");
}

#[test]
fn limit_the_ground_is_left_at_rest_where_it_was() {
    for ground in GROUNDS {
        for seed in 0..50 {
            let record = record(&motion(ground.clone(), seed));
            let (moved, peaks) = (record.integrated(), record.measures());
            let (velocity, displacement) = (moved.velocity[2000], moved.displacement[2000]);
            assert!(velocity.abs() < 1e-12 * peaks.pgv, "{seed}: {velocity}");
            assert!(displacement.abs() < 1e-12 * peaks.pgd, "{seed}: {displacement}");
        }
    }
}

#[test]
fn extreme_settings_that_cannot_be() {
    let error = |change: fn(&mut StochasticMotion)| {
        let mut motion = motion(GroundFilter::FIRM, 0);
        change(&mut motion);
        motion.record().expect_err("refused").to_string()
    };
    insta::assert_snapshot!(
        [
            error(|motion| motion.ground.angular_frequency = 0.0),
            error(|motion| motion.ground.damping_ratio = f64::NAN),
            error(|motion| motion.ground.high_pass_angular_frequency = -1.0),
            error(|motion| motion.ground.high_pass_damping_ratio = f64::INFINITY),
            error(|motion| motion.peak = -1.0),
            error(|motion| motion.peak = f64::NAN),
            error(|motion| motion.cutoff = 25.0),
            error(|motion| motion.cutoff = 0.02),
            error(|motion| motion.duration = 0.0),
            error(|motion| motion.duration = 1e6),
            error(|motion| motion.time_step = -0.01),
            error(|motion| {
                motion.envelope = Envelope {
                    strong_from: 0.0,
                    strong_until: 1.0,
                    decay: 1.0,
                };
            }),
            error(|motion| {
                motion.envelope = Envelope {
                    strong_from: 3.0,
                    strong_until: 2.0,
                    decay: 1.0,
                };
            }),
            error(|motion| {
                motion.envelope = Envelope {
                    strong_from: 3.0,
                    strong_until: 4.0,
                    decay: 0.0,
                };
            }),
        ]
        .join("\n")
    );
}
