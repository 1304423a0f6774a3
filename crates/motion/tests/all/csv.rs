//! Two-column CSV: files that are read, and the message of each refusal.

use insta::assert_snapshot;
use pounding_motion::{AccelerationUnit, Accelerogram, read};

fn accelerogram(text: &str) -> Accelerogram {
    read(text.as_bytes()).expect("a readable CSV")
}

fn refusal(text: &str) -> String {
    read(text.as_bytes()).expect_err("a CSV that is refused").to_string()
}

/// A file in g with these times and zeros for accelerations.
fn with_times(times: &[&str]) -> String {
    let rows: Vec<String> = times.iter().map(|time| format!("{time},0\n")).collect();
    format!("time_s,acceleration_g\n{}", rows.concat())
}

fn time_step(times: &[&str]) -> f64 {
    accelerogram(&with_times(times)).time_step()
}

#[test]
fn reference_values_unit_and_comments() {
    let found = accelerogram("# El Somewhere\n#second line\ntime_s,acceleration_g\n0.00,0.1\n0.02,-0.25\n");
    assert_eq!(found.values(), [0.1, -0.25]);
    assert_eq!(found.time_step().to_string(), "0.02");
    assert_eq!(found.unit(), AccelerationUnit::StandardGravity);
    assert_eq!(found.provenance(), "El Somewhere\nsecond line");
    let record = found.into_record(10.0).unwrap();
    assert_eq!(record.samples(), [1.0, -2.5]);
    assert_eq!(record.source(), "El Somewhere\nsecond line");
}

#[test]
fn reference_metres_per_second_squared_are_left_as_they_are() {
    let found = accelerogram("time_s,acceleration_m_per_s2\n0,1\n1,2\n");
    assert_eq!(found.unit(), AccelerationUnit::MetrePerSecondSquared);
    assert_eq!(found.into_record(9.81).unwrap().samples(), [1.0, 2.0]);
}

#[test]
fn reference_a_file_that_begins_after_one_step_gets_the_state_of_rest() {
    let found = accelerogram("time_s,acceleration_g\n0.02,0.0063\n0.04,0.00364\n");
    assert_eq!(found.values(), [0.0, 0.0063, 0.00364]);
    assert_eq!(found.time_step().to_string(), "0.02");
}

#[test]
fn reference_time_step_is_the_decimal_that_was_printed() {
    assert_eq!(time_step(&["0.00", "0.01", "0.02", "0.03"]).to_string(), "0.01");
    assert_eq!(time_step(&["0", "0.005", "0.01"]).to_string(), "0.005");
    assert_eq!(time_step(&["0.0", "0.1", "0.2", "0.30000000000000004"]).to_string(), "0.1");
    assert_eq!(time_step(&["0.0e+00", "1.00e-02", "2.00e-02"]).to_string(), "0.01");
    assert_eq!(time_step(&["0", "0.00390625", "0.0078125"]).to_string(), "0.00390625");
    // This is not a decimal step: the single precision of some writers is kept.
    assert_eq!(time_step(&["0", "0.01999999955", "0.0399999991"]).to_string(), "0.01999999955");
    let long: Vec<String> = (0..4000).map(|step| format!("{:.2}", f64::from(step) / 100.0)).collect();
    let long: Vec<&str> = long.iter().map(String::as_str).collect();
    assert_eq!(time_step(&long).to_string(), "0.01");
}

#[test]
fn reference_rounded_times_give_their_mean_step() {
    let times: Vec<String> = (0..=1000).map(|step| format!("{:.4}", f64::from(step) / 256.0)).collect();
    let times: Vec<&str> = times.iter().map(String::as_str).collect();
    let error = time_step(&times) - 1.0 / 256.0;
    assert!(error.abs() <= 1e-4 / 1000.0, "off by {error} s");
}

#[test]
fn limit_ends_of_lines_blanks_and_quotes_change_nothing() {
    let plain = accelerogram("# c\ntime_s,acceleration_g\n0.0,1\n0.1,2\n");
    for text in [
        "# c\r\ntime_s,acceleration_g\r\n0.0,1\r\n0.1,2",
        "# c\rtime_s,acceleration_g\r0.0,1\r0.1,2\r",
        "\u{feff}# c\ntime_s,acceleration_g\n0.0,1\n0.1,2\n",
        "\n  \ntime_s, acceleration_g\n# c\n 0.0 , 1\n\n0.1,2\n\n",
        "# c\n\"time_s\",\"acceleration_g\"\n0.0,1\n0.1,2\n",
    ] {
        let found = accelerogram(text);
        assert_eq!(found.values(), plain.values(), "{text}");
        assert_eq!(found.time_step().to_string(), "0.1", "{text}");
        assert_eq!(found.provenance(), "c", "{text}");
    }
}

#[test]
fn extreme_nothing_to_read() {
    assert_snapshot!(refusal(""), @"the text holds nothing but blank lines and comments; give a header followed by numbers");
    assert_snapshot!(refusal("# only a comment\n\n"), @"the text holds nothing but blank lines and comments; give a header followed by numbers");
    assert_snapshot!(refusal("time_s,acceleration_g\n"), @"0 sample(s) found, but the time step is taken from the time column and needs at least 2");
    assert_snapshot!(refusal("time_s,acceleration_g\n0.0,1.0\n"), @"1 sample(s) found, but the time step is taken from the time column and needs at least 2");
}

