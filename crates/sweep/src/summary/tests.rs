//! Summaries of runs in any parts and any order, compared with their single numbers.

use num_bigint::{BigInt, BigUint};
use pounding_assess::{Distribution, wilson_of};
use proptest::prelude::*;

use super::exact::Sums;
use super::form::{By, EventsOfMotions, Form, Summed};
use super::octaves::Octaves;
use super::table::{SummaryTable, middle};
use super::tally::Tally;
use crate::batch::Batch;
use crate::checked::Checked;

/// Largest promised relative error of a quantile \[–\]: half the width of a bin.
const BIN_ERROR: f64 = 1.0 / 128.0;

/// Two columns, the first for peaks; runs alternate between two cells by threes.
fn form(thresholds: &[f64]) -> Form {
    let column = |name: &str, is_peak, thresholds: &[f64]| Summed {
        name: name.into(),
        quantity: name.into(),
        is_peak,
        thresholds: thresholds.into(),
    };
    Form {
        events: None,
        by: vec![By {
            name: "gap".into(),
            values: vec!["0.1".into(), "0.2".into()],
            runs: 3,
        }],
        columns: vec![column("peak", true, thresholds), column("other", false, &[0.0])],
        quantiles: vec![0.0, 0.16, 0.5, 0.84, 0.99, 1.0],
        rows: false,
    }
}

/// Runs with these numbers; NaN in the first column is a failed run.
fn batch(start: u64, numbers: &[[f64; 2]]) -> Batch {
    let column = |column: usize| numbers.iter().map(|both| both[column]).collect();
    let is_failed = |both: &[f64; 2]| both[0].is_nan();
    let runs = start..start + numbers.len() as u64;
    let mut batch = Batch::of(runs, 0);
    batch.columns = vec![column(0), column(1)];
    let reason = |both: &[f64; 2]| is_failed(both).then(|| "it fails".into());
    batch.failed = numbers.iter().map(reason).collect();
    let checked = |both: &[f64; 2]| {
        if is_failed(both) { Checked::No } else { Checked::Beside }
    };
    batch.checked = numbers.iter().map(checked).collect();
    batch
}

/// Numbers of all sizes, some equal, some NaN.
fn numbers() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let number = prop_oneof![
        4 => -10.0..10.0,
        2 => (-20_i32..20).prop_map(f64::from),
        2 => prop::num::f64::ANY,
        1 => Just(f64::NAN),
        1 => Just(0.0),
    ];
    // A run that failed has no numbers.
    let both = (number.clone(), number).prop_map(|(one, other): (f64, f64)| if one.is_nan() { [f64::NAN; 2] } else { [one, other] });
    prop::collection::vec(both, 1..200)
}

fn added(numbers: &[f64]) -> Octaves {
    let mut all = Octaves::default();
    for number in numbers {
        all.add(*number);
    }
    all
}

