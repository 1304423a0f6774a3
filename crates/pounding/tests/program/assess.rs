//! Tests of `pounding assess`: the answer comes first, and nothing unsafe passes silently.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::assess_safe::burst;
use crate::{Ended, folder, pounding};

const RECORDS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/records");

/// Two towers and a low stiff building; floors of the first two are level.
pub(crate) const TOWERS: &str = r#"
name = "towers"
record.file = "el-centro-1940-ns-chopra.csv"

[[structures]]
building = { name = "Tower 8", period_s = 1.1, damping.ratio = 0.05, storeys = [{ mass_kg = 4e5, height_m = 3.5, repeat = 4, yield_drift_ratio = 0.005, hardening_ratio = 0.03 }] }

[[structures]]
building = { name = "Tower 5", period_s = 0.6, damping.ratio = 0.05, storeys = [{ mass_kg = 4e5, height_m = 3.5, repeat = 3 }] }

[[structures]]
sdof = { name = "Workshop", mass_kg = 8e5, period_s = 0.2, damping.ratio = 0.05, height_m = 3.5 }

[[contacts]]
gap_m = 0.04
law.hertz_damp = { impact_stiffness_n_per_m1_5 = 2.75e9, restitution = 0.65 }

[[contacts]]
gap_m = 0.04
law.hertz_damp = { impact_stiffness_n_per_m1_5 = 2.75e9, restitution = 0.65 }
"#;

/// A folder with the scene and its records.
pub(crate) fn workplace(test: &str, scene: &str) -> PathBuf {
    let work = folder(test);
    fs::write(work.join("scene.toml"), scene).expect("it can be written");
    fs::create_dir(work.join("records")).expect("it can be made");
    for name in ["el-centro-1940-ns-chopra.csv", "el-centro-1940-ns-peer-pacific-engineering.csv"] {
        let from = Path::new(RECORDS).join(name);
        fs::copy(&from, work.join("records").join(name)).expect("it can be copied");
    }
    fs::copy(
        Path::new(RECORDS).join("el-centro-1940-ns-chopra.csv"),
        work.join("el-centro-1940-ns-chopra.csv"),
    )
    .expect("it can be copied");
    work
}

pub(crate) fn assess(work: &Path, more: &[&str]) -> Ended {
    let arguments = ["assess", "scene.toml", "--records", "records"];
    pounding(work, &[&arguments, more].concat())
}

