//! Harmonic motions and pulses.

use std::f64::consts::{FRAC_PI_2, PI};

use pounding_motion::{HalfSinePulse, Harmonic, RickerPulse};

const HARMONIC: Harmonic = Harmonic {
    amplitude: 2.0,
    frequency: 1.25,
    phase: 0.0,
    ramp_periods: 0.0,
    duration: 4.0,
    time_step: 0.01,
};

#[test]
fn reference_a_harmonic_at_quarters_of_its_period() {
    let record = HARMONIC.record().unwrap();
    assert_eq!(record.samples().len(), 401);
    for (index, &sample) in record.samples().iter().enumerate().step_by(20) {
        let wanted = [0.0, 2.0, 0.0, -2.0][index / 20 % 4];
        // An angle up to 31 rad is rounded three times, by up to 4e-15 each.
        assert!((sample - wanted).abs() < 2.4e-14, "{index}: {sample}");
    }
    let cosine = Harmonic {
        phase: FRAC_PI_2,
        ..HARMONIC
    };
    let cosine = cosine.record().unwrap();
    for (cosine, sine) in cosine.samples().iter().zip(&record.samples()[20..]) {
        assert!((cosine - sine).abs() < 4.8e-14, "{cosine} {sine}");
    }
}

#[test]
fn limit_ramps_change_nothing_between_them_and_begin_and_end_at_zero() {
    let steady = Harmonic { phase: 1.0, ..HARMONIC };
    let ramped = Harmonic {
        ramp_periods: 2.0,
        ..steady.clone()
    };
    let [steady, ramped] = [steady, ramped].map(|motion| motion.record().unwrap());
    assert_eq!(ramped.samples()[160..=240], steady.samples()[160..=240]);
    let ends = [0, 400].map(|index| ramped.samples()[index].to_string());
    assert_eq!(ends, ["0", "0"]);
    // Half way up a ramp is half the amplitude.
    let half = 0.5 * steady.samples()[80];
    assert!((ramped.samples()[80] - half).abs() < 1e-14, "{half}");
}

#[test]
fn issue_a_last_sample_behind_the_end_by_its_rounding_is_a_number() {
    // 70 steps of 0.01 s end 1e-16 s after 0.7 s. Without ramps that sample was 0/0, and the run refused its own record.
    for (duration, time_step) in [(0.7, 0.01), (4.1, 0.025)] {
        let motion = Harmonic {
            frequency: 5.0,
            duration,
            time_step,
            ..HARMONIC
        };
        let record = motion.record().unwrap();
        let last = *record.samples().last().unwrap();
        assert!(last.abs() < 1e-12, "{duration} s: {last}");
    }
}

#[test]
fn reference_a_ricker_pulse_leaves_the_ground_where_it_was() {
    let pulse = RickerPulse {
        amplitude: -3.0,
        frequency: 2.0,
        time_step: 0.001,
    };
    let record = pulse.record().unwrap();
    assert_eq!(record.peak(), (0.75, -3.0));
    assert_eq!(record.samples().len(), 1501);
    let mirrored: Vec<f64> = record.samples().iter().rev().copied().collect();
    assert_eq!(record.samples(), mirrored);
    // The troughs of 2·exp(−3/2) are at x² = 3/2.
    let trough = record.samples().iter().copied().fold(0.0, f64::max);
    assert!((trough / (6.0 * libm::exp(-1.5)) - 1.0).abs() < 1e-4, "{trough}");
    let moved = record.integrated();
    let (velocity, displacement) = (moved.velocity[1500], moved.displacement[1500]);
    // The tail cut off at x = 1.5π leaves a velocity of 2A·1.5/f·exp(−x²), which lasts for half of the duration.
    let cut = -3.0 * 1.5 * libm::exp(-2.25 * PI * PI);
    assert!((velocity - cut).abs() < 1e-12, "{velocity} {cut}");
    assert!((displacement - 0.75 * cut).abs() < 1e-12, "{displacement}");
    // The second integral of the pulse is the bell −A/(2π²f²)·exp(−x²).
    let bell = 3.0 / (2.0 * PI * PI * 4.0);
    let pgd = record.measures().pgd;
    assert!((pgd / bell - 1.0).abs() < 1e-4, "{pgd} {bell}");
}

#[test]
fn reference_a_half_sine_pulse_ends_at_or_after_its_duration() {
    let pulse = |duration, time_step| HalfSinePulse {
        amplitude: 2.0,
        duration,
        time_step,
    };
    let even = pulse(0.4, 0.1).record().unwrap();
    let wanted = [0.0, 2.0_f64.sqrt(), 2.0, 2.0_f64.sqrt(), 0.0];
    assert_eq!(even.samples().len(), 5);
    for (found, wanted) in even.samples().iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
    }
    let odd = pulse(0.35, 0.1).record().unwrap();
    assert_eq!(odd.samples().len(), 5);
    assert!(odd.samples()[3] > 0.0 && odd.samples()[4] == 0.0, "{odd:?}");
    // 0.3/0.1 is less than 3 in binary.
    assert_eq!(pulse(0.3, 0.1).record().unwrap().samples().len(), 4);
}

#[test]
fn extreme_motions_that_cannot_be() {
    let harmonic = |change: fn(&mut Harmonic)| {
        let mut motion = HARMONIC;
        change(&mut motion);
        motion.record().expect_err("refused").to_string()
    };
    let ricker = |amplitude, frequency, time_step| {
        let pulse = RickerPulse {
            amplitude,
            frequency,
            time_step,
        };
        pulse.record().expect_err("refused").to_string()
    };
    let half_sine = |amplitude, duration, time_step| {
        let pulse = HalfSinePulse {
            amplitude,
            duration,
            time_step,
        };
        pulse.record().expect_err("refused").to_string()
    };
    insta::assert_snapshot!(
        [
            harmonic(|motion| motion.amplitude = f64::NAN),
            harmonic(|motion| motion.phase = f64::INFINITY),
            harmonic(|motion| motion.frequency = 0.0),
            harmonic(|motion| motion.frequency = 50.0),
            harmonic(|motion| motion.duration = -1.0),
            harmonic(|motion| motion.duration = 1e9),
            harmonic(|motion| motion.time_step = 0.0),
            harmonic(|motion| motion.ramp_periods = 3.0),
            ricker(1.0, 60.0, 0.01),
            ricker(f64::NAN, 6.0, 0.01),
            ricker(1.0, 0.0, 0.01),
            ricker(1.0, 1e-300, 0.01),
            half_sine(1.0, 0.015, 0.01),
            half_sine(1.0, f64::INFINITY, 0.01),
        ]
        .join("\n")
    );
    let still = Harmonic { duration: 0.0, ..HARMONIC };
    assert_eq!(still.record().unwrap().samples(), [0.0]);
    let tiny = RickerPulse {
        amplitude: 1.0,
        frequency: 1e-300,
        time_step: f64::MAX,
    };
    assert!(
        tiny.record().is_err_and(|refused| refused.to_string().starts_with("time_step: ")),
        "{tiny:?}"
    );
}
