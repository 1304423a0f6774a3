//! Tests of errors beside results, and of advice for an accuracy.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

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
    let with = pounding(Path::new(HERE), &["run", EXAMPLE, "--details"]).stdout;
    let without = pounding(Path::new(HERE), &["run", EXAMPLE, "--no-error", "--details"]).stdout;
    assert_eq!(paragraph(&without, "Errors"), ["Errors    not measured (--no-error)"]);
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
        let scene = small_scene(&json!({"newmark": {"time_step_s": time_step, "beta": 0.25, "gamma": 0.5}}));
        let ended = run("order", &scene.to_string(), Some(&quiet(10)));
        let errors = paragraph(printed(&ended), "Errors").join(" ");
        let number = errors.split("the largest is ").nth(1).expect("a number");
        let number = number.split_whitespace().next().expect("a number");
        number.parse().expect("a number")
    };
    let (coarse, fine) = (largest(0.001), largest(0.0001));
    assert!(10.0 * fine < 2.0 * coarse, "{coarse} % and {fine} %");
}

#[test]
fn reference_advice_on_the_example() {
    let advice = pounding(Path::new(HERE), &["advise", EXAMPLE, "--accuracy", "1%"]);
    assert_snapshot!(printed(&advice));
    let same = pounding(Path::new(HERE), &["advise", EXAMPLE, "--accuracy", "0.01"]);
    assert_eq!(advice.stdout, same.stdout, "1% is 0.01");
}

/// A scene accepts the advised method, and an accuracy in the scene chooses that method.
#[test]
fn limit_an_accuracy_chooses_what_is_advised() {
    let folder = folder("advised");
    let scene = small_scene(&json!({"accuracy": 0.3}));
    fs::write(folder.join("scene.json"), scene.to_string()).expect("the scene can be written");
    fs::write(folder.join("record.csv"), quiet(10)).expect("the record can be written");
    let advice = pounding(&folder, &["advise", "scene.json", "--accuracy", "30%"]);
    let snippet = paragraph(printed(&advice), "  \"method\"").join("");
    let pasted: Value = serde_json::from_str(&format!("{{{snippet}}}")).expect("JSON");
    let chosen = pounding(&folder, &["run", "scene.json", "--details"]);
    let named = pasted["method"].as_object().expect("a method").keys().next();
    let name = named.expect("its name").replace('_', " ");
    let method = paragraph(printed(&chosen), "Method").join("\n");
    assert!(method.starts_with(&format!("Method    {name}")), "{method}");
    assert!(method.contains("chosen: "), "{method}");
    let scene = small_scene(&pasted["method"]);
    let same = run("pasted", &scene.to_string(), Some(&quiet(10)));
    assert_eq!(paragraph(printed(&same), "Work"), paragraph(printed(&chosen), "Work"));
}

/// The example with another method.
fn example_with(method: &Value) -> Value {
    let text = fs::read_to_string(EXAMPLE).expect("the example is there");
    let mut scene: Value = serde_json::from_str(&text).expect("the example is JSON");
    scene["method"] = method.clone();
    scene
}

/// A folder with a scene, `scene.json`, and the record of the example.
fn folder_of(test: &str, mut scene: Value) -> PathBuf {
    let file = scene["record"]["file"].as_str().expect("a path");
    let record = Path::new(EXAMPLE).with_file_name(file);
    let folder = folder(test);
    fs::copy(record, folder.join("record.csv")).expect("the record can be copied");
    scene["record"]["file"] = json!("record.csv");
    fs::write(folder.join("scene.json"), scene.to_string()).expect("the scene can be written");
    folder
}

/// Runs the example with another method.
fn run_example(test: &str, method: &Value) -> Ended {
    pounding(&folder_of(test, example_with(method)), &["run", "scene.json", "--details"])
}

