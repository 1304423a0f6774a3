//! Tests of the promises of exit code 0, and that other exit codes lose no data. `docs/exit-code-0.md` lists these tests.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::{Value, json};

use crate::suites::{TOWERS, suite};
use crate::sweeps::{sweep, with_sweep};
use crate::{Ended, folder, pounding};

/// Files of a folder and of its subfolders, with their bytes.
pub(crate) fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(contents(&path));
        } else {
            found.push((path.display().to_string(), fs::read(&path).expect("a file")));
        }
    }
    found.sort();
    found
}

/// The towers with a contact law that other programs know.
pub(crate) fn springs() -> String {
    TOWERS.replace(
        "law.stereomechanical.restitution = 0.6",
        "law.linear_spring.impact_stiffness_n_per_m = 1e8",
    )
}

/// Commands overwrote files that they read: `run` its scene, `sweep` its sweep, scene and record, `export` its scene, `convert` a hard
/// link.
#[test]
fn issue_no_command_writes_over_what_it_reads() {
    let folder = suite("promises_inputs");
    fs::write(folder.join("towers.toml"), springs()).expect("a disk");
    let ran = pounding(&folder, &["run", "towers.toml", "--out", "own"]);
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    let mut summary: Value = serde_json::from_slice(&fs::read(folder.join("own/summary.json")).expect("a file")).expect("JSON");
    let mut scene = summary["scene"].take();
    scene["record"]["file"] = json!("../records/column.txt");
    fs::write(folder.join("own/summary.json"), scene.to_string()).expect("a disk");
    let gaps = json!({"scene": "towers.toml", "vary": [{"field": "contacts[0].gap_m", "values": [0.01, 0.02]}]});
    fs::write(folder.join("gaps.json"), gaps.to_string()).expect("a disk");
    let mut accurate = gaps;
    accurate["scene"] = json!("accurate.toml");
    fs::write(folder.join("accurate.toml"), format!("method.accuracy = 0.05\n{TOWERS}")).expect("a disk");
    fs::write(folder.join("accurate.json"), accurate.to_string()).expect("a disk");
    fs::hard_link(folder.join("accurate.toml"), folder.join("runs.accuracy.csv")).expect("a disk");
    fs::hard_link(folder.join("records/pulse.csv"), folder.join("other.csv")).expect("a disk");
    fs::hard_link(folder.join("records/pulse.csv"), folder.join("records/runs.csv")).expect("a disk");
    let before = contents(&folder);
    for command in [
        "run own/summary.json --out own",
        "run own/summary.json --out own --overwrite",
        "run towers.toml --records records --out records --overwrite",
        "assess towers.toml --records records --target records/pulse.csv --out records --overwrite",
        "ida towers.toml --records records --out records --overwrite",
        "sweep gaps.json --out gaps.json --overwrite",
        "sweep gaps.json --out towers.toml --overwrite",
        "sweep gaps.json --out records/column.txt --overwrite",
        "sweep accurate.json --out runs.csv --overwrite",
        "export --opensees towers.toml --out towers.toml --overwrite",
        "export --opensees towers.toml --out records/column.txt --overwrite",
        "motion convert records/pulse.csv other.csv --overwrite",
        "motion convert towers.toml records/column.txt --overwrite",
        "init records/pulse.csv --record records/pulse.csv --overwrite",
    ] {
        let ended = pounding(&folder, &command.split(' ').collect::<Vec<_>>());
        assert_eq!(ended.code, 1, "{command}: {}", ended.stdout);
        assert!(ended.stderr.contains("is the file that is read"), "{command}: {}", ended.stderr);
        assert!(contents(&folder) == before, "{command} changed something");
    }
}

