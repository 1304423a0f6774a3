//! Response spectra of two horizontal components against closed forms, single components and many angles.

use std::f64::consts::TAU;

use pounding_motion::Record;
use pounding_scene::{PairValues, pair_spectra, response_spectrum};

use crate::spectrum::el_centro;

fn with(record: &Record, sample: impl FnMut((usize, &f64)) -> f64) -> Record {
    let samples = record.samples().iter().enumerate().map(sample).collect();
    Record::new(record.time_step(), samples, "").expect("a record")
}

fn spectrum(pair: [&Record; 2], periods: &[f64], damping_ratio: f64) -> Vec<PairValues> {
    pair_spectra(pair, periods, &[damping_ratio], None, &|| ())
        .expect("spectra")
        .remove(0)
        .values
}

fn close(found: f64, wanted: f64, share: f64, what: &str) {
    assert!((found - wanted).abs() <= share * wanted.abs(), "{what}: {found} against {wanted}");
}

const PERIODS: [f64; 7] = [0.0, 0.02, 0.1, 0.45, 1.0, 3.3, 10.0];

/// A second component of 0.75 times the first: every structure moves on a line, so that `RotD100` is √(1 + 0.75²) Sa, `RotD50` is √½ of it, `RotD00`
/// is 0 and the geometric mean √0.75 Sa.
#[test]
fn reference_a_polarised_pair() {
    let one = el_centro();
    let other = with(&one, |(_, sample)| 0.75 * sample);
    for (values, single) in spectrum([&one, &other], &PERIODS, 0.05)
        .iter()
        .zip(response_spectrum(&one, &PERIODS, 0.05).expect("a spectrum"))
    {
        let sa = values.of_components[0];
        close(sa, single.pseudo_acceleration, 1e-8, "the first component");
        close(values.rotd100, 1.25 * sa, 1e-12, "RotD100");
        close(values.rotd50, 0.883_883_476_483_184_4 * sa, 1e-12, "RotD50");
        close(values.geometric_mean, 0.866_025_403_784_438_6 * sa, 1e-12, "geometric mean");
        assert!(values.rotd00 < 1e-13 * sa, "RotD00: {}", values.rotd00);
    }
}

/// Two sines a quarter period apart: in the steady state each structure moves on a circle of the resonance curve's radius, and all
/// percentiles are equal.
#[test]
fn reference_a_ground_that_circles() {
    let (frequency, damping) = (0.7, 0.1);
    let step = 0.005;
    let squared = |value: f64| value * value;
    let ramp = |time: f64| squared(libm::sin(0.25 * TAU * (time / 40.0).min(1.0)));
    let made = |phase: f64| {
        let sample = |index: i32| {
            let time = f64::from(index) * step;
            ramp(time) * libm::sin(TAU * frequency * time + phase)
        };
        Record::new(step, (0..16_000).map(sample).collect(), "").expect("a record")
    };
    let pair = [made(0.0), made(TAU / 4.0)];
    let ratio: f64 = 0.5;
    let values = spectrum([&pair[0], &pair[1]], &[ratio / frequency], damping)[0];
    let wanted = 1.0 / (squared(1.0 - ratio * ratio) + squared(2.0 * damping * ratio)).sqrt();
    // The ground is linear between samples, which takes sinc² of the frequency off.
    for (what, found) in [("RotD00", values.rotd00), ("RotD50", values.rotd50), ("RotD100", values.rotd100)] {
        close(found, wanted, 5e-4, what);
    }
    close(values.rotd100, values.rotd00, 5e-4, "a circle");
}

/// Rotating the ground by many angles, each with the spectrum of a single component, is a second route.
#[test]
fn limit_many_angles_of_single_spectra() {
    let one = el_centro();
    let n = one.samples().len();
    let other = with(&one, |(index, _)| {
        0.8 * one.samples()[(index * 7 + 311) % n] * libm::exp(-1e-3 * index as f64)
    });
    let n_angles = 180;
    for (period, damping) in [(0.2, 0.05), (1.3, 0.02)] {
        let values = spectrum([&one, &other], &[period], damping)[0];
        let at = |degrees: f64| {
            let (sine, cosine) = libm::sincos(degrees.to_radians());
            let turned = with(&one, |(index, sample)| cosine * sample + sine * other.samples()[index]);
            response_spectrum(&turned, &[period], damping).expect("a spectrum")[0].pseudo_acceleration
        };
        let mut all: Vec<f64> = (0..n_angles)
            .map(|index| at(f64::from(index) * 180.0 / f64::from(n_angles)))
            .collect();
        close(values.of_components[0], all[0], 1e-8, "0°");
        close(values.of_components[1], all[90], 1e-8, "90°");
        all.sort_by(f64::total_cmp);
        assert!(
            all[179] <= values.rotd100 * (1.0 + 1e-9) && all[0] >= values.rotd00 * (1.0 - 1e-9),
            "no angle is beyond the ends"
        );
        close(all[179], values.rotd100, 2e-4, "RotD100");
        close(f64::midpoint(all[89], all[90]), values.rotd50, 5e-3, "RotD50");
        close(all[0], values.rotd00, 2e-2, "RotD00");
    }
}

