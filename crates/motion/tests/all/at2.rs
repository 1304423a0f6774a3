//! PEER AT2 and similar files: every header and layout that is read, and the message of each refusal.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Accelerogram, Declared, components, read, read_declared};

const TITLES: &str = "A DATABASE RECORD\nSOMEWHERE 01/02/03 0405, A STATION\n\
                      ACCELERATION TIME SERIES IN UNITS OF G\n";

fn accelerogram(text: &str) -> Accelerogram {
    match read(text.as_bytes()) {
        Ok(found) => found,
        Err(error) => panic!("{error}\n{text}"),
    }
}

fn refusal(text: &str) -> String {
    read(text.as_bytes()).expect_err("a file that is refused").to_string()
}

/// A file whose header declares a number of values at a step of 0.01 s, with the given values.
fn with_values(n_samples: usize, values: &str) -> String {
    format!("{TITLES}NPTS= {n_samples}, DT= .0100 SEC\n{values}")
}

#[test]
fn reference_five_columns_with_leading_points() {
    let found = accelerogram(&with_values(
        7,
        "  -.6403182E-02  -.6028710E-02   .5304200E-03   .7743260E-02   .6890380E-02\n   \
         .6876500E-02   .1000000E+01\n",
    ));
    let expected = [
        -0.006_403_182,
        -0.006_028_71,
        0.000_530_42,
        0.007_743_26,
        0.006_890_38,
        0.006_876_5,
        1.0,
    ];
    assert_eq!(found.values(), expected);
    assert_eq!(found.time_step().to_string(), "0.01");
    assert_eq!(found.unit(), AccelerationUnit::StandardGravity);
    assert_eq!(
        found.provenance(),
        "A DATABASE RECORD\nSOMEWHERE 01/02/03 0405, A STATION\nACCELERATION TIME SERIES IN UNITS OF G"
    );
}

#[test]
fn reference_line_with_npts_and_dt_in_every_spelling() {
    for line in [
        "NPTS=  4, DT= .02500 SEC",
        "NPTS=   4, DT=   .0250 SEC,",
        "4    0.0250    NPTS, DT",
        "4 0.0250 NPTS, DT ",
        "0.0250 4 DT, NPTS",
        "4 0.0250 NPTS DT",
        "NPTS   4   DT   .0250",
        "DT= .0250 SEC, NPTS= 4",
        "NPTS= 4, dt= .025",
        "4 0.0250",
        "  NPTS=4,DT=.025SEC  ",
        "npts: 4 dt: 2.5D-2",
    ] {
        let found = accelerogram(&format!("{TITLES}{line}\n 0.1 0.2 0.3 0.4\n"));
        assert_eq!(found.time_step().to_string(), "0.025", "{line}");
        assert_eq!(found.values(), [0.1, 0.2, 0.3, 0.4], "{line}");
    }
}

#[test]
fn reference_seven_header_lines_with_crlf_and_left_aligned_values() {
    let found = accelerogram(
        "Orig PEER filename = SOMEWHERE_FN.acc, Scale factor = 2.4 \r\n  H1 for rotation: 000\r\n  \
         H2 for rotation: 270\r\n  rotation angle - clockwise   -37.0\r\n  FN component\r\n  \
         Acceleration in g\r\n3 0.0050 NPTS, DT \r\n0.008941     -0.009683     \r\n0.000898     ",
    );
    assert_eq!(found.values(), [0.008_941, -0.009_683, 0.000_898]);
    assert_eq!(found.time_step().to_string(), "0.005");
    assert_eq!(found.provenance().lines().count(), 6);
}

#[test]
fn reference_eight_columns_and_the_unit_in_brackets() {
    let found = accelerogram(
        "Data for Somewhere\n9 points at equal spacing of 0.02 sec\nThe units are (g)\n\
         NPTS=  9, DT= .02000 SEC\n   0.00630   0.00364   0.00099   0.00428   0.00758   0.01087   \
         0.00682   0.00277\n  -0.00128\n",
    );
    assert_eq!(found.values().len(), 9);
    assert_eq!(found.values().last(), Some(&-0.00128));
}

