//! Messages about studies that do not fit together, and round trips of study files.

use pounding_scene::{Advice, Goal, Method, QuantityGroup, Simulation};
use pounding_solver::{LedgerError, Rk4};
use pounding_studies::{Completed, Study, StudyError, StudyFile, StudyTable, figure_png};
use std::fs;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use serde_json::{Value, json};

fn studies() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies")
}

/// A study of the paper as JSON, with an absolute path to its record.
fn study(id: &str) -> Value {
    let text = fs::read_to_string(studies().join(id).with_extension("json")).expect("a study");
    let mut study: Value = serde_json::from_str(&text).expect("JSON");
    for scene in study["scenes"].as_array_mut().expect("scenes") {
        let file = scene["record"]["file"].as_str().expect("a path").to_string();
        scene["record"]["file"] = json!(studies().join(file).to_str().expect("a path in UTF-8"));
    }
    study
}

/// Reads a study from a file, runs it and makes its table or figure.
fn make(test: &str, study: &Value) -> Result<(), StudyError> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("scenes").join(test);
    fs::create_dir_all(&folder).expect("the folder can be made");
    let path = folder.join("study.json");
    fs::write(&path, serde_json::to_string_pretty(study).expect("JSON")).expect("the study can be written");
    let completed = Completed::run(StudyFile::read(&path)?, &|| ())?;
    StudyTable::of(&completed)?;
    figure_png(&completed)?;
    Ok(())
}

/// The message about a refused study, from the name of its file.
fn refused(test: &str, study: &Value) -> String {
    let message = make(test, study).expect_err("a study that is refused").to_string();
    let message = message.replace('\\', "/");
    let (_, message) = message.split_once(&format!("scenes/{test}/")).expect("the file is named");
    message.into()
}

#[test]
fn extreme_no_scenes() {
    let mut study = study("table-5");
    study["scenes"] = json!([]);
    assert_snapshot!(refused("none", &study), @"study.json: scenes: found none, allowed one or more scenes");
}