#[test]
fn extreme_header_absent_or_unknown() {
    assert_snapshot!(refusal("time_s,acceleration\n0.00,0.1\n0.02,0.2\n"), @r#"line 1 reads "time_s,acceleration", but the header of a CSV must be `time_s,acceleration_g` or `time_s,acceleration_m_per_s2`; put the one that gives the unit above the numbers"#);
    assert_snapshot!(refusal("time_s,velocity_m_per_s\n0.00,0.1\n0.02,0.2\n0.04,-0.1\n"), @r#"line 1 reads "velocity_m_per_s", which speaks for velocities, and only histories of acceleration are read; take the record of accelerations, such as channel HNE of an accelerometer, or declare `acceleration` if the values were turned into accelerations"#);
}

#[test]
fn extreme_fields() {
    let header = "# c\n\ntime_s,acceleration_g\n0.0,1\n";
    assert_snapshot!(refusal(&format!("{header}0.1\n")), @"line 5 has 1 field(s), allowed are 2, the time and the acceleration; write one sample to a line, with a comma between");
    assert_snapshot!(refusal(&format!("{header}# c\n0.1,2,3\n")), @"line 6 has 3 field(s), allowed are 2, the time and the acceleration; write one sample to a line, with a comma between");
    assert_snapshot!(refusal(&format!("{header}0.1,0.2g\n")), @r#"line 5, field 2: "0.2g" is not a number; write it like -0.00640 or -.6403182E-02"#);
    assert_snapshot!(refusal(&format!("{header}0.1,\n")), @"line 5 has 1 field(s), allowed are 2, the time and the acceleration; write one sample to a line, with a comma between");
    assert_snapshot!(refusal(&format!("{header}0.1,NaN\n")), @r#"line 5, field 2: "NaN" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal(&format!("{header}inf,0.1\n")), @r#"line 5, field 1: "inf" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal(&format!("{header}1e999,0.1\n")), @r#"line 5, field 1: "1e999" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal(&format!("{header}0.1,-Infinity\n")), @r#"line 5, field 2: "-Infinity" is not finite, and every number must be; put a measured value there or cut the record before it"#);
    assert_snapshot!(refusal(&format!("{header}0.1,1e999\n")), @r#"line 5, field 2: "1e999" is not finite, and every number must be; put a measured value there or cut the record before it"#);
}

#[test]
fn extreme_times() {
    assert_snapshot!(refusal(&with_times(&["0.00", "0.01", "0.02", "0.04", "0.05"])),  @"the times rise in uneven steps, from 0.01 to 0.02 s: at line 5 by 0.02 s, where 0.01 s are the median; declare the step to which they are to be resampled, linear between them, as `time_step`, or print them with more decimals");
    assert_snapshot!(refusal(&with_times(&["0.00", "0.01", "0.005", "0.02"])),  @"line 4: the time is 0.005 s, allowed are times after the 0.01 s of the line before; sort the lines by time and keep one of each");
    assert_snapshot!(refusal(&with_times(&["0.00", "0.01", "0.01", "0.02"])),  @"line 4: the time is 0.01 s, allowed are times after the 0.01 s of the line before; sort the lines by time and keep one of each");
    assert_snapshot!(refusal(&with_times(&["0", "0", "0"])),  @"line 3: the time is 0 s, allowed are times after the 0 s of the line before; sort the lines by time and keep one of each");
    assert_snapshot!(refusal(&with_times(&["0", "1", "3"])),  @"the times rise in uneven steps, from 1 to 2 s: at line 3 by 1 s, where 2 s are the median; declare the step to which they are to be resampled, linear between them, as `time_step`, or print them with more decimals");
    assert_snapshot!(refusal(&with_times(&["5.00", "5.01", "5.02"])),  @"line 2: the first time is 5 s, allowed are 0 s and one time step, 0.01 s; shift the time column so that the record begins there");
    assert_snapshot!(refusal(&with_times(&["-0.01", "0.00", "0.01"])),  @"line 2: the first time is -0.01 s, allowed are 0 s and one time step, 0.01 s; shift the time column so that the record begins there");
    assert_snapshot!(refusal(&with_times(&["-1.7e308", "0", "1.7e308"])),  @"line 4: the time step is inf s, and must be finite and above 0 s; correct it there");
}

/// Comments that quote the header of another format, as provenance does, once determined the format.
#[test]
fn issue_comments_with_the_header_of_another_format() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/files");
    let files = std::fs::read_dir(folder).expect("the folder is there");
    for file in files {
        let path = file.expect("it is listed").path();
        let bytes = std::fs::read(&path).expect("it is read");
        let text = String::from_utf8_lossy(&bytes);
        let header = text.lines().take(60).map(|line| format!("# {line}\n"));
        let header: String = header.collect();
        let text = format!("{header}time_s,acceleration_g\n0,0.25\n0.01,0.5\n");
        let read = read(text.as_bytes());
        let read = read.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert_eq!(read.format(), pounding_motion::Format::Csv, "{}", path.display());
        assert_eq!(read.values(), [0.25, 0.5]);
    }
}

/// Sheets write numbers in quotes. Such a file was of no known format.
#[test]
fn issue_numbers_in_quotes_are_read() {
    let text = "\"Time (s)\",\"Acc, NS (g)\"\n\"0.00\",\"0.0\"\n\"0.01\",\"-0.25\"\n\"0.02\",\"0.125\"\n";
    let file = read(text.as_bytes()).expect("a record");
    assert_eq!(file.values(), [0.0, -0.25, 0.125]);
    assert_eq!((file.time_step(), file.unit().name()), (0.01, "g"));
}
