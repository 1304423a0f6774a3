//! Tests of `pounding sweep` and `pounding merge`: equal bytes however they are run.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use insta::assert_snapshot;
use serde_json::{Value, json};

use crate::runs::printed;
use crate::suites::suite;
use crate::{folder, pounding, refusal};

/// Two structures under half a sine; a run takes about 0.1 ms.
pub(crate) fn scene() -> Value {
    json!({
        "name": "two",
        "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
        "duration_s": 1.0,
        "structures": [
            {"sdof": {"name": "left", "mass_kg": 1e5, "period_s": 0.8, "damping": {"ratio": 0.05}}},
            {"sdof": {"name": "right", "mass_kg": 2e5, "period_s": 0.4, "damping": {"ratio": 0.05}}},
        ],
        "contacts": [{"gap_m": 0.01, "law": {"linear_spring": {"impact_stiffness_n_per_m": 1e8}}}],
        "method": {"central_difference": {"time_step_s": 0.002}},
    })
}

pub(crate) fn sweep(count: u64) -> Value {
    json!({
        "scene": scene(),
        "vary": [
            {"field": "contacts[0].gap_m", "uniform": {"from": 0.0, "to": 0.02}},
            {"field": "structures[0].sdof.period_s", "log_uniform": {"from": 0.3, "to": 1.5}},
        ],
        "samples": {"count": count, "seed": 3, "method": "sobol"},
    })
}

/// A folder that contains a sweep.
pub(crate) fn with_sweep(test: &str, words: &Value) -> PathBuf {
    let folder = folder(test);
    let text = serde_json::to_string_pretty(words).expect("JSON");
    fs::write(folder.join("sweep.json"), text).expect("a file");
    folder
}

fn table(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).expect("the table is there")
}

