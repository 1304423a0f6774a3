//! Scene files: JSON and TOML give the same scene, and every way to describe a structure gives the same structure.

mod choices;
mod motions;

use std::path::Path;

use insta::assert_snapshot;
use pounding_scene::{Damping, Scene, Structure, file};
use serde_json::{Value, json};

const TOML: &str = r#"
name = "two towers"
record.file = "record.csv"

[[structures]]
[structures.sdof]
name = "old"
mass_kg = 75e3
period_s = 1.2
damping.ratio = 0.05
height_m = 12
yield_drift_ratio = 0.005

[[structures]]
[structures.sdof]
name = "new"
mass_kg = 3e5
stiffness_n_per_m = 3.3e7
damping.two_frequencies = { frequencies_hz = [1.0, 5.0], ratios = [0.05, 0.05] }
yield_displacement_m = 0.02

[[contacts]]
gap_m = 0.03
law.stereomechanical.restitution = 0.65
"#;

fn scene(text: &str, name: &str) -> Scene {
    Scene::parse(text.as_bytes(), Path::new(name)).expect("a good scene")
}

fn refusal(text: &str) -> String {
    let refused = Scene::parse(text.as_bytes(), Path::new("scene.toml"));
    refused.expect_err("a scene that is refused").to_string()
}

/// The scene with one piece of text replaced.
fn changed(from: &str, to: &str) -> String {
    assert!(TOML.contains(from), "{from}");
    TOML.replace(from, to)
}

fn sdof(scene: &Scene, index: usize) -> &pounding_scene::Sdof {
    match &scene.structures[index] {
        Structure::Sdof(sdof) => sdof,
        Structure::Building(_) | Structure::Wall => panic!("structure {index} is no wall"),
    }
}

#[test]
fn limit_json_and_toml_say_the_same() {
    let of_toml = scene(TOML, "scene.toml");
    let json = serde_json::to_string(&of_toml).expect("a scene is written");
    assert_eq!(scene(&json, "scene.json"), of_toml);
    // The first letter decides, whatever the name of the file. A byte order mark does not matter.
    assert_eq!(scene(&format!("\u{feff}{json}"), "scene"), of_toml);
    assert_eq!(scene(&format!("\u{feff}{TOML}"), "scene"), of_toml);
}

#[test]
fn reference_period_drift_and_two_frequencies() {
    let scene = scene(TOML, "scene.toml");
    let (old, new) = (sdof(&scene, 0), sdof(&scene, 1));
    assert!((old.period() - 1.2).abs() < 1e-15, "{}", old.period());
    let omega = 2.0 * std::f64::consts::PI / 1.2;
    let stiffness = 75e3 * omega * omega;
    let expected = stiffness * 0.06;
    let found = old.yield_force_n.expect("it yields");
    assert!((found / expected - 1.0).abs() < 1e-15, "{found}");
    let found = new.yield_force_n.expect("it yields");
    assert!((found / 6.6e5 - 1.0).abs() < 1e-15, "{found}");
    // By hand: α/(2ω) + βω/2 with α = 2ζ ω₁ω₂/(ω₁+ω₂), β = 2ζ/(ω₁+ω₂).
    let omega = |frequency: f64| 2.0 * std::f64::consts::PI * frequency;
    let (alpha, beta) = (0.1 * omega(1.0) * omega(5.0) / omega(6.0), 0.1 / omega(6.0));
    let own = (3.3e7_f64 / 3e5).sqrt();
    let expected = 0.5 * (alpha / own + beta * own);
    let found = new.damping_ratio();
    assert!((found - expected).abs() < 1e-14, "{found} {expected}");
}

#[test]
fn limit_a_scene_without_method_and_duration() {
    let scene = scene(TOML, "scene.toml");
    assert_eq!(scene.method, pounding_scene::Method::EXACT);
    assert_eq!(scene.duration_s, None);
    let record = b"time_s,acceleration_g\n0,0\n1,0.1\n2,0\n";
    let record = pounding_motion::read(record).expect("a record");
    let prepared = pounding_scene::Simulation::with_record(&scene, record).expect("a good scene");
    // The duration is that of the record and two of the longest periods.
    assert!((prepared.duration() - 4.4).abs() < 1e-12, "{}", prepared.duration());
}

