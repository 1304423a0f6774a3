//! Tests of `pounding export`: the script of a scene, and the laws that it cannot hold.

use std::fs;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use pounding::scene::{Method, Scene, Simulation};
use serde_json::{Value, json};

use crate::runs::printed;
use crate::{Ended, folder, good_scene, pounding, refusal};

fn linear() -> Value {
    json!({"linear_spring": {"impact_stiffness_n_per_m": 93.5e6}})
}

/// A wall and two structures under a jerk of the ground; one structure yields.
fn scene() -> Value {
    let mut scene = good_scene();
    let (weak, stiff) = (scene["structures"][0].clone(), scene["structures"][1].clone());
    scene["structures"] = json!(["wall", weak, stiff]);
    scene["contacts"] = json!([{"gap_m": 0.02, "law": linear()}, {"gap_m": 0.03, "law": linear()}]);
    scene["record"]["scale"] = json!(-2);
    scene["duration_s"] = json!(2);
    scene
}

fn written(test: &str, scene: &Value) -> PathBuf {
    let folder = folder(test);
    fs::write(folder.join("scene.json"), scene.to_string()).expect("written");
    let jerk = "time_s,acceleration_m_per_s2\n0,1.5\n0.2,-3\n0.4,0\n";
    fs::write(folder.join("record.csv"), jerk).expect("written");
    folder
}

fn export(folder: &Path, options: &[&str]) -> Ended {
    pounding(folder, &[&["export", "--opensees", "scene.json"], options].concat())
}

/// The numbers of a script; the code below them is equal in all scripts.
fn numbers(script: &str) -> &str {
    let (numbers, program) = script.split_once("\n\n\ndef travels").expect("two parts");
    assert!(program.contains("UniformExcitation"), "{program}");
    numbers
}

#[test]
fn reference_script_of_a_small_scene() {
    let folder = written("export", &scene());
    let ended = export(&folder, &[]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    assert_snapshot!(numbers(&ended.stdout));
}

/// Buildings and travelling motions were refused although OpenSees can model them.
#[test]
fn issue_buildings_and_motions_that_travel_are_written() {
    let mut scene = scene();
    let storeys = |yields: Value| {
        let mut storey = json!({"mass_kg": 2e5, "height_m": 3, "stiffness_n_per_m": 1e8, "yield_displacement_m": 0.02, "repeat": 2});
        for (word, value) in yields.as_object().into_iter().flatten() {
            storey[word] = value.clone();
        }
        json!({"building": {"name": "tower", "damping": {"ratio": 0.05}, "storeys": [storey]}})
    };
    let hardening = storeys(json!({"hardening_ratio": 0.05}));
    let smooth = storeys(json!({"bouc_wen": {"exponent": 2}}));
    scene["structures"] = json!([hardening, smooth, "wall"]);
    scene["arrivals_s"] = json!([0, 0.1, 0.1]);
    let folder = written("export_buildings", &scene);
    let ended = export(&folder, &["--time-step", "1e-5"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    assert_snapshot!(numbers(&ended.stdout));
}

#[test]
fn limit_the_script_holds_the_numbers_of_the_exact_run() {
    let folder = written("export_exact", &scene());
    let script = export(&folder, &["--time-step", "1e-6"]).stdout;
    let mut scene: Scene = Scene::read(&folder.join("scene.json")).unwrap();
    scene.method = Method::EXACT;
    let outcome = Simulation::new(&scene, &folder).unwrap().run(None).unwrap();
    let peaks = [0, 1, 2].map(|index| outcome.peaks.of(index).displacement.value);
    let first = |pair| outcome.collisions.all().iter().find(|one| one.pair == pair);
    let firsts = [0, 1].map(|pair| first(pair).expect("they touch").start);
    for line in [
        format!("    \"displacement\": {peaks:?},"),
        format!("    \"first\": {firsts:?},"),
        "TIME_STEP = 1e-6  # s".into(),
        "GROUND_STEP = 0.2  # s".into(),
    ] {
        assert!(script.lines().any(|one| one == line), "{line}\n{script}");
    }
}

#[test]
fn reference_materials_of_the_laws() {
    let nonlinear = json!({"impact_stiffness_n_per_m1_5": 2.75e9, "impact_damping_ratio": 0.35});
    let linear_damped = json!({"impact_stiffness_n_per_m": 93.5e6, "impact_damping_ratio": 0.35});
    let factor = json!({"impact_stiffness_n_per_m1_5": 2.75e9, "impact_damping_factor": 0.5});
    let linear_factor = json!({"impact_stiffness_n_per_m": 93.5e6, "impact_damping_factor": 0.5});
    let materials = [
        linear(),
        json!({"hertz": {"impact_stiffness_n_per_m1_5": 2.75e9}}),
        json!({"nonlinear_viscoelastic": nonlinear}),
        json!({"hertz_damp": factor}),
        json!({"modified_kelvin": linear_factor}),
        json!({"kelvin_voigt": linear_damped}),
    ]
    .map(|law| {
        let mut scene = scene();
        scene["contacts"][1]["law"] = law;
        let folder = written("export_materials", &scene);
        let script = export(&folder, &["--approximate"]).stdout;
        let contact = script.lines().skip_while(|line| !line.contains("weak - stiff"));
        contact.take(3).collect::<Vec<_>>().join("\n")
    });
    assert_snapshot!(materials.join("\n"));
}

#[test]
fn extreme_laws_without_an_equal() {
    let linear_damped = json!({"impact_stiffness_n_per_m": 93.5e6, "impact_damping_ratio": 0.35});
    let messages = [
        json!({"stereomechanical": {"restitution": 0.65}}),
        json!({"kelvin_voigt": linear_damped}),
        json!({"modified_linear_viscoelastic": linear_damped}),
    ]
    .map(|law| {
        let mut scene = scene();
        scene["contacts"][1]["law"] = law;
        refusal(&export(&written("export_laws", &scene), &[]))
    });
    assert_snapshot!(messages.join("\n"));
}

#[test]
fn extreme_exports_that_are_refused() {
    let folder = written("export_refused", &scene());
    let ended = export(&folder, &["--out", "check.py"]);
    assert_snapshot!(printed(&ended));
    let script = fs::read_to_string(folder.join("check.py")).expect("written");
    assert_eq!(script, export(&folder, &[]).stdout, "the same file or printed");
    assert_snapshot!(refusal(&export(&folder, &["--out", "check.py"])), @"error: check.py: is there already, allowed is a new file; name another one or add --overwrite");
    printed(&export(&folder, &["--out", "check.py", "--overwrite"]));
    assert_eq!(pounding(&folder, &["export", "scene.json"]).code, 2);
    assert_eq!(export(&folder, &["--time-step", "0"]).code, 2);
    let mut closed = scene();
    closed["contacts"][0]["gap_m"] = json!(-1);
    let folder = written("export_refused", &closed);
    assert_snapshot!(refusal(&export(&folder, &[])), @r#"error: scene.json: scene "two structures": contacts[0].gap_m: found -1, allowed a finite number >= 0"#);
}