#[test]
fn reference_last_of_two_headers_counts() {
    let text = "TIME-DOMAIN CORRECTION, ACCELERATION IN G'S\nNPTS= 9, DT= .9\nOLD HEADERS FOLLOW\n\
                A\nB\nC\nNPTS= 2, DT= .01\n 0.5 0.25\n";
    assert_eq!(accelerogram(text).values(), [0.5, 0.25]);
}

#[test]
fn reference_numbers_that_touch_are_cut_at_fixed_columns() {
    let expected = [-1.5, -12.25, 100.125, -0.5, 3.0];
    for values in [
        // 4F9.5, full width from the second number on
        " -1.50000-12.25000100.12500 -0.50000\n  3.00000\n",
        // 3E13.6 and 3E12.6
        "-1.500000E+00-1.225000E+01 1.001250E+02\n-5.000000E-01 3.000000E+00\n",
        "-.150000E+01-.122500E+020.100125E+03\n-.500000E+000.300000E+01   \n",
        // leading blanks lost
        "-1.50000-12.25000100.12500\n-0.50000  3.00000",
    ] {
        assert_eq!(accelerogram(&with_values(5, values)).values(), expected, "{values}");
    }
}

#[test]
fn reference_double_precision_exponents_of_fortran() {
    let found = accelerogram(&with_values(3, " 0.15D+01 -0.1225d-02 +.5D0\n"));
    assert_eq!(found.values(), [1.5, -0.001_225, 0.5]);
}

#[test]
fn limit_tails_blank_lines_and_trailing_blanks_change_nothing() {
    let plain = accelerogram(&with_values(3, "0.1 0.2\n0.3\n"));
    for values in [
        "0.1 0.2\r\n0.3",
        "\n  0.1\t0.2   \n\n   0.3   \n  \n",
        "0.1 0.2\n0.3\n*** End Data ***\n\n1940 leftovers\n",
        "0.1\n0.2\n0.3\n-----\n",
    ] {
        assert_eq!(accelerogram(&with_values(3, values)), plain);
    }
}

#[test]
fn limit_letters_of_other_code_pages_in_the_header() {
    let mut text = b"KOCAEL\xDD, T\xDCRK\xDDYE\n".to_vec();
    text.extend(b"x\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 1, DT= .01 SEC\n .5\n");
    assert_eq!(read(&text).unwrap().values(), [0.5]);
}

