//! Tests of messages about records that cannot be read or used.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use serde_json::{Value, json};

use crate::runs::printed;
use crate::suites::{self, suite};
use crate::{good_scene, pounding, quiet, refusal, run};

/// The message for the good scene on a record with this text.
fn refused(test: &str, record: &str) -> String {
    refusal(&run(test, &good_scene().to_string(), Some(record)))
}

/// An AT2 file whose header declares a number of values, with the given values.
fn at2(header: &str, values: &str) -> String {
    format!(
        "A DATABASE RECORD\nSOMEWHERE 01/02/03 0405, A STATION\nACCELERATION TIME SERIES IN UNITS OF G\n\
         {header}\n{values}\n"
    )
}

#[test]
fn extreme_record_not_there() {
    let ended = run("record_not_there", &good_scene().to_string(), None);
    let missing = fs::read(Path::new("record.csv")).expect_err("no record lies beside the crate");
    let message = refusal(&ended).replace(&missing.to_string(), "[what the system says]");
    assert_snapshot!(message, @"error: scene.json: record.file: record.csv cannot be read (it is looked for from the folder of the scene's file): [what the system says]");
}

#[test]
fn extreme_record_empty() {
    assert_snapshot!(refused("record_empty", ""), @"error: record.csv: the text holds nothing but blank lines and comments; give a header followed by numbers");
}

#[test]
fn extreme_record_of_comments_only() {
    assert_snapshot!(refused("record_comments", "# El Centro\n\n"), @"error: record.csv: the text holds nothing but blank lines and comments; give a header followed by numbers");
}

#[test]
fn extreme_record_of_unknown_format() {
    assert_snapshot!(refused("record_format", "El Centro 1940, north-south, 0.02 s\nin g\n"), @"error: record.csv: line 1 begins none of the formats known: CSV, PEER AT2, CSMIP V1, CSMIP V2, COSMOS 1.2, USGS SMC, USC V2, K-NET, ESM ASC, GeoNet, RENADIC V1, CWB, AFAD, UNAM, SCEC BBP, BHRC, CSMNC, DYNA, EMOD3D, USGS text, SAC, miniSEED, eqsig, SimCenter JSON, plain text; fetch the file again in one of them, or write one number to a line");
}

