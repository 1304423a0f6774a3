//! Errors beside results, and advice for an accuracy.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use serde_json::{Value, json};

use crate::{EXAMPLE, Ended, folder, good_scene, pounding, quiet, refusal, run};

const HERE: &str = env!("CARGO_MANIFEST_DIR");

fn printed(ended: &Ended) -> &str {
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "a good run");
    let widest = ended.stdout.lines().map(|line| line.chars().count()).max();
    assert!(widest <= Some(80), "at most 80 columns:\n{}", ended.stdout);
    &ended.stdout
}

/// Two elastic structures that move at the start under a record at rest, five seconds.
fn small_scene(method: &Value) -> Value {
    let mut scene = good_scene();
    scene["structures"][0]["sdof"]["initial_velocity_m_per_s"] = json!(0.5);
    scene["structures"][0]["sdof"]["yield_force_n"] = Value::Null;
    scene["duration_s"] = json!(5.0);
    scene["method"] = method.clone();
    scene
}

fn paragraph<'a>(stdout: &'a str, label: &str) -> Vec<&'a str> {
    let lines = stdout.lines().skip_while(|line| !line.starts_with(label));
    lines.take_while(|line| !line.is_empty()).collect()
}

#[test]
fn limit_without_errors_the_numbers_are_the_same() {
    let with = pounding(Path::new(HERE), &["run", EXAMPLE]).stdout;
    let without = pounding(Path::new(HERE), &["run", EXAMPLE, "--no-error"]).stdout;
    assert_eq!(
        paragraph(&without, "Errors"),
        ["Errors    not measured (--no-error)"]
    );
    let numbers = |text: &str, begin: &str| {
        let line = text.lines().find(|line| line.starts_with(begin));
        let words = line.expect("the line is there").split_whitespace();
        words.map(String::from).collect::<Vec<_>>()
    };
    for begin in ["weak ", "stiff ", "weak – stiff", "Method"] {
        assert_eq!(numbers(&with, begin), numbers(&without, begin), "{begin}");
    }
}

#[test]
fn limit_the_exact_method_has_no_error() {
    let scene = small_scene(&json!({"exact": {}}));
    let ended = run("exact_error", &scene.to_string(), Some(&quiet(10)));
    assert_eq!(
        paragraph(printed(&ended), "Errors"),
        ["Errors    none beyond rounding: the method is exact"]
    );
    let scene = small_scene(&json!({"exact": {"tolerance": 1e-6}}));
    let ended = run("coarse_error", &scene.to_string(), Some(&quiet(10)));
    assert_snapshot!(paragraph(printed(&ended), "Errors").join("\n"));
}

#[test]
fn order_errors_fall_with_the_time_step() {
    let largest = |time_step: f64| -> f64 {
        let scene = small_scene(
            &json!({"newmark": {"time_step_s": time_step, "beta": 0.25, "gamma": 0.5}}),
        );
        let ended = run("order", &scene.to_string(), Some(&quiet(10)));
        let errors = paragraph(printed(&ended), "Errors").join(" ");
        let number = errors.split("the largest is ").nth(1).expect("a number");
        let number = number.split(' ').next().expect("a number");
        number.parse().expect("a number")
    };
    let (coarse, fine) = (largest(0.001), largest(0.0001));
    assert!(10.0 * fine < 2.0 * coarse, "{coarse} % and {fine} %");
}

#[test]
fn reference_advice_on_the_example() {
    let advice = pounding(Path::new(HERE), &["advise", EXAMPLE, "--error", "1%"]);
    assert_snapshot!(printed(&advice));
    let same = pounding(Path::new(HERE), &["advise", EXAMPLE, "--error", "0.01"]);
    assert_eq!(advice.stdout, same.stdout, "1% is 0.01");
}

/// What is pasted into the scene is accepted, and what an accuracy chooses.
#[test]
fn limit_an_accuracy_chooses_what_is_advised() {
    let folder = folder("advised");
    let scene = small_scene(&json!({"accuracy": 0.3}));
    fs::write(folder.join("scene.json"), scene.to_string()).expect("the scene can be written");
    fs::write(folder.join("record.csv"), quiet(10)).expect("the record can be written");
    let advice = pounding(&folder, &["advise", "scene.json", "--error", "30%"]);
    let snippet = paragraph(printed(&advice), "  \"method\"").join("");
    let pasted: Value = serde_json::from_str(&format!("{{{snippet}}}")).expect("JSON");
    let chosen = pounding(&folder, &["run", "scene.json"]);
    let named = pasted["method"]
        .as_object()
        .expect("a method")
        .keys()
        .next();
    let name = named.expect("its name").replace('_', " ");
    let method = paragraph(printed(&chosen), "Method").join("\n");
    assert!(method.starts_with(&format!("Method    {name}")), "{method}");
    assert!(method.contains("chosen: "), "{method}");
    let scene = small_scene(&pasted["method"]);
    let same = run("pasted", &scene.to_string(), Some(&quiet(10)));
    assert_eq!(
        paragraph(printed(&same), "Work"),
        paragraph(printed(&chosen), "Work")
    );
}

#[test]
fn extreme_accuracy_out_of_range() {
    let scene = small_scene(&json!({"accuracy": 1.0}));
    let ended = run("accuracy", &scene.to_string(), Some(&quiet(10)));
    assert_snapshot!(refusal(&ended));
    for error in ["0", "1", "100%", "-1%", "inf", "NaN", "much"] {
        let error = format!("--error={error}");
        let ended = pounding(Path::new(HERE), &["advise", EXAMPLE, &error]);
        assert_eq!((ended.code, ended.stdout.as_str()), (2, ""), "{error}");
        assert!(ended.stderr.contains("such as 0.01 or 1%"), "{error}");
    }
}
