//! Tests of texts that steer no terminal, of messages that end, and of files left by interrupted commands.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::pounding;
use crate::promises::{contents, springs};
use crate::suites::{TOWERS, suite};

/// The output of commands in a folder in which each succeeds.
fn all_succeed(folder: &Path, commands: &[&str]) -> Vec<String> {
    let one = |command: &&str| {
        let ended = pounding(folder, &command.split(' ').collect::<Vec<_>>());
        assert_eq!(ended.code, 0, "{command}: {}", ended.stderr);
        ended.stdout
    };
    commands.iter().map(one).collect()
}

/// Control characters reached the terminal.
#[test]
fn issue_control_characters_are_spelt() {
    let folder = suite("promises_control");
    let named = TOWERS
        .replace("\"left\"", "\"\\u001B]0;owned\\u0007\"")
        .replace("\"right\"", "\"=1+1\"");
    fs::write(folder.join("scene.toml"), &named).expect("a disk");
    fs::write(
        folder.join("sweep.toml"),
        "scene = \"scene.toml\"\nvary = [{ field = \"contacts[0].gap_m\", values = [0.01] }]\n",
    )
    .expect("a disk");
    let steers = |letter: char| letter.is_control() && letter != '\n';
    let commands = [
        "run scene.toml",
        "run scene.toml --details",
        "run scene.toml --json",
        "check scene.toml",
    ];
    for said in all_succeed(&folder, &commands) {
        assert!(!said.contains(steers), "{said}");
        assert!(said.contains("\\u001b"), "{said}");
    }
    all_succeed(&folder, &["sweep sweep.toml"]);
    let table = fs::read_to_string(folder.join("sweep.toml.csv")).expect("a table");
    assert!(table.contains(",'=1+1: peak_displacement_m,"), "{table}");
}

/// Result files held control characters, and a terminal obeyed a name when a reader printed a file with `cat`.
#[test]
fn issue_no_file_of_text_steers_a_terminal() {
    let folder = suite("promises_written");
    let named = springs()
        .replace("name = \"towers\"", "name = \"\\u001B[31mred\\u0007\"")
        .replace("\"left\"", "\"\\u202Etfel\\u0000\"")
        .replace("\"right\"", "\"\\u200Fright\\u009B2J\"");
    assert_ne!(named, springs());
    fs::write(folder.join("scene.toml"), &named).expect("a disk");
    fs::write(
        folder.join("sweep.toml"),
        "scene = \"scene.toml\"\nsummary = {}\nvary = [{ field = \"contacts[0].gap_m\", values = [0.01, 0.02] }]\n",
    )
    .expect("a disk");
    let commands = [
        "run scene.toml --out one",
        "run scene.toml --records records --effects --out several",
        "assess scene.toml --records records --out assessed",
        "sweep sweep.toml --out runs.csv",
        "export --opensees scene.toml --out check.py",
        "motion convert scene.toml motion.csv",
    ];
    all_succeed(&folder, &commands);
    let (mut looked_at, mut spelt) = (0, 0);
    for (path, bytes) in contents(&folder) {
        let ending = path.rsplit('.').next().unwrap_or_default();
        if path.contains("records/") || ["toml", "png"].contains(&ending) {
            continue;
        }
        let text = String::from_utf8(bytes).expect("text");
        let steers = |letter: char| pounding::text::steers(letter);
        assert_eq!(text.find(steers), None, "{path}");
        looked_at += 1;
        spelt += usize::from(text.contains("\\u202etfel\\u0000"));
    }
    assert!(looked_at > 15 && spelt > 8, "{spelt} of {looked_at}");
}

/// A message was as long as the path that it named.
#[test]
fn issue_a_path_of_a_megabyte_is_not_repeated() {
    let folder = suite("promises_path");
    let path = "deep/".repeat(200_000);
    fs::write(folder.join("scene.toml"), TOWERS.replace("records/column.txt", &path)).expect("a disk");
    for command in ["run scene.toml", "run scene.toml --json"] {
        let ended = pounding(&folder, &command.split(' ').collect::<Vec<_>>());
        assert_eq!(ended.code, 1);
        assert!(ended.stderr.len() < 10_000, "{}", ended.stderr.len());
        assert!(ended.stderr.contains("letters are left out"), "{}", ended.stderr);
        if command.ends_with("--json") {
            serde_json::from_str::<Value>(&ended.stderr).expect("JSON");
        }
    }
}

/// Interrupted `convert` and `export` commands left temporary files for ever.
#[cfg(unix)]
#[test]
fn issue_what_a_stop_leaves_goes_with_the_next_file() {
    let folder = suite("written_leftovers");
    fs::write(folder.join("towers.toml"), springs()).expect("a disk");
    let left = ["c.csv", "c.provenance.json", "check.py", "new.toml", "new.png"];
    let left = left.map(|name| folder.join(format!(".{name}.aB3xyz.new")));
    for path in &left {
        fs::write(path, "half").expect("a disk");
    }
    let mine = folder.join(".c.csv.mine.new");
    fs::write(&mine, "mine").expect("a disk");
    let commands = [
        "motion convert records/pulse.csv c.csv",
        "export --opensees towers.toml --out check.py",
        "init new.toml",
        "motion spectrum records/pulse.csv --figure new.png",
    ];
    all_succeed(&folder, &commands);
    for path in &left {
        assert!(!path.exists(), "{}", path.display());
    }
    assert!(mine.exists(), "it is nobody's");
}
