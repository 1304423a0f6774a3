//! Tests of output for machines: the JSON of every command has one name for each number.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use pounding::report::Summary;
use pounding::scene::{PairQuantity, QuantityKind};
use serde_json::Value;

use crate::suites::{TOWERS, suite};
use crate::{EXAMPLE, folder, pounding};

/// The output of a command, as JSON.
fn json(folder: &Path, arguments: &[&str]) -> Value {
    let ended = pounding(folder, arguments);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{arguments:?}");
    assert!(ended.stdout.ends_with("}\n"), "{arguments:?}");
    serde_json::from_str(&ended.stdout).expect("JSON")
}

/// Lists the names of all fields with the names of their parents.
fn fields(value: &Value, place: &str, all: &mut Vec<String>) {
    match value {
        Value::Object(object) => {
            for (name, value) in object {
                fields(value, &format!("{place}.{name}"), all);
            }
        }
        Value::Array(list) => {
            for value in list.iter().take(1) {
                fields(value, &format!("{place}[]"), all);
            }
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {
            all.push(place.trim_start_matches('.').into());
        }
    }
}

fn names(value: &Value) -> String {
    let mut all = Vec::new();
    fields(value, "", &mut all);
    all.join("\n")
}

#[test]
fn reference_a_plan_as_json() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut plan = json(here, &["check", EXAMPLE, "--json"]);
    // Scene and record have the names of `run --json`.
    plan["scene"] = Value::Null;
    plan["record"] = Value::Null;
    assert_snapshot!(format!("{plan:#}"));
}

/// A thing has one name in the output of all commands.
#[test]
fn limit_fields_have_one_name() {
    let folder = suite("names");
    // With a folder of records every motion runs to its end, whatever the duration of the scene.
    let whole = TOWERS.replace("duration_s = 3.0\n", "");
    fs::write(folder.join("towers.toml"), whole).expect("a file");
    // The other commands run only the direction of the scene.
    let run = ["run", "towers.toml", "--json", "--one-direction"];
    let mut run = json(&folder, &run);
    // Only `run` runs again with a band-limited record.
    run.as_object_mut()
        .expect("an object")
        .remove("between_samples")
        .expect("it ran again");
    let under = ["run", "towers.toml", "--records", "records", "--json"];
    let suite = json(&folder, &under);
    let compared = json(&folder, &["compare", "towers.toml", "towers.toml", "--json"]);
    let plan = json(&folder, &["check", "towers.toml", "--json"]);
    for part in ["structures", "pairs"] {
        // The scene's own record is the first of the folder.
        assert_eq!(suite["motions"][0][part], run[part], "{part}");
    }
    assert_eq!(compared["runs"][0], run);
    assert_eq!(compared["runs"][1], run);
    for part in ["record", "scene"] {
        assert_eq!(plan[part], run[part], "{part}");
    }
    for (part, field) in [
        ("structures", "name"),
        ("structures", "period_s"),
        ("pairs", "left"),
        ("pairs", "gap_m"),
        ("pairs", "law"),
    ] {
        assert_eq!(plan[part][0][field], run[part][0][field], "{part} {field}");
    }
    let _: Summary = serde_json::from_value(compared["runs"][0].clone()).expect("a summary");
    // A number of the table is a field of the JSON. The fields of a nested object carry its name and `_` in front.
    let csv = pounding(&folder, &[&under[..4], &["--csv"]].concat()).stdout;
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let mut compared = 0;
    for row in reader.records() {
        let row = row.expect("a row");
        if (&row[0], &row[3], &row[5]) != ("column.txt", "left", "right") {
            continue;
        }
        let pair = &run["pairs"][0];
        let (quantity, value) = (&row[7], row[8].parse::<f64>().ok());
        let nested = quantity.split_once('_').filter(|_| pair[quantity].is_null());
        let field = nested.map_or(&pair[quantity], |(of, name)| &pair[of][name]);
        assert_eq!(field.as_f64(), value, "{quantity}");
        compared += 1;
    }
    let measured = PairQuantity::ALL.iter().filter(|one| one.about().kind != QuantityKind::Model);
    assert_eq!(compared, measured.count(), "numbers of a pair");
}

#[test]
fn reference_advice_as_json() {
    let folder = folder("advice_json");
    let records = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies/records");
    let record = records.join("el-centro-1940-ns-chopra.csv");
    fs::copy(record, folder.join("record.csv")).expect("a file");
    let scene = TOWERS.replace(
        "file = \"records/column.txt\", unit = \"cm_per_s2\", time_step_s = 0.02",
        "file = \"record.csv\"",
    );
    fs::write(folder.join("towers.toml"), scene).expect("a file");
    let advice = json(&folder, &["advise", "towers.toml", "--accuracy", "1%", "--json"]);
    let text = pounding(&folder, &["advise", "towers.toml", "--accuracy", "1%"]).stdout;
    let name = advice["use"]["name"].as_str().expect("a name");
    assert!(text.starts_with(&format!("Use       {name}")), "{text}");
    let error = advice["use"]["error"].as_f64().expect("a number");
    assert!(error <= 0.01, "{error}");
    assert_eq!(advice["goal"]["quantity"], "all");
    assert_snapshot!(names(&advice));
}

#[test]
fn reference_laws_as_json() {
    let laws = json(Path::new("."), &["laws", "--json"]);
    let text = pounding(Path::new("."), &["laws"]).stdout;
    let listed: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("Law       ")).collect();
    let all = laws["laws"].as_array().expect("a list");
    let found: Vec<&str> = all.iter().filter_map(|law| law["name"].as_str()).collect();
    assert_eq!(found, listed);
    assert_snapshot!(names(&laws));
}

/// `--json` and `--csv` of certificates work as in the other commands.
#[test]
fn limit_certificates_by_either_option() {
    let asked = [
        "certify",
        "hertz_damp",
        "--restitution",
        "0.65",
        "--masses",
        "75e3",
        "3e6",
        "--speed",
        "0.3",
    ];
    let certify = |more: &[&str]| pounding(Path::new("."), &[&asked[..], more].concat());
    for format in ["json", "csv"] {
        let short = certify(&[&format!("--{format}")]);
        assert_eq!((short.code, short.stderr.as_str()), (0, ""));
        assert_eq!(short.stdout, certify(&["--format", format]).stdout);
    }
    assert_eq!(certify(&["--json", "--csv"]).code, 2);
    assert_eq!(certify(&["--json", "--format", "csv"]).code, 2);
}
