//! Tests of summaries of sweeps: numbers over all runs, with equal bytes however the sweep is run.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use insta::assert_snapshot;
use serde_json::{Value, json};

use crate::runs::printed;
use crate::sweeps::{sweep, with_sweep};
use crate::{pounding, refusal};

/// The sweep with two gaps, and a summary for each gap.
fn summed(count: u64, rows: bool) -> Value {
    let mut words = sweep(count);
    words["vary"][0] = json!({"field": "contacts[0].gap_m", "values": [0.005, 0.015]});
    words["summary"] = json!({
        "by": ["contacts[0].gap_m"],
        "exceedance": {"peak_displacement_m": [0.05], "left – right: peak_force_n": [1e6, 2e6]},
        "rows": rows,
    });
    words
}

fn bytes(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Runs a share of the sweep into `shards.csv`.
fn run_shard(folder: &Path, shard: &str) {
    let arguments = ["sweep", "sweep.json", "--out", "shards.csv", "--shard"];
    printed(&pounding(folder, &[&arguments[..], &[shard]].concat()));
}

/// Runs the program with a number of threads; returns whether it succeeds.
fn runs(folder: &Path, arguments: &[&str], threads: &str) -> bool {
    Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
        .args(arguments)
        .current_dir(folder)
        .env("RAYON_NUM_THREADS", threads)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .expect("the program starts")
        .success()
}

#[test]
fn reference_a_summary_in_place_of_rows() {
    let folder = with_sweep("summary_small", &summed(16, false));
    let ended = pounding(&folder, &["sweep", "sweep.json", "--out", "all.csv"]);
    assert_snapshot!(printed(&ended));
    let text = String::from_utf8(bytes(&folder, "all.csv")).expect("text");
    let of_one = |line: &&str| !line.starts_with("0.015") && !line.contains("histogram");
    let shown: Vec<&str> = text.lines().filter(of_one).collect();
    assert_snapshot!(shown.join("\n"));
    assert!(!folder.join("all.csv.parts").exists(), "parts go");
}

/// If every run fails the sweep fails, and the message lists the first reasons.
#[test]
fn extreme_a_summary_of_runs_that_fail() {
    let mut words = summed(4, false);
    words["budget"] = json!({"seconds": 1e-9});
    let folder = with_sweep("summary_failed", &words);
    let ended = pounding(&folder, &["sweep", "sweep.json"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stdout.contains("run 0: "), "{}", ended.stdout);
    assert!(ended.stderr.contains("all 8 runs failed: the summary says why"), "{}", ended.stderr);
}

/// The summary has equal bytes with and without rows, and agrees with the rows.
#[test]
fn limit_a_summary_is_that_of_the_rows() {
    let folder = with_sweep("summary_rows", &summed(1000, true));
    let arguments = ["sweep", "sweep.json", "--out", "runs.csv"];
    printed(&pounding(&folder, &arguments));
    let alone = summed(1000, false).to_string();
    fs::write(folder.join("alone.json"), alone).expect("a file");
    let arguments = ["sweep", "alone.json", "--out", "alone.csv"];
    printed(&pounding(&folder, &arguments));
    let summary = bytes(&folder, "alone.csv");
    assert!(summary == bytes(&folder, "runs.summary.csv"), "rows change a summary");

    let (peaks, told) = (peaks(&folder.join("runs.csv")), told(&summary));
    assert_eq!(peaks.len(), 1000);
    let mean = peaks.iter().sum::<f64>() / 1000.0;
    let scatter = peaks.iter().map(|peak| (peak - mean) * (peak - mean));
    let above = peaks.iter().filter(|peak| **peak > 0.05).count();
    for (key, wanted, allowed) in [
        ("numbers", 1000.0, 0.0),
        ("without_number", 0.0, 0.0),
        ("least", peaks[0], 0.0),
        ("largest", peaks[999], 0.0),
        ("mean", mean, 1e-13),
        ("standard_deviation", (scatter.sum::<f64>() / 999.0).sqrt(), 1e-13),
        ("exceedance 0.05", above as f64 / 1000.0, 0.0),
        ("quantile 0.5", peaks[499], 0.5 / 64.0),
        ("quantile 0.99", peaks[989], 0.5 / 64.0),
    ] {
        let [found, low, high] = told[key];
        let found = found.unwrap_or_else(|| panic!("{key} in {told:?}"));
        assert!((found - wanted).abs() <= allowed * wanted, "{key}: {found}, wanted {wanted}");
        let within = low.is_none_or(|low| low <= wanted) && high.is_none_or(|high| wanted <= high);
        assert!(within, "{key}: {wanted} in {low:?} to {high:?}");
    }
}

/// Sorted magnitudes of the left structure at the first gap, from the table of rows.
fn peaks(rows: &Path) -> Vec<f64> {
    let mut rows = csv::Reader::from_path(rows).expect("a table");
    let rows = rows.records().map(|row| row.expect("a row"));
    let mut peaks: Vec<f64> = rows
        .filter(|row| &row[3] == "0.005")
        .map(|row| row[5].parse::<f64>().expect("a peak").abs())
        .collect();
    peaks.sort_by(f64::total_cmp);
    peaks
}

/// The summary of those magnitudes: value and bounds by the statistic and its argument.
fn told(summary: &[u8]) -> BTreeMap<String, [Option<f64>; 3]> {
    let mut table = csv::Reader::from_reader(summary);
    let lines = table.records().map(|line| line.expect("a line"));
    let lines = lines.filter(|line| &line[0] == "0.005" && &line[1] == "abs(left: peak_displacement_m)" && &line[2] != "histogram");
    let told = lines.map(|line| {
        let key = format!("{} {}", &line[2], &line[3]);
        let numbers = [4, 5, 6].map(|place: usize| line[place].parse().ok());
        (key.trim().to_owned(), numbers)
    });
    told.collect()
}

/// The summary is equal with one thread or two, whole or in shards, killed or not.
#[test]
fn limit_the_same_summary_whatever_happens_on_the_way() {
    let folder = with_sweep("summary_shards", &summed(10_000, false));
    for threads in ["1", "2"] {
        let out = format!("{threads}.csv");
        assert!(runs(&folder, &["sweep", "sweep.json", "--out", &out], threads));
    }
    let whole = bytes(&folder, "1.csv");
    assert!(whole == bytes(&folder, "2.csv"), "threads change bytes");

    for shard in ["3/3", "1/3", "2/3"] {
        run_shard(&folder, shard);
    }
    printed(&pounding(&folder, &["merge", "shards.csv"]));
    assert!(whole == bytes(&folder, "shards.csv"), "shards change bytes");

    let arguments = ["sweep", "sweep.json", "--out", "killed.csv"];
    let mut killed = 0;
    for kill in 1..=8 {
        let mut child = Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
            .args(arguments)
            .current_dir(&folder)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program starts");
        std::thread::sleep(Duration::from_millis(13 * kill));
        child.kill().expect("it can be killed");
        child.wait().expect("it ends");
        if folder.join("killed.csv").exists() {
            break;
        }
        killed += 1;
    }
    assert!(killed > 0, "at least one was killed on the way");
    if !folder.join("killed.csv").exists() {
        printed(&pounding(&folder, &arguments));
    }
    assert!(whole == bytes(&folder, "killed.csv"), "a kill changes bytes");
}

/// A changed digit in a part is found, and the part runs again.
#[test]
fn extreme_a_changed_digit_of_a_part_is_found() {
    let folder = with_sweep("summary_changed", &summed(1000, false));
    printed(&pounding(&folder, &["sweep", "sweep.json", "--out", "whole.csv"]));
    for shard in ["1/2", "2/2"] {
        run_shard(&folder, shard);
    }
    let part = folder.join("shards.csv.parts/part-000000003.csv");
    let text = fs::read_to_string(&part).expect("a part");
    let place = text.rfind(|letter: char| letter.is_ascii_digit()).expect("a digit");
    let digit = if text.as_bytes()[place] == b'7' { "8" } else { "7" };
    fs::write(&part, format!("{}{digit}{}", &text[..place], &text[place + 1..])).expect("a file");
    assert_snapshot!(refusal(&pounding(&folder, &["merge", "shards.csv"])), @"error: shards.csv.parts/part-000000003.csv: found other bytes than were written, allowed is the file as it was written; start the sweep again, or the shard that made it, which runs this part anew");
    let ended = pounding(&folder, &["sweep", "sweep.json", "--out", "shards.csv"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let again = "run again: shards.csv.parts/part-000000003.csv: found other bytes";
    assert!(ended.stderr.starts_with(again), "{}", ended.stderr);
    assert!(bytes(&folder, "whole.csv") == bytes(&folder, "shards.csv"), "a change is left");
}

/// An existing summary stays, even next to the table; a compressed summary has the same contents.
#[test]
fn extreme_a_summary_that_is_there_already() {
    let folder = with_sweep("summary_there", &summed(4, true));
    fs::write(folder.join("runs.summary.csv"), "mine").expect("a file");
    let arguments = ["sweep", "sweep.json", "--out", "runs.csv"];
    assert_snapshot!(refusal(&pounding(&folder, &arguments)), @"error: runs.summary.csv: is there already, allowed is a new file; name another one or add --overwrite");
    assert_eq!(bytes(&folder, "runs.summary.csv"), b"mine");
    printed(&pounding(&folder, &[&arguments[..], &["--overwrite"]].concat()));
    assert!(bytes(&folder, "runs.summary.csv").starts_with(b"contacts[0].gap_m,column,statistic"));
    fs::write(folder.join("sweep.json"), summed(4, false).to_string()).expect("a file");
    printed(&pounding(&folder, &["sweep", "sweep.json", "--out", "all.csv.zst"]));
    assert!(bytes(&folder, "all.csv.zst").starts_with(&[0x28, 0xb5, 0x2f, 0xfd]), "a frame");
}
