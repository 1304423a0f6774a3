//! Tests of names: refused ones, ones that identify scenes and structures, and messages in a scene's own words.

use std::fs;

use insta::assert_snapshot;

use crate::runs::printed;
use crate::suites::{TOWERS, suite};
use crate::{pounding, refusal};

/// Three columns had one name.
#[test]
fn issue_scenes_of_one_name_are_told_by_their_files() {
    let folder = suite("names_compare");
    let wide = TOWERS.replace("gap_m = 0.01", "gap_m = 0.1");
    fs::write(folder.join("wide.toml"), wide).expect("a file");
    let heading = |files: &[&str]| {
        let text = pounding(&folder, &[&["compare", "--no-error", "--all"], files].concat());
        let mut lines = printed(&text).lines().map(String::from);
        let lines = lines.by_ref().take_while(|line| !line.starts_with("Record"));
        let words = lines.collect::<Vec<_>>().join(" ");
        words.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert_eq!(heading(&["towers.toml", "wide.toml"]), "Scene towers.toml wide.toml");
    fs::create_dir_all(folder.join("b/records")).expect("a folder");
    fs::copy(folder.join("records/column.txt"), folder.join("b/records/column.txt")).expect("a file");
    fs::write(folder.join("b/towers.toml"), TOWERS).expect("a file");
    assert_eq!(heading(&["towers.toml", "b/towers.toml"]), "Scene towers.toml b/towers.toml");
    let json = pounding(&folder, &["compare", "towers.toml", "wide.toml", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json.stdout).expect("JSON");
    assert_eq!(json["files"][1], "wide.toml");
}

/// The middle of a long name was cut.
#[test]
fn issue_long_names_are_whole() {
    let folder = suite("names_long");
    let long = "the department store with the soft first storey at the corner of the market";
    let scene = TOWERS
        .replace("\"towers\"", &format!("\"{long}\""))
        .replace("\"left\"", &format!("\"{long}\""));
    fs::write(folder.join("long.toml"), scene).expect("a file");
    let text = pounding(&folder, &["run", "long.toml", "--details"]);
    assert!(printed(&text).lines().any(|line| line == long), "{}", text.stdout);
    let text = pounding(&folder, &["compare", "long.toml", "towers.toml", "--all"]);
    let letters = |text: &str| text.split_whitespace().collect::<String>();
    let column = printed(&text).lines().take_while(|line| !line.starts_with("Record"));
    // The first column of cells, without the names in front and without the scene behind.
    let cells: String = column.map(|line| line[10..].replace("towers", "")).collect();
    assert_eq!(letters(&cells).trim_start_matches("Scene"), letters(long));
}

/// Empty names were accepted, and tables then had nothing to identify a row.
#[test]
fn issue_empty_names_are_refused() {
    let folder = suite("names_empty");
    let refused = |from: &str| {
        fs::write(folder.join("scene.toml"), TOWERS.replace(from, "\" \"")).expect("a file");
        refusal(&pounding(&folder, &["run", "scene.toml"]))
    };
    assert_snapshot!(refused("\"towers\""), @r#"error: scene.toml, line 2, column 1: scene " ": name: found an empty name, allowed is a name, for tables and figures"#);
    assert_snapshot!(refused("\"right\""), @r#"error: scene.toml, line 8, column 14: scene "towers": structures[1].sdof.name: found an empty name, allowed is a name, by which results tell structures"#);
}

/// For a run of thirty years the message named the stiffness.
#[test]
fn issue_a_duration_too_long_is_named() {
    let folder = suite("names_duration");
    let refused = |scene: &str| {
        fs::write(folder.join("scene.toml"), scene).expect("a file");
        refusal(&pounding(&folder, &["run", "scene.toml"]))
    };
    let long = TOWERS.replace("duration_s = 3.0", "duration_s = 1e9");
    assert_snapshot!(refused(&long), @r#"error: scene.toml, line 4, column 1: scene "towers": duration_s: found 1000000000, allowed up to about 1.211e6 by the exact method, which would need 8.3e9 pieces of the motion of structures[0], "left", of 1e7 at most (`budget.pieces`): use a shorter duration_s, or leave it out for that of the record and two periods"#);
    let stepping = format!("method.rk4.time_step_s = 0.01\n{long}");
    assert_snapshot!(refused(&stepping), @r#"error: scene.toml, line 5, column 1: scene "towers": duration_s: found 1000000000, of which the run would take 2.0e11 time steps times floors, allowed 1e8 (`budget.steps`): shorten it, take a longer time_step_s, or make the budget more"#);
}

/// Advice on a scene in TOML was printed as JSON to paste.
#[test]
fn issue_advice_is_in_the_words_of_the_file() {
    let folder = suite("names_advice");
    let advice = pounding(&folder, &["advise", "towers.toml", "--accuracy", "5%"]);
    let lines = printed(&advice).lines().skip_while(|line| !line.starts_with("  [method"));
    let snippet: Vec<&str> = lines.take_while(|line| !line.is_empty()).collect();
    let pasted = format!("{TOWERS}\n{}\n", snippet.join("\n"));
    fs::write(folder.join("pasted.toml"), pasted).expect("a file");
    let ran = pounding(&folder, &["run", "pasted.toml", "--details"]);
    let name = snippet[0].trim().trim_start_matches("[method.").trim_end_matches(']');
    let method = format!("Method    {}", name.replace('_', " "));
    assert!(printed(&ran).contains(&method), "{method}\n{}", ran.stdout);
}