/// Two sweeps with one output name mixed their rows, and two equal sweeps both failed.
#[test]
fn issue_two_sweeps_on_one_table_do_not_mix() {
    for (round, same) in [(0, false), (1, true)] {
        let folder = with_sweep(&format!("promises_race_{round}"), &sweep(1500));
        let mut other = sweep(1500);
        if !same {
            other["samples"]["seed"] = json!(4);
        }
        fs::write(folder.join("other.json"), other.to_string()).expect("a disk");
        let names = ["sweep.json", "other.json"];
        let wanted = names.map(|name| {
            let out = format!("alone-{name}.csv");
            assert_eq!(pounding(&folder, &["sweep", name, "--out", &out]).code, 0);
            fs::read(folder.join(out)).expect("a table")
        });
        let both = names.map(|name| {
            Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
                .args(["sweep", name, "--out", "both.csv"])
                .current_dir(&folder)
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .expect("it starts")
        });
        let ended = both.map(|child| child.wait_with_output().expect("it ends"));
        let said = ended.each_ref().map(|one| String::from_utf8_lossy(&one.stderr).into_owned());
        let winners: Vec<usize> = (0..2).filter(|index| ended[*index].status.success()).collect();
        assert_eq!(winners.len(), 1, "{said:?}");
        let table = fs::read(folder.join("both.csv")).expect("a table");
        assert!(table == wanted[winners[0]], "round {round}: rows are mixed");
        let loser = &said[1 - winners[0]];
        assert!(loser.contains("at work on it") || loser.contains("is there already"), "{loser}");
        // The second sweep left new parts next to the finished table.
        for left in [".both.csv.lock", ".both.csv.joined.json", "both.csv.parts"] {
            let left = folder.join(left);
            assert!(!left.exists(), "round {round}: {} is left, {loser}", left.display());
        }
    }
}

/// After a kill between the table and the clean-up, the repeated command ended with 1.
#[test]
fn issue_a_rerun_after_a_kill_in_the_clean_up_is_done() {
    let folder = with_sweep("promises_clean_up", &sweep(8));
    let arguments = ["sweep", "sweep.json", "--out", "runs.csv"];
    let shard = [&arguments[..], &["--shard", "1/2"]].concat();
    assert_eq!(pounding(&folder, &shard).code, 0);
    // A sweep that is killed with its table in place leaves what shards and `merge` leave.
    let shard = [&arguments[..], &["--shard", "2/2"]].concat();
    assert_eq!(pounding(&folder, &shard).code, 0);
    assert_eq!(pounding(&folder, &["merge", "runs.csv"]).code, 0);
    let table = fs::read(folder.join("runs.csv")).expect("a table");
    let again = pounding(&folder, &arguments);
    assert_eq!((again.code, again.stderr.as_str()), (0, ""), "{}", again.stdout);
    assert!(again.stdout.contains("was finished already"), "{}", again.stdout);
    assert!(!folder.join("runs.csv.parts").exists());
    assert_eq!(fs::read(folder.join("runs.csv")).expect("a table"), table);
}

/// After a kill between the last part and the folder, the repeated command ended with 1: nothing identified the table as this sweep's.
#[test]
fn issue_a_rerun_after_a_kill_at_any_step_of_the_clean_up_is_done() {
    let folder = with_sweep("promises_clean_up_steps", &sweep(8));
    let arguments = ["sweep", "sweep.json", "--out", "runs.csv"];
    let (parts, table) = (folder.join("runs.csv.parts"), folder.join("runs.csv"));
    let beside = folder.join(".runs.csv.joined.json");
    let shards = ["1/2", "2/2"].map(|shard| [&arguments[..], &["--shard", shard]].concat());
    // Number of deletions before the kill: parts, manifest, folder.
    for deleted in 0.. {
        for shard in &shards {
            assert_eq!(pounding(&folder, shard).code, 0);
        }
        assert_eq!(pounding(&folder, &["merge", "runs.csv"]).code, 0);
        fs::copy(parts.join("manifest.json"), &beside).expect("a disk");
        let mut files: Vec<_> = contents(&parts).into_iter().map(|(path, _)| path).collect();
        files.sort_by_key(|path| path.ends_with("manifest.json"));
        for file in files.iter().take(deleted) {
            fs::remove_file(file).expect("a disk");
        }
        let is_last = deleted > files.len();
        if is_last {
            fs::remove_dir(&parts).expect("it is empty");
        }
        let before = fs::read(&table).expect("a table");
        let again = pounding(&folder, &arguments);
        assert_eq!(again.code, 0, "{deleted}: {}", again.stderr);
        assert!(!parts.exists() && !beside.exists(), "{deleted}");
        assert_eq!(fs::read(&table).expect("a table"), before);
        // Without the other files the table counts as any other file.
        assert_eq!(pounding(&folder, &arguments).code, 1);
        assert!(!parts.exists(), "{deleted}: something was begun beside it");
        fs::remove_file(&table).expect("a disk");
        if is_last {
            assert!(deleted > 2, "parts, manifest and folder");
            return;
        }
    }
}

