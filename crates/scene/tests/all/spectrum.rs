//! Response spectra against closed forms, printed values, and another method.

use std::f64::consts::{PI, TAU};

use pounding_motion::{Record, RickerPulse};
use pounding_scene::{SpectralValues, SpectrumIntensities, periods_between, response_spectrum, scaled_to_sa};

/// One inch \[m\].
const INCH: f64 = 0.0254;

/// El Centro as Chopra prints it.
pub(crate) fn el_centro() -> Record {
    let text = include_str!(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../studies/records/el-centro-1940-ns-chopra.csv"
    ));
    let record = pounding_motion::read(text.as_bytes()).expect("the record is readable");
    record.into_record(9.81).expect("the record is finite")
}

fn at(record: &Record, period: f64, damping_ratio: f64) -> SpectralValues {
    response_spectrum(record, &[period], damping_ratio).expect("a spectrum")[0]
}

fn close(found: f64, wanted: f64) {
    assert!((found / wanted - 1.0).abs() < 1e-12, "{found} against {wanted}");
}

#[test]
fn reference_a_step_overshoots_by_the_closed_form() {
    let a = 1.7;
    let step = Record::new(0.01, vec![a; 501], "").expect("a record");
    for period in [0.05, 0.3, 1.0, 2.5] {
        for z in [0.0_f64, 0.02, 0.05, 0.3, 0.7] {
            let w = TAU / period;
            let root = (1.0 - z * z).sqrt();
            let found = at(&step, period, z);
            let overshoot = 1.0 + libm::exp(-PI * z / root);
            close(found.displacement, a / (w * w) * overshoot);
            close(found.pseudo_velocity, a / w * overshoot);
            close(found.pseudo_acceleration, a * overshoot);
            // The absolute acceleration is a (1 − exp(−ζωt) (cos ω_d t − ζω/ω_d sin ω_d t)); its peak is where its rate is zero.
            let angle = PI - libm::atan2(2.0 * z * root, 1.0 - 2.0 * z * z);
            let bracket = libm::cos(angle) - z / root * libm::sin(angle);
            let absolute = a * (1.0 - libm::exp(-z / root * angle) * bracket);
            close(found.absolute_acceleration, absolute);
        }
    }
}

#[test]
fn reference_a_short_push_peaks_in_the_free_vibration_after_it() {
    let (a, duration) = (2.0, 0.1);
    let push = Record::new(0.05, vec![a; 3], "").expect("a record");
    for period in [0.3, 1.0, 10.0, 100.0] {
        let w = TAU / period;
        let wanted = 2.0 * a / (w * w) * libm::sin(0.5 * w * duration);
        close(at(&push, period, 0.0).displacement, wanted);
    }
}

#[test]
fn limit_a_stiff_structure_moves_with_the_ground_and_a_soft_one_stays() {
    let pulse = RickerPulse {
        amplitude: 3.0,
        frequency: 2.0,
        time_step: 0.005,
    };
    let pulse = pulse.record().expect("a pulse");
    let (pga, pgd) = (pulse.measures().pga, pulse.measures().pgd);
    let still = at(&pulse, 0.0, 0.05);
    let nothing = [still.displacement, still.pseudo_velocity].map(|value| value.to_string());
    assert_eq!(nothing, ["0", "0"]);
    close(still.pseudo_acceleration, pga);
    close(still.absolute_acceleration, pga);
    let stiff = at(&pulse, 1e-3, 0.05);
    assert!((stiff.pseudo_acceleration / pga - 1.0).abs() < 1e-3, "{stiff:?}");
    assert!((stiff.absolute_acceleration / pga - 1.0).abs() < 1e-3, "{stiff:?}");
    let soft = at(&pulse, 1e3, 0.05);
    assert!((soft.displacement / pgd - 1.0).abs() < 1e-3, "{soft:?} {pgd}");
}

