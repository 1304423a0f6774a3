//! Every number of a scene: NaN and infinities are refused, and the message names the field.

use std::path::Path;

use pounding_contact::{ContactLaw, LawName};
use pounding_motion::Accelerogram;
use pounding_scene::{Error, Scene, Simulation};
use serde_json::{Map, Value, json};

/// A record that is not read from a file.
fn pulse() -> Accelerogram {
    let text = b"time_s,acceleration_m_per_s2\n0,1\n0.1,-1\n";
    pounding_motion::read(text).expect("a record")
}

/// Reads, prepares and runs the text of a scene. All printed numbers must be finite.
fn answer(text: &str) -> Result<(), Error> {
    let scene: Scene = Scene::parse(text.as_bytes(), Path::new("scene.json"))?;
    let outcome = Simulation::with_record(&scene, pulse())?.run(None)?;
    for structure in 0..scene.structures.len() {
        let peaks = outcome.peaks.of(structure);
        let momentum = outcome.momentum.of(structure);
        let numbers = [peaks.displacement, peaks.restoring_force].map(|peak| peak.value);
        let finite = momentum.is_finite() && numbers.iter().all(|number| number.is_finite());
        assert!(finite, "{text}: {numbers:?}, {momentum}");
    }
    for collision in outcome.collisions.all() {
        let force = collision.peak_force.unwrap_or(0.0);
        let finite = collision.impulse.is_finite() && force.is_finite();
        assert!(finite, "{text}: {collision:?}");
    }
    Ok(())
}

/// A scene with both kinds of damping, and every field of structures and records.
fn scene(law: &Value, method: &Value) -> Value {
    let sdof = |damping: Value| {
        json!({"sdof": {
            "name": "any", "mass_kg": 1e5, "stiffness_n_per_m": 4e6, "damping": damping, "yield_force_n": 1e5,
            "initial_displacement_m": 0.0, "initial_velocity_m_per_s": 0.0,
        }})
    };
    let rayleigh = json!({"rayleigh": {"alpha_per_s": 0.1, "beta_s": 0.001}});
    json!({
        "name": "any", "record": {"file": "any", "gravity_m_per_s2": 9.81, "scale": 1.0, "reversed": false},
        "duration_s": 0.1, "structures": [sdof(json!({"ratio": 0.05})), sdof(rayleigh)],
        "contacts": [{"gap_m": 0.01, "law": law}], "method": method,
    })
}

/// Every law with all its parameters, and the laws that accept a restitution also with it.
fn laws() -> Vec<Value> {
    let by_parameters = |json: &Value| {
        let name = json.as_object().and_then(|law| law.keys().next());
        let name = name.expect("an example has a name");
        let law = LawName::from_name(name).expect("files name laws as commands do");
        let rows = law.parameters().into_iter();
        let parameters: Map<_, _> = rows.map(|row| (row.name.into(), json!(row.usual))).collect();
        json!({ name: parameters })
    };
    let examples = ContactLaw::examples().map(|json| serde_json::from_str(&json).expect("JSON"));
    let mut laws: Vec<Value> = examples.flat_map(|json| [by_parameters(&json), json]).collect();
    laws.dedup();
    laws
}

fn methods() -> Vec<Value> {
    vec![
        json!({"central_difference": {
            "time_step_s": 0.01, "contact_substeps": 2
        }}),
        json!({"newmark": {"time_step_s": 0.01, "beta": 0.25, "gamma": 0.5}}),
        json!({"hht": {"time_step_s": 0.01, "alpha": -0.1}}),
        json!({"velocity_verlet": {"time_step_s": 0.01}}),
        json!({"rk4": {"time_step_s": 0.01}}),
        json!({"moreau_jean": {"time_step_s": 0.01, "theta": 0.5}}),
        json!({"exact": {"tolerance": 1e-10}}),
        json!({"accuracy": 0.1}),
    ]
}

/// Paths of all numbers of a value, as JSON pointers.
fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(path.into()),
        Value::Array(values) => {
            for (index, value) in values.iter().enumerate() {
                numbers(value, &format!("{path}/{index}"), found);
            }
        }
        Value::Object(fields) => {
            for (name, value) in fields {
                numbers(value, &format!("{path}/{name}"), found);
            }
        }
        Value::Null | Value::Bool(_) | Value::String(_) => {}
    }
}

/// Words that a writer of JSON may use for NaN and infinity, and numbers that a reader may take for infinity.
#[test]
fn extreme_numbers_that_are_none_are_refused_with_their_place() {
    let rest = (laws().remove(0), methods().remove(0));
    let scenes = laws()
        .iter()
        .map(|law| scene(law, &rest.1))
        .chain(methods().iter().map(|method| scene(&rest.0, method)))
        .collect::<Vec<_>>();
    let mut tried = 0;
    for scene in scenes {
        let accuracy = scene["method"].get("accuracy").is_some();
        assert!(accuracy || answer(&scene.to_string()).is_ok(), "good as it is: {scene}");
        let mut places = Vec::new();
        numbers(&scene, "", &mut places);
        for place in places {
            for wrong in ["1e999", "-1e999", "NaN", "Infinity", "-Infinity", "\"inf\"", "\"nan\""] {
                let mut scene = scene.clone();
                *scene.pointer_mut(&place).expect("a place of this scene") = json!("here");
                let text = scene.to_string().replace("\"here\"", wrong);
                let message = answer(&text).expect_err("a number that is none").to_string();
                // Invalid JSON is named by line and column, an unknown law by its choices.
                let field = place.rsplit('/').find(|name| name.parse::<u32>().is_err());
                let field = field.expect("every place has a name");
                let is_json = !wrong.ends_with(['N', 'y']);
                let named = message.contains(field) || message.contains("not JSON") && !is_json;
                assert!(named, "{place} = {wrong}: {message}");
                assert!(message.contains("line 1, column "), "{place} = {wrong}: {message}");
                tried += 1;
            }
        }
    }
    assert!(tried > 2000, "{tried} numbers tried");
}

/// Numbers at the ends of their range, one after another: each is refused or gives finite results, without a panic.
#[test]
fn extreme_largest_and_smallest_numbers_are_answered() {
    let impulsive = laws().remove(0);
    let compliant = laws().remove(9);
    for law in [impulsive, compliant] {
        for method in &methods()[..7] {
            let scene = scene(&law, method);
            let mut places = Vec::new();
            numbers(&scene, "", &mut places);
            for place in places {
                for edge in [f64::MAX, -f64::MAX, f64::MIN_POSITIVE, 5e-324, 1e154, -0.0, 1e9] {
                    let mut scene = scene.clone();
                    *scene.pointer_mut(&place).expect("a place of this scene") = json!(edge);
                    if let Err(error) = answer(&scene.to_string()) {
                        let message = error.to_string();
                        let says = ["found", "structure", "invalid type", "use a "];
                        let named = says.iter().any(|word| message.contains(word));
                        assert!(named, "{place} = {edge:e}: {message}");
                    }
                }
            }
        }
    }
}