#[test]
fn extreme_header() {
    assert_snapshot!(refusal(" \n"), @"the text holds nothing but blank lines and comments; give a header followed by numbers");
    assert_snapshot!(refusal("PEER STRONG MOTION DATABASE RECORD\nx\ny\n4000\n 0.1\n"), @"no line among the first 5 gives the number of samples and the time step; write line 4 as `NPTS= 4000, DT= .01000 SEC`");
    assert_snapshot!(refusal(&format!("{TITLES}NPTS= many, DT= .01 SEC\n 0.1\n")), @r#"line 4 reads "NPTS= many, DT= .01 SEC", but must give a whole number of samples above 0 and the time step in seconds, and no other number; write it as `NPTS= 4000, DT= .01000 SEC`"#);
    assert_snapshot!(refusal(&format!("{TITLES}NPTS= 0, DT= .01 SEC\n")), @r#"line 4 reads "NPTS= 0, DT= .01 SEC", but must give a whole number of samples above 0 and the time step in seconds, and no other number; write it as `NPTS= 4000, DT= .01000 SEC`"#);
    assert_snapshot!(refusal(&format!("{TITLES}NPTS= 1, DT= .01 SEC, LP= 15\n 0.1\n")), @r#"line 4 reads "NPTS= 1, DT= .01 SEC, LP= 15", but must give a whole number of samples above 0 and the time step in seconds, and no other number; write it as `NPTS= 4000, DT= .01000 SEC`"#);
    assert_snapshot!(refusal(&format!("{TITLES}NPTS= 1, DT= 0 SEC\n 0.1\n")), @"line 4: the time step is 0 s, and must be finite and above 0 s; correct it there");
    assert_snapshot!(refusal(&format!("{TITLES}NPTS= 1, DT= -.01 SEC\n 0.1\n")), @"line 4: the time step is -0.01 s, and must be finite and above 0 s; correct it there");
    assert_snapshot!(refusal(&format!("{TITLES}NPTS= 1, DT= 1E999 SEC\n 0.1\n")), @"line 4: the time step is inf s, and must be finite and above 0 s; correct it there");
    assert_snapshot!(refusal(&format!("{TITLES}NPTS= 1, DT= NaN SEC\n 0.1\n")), @r#"line 4 reads "NPTS= 1, DT= NaN SEC", but must give a whole number of samples above 0 and the time step in seconds, and no other number; write it as `NPTS= 4000, DT= .01000 SEC`"#);
    assert_snapshot!(refusal(&format!("{TITLES}NPTS= 1, DT= INF SEC\n 0.1\n")), @r#"line 4 reads "NPTS= 1, DT= INF SEC", but must give a whole number of samples above 0 and the time step in seconds, and no other number; write it as `NPTS= 4000, DT= .01000 SEC`"#);
}

#[test]
fn extreme_quantity() {
    let with_line_3 = |line: &str| refusal(&format!("A\nB\n{line}\nNPTS= 1, DT= .01 SEC\n 0.1\n"));
    assert_snapshot!(with_line_3("VELOCITY TIME SERIES IN UNITS OF CM/S"), @r#"line 3 reads "VELOCITY TIME SERIES IN UNITS OF CM/S", but only acceleration in units of g is read; take the .AT2 file of the record"#);
    assert_snapshot!(with_line_3("DISPLACEMENT TIME HISTORY IN UNITS OF CM"), @r#"line 3 reads "DISPLACEMENT TIME HISTORY IN UNITS OF CM", but only acceleration in units of g is read; take the .AT2 file of the record"#);
    assert_snapshot!(with_line_3("ACCELERATION TIME HISTORY IN UNITS OF CM/S/S"), @r#"line 3 reads "ACCELERATION TIME HISTORY IN UNITS OF CM/S/S", but only acceleration in units of g is read; take the .AT2 file of the record"#);
    assert_snapshot!(with_line_3("UNITS ARE SEC AND G/10"), @r#"line 3 reads "UNITS ARE SEC AND G/10", but only acceleration in units of g is read; take the .AT2 file of the record"#);
    assert_snapshot!(with_line_3("SCALED TO THE SPECTRUM"), @"the file does not say in which unit its values are; declare it as `unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
}

#[test]
fn reference_what_is_read_is_told_and_a_missing_unit_may_be_declared() {
    let found = accelerogram(&with_values(2, "0.1 0.2\n"));
    let readings: Vec<String> = found
        .readings()
        .iter()
        .map(|reading| format!("{:?} {}: {}", reading.line, reading.what, reading.found))
        .collect();
    assert_snapshot!(readings.join("; "), @"None format: PEER AT2; Some(4) number of samples: 2; Some(4) time step: 0.01 s; Some(3) unit: g (ACCELERATION TIME SERIES IN UNITS OF G)");
    let text = "A\nB\nSCALED TO THE SPECTRUM\nNPTS= 1, DT= .01 SEC\n 0.1\n";
    let declared = Declared {
        unit: Some(AccelerationUnit::MilliG),
        ..Declared::default()
    };
    let found = read_declared(text.as_bytes(), &declared).unwrap();
    assert_eq!(found.unit(), AccelerationUnit::MilliG);
}

#[test]
fn extreme_values() {
    assert_snapshot!(refusal(&with_values(4, "0.1 0.2\n0.3\n")), @"the values end at line 6 after 3 of them, but the header declares 4; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refusal(&with_values(4, "0.1 0.2\n0.3\n*** End Data ***\n0.4\n")), @r#"the values end at line 6 after 3 of them (line 7 reads "*** End Data ***"), but the header declares 4; fetch the file again, or correct the header if the values are complete"#);
    assert_snapshot!(refusal(&with_values(4, "")), @"the values end at line 4 after 0 of them, but the header declares 4; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refusal(&with_values(2, "0.1 0.2\n0.3\n")), @"the values end at line 6 after 3 of them, but the header declares 2; fetch the file again, or correct the header if the values are complete");
    assert_snapshot!(refusal(&with_values(3, "0.1 0.2\n0.3x\n")), @r#"line 6, field 1: "0.3x" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refusal(&with_values(3, "0.1 0.2\nNaN\n")), @r#"line 6, field 1: "NaN" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal(&with_values(3, "0.1 1D999\n0.3\n")), @r#"line 5, field 2: "1D999" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal(&with_values(2, "0.1 -inf\n")), @r#"line 5, field 2: "-inf" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal(&with_values(2, "0.1 *******\n")), @r#"line 5, field 2: "*******" is not a number; a program writes asterisks for a number that did not fit: fetch the file again, or print it with wider columns"#);
    assert_snapshot!(refusal(&with_values(4, "0.12-0.345\n0.1 0.2\n")), @r#"line 5, field 1: "0.12-0.345" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refusal(&with_values(4, "-12.3\u{b2}5-34.500\n")), @r#"line 5, field 1: "-12.3²" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refusal(&with_values(18_446_744_073_709_551_615, "0.1\n")), @"the values end at line 5 after 1 of them, but the header declares 18446744073709551615; fetch the file again, or correct the header if the values are complete");
}

/// The names of the components of a file with this line of earthquake and station.
fn names(line: &str) -> Vec<String> {
    let text = format!("A DATABASE RECORD\n{line}\nACCELERATION TIME SERIES IN UNITS OF G\n");
    let text = format!("{text}NPTS= 1, DT= .01 SEC\n 0.1\n");
    let names = components(text.as_bytes()).expect("an AT2 file");
    // A single component with a name is read without a declaration.
    let found = accelerogram(&text);
    assert_eq!(found.values(), [0.1], "{line}");
    names
}

#[test]
fn reference_the_direction_behind_the_last_comma_is_the_component() {
    for (line, name) in [
        ("SOMEWHERE 01/02/03 0405, A STATION #9, 180 (AGENCY STATION 117)", "180"),
        ("Somewhere-02, 2/3/1940, A Station #9, 000", "000"),
        ("Somewhere_ Japan, 6/13/2008, IWTH25, UD", "UD"),
        ("SOMEWHERE, 1/2/03, STATION, UP", "UP"),
        ("SOMEWHERE, 1/2/03, STATION,DWN  ", "DWN"),
        ("SOMEWHERE, 1/2/03, STATION, V", "V"),
        ("SOMEWHERE, 1/2/03, STATION, NS", "NS"),
    ] {
        assert_eq!(names(line), [name], "{line}");
    }
}

#[test]
fn extreme_titles_without_a_direction() {
    for line in [
        "SOMEWHERE 01/02/03 0405, A STATION",
        "UP",
        "SOMEWHERE, STATION,",
        "9 points, i.e., 8 points across in a row with 5 decimals",
        "SOMEWHERE, LOOK UP",
        "SOMEWHERE, 361",
        ",",
    ] {
        assert!(names(line).is_empty(), "{line}");
    }
    let rotated = "Orig PEER filename = X, Scale factor = 2.4\n  H1 for rotation: X 10/15/79, A TOWN, 000 (STATION 5155)\n  \
                   H2 for rotation: X, 270\n  rotation angle - clockwise   -37.0\n  FN component, azimuth =   233.0\n  \
                   Acceleration in g\n1 0.0050 NPTS, DT \n0.008941\n";
    // The component of a rotated record has a separate line.
    assert_eq!(components(rotated.as_bytes()).expect("an AT2 file"), ["FN"]);
}
