//! Tests of messages about refused sweeps.

use insta::assert_snapshot;
use serde_json::{Value, json};

use crate::sweeps::{scene, sweep, with_sweep};
use crate::{pounding, refusal};

/// Sweeps with wrong field names: name of the case, changed place, new value.
fn wrong_fields() -> Vec<(&'static str, &'static str, Value)> {
    let field = "/vary/0/field";
    vec![
        ("a field that is misspelt", field, json!("contacts[0].gap")),
        ("a list that is shorter", field, json!("contacts[3].gap_m")),
        ("no place", field, json!("gap m of all")),
        ("stiffness beside a period", field, json!("structures[0].sdof.stiffness_n_per_m")),
        ("a field twice", field, json!("structures[0].sdof.period_s")),
        (
            "a value of a list out of range",
            "/vary/0",
            json!({"field": "contacts[0].gap_m", "values": [0.01, -0.01]}),
        ),
        (
            "a value of a grid out of range",
            "/vary/0",
            json!({"field": "structures[0].sdof.mass_kg", "grid": {"from": 1e5, "to": 0.0, "count": 3}}),
        ),
        (
            "a value of another form",
            "/vary/0",
            json!({"field": "contacts[0].law", "values": [{"spring": {}}]}),
        ),
        (
            "another row",
            "/vary/0",
            json!({"field": "structures[1]", "values": [
                scene()["structures"][1],
                {"building": {"name": "b", "period_s": 0.4, "damping": {"ratio": 0.05}, "storeys": [{"mass_kg": 1e5, "repeat": 2}]}},
            ]}),
        ),
        (
            "a direction that varies",
            "/vary/0",
            json!({"field": "record.reversed", "values": [true, false]}),
        ),
        ("bounds the wrong way", "/vary/0/uniform/to", json!(-1.0)),
    ]
}

/// Sweeps with other wrong words: name of the case, changed place, new value.
fn wrong_words() -> Vec<(&'static str, &'static str, Value)> {
    vec![
        ("no samples", "/samples", Value::Null),
        ("samples of nothing", "/vary", json!([])),
        ("no such method", "/samples/method", json!("sobl")),
        ("no sample", "/samples/count", json!(0)),
        (
            "too many runs",
            "/vary/0",
            json!({"field": "contacts[0].gap_m", "grid": {"from": 0.0, "to": 1.0, "count": 1_000_000_000_000_000_u64}}),
        ),
        ("an accuracy", "/scene/method", json!({"accuracy": 2.0})),
        ("no record", "/records", json!("nowhere")),
        ("no scene file", "/scene", json!("nowhere.json")),
        ("a scene that is none", "/scene/structures/0/sdof/mass", json!(1.0)),
        ("an output that there is not", "/outputs", json!({"pairs": ["colisions"]})),
        ("a summary by what is random", "/summary", json!({"by": ["contacts[0].gap_m"]})),
        ("a summary by the same twice", "/summary", json!({"by": ["record", "record"]})),
        ("a threshold of nothing", "/summary", json!({"exceedance": {"peak_forc_n": [1e6]}})),
        ("no threshold", "/summary", json!({"exceedance": {"peak_force_n": []}})),
        ("a quantile beyond all runs", "/summary", json!({"quantiles": [50.0]})),
        ("a word that a summary has not", "/summary", json!({"row": true})),
    ]
}

/// The message names the line of the fault before any run.
#[test]
fn extreme_sweeps_that_are_refused() {
    let mut said = String::new();
    for (what, place, value) in wrong_fields().into_iter().chain(wrong_words()) {
        let mut words = sweep(4);
        // A case has a building of several storeys without heights.
        words["scene"]["floors"] = json!("level");
        let (parent, key) = place.rsplit_once('/').expect("a place");
        let parent = words.pointer_mut(parent).expect("it is there");
        if let Value::Array(items) = parent {
            items[0] = value;
        } else {
            parent[key] = value;
        }
        let folder = with_sweep("sweep_refused", &words);
        let message = refusal(&pounding(&folder, &["sweep", "sweep.json"]));
        assert!(!folder.join("sweep.json.csv.parts").exists(), "{what}: nothing was begun");
        said = format!("{said}{what}\n  {message}\n");
    }
    assert_snapshot!(said);
}

/// A scene given to `sweep`, or a sweep given to `run`, is refused with the name of the other command.
#[test]
fn extreme_a_scene_for_a_sweep_and_a_sweep_for_a_scene() {
    let folder = with_sweep("sweep_confused", &scene());
    let ended = pounding(&folder, &["sweep", "sweep.json"]);
    assert_snapshot!(refusal(&ended), @"error: sweep.json, line 2, column 3: contacts: found `contacts`, which a scene has, allowed is a sweep, which names a scene in `scene` and what varies in `vary`; `pounding run` runs a scene alone");
    let folder = with_sweep("scene_confused", &sweep(4));
    let ended = pounding(&folder, &["run", "sweep.json"]);
    assert_snapshot!(refusal(&ended), @"error: sweep.json, line 2, column 3: samples: found `samples`, which a sweep has, allowed is a scene; `pounding sweep` runs a sweep");
}
