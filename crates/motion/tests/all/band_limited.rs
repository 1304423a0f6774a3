//! Records between their samples: straight lines, and the band-limited motion.
#![expect(clippy::disallowed_methods, reason = "sines in tests")]

use std::f64::consts::TAU;

use pounding_motion::Record;

fn sampled(time_step: f64, n: u32, motion: impl Fn(f64) -> f64) -> Record {
    let samples = (0..n).map(|index| motion(time_step * f64::from(index))).collect();
    Record::new(time_step, samples, "made up").expect("a record")
}

/// A wave of 5 Hz that swells and fades: it holds nothing above 12 Hz, and nothing outside of the record, to rounding.
fn wave(time: f64) -> f64 {
    let after = time - 5.0;
    (-2.0 * after * after).exp() * (TAU * 5.0 * after).sin()
}

#[test]
fn reference_a_band_limited_wave_returns_between_its_samples() {
    let record = sampled(0.02, 501, wave);
    let finer = record.band_limited().expect("a finer one");
    assert!(finer.time_step() <= 0.02 / 8.0, "{}", finer.time_step());
    let error = |record: &Record, times: &Record| {
        let times = (0..times.samples().len()).map(|index| index as f64 * times.time_step());
        times.map(|time| (record.at(time) - wave(time)).abs()).fold(0.0, f64::max)
    };
    let (limited, linear) = (error(&finer, &finer), error(&record, &finer));
    assert!(limited < 1e-12, "{limited}");
    assert!(linear > 0.04, "{linear}");
}

/// Straight lines between its samples are the motion to the promised 0.05 %: finer samples lie on them.
#[test]
fn limit_straight_lines_between_finer_samples_are_the_motion() {
    for (time_step, n) in [(0.01, 1001), (0.02, 501), (0.04, 251), (0.08, 126)] {
        let finer = sampled(time_step, n, wave).band_limited().expect("a finer one");
        let times = (0..100_000).map(|index| 1e-4 * f64::from(index));
        let squares = times.map(|time| [(finer.at(time) - wave(time)).powi(2), wave(time).powi(2)]);
        let [error, all] = squares.fold([0.0, 0.0], |sum, next| [sum[0] + next[0], sum[1] + next[1]]);
        let error = (error / all).sqrt();
        // The images of the wave are as strong as what it loses.
        assert!(error < 1e-3, "{time_step}: {error}");
    }
}

#[test]
fn limit_samples_stay_and_a_fine_record_is_left_alone() {
    let record = sampled(0.02, 501, wave);
    let finer = record.band_limited().expect("a finer one");
    let factor = (finer.samples().len() - 1) / (record.samples().len() - 1);
    let kept: Vec<f64> = finer.samples().iter().copied().step_by(factor).collect();
    assert_eq!(kept, record.samples());
    let fine = sampled(1e-3, 10_001, wave);
    assert_eq!(fine.band_limited().expect("itself").samples(), fine.samples());
    for short in [vec![0.0], vec![2.0], vec![0.0; 7], vec![1.0, -1.0]] {
        let record = Record::new(0.02, short, "").expect("a record");
        let finer = record.band_limited().expect("a finer one");
        assert!((finer.duration() - record.duration()).abs() < 1e-12);
    }
}

/// Amplitude of a frequency \[Hz\] in the straight lines between samples, from 2 to 8 s, by Simpson's rule within every line.
fn amplitude(record: &Record, frequency: f64) -> f64 {
    let n = 6000 * 20;
    let h = 6.0 / f64::from(n);
    let [mut sine, mut cosine] = [0.0; 2];
    for index in 0..=n {
        let time = 2.0 + h * f64::from(index);
        let weight = match index {
            0 => 1.0,
            last if last == n => 1.0,
            odd if odd % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let value = weight * h / 3.0 * record.at(time);
        sine += value * (TAU * frequency * time).sin();
        cosine += value * (TAU * frequency * time).cos();
    }
    2.0 / 6.0 * sine.hypot(cosine)
}

/// What straight lines make of a harmonic: sinc²(fΔt) of it, and an image at 1/Δt − f.
#[test]
fn reference_straight_lines_keep_the_square_of_a_sinc() {
    let case: serde_json::Value = serde_json::from_str(include_str!("../../../scene/tests/reach/band-limited-sinc2.json")).expect("JSON");
    for (name, frequency, time_step, n) in [
        ("5 Hz at 0.02 s", 5.0, 0.02, 501),
        ("10 Hz at 0.01 s", 10.0, 0.01, 1001),
        ("10 Hz at 0.02 s", 10.0, 0.02, 501),
    ] {
        let wanted = |field: &str| -> f64 {
            let text = case["expected"][name][field].as_str().expect(field);
            text.parse().expect(field)
        };
        let record = sampled(time_step, n, |time| (TAU * frequency * time).sin());
        let [kept, image] = [frequency, wanted("first_image_hz")].map(|frequency| amplitude(&record, frequency));
        assert!((kept - wanted("fundamental")).abs() < 1e-9, "{name}: {kept}");
        assert!((image - wanted("first_image")).abs() < 1e-9, "{name}: {image}");
    }
}

#[test]
fn issue_a_record_that_begins_or_ends_away_from_zero_is_told() {
    let of = |samples: Vec<f64>| Record::new(0.02, samples, "").expect("a record").jumps();
    assert_eq!(of(vec![0.0, 2.0, -4.0, 0.05]), None);
    assert_eq!(of(vec![0.0, 2.0, -4.0, 1.0]), Some(0.25));
    assert_eq!(of(vec![0.0; 3]), None);
}

#[test]
fn extreme_a_record_too_long_to_be_made_finer() {
    let mut samples = vec![0.0; 2_000_001];
    samples[1_000_000] = 1.0;
    let refused = Record::new(0.005, samples, "")
        .expect("a record")
        .band_limited()
        .expect_err("too long");
    insta::assert_snapshot!(refused, @r#"interpolation: found band_limited, which needs 64000001 samples, allowed up to 10000000; shorten the record, or take "linear""#);
}