/// Chopra, *Dynamics of Structures*, Fig. 6.4.1. The book reads its responses every 0.02 s. If a peak lies between, as for 0.5 s, ours is
/// larger by up to (ωΔt/2)²/2 of it.
#[test]
fn reference_peak_deformations_of_chopra() {
    let record = el_centro();
    for (period, ratio, printed) in [
        (0.5, 0.02, 2.67),
        (1.0, 0.02, 5.97),
        (2.0, 0.02, 7.47),
        (2.0, 0.0, 9.91),
        (2.0, 0.05, 5.37),
    ] {
        let found = at(&record, period, ratio).displacement / INCH;
        let between = 0.5 * (PI / period * 0.02) * (PI / period * 0.02);
        let allowed = printed - 0.01..(printed + 0.01) * (1.0 + between);
        assert!(allowed.contains(&found), "T = {period} s: {found} against {printed} in");
    }
}

/// Largest displacement at the samples, by the recurrence for a load that is linear between them (N. C. Nigam and
/// P. C. Jennings, *Bull. Seism. Soc. Am.* 59 (1969) 909), written with the complementary and the particular solution.
fn by_recurrence(record: &Record, period: f64, z: f64) -> f64 {
    let dt = record.time_step();
    let w = TAU / period;
    let wd = w * (1.0 - z * z).sqrt();
    let decay = libm::exp(-z * w * dt);
    let (sine, cosine) = (libm::sin(wd * dt), libm::cos(wd * dt));
    let [mut u, mut v, mut largest] = [0.0_f64; 3];
    for pair in record.samples().windows(2) {
        let slope = (pair[1] - pair[0]) / dt;
        // u_p = p + q·t solves ü + 2ζωu̇ + ω²u = −a − slope·t.
        let q = -slope / (w * w);
        let p = (-pair[0] - 2.0 * z * w * q) / (w * w);
        let c = u - p;
        let s = (v - q + z * w * c) / wd;
        let free = decay * (c * cosine + s * sine);
        u = p + q * dt + free;
        v = q + decay * wd * (s * cosine - c * sine) - z * w * free;
        largest = largest.max(u.abs());
    }
    largest
}

#[test]
fn reference_another_method_finds_the_same_peaks() {
    let record = el_centro();
    let fine = record.resampled(0.02 / 16.0).expect("a finer record");
    for period in [0.05, 0.1, 0.22, 0.5, 1.0, 2.0, 3.7] {
        for ratio in [0.0, 0.02, 0.05, 0.2] {
            let found = at(&record, period, ratio).displacement;
            let sampled = by_recurrence(&fine, period, ratio);
            // At most half a sample beside a peak, the displacement is smaller because of the acceleration there.
            let frequency = TAU / period;
            let acceleration = frequency * frequency * found + record.measures().pga;
            let between = 0.5 * acceleration * (0.01 / 16.0) * (0.01 / 16.0);
            let apart = found - sampled;
            let allowed = -1e-12 * found..between;
            assert!(allowed.contains(&apart), "{period} {ratio}: {apart} not in {allowed:?}");
        }
    }
}

#[test]
fn limit_a_spectrum_is_the_same_for_the_reversed_and_twice_for_the_doubled_record() {
    let record = el_centro();
    let periods = [0.0, 0.1, 0.5, 2.0, 0.7];
    let spectrum = |record: &Record| response_spectrum(record, &periods, 0.05).expect("a spectrum");
    let once = spectrum(&record);
    assert_eq!(once.iter().map(|values| values.period).collect::<Vec<_>>(), periods);
    assert_eq!(spectrum(&record.reversed()), once);
    for (twice, once) in spectrum(&record.scaled(2.0).expect("finite")).iter().zip(&once).skip(1) {
        close(twice.displacement, 2.0 * once.displacement);
        close(twice.absolute_acceleration, 2.0 * once.absolute_acceleration);
    }
}

