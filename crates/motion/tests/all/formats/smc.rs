//! USGS SMC.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format, components};

use super::{accelerogram, file, readings, refusal, with};

fn refused(from: &str, to: &str) -> String {
    refusal(with("usgs.smc", from, to), &Declared::default())
}

#[test]
fn reference_numbers_that_touch() {
    let found = accelerogram(file("usgs.smc"), &Declared::default());
    assert_eq!(found.format(), Format::UsgsSmc);
    assert_eq!(found.unit(), AccelerationUnit::CentimetrePerSecondSquared);
    assert_eq!(found.time_step().to_string(), "0.01");
    assert_eq!(found.values().len(), 21);
    assert_eq!(found.values()[..5], [-24.676, -71.842, -61.421, -9.2692, 41.702]);
    assert_eq!(found.values()[20..=20], [8.8053]);
    assert_snapshot!(readings(&found), @r"
    format: USGS SMC
    component (line 6): 27
    number of samples (line 14): 21
    time step (line 18): 0.01 s
    unit (line 1): cm/s² (as the format has it)
    peak in the header (line 23): 71.842 cm/s²
    ");
}

#[test]
fn extreme_header() {
    let seven = "        21    -32768    -32768";
    assert_snapshot!(refused(seven, "        22    -32768    -32768"), @"the values end at line 32 after 21 of them, but the header declares 22; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refused(seven, "    -32768    -32768    -32768"), @r#"line 14 reads "-32768    -32768    -32768    -32768    -32768    -32768    …", but a whole number of samples above 0 should stand there; fetch the file again"#);
    assert_snapshot!(refused("0.1000000E+03", "0.0000000E+00"), @"line 18: the time step is inf s, and must be finite and above 0 s; correct it there");
    assert_snapshot!(refused("       101         2", "       101         3"), @r#"line 13 reads "1         3         3    -32768        90        27       10…", but the number of comment lines that follow as the eighth should stand there; fetch the file again"#);
    assert_snapshot!(refused("2 CORRECTED ACCELEROGRAM", "4 VELOCITY              "), @r#"line 1 reads "4 VELOCITY", but only histories of acceleration are read; take the accelerogram of the record"#);
    assert_snapshot!(refusal("2 CORRECTED ACCELEROGRAM\n*\nXYZ01\n", &Declared::default()), @"the file ends at line 3, before the numbers of its header; fetch it again");
}

#[test]
fn extreme_values() {
    assert_snapshot!(refused("-7.1842E+1", "-1.7842E+2"), @r#"line 23 states a peak of "71.842 cm/s²", but the largest value read is 178.42 cm/s²; one of them is damaged or in another unit: fetch the file again"#);
    assert_snapshot!(refused(" 8.8053E+0", ""), @"the values end at line 32 after 20 of them, but the header declares 21; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refused(" 8.8053E+0", "-3.2768E+4"), @r#"line 32, field 5: "-3.2768E+4" marks a missing value; cut the record before it or take another"#);
    assert_snapshot!(refused(" 8.8053E+0", " 1.7000E38"), @r#"line 32, field 5: "1.7000E38" marks a missing value; cut the record before it or take another"#);
    assert_snapshot!(refused(" 8.8053E+0", "**********"), @r#"line 32, field 5: "**********" is not a number; a program writes asterisks for a number that did not fit: fetch the file again, or print it with wider columns"#);
    assert_snapshot!(refused(" 8.8053E+0", "        88"), @r#"line 32, field 5: "88" is not a number; write it like -0.00640 or -.6403182E-02"#);
    // A byte lost in the line shifts every field after it.
    assert_snapshot!(refused("-4.1299E+1-3.4734E+1", "-4.129E+1-3.4734E+1"), @r#"line 31, field 1: "-4.129E+1-" is not a number; write it like -0.00640 or -.6403182E-02"#);
}

#[test]
fn reference_component_by_its_title_or_by_the_angle_of_the_sensor() {
    let names = |from: &str, to: &str| components(with("usgs.smc", from, to).as_bytes()).unwrap();
    assert_eq!(names("component=     27", "component=     27"), ["27"]);
    assert_eq!(names("component=     27", "component=     Up"), ["Up"]);
    assert!(names("component=     27", "component=").is_empty());
    let angle = "3    -32768        90        27";
    assert_eq!(names(angle, "3    -32768         0        27"), ["UP"]);
    assert_eq!(names(angle, "3    -32768    -32768        27"), ["27"]);
}

fn smc_of_pairs(values: &str) -> String {
    let text = file("usgs.smc");
    let (header, _) = text.split_once("-2.4676E+1").expect("the values");
    let mut header = header.replace("0.1000000E+03", "0.1700000E+39");
    header = header
        .replace("0.5575700E+02", "0.1700000E+39")
        .replace("-0.7184200E+02", " 0.1700000E+39");
    let n_numbers = values.len() / 10;
    let count = format!("{n_numbers:>10}    -32768    -32768");
    header = header.replace("        21    -32768    -32768", &count);
    format!("{header}{values}\n")
}

/// Such a file was read silently with a step of 5.9e-39 s, or was refused only because its count of values was wrong.
#[test]
fn issue_smc_of_uneven_pairs() {
    let uneven = smc_of_pairs(" 0.0000E+0 1.0000E+0 4.0000E-2 3.0000E+0 6.0000E-2 2.0000E+0 1.0000E-1-6.0000E+0");
    assert_snapshot!(refusal(&uneven, &Declared::default()), @"the times rise in uneven steps, from 0.02 to 0.04 s: at line 30 by 0.02 s, where 0.04 s are the median; declare the step to which they are to be resampled, linear between them, as `time_step`, or print them with more decimals");
    let found = accelerogram(&uneven, &with_step(0.02));
    assert_eq!(found.values(), [1.0, 2.0, 3.0, 2.0, -2.0, -6.0]);
    assert_snapshot!(readings(&found), @r"
    format: USGS SMC
    component (line 6): 27
    number of samples (line 14): 4
    time step (line 30): 0.02 s (declared; 4 uneven pairs resampled to 6, linear between)
    unit (line 1): cm/s² (as the format has it)
    ");
    assert_snapshot!(refusal(&uneven, &with_step(1e-4)), @"the declared `time_step` of 0.0001 s resamples the uneven times of the file to more than 8 values for each there is; allowed is 0.0034 s and more");
    let even = smc_of_pairs(" 0.0000E+0 1.0000E+0 2.0000E-2 3.0000E+0 4.0000E-2 2.0000E+0");
    assert_eq!(accelerogram(&even, &Declared::default()).time_step().to_string(), "0.02");
}

/// Values alone are not pairs, whatever the header lacks.
#[test]
fn extreme_smc_without_a_rate() {
    let text = with("usgs.smc", "0.1000000E+03", "0.1700000E+39");
    assert_snapshot!(refusal(text, &Declared::default()), @r#"line 18 reads "0.1700000E+39  0.1700000E+39  0.1700000E+39  0.1700000E+39  …", but a number of samples in a second, or below the header pairs of time and value, should stand there; fetch the file again"#);
}

fn with_step(time_step: f64) -> Declared {
    Declared {
        time_step: Some(time_step),
        ..Declared::default()
    }
}
