//! Tests that no table and no JSON holds an infinite number or NaN, and that no message prints three hundred digits.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::suites::{TOWERS, suite};
use crate::sweeps::{scene, sweep, with_sweep};
use crate::{folder, pounding, refusal};

/// Cells of a table that readers take for numbers that are not finite.
fn infinite(table: &str) -> Vec<&str> {
    let is_none = |cell: &&str| cell.parse().is_ok_and(|number: f64| !number.is_finite());
    let cells = table.lines().flat_map(|line| line.split(','));
    cells.filter(is_none).collect()
}

/// The table had `largest_error,inf` if the numbers of collisions differ.
#[test]
fn issue_an_error_that_does_not_exist_is_an_empty_cell() {
    let folder = suite("finite_errors");
    let value = |step: usize| format!("{:.3}", -400.0 * libm::sin(0.25 * step as f64));
    let values: Vec<String> = (0..60).map(value).collect();
    fs::write(folder.join("records/column.txt"), values.join("\n")).expect("a file");
    fs::remove_file(folder.join("records/pulse.csv")).expect("it is there");
    // One of two collisions happens between the steps.
    let soft = "law.kelvin_voigt = { restitution = 0.9, impact_stiffness_n_per_m = 1e8, calibration = \"exact\" }";
    let towers = TOWERS.replace("law.stereomechanical.restitution = 0.6", soft);
    let coarse = "\n[method.central_difference]\ntime_step_s = 0.04\nstart = \"consistent\"\n";
    fs::write(folder.join("coarse.toml"), format!("{towers}{coarse}")).expect("a file");
    let run = ["run", "coarse.toml", "--records", "records"];
    let csv = pounding(&folder, &[&run[..], &["--csv"]].concat());
    assert_eq!(csv.code, 0, "{}", csv.stderr);
    assert_eq!(infinite(&csv.stdout), Vec::<&str>::new());
    let errors = csv.stdout.lines().filter(|line| line.contains(",largest_error,"));
    let errors: Vec<&str> = errors.collect();
    assert!(errors.iter().any(|line| line.ends_with(",largest_error,,")), "{errors:?}");
    let json = pounding(&folder, &[&run[..], &["--json"]].concat());
    let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
    let motions = json["motions"].as_array().expect("a list");
    assert!(motions.iter().any(|one| one["largest_error"].is_null()), "{json:#}");
}

/// Asserts that a message has all of these words and no number with more than a few digits.
fn says(message: &str, words: &[&str]) {
    let missing = words.iter().find(|word| !message.contains(**word));
    assert_eq!(missing, None, "{message}");
    let digits = |word: &str| word.chars().filter(char::is_ascii_digit).count();
    assert!(message.split([' ', ',']).all(|word| digits(word) < 20), "{message}");
}

fn with_record(test: &str, samples: &str) -> std::path::PathBuf {
    let folder = folder(test);
    let record = format!("time_s,acceleration_m_per_s2\n{samples}");
    fs::write(folder.join("record.csv"), record).expect("a file");
    let mut scene = scene();
    scene["record"] = json!({"file": "record.csv"});
    write(&folder, &scene);
    folder
}

fn write(folder: &Path, scene: &Value) {
    fs::write(folder.join("scene.json"), scene.to_string()).expect("a file");
}

/// A record had an Arias intensity of `inf`.
#[test]
fn issue_a_record_beyond_all_grounds_is_refused() {
    let folder = with_record("finite_record", "0,0\n0.01,1e300\n0.02,0\n");
    let too_strong = ["sample 1 ", "1e300 m/s²", "1e9 m/s²"];
    says(
        &refusal(&pounding(&folder, &["motion", "info", "record.csv", "--csv"])),
        &too_strong,
    );
    says(
        &refusal(&pounding(&folder, &["motion", "spectrum", "record.csv", "--csv"])),
        &too_strong,
    );
    says(&refusal(&pounding(&folder, &["run", "scene.json"])), &too_strong);
    let folder = with_record("finite_record_of_inf", "0,0\n0.01,inf\n0.02,0\n");
    says(
        &refusal(&pounding(&folder, &["run", "scene.json"])),
        &["record.csv", "line 3", "\"inf\""],
    );
    let folder = with_record("finite_step", "0,0\n1e300,1\n2e300,0\n");
    says(
        &refusal(&pounding(&folder, &["motion", "info", "record.csv", "--csv"])),
        &["1e300 s", "allowed"],
    );
}

/// The table had `inf` as a sampled input.
#[test]
fn issue_a_sampled_number_beyond_all_numbers_is_an_empty_cell_with_its_reason() {
    let mut words = sweep(8);
    let wide = json!({"median": 1e5, "log_standard_deviation": 800.0});
    words["vary"] = json!([{"field": "structures[0].sdof.mass_kg", "log_normal": wide}]);
    let folder = with_sweep("finite_sweep", &words);
    pounding(&folder, &["sweep", "sweep.json"]);
    let table = fs::read_to_string(folder.join("sweep.json.csv")).expect("a table");
    assert_eq!(infinite(&table), Vec::<&str>::new());
    let refused = table.lines().find(|line| line.contains("found inf"));
    let refused = refused.expect("one is beyond all numbers");
    says(refused, &["structures[0].sdof.mass_kg", "found inf", "allowed"]);
}

/// A finite mass and stiffness gave a period of `inf`, and runs with some masses did not end.
#[test]
fn issue_numbers_of_a_scene_beyond_all_buildings_are_refused_in_its_words() {
    let folder = folder("finite_scenes");
    let refused = |field: &str, value: Value| {
        let mut scene = scene();
        let sdof = &mut scene["structures"][0]["sdof"];
        if field != "period_s" {
            sdof.as_object_mut().expect("a table").remove("period_s");
            sdof["stiffness_n_per_m"] = json!(1e6);
        }
        if field == "bouc_wen" {
            sdof["yield_displacement_m"] = json!(0.02);
        }
        sdof[field] = value;
        write(&folder, &scene);
        refusal(&pounding(&folder, &["check", "scene.json", "--json"]))
    };
    says(
        &refused("mass_kg", json!(1.7e308)),
        &["structures[0].sdof.mass_kg", "1.7e308", "1e100"],
    );
    says(&refused("mass_kg", json!(5e-324)), &["structures[0].sdof", "e-324"]);
    says(
        &refused("stiffness_n_per_m", json!(1e-310)),
        &["structures[0].sdof.stiffness_n_per_m", "1e-310", "1e-100"],
    );
    says(&refused("period_s", json!(1e300)), &["structures[0].sdof", "period_s", "1e300"]);
    says(
        &refused("damping", json!({"ratio": 1e300})),
        &["structures[0].sdof.damping.ratio", "1e300", "1e100"],
    );
    says(
        &refused("initial_velocity_m_per_s", json!(-1e307)),
        &["structures[0].sdof.initial_velocity_m_per_s", "-1e307", "1e100"],
    );
    let bent = |exponent: Value| json!({"exponent": exponent, "beta": 0.5});
    says(
        &refused("bouc_wen", bent(json!(2.5))),
        &["bouc_wen.exponent", "2.5", "a whole number from 1 to 20"],
    );
    says(
        &refused("bouc_wen", bent(json!(-1))),
        &["bouc_wen.exponent", "-1", "a whole number from 1 to 20"],
    );
    says(
        &refused("bouc_wen", bent(json!(21))),
        &["bouc_wen.exponent", "21", "a whole number from 1 to 20"],
    );
}