/// A sweep without a result ended with 0.
#[test]
fn issue_a_sweep_without_a_result_is_a_failure() {
    let mut words = sweep(4);
    words["scene"]["contacts"][0]["law"] = json!({"kelvin_voigt": {"impact_stiffness_n_per_m": 9e7, "impact_damping_ratio": 1e12}});
    words["scene"]["method"] = json!({"exact": {}});
    words["scene"]["budget"] = json!({"pieces": 5000});
    let folder = with_sweep("promises_failed", &words);
    let ended = pounding(&folder, &["sweep", "sweep.json", "--out", "runs.csv"]);
    assert_eq!(ended.code, 1, "{}", ended.stdout);
    assert_eq!(ended.stderr, "error: all 4 runs failed: the last column says why\n");
    assert!(ended.stdout.contains("4 rows, 4 failed"), "{}", ended.stdout);
    assert!(folder.join("runs.csv").exists());
}

/// A command that cannot write its output to the end leaves the old files.
#[cfg(unix)]
#[test]
fn issue_a_disk_that_is_full_takes_nothing_away() {
    let folder = suite("promises_full");
    fs::write(folder.join("towers.toml"), springs()).expect("a disk");
    for (name, old) in [("c.csv", "old"), ("check.py", "old")] {
        fs::write(folder.join(name), old).expect("a disk");
    }
    assert_eq!(pounding(&folder, &["run", "towers.toml", "--out", "out"]).code, 0);
    let before = contents(&folder);
    let program = assert_cmd::cargo::cargo_bin!("pounding").display();
    for command in [
        "motion convert records/pulse.csv c.csv --overwrite",
        "export --opensees towers.toml --out check.py --overwrite",
        "run towers.toml --out out",
        "motion spectrum records/pulse.csv --figure new.png",
    ] {
        // No file may be longer than one block. The signal about it ended the program silently.
        let script = format!("ulimit -f 1; exec {program} {command}");
        let ended = Command::new("sh").args(["-c", &script]).current_dir(&folder).output();
        let ended = ended.expect("a shell");
        let said = String::from_utf8_lossy(&ended.stderr);
        assert_eq!(ended.status.code(), Some(1), "{command}: {said}");
        assert!(said.contains("cannot be written"), "{command}: {said}");
        assert!(contents(&folder) == before, "{command} changed something");
    }
}

/// A full standard error caused a panic with exit code 101.
#[cfg(target_os = "linux")]
#[test]
fn issue_a_full_standard_error_is_no_panic() {
    let folder = folder("promises_stderr");
    let full = fs::File::options().write(true).open("/dev/full").expect("Linux has it");
    let status = Command::new(assert_cmd::cargo::cargo_bin!("pounding"))
        .args(["run", "nowhere.toml"])
        .current_dir(&folder)
        .stdout(Stdio::null())
        .stderr(full)
        .status();
    assert_eq!(status.expect("it ends").code(), Some(1));
}

/// The program waited for a pipe, and read a device until the memory was full.
#[cfg(unix)]
#[test]
fn issue_what_is_no_regular_file_is_not_read() {
    let folder = suite("promises_special");
    let made = Command::new("mkfifo").arg(folder.join("pipe")).status();
    assert!(made.expect("mkfifo is there").success());
    let of_record = |path: &str| TOWERS.replace("records/column.txt", path);
    for (name, path) in [("of-pipe.toml", "pipe"), ("of-zero.toml", "/dev/zero")] {
        fs::write(folder.join(name), of_record(path)).expect("a disk");
    }
    for command in [
        "run pipe",
        "run /dev/zero",
        "run of-pipe.toml",
        "run of-zero.toml",
        "sweep pipe",
        "sweep /dev/zero --out runs.csv",
        "motion info pipe",
        "motion info /dev/zero",
        "motion convert pipe c.csv",
        "motion spectrum /dev/zero",
        "init new.toml --record /dev/zero",
        "assess towers.toml --records records --target pipe",
        "advise pipe --accuracy 1%",
    ] {
        let ended = pounding(&folder, &command.split(' ').collect::<Vec<_>>());
        assert_eq!(ended.code, 1, "{command}: {}", ended.stdout);
    }
}

