//! The arrangement of numbers in a text: in rows, after semicolons, above end marks.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Declared, components};

use super::{accelerogram, file, readings, refusal, rows_of, wave};

fn list() -> Declared {
    Declared {
        unit: Some(AccelerationUnit::StandardGravity),
        time_step: Some(0.01),
        ..Declared::default()
    }
}

fn in_rows() -> Declared {
    Declared { in_rows: true, ..list() }
}

/// The values in rows of `per_row`.
fn rows(n_values: usize, per_row: usize, separator: &str) -> String {
    let values: Vec<String> = wave(n_values).iter().map(|value| format!("{value:.6}")).collect();
    let rows = values.chunks(per_row).map(|row| row.join(separator) + "\n");
    rows.collect()
}

/// Several values per line without names could not be declared in any way.
#[test]
fn issue_values_in_rows() {
    let expected = accelerogram(rows(40, 1, ""), &list());
    for (text, n_columns) in [(rows(40, 5, " "), "5"), (rows(40, 4, ","), "4"), (rows(40, 2, "\t"), "2")] {
        let found = accelerogram(&text, &in_rows());
        assert_eq!(found.values(), expected.values(), "{n_columns}");
        let said = refusal(&text, &list());
        assert!(said.contains("declare `in_rows`"), "{said}");
    }
    assert_snapshot!(refusal(rows(40, 5, " "), &list()), @"line 1 has 5 numbers: column 1 is no time, and nothing names the columns; if they follow one another, declare `in_rows`; if they are columns, write their names above, such as `NS EW UD …` or `time NS EW UD`");
    assert_snapshot!(refusal(format!("# dt = 0.01 s\n{}", rows(40, 2, " ")), &list()), @"line 2 has 2 numbers: column 1 is no time, and nothing names the columns; if they follow one another, declare `in_rows`; if they are columns, write their names above, such as `NS EW` or `time NS`");
    // This declaration contradicts the file.
    assert_snapshot!(refusal("0.00 0.1\n0.01 -0.2\n0.02 0.1\n", &in_rows()), @r#"line 1 reads "0.00 0.1": the numbers stand in columns, but `in_rows` is declared; leave the declaration away"#);
    assert_snapshot!(refusal("NS EW\n0.3 0.1\n0.01 -0.2\n", &in_rows()), @r#"line 1 reads "NS EW": the numbers stand in columns, but `in_rows` is declared; leave the declaration away"#);
    // A table with a cut last row was read as values in rows, including the times.
    assert_snapshot!(refusal("time NS EW\n0.00 0.1 0.2\n0.01 0.2 0.3\n0.02 0.1\n", &list()), @"line 2 has 3 numbers: the rows below have others; if they follow one another, declare `in_rows`; if they are columns, write their names above, such as `NS EW UD` or `time NS EW`");
    assert_snapshot!(refusal("0.00 0.1 0.2\n0.01 0.2 0.3\n0.02 0.1 0.2\n0.03 0.1\n", &list()), @"line 1 has 3 numbers: the rows below have others; if they follow one another, declare `in_rows`; if they are columns, write their names above, such as `NS EW UD` or `time NS EW`");
}

/// Fixed columns of touching numbers were refused as an unknown format.
#[test]
fn issue_values_in_rows_that_touch() {
    let values = wave(40);
    let touching = rows_of(40, |step, value| {
        let end = if (step + 1.0) % 8.0 < 0.5 { "\n" } else { "" };
        format!("{value:9.6}{end}")
    });
    let found = accelerogram(format!("ACCELEROGRAM FOR A PROGRAM\n{touching}"), &in_rows());
    assert_eq!(found.values().len(), 40);
    assert!((found.values()[7] - values[7]).abs() < 1e-6);
    assert!(refusal(format!("A PROGRAM\n{touching}"), &list()).contains("declare `in_rows`"));
}

/// An end mark after the last line was refused as a row.
#[test]
fn issue_marks_of_the_end() {
    let expected = accelerogram(rows(30, 1, ""), &list());
    for end in [
        "*** End Data ***\n",
        "*** End Data ***\n\n\n",
        "/&\n",
        "END OF DATA\n",
        "\u{1a}",
        "\u{1a}\r\n",
        ",,,\n,,,\n",
        ",\n;\n \n",
    ] {
        let found = accelerogram(rows(30, 1, "") + end, &list());
        assert_eq!(found.values(), expected.values(), "{end}");
    }
}

/// Ctrl-Z at the end, a blank line above the first row, or rows of only commas below the last hid most layouts.
#[test]
fn issue_blank_lines_above_and_ctrl_z_below() {
    for name in [
        "cosmos.v2",
        "csmip-new.v1",
        "csmip-old.v1",
        "csmip.v2",
        "esm.asc",
        "geonet.v1a",
        "geonet.v2a",
        "knet.ns",
        "renadic.v1",
        "usc.s0a",
        "usgs.smc",
    ] {
        let declared = Declared {
            component: Some("1".to_owned()),
            ..Declared::default()
        };
        let plain = accelerogram(file(name), &declared);
        for text in [
            format!("{}\u{1a}", file(name)),
            format!("\n \n{}", file(name)),
            format!("{}\n,,,\n", file(name).trim_end()),
        ] {
            let found = accelerogram(&text, &declared);
            assert_eq!(found.values(), plain.values(), "{name}");
            assert_eq!(found.format(), plain.format(), "{name}");
        }
    }
}

/// Decimal commas were read as separators of a time and a value, or were not recognised.
#[test]
fn issue_decimal_commas() {
    let comma = |text: String| text.replace('.', ",");
    let expected = accelerogram("0.00,0.25\n0.01,-0.5\n0.02,0.25\n", &Declared { time_step: None, ..list() });
    for text in [
        "0,00;0,25\n0,01;-0,5\n0,02;0,25\n",
        "0,00 0,25\n0,01 -0,5\n0,02 0,25\n",
        "t;a\n0,00;0,25;\n0,01;-0,5;\n0,02;0,25;\n",
    ] {
        let found = accelerogram(text.replace(";\n", "\n"), &Declared { time_step: None, ..list() });
        assert_eq!(found.values(), expected.values(), "{text}");
        let steps = [&found, &expected].map(|one| one.time_step().to_string());
        assert_eq!(steps[0], steps[1], "{text}");
        assert!(readings(&found).contains("decimal commas (line"), "{}", readings(&found));
    }
    let named = "Zeit;time (s);NS (g)\n1;0,00;0,25\n2;0,01;-0,5\n3;0,02;0,25\n";
    assert!(components(named.as_bytes()).is_ok());
    assert_snapshot!(refusal(comma(rows(20, 1, "")).replace('-', ""), &list()), @r#"line 1 reads "0,000000": its comma may be a decimal comma, or separate two whole numbers; write decimal points, or semicolons between numbers with decimal commas"#);
    assert_snapshot!(refusal(comma(rows(20, 1, "")), &list()), @r#"line 1 reads "0,000000": its comma may be a decimal comma, or separate two whole numbers; write decimal points, or semicolons between numbers with decimal commas"#);
}

/// A single line of values as long as the file took 30 times its size in memory.
#[test]
fn extreme_one_long_line() {
    let text = "0.1 -0.2 ".repeat(100_000);
    let found = accelerogram(&text, &in_rows());
    assert_eq!(found.values().len(), 200_000);
    assert!(refusal(&text, &list()).contains("line 1 has 200000 numbers"));
    let too_many = "1 ".repeat(10_000_001);
    assert_snapshot!(refusal(&too_many, &in_rows()), @"found more samples than the 10000000 allowed; cut the record to the shaking that matters, or resample it");
}