#[test]
fn extreme_scene_name_twice() {
    let mut study = study("table-5");
    study["scenes"][2]["name"] = study["scenes"][0]["name"].clone();
    assert_snapshot!(refused("twice", &study), @r#"study.json: scenes: found "stereomechanical elastic" twice, allowed names that differ"#);
}

#[test]
fn extreme_output_unknown() {
    let mut study = study("table-5");
    study["output"] = json!("momentum_table");
    assert_snapshot!(refused("output", &study), @"study.json, line 3, column 13: output: found `momentum_table`, allowed are `structures_table`, `pounding_forces_table`, `first_collision_table`, `transferred_momentum_table`, `text_table`, `claims`, `trade`, `laws`, `extremes`, `beyond`, `survey`, `record_figure`, `displacement_figure`, `pounding_figure`, `first_collision_figure`, `layout_figure`, `shear_force_figure`");
}

#[test]
fn extreme_option_of_output_unknown() {
    let mut study = study("table-2");
    study["output"]["pounding_forces_table"]["offset_s"] = json!(0.02);
    assert_snapshot!(refused("option", &study), @"study.json, line 6, column 7: output.pounding_forces_table.offset_s: found the field `offset_s`, allowed are `n_collisions`, `label_offset_s`");
}

#[test]
fn extreme_field_missing_deep_in_a_study() {
    let mut study = study("table-2");
    let contact = study["scenes"][1]["contacts"][0].as_object_mut();
    contact.expect("a contact has fields").remove("gap_m");
    assert_snapshot!(refused("deep", &study), @"study.json, line 70, column 9: scenes[1].contacts[0]: found no `gap_m`, which must be there; add it");
}

#[test]
fn extreme_text_of_a_scene_that_is_not_there() {
    insta::allow_duplicates! {
        for quantity in ["transferred_momentum", "peak_forces"] {
            let mut study = study("text");
            study["output"]["text_table"][quantity] = json!(["three structures"]);
            assert_snapshot!(refused("text", &study), @r#"study.json: output.text_table: found "three structures", allowed names of scenes of the study"#);
        }
    }
}

#[test]
fn extreme_peak_force_of_an_impulsive_law() {
    let mut study = study("text");
    study["output"]["text_table"]["peak_forces"] = json!(["two structures stereomechanical elastic"]);
    assert_snapshot!(refused("impulsive", &study), @r#"study.json: output.text_table.peak_forces: found "two structures stereomechanical elastic", allowed scenes with a compliant contact law"#);
}

#[test]
fn extreme_pounding_forces_of_three_structures() {
    let mut study = study("table-6");
    study["output"] = json!({"pounding_forces_table": {}});
    assert_snapshot!(refused("three", &study), @r#"study.json: scenes: found 3 structures in "layout A elastic", allowed two structures per scene"#);
}

#[test]
fn extreme_shear_force_of_a_structure_that_is_not_there() {
    let mut study = study("figure-15");
    study["output"]["shear_force_figure"]["structure"] = json!("west");
    assert_snapshot!(refused("shear", &study), @r#"study.json: output.shear_force_figure.structure: found "west", allowed the name of a structure of every scene"#);
}

#[test]
fn extreme_scene_that_diverges_is_named() {
    let mut study = study("table-5");
    let law = &mut study["scenes"][2]["contacts"][0]["law"]["nonlinear_viscoelastic"];
    law["impact_stiffness_n_per_m1_5"] = json!(1e300);
    let error = make("diverges", &study).expect_err("contact far too stiff for the time step");
    let StudyError::Scene(pounding_scene::Error::Run { refused, .. }) = &error else {
        panic!("the run should have ended early: {error}");
    };
    let place = refused.place();
    assert!(place.file.as_ref().is_some_and(|path| path.ends_with("study.json")), "{place:?}");
    assert_eq!(place.scene.as_deref(), Some("viscoelastic elastic"));
    assert_eq!(refused.parts().help.as_deref(), Some("structure 0 is \"weak\""));
}

#[test]
fn extreme_time_step_at_the_limit() {
    // The limits are T/π = 2/ω of the stiff structure, T√3/π for linear acceleration, and none for average acceleration and its relatives.
    // The limit of the Runge–Kutta method, near 2√2/ω, depends on the damping.
    let limit = 2.0 * (3e6_f64 / 1.316e9).sqrt();
    let damping = (0.5712 * 3e6 + 0.001_447 * 1.316e9) / (2.0 * (3e6_f64 * 1.316e9).sqrt());
    let newmark = |beta: f64| json!({"newmark": {"time_step_s": 0, "beta": beta, "gamma": 0.5}});
    let central = json!({"central_difference": {"time_step_s": 0}});
    for (method, limit) in [
        (central, Some(limit)),
        (newmark(1.0 / 6.0), Some(3.0_f64.sqrt() * limit)),
        (newmark(0.25), None),
        (json!({"velocity_verlet": {"time_step_s": 0}}), Some(limit)),
        (
            json!({"rk4": {"time_step_s": 0}}),
            Some(Rk4::critical_time_step(2.0 / limit, damping)),
        ),
        (json!({"hht": {"time_step_s": 0, "alpha": -0.3}}), None),
        (json!({"moreau_jean": {"time_step_s": 0, "theta": 0.5}}), None),
    ] {
        let run = |time_step: f64| {
            let mut study = study("figure-1");
            let scene = &mut study["scenes"][0];
            scene["method"] = method.clone();
            let settings = scene["method"].as_object_mut().expect("a method has settings");
            for settings in settings.values_mut() {
                settings["time_step_s"] = json!(time_step);
            }
            scene["duration_s"] = json!(1000.0 * time_step);
            make("limit", &study)
        };
        let limit = limit.unwrap_or(f64::NAN);
        if limit.is_nan() {
            assert!(run(10.0).is_ok(), "no limit: {method}");
        } else {
            assert!(run(0.999 * limit).is_ok(), "below the limit: {method}");
            let error = run(1.001 * limit).expect_err("above the limit");
            assert!(error.to_string().contains("allowed less than"), "{error}");
        }
    }
}

#[test]
fn extreme_the_first_error_is_the_first_scene_on_any_number_of_threads() {
    let mut study = study("table-7");
    for scene in study["scenes"].as_array_mut().expect("scenes") {
        for contact in scene["contacts"].as_array_mut().expect("contacts") {
            contact["law"]["nonlinear_viscoelastic"]["impact_stiffness_n_per_m1_5"] = json!(1e300);
        }
    }
    for _ in 0..5 {
        let error = make("first-error", &study).expect_err("every scene diverges");
        assert!(error.to_string().contains("layout A elastic"), "{error}");
    }
}

/// A table shows the method that was found for an accuracy, which is the advised one.
#[test]
fn limit_an_accuracy_in_a_study_is_what_is_advised() {
    let mut study = study("table-7");
    study["scenes"].as_array_mut().expect("scenes").truncate(1);
    study["scenes"][0]["method"] = json!({"accuracy": 0.2});
    study.as_object_mut().expect("a study").remove("program");
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("accuracy.json");
    fs::write(&path, study.to_string()).expect("the study can be written");
    let file = StudyFile::read(&path).expect("a study");
    let asked = Completed::run(file.clone(), &|| ()).expect("a method is found");
    let mut exact = file.study.scenes[0].clone();
    exact.method = Method::EXACT;
    let exact = Simulation::new(&exact, file.base()).expect("a good scene");
    let (error, quantity) = (0.2, QuantityGroup::All);
    let advice = Advice::of(&exact, Goal { error, quantity }, &|_| ()).expect("an exact run");
    let mut named = file;
    named.study.scenes[0].method = advice.best().method;
    assert_eq!(asked.file.study.scenes[0].method, advice.best().method);
    let named = Completed::run(named, &|| ()).expect("a good study");
    let csv = |completed| StudyTable::of(completed).expect("a table").expect("one").to_csv();
    assert_eq!(csv(&asked), csv(&named));
}

#[test]
fn extreme_scenes_that_the_papers_program_cannot_run() {
    insta::allow_duplicates! {
        for (place, name, value) in [
            ("/scenes/0/method/central_difference", "time_step_s", json!(0.04)),
            ("/scenes/0/method/central_difference", "contact_substeps", json!(2)),
            ("/scenes/0", "method", json!({"accuracy": 0.1})),
            ("/scenes/0/structures/0/sdof", "initial_velocity_m_per_s", json!(0.1)),
            ("/scenes/0", "arrivals_s", json!([0.0, 0.1])),
            ("/scenes/0/contacts/0", "law", json!({"hertz": {"impact_stiffness_n_per_m1_5": 1e9}})),
        ] {
            let mut study = study("table-5");
            study["output"] = json!("transferred_momentum_table");
            study["program"] = json!({});
            study.pointer_mut(place).expect("a place")[name] = value;
            assert_snapshot!(refused("program", &study), @r#"study.json: program: found the scene "stereomechanical elastic", allowed structures of one storey at rest, no walls, no arrivals, stereomechanical impact or the nonlinear viscoelastic element, and a method with a time step that divides the record's, without sub-steps"#);
        }
    }
}

/// A misspelt name gave the other start silently.
#[test]
fn issue_a_start_of_a_scene_that_is_not_there() {
    let mut study = study("table-6");
    study["program"]["first_load_used"] = json!(["layout A elastik"]);
    assert_snapshot!(refused("start", &study), @r#"study.json: program: found "layout A elastik", allowed in `first_load_used` names of scenes of the study by central differences"#);
}

#[test]
fn extreme_an_accuracy_where_steps_are_shown() {
    let mut study = study("table-2");
    study["scenes"][0]["method"] = json!({"accuracy": 0.2});
    assert_snapshot!(refused("steps", &study), @r#"study.json: scenes.method: found "elastic" without a time step, allowed methods with a time step, because this output shows single steps"#);
}

#[test]
fn extreme_a_run_that_creates_energy_names_pair_and_structures() {
    let mut study = study("table-4");
    study["scenes"].as_array_mut().expect("scenes").remove(0);
    study["scenes"][0]["method"]["central_difference"]["time_step_s"] = json!(0.05);
    study.as_object_mut().expect("a study").remove("program");
    let error = make("energy", &study).expect_err("steps far too long for the contact");
    let StudyError::Scene(pounding_scene::Error::Broken { refused, source }) = &error else {
        panic!("a law should be broken: {error}");
    };
    let LedgerError::GainInContact { pair, .. } = source else {
        panic!("energy should be created: {error}");
    };
    assert!(refused.place().file.is_some(), "the error should name its file: {error}");
    let help = refused.parts().help.expect("the structures");
    let indices = [*pair, pair + 1].map(|index| help.contains(&format!("structure {index} is")));
    assert_eq!((indices, help.matches("structure ").count()), ([true; 2], 2), "{help}");
}

#[test]
fn extreme_claims_without_their_scenes() {
    let error = pounding_studies::claims(&[]).expect_err("no study");
    assert_snapshot!(error, @r#"studies/table-2.json: found no scene "any"; the claims of the paper are tested on it"#);
}

#[test]
fn limit_studies_survive_writing_and_reading() {
    let files = StudyFile::read_all(&studies()).expect("readable studies");
    assert!(files.len() > 20, "{} studies", files.len());
    for file in files {
        let text = serde_json::to_string_pretty(&file.study).expect("a study can be written");
        let again: Study = serde_json::from_str(&text).expect("what was written can be read");
        assert_eq!(again, file.study, "{}", file.id);
    }
}