/// Messages repeated the first line of any file, even of one that is no record.
#[test]
fn issue_what_is_no_record_is_not_repeated() {
    let folder = suite("promises_secret");
    let secret = "root:x:0:0:root:/root";
    fs::write(folder.join("passwd"), secret).expect("a disk");
    fs::write(folder.join("scene.toml"), TOWERS.replace("records/column.txt", "passwd")).expect("a disk");
    for command in ["motion info passwd", "run scene.toml", "run passwd", "init a.toml --record passwd"] {
        let Ended { code, stdout, stderr } = pounding(&folder, &command.split(' ').collect::<Vec<_>>());
        assert_eq!(code, 1, "{command}");
        assert!(!stdout.contains("root") && !stderr.contains("root"), "{command}: {stderr}");
    }
}

/// SIGTERM at the end of a job lost the finished runs.
#[cfg(unix)]
#[test]
fn issue_a_terminated_run_keeps_what_is_finished() {
    let folder = suite("promises_term");
    // The run under one record ends at once; the others meet an overdamped contact and would never end.
    fs::write(folder.join("records/aa.txt"), "1\n-1\n".repeat(50)).expect("a disk");
    let law = "law.kelvin_voigt = { impact_stiffness_n_per_m = 9e7, impact_damping_ratio = 1e9 }";
    let endless = TOWERS
        .replace("law.stereomechanical.restitution = 0.6", law)
        .replace("gap_m = 0.01", "gap_m = 0.001")
        .replace("duration_s = 3.0\n", "budget = { pieces = 1e30 }\n");
    fs::write(folder.join("scene.toml"), endless).expect("a disk");
    for signal in ["-TERM", "-HUP"] {
        let arguments = ["run", "scene.toml", "--records", "records", "--out", "out", "--no-error"];
        let ended = crate::budgets::interrupted(&folder, signal, &arguments, || true);
        let said = String::from_utf8_lossy(&ended.stderr);
        assert_eq!(ended.status.code(), Some(1), "{said}");
        assert!(said.contains("stopped: of "), "{said}");
        let table = fs::read_to_string(folder.join("out/runs.csv")).expect("what is finished is written");
        assert!(table.contains("aa.txt"), "{table}");
        fs::remove_dir_all(folder.join("out")).expect("a disk");
    }
}

/// Only answers were JSON; refusals were not.
#[test]
fn issue_refusals_are_json_where_it_is_asked_for() {
    let folder = suite("promises_json");
    fs::write(folder.join("scene.toml"), TOWERS.replace("gap_m = 0.01", "gap_m = -0.01")).expect("a disk");
    let ended = pounding(&folder, &["run", "scene.toml", "--json"]);
    assert_eq!((ended.code, ended.stdout.as_str()), (1, ""));
    let said: Value = serde_json::from_str(&ended.stderr).expect("JSON");
    let error = said["error"].as_object().expect("a table");
    assert!(
        error["place"].as_str().is_some_and(|place| place.starts_with("scene.toml, line")),
        "{said}"
    );
    assert_eq!(error["found"], "-0.01", "{said}");
    assert!(error["allowed"].as_str().is_some_and(|allowed| allowed.contains('0')), "{said}");
    assert!(error["message"].as_str().is_some_and(|message| message.contains("gap_m")), "{said}");
}

/// Some commands made one text of a refusal, and its JSON had no parts.
#[test]
fn issue_refusals_keep_their_parts() {
    let folder = suite("promises_parts");
    fs::create_dir_all(folder.join("empty")).expect("a disk");
    for arguments in [&["motion", "info", "empty"][..], &["assess", "one.toml", "--records", "records"]] {
        fs::write(
            folder.join("one.toml"),
            "name = \"one\"\nrecord.file = \"x\"\nstructures = [{ wall = {} }]\n",
        )
        .expect("a disk");
        let ended = pounding(&folder, &[arguments, &["--json"]].concat());
        let said: Value = serde_json::from_str(&ended.stderr).expect("JSON");
        for part in ["place", "found", "allowed"] {
            assert!(said["error"][part].is_string(), "{arguments:?}: {part}: {said}");
        }
    }
}
