//! Tests of runs under a folder of records: printed lines and the folder of results.

use std::fs;

use serde_json::Value;

use crate::runs::printed;
use crate::suites::{TOWERS, suite};
use crate::{pounding, refusal};

/// Writes a changed copy of the folder's scene.
fn changed(test: &str, from: &str, to: &str) -> std::path::PathBuf {
    let folder = suite(test);
    assert!(TOWERS.contains(from), "{from}");
    fs::write(folder.join("changed.toml"), TOWERS.replace(from, to)).expect("a file");
    folder
}

const RECORDS: [&str; 4] = ["run", "changed.toml", "--records", "records"];

/// The scale factor of each record was not printed.
#[test]
fn issue_the_factor_of_every_record_is_shown() {
    let folder = changed(
        "batch_scale",
        "time_step_s = 0.02",
        "time_step_s = 0.02, scale_to.pga_g = 0.5, scale = 2",
    );
    let json = pounding(&folder, &[&RECORDS[..], &["--json"]].concat());
    let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let text = pounding(&folder, &RECORDS);
    // Both files hold one motion, rounded, one of them in cm/s²; the peak is near 4 m/s².
    for (index, name) in [(0, "column.txt"), (1, "pulse.csv")] {
        let factor = json["motions"][index]["scale_factor"].as_f64();
        let factor = factor.expect("a number");
        let wanted = 2.0 * 0.5 * 9.806_65 / 4.0;
        assert!((factor / wanted - 1.0).abs() < 1e-2, "{factor} {wanted}");
        let line = printed(&text).lines().find(|line| line.starts_with(name));
        let shown = line.and_then(|line| line.split_whitespace().nth(2));
        assert_eq!(shown, Some(&*pounding::text::short(factor)));
    }
    let alone = pounding(&folder, &["run", "changed.toml", "--details"]);
    assert!(printed(&alone).contains("; in all × "), "{}", alone.stdout);
}

/// A row with one impulsive contact had no forces in the table.
#[test]
fn issue_the_forces_of_laws_that_have_one_are_shown() {
    let third = "  { sdof = { name = \"third\", mass_kg = 2e5, period_s = 0.6, damping.ratio = 0.05 } },\n]";
    let two = TOWERS.replace("\n]", &format!("\n{third}"));
    let two = format!("{two}\n[[contacts]]\ngap_m = 0.001\nlaw.linear_spring = {{ impact_stiffness_n_per_m = 1e8 }}\n");
    let folder = suite("batch_forces");
    fs::write(folder.join("changed.toml"), two).expect("a file");
    let text = pounding(&folder, &RECORDS);
    let line = printed(&text).lines().find(|line| line.starts_with("pulse.csv"));
    let words: Vec<&str> = line.expect("a line").split_whitespace().collect();
    let json = pounding(&folder, &[&RECORDS[..], &["--json"]].concat());
    let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let pairs = &json["motions"][1]["pairs"];
    assert!(pairs[0]["collisions"].as_u64() > Some(0), "{pairs}");
    assert_eq!(pairs[0]["peak_force_n"], Value::Null, "an impulse has none");
    let force = pairs[1]["peak_force_n"].as_f64().expect("a force");
    assert_eq!(words[6], pounding::text::short(force / 1e3), "{words:?}");
}

/// `--out` was refused together with a folder of records.
#[test]
fn issue_a_folder_of_records_is_written_to_a_folder() {
    let folder = changed("batch_out", "towers", "two towers");
    let out = [&RECORDS[..], &["--out", "out"]].concat();
    let text = pounding(&folder, &out);
    let (table, results) = printed(&text).split_once("\nResults ").expect("where it is");
    assert_eq!(results.trim(), "out");
    let file = |name: &str| fs::read_to_string(folder.join("out").join(name)).expect("it is there");
    assert_eq!(file("runs.txt"), table);
    for (option, name) in [("--csv", "runs.csv"), ("--json", "runs.json")] {
        let printed = pounding(&folder, &[&RECORDS[..], &[option]].concat());
        assert_eq!(file(name), printed.stdout, "{name}");
    }
    // A second run replaces its own results but no other files.
    assert_eq!(pounding(&folder, &out).stdout, text.stdout);
    fs::write(folder.join("out/mine.txt"), "mine").expect("a file");
    let message = refusal(&pounding(&folder, &out));
    assert!(message.contains("such as \"mine.txt\""), "{message}");
}

/// "They do not touch" was printed for a run whose steps missed touches of the exact motion.
#[test]
fn issue_touches_that_the_steps_miss_are_not_denied() {
    let newmark = "method.newmark = { time_step_s = 3.0, beta = 0.25, gamma = 0.5 }\nduration_s = 3.0";
    let folder = changed("batch_missed", "duration_s = 3.0", newmark);
    let alone = pounding(&folder, &["run", "changed.toml", "--json", "--out", "out"]);
    let summary: Value = serde_json::from_str(&alone.stdout).expect("JSON");
    let pair = &summary["pairs"][0];
    assert_eq!(pair["collisions"], 0, "the steps see none");
    assert!(pair["errors"]["exact_collisions"].as_u64() > Some(0), "{pair}");
    let page = fs::read_to_string(folder.join("out/report.html")).expect("a report");
    assert!(!page.contains("They do not touch"), "the exact run does");
    assert!(
        page.contains("The steps of this run miss the touches that exact motion has."),
        "{page}"
    );
    let text = pounding(&folder, &RECORDS);
    assert!(
        printed(&text).contains("the steps miss the touches that exact motion has"),
        "{}",
        text.stdout
    );
}

/// No command that runs repeated the implausible values that `check` found.
#[test]
fn issue_what_is_unusual_is_said_by_runs() {
    let folder = changed("batch_unusual", "mass_kg = 2e5", "mass_kg = 200");
    let brief = "structures[1].sdof.mass_kg: found 200 kg, usual is 1e4 to 1e9 kg for a";
    for arguments in [&["run", "changed.toml"][..], &RECORDS] {
        let text = pounding(&folder, arguments);
        assert!(printed(&text).contains(brief), "{}", text.stdout);
    }
    let json = pounding(&folder, &["run", "changed.toml", "--json", "--out", "out"]);
    let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let all = json["unusual"].as_array().expect("a list");
    let places: Vec<_> = all.iter().map(|one| &one["place"]).collect();
    assert!(places.iter().any(|place| **place == "structures[1].sdof.mass_kg"), "{places:?}");
    let page = fs::read_to_string(folder.join("out/report.html")).expect("a report");
    let full = "structures[1].sdof.mass_kg: found 200 kg, usual is 1e4 to 1e9 kg for a building";
    assert!(page.contains(full), "{full}");
}
