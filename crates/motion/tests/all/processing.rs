//! Trends, filters and peaks of records.

use std::f64::consts::TAU;

use pounding_motion::{BandPass, Passes, Record, Trend};
use proptest::prelude::*;

fn record(time_step: f64, samples: Vec<f64>) -> Record {
    Record::new(time_step, samples, "made up").expect("a valid record")
}

fn band(order: u32, low_corner: f64, high_corner: f64, passes: Passes) -> BandPass {
    BandPass {
        order,
        low_corner,
        high_corner,
        passes,
    }
}

/// A record like noise on a ramp, with the same values in any language.
fn rough() -> Vec<f64> {
    let sample = |index: u32| f64::from((index * 7919) % 101) / 50.0 - 1.0 + 0.01 * f64::from(index);
    (0..120).map(sample).collect()
}

/// Order, corners \[Hz\] and time step \[s\], then results of scipy 1.17 for the rough record. They are samples 0, 1, 60 and 119 of
/// `sosfiltfilt`, then of `sosfilt`, with the sections of `butter(order, [low, high], "bandpass", fs=1/dt)`.
const SCIPY: &str = "\
4 0.1 25.0 0.01  0.1307972354877549 1.0642260142124298 1.241905392337023 0.2431935488939007  -0.09280495787097971 -0.38611207947962084 0.62466763246554 0.5496529420333768
3 0.5 10.0 0.01  -0.05150748874437039 0.29621988881003414 0.15350228589017484 -0.09839591074778253  -0.015878347948126138 -0.07846718740433375 0.06111002849647751 -0.047343364698545776
1 0.2 20.0 0.02  -0.0018081752896053072 0.9162934853349074 0.3853774432156857 0.2949961024344524  -0.7468982641182367 -0.4768977965883725 0.3046292548156354 0.29951015199056474
2 1.0 1.1 0.01  -0.001580989308217166 -0.001434853432606974 -0.00013535817256683227 1.839111802160446e-05  -9.825916820482023e-06 -4.0801642461480084e-05 0.0024510093261861984 0.0007751236044093446
8 0.1 40.0 0.01  0.01754094392941541 1.1234923935249408 0.7083064038096565 -0.06977863141063484  -0.18958469058246222 -0.6361222160700235 0.30572441146706064 0.09618180852836106";

#[test]
fn reference_the_samples_that_scipy_gives() {
    for line in SCIPY.lines() {
        let numbers: Vec<f64> = line.split_whitespace().map(|number| number.parse().expect("a number")).collect();
        let order = line.split(' ').next().map(str::parse);
        let order = order.expect("a number").expect("an order");
        let record = record(numbers[3], rough());
        for (passes, wanted) in [(Passes::ForwardAndBackward, &numbers[4..8]), (Passes::Forward, &numbers[8..12])] {
            let filter = band(order, numbers[1], numbers[2], passes);
            let found = record.band_passed(&filter).unwrap();
            for (index, wanted) in [0, 1, 60, 119].into_iter().zip(wanted) {
                let found = found.samples()[index];
                assert!(
                    (found - wanted).abs() < 1e-10,
                    "order {order}, {passes:?}, sample {index}: {found} against {wanted}"
                );
            }
        }
    }
}

/// Root mean square of ten seconds in the middle of a harmonic of unit amplitude, after the filter, times √2.
#[expect(clippy::disallowed_methods, reason = "a sine in a test")]
fn gain(filter: &BandPass, frequency: f64) -> f64 {
    let samples = (0..10_000).map(|step| (TAU * frequency * 0.01 * f64::from(step)).sin());
    let filtered = record(0.01, samples.collect()).band_passed(filter);
    let filtered = filtered.expect("a valid filter");
    // The middle is away from both ends: a filter that runs backward starts at the last one.
    let middle = &filtered.samples()[4_000..5_000];
    let square: f64 = middle.iter().map(|sample| sample * sample).sum();
    (2.0 * square / 1_000.0).sqrt()
}

