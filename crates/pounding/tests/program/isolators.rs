//! Tests of buildings on isolators, of their damping, and of limits that a scene gives or assumes.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::unusual::{TWO, flat, workplace};
use crate::{folder, pounding};

const MOAT: &str = "studies/examples/isolated-building-and-moat.toml";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// "Stability coefficient 2.170 … gravity would bring the storey down", a drift of 36 %, a ductility of 20.9 and "repair hardly pays" were
/// said of isolators, and GB 50011 offered 100 mm for their moat.
#[test]
fn issue_the_example_of_a_moat_has_no_false_alarm() {
    let assessed: &[&str] = &["assess", MOAT, "--records", "studies/records"];
    for arguments in [
        assessed,
        &["gap", MOAT, "--records", "studies/records"],
        &["run", MOAT],
        &["check", MOAT],
    ] {
        let said = flat(&pounding(&root(), arguments));
        for gone in [
            "Unusual",
            "stability coefficient",
            "(isolated, storey 1",
            "ductility demand",
            "damper force",
            "mass term",
            "EC 8:",
            "TBDY ",
            "GB 50011 1",
        ] {
            assert!(!said.contains(gone), "{arguments:?}: {gone}: {said}");
        }
        let moat = "rules for joints between buildings do not size the moat of a building on isolators";
        let is_of_gaps = ["assess", "gap"].contains(&arguments[0]);
        assert_eq!(said.contains(moat), is_of_gaps, "{arguments:?}: {said}");
        assert!(!is_of_gaps || said.contains("ABS"), "{said}");
    }
}

/// With `damping.ratio = 0.05` the moat is touched once with 1 580 kN, with damping of the stiffness three times with up to 5 235 kN, and
/// nothing warned: the mass term is a dashpot to the sky.
#[test]
fn issue_damping_that_holds_isolators_is_warned_of() {
    let work = folder("isolators_damping");
    let scene = fs::read_to_string(root().join(MOAT)).expect("an example");
    let records = fs::canonicalize(root().join("studies/records")).expect("records");
    let here = format!("{}/", records.display());
    // The same loop as columns, which have the damping of the building.
    let from = scene.find("isolator_damping_n_s_per_m").expect("isolators in words");
    let (words, _) = scene[from..].split_once("} },").expect("a table");
    let columns = "stiffness_n_per_m = 9.8e7, yield_force_n = 8.4e5, hardening_ratio = 0.1, isolation_layer = true";
    let natural = scene
        .replace("../records/", &here)
        .replace("damping.ratio = 0.02", "damping.ratio = 0.05")
        .replace(&format!("{words}}}"), columns);
    let untold = natural.replace(", isolation_layer = true", "");
    for (name, text) in [("told.toml", &natural), ("untold.toml", &untold)] {
        assert_ne!(*text, scene);
        fs::write(work.join(name), text).expect("it can be written");
        for command in ["run", "check"] {
            let said = flat(&pounding(&work, &[command, name]));
            let warned = "the mass term of its damping is 9.6 % of critical at the period of the peak drifts, above 1 %";
            assert!(said.contains(warned), "{command} {name}: {said}");
            let asks =
                "usual is `isolator`, or `isolation_layer = true`, if it stands for isolators, `isolation_layer = false` if it does not";
            assert_eq!(said.contains(asks), name == "untold.toml", "{command} {name}: {said}");
        }
    }
    let said = flat(&pounding(&work, &["run", "told.toml", "--details"]));
    assert!(
        said.contains("isolated: in modes 1 and 2; its mass term is 9.6 % of critical at 2."),
        "{said}"
    );
    let said = flat(&pounding(&work, &["assess", "told.toml", "--records", &here]));
    assert!(said.contains("Caution: isolated: dashpots to the ground of "), "{said}");
}

/// The shear force of the demo was 1 of the yield force, without the 14.7 % of its damper, and no word said so.
#[test]
fn issue_the_force_of_dampers_is_said() {
    let work = folder("isolators_demo");
    let shown = pounding(&work, &["demo"]);
    assert!(flat(&shown).contains(" V/W "), "{}", shown.stdout);
    let said = flat(&pounding(&work.join("pounding-demo"), &["run", "scene.toml", "--details"]));
    for words in [
        "old building: damper force of 20 % of the yield force, above 10 % (Hall 2006; Charney 2008)",
        "the force of the dampers is not in it",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let summary = fs::read_to_string(work.join("pounding-demo/results/summary.json")).expect("a summary");
    let summary: Value = serde_json::from_str(&summary).expect("JSON");
    let ratio = summary["structures"][0]["damper_force_ratio"].as_f64().expect("a number");
    assert!((ratio - 0.147).abs() < 5e-4, "{ratio}");
}

/// An elastic frame with a base shear of more than half of its weight had "Warnings none", and 2.5 % of drift was allowed to masonry.
#[test]
fn issue_what_no_frame_bears_and_what_is_assumed_of_frames_is_said() {
    let high = TWO.replace("period_s = 0.5,", "period_s = 0.5, height_m = 3,");
    let work = workplace("isolators_frames", &high, false);
    let arguments: [&[&str]; 2] = [&["run", "scene.toml"], &["assess", "scene.toml", "--records", "records"]];
    for arguments in arguments {
        let said = flat(&pounding(&work, arguments));
        for words in [
            "times the weight above, more than 0.4: few structures are that strong",
            "the limit of ductile construction, which is assumed; masonry and non-ductile frames fail at 0.4 to 1 %",
        ] {
            assert!(said.contains(words), "{words}: {said}");
        }
    }
    let told = high.replace(
        "height_m = 3,",
        "height_m = 3, drift_capacity_ratio = 0.004, shear_capacity_n = 3e5,",
    );
    fs::write(work.join("scene.toml"), told).expect("it can be written");
    for arguments in arguments {
        let said = flat(&pounding(&work, arguments));
        for words in [", above its capacity of 0.40 %", ", above its capacity of 300.0 kN"] {
            assert!(said.contains(words), "{words}: {said}");
        }
        assert!(!said.contains("ductile construction"), "{said}");
    }
}

/// A scene with gravity could not be told from one without; the damping ratio of isolated buildings was said to hold in two modes.
#[test]
fn issue_check_tells_gravity_and_the_damping_above_isolators() {
    let gravity = TWO.replacen("name = ", "p_delta = \"from_masses\"\nname = ", 1);
    let gravity = gravity.replace("damping.ratio = 0.05", "damping.ratio = 0.05, height_m = 3");
    let work = workplace("check_tells_gravity", &gravity, false);
    let said = flat(&pounding(&work, &["check", "scene.toml"]));
    assert!(said.contains("gravity: P-Δ on 2 storeys, up to "), "{said}");
    let moat = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../studies/examples/isolated-building-and-moat.toml"
    );
    let said = flat(&pounding(&work, &["check", moat]));
    assert!(
        said.contains(" % of critical in the first mode of the building above its isolators"),
        "{said}"
    );
    assert!(!said.contains("gravity:"), "{said}");
}
