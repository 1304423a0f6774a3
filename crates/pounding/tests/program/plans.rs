//! Tests of messages before a run, and about forced runs.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use serde_json::json;

use crate::runs::printed;
use crate::{EXAMPLE, Ended, folder, good_scene, pounding, refusal};

/// Runs a command on the example under its own record at a time step.
fn at(test: &str, time_step: f64, arguments: &[&str]) -> Ended {
    let folder = folder(test);
    let mut scene = good_scene();
    scene["method"]["central_difference"]["time_step_s"] = json!(time_step);
    let record = "../../studies/records/el-centro-1940-ns-peer-pacific-engineering.csv";
    fs::copy(record, folder.join("record.csv")).expect("the record can be copied");
    fs::write(folder.join("scene.json"), scene.to_string()).expect("the scene can be written");
    pounding(&folder, arguments)
}

#[test]
fn reference_plan_of_the_example() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    assert_snapshot!(printed(&pounding(here, &["check", EXAMPLE])));
    let wall = "../../studies/examples/wall-and-neighbour.json";
    assert_snapshot!("plan_with_a_wall", printed(&pounding(here, &["check", wall])));
}

#[test]
fn extreme_plan_of_a_step_that_cannot_follow_the_contact() {
    let ended = at("plan-coarse", 0.02, &["check", "scene.json"]);
    let (_, warnings) = printed(&ended).split_once("Warnings").expect("warnings");
    assert_snapshot!(warnings);
    let ended = at("plan-unstable", 0.05, &["check", "scene.json"]);
    let (_, warnings) = printed(&ended).split_once("Warnings").expect("warnings");
    assert_snapshot!("plan_unstable_in_contact", warnings);
}

#[test]
fn extreme_a_step_beyond_the_limit_is_refused_and_forced() {
    let ended = at("beyond", 0.1, &["run", "scene.json"]);
    assert_snapshot!(refusal(&ended));
    // The forced run diverges, and a message says so.
    let ended = at("beyond", 0.1, &["run", "--force", "scene.json"]);
    assert!(refusal(&ended).contains("no longer a finite number"));
    // A run that breaks a law of mechanics is printed together with that law.
    let ended = at("broken", 0.05, &["run", "scene.json"]);
    assert!(refusal(&ended).contains("more given back than taken"));
    let ended = at("broken", 0.05, &["run", "--force", "scene.json"]);
    let (_, warnings) = printed(&ended).split_once("Warnings").expect("warnings");
    assert_snapshot!("warnings_of_a_forced_run", warnings);
}

#[test]
fn extreme_warnings_without_measured_errors() {
    let ended = at("no-error", 0.02, &["run", "--no-error", "scene.json"]);
    let (_, warnings) = printed(&ended).split_once("Warnings").expect("warnings");
    assert_snapshot!(warnings);
}
