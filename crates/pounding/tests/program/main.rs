//! Tests of the program `pounding` from outside: its output, and its messages about refused input.

mod assess;
mod assess_neighbours;
mod assess_safe;
mod assess_signed;
mod batches;
mod budgets;
mod buildings;
mod certificates;
mod codes;
mod collapses;
mod directions;
mod documents;
mod errors;
mod examples;
mod explain;
mod exports;
mod finite;
mod first_screens;
mod folders;
mod helps;
mod init;
mod isolators;
mod law_lists;
mod machines;
mod motion_issues;
mod motions;
mod names;
mod number_lists;
mod pages;
mod pairs;
mod plans;
mod promises;
mod records;
mod results;
mod runs;
mod scenes;
mod schema;
mod storeys;
mod stripes;
mod suites;
mod summaries;
mod sweep_refusals;
mod sweeps;
mod unusual;
mod unwatched;
mod view;
mod written;

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use serde_json::{Value, json};

const EXAMPLE: &str = "../../studies/examples/two-structures.json";

/// The output of the program.
struct Ended {
    code: i32,
    stdout: String,
    stderr: String,
}

/// Runs the program in a folder.
fn pounding(folder: &Path, arguments: &[&str]) -> Ended {
    let output = Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the program starts");
    let text = |bytes| String::from_utf8(bytes).expect("the program prints UTF-8");
    Ended {
        code: output.status.code().expect("the program ends by itself"),
        stdout: text(output.stdout),
        stderr: without_progress(&text(output.stderr)),
    }
}

/// Standard error without the progress lines of a sweep: a slow machine may print some in any test.
fn without_progress(stderr: &str) -> String {
    let is_count = |word: &str| word.chars().all(|sign| sign.is_ascii_digit() || sign == ',');
    let is_progress = |line: &&str| {
        let mut words = line.split(' ');
        let [done, of, all, runs] = [(); 4].map(|()| words.next().unwrap_or_default());
        is_count(done) && is_count(all) && (of, runs) == ("of", "runs,")
    };
    let lines = stderr.split_inclusive('\n');
    lines.filter(|line| !is_progress(line)).collect()
}

#[test]
fn reference_lines_of_progress() {
    let said = "17,184 of 20,000 runs, 00:00:10, 00:00:01 left\nerror: 3 of 4 runs failed\n0 of 4 runs, 00:01:10\n";
    assert_eq!(without_progress(said), "error: 3 of 4 runs failed\n");
}

/// An empty folder for one test. The program runs in it, so messages contain no path of this machine.
fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program").join(test);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("the folder of the last run can go");
    }
    fs::create_dir_all(&folder).expect("the folder can be made");
    folder
}

/// The example scene; its record `record.csv` has ten zero samples.
fn good_scene() -> Value {
    let text = fs::read_to_string(EXAMPLE).expect("the example is there");
    let mut scene: Value = serde_json::from_str(&text).expect("the example is JSON");
    scene["record"]["file"] = json!("record.csv");
    scene
}

/// Runs a scene, given as text, on a record, given as text.
fn run(test: &str, scene: &str, record: Option<&str>) -> Ended {
    let folder = folder(test);
    fs::write(folder.join("scene.json"), scene).expect("the scene can be written");
    if let Some(record) = record {
        fs::write(folder.join("record.csv"), record).expect("the record can be written");
    }
    pounding(&folder, &["run", "scene.json", "--details"])
}

/// A record at rest: `n_samples` of 0, 0.01 s apart.
fn quiet(n_samples: usize) -> String {
    let sample = |index| format!("{},0\n", index as f64 / 100.0);
    std::iter::once("time_s,acceleration_m_per_s2\n".to_string())
        .chain((0..n_samples).map(sample))
        .collect()
}

/// The message of a run that is refused: exit code 1, nothing on stdout, one line on stderr.
fn refusal(ended: &Ended) -> String {
    assert_eq!(
        (ended.code, ended.stdout.as_str(), ended.stderr.lines().count()),
        (1, "", 1),
        "a refusal is one line on stderr and exit code 1: {}",
        ended.stderr
    );
    ended.stderr.trim_end().into()
}
