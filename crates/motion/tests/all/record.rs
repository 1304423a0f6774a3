//! A record between its samples, at its ends, and under each operation.

use pounding_motion::Record;

fn record(time_step: f64, samples: &[f64]) -> Record {
    Record::new(time_step, samples.to_vec(), "made up").expect("a valid record")
}

fn same(left: f64, right: f64) -> bool {
    left.to_bits() == right.to_bits()
}

#[test]
fn reference_linear_between_samples_and_zero_outside() {
    let record = record(0.5, &[1.0, 3.0, -1.0]);
    let cases = [
        (0.0, 1.0),
        (0.25, 2.0),
        (0.5, 3.0),
        (0.625, 2.0),
        (1.0, -1.0),
        (-0.01, 0.0),
        (1.01, 0.0),
    ];
    for (time, acceleration) in cases {
        assert!(same(record.at(time), acceleration), "at {time} s: {}", record.at(time));
    }
    assert!(same(record.duration(), 1.0), "two steps of 0.5 s");
}

#[test]
fn reference_peak_keeps_its_sign_and_is_the_first_of_equals() {
    assert_eq!(record(0.5, &[1.0, -3.0, 3.0]).peak(), (0.5, -3.0));
    assert_eq!(record(0.5, &[0.0]).peak(), (0.0, 0.0));
}

#[test]
fn reference_resampling_halves_and_doubles_the_step() {
    let coarse = record(0.5, &[0.0, 2.0, -2.0]);
    assert_eq!(coarse.resampled(0.25).unwrap().samples(), [0.0, 1.0, 2.0, 0.0, -2.0]);
    assert_eq!(coarse.resampled(1.0).unwrap().samples(), [0.0, -2.0]);
    // 0.25 s remain after the last grid point of 0.75 s: less than one step, hence dropped.
    assert_eq!(coarse.resampled(0.75).unwrap().samples(), [0.0, 0.0]);
}

#[test]
fn reference_scaled_and_reversed() {
    let record = record(0.5, &[1.0, -3.0]);
    assert_eq!(record.scaled(-2.0).unwrap().samples(), [-2.0, 6.0]);
    assert_eq!(record.reversed().samples(), [-1.0, 3.0]);
    assert_eq!(record.reversed().source(), "made up");
}

#[test]
fn limit_a_record_resampled_at_its_own_step_is_itself() {
    let samples: Vec<f64> = (0..4000).map(|step| f64::from(step % 17) * 0.1).collect();
    for time_step in [0.01, 0.005, 0.02, 1.0 / 256.0, 0.003] {
        let record = record(time_step, &samples);
        assert_eq!(record.resampled(time_step).unwrap(), record);
        for (index, &sample) in samples.iter().enumerate() {
            assert!(same(record.at(index as f64 * time_step), sample), "{index} × {time_step} s");
        }
    }
}

#[test]
fn extreme_times_that_are_no_time() {
    for record in [record(0.5, &[4.0]), record(0.5, &[4.0, 5.0]), record(1e-320, &[4.0, 5.0])] {
        assert!(record.at(f64::NAN).is_nan(), "NaN in, NaN out");
        assert!(same(record.at(f64::INFINITY), 0.0), "after the last sample");
        assert!(same(record.at(f64::NEG_INFINITY), 0.0), "before the first sample");
        assert!(same(record.at(0.0), 4.0), "the first sample");
    }
}

#[test]
fn extreme_numbers_that_make_no_record() {
    let refused = |time_step, samples: &[f64]| Record::new(time_step, samples.to_vec(), "").unwrap_err();
    insta::assert_snapshot!(refused(-0.01, &[1.0]), @"time_step: found -0.01 s, allowed are more than 0 s and up to 1e6 s; correct it");
    insta::assert_snapshot!(refused(f64::NAN, &[1.0]), @"time_step: found NaN s, allowed are more than 0 s and up to 1e6 s; correct it");
    insta::assert_snapshot!(refused(0.01, &[1.0, f64::INFINITY]), @"the acceleration of sample 1 (the first is 0) is inf m/s², allowed are up to 1e9 m/s² either way; correct its unit or its factor");
    insta::assert_snapshot!(refused(0.01, &[]), @"found no sample, allowed is at least one sample");

    let record = record(0.01, &[1.0, 1e9]);
    insta::assert_snapshot!(record.scaled(f64::NAN).unwrap_err(), @"found a factor of NaN, allowed is a finite one; take a lower target, or a stronger motion");
    insta::assert_snapshot!(record.scaled(1e300).unwrap_err(), @"the acceleration of sample 0 (the first is 0) is 1e300 m/s², allowed are up to 1e9 m/s² either way; correct its unit or its factor");
    insta::assert_snapshot!(record.resampled(0.0).unwrap_err(), @"time_step: found 0 s, allowed are more than 0 s and up to 1e6 s; correct it");
    insta::assert_snapshot!(record.resampled(1e-300).unwrap_err(), @"time_step: found 1e-300 s, which over 0.01 s makes more than 10000000 samples, allowed is a longer step");
}