/// A number as a whole multiple of the smallest number, from its digits.
fn whole(number: f64) -> BigInt {
    let bits = number.abs().to_bits();
    let (exponent, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
    let digits = BigInt::from(fraction + (u64::from(exponent > 0) << 52));
    let magnitude = digits << (exponent.max(1) - 1);
    if number < 0.0 { -magnitude } else { magnitude }
}

proptest! {
    /// Cut anywhere, merged in any order, stored as text in between: an equal table.
    #[test]
    fn limit_the_same_bytes_however_runs_are_cut(
        numbers in numbers(),
        cuts in prop::collection::vec(any::<prop::sample::Index>(), 0..6),
        turn in 0..6_usize,
    ) {
        let form = form(&[-1.0, 0.5, 3.0]);
        let mut at_once = Tally::default();
        at_once.add_batch(&form, &batch(7, &numbers));
        let mut places: Vec<usize> = cuts.iter().map(|cut| cut.index(numbers.len() + 1)).collect();
        places.extend([0, numbers.len()]);
        places.sort_unstable();
        let mut parts: Vec<Tally> = places.windows(2).map(|ends| {
            let mut part = Tally::default();
            part.add_batch(&form, &batch(7 + ends[0] as u64, &numbers[ends[0]..ends[1]]));
            Tally::of_line(&form, part.line().as_bytes()).expect("it was written")
        }).collect();
        let n = parts.len();
        parts.rotate_left(turn % n);
        if turn % 2 == 1 {
            parts.reverse();
        }
        let mut merged = Tally::default();
        for part in &parts {
            merged.merge(part);
        }
        prop_assert_eq!(merged.line(), at_once.line());
        let table = |tally| SummaryTable::new(form.clone(), tally).csv();
        prop_assert_eq!(table(merged), table(at_once));
    }

    /// Counts, ends and thresholds are exact, quantiles are within their bounds, and the bounds within the promised error.
    #[test]
    fn reference_a_summary_is_what_the_numbers_say(numbers in numbers()) {
        let form = form(&[-1.0, 0.5, 3.0]);
        let mut tally = Tally::default();
        tally.add_batch(&form, &batch(0, &numbers));
        let whole = tally.whole(&form);
        let failed = numbers.iter().filter(|both| both[0].is_nan()).count() as u64;
        prop_assert_eq!([whole.runs, whole.failed], [numbers.len() as u64, failed]);
        prop_assert_eq!(whole.beside + whole.failed, whole.runs);
        for (index, column) in whole.columns.iter().enumerate() {
            let finite = numbers.iter().map(|both| both[index]).filter(|number| number.is_finite());
            let taken = finite.map(|number| if index == 0 { number.abs() } else { number + 0.0 });
            let taken: Vec<f64> = taken.collect();
            prop_assert_eq!(column.numbers.count(), taken.len() as u64);
            for (above, threshold) in column.above.iter().zip(&form.columns[index].thresholds) {
                let wanted = taken.iter().filter(|number| *number > threshold).count();
                prop_assert_eq!(*above, wanted as u64);
            }
            let bars = column.numbers.histogram();
            for (near, far, count) in &bars {
                let ends = if near.total_cmp(far).is_gt() { [far, near] } else { [near, far] };
                // The bound towards zero belongs to the bar, the other bound does not.
                let is_in = |number: &&f64| {
                    let at_far = number.total_cmp(far).is_eq() && near.total_cmp(far).is_ne();
                    number.total_cmp(ends[0]).is_ge() && number.total_cmp(ends[1]).is_le() && !at_far
                };
                prop_assert_eq!(taken.iter().filter(is_in).count() as u64, *count, "{} to {}", near, far);
            }
            prop_assert_eq!(bars.iter().map(|bar| bar.2).sum::<u64>(), taken.len() as u64);
            let Some(wanted) = Distribution::of(taken) else {
                prop_assert_eq!(column.numbers.ends(), None);
                continue;
            };
            let ends = column.numbers.ends().expect("there are numbers");
            prop_assert!(ends.0.total_cmp(&wanted.sorted()[0]).is_eq() && ends.1.total_cmp(&wanted.largest()).is_eq());
            for part in &form.quantiles {
                let bounds = column.numbers.quantile(*part).expect("there are numbers");
                let wanted = wanted.quantile(*part);
                prop_assert!((bounds.0..=bounds.1).contains(&wanted), "{part}: {wanted} in {bounds:?}");
                let error = (middle(bounds) - wanted).abs();
                prop_assert!(error <= BIN_ERROR * wanted.abs() || wanted.abs() < 1e-300, "{part}: {error}");
            }
        }
    }

    /// Sums are exact, digit by digit.
    #[test]
    fn reference_sums_to_the_last_digit(numbers in prop::collection::vec(prop::num::f64::ANY, 0..100)) {
        let finite: Vec<f64> = numbers.into_iter().filter(|number| number.is_finite()).collect();
        let sums = Sums::of(&added(&finite));
        let each = || finite.iter().map(|number| whole(*number));
        let (sum, squares) = sums.digits();
        prop_assert_eq!(sum, &each().sum::<BigInt>());
        let wanted: BigInt = each().map(|one| &one * &one).sum();
        prop_assert_eq!(squares, wanted.magnitude() as &BigUint);
    }

    /// Mean and deviation of whole numbers whose sums fit into 128 bits.
    #[test]
    fn reference_mean_and_deviation(
        whole in prop::collection::vec(-1_000_000_i64..1_000_000, 2..100),
        scale in -1000..900_i32,
    ) {
        let scale = libm::scalbn(1.0, scale);
        let numbers: Vec<f64> = whole.iter().map(|one| *one as f64 * scale).collect();
        let sums = Sums::of(&added(&numbers));
        let n = i64::try_from(whole.len()).expect("a few");
        let sum: i64 = whole.iter().sum();
        prop_assert_eq!(sums.mean(), Some(sum as f64 / n as f64 * scale));
        let squares: i64 = whole.iter().map(|one| one * one).sum();
        let scatter = i128::from(n) * i128::from(squares) - i128::from(sum) * i128::from(sum);
        let wanted = (scatter as f64 / (n * (n - 1)) as f64).sqrt() * scale;
        let found = sums.deviation().expect("there are two or more");
        prop_assert!((found - wanted).abs() <= 4.0 * f64::EPSILON * wanted, "{found} and {wanted}");
    }
}

/// A large mean does not hide a small scatter, unlike sums of 53 bits.
#[test]
fn extreme_the_scatter_of_numbers_far_from_zero() {
    let numbers = [1e15 + 1.0, 1e15 + 2.0, 1e15 + 3.0];
    let sums = Sums::of(&added(&numbers));
    assert_eq!((sums.mean(), sums.deviation()), (Some(1e15 + 2.0), Some(1.0)));
    let huge = Sums::of(&added(&[f64::MAX, -f64::MAX, f64::MAX]));
    assert!(huge.mean().is_some_and(|mean| (mean / (f64::MAX / 3.0) - 1.0).abs() < 1e-15));
    assert_eq!(Sums::of(&added(&[])).mean(), None);
    assert_eq!(Sums::of(&added(&[1.0])).deviation(), None);
    assert_eq!(Sums::of(&added(&[1.0, 1.0])).deviation(), Some(0.0));
}

/// Bars of the histogram: eighths of octaves, and zeros separately.
#[test]
fn reference_bars_of_a_histogram() {
    let bars = added(&[0.0, -0.0, 1.0, 1.1, 1.125, 2.0, -3.0]).histogram();
    let wanted = [(-3.0, -3.25, 1), (0.0, 0.0, 2), (1.0, 1.125, 2), (1.125, 1.25, 1), (2.0, 2.25, 1)];
    assert_eq!(bars, wanted);
}

/// Rows of another form are refused.
#[test]
fn extreme_rows_of_another_form() {
    let form = form(&[]);
    let add = |rows: &str| Tally::default().add_rows(&form, 0..2, rows.as_bytes());
    assert!(add("0,a,false,1,2,beside,\n1,a,false,,,,reason\n"));
    for wrong in ["", "0,1\n", "0,a,false,1,2,beside,\n", "0,1,2,,\n1,1,2,,\n2,1,2,,\n"] {
        assert!(!add(wrong), "{wrong}");
    }
}

/// Both directions of a record counted as two independent runs: the bounds of a fragility were too narrow, and percentiles stood for three
/// events.
#[test]
fn issue_bounds_of_a_probability_count_events() {
    let of = |of_motion: &[usize], runs: u64| {
        let form = Form {
            events: Some(EventsOfMotions {
                of_motion: of_motion.into(),
                runs,
            }),
            by: Vec::new(),
            ..form(&[1.0])
        };
        let mut tally = Tally::default();
        tally.add_batch(&form, &batch(0, &[[2.0, 0.0]; 3]));
        tally.add_batch(&form, &batch(3, &[[0.5, 0.0]; 9]));
        let tally = Tally::of_line(&form, tally.line().as_bytes()).expect("it was written");
        let whole = SummaryTable::new(form, tally).whole();
        (whole[0].samples, whole[0].exceedances[0].bounds, whole[0].p84.is_some())
    };
    // Six motions of three events, each with two sets of values.
    assert_eq!(of(&[0, 0, 1, 1, 2, 2], 2), (3, wilson_of(0.25, 3), false));
    // Both directions of one record, with six sets of values.
    assert_eq!(of(&[0, 0], 6), (6, wilson_of(0.25, 6), false));
    // Twelve records.
    let each: Vec<usize> = (0..12).collect();
    assert_eq!(of(&each, 1), (12, wilson_of(0.25, 12), true));
}
