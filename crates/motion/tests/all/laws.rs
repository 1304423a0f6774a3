//! Laws that hold for every record and every text.

use pounding_motion::{Record, components, read};
use proptest::prelude::*;

/// A value as Fortran writes it in `Ew.7`: without the zero before the point, as PEER does.
fn exponential(value: f64, width: usize) -> String {
    let text = format!("{value:.6e}");
    let (mantissa, exponent) = text.split_once('e').expect("a number in exponent notation");
    let (sign, digits) = mantissa.strip_prefix('-').map_or(("", mantissa), |digits| ("-", digits));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let exponent = if value == 0.0 { 0 } else { exponent + 1 };
    let digits = digits.replace('.', "");
    let field = format!("{sign}.{digits}E{exponent:+03}");
    format!("{field:>width$}")
}

fn at2(fields: &[String], columns: usize) -> String {
    let lines: Vec<String> = fields.chunks(columns).map(|line| line.concat() + "\n").collect();
    let n_samples = fields.len();
    format!(
        "A\nB\nACCELERATION IN UNITS OF G\nNPTS= {n_samples}, DT= .0050 SEC\n{}",
        lines.concat()
    )
}

/// The number in a separate field.
fn alone(field: &str) -> f64 {
    field.trim().parse().expect("a number")
}

proptest! {
    // Two routes: each field read alone, and all of them touching in lines.
    #[test]
    fn limit_touching_numbers_are_read_as_if_alone(
        values in prop::collection::vec(-2.0..2.0_f64, 1..40),
        width in 13..16_usize,
        columns in 1..9_usize,
    ) {
        let fields: Vec<String> = values.iter().map(|value| exponential(*value, width)).collect();
        let expected: Vec<f64> = fields.iter().map(|field| alone(field)).collect();
        let found = read(at2(&fields, columns).as_bytes()).unwrap();
        prop_assert_eq!(found.values(), expected);
    }

    #[test]
    fn limit_touching_decimals_are_read_as_if_alone(
        values in prop::collection::vec(-999.0..9999.0_f64, 1..40),
        columns in 1..9_usize,
    ) {
        let fields: Vec<String> = values.iter().map(|value| format!("{value:10.5}")).collect();
        let expected: Vec<f64> = fields.iter().map(|field| alone(field)).collect();
        let found = read(at2(&fields, columns).as_bytes()).unwrap();
        prop_assert_eq!(found.values(), expected);
    }

    #[test]
    fn limit_a_csv_is_read_as_written(
        values in prop::collection::vec(-2.0..2.0_f64, 2..60),
        milliseconds in 1..50_u32,
    ) {
        let rows: Vec<String> = (0_u32..)
            .zip(&values)
            .map(|(step, value)| format!("{:.3},{value}\n", f64::from(step * milliseconds) / 1000.0))
            .collect();
        let found = read(format!("time_s,acceleration_g\n{}", rows.concat()).as_bytes()).unwrap();
        prop_assert_eq!(found.values(), values);
        prop_assert_eq!(found.time_step().to_bits(), (f64::from(milliseconds) / 1000.0).to_bits());
    }

    #[test]
    fn limit_resampling_to_a_fraction_keeps_every_sample(
        samples in prop::collection::vec(-20.0..20.0_f64, 1..60),
        time_step in 0.001..0.1_f64,
        parts in 1..12_u32,
    ) {
        let record = Record::new(time_step, samples, "").unwrap();
        let fine = record.resampled(time_step / f64::from(parts)).unwrap();
        let kept: Vec<f64> = fine.samples().iter().copied().step_by(parts as usize).collect();
        prop_assert_eq!(kept, record.samples());
        prop_assert!(fine.peak().1.abs() <= record.peak().1.abs(), "a line is below its ends");
        prop_assert_eq!(record.reversed().reversed(), record);
    }

    #[test]
    fn extreme_any_bytes_are_answered_without_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = (read(&bytes), components(&bytes));
    }

    // Nearly correct texts reach more code than random bytes.
    #[test]
    fn extreme_any_values_after_a_right_header_are_answered_without_panic(
        values in "[-+.eED0-9 \r\n,\"#\u{b2}]{0,120}",
    ) {
        let _ = read(format!("a\nb\nACCELERATION IN G\nNPTS= 3, DT= .01\n{values}").as_bytes());
        let _ = read(format!("time_s,acceleration_g\n{values}").as_bytes());
        let _ = read(format!("a\nb\nACCELERATION IN G\nNPTS {values} DT\n .5 .25").as_bytes());
    }
}