#[test]
fn extreme_record_without_header() {
    assert_snapshot!(refused("record_header", "0.00,0.1\n0.01,0.2\n"), @"error: record.csv: the file does not say in which unit its values are; declare it as `record.unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
}

#[test]
fn extreme_record_shorter_than_npts() {
    let record = at2("NPTS= 5, DT= .0100 SEC", ".1 .2 .3");
    assert_snapshot!(refused("record_short", &record), @"error: record.csv: the values end at line 5 after 3 of them, but the header declares 5; fetch the file again, or correct the header if the values are complete");
}

#[test]
fn extreme_record_with_a_word() {
    let record = quiet(10).replace("0.04,0", "0.04,none");
    assert_snapshot!(refused("record_word", &record), @r#"error: record.csv: line 6, field 2: "none" is not a number; write it like -0.00640 or -.6403182E-02"#);
}

#[test]
fn extreme_record_with_an_infinite_number() {
    let record = quiet(10).replace("0.04,0", "0.04,inf");
    assert_snapshot!(refused("record_infinite", &record), @r#"error: record.csv: line 6, field 2: "inf" is not finite, and every number must be; put a measured value there or cut the record before it"#);
}

#[test]
fn extreme_record_with_time_standing_still() {
    let record = quiet(10).replace("0.04,", "0.03,");
    assert_snapshot!(refused("record_still", &record), @"error: record.csv: line 6: the time is 0.03 s, allowed are times after the 0.03 s of the line before; sort the lines by time and keep one of each");
}

#[test]
fn extreme_record_with_a_hole() {
    let record = quiet(10).replace("0.04,0\n", "");
    assert_snapshot!(refused("record_hole", &record), @"error: record.csv: the times rise in uneven steps, from 0.01 to 0.02 s: at line 6 by 0.02 s, where 0.01 s are the median; declare the step to which they are to be resampled, linear between them, as `record.time_step_s`, or print them with more decimals");
}

#[test]
fn extreme_record_with_time_step_zero() {
    let record = at2("NPTS= 3, DT= 0.0 SEC", ".1 .2 .3");
    assert_snapshot!(refused("record_step_zero", &record), @"error: record.csv: line 4: the time step is 0 s, and must be finite and above 0 s; correct it there");
}

#[test]
fn extreme_record_with_negative_time_step() {
    let record = at2("NPTS= 3, DT= -.0100 SEC", ".1 .2 .3");
    assert_snapshot!(refused("record_step_negative", &record), @"error: record.csv: line 4: the time step is -0.01 s, and must be finite and above 0 s; correct it there");
}

/// The message named fields that no scene has.
#[test]
fn issue_what_a_file_leaves_out_is_named_by_its_field() {
    let refused = |record: Value, text: &str| {
        let mut scene = good_scene();
        scene["record"] = record;
        refusal(&run("fields", &scene.to_string(), Some(text)))
    };
    let column = "0.1\n-0.2\n0.3\n";
    assert_snapshot!(refused(json!({"file": "record.csv", "unit": "g"}), column), @"error: record.csv: the file does not say how far apart its values are; declare it as `record.time_step_s` in seconds");
    assert_snapshot!(refused(json!({"file": "record.csv", "time_step_s": 0.01}), column), @"error: record.csv: the file does not say in which unit its values are; declare it as `record.unit`, one of g, m_per_s2, cm_per_s2, mm_per_s2, mg, g_per_10");
    assert_snapshot!(refused(json!({"file": "record.csv", "time_step_s": 0, "unit": "g"}), column), @"error: record.csv: the declared `record.time_step_s` is 0 s, and must be finite and above 0 s");
    assert_snapshot!(refused(json!({"file": "record.csv", "time_step_s": 0.02}), &quiet(10)), @"error: record.csv: line 2 gives a time step of 0.01 s, but 0.02 s is declared as `record.time_step_s`; leave the declaration away");
    assert_snapshot!(refused(json!({"file": "record.csv", "component": "UP"}), &quiet(10)), @r#"error: record.csv: "UP" is declared as `record.component`, but the file holds one, which has no name; leave the declaration away"#);
    assert_snapshot!(refused(json!({"file": "record.csv", "per_count": 2}), &quiet(10)), @"error: record.csv: line 1 says that the values are in m_per_s2, but `record.per_count` is declared as 2; leave it away, there are no counts to scale");
    assert_snapshot!(refused(json!({"file": "record.csv", "resample_s": 1e-12}), &quiet(10)), @r#"error: scene.json: scene "two structures": record.resample_s: found 1e-12 s, which over 0.09 s makes more than 10000000 samples, allowed is a longer step"#);
}

#[test]
fn extreme_record_scaled_out_of_range() {
    let mut scene = good_scene();
    scene["record"]["scale"] = json!(1e308);
    let record = quiet(10).replace("0.04,0", "0.04,100");
    assert_snapshot!(refusal(&run("record_scale", &scene.to_string(), Some(&record))), @r#"error: scene.json: scene "two structures": record.scale: found 1e308, allowed 0, or numbers from 1e-100 to 1e100 in magnitude"#);
}

/// A component number was refused with "allowed is a text".
#[test]
fn issue_a_component_may_be_a_number() {
    let columns = "time,NS(gal),EW(gal),UD(gal)\n0.00,10,20,30\n0.01,-10,-20,-30\n0.02,10,20,30\n";
    let mut scene = good_scene();
    let checked = |scene: &Value| {
        let folder = crate::folder("component_number");
        fs::write(folder.join("scene.json"), scene.to_string()).expect("a file");
        fs::write(folder.join("record.csv"), columns).expect("a file");
        let ended = pounding(&folder, &["check", "scene.json", "--json"]);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        serde_json::from_str::<Value>(&ended.stdout).expect("JSON")
    };
    scene["record"] = json!({"file": "record.csv", "component": "UD"});
    let by_name = checked(&scene);
    scene["record"] = json!({"file": "record.csv", "component": 3});
    let by_number = checked(&scene);
    assert_eq!(by_number["record"], by_name["record"]);
    assert!(by_number["record"]["peak_m_per_s2"].is_number());
    // A row moves sideways, so a vertical component that a user names gets a remark.
    let unusual = by_number["unusual"].as_array().expect("a list");
    let said = unusual
        .iter()
        .find(|one| one["found"].as_str().is_some_and(|found| found.contains("vertical")));
    assert_eq!(said.expect("a doubt")["place"], "record");
}

/// Impossible peaks and time steps passed silently, and the channel of a seismometer passed as an acceleration.
#[test]
fn issue_what_looks_wrong_in_a_file_is_said() {
    let folder = crate::folder("unusual_file");
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("a file");
    let pounding = |arguments: &[&str]| pounding(&folder, arguments);
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    write("fast.csv", "time_s,acceleration_g\n0.0,0.1\n0.5,-60\n1.0,0.2\n");
    let said = words(&pounding(&["motion", "info", "fast.csv"]).stdout);
    let [step, peak] = ["a time step of 0.5 s in the file", "a peak of 60.0 g in the file"];
    assert!(said.contains(step) && said.contains(peak), "{said}");
    let mut scene = good_scene();
    scene["record"] = json!({"file": "fast.csv"});
    write("scene.json", &scene.to_string());
    let check = pounding(&["check", "scene.json", "--json"]).stdout;
    let check: Value = serde_json::from_str(&check).expect("JSON");
    let unusual = check["unusual"].as_array().expect("a list").iter();
    let found: Vec<_> = unusual.filter_map(|one| one["found"].as_str()).collect();
    assert!(found.contains(&step) && found.contains(&peak), "{found:?}");

    let velocity = "# time (s) N-S (cm/s) E-W (cm/s) U-D (cm/s)\n0.0 1.0 2.0 3.0\n0.01 -1.0 -2.0 -3.0\n0.02 1.0 2.0 3.0\n";
    write("velocity.bbp", velocity);
    let asked = ["motion", "info", "velocity.bbp", "--component", "1", "--unit", "cm_per_s2"];
    let refused = refusal(&pounding(&asked));
    assert!(refused.contains("declare --acceleration if"), "{refused}");
    let turned = words(&pounding(&[&asked[..], &["--acceleration"]].concat()).stdout);
    assert!(turned.contains("declared to be accelerations"), "{turned}");
    scene["record"] = json!({"file": "velocity.bbp", "component": 1, "unit": "cm_per_s2"});
    write("scene.json", &scene.to_string());
    let refused = refusal(&pounding(&["check", "scene.json"]));
    assert!(refused.contains("declare `record.acceleration` as true if"), "{refused}");
    scene["record"]["acceleration"] = json!(true);
    write("scene.json", &scene.to_string());
    assert_eq!(pounding(&["check", "scene.json"]).code, 0);
}

/// The paragraph under a heading with single blanks between its words; empty if there is none.
fn under(text: &str, heading: &str) -> String {
    let lines = text.lines().skip_while(|line| !line.starts_with(heading));
    let mut lines = lines.take_while(|line| !line.is_empty());
    let first = lines.next().unwrap_or_default();
    // The following lines are indented, even without a blank line between paragraphs.
    let others = lines.take_while(|line| line.starts_with(' '));
    let words = std::iter::once(first).chain(others).flat_map(str::split_whitespace);
    words.collect::<Vec<_>>().join(" ")
}

/// Motions with an unknown direction had no remark, and a sweep failed at an unreadable file of a folder.
#[test]
fn issue_directions_that_nothing_tells_are_said() {
    let folder = suite("untold");
    for (name, direction) in [("A-ELC180.AT2", ", 180"), ("A-ELC-1.AT2", ", 1 Up")] {
        fs::write(folder.join("records").join(name), suites::at2(direction)).expect("a file");
    }
    let sweep = "scene = \"towers.toml\"\nrecords = \"records\"\noutputs.pairs = [\"collisions\"]\n";
    fs::write(folder.join("sweep.toml"), sweep).expect("a file");
    let said = |arguments: &[&str]| {
        let text = printed(&pounding(&folder, arguments)).to_string();
        under(&text, "Records")
    };
    let gap = said(&["gap", "towers.toml", "--records", "records"]);
    assert!(
        gap.starts_with("Records 5 files, 3 used and 2 left out: 3 motions of 3 events"),
        "{gap}"
    );
    assert!(gap.contains("direction not told"), "{gap}");
    assert!(gap.ends_with("column.txt, pulse.csv"), "{gap}");
    assert!(
        gap.contains("1 vertical component, by the name in the file: A-ELC-1.AT2 (1 Up)"),
        "{gap}"
    );
    assert!(gap.contains("spectra.V3"), "{gap}");
    // All commands leave out the same records and print equal remarks about them.
    assert_eq!(said(&["run", "towers.toml", "--records", "records", "--no-error"]), gap);
    assert_eq!(said(&["sweep", "sweep.toml"]), gap);
    let info = pounding(
        &folder,
        &["motion", "info", "records", "--unit", "cm_per_s2", "--time-step", "0.02"],
    );
    assert_eq!(under(printed(&info), "Records"), gap);
    let json = pounding(&folder, &["gap", "towers.toml", "--records", "records", "--json"]);
    let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let motions = json["motions"].as_array().expect("a list");
    let shaken = motions.iter().filter(|one| one.get("refused").is_none());
    let names: Vec<_> = shaken.map(|one| one["record"].as_str()).collect();
    assert!(names.contains(&Some("A-ELC180.AT2")), "{names:?}");
    let left_out = json["left_out"].to_string();
    assert!(left_out.contains("A-ELC-1.AT2"), "{left_out}");
}

/// Of several grounds that do not come to rest, the smallest drift was called the largest. Widths had no remark about missing records.
#[test]
fn issue_the_worst_of_all_records_is_named() {
    let folder = suite("worst_drift");
    for (name, offset) in [("mild.csv", 0.06), ("worst.csv", 2.0)] {
        let row = |step: usize| {
            let time = 0.02 * step as f64;
            format!("{time:.2},{:.5}\n", 2.0 * libm::sin(5.0 * time + offset) + offset)
        };
        let rows: String = (0..300).map(row).collect();
        fs::write(folder.join("records").join(name), format!("time_s,acceleration_m_per_s2\n{rows}")).expect("a file");
    }
    for command in ["gap", "run"] {
        let ended = pounding(&folder, &[command, "towers.toml", "--records", "records"]);
        let said = printed(&ended).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains("farthest off worst.csv: found a ground that"), "{said}");
        assert!(!said.contains("missing here"), "{said}");
    }
    let cut = suites::at2(", 90");
    let half = &cut[..cut.len() * 3 / 4];
    fs::write(folder.join("records").join("cut.AT2"), half).expect("a file");
    for command in ["gap", "run"] {
        let ended = pounding(&folder, &[command, "towers.toml", "--records", "records"]);
        let said = printed(&ended);
        assert!(said.contains("1 record of the folder is missing here"), "{said}");
    }
}

/// One kind of doubt filled two lines because its peaks differ. A named file of a sensor on a roof had no remark.
#[test]
fn issue_a_kind_is_one_line_and_a_roof_is_no_ground() {
    let folder = suite("one_kind");
    for (name, size) in [("small.csv", 0.3), ("large.csv", 5.0)] {
        let row = |step: usize| {
            let time = 0.02 * step as f64;
            format!("{time:.2},{:.5}\n", size * (1.1 + libm::sin(5.0 * time)))
        };
        let rows: String = (0..300).map(row).collect();
        let text = format!("time_s,acceleration_m_per_s2\n{rows}");
        fs::write(folder.join("records").join(name), text).expect("a file");
    }
    let ended = pounding(&folder, &["gap", "towers.toml", "--records", "records"]);
    let said = printed(&ended).split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(said.matches("that never change sign").count(), 1, "{said}");
    let header = "Time (s),NS1 (gal),NS2 (gal)\n";
    let row = |step: usize| {
        let wave = libm::sin(0.1 * step as f64);
        format!("{:.2},{:.3},{:.3}\n", 0.02 * step as f64, 90.0 * wave, 99.0 * wave)
    };
    let rows = (0..300).map(row);
    fs::write(folder.join("records/deep.csv"), header.to_owned() + &rows.collect::<String>()).expect("a file");
    let scene = |component: &str| {
        let record = format!("record = {{ file = \"records/deep.csv\", component = \"{component}\" }}");
        let old = "record = { file = \"records/column.txt\", unit = \"cm_per_s2\", time_step_s = 0.02 }";
        assert!(suites::TOWERS.contains(old));
        let text = suites::TOWERS.replace(old, &record);
        fs::write(folder.join("deep.toml"), text).expect("a file");
        printed(&pounding(&folder, &["run", "deep.toml", "--no-error"])).to_string()
    };
    assert!(scene("NS1").contains("a sensor that is not at the ground"));
    assert!(!scene("NS2").contains("not at the ground"));
}