#[test]
fn extreme_too_few_or_too_many_words() {
    assert_snapshot!(refusal(&changed("period_s = 1.2\n", "")), @"scene.toml, line 6, column 1: structures[0].sdof: found neither `stiffness_n_per_m` nor `period_s`, allowed is one of them; add the one that is known");
    assert_snapshot!(refusal(&changed("period_s = 1.2\n", "period_s = 1.2\nstiffness_n_per_m = 1e6\n")), @"scene.toml, line 6, column 1: structures[0].sdof: found both `stiffness_n_per_m` and `period_s`, allowed is one of them; delete the other");
    assert_snapshot!(refusal(&changed("height_m = 12\n", "")), @"scene.toml, line 6, column 1: structures[0].sdof: found `yield_drift_ratio` without `height_m`, which it is a part of; add the height, or give `yield_displacement_m`");
    assert_snapshot!(refusal(&changed("height_m = 12\n", "height_m = 12\nyield_force_n = 1e5\n")), @"scene.toml, line 6, column 1: structures[0].sdof: found several of `yield_force_n`, `yield_displacement_m` and `yield_drift_ratio`, allowed is at most one; delete the others");
    assert_snapshot!(refusal(&changed("record.file = \"record.csv\"", "record.scale = 2")), @"scene.toml, line 3, column 1: record: found neither `file` nor `generated`, allowed is one of them; name the record");
}

#[test]
fn extreme_values_that_cannot_be_converted() {
    for (from, to) in [
        ("period_s = 1.2", "period_s = 0"),
        ("period_s = 1.2", "period_s = nan"),
        ("period_s = 1.2", "period_s = inf"),
        ("height_m = 12", "height_m = -12"),
        ("yield_drift_ratio = 0.005", "yield_drift_ratio = 0.0"),
        ("yield_displacement_m = 0.02", "yield_displacement_m = -0.02"),
    ] {
        let message = refusal(&changed(from, to));
        assert!(message.contains("allowed a finite number > 0"), "{to}: {message}");
        let field = to.split(' ').next().expect("a field");
        assert!(message.contains(&format!("{field}: found")), "{to}: {message}");
    }
}

#[test]
fn extreme_fields_of_laws() {
    let law = |to: &str| refusal(&changed("law.stereomechanical.restitution = 0.65", to));
    assert_snapshot!(law("law.stereomechanical.e = 0.65"), @"scene.toml, line 24, column 22: contacts[0].law.stereomechanical.e: found the field `e`, allowed are `restitution`");
    assert_snapshot!(law("law.hertz = [2e9]"), @"scene.toml, line 24, column 13: contacts[0].law.hertz: found a list, allowed is a table of fields");
    assert_snapshot!(law("law.hertz = {}"), @"scene.toml, line 24, column 13: contacts[0].law.hertz: found no `impact_stiffness_n_per_m1_5`, which must be there; add it");
}