#[test]
fn limit_zeros_after_the_record_change_nothing() {
    let record = el_centro();
    let samples = record.samples();
    // The record is cut within the strong shaking, so that the free vibration after it holds the largest response.
    for length in [100, 110, 123, 250] {
        let mut longer = samples[..length].to_vec();
        longer.push(0.0);
        let ended = Record::new(0.02, longer.clone(), "").expect("a record");
        longer.extend([0.0; 1000]);
        let rested = Record::new(0.02, longer, "").expect("a record");
        for (period, ratio) in [(0.3, 0.0), (1.0, 0.05), (2.0, 0.0), (2.0, 0.5), (1.5, 1.0)] {
            let (ended, rested) = (at(&ended, period, ratio), at(&rested, period, ratio));
            close(ended.displacement, rested.displacement);
            close(ended.absolute_acceleration, rested.absolute_acceleration);
        }
    }
}

#[test]
fn reference_scaled_to_a_spectral_acceleration() {
    let record = el_centro();
    for period in [0.0, 0.2, 1.0] {
        let scaled = scaled_to_sa(&record, period, 0.05, 3.3).expect("a record");
        close(at(&scaled, period, 0.05).pseudo_acceleration, 3.3);
    }
}

#[test]
fn extreme_spectra_that_cannot_be() {
    let record = el_centro();
    let error = |periods: &[f64], ratio| response_spectrum(&record, periods, ratio).expect_err("refused").to_string();
    let still = Record::new(0.01, vec![0.0; 9], "").expect("a record");
    let none = scaled_to_sa(&still, 1.0, 0.05, 2.0).expect_err("refused");
    assert!(none.to_string().contains("without any acceleration"), "{none:?}");
    let target = scaled_to_sa(&record, 1.0, 0.05, 0.0).expect_err("refused");
    insta::assert_snapshot!(
        [
            error(&[1.0, -1.0], 0.05),
            error(&[f64::NAN], 0.05),
            error(&[1e-200], 0.05),
            error(&[1.0, 2.0, 1e7], 0.05),
            error(&[1.0], 1.01),
            error(&[1.0], f64::NAN),
            error(&[1e-5], 0.05),
            none.to_string(),
            target.to_string(),
        ]
        .join("\n")
    );
    assert_eq!(response_spectrum(&record, &[], 0.05), Ok(vec![]));
    let one = Record::new(0.01, vec![3.0], "").expect("a record");
    assert!(response_spectrum(&one, &[0.0, 1e-6, 1.0, 1e6], 1.0).is_ok(), "one sample");
    let strongest = Record::new(0.01, vec![0.0, Record::STRONGEST, 0.0], "").expect("a record");
    let strongest = response_spectrum(&strongest, &[1e6], 0.0);
    assert!(strongest.is_ok(), "{strongest:?}");
}

#[test]
fn limit_periods_rise_in_equal_ratios_between_exact_ends() {
    let periods = periods_between(0.02, 10.0, 60);
    assert_eq!((periods.len(), periods[0], periods[59]), (60, 0.02, 10.0));
    let ratio = periods[1] / periods[0];
    for pair in periods.windows(2) {
        assert!((pair[1] / pair[0] / ratio - 1.0).abs() < 1e-13, "{pair:?}");
    }
    assert_eq!(periods_between(0.5, 2.0, 1), [0.5]);
    assert!(periods_between(0.5, 2.0, 0).is_empty());
}

/// Under a step of constant acceleration an undamped oscillator would have PSA = 2a; with damping the closed form of the overshoot.
#[test]
fn reference_spectrum_intensities_of_a_step() {
    let a = 1.3;
    let step = Record::new(0.01, vec![a; 1001], "").expect("a record");
    let found = SpectrumIntensities::of(&step).expect("a spectrum");
    let z: f64 = 0.05;
    let psa = a * (1.0 + libm::exp(-PI * z / (1.0 - z * z).sqrt()));
    close(found.asi, 0.4 * psa);
    // PSV = PSA T/2π, and a straight line is integrated exactly.
    close(found.housner, psa / TAU * 0.5 * (2.5 * 2.5 - 0.1 * 0.1));
}