#[test]
fn reference_gain_is_one_over_root_two_at_the_corners_in_every_pass() {
    for order in 1..=10 {
        for corner in [1.0, 10.0] {
            let forward = gain(&band(order, 1.0, 10.0, Passes::Forward), corner);
            let both = gain(&band(order, 1.0, 10.0, Passes::ForwardAndBackward), corner);
            assert!((forward - 0.5_f64.sqrt()).abs() < 1e-9, "{order}: {forward}");
            assert!((both - 0.5).abs() < 1e-9, "{order}: {both}");
        }
        let centre = gain(&band(order, 1.0, 10.0, Passes::Forward), 3.2);
        assert!((0.99..1.0 + 1e-9).contains(&centre), "{order}: {centre}");
    }
    let outside = gain(&band(4, 1.0, 10.0, Passes::Forward), 0.1);
    assert!(outside < 2e-4, "falls like the fourth power: {outside}");
}

#[test]
fn limit_no_phase_turned_in_time() {
    // A pulse far from both ends that is symmetrical about its middle stays symmetrical.
    let mut samples = vec![0.0; 6001];
    for (offset, value) in [(0, 3.0), (1, 2.0), (2, -1.0), (7, 0.5)] {
        samples[3000 + offset] = value;
        samples[3000 - offset] = value;
    }
    let filter = band(4, 0.5, 20.0, Passes::ForwardAndBackward);
    let filtered = record(0.01, samples).band_passed(&filter).unwrap();
    for offset in 0..1000 {
        let [left, right] = [3000 - offset, 3000 + offset].map(|index| filtered.samples()[index]);
        assert!((left - right).abs() < 1e-12, "{offset}: {left} {right}");
    }
}

#[test]
fn limit_no_offset_passes() {
    let filter = band(4, 0.1, 25.0, Passes::ForwardAndBackward);
    let filtered = record(0.01, vec![2.0; 3000]).band_passed(&filter).unwrap();
    assert!(filtered.peak().1.abs() < 1e-11, "{:?}", filtered.peak());
}

#[test]
fn extreme_filters_that_cannot_be() {
    let record = record(0.01, rough());
    let error = |order, low, high| {
        let filter = band(order, low, high, Passes::ForwardAndBackward);
        record.band_passed(&filter).expect_err("refused").to_string()
    };
    insta::assert_snapshot!(
        [
            error(0, 0.1, 25.0),
            error(11, 0.1, 25.0),
            error(4, 0.0, 25.0),
            error(4, 9e-5, 25.0),
            error(4, f64::NAN, 25.0),
            error(4, 0.1, 50.0),
            error(4, 0.1, f64::NAN),
            error(4, 25.0, 25.0),
            error(4, 26.0, 25.0),
        ]
        .join("\n")
    );
    let short = Record::new(0.01, vec![1.0; 27], "").unwrap();
    let filter = band(4, 0.1, 25.0, Passes::ForwardAndBackward);
    insta::assert_snapshot!(short.band_passed(&filter).expect_err("refused"));
    let enough = Record::new(0.01, vec![1.0; 28], "").unwrap();
    assert!(enough.band_passed(&filter).is_ok(), "one more than the padding");
    let forward = band(4, 0.1, 25.0, Passes::Forward);
    assert!(short.band_passed(&forward).is_ok(), "no padding forward");
}

#[test]
fn extreme_narrow_low_and_wide_bands_stay_bounded() {
    let mut samples = vec![0.0; 50_000];
    samples[10] = 1.0;
    let record = record(0.005, samples);
    for (low, high) in [(2.1e-4, 2.2e-4), (1e-3, 1.1e-3), (1e-3, 99.9), (99.0, 99.9), (5.0, 5.001)] {
        for order in [1, 2, 5, 10] {
            for passes in [Passes::Forward, Passes::ForwardAndBackward] {
                let filtered = record.band_passed(&band(order, low, high, passes)).unwrap();
                let peak = filtered.peak().1.abs();
                assert!(peak <= 1.0 + 1e-9, "{low} {high} {order} {passes:?}: {peak}");
            }
        }
    }
}

