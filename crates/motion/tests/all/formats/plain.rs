//! Plain text of one and two columns.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, Format};

use super::{accelerogram, readings, refusal};

const IN_G: Declared = Declared {
    unit: Some(AccelerationUnit::StandardGravity),
    time_step: None,
    component: None,
    per_count: None,
    acceleration: false,
    in_rows: false,
};

fn in_g_with_step(time_step: f64) -> Declared {
    Declared {
        time_step: Some(time_step),
        ..IN_G
    }
}

#[test]
fn reference_one_column() {
    for text in [
        "0.1\n-0.25\n3\n",
        "# title\n0.1\n\n -0.25 \n# tail\n3",
        "El Somewhere, 1940\n.1\n-.25\n3.0D0\n",
    ] {
        let found = accelerogram(text, &in_g_with_step(0.02));
        assert_eq!(found.format(), Format::Plain);
        assert_eq!(found.values(), [0.1, -0.25, 3.0], "{text}");
        assert_eq!(found.time_step().to_string(), "0.02");
    }
    let found = accelerogram("# El Somewhere\nin some unit\n0.1\n0.2\n", &in_g_with_step(0.02));
    assert_eq!(found.provenance(), "El Somewhere\nin some unit");
    assert_snapshot!(readings(&found), @r"
    format: plain text
    number of samples: 2
    time step: 0.02 s (declared)
    unit: g (declared)
    columns (line 3): 1
    ");
}

#[test]
fn reference_two_columns() {
    for text in [
        "0.00 0.1\n0.02 -0.25\n",
        "t, a\n0.00,0.1\n0.02 , -0.25\n",
        "0.00\t0.1\r\n0.02\t-0.25\r\n",
    ] {
        let found = accelerogram(text, &IN_G);
        assert_eq!(found.values(), [0.1, -0.25], "{text}");
        assert_eq!(found.time_step().to_string(), "0.02");
    }
}

#[test]
fn reference_a_file_that_begins_after_one_step_gets_the_state_of_rest() {
    let found = accelerogram("0.02 0.1\n0.04 -0.25\n", &IN_G);
    assert_eq!(found.values(), [0.0, 0.1, -0.25]);
    assert_snapshot!(readings(&found), @r"
    format: plain text
    number of samples: 3
    time step (line 1): 0.02 s
    unit: g (declared)
    columns (line 1): 2, time and acceleration
    state of rest (line 1): 0 put at t = 0, where the file has nothing
    ");
}

#[test]
fn extreme_nothing_declared() {
    assert_snapshot!(refusal("0.1\n0.2\n", &Declared::default()), @"the file does not say how far apart its values are; declare it as `time_step` in seconds");
    assert_snapshot!(refusal("0.1\n0.2\n", &IN_G), @"the file does not say how far apart its values are; declare it as `time_step` in seconds");
    assert_snapshot!(refusal("0.00 0.1\n0.02 0.2\n", &Declared::default()), @"the file does not say in which unit its values are; declare it as `unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
}

#[test]
fn extreme_lines() {
    assert_snapshot!(refusal("0.0 0.1\n0.1 0.2\n0.2 0.3\n3 0.5\n", &IN_G), @"the times rise in uneven steps, from 0.1 to 2.8 s: at line 4 by 2.8 s, where 0.1 s are the median; declare the step to which they are to be resampled, linear between them, as `time_step`, or print them with more decimals");
    assert_snapshot!(refusal("0.1\n0.2 0.3\n", &IN_G), @"line 2 has 2 column(s), allowed are 1 as in the first line of numbers; write time and acceleration alone, or one acceleration to a line");
    assert_snapshot!(refusal("0.1 0.2 0.3\n0.1 0.2 0.3\n", &IN_G), @"line 1 has 3 numbers: column 1 is no time, and nothing names the columns; if they follow one another, declare `in_rows`; if they are columns, write their names above, such as `NS EW UD` or `time NS EW`");
    assert_snapshot!(refusal("0.1\n0.2\nthe end\n", &in_g_with_step(0.1)), @"line 3 has 2 column(s), allowed are 1 as in the first line of numbers; write time and acceleration alone, or one acceleration to a line");
    assert_snapshot!(refusal("0.1\n0.2x\n", &in_g_with_step(0.1)), @r#"line 2, field 1: "0.2x" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refusal("0.1\n1e999\n", &in_g_with_step(0.1)), @r#"line 2, field 1: "1e999" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal("0.1\nNaN\n", &in_g_with_step(0.1)), @r#"line 2, field 1: "NaN" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal("0.0,0.1\n0.1,\n", &IN_G), @"line 2 has 1 column(s), allowed are 2 as in the first line of numbers; write time and acceleration alone, or one acceleration to a line");
    assert_snapshot!(refusal("3\n0.1\n0.2\n0.3\n", &in_g_with_step(0.1)), @r#"line 1 reads "3", which is how many values follow; put # before it, or it would be taken for the first"#);
    // A decimal comma makes two columns of one.
    assert_snapshot!(refusal("0,00123\n0,00145\n", &in_g_with_step(0.1)), @r#"line 1 reads "0,00123": its comma may be a decimal comma, or separate two whole numbers; write decimal points, or semicolons between numbers with decimal commas"#);
}

#[test]
fn extreme_unknown_format() {
    assert_snapshot!(refusal("\nSome words\nand others\n", &IN_G), @"line 2 begins none of the formats known: CSV, PEER AT2, CSMIP V1, CSMIP V2, COSMOS 1.2, USGS SMC, USC V2, K-NET, ESM ASC, GeoNet, RENADIC V1, CWB, AFAD, UNAM, SCEC BBP, BHRC, CSMNC, DYNA, EMOD3D, USGS text, SAC, miniSEED, eqsig, SimCenter JSON, plain text; fetch the file again in one of them, or write one number to a line");
    assert_snapshot!(refusal("# words alone\n \n", &IN_G), @"the text holds nothing but blank lines and comments; give a header followed by numbers");
    assert_snapshot!(refusal(b"\xff\xfe\x00\x01 binary", &IN_G), @r#"the file is text in UTF-16, allowed is a record as text, SAC or miniSEED; save it again as UTF-8 (an editor's "Save as", or `iconv -f UTF-16 -t UTF-8`)"#);
}

/// A file with 100 MB of line ends took 2.4 GB of memory.
#[test]
fn extreme_too_many_lines_are_refused() {
    let empty = "\n".repeat(1_000_001);
    assert_snapshot!(refusal(&empty, &IN_G), @"found 1000001 lines, allowed are 1000000; cut the record to the shaking that matters");
    let short = "1\n".repeat(20_000_001);
    assert_snapshot!(refusal(&short, &IN_G), @"found 20000001 lines, allowed are 20000000; cut the record to the shaking that matters");
}

/// Spreadsheets end every line with the commas of empty columns. The refusal was a list of formats.
#[test]
fn issue_empty_columns_of_a_spreadsheet_are_left_out() {
    let text = "time (s),acc_g,,\n0.00,0.1,,\n0.02,-0.25,,\n";
    let found = accelerogram(text, &Declared::default());
    assert_eq!(found.values(), [0.1, -0.25]);
    assert_eq!(found.unit(), AccelerationUnit::StandardGravity);
}

/// The number of rows above times and values was refused as a line with too few columns.
#[test]
fn issue_the_number_of_the_rows_may_stand_above_them() {
    let rows = "0.00 0.1\n0.02 -0.25\n0.04 0.05\n";
    let found = accelerogram(format!("3\n{rows}"), &IN_G);
    assert_eq!(found.values(), [0.1, -0.25, 0.05]);
    assert_snapshot!(refusal(format!("4\n{rows}"), &IN_G), @"the values end at line 4 after 3 of them, but the header declares 4; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refusal(format!("1\n{rows}"), &IN_G), @"line 2 has 2 column(s), allowed are 1 as in the first line of numbers; write time and acceleration alone, or one acceleration to a line");
}

/// Decimal commas made four columns of two, in which no time was found.
#[test]
fn issue_decimal_commas_of_four_columns_are_named() {
    assert_snapshot!(refusal("0,00,0,000123\n0,02,-1,5\n", &IN_G), @r#"line 1 reads "0,00,0,000123": its comma may be a decimal comma, or separate two whole numbers; write decimal points, or semicolons between numbers with decimal commas"#);
    assert_snapshot!(refusal("time_s,acceleration_g\n0,00,0,00000\n0,02,0,00150\n", &IN_G), @r#"line 2 reads "0,00,0,00000": its comma may be a decimal comma, or separate two whole numbers; write decimal points, or semicolons between numbers with decimal commas"#);
    // Counts of four channels have no fraction.
    assert!(!refusal("12,34,56,78\n90,12,34,56\n", &IN_G).contains("decimal comma"));
}

/// A unit in Latin-1, as spreadsheets save it, was not read, and a contradicting declaration was accepted.
#[test]
fn issue_units_in_latin_1_are_read() {
    let text = b"Zeit [s];Beschleunigung [m/s\xb2]\n0,00;0,1\n0,02;-0,25\n0,04;0,05\n";
    let found = accelerogram(text, &Declared::default());
    assert_eq!(found.unit(), AccelerationUnit::MetrePerSecondSquared);
    assert_eq!(found.values(), [0.1, -0.25, 0.05]);
    assert_snapshot!(refusal(text, &IN_G), @"line 1 says that the values are in m_per_s2, but g is declared as `unit`; leave the declaration away");
}

/// The message about velocities advised to put the header of an acceleration above them.
#[test]
fn issue_velocities_are_named_as_such() {
    let rows = "0.00,0.1\n0.02,-0.25\n0.04,0.05\n";
    for header in [
        "time_s,velocity_m_per_s",
        "time_s,velocity (m/s)",
        "time_s,displacement_m",
        "Zeit [s],Geschwindigkeit [m/s]",
        "Temps [s],Weg [mm]",
    ] {
        let said = refusal(format!("{header}\n{rows}"), &Declared::default());
        assert!(!said.contains("put the one"), "{header}: {said}");
        assert!(said.contains("acceleration"), "{header}: {said}");
    }
}
