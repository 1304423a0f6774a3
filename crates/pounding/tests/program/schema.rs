//! Tests of the JSON Schema of scene files: it accepts all files of the project and refuses words that a scene may not have.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::{folder, pounding};

/// The JSON Schema that a command prints.
struct Schema(jsonschema::Validator);

impl Schema {
    fn of_scenes() -> Self {
        Self::printed_by(&["schema"])
    }

    fn printed_by(command: &[&str]) -> Self {
        let ended = pounding(Path::new(env!("CARGO_MANIFEST_DIR")), command);
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "it is printed");
        let schema = serde_json::from_str(&ended.stdout).expect("the schema is JSON");
        Self(jsonschema::validator_for(&schema).expect("it is a schema"))
    }

    /// The parts of a scene that the schema refuses.
    fn faults(&self, scene: &Value) -> Vec<String> {
        let fault = |error: jsonschema::ValidationError<'_>| format!("{}: {error}", error.instance_path());
        self.0.iter_errors(scene).map(fault).collect()
    }
}

/// The scene or scenes of a file.
fn scenes(path: &Path) -> Vec<Value> {
    let text = fs::read_to_string(path).expect("the file is there");
    let is_toml = path.extension().is_some_and(|ending| ending == "toml");
    let value: Value = if is_toml {
        toml::from_str(&text).expect("TOML")
    } else {
        serde_json::from_str(&text).expect("JSON")
    };
    match value.get("scenes") {
        Some(scenes) => scenes.as_array().expect("a list").clone(),
        // A study may use the scenes of other studies.
        None if value.get("output").is_some() => Vec::new(),
        None => vec![value],
    }
}

/// The scenes and studies of a folder.
fn in_folder(folder: &Path) -> Vec<Value> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let is_scene = |path: &std::path::PathBuf| {
        let ending = path.extension();
        ending.is_some_and(|ending| ending == "toml" || ending == "json")
    };
    paths.filter(is_scene).flat_map(|path| scenes(&path)).collect()
}

#[test]
fn limit_what_ships_keeps_to_the_schema() {
    let schema = Schema::of_scenes();
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let folder = folder("schema_ships");
    for arguments in [&["demo"] as &[&str], &["init"]] {
        let ended = pounding(&folder, arguments);
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{arguments:?}");
    }
    let places = [
        (studies.clone(), 40),
        (studies.join("examples"), 3),
        (folder.join("pounding-demo"), 1),
        (folder.clone(), 1),
    ];
    for (place, least) in places {
        let scenes = in_folder(&place);
        assert!(scenes.len() >= least, "{}: {}", place.display(), scenes.len());
        for scene in scenes {
            let faults = schema.faults(&scene);
            assert!(faults.is_empty(), "{}: {}", scene["name"], faults.join("\n"));
        }
    }
    // The copy of a scene in a folder of results is a scene too.
    let summary = fs::read_to_string(folder.join("pounding-demo/results/summary.json"));
    let summary: Value = serde_json::from_str(&summary.expect("it is there")).expect("JSON");
    assert_eq!(schema.faults(&summary["scene"]), [""; 0], "of a summary");
}

/// An editor marks scenes whose form the program refuses.
#[test]
fn extreme_what_has_another_form_does_not_keep_to_the_schema() {
    let schema = Schema::of_scenes();
    let good = crate::good_scene();
    assert_eq!(schema.faults(&good), [""; 0], "the example");
    let damping = |damping: Value| {
        let mut scene = good.clone();
        scene["structures"][0]["sdof"]["damping"] = damping;
        scene
    };
    let at = |pointer: &str, value: Value| {
        let mut scene = good.clone();
        *scene.pointer_mut(pointer).expect("it is there") = value;
        scene
    };
    let with = |pointer: &str, field: &str| {
        let mut scene = good.clone();
        scene.pointer_mut(pointer).expect("it is there")[field] = json!(1);
        scene
    };
    let mut nameless = good.clone();
    nameless.as_object_mut().expect("fields").remove("name");
    for (what, scene) in [
        ("no name", nameless),
        ("a misspelt field", with("", "metod")),
        ("another one", with("/structures/0/sdof", "mas_kg")),
        ("an unknown unit", with("/record", "unit")),
        ("a text for a number", at("/contacts/0/gap_m", json!("3 cm"))),
        ("an unknown law", at("/contacts/0/law", json!({"glue": {}}))),
        ("a structure that is a number", at("/structures/1", json!(3))),
        (
            "two dampings",
            damping(json!({"ratio": 0.05, "rayleigh": {"alpha_per_s": 0, "beta_s": 0}})),
        ),
        (
            "one frequency",
            damping(json!({"two_frequencies": {"frequencies_hz": [1], "ratios": [0.05, 0.05]}})),
        ),
    ] {
        assert!(!schema.faults(&scene).is_empty(), "{what} is found");
    }
}

#[test]
fn limit_sweeps_keep_to_their_schema() {
    let schema = Schema::printed_by(&["schema", "--sweep"]);
    let text = fs::read_to_string("../../studies/sweeps/gap-and-period.json").expect("a sweep");
    let good: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(schema.faults(&good), [""; 0]);
    let mut inline = good.clone();
    inline["scene"] = crate::good_scene();
    inline["records"] = json!(["a.csv", "folder"]);
    assert_eq!(schema.faults(&inline), [""; 0]);
    inline["summary"] = json!({"by": ["record"], "exceedance": {"peak_force_n": [1e6]}, "rows": true});
    assert_eq!(schema.faults(&inline), [""; 0]);
    for (place, value) in [
        ("/summary", json!({"quantile": [0.5]})),
        ("/summary", json!({"exceedance": {"peak_force_n": 1e6}})),
        ("/scene", json!(3)),
        ("/scene", json!({"name": "x"})),
        ("/vary/0/grid/spacing", json!("cubic")),
        ("/vary/0/grid", json!({"from": 0.0})),
        ("/samples/method", json!("halton")),
        ("/directions", json!("left")),
        ("/outputs/pairs/0", json!("collision")),
    ] {
        let mut bad = good.clone();
        let (parent, key) = place.rsplit_once('/').expect("a place");
        let parent = bad.pointer_mut(parent).expect("it is there");
        if let Value::Array(items) = parent {
            items[0] = value.clone();
        } else {
            parent[key] = value.clone();
        }
        assert!(!schema.faults(&bad).is_empty(), "{place}: {value}");
    }
}