/// A stepping method wins at a low accuracy. A run with it measures the advised error.
#[test]
fn reference_a_stepping_method_wins() {
    let arguments = ["advise", EXAMPLE, "--accuracy", "10%", "--quantity", "momentum"];
    let advice = pounding(Path::new(HERE), &arguments);
    let advice = printed(&advice);
    assert_snapshot!(advice);
    let snippet = paragraph(advice, "  \"method\"").join("");
    let pasted: Value = serde_json::from_str(&format!("{{{snippet}}}")).expect("JSON");
    assert!(pasted["method"].get("exact").is_none(), "{pasted}");
    let ended = run_example("wins", &pasted["method"]);
    let structures = ended.stdout.lines().skip_while(|line| !line.starts_with("Structure "));
    let error = structures.skip(1).find(|line| line.starts_with("  error"));
    let words: Vec<_> = error.expect("errors").split_whitespace().collect();
    let momentum: f64 = words[words.len() - 2].parse().expect("a number");
    assert!(momentum <= 10.0, "{words:?}");
    let stated = paragraph(advice, "Use").join(" ");
    assert!(stated.contains(&format!("{} % (momentum)", words[words.len() - 2])), "{stated}");
}

#[test]
fn reference_advice_on_each_quantity() {
    let mut uses = String::new();
    for quantity in ["momentum", "displacement", "force", "impulse", "time", "all"] {
        let arguments = ["advise", EXAMPLE, "--accuracy", "10%", "--quantity", quantity];
        let advice = pounding(Path::new(HERE), &arguments);
        let lines = paragraph(printed(&advice), "Use").join("\n");
        writeln!(uses, "{quantity}\n{lines}").expect("a string takes all");
    }
    assert_snapshot!(uses);
}

/// A larger set of quantities never allows a cheaper method.
#[test]
fn limit_all_quantities_cost_no_less_than_one() {
    let cost = |quantity: &str| -> u64 {
        let arguments = ["advise", EXAMPLE, "--accuracy", "5%", "--quantity", quantity];
        let advice = pounding(Path::new(HERE), &arguments);
        let text = paragraph(printed(&advice), "Use").join(" ");
        let number = text.split("cost ").nth(1).expect("the cost");
        let digits: String = number.chars().take_while(char::is_ascii_digit).collect();
        digits.parse().expect("a number")
    };
    let all = cost("all");
    for quantity in ["momentum", "force", "time"] {
        assert!(cost(quantity) <= all, "{quantity}");
    }
}

#[test]
fn extreme_advice_without_an_exact_run() {
    // Contact elements so stiff that their force overflows.
    let mut scene = example_with(&json!({"accuracy": 0.01}));
    let law = &mut scene["contacts"][0]["law"]["nonlinear_viscoelastic"];
    law["impact_stiffness_n_per_m1_5"] = json!(1e300);
    let folder = folder_of("no_exact", scene);
    let ended = pounding(&folder, &["run", "scene.json", "--details"]);
    assert_snapshot!(refusal(&ended));
    let advice = pounding(&folder, &["advise", "scene.json", "--accuracy", "1%"]);
    assert_eq!(refusal(&advice), refusal(&ended));
}

/// With a step of 0.05 s the weak structure penetrates deep into the stiff one and is thrown back with added energy.
#[test]
fn extreme_a_run_that_creates_energy_is_refused() {
    let steps = json!({"central_difference": {"time_step_s": 0.05}});
    assert_snapshot!(refusal(&run_example("creates", &steps)));
}

#[test]
fn extreme_accuracy_out_of_range() {
    let scene = small_scene(&json!({"accuracy": 1.0}));
    let ended = run("accuracy", &scene.to_string(), Some(&quiet(10)));
    assert_snapshot!(refusal(&ended));
    for error in ["0", "1", "100%", "-1%", "inf", "NaN", "much"] {
        let error = format!("--accuracy={error}");
        let ended = pounding(Path::new(HERE), &["advise", EXAMPLE, &error]);
        assert_eq!((ended.code, ended.stdout.as_str()), (2, ""), "{error}");
        assert!(ended.stderr.contains("such as 0.01 or 1%"), "{error}");
    }
}