#[test]
fn reference_trends_are_found_and_removed() {
    let ramp: Vec<f64> = (0..1001).map(|step| 3.0 - 0.5 * f64::from(step)).collect();
    let linear = record(0.01, ramp.clone()).detrended(Trend::Linear).unwrap();
    assert!(linear.peak().1.abs() < 1e-10, "{:?}", linear.peak());
    let constant = record(0.01, ramp).detrended(Trend::Constant).unwrap();
    assert_eq!(constant.samples()[0].to_string(), "250");
    // scipy.signal.detrend([0, 1, 0, 5]): the line through it is 0.1·(−6 … ) = −0.6 + 1.4 i.
    let found = record(0.5, vec![0.0, 1.0, 0.0, 5.0]).detrended(Trend::Linear).unwrap();
    for (found, wanted) in found.samples().iter().zip([0.6, 0.2, -2.2, 1.4]) {
        assert!((found - wanted).abs() < 1e-15, "{found} against {wanted}");
    }
}

#[test]
fn extreme_trends_of_one_and_two_samples_and_of_too_much() {
    for trend in [Trend::Constant, Trend::Linear] {
        let one = record(0.5, vec![3.0]).detrended(trend).unwrap();
        assert_eq!(one.samples(), [0.0]);
    }
    let two = record(0.5, vec![3.0, 5.0]).detrended(Trend::Linear).unwrap();
    assert_eq!(two.samples(), [0.0, 0.0]);
    let strongest = record(0.5, vec![Record::STRONGEST; 3]).detrended(Trend::Constant);
    assert!(strongest.is_ok(), "{strongest:?}");
}

#[test]
fn reference_scaled_to_a_peak() {
    let scaled = record(0.5, vec![1.0, -4.0, 2.0]).scaled_to_peak(3.0).unwrap();
    assert_eq!(scaled.samples(), [0.75, -3.0, 1.5]);
    let none = record(0.5, vec![0.0; 3]).scaled_to_peak(3.0);
    insta::assert_snapshot!(none.expect_err("refused"));
    for target in [-1.0, f64::NAN, f64::INFINITY] {
        let refused = record(0.5, vec![1.0]).scaled_to_peak(target);
        assert!(
            refused.is_err_and(|refused| refused.to_string().starts_with("target: ")),
            "{target}"
        );
    }
}

proptest! {
    // Doubling and the change of sign are exact, so every bit follows.
    #[test]
    fn limit_twice_the_motion_is_twice_the_filtered_motion_bit_for_bit(
        samples in prop::collection::vec(-20.0..20.0_f64, 40..200),
        order in 1..5_u32,
    ) {
        let record = record(0.01, samples);
        for passes in [Passes::Forward, Passes::ForwardAndBackward] {
            let filter = band(order, 0.3, 30.0, passes);
            let twice = |record: &Record| record.scaled(2.0).unwrap();
            let filtered = record.band_passed(&filter).unwrap();
            prop_assert_eq!(twice(&record).band_passed(&filter).unwrap(), twice(&filtered));
            prop_assert_eq!(record.reversed().band_passed(&filter).unwrap(), filtered.reversed());
        }
        let line = record.detrended(Trend::Linear).unwrap();
        prop_assert_eq!(record.reversed().detrended(Trend::Linear).unwrap(), line.reversed());
        let again = line.detrended(Trend::Linear).unwrap();
        for (once, twice) in line.samples().iter().zip(again.samples()) {
            prop_assert!((once - twice).abs() < 1e-12, "{} {}", once, twice);
        }
    }

    #[test]
    fn limit_the_filtered_sum_is_the_sum_of_the_filtered(
        pairs in prop::collection::vec((-20.0..20.0_f64, -20.0..20.0_f64), 40..200),
    ) {
        let filter = band(4, 0.3, 30.0, Passes::ForwardAndBackward);
        let filtered = |pick: fn(&(f64, f64)) -> f64| {
            record(0.01, pairs.iter().map(pick).collect()).band_passed(&filter).unwrap()
        };
        let (left, right, sum) = (filtered(|p| p.0), filtered(|p| p.1), filtered(|p| p.0 + p.1));
        for (index, sum) in sum.samples().iter().enumerate() {
            let apart = sum - left.samples()[index] - right.samples()[index];
            prop_assert!(apart.abs() < 1e-10, "{}", apart);
        }
    }
}