/// Starts the program in a folder with environment variables.
fn start(folder: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> Child {
    Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
        .args(arguments)
        .current_dir(folder)
        .envs(variables.iter().copied())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts")
}

#[test]
fn reference_a_small_sweep() {
    let folder = with_sweep("sweep_small", &sweep(4));
    let ended = pounding(&folder, &["sweep", "sweep.json"]);
    assert_snapshot!(printed(&ended), @r"
    Sweep     4 runs
    Results   sweep.json.csv: 4 rows, none failed
    Checked   what held a row to mechanics: `ledger`, its own energy and momentum;
              `beside`, a run side by side with others; `both`, such a run and
              another one alone
    ");
    let text = String::from_utf8(table(&folder, "sweep.json.csv")).expect("text");
    let header = text.lines().next().unwrap_or_default();
    assert_snapshot!(header, @"run,record,reversed,contacts[0].gap_m,structures[0].sdof.period_s,left: peak_displacement_m,right: peak_displacement_m,left - right: collisions,left - right: peak_force_n,left - right: total_impulse_n_s,checked,failed");
    assert_eq!(text.lines().count(), 5);
    assert!(!folder.join("sweep.json.csv.parts").exists(), "parts go when they are joined");
    let again = pounding(&folder, &["sweep", "sweep.json"]);
    assert_snapshot!(refusal(&again), @"error: sweep.json.csv: is there already, allowed is a new file; name another one or add --overwrite");
}

/// The method is printed before the work begins, and the measured error at the end.
#[test]
fn reference_a_sweep_with_an_accuracy() {
    let mut words = sweep(4);
    words["scene"]["method"] = json!({"accuracy": 0.01});
    let folder = with_sweep("sweep_accuracy", &words);
    let ended = pounding(&folder, &["sweep", "sweep.json"]);
    assert_snapshot!(format!("{}\n{}", ended.stderr, ended.stdout), @r"
    1.0 % asked: exact

    Sweep     4 runs
    Accuracy  1.0 % asked: exact: by the estimate of their costs nothing that keeps
              95 % of a sample of the runs within it is cheaper. It has no errors
              but those of rounding; none were measured. All columns:
              sweep.json.accuracy.csv
    Results   sweep.json.csv: 4 rows, none failed
    Checked   what held a row to mechanics: `ledger`, its own energy and momentum;
              `beside`, a run side by side with others; `both`, such a run and
              another one alone
    ");
}

/// The table has equal bytes with one thread or two, whole or in shards, from the command line or from a job array.
#[test]
fn limit_the_same_bytes_whatever_the_threads_and_shards() {
    let folder = with_sweep("sweep_shards", &sweep(2500));
    for threads in ["1", "2"] {
        let out = format!("{threads}.csv");
        let arguments = ["sweep", "sweep.json", "--out", &out];
        let ended = start(&folder, &arguments, &[("RAYON_NUM_THREADS", threads)]).wait();
        assert!(ended.expect("it ends").success());
    }
    let whole = table(&folder, "1.csv");
    let text = String::from_utf8(whole.clone()).expect("text");
    assert_eq!(text.lines().count(), 2501);
    assert!(whole == table(&folder, "2.csv"), "threads change bytes");

    let shards = ["sweep", "sweep.json", "--out", "shards.csv", "--shard"];
    for shard in ["3/3", "1/3"] {
        printed(&pounding(&folder, &[&shards[..], &[shard]].concat()));
    }
    assert_snapshot!(refusal(&pounding(&folder, &["merge", "shards.csv"])));
    let ended = pounding(&folder, &[&shards[..], &["2/3"]].concat());
    assert_snapshot!(printed(&ended));
    let merged = pounding(&folder, &["merge", "shards.csv"]);
    assert_snapshot!(printed(&merged), @r"
    Results   shards.csv: 2500 rows, none failed
    Checked   what held a row to mechanics: `ledger`, its own energy and momentum;
              `beside`, a run side by side with others; `both`, such a run and
              another one alone
    ");
    assert!(whole == table(&folder, "shards.csv"), "shards change bytes");

    for task in ["5", "6", "7"] {
        let out = format!("node{task}.csv");
        let variables = [
            ("SLURM_ARRAY_TASK_ID", task),
            ("SLURM_ARRAY_TASK_COUNT", "3"),
            ("SLURM_ARRAY_TASK_MIN", "5"),
            ("SLURM_ARRAY_TASK_STEP", "1"),
        ];
        let ended = start(&folder, &["sweep", "sweep.json", "--out", &out], &variables).wait();
        assert!(ended.expect("it ends").success());
    }
    let merged = ["merge", "nodes.csv", "node5.csv.parts", "node6.csv.parts", "node7.csv.parts"];
    printed(&pounding(&folder, &merged));
    assert!(whole == table(&folder, "nodes.csv"), "a job array changes bytes");
}

/// A forgotten environment variable silently gave half a table.
#[test]
fn issue_a_task_of_a_job_array_says_that_it_runs_a_shard() {
    let folder = with_sweep("sweep_task", &sweep(4));
    let output = Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
        .args(["sweep", "sweep.json"])
        .current_dir(&folder)
        .envs([
            ("SLURM_ARRAY_TASK_ID", "2"),
            ("SLURM_ARRAY_TASK_COUNT", "4"),
            ("SLURM_ARRAY_TASK_MIN", "1"),
        ])
        .output();
    let output = output.expect("the program starts");
    assert!(output.status.success());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_snapshot!(said, @"SLURM_ARRAY_TASK_ID is set: runs shard 2/4 alone; --shard 1/1 runs the whole");
}

/// Number of parts of a table.
fn parts_of(folder: &Path, table: &str) -> usize {
    let there = fs::read_dir(folder.join(format!("{table}.parts")));
    there.map_or(0, |all| {
        let names = all.flatten().map(|entry| entry.file_name());
        let parts = names.filter(|name| name.to_string_lossy().starts_with("part-"));
        parts.count()
    })
}

/// A sweep that is killed ten times at different moments ends with the bytes of an uninterrupted one.
#[test]
fn limit_a_sweep_that_is_killed_goes_on() {
    let folder = with_sweep("sweep_killed", &sweep(20_000));
    printed(&pounding(&folder, &["sweep", "sweep.json", "--out", "whole.csv"]));
    let arguments = ["sweep", "sweep.json", "--out", "killed.csv"];
    let mut parts = 0;
    for kill in 1..=10_u64 {
        let mut child = start(&folder, &arguments, &[]);
        // Every second kill waits for one more part than before, so the sweep progresses on slow machines too.
        let ended = |child: &mut Child| child.try_wait().expect("a child").is_some();
        while kill % 2 == 0 && parts_of(&folder, "killed.csv") <= parts && !ended(&mut child) {
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_millis(13 * kill % 20));
        child.kill().expect("it can be killed");
        child.wait().expect("it ends");
        if folder.join("killed.csv").exists() {
            break;
        }
        let there = parts_of(&folder, "killed.csv");
        assert!(there >= parts, "{there} parts after {parts}");
        parts = there;
    }
    assert!(parts > 0, "something was done before the last kill");
    if !folder.join("killed.csv").exists() {
        let ended = pounding(&folder, &arguments);
        assert!(printed(&ended).contains("were there already"), "{}", ended.stdout);
    } else if folder.join("killed.csv.parts").exists() {
        // The process was killed while it removed its parts. The repeated command removes them, except an empty folder, which does not
        // identify a table.
        let parts = folder.join("killed.csv.parts");
        let is_empty = fs::read_dir(&parts).expect("a folder").count() == 0;
        let ended = pounding(&folder, &arguments);
        assert!(ended.code == 0 || is_empty, "{}", ended.stderr);
        if is_empty {
            fs::remove_dir(&parts).expect("it is empty");
        }
    }
    assert!(table(&folder, "whole.csv") == table(&folder, "killed.csv"), "a kill changes bytes");
    assert!(!folder.join("killed.csv.parts").exists());
}

/// A changed sweep does not continue with parts of the old one.
#[test]
fn extreme_parts_of_another_sweep() {
    let folder = with_sweep("sweep_changed", &sweep(8));
    let arguments = ["sweep", "sweep.json", "--out", "runs.csv"];
    printed(&pounding(&folder, &[&arguments[..], &["--shard", "1/2"]].concat()));
    let mut other = sweep(8);
    other["samples"]["seed"] = json!(4);
    fs::write(folder.join("sweep.json"), other.to_string()).expect("a file");
    assert_snapshot!(refusal(&pounding(&folder, &arguments)));
    printed(&pounding(&folder, &[&arguments[..], &["--overwrite"]].concat()));
    printed(&pounding(&folder, &["sweep", "sweep.json", "--out", "anew.csv"]));
    assert!(table(&folder, "runs.csv") == table(&folder, "anew.csv"));
}

/// The records of a folder, in both directions, have the names and numbers of `pounding run --records`.
#[test]
fn limit_records_are_those_of_run() {
    let folder = suite("sweep_records");
    fs::remove_file(folder.join("records").join("spectra.V3")).expect("a file");
    let words = "scene = \"towers.toml\"\nrecords = \"records\"\ndirections = \"both\"\noutputs.structures = [\"peak_displacement_m\", \
                 \"peak_acceleration_m_per_s2\", \"transferred_momentum_n_s\"]\noutputs.pairs = [\"collisions\", \"largest_impulse_n_s\", \"least_opening_m\"]\n";
    fs::write(folder.join("sweep.toml"), words).expect("a file");
    printed(&pounding(&folder, &["sweep", "sweep.toml"]));
    let run = ["run", "towers.toml", "--records", "records", "--both", "--csv"];
    let long = pounding(&folder, &run);
    let mut wanted = csv::Reader::from_reader(long.stdout.as_bytes());
    let wanted: Vec<csv::StringRecord> = wanted.records().map(|row| row.expect("a row")).collect();
    let wide = table(&folder, "sweep.toml.csv");
    let mut wide = csv::Reader::from_reader(&wide[..]);
    let columns: Vec<String> = wide.headers().expect("a header").iter().map(String::from).collect();
    let rows: Vec<csv::StringRecord> = wide.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), 4);
    let mut compared = 0;
    for row in &rows {
        for (column, found) in columns.iter().zip(row) {
            let Some((of, quantity)) = column.split_once(": ") else {
                continue;
            };
            // Buildings of one storey are named without their storey.
            let (building, neighbour) = of.split_once(" - ").unwrap_or((of, ""));
            let same = wanted.iter().find(|wanted| {
                [&wanted[0], &wanted[2], &wanted[3], &wanted[5], &wanted[7]] == [&row[1], &row[2], building, neighbour, quantity]
            });
            let same = same.unwrap_or_else(|| panic!("{column} of {}", &row[1]));
            assert_eq!(found.parse::<f64>().ok(), same[8].parse::<f64>().ok(), "{column}");
            compared += 1;
        }
    }
    assert_eq!(compared, 4 * (2 * 3 + 3));
}

/// The sweep that the project ships runs, and all its runs succeed.
#[test]
fn reference_the_sweep_to_copy() {
    let folder = folder("sweep_ships");
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let sweep = studies.join("sweeps/gap-and-period.json");
    let sweep = sweep.to_str().expect("UTF-8");
    let ended = pounding(&folder, &["sweep", sweep, "--out", "gaps.csv"]);
    assert_snapshot!(printed(&ended), @r"
    Sweep     448 runs
    Results   gaps.csv: 448 rows, none failed
    Checked   what held a row to mechanics: `ledger`, its own energy and momentum;
              `beside`, a run side by side with others; `both`, such a run and
              another one alone
    ");
}

/// The job scripts run with the variables of a cluster set by hand.
#[cfg(unix)]
#[test]
fn limit_job_scripts_make_the_bytes_of_one_machine() {
    let folder = with_sweep("sweep_jobs", &sweep(100));
    printed(&pounding(&folder, &["sweep", "sweep.json", "--out", "whole.csv"]));
    let program = assert_cmd::cargo::cargo_bin!("pounding");
    let job = |script: &str, out: &str, variables: &[(&str, &str)]| {
        let jobs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies/jobs");
        let mut command = Command::new("bash");
        command.arg(jobs.join(script)).args(["sweep.json", out]);
        command.current_dir(&folder).env("POUNDING", program);
        let output = command.envs(variables.iter().copied()).output().expect("bash");
        let said = String::from_utf8_lossy(&output.stdout);
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(said.contains(&format!("pounding merge {out}")), "{said}{errors}");
    };
    for task in ["1", "2", "3"] {
        let slurm = [
            ("SLURM_ARRAY_TASK_ID", task),
            ("SLURM_ARRAY_TASK_COUNT", "3"),
            ("SLURM_ARRAY_TASK_MIN", "1"),
        ];
        job("slurm.sh", "slurm.csv", &slurm);
        let hyperqueue = [("HQ_TASK_ID", task), ("SHARDS", "3"), ("HQ_CPUS", "0,1")];
        job("hyperqueue.sh", "hyperqueue.csv", &hyperqueue);
    }
    // Two tasks of an array are submitted again: existing shards stay.
    job(
        "slurm.sh",
        "slurm.csv",
        &[("SLURM_ARRAY_TASK_ID", "2"), ("SLURM_ARRAY_TASK_COUNT", "1"), ("SHARDS", "3")],
    );
    for out in ["slurm.csv", "hyperqueue.csv"] {
        printed(&pounding(&folder, &["merge", out]));
        assert!(table(&folder, "whole.csv") == table(&folder, out), "{out}");
    }
}

/// Ctrl-C leaves whole parts, and the message says how to continue.
#[cfg(unix)]
#[test]
fn reference_a_sweep_that_is_stopped_says_how_to_go_on() {
    let folder = with_sweep("sweep_stopped", &sweep(2_000_000));
    let child = Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
        .args(["sweep", "sweep.json"])
        .current_dir(&folder)
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let parts = folder.join("sweep.json.csv.parts");
    let begun = || fs::read_dir(&parts).is_ok_and(|all| all.count() > 2);
    while !begun() {
        std::thread::sleep(Duration::from_millis(10));
    }
    let id = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &id]).status();
    assert!(sent.expect("kill is there").success());
    let output = child.wait_with_output().expect("it ends");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    let wanted = "of 2000000 runs are in sweep.json.csv.parts; the same command runs the others\n";
    assert!(said.starts_with("error: stopped: ") && said.ends_with(wanted), "{said}");
    fs::remove_dir_all(&parts).expect("nobody works there any more");
}