#[test]
fn extreme_fields_of_wrong_type() {
    assert_snapshot!(refusal(&changed("mass_kg = 75e3", "mass_kg = \"75 t\"")), @r#"scene.toml, line 8, column 11: structures[0].sdof.mass_kg: found the text "75 t", allowed is a number"#);
    assert_snapshot!(refusal(&changed("damping.ratio = 0.05", "damping = 0.05")), @r#"scene.toml, line 10, column 11: structures[0].sdof.damping: found no choice, allowed is one, such as {"ratio": 0.05} in JSON, { ratio = 0.05 } in TOML"#);
    assert_snapshot!(refusal(&changed("ratios = [0.05, 0.05]", "ratios = [0.05]")), @"scene.toml, line 19, column 67: structures[1].sdof.damping.two_frequencies.ratios: found a list of 1, allowed is a list of two");
    assert_snapshot!(refusal(&changed("record.file = \"record.csv\"", "record = \"record.csv\"")), @r#"scene.toml, line 3, column 10: record: found the text "record.csv", allowed is a table of fields"#);
    assert_snapshot!(refusal(&changed("[[contacts]]", "[contacts]")), @"scene.toml, line 22, column 1: contacts: found a table, allowed is a list");
    assert_snapshot!(refusal(&changed("gap_m = 0.03", "gap_m = true")), @"scene.toml, line 23, column 9: contacts[0].gap_m: found true, allowed is a number");
    assert_snapshot!(refusal(&changed("gap_m = 0.03", "gab_m = 0.03")), @"scene.toml, line 23, column 1: contacts[0].gab_m: found the field `gab_m`, allowed are `gap_m`, `law`, `levels`, `heights_m`, `seat_width_m`, `column_shape`, `property`; perhaps `gap_m` is meant");
    assert_snapshot!(refusal(&changed("gap_m = 0.03", "gap_m = 0,03")), @"scene.toml, line 23, column 10: found `0,03` with a decimal comma, allowed is a decimal point: `0.03`");
    assert_snapshot!(refusal(&changed("gap_m = 0.03", "gap_m = 0.03\ngap_m = 0.04")), @"scene.toml, line 24, column 1: not TOML: duplicate key");
    assert_snapshot!(refusal("structures: 2\n"), @"scene.toml, line 1, column 13: not TOML: key with no value, expected `=`");
}

/// TOML read the first two numbers of a range and dropped the rest.
#[test]
fn issue_a_range_of_three_numbers_lost_one() {
    let range = "[neighbour.unknown]\nperiod_s = [0.2, 1, 2]\nmass_ratio = [0.5, 2]\n\n[[contacts]]";
    assert_snapshot!(refusal(&changed("[[contacts]]", range)), @"scene.toml, line 23, column 12: neighbour.unknown.period_s: found a list of 3, allowed is a list of two");
}

#[test]
fn extreme_fields_that_are_there_twice() {
    let text = serde_json::to_string_pretty(&scene(TOML, "scene.toml")).expect("JSON");
    let twice = text.replace("\"mass_kg\": 75000.0,", "\"mass_kg\": 75000.0, \"mass_kg\": 1.0,");
    let refused = Scene::parse(twice.as_bytes(), Path::new("scene.json"));
    assert_snapshot!(refused.expect_err("two masses").to_string(), @"scene.json, line 11, column 15: structures[0].sdof: found `mass_kg` twice, allowed is once; delete one");
}

#[test]
fn extreme_text_that_is_not_utf8() {
    let refused = |text: &[u8], name: &str| {
        let refused = Scene::parse(text, Path::new(name));
        refused.expect_err("Latin-1").to_string()
    };
    assert_snapshot!(refused(b"name = \"T\xfcrkiye\"", "scene.toml"), @"scene.toml: the text is not UTF-8 from byte 9 on; save it as UTF-8");
    assert_snapshot!(refused(b"{\"name\": \"T\xfcrkiye\"}", "scene.json"), @"scene.json: the text is not UTF-8 from byte 11 on; save it as UTF-8");
}

/// The schema allows only fields that it knows, and choices that are single words. Tests of the program check that the shipped files fit
/// it.
#[test]
fn limit_the_schema_knows_the_words_of_a_file() {
    let schema: Value = serde_json::from_str(&file::schema()).expect("JSON");
    assert_eq!(schema["additionalProperties"], json!(false));
    let Damping::Ratio(_) = sdof(&scene(TOML, "x.toml"), 0).damping else {
        panic!("a ratio")
    };
    let text = file::schema();
    for field in [
        "period_s",
        "yield_drift_ratio",
        "two_frequencies",
        "hertz_damp",
        "restitution",
        "contact_substeps",
        "simultaneous_impacts",
        "gravity_m_per_s2",
        "initial_velocity_m_per_s",
    ] {
        assert!(text.contains(&format!("\"{field}\"")), "{field}");
    }
    insta::assert_snapshot!("schema", text);
}
