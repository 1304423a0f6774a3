//! Tests of both directions of shaking in `run`, `check` and the report.

use std::fs;

use serde_json::Value;

use crate::assess::{TOWERS, workplace};
use crate::pounding;

/// "They touch at 1 of 7 gaps" was printed although the reversed shaking closes six.
#[test]
fn issue_a_run_tells_of_both_directions() {
    let work = workplace("assess_both", TOWERS);
    let run = pounding(&work, &["run", "scene.toml", "--no-error"]);
    let first: Vec<&str> = run.stdout.lines().take(11).flat_map(str::split_whitespace).collect();
    let first = first.join(" ");
    assert!(
        first.starts_with("Answer Shaken reversed, floors touch") && first.contains("Shaken as given, "),
        "{first}"
    );
    assert!(
        first.contains("This direction is worse for the buildings (") && first.contains("Worst here: "),
        "{first}"
    );
    let one = pounding(&work, &["run", "scene.toml", "--no-error", "--one-direction"]);
    assert!(!one.stdout.contains("reversed"), "{}", one.stdout);
}

/// "never" and "not needed" were printed from one direction; in the other direction all pairs touch.
#[test]
fn issue_check_looks_in_both_directions() {
    let work = workplace("check_both", TOWERS);
    let said = pounding(&work, &["check", "scene.toml"]).stdout;
    assert!(!said.contains("never") && !said.contains("not needed"), "{said}");
    let json = pounding(&work, &["check", "scene.toml", "--json"]).stdout;
    let plan: Value = serde_json::from_str(&json).expect("JSON");
    let pairs = plan["pairs"].as_array().expect("pairs");
    assert!(pairs.iter().all(|pair| pair["touches_reversed"].is_boolean()), "{json}");
}

/// The headline of a report described only the direction of the record.
#[test]
fn issue_the_report_of_a_run_shows_both_directions() {
    let work = workplace("run_both", TOWERS);
    let ended = pounding(&work, &["run", "scene.toml", "--no-error", "--out", "out"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    let page = fs::read_to_string(work.join("out/report.html")).expect("a page");
    let first = page.find("class=\"verdict").expect("a headline");
    let headline = &page[first..first + 600];
    assert!(
        headline.contains("<strong>Shaken reversed, ") && headline.contains("<li>Shaken as given, "),
        "{headline}"
    );
    assert!(work.join("out/profiles.png").is_file());
}
