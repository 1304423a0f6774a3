//! COSMOS 1.2.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format, components};
use proptest::prelude::*;

use super::{accelerogram, component, file, readings, refusal, with};

#[test]
fn reference_channels_of_acceleration_alone() {
    let bytes = file("cosmos.v2");
    assert_eq!(components(bytes.as_bytes()).unwrap(), ["Sta Cha: 1: 340 deg", "Sta Cha: 2: up"]);
    let found = accelerogram(&bytes, &component("1"));
    assert_eq!(found.format(), Format::Cosmos);
    assert_eq!(found.unit(), AccelerationUnit::CentimetrePerSecondSquared);
    assert_eq!(found.time_step().to_string(), "0.01");
    assert_eq!(found.values()[..2], [-996.996_24, -623.219_34]);
    assert_eq!(found.values()[19..=19], [53.989_07]);
    assert_snapshot!(readings(&found), @r"
    format: COSMOS 1.2
    component (line 9): Sta Cha: 1: 340 deg
    number of samples (line 48): 20
    time step (line 38): 0.01 s
    unit (line 48): cm/s² (cm/sec2(04))
    peak in the header (line 38): number 64 of the block: -996.99624
    columns (line 48): 8 to a line, 10 bytes each
    ");
    let other = accelerogram(&bytes, &component("2"));
    assert_eq!(other.unit(), AccelerationUnit::StandardGravity);
}

#[test]
fn reference_counts_become_what_the_caller_says() {
    let declared = Declared {
        unit: Some(AccelerationUnit::CentimetrePerSecondSquared),
        per_count: Some(0.25),
        ..Declared::default()
    };
    let found = accelerogram(file("cosmos.v0"), &declared);
    assert_eq!(found.values()[..2], [-8865.5, -25811.5]);
    // In counts the mark of unknown values is a valid value.
    assert_eq!(found.values()[7..=7], [-249.75]);
    assert_snapshot!(readings(&found), @r"
    format: COSMOS 1.2
    component (line 9): Sta Cha: 3: 250 deg
    number of samples (line 48): 20
    time step (line 38): 0.005 s
    unit: cm/s² (declared)
    worth of a count: 0.25 (declared)
    peak in the header (line 38): number 64 of the block: -103246
    columns (line 48): 10 to a line, 8 bytes each
    ");
    assert_snapshot!(refusal(file("cosmos.v0"), &Declared::default()), @r#"line 48 reads "20  accel. pts, approx    0 secs, units=counts(50),Format=(1…": the values are counts of a digitiser; declare what one is worth as `per_count`, and in which `unit`"#);
    let without = Declared {
        per_count: None,
        acceleration: false,
        ..declared
    };
    assert_snapshot!(refusal(file("cosmos.v0"), &without), @r#"line 48 reads "20  accel. pts, approx    0 secs, units=counts(50),Format=(1…": the values are counts of a digitiser; declare what one is worth as `per_count`, and in which `unit`"#);
}

#[test]
fn extreme_header_and_values() {
    let refused = |from: &str, to: &str| refusal(with("cosmos.v2", from, to), &component("1"));
    assert_snapshot!(refused("     20  acceleration pts", "     21  acceleration pts"), @r#"the values end at line 51 after 20 of them (line 52 reads "/&  ----------  End of data for channel  1  ----------"), but the header declares 21; fetch the file again, or correct the header if the values are complete"#);
    assert_snapshot!(refused("approx    0 secs", "approx   70 secs"), @r#"line 48 reads "20  acceleration pts, approx   70 secs, units=cm/sec2(04),Fo…", but a duration that the number of values and the time step of the header give should stand there; fetch the file again"#);
    assert_snapshot!(refused("cm/sec2(04)", "in/sec2(07)"), @r#"line 48 reads "20  acceleration pts, approx    0 secs, units=in/sec2(07),Fo…" and names no unit of an acceleration that is known, such as g, g/10, mg, gal, cm/s/s, mm/s/s or m/s/s; if one of them is meant, write it there"#);
    assert_snapshot!(refused(",Format=(8F10.5)", ""), @r#"line 48 reads "20  acceleration pts, approx    0 secs, units=cm/sec2(04)", but a Fortran format such as Format=(8F10.5) should stand there; fetch the file again"#);
    assert_snapshot!(refused("  53.03927", "-999.00000"), @r#"line 51, field 1: "-999.00000" marks a missing value; cut the record before it or take another"#);
    assert_snapshot!(refused("    -996.996240", "    -699.996240"), @r#"line 38 states a peak of "number 64 of the block: -699.99624", but the largest value read is 996.99624 cm/s²; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refused("follow on  10 lines", "follow on many lines"), @r#"line 14 reads "100 Integer-header values follow on many lines, Format= (10I…", but the number of lines of the block below should stand there; fetch the file again"#);
    assert_snapshot!(refused("follow on  20 lines", "follow on 9999999999 lines"), @"the file ends at line 52, before the end of its header; fetch it again");
    assert_snapshot!(refused("      10.000000", "    -999.000000"), @"the file does not say how far apart its values are; declare it as `time_step` in seconds");
    let velocity = file("cosmos.v2").replace("Corrected acceleration ", "Corrected velocity ");
    assert_snapshot!(refusal(velocity, &Declared::default()), @r#"line 1 reads "Corrected velocity    (Format v01.20 with 13 text lines) Src…", but only histories of acceleration are read; take the channels of acceleration of the record"#);
}

#[test]
fn limit_a_step_that_the_header_leaves_out_may_be_declared() {
    let text = with("cosmos.v2", "      10.000000", "    -999.000000");
    let declared = Declared {
        time_step: Some(0.01),
        ..component("1")
    };
    assert_eq!(accelerogram(text, &declared).time_step().to_string(), "0.01");
}

/// A channel with these fields, `per_line` on each line, without header numbers.
fn channel(format: &str, per_line: usize, fields: &[String]) -> String {
    let rows: Vec<String> = fields.chunks(per_line).map(<[String]>::concat).collect();
    format!(
        "Corrected acceleration (Format v01.20 with 1 text lines)\n0 Integer-header values follow on 0 lines\n\
         0 Real-header values follow on 0 lines\n0 Comment line(s)\n\
         {} acceleration pts, units=g(02),Format=({per_line}{format})\n{}\n/&\n",
        fields.len(),
        rows.join("\n")
    )
}

proptest! {
    #[test]
    fn reference_numbers_written_in_fixed_columns_come_back(
        numbers in prop::collection::vec(-99_999_999..99_999_999_i32, 1..60),
        per_line in 1..12_usize,
        decimals in 1..8_usize,
    ) {
        let declared = Declared { time_step: Some(0.01), ..Declared::default() };
        let scale: f64 = format!("1e-{decimals}").parse().unwrap();
        let values: Vec<f64> = numbers.iter().map(|number| f64::from(*number) * scale).collect();
        // The columns are no wider than the widest number, so numbers touch.
        let fields: Vec<String> = values.iter().map(|value| format!("{value:.decimals$}")).collect();
        let width = fields.iter().map(String::len).max().unwrap();
        let padded: Vec<String> = fields.iter().map(|field| format!("{field:>width$}")).collect();
        let text = channel(&format!("F{width}.{decimals}"), per_line, &padded);
        let expected: Vec<f64> = fields.iter().map(|field| field.parse().unwrap()).collect();
        let found = accelerogram(text, &declared);
        prop_assert_eq!(found.values(), &expected[..]);

        let fields: Vec<String> = values.iter().map(|value| format!("{value:.decimals$E}")).collect();
        let width = fields.iter().map(String::len).max().unwrap();
        let padded: Vec<String> = fields.iter().map(|field| format!("{field:>width$}")).collect();
        let text = channel(&format!("E{width}.{decimals}"), per_line, &padded);
        let expected: Vec<f64> = fields.iter().map(|field| field.parse().unwrap()).collect();
        let found = accelerogram(text, &declared);
        prop_assert_eq!(found.values(), &expected[..]);
    }
}