/// The percentiles do not depend on the axes of the components.
#[test]
fn limit_axes_do_not_matter() {
    let one = el_centro();
    let other = with(&one, |(index, sample)| sample * libm::sin(0.01 * index as f64));
    let [sine, cosine] = [libm::sin(0.6), libm::cos(0.6)];
    let turned = [
        with(&one, |(index, sample)| cosine * sample + sine * other.samples()[index]),
        with(&one, |(index, sample)| cosine * other.samples()[index] - sine * sample),
    ];
    let both = [[&one, &other], [&turned[0], &turned[1]]].map(|pair| spectrum(pair, &PERIODS, 0.05));
    for (one, other) in both[0].iter().zip(&both[1]) {
        close(one.rotd50, other.rotd50, 1e-8, "RotD50");
        close(one.rotd100, other.rotd100, 1e-8, "RotD100");
    }
}

#[test]
fn extreme_pairs() {
    let one = el_centro();
    let still = with(&one, |_| 0.0);
    let values = spectrum([&one, &still], &[0.0, 1.0], 0.05);
    for value in &values {
        close(value.rotd50, 0.5_f64.sqrt() * value.of_components[0], 1e-12, "one component alone");
        assert!(value.geometric_mean == 0.0 && value.of_components[1] == 0.0, "{value:?}");
    }
    let none = spectrum([&still, &still], &[0.0, 1.0], 0.0);
    assert!(none.iter().all(|one| one.rotd100 == 0.0), "{none:?}");
    // The shorter component ends in zeros.
    let short = Record::new(0.02, one.samples()[..200].to_vec(), "").expect("a record");
    let mut samples = short.samples().to_vec();
    samples.resize(one.samples().len(), 0.0);
    let filled = Record::new(0.02, samples, "").expect("a record");
    assert_eq!(spectrum([&one, &short], &[0.5], 0.05), spectrum([&one, &filled], &[0.5], 0.05));
    let refused = |pair: [&Record; 2], period: f64, damping: f64| {
        let refused = pair_spectra(pair, &[period], &[damping], None, &|| ()).expect_err("it is refused");
        refused.to_string()
    };
    let slower = Record::new(0.01, vec![0.0; 3], "").expect("a record");
    assert!(refused([&one, &slower], 1.0, 0.05).contains("time steps of 0.02 s and 0.01 s"));
    assert!(refused([&one, &one], 1e-5, 0.05).contains("steps over this record"));
    assert!(refused([&one, &one], 1.0, 1.5).contains("0 to 1"));
}

/// The package pyrotd takes the pair as band-limited, by Fourier transforms: see the script beside its numbers.
#[test]
fn reference_pyrotd() {
    let step = 0.25e-3;
    let made = |motion: fn(f64) -> f64| {
        let sample = |index: i32| {
            let time = f64::from(index) * step;
            let window = libm::sin(0.5 * TAU * time / 6.0);
            window * window * motion(time)
        };
        Record::new(step, (0..24_000).map(sample).collect(), "").expect("a record")
    };
    let pair = [
        made(|time| libm::sin(1.2 * TAU * time) + 0.5 * libm::cos(0.7 * TAU * time)),
        made(|time| 0.8 * libm::sin(0.9 * TAU * time + 0.4)),
    ];
    let table = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/pyrotd/pair.csv"));
    let rows: Vec<Vec<f64>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let [period, damping, rotd00, rotd50, rotd100] = row[..] else {
            panic!("{row:?}");
        };
        let found = spectrum([&pair[0], &pair[1]], &[period], damping)[0];
        // The least value is at a kink, which directions 0.01° apart miss by up to half of that.
        close(found.rotd00, rotd00, 0.5 * 0.01_f64.to_radians(), "RotD00");
        close(found.rotd50, rotd50, 1e-6, "RotD50");
        close(found.rotd100, rotd100, 1e-6, "RotD100");
    }
}