#[test]
fn reference_the_answer_comes_first() {
    let work = workplace("assess_first", TOWERS);
    let ended = assess(&work, &["--target", "ec8:a_g=0.25g,ground=C"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    insta::assert_snapshot!(ended.stdout);
}

/// Under the proposed widths no run touches; under a step less some do.
#[test]
fn limit_what_is_proposed_is_enough() {
    let work = workplace("assess_proposed", TOWERS);
    let of = |scene: &str| -> Value {
        fs::write(work.join("scene.toml"), scene).expect("it can be written");
        let ended = assess(&work, &["--scale", "pga=0.4g", "--json"]);
        serde_json::from_str(&ended.stdout).expect("JSON")
    };
    let found = of(TOWERS);
    let gaps = found["gaps"].as_array().expect("gaps");
    let with = |change: f64| {
        let mut scene = TOWERS.to_string();
        for gap in gaps {
            let width = gap["proposed_m"].as_f64().expect("a width") + change;
            scene = scene.replacen("gap_m = 0.04", &format!("gap_m = {width}"), 1);
        }
        let touching = of(&scene)["gaps"].clone();
        let touching = touching.as_array().expect("gaps").iter();
        touching
            .map(|gap| gap["touching_runs"].as_u64().expect("a count"))
            .collect::<Vec<_>>()
    };
    assert_eq!(gaps.len(), 2);
    assert_eq!(with(0.0), [0, 0]);
    assert!(with(-0.01).iter().all(|runs| *runs > 0));
}

/// A run with a drift of a quarter of the storey height printed "Warnings none".
#[test]
fn issue_impossible_responses_are_warned_of() {
    let weak = TOWERS.replace("yield_drift_ratio = 0.005", "yield_drift_ratio = 0.001");
    let weak = weak.replace(
        "record.file = \"el-centro-1940-ns-chopra.csv\"",
        "record = { file = \"el-centro-1940-ns-chopra.csv\", scale_to.pga_g = 1.6 }",
    );
    let work = workplace("assess_impossible", &weak);
    let run = pounding(&work, &["run", "scene.toml"]);
    let all = assess(&work, &[]);
    for printed in [run.stdout, all.stdout] {
        let printed = printed.split_whitespace().collect::<Vec<_>>().join(" ");
        for said in [
            "of the height, above 2.5 %, the limit for buildings (NBCC 2015, 4.1.8.13)",
            "ductility demand of",
            "above the design limit of 0.25 (ASCE 7-16, 12.8.7)",
        ] {
            assert!(printed.contains(said), "{said}:\n{printed}");
        }
        assert!(!printed.contains("bring the storey down"), "{printed}");
    }
    let answer = assess(&work, &[]).stdout;
    let answer = answer.split("Motions").next().expect("an answer");
    let answer = answer.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(answer.contains("Caution: ") && answer.contains("above 2.5 %"), "{answer}");
}

/// A scale of 1144 was accepted without a warning.
#[test]
fn issue_a_far_scale_is_warned_of() {
    let far = TOWERS.replace(
        "record.file = \"el-centro-1940-ns-chopra.csv\"",
        "record = { file = \"el-centro-1940-ns-chopra.csv\", scale = 12.0 }",
    );
    let work = workplace("assess_far", &far);
    let run = pounding(&work, &["run", "scene.toml", "--no-error"]);
    assert!(run.stdout.contains("a scale factor of 12"), "{}", run.stdout);
    let all = assess(&work, &["--scale", "pga=3g"]);
    assert!(
        all.stdout.starts_with("Unusual   2 motions, the farthest off")
            && all.stdout.contains("a scale factor")
            && all.stdout.contains("scaled by less than 0.25 or more than 4"),
        "{}",
        all.stdout
    );
}

/// A force was printed with four digits although its stiffness is unknown. Now it is a range, and a wide one.
#[test]
fn issue_forces_are_ranges() {
    let work = workplace("assess_ranges", TOWERS);
    let of = |more: &[&str]| -> Vec<Value> {
        let ended = assess(&work, &[more, &["--scale", "pga=0.6g", "--json"]].concat());
        let found: Value = serde_json::from_str(&ended.stdout).expect("JSON");
        let pairs = found["pairs"].as_array().expect("pairs").clone();
        pairs.into_iter().filter(|pair| pair["touching_runs"] != 0).collect()
    };
    let ratio = |pair: &Value| {
        let force = &pair["peak_force_n"];
        let end = |end: &str| force[end]["largest"].as_f64().expect("a force");
        end("largest") / end("least")
    };
    let (wide, none) = (of(&[]), of(&["--stiffness", "1..1"]));
    assert!(!wide.is_empty() && wide.len() == none.len());
    assert!(wide.iter().all(|pair| ratio(pair) > 2.0), "{wide:?}");
    assert!(none.iter().all(|pair| (ratio(pair) - 1.0).abs() <= 0.0), "{none:?}");
}

/// The answer "1078 mm are enough for all 22 motions" had no median.
#[test]
fn issue_gaps_have_statistics() {
    let work = workplace("assess_gap", TOWERS);
    for index in 0..5 {
        burst(&work, &format!("burst-{index}.csv"), 0.5 + 0.1 * f64::from(index), 0.3);
    }
    let gap = pounding(&work, &["gap", "scene.toml", "--records", "records"]);
    let printed = gap.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        printed.contains("mm for half of them,") && printed.contains("mm for 84 %"),
        "{printed}"
    );
}

/// Floors at 3.5 and 3.8 m were refused, though the width that keeps them apart needs no contact.
#[test]
fn issue_floors_beside_columns_are_not_called_level() {
    let uneven = TOWERS.replacen("height_m = 3.5, repeat = 3", "height_m = 3.8, repeat = 3", 1);
    let work = workplace("assess_uneven", &uneven);
    let all = found(&work, &[]);
    assert!(all["gaps"][0]["beside_columns_m"].as_f64() > Some(0.0), "{all}");
    let ended = pounding(&work, &["run", "scene.toml"]);
    assert!(ended.code == 0 && ended.stdout.contains("column of storey"), "{}", ended.stdout);
}

#[test]
fn reference_the_folder_holds_what_is_printed() {
    let work = workplace("assess_out", TOWERS);
    let ended = assess(&work, &["--out", "out", "--author", "A. Engineer", "--date", "2026-11-25"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let read = |name: &str| fs::read_to_string(work.join("out").join(name)).expect("it is there");
    let (page, table) = (read("report.html"), read("assess.csv"));
    let first = ended.stdout.lines().next().expect("an answer");
    let first = first.trim_start_matches("Answer").trim();
    assert!(page.contains(first) && page.contains("A. Engineer, 2026-11-25."));
    roxmltree::Document::parse_with_options(
        page.strip_prefix("<!DOCTYPE html>").expect("HTML"),
        roxmltree::ParsingOptions::default(),
    )
    .expect("it is well-formed");
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let header: Vec<String> = rows.headers().expect("a header").iter().map(String::from).collect();
    let quantity = header.iter().position(|name| name == "quantity").expect("a column");
    let required = rows
        .records()
        .filter(|row| row.as_ref().is_ok_and(|row| &row[quantity] == "required_m"));
    // There are two gaps, two records and two directions.
    assert_eq!(required.count(), 8);
    assert_eq!(table, assess(&work, &["--csv"]).stdout);
    for name in ["row.png", "gap.svg", "assess.json"] {
        assert!(work.join("out").join(name).is_file(), "{name}");
    }
}

#[test]
fn extreme_what_cannot_be_assessed_says_why() {
    let work = workplace("assess_refused", TOWERS);
    let said = |more: &[&str]| {
        let ended = assess(&work, more);
        format!("{} {}", ended.code, ended.stderr)
    };
    let all = [
        said(&["--target", "ec8:a_g=0.25g"]),
        said(&["--target", "nowhere.csv"]),
        said(&["--scale", "pga=-1g"]),
        said(&["--scale", "sa(0.8s)"]),
        said(&["--stiffness", "2..10"]),
    ];
    insta::assert_snapshot!(all.join("\n"));
}

/// A gap in millimetres passed as one in metres: "30000 mm is enough".
#[test]
fn issue_what_is_unusual_in_the_scene_is_said() {
    let scene = TOWERS.replace("gap_m = 0.04", "gap_m = 40");
    let ended = assess(&workplace("assess_unusual", &scene), &[]);
    assert!(ended.stdout.contains("contacts[0].gap_m"), "{}", ended.stdout);
}

/// The report did not name the scaling, so a repetition gave another answer.
#[test]
fn issue_the_report_repeats_the_scaling() {
    let work = workplace("assess_repeated", TOWERS);
    let target = "ec8:a_g=0.3g,ground=C";
    let ended = assess(&work, &["--target", target, "--out", "out"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let page = fs::read_to_string(work.join("out/report.html")).expect("a page");
    let command = page.lines().find(|line| line.contains("pounding assess scene.json"));
    let command = command.expect("the command that repeats it");
    assert!(command.contains(target), "{command}");
}

/// The JSON of an assessment.
pub(crate) fn found(work: &Path, more: &[&str]) -> Value {
    let ended = assess(work, &[more, &["--json"]].concat());
    serde_json::from_str(&ended.stdout).expect("JSON")
}

/// The mean spectrum of eleven records fell short of the target without a warning.
#[test]
fn issue_a_mean_spectrum_below_its_target_is_warned_of() {
    let work = workplace("assess_mean_spectrum", TOWERS);
    fs::write(work.join("peak.csv"), "0.1,0.1\n0.9,0.1\n1.0,3\n1.1,0.1\n").expect("it can be written");
    let ended = assess(&work, &["--target", "peak.csv"]);
    let said = ended.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        said.contains("EN 1998-1:2004, 3.2.3.1.2 (4) c, wants 90 %")
            && said.contains("ASCE/SEI 7-16, 16.2.3.2, compares maximum-direction spectra with MCE_R, which is not done here"),
        "{said}"
    );
    assert!(said.contains("scaled to the spectrum of a table"), "{said}");
    let share = found(&work, &["--target", "peak.csv"])["target"]["least_share"].as_f64();
    assert!(share.is_some_and(|share| share < 0.9), "{share:?}");
}

/// `a_g = 0.25` was read in g; Eurocode 8 gives it in m/s².
#[test]
fn issue_a_number_without_a_unit_is_asked_for_one() {
    let work = workplace("assess_units", TOWERS);
    let scale = assess(&work, &["--scale", "pga=0.3"]).stderr;
    assert!(scale.contains("write 0.3g or 0.3m/s2"), "{scale}");
    let target = assess(&work, &["--target", "ec8:a_g=0.25,ground=C"]).stderr;
    assert!(target.contains("with its unit"), "{target}");
    let said = assess(&work, &["--scale", "pga=2.94m/s2"]).stdout;
    assert!(said.contains("g = 2.940 m/s²"), "{said}");
}

/// Two components of one event counted as two independent records.
#[test]
fn issue_components_of_one_event_are_one_event() {
    let work = workplace("assess_events", TOWERS);
    let records = work.join("records");
    let names = ["chopra", "peer-pacific-engineering"].map(|end| format!("el-centro-1940-ns-{end}.csv"));
    for (name, other) in names.iter().zip(["quake-H1.csv", "quake-H2.csv"]) {
        fs::rename(records.join(name), records.join(other)).expect("it can be renamed");
    }
    let all = found(&work, &[]);
    assert_eq!((&all["events"], &all["runs"]), (&1.into(), &4.into()));
    let said = assess(&work, &[]).stdout;
    assert!(said.contains("2 files: 2 motions of 1 event"), "{said}");
    assert!(said.contains("in about one case of 2"), "{said}");
}

/// An acceleration was printed with three digits although it depends on an unknown force.
#[test]
fn issue_accelerations_are_ranges() {
    let work = workplace("assess_accelerations", TOWERS);
    let all = found(&work, &["--scale", "pga=0.6g"]);
    let floors = all["floors"].as_array().expect("floors");
    let ratio = |floor: &Value| {
        let range = &floor["acceleration_amplification_over_stiffness"];
        let end = |end: &str| range[end]["median"].as_f64().expect("a number");
        end("largest") / end("least")
    };
    assert!(floors.iter().all(|floor| ratio(floor) >= 1.0), "{floors:?}");
    assert!(floors.iter().any(|floor| ratio(floor) > 1.5), "{floors:?}");
    let most = |of: &str| all["by_stiffness"][of]["largest"].as_f64().expect("a ratio");
    assert!(2.0 * most("drift_largest_over_least") < most("acceleration_largest_over_least"));
}

/// Half of the folder could not be read, and the answer did not mention it. Then its first sentence was about files.
#[test]
fn issue_what_is_left_out_is_said_in_the_answer() {
    let work = workplace("assess_left_out", TOWERS);
    fs::write(work.join("records/bad.csv"), "time_s,acceleration_g\n0,x\n").expect("a file");
    let said = assess(&work, &[]).stdout;
    let answer = said.split("Motions").next().expect("an answer");
    assert!(answer.starts_with("Answer    Caution: the records are not scaled"), "{said}");
    assert!(answer.contains("1 record of the folder is missing here"), "{said}");
    assert!(said.contains("bad.csv:"), "{said}");
}
