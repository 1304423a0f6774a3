//! Tests of runs that end in a collapse, and of floors that leave their seats, in the words of the program.

use std::fs;

use serde_json::Value;

use crate::pounding;
use crate::unusual::{flat, workplace};

/// A storey that yields early and carries much, whose neighbour has a seat on it.
const LEANING: &str = r#"
name = "leaning"
record = { file = "records/good.csv", reversed = true }
structures = [
  { sdof = { name = "a", mass_kg = 2e5, period_s = 0.9, damping.ratio = 0.02, height_m = 3, yield_displacement_m = 0.01, gravity_load_n = 1e7 } },
  { sdof = { name = "b", mass_kg = 2e5, period_s = 0.5, damping.ratio = 0.02, height_m = 3 } },
]
contacts = [{ gap_m = 1, seat_width_m = 0.05, law.hertz.impact_stiffness_n_per_m1_5 = 2e9 }]
"#;

/// A run under gravity ended with an error where a storey fell, and nobody learnt what came before.
#[test]
fn issue_a_collapse_is_in_the_first_sentence() {
    let work = workplace("collapses", LEANING, false);
    let both = flat(&pounding(&work, &["run", "scene.toml"]));
    assert!(
        both.starts_with("Answer Shaken ") && both.contains(", a collapses under gravity: at t = "),
        "{both}"
    );
    assert!(
        both.contains("passes 20 % of its height, and the run ends; until then no floors touch"),
        "{both}"
    );
    let one = flat(&pounding(&work, &["run", "scene.toml", "--one-direction"]));
    assert!(one.starts_with("Collapse A collapses under gravity: at t = "), "{one}");
    for said in [
        "a passes its unstable equilibrium, a drift of ",
        "nothing brought it back",
        "contacts[0] (a – b): unseated at t = ",
        "Seats used is how far the right side moves away from the left one",
    ] {
        assert!(one.contains(said), "{said}: {one}");
    }
    let json = pounding(&work, &["run", "scene.toml", "--json"]);
    let summary: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let time = summary["collapse"]["time_s"].as_f64().expect("it falls");
    assert_eq!(
        (&summary["collapse"]["structure"], &summary["collapse"]["storey"]),
        (&Value::from("a"), &Value::from(1))
    );
    let own = &summary["structures"][0];
    assert_eq!(own["collapse_s"].as_f64(), Some(time));
    assert!(own["unstable_s"].as_f64().is_some_and(|unstable| unstable < time));
    let pair = &summary["pairs"][0];
    let opening = pair["largest_opening_m"].as_f64().expect("it opens");
    assert!(opening > 1.05 && pair["unseated_s"].as_f64().is_some(), "{pair}");
    // Histories end with the run.
    pounding(&work, &["run", "scene.toml", "--out", "out"]);
    let history = fs::read_to_string(work.join("out/history.csv")).expect("a table");
    let last = history.lines().last().and_then(|line| line.split(',').next()).expect("a row");
    let last: f64 = last.parse().expect("an instant");
    assert!(last <= time && time - last < 0.01, "{last} {time}");
    let page = fs::read_to_string(work.join("out/report.html")).expect("a page");
    assert!(page.contains("collapses under gravity: at t = "));
}

/// An assessment went on without a motion under which a storey fell, and called the gap enough.
#[test]
fn issue_a_gap_is_not_enough_where_a_storey_collapses() {
    let work = workplace("collapses_assessed", LEANING, false);
    let said = flat(&pounding(&work, &["assess", "scene.toml", "--records", "records"]));
    assert!(!said.contains("mm is enough"), "{said}");
    assert!(
        said.contains("a collapses under gravity at a drift of ") || said.contains("(a: collapses under gravity at a drift of "),
        "{said}"
    );
    assert!(said.contains("a – b: unseated in "), "{said}");
    let json = pounding(&work, &["assess", "scene.toml", "--records", "records", "--json"]);
    let answer: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let collapsed = answer["collapsed"].as_u64().expect("a number");
    let motions = answer["motions"].as_array().expect("a list");
    let of_motions = motions.iter().filter(|one| one["collapsed"] == Value::Bool(true)).count();
    assert!(collapsed >= 1 && of_motions >= 1, "{answer}");
    assert!(answer["pairs"][0]["unseated"].as_u64() >= Some(1), "{answer}");
}
