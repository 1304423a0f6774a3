//! Tests of the output of runs.

use std::path::Path;

use insta::assert_snapshot;
use serde_json::{Value, json};

use crate::{EXAMPLE, Ended, good_scene, pounding, quiet, run};

/// Folder of the package.
const HERE: &str = env!("CARGO_MANIFEST_DIR");

pub(crate) fn printed(ended: &Ended) -> &str {
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "a good run");
    // A path stays on one line, so that it can be copied.
    let lines = ended.stdout.lines().filter(|line| !line.contains("/records/"));
    let widest = lines.map(|line| line.chars().count()).max();
    assert!(widest <= Some(80), "at most 80 columns:\n{}", ended.stdout);
    &ended.stdout
}

/// Columns of the line that begins with these words.
fn line<'a>(stdout: &'a str, begin: &str) -> Vec<&'a str> {
    let line = stdout.lines().find_map(|line| line.strip_prefix(begin));
    line.unwrap_or_else(|| panic!("no line begins with {begin:?}:\n{stdout}"))
        .split_whitespace()
        .collect()
}

#[test]
fn reference_example() {
    assert_snapshot!(printed(&pounding(Path::new(HERE), &["run", EXAMPLE])));
}

#[test]
fn extreme_wrong_usage() {
    for arguments in [&[] as &[&str], &["run"], &["walk"], &["run", "a", "b"]] {
        let ended = pounding(Path::new(HERE), arguments);
        assert_eq!((ended.code, ended.stdout.as_str()), (2, ""), "{arguments:?}");
        assert!(ended.stderr.contains("Usage: pounding"), "{arguments:?}: {}", ended.stderr);
    }
}

/// Almost no stiffness, no damping and no shaking: only a free impact remains.
fn free(name: &str, mass: f64, velocity: f64) -> Value {
    json!({"sdof": {
        "name": name, "mass_kg": mass, "stiffness_n_per_m": 1e-6, "damping": {"ratio": 0},
        "initial_velocity_m_per_s": velocity
    }})
}

#[test]
fn reference_free_impact() {
    let mut scene = good_scene();
    scene["structures"] = json!([free("one", 1000.0, 2.0), free("other", 3000.0, 0.0)]);
    scene["contacts"] = json!([{"gap_m": 0.125, "law": {"stereomechanical": {"restitution": 0.5}}}]);
    scene["method"] = json!({"newmark": {"time_step_s": 0.01, "beta": 0.25, "gamma": 0.5}});
    scene["duration_s"] = json!(0.5);
    let ended = run("free_impact", &scene.to_string(), Some(&quiet(10)));
    // 2 m/s close 125 mm in 0.0625 s; the method finds the overlap at 0.07 s.
    // (1 + e) · m₁m₂/(m₁ + m₂) · δ̇ = 1.5 · 750 kg · 2 m/s = 2.25 kN·s.
    // By then they overlap by 2 m/s · 0.07 s − 125 mm = 15 mm.
    let pair = ["125", "-15.00", "1", "0.07", "2.250", "impulsive", "–"];
    assert_eq!(line(printed(&ended), "one – other"), pair);
    // After the impact the velocities are −0.25 m/s and 0.75 m/s; the right structure moves 0.43 s · 0.75 m/s until the end.
    let one = line(printed(&ended), "one  ");
    let other = line(printed(&ended), "other");
    assert_eq!((one[2], one[3], one[6]), ("140.0", "0.07", "2.250"));
    assert_eq!((other[2], other[3], other[6]), ("322.5", "0.5", "2.250"));
}

#[test]
fn reference_every_method_runs_and_is_named() {
    let mut scene = good_scene();
    scene["structures"] = json!([free("one", 1000.0, 2.0), free("other", 3000.0, 0.0)]);
    scene["contacts"] = json!([{"gap_m": 0.125, "law": {"stereomechanical": {"restitution": 0.5}}}]);
    scene["duration_s"] = json!(0.5);
    let mut named = Vec::new();
    for method in [
        json!({"central_difference": {"time_step_s": 0.01}}),
        json!({"central_difference": {"time_step_s": 0.01, "contact_substeps": 8}}),
        json!({"newmark": {"time_step_s": 0.01, "beta": 0.25, "gamma": 0.5}}),
        json!({"hht": {"time_step_s": 0.01, "alpha": -0.125}}),
        json!({"velocity_verlet": {"time_step_s": 0.01}}),
        json!({"velocity_verlet": {"time_step_s": 0.01, "impacts": "located"}}),
        json!({"rk4": {"time_step_s": 0.01}}),
        json!({"moreau_jean": {"time_step_s": 0.01, "theta": 0.5}}),
    ] {
        scene["method"] = method;
        let ended = run("every_method", &scene.to_string(), Some(&quiet(10)));
        let stdout = printed(&ended);
        // The impulse is that of the free impact above; only the time of its action differs.
        let pair = line(stdout, "one – other");
        assert_eq!((pair[2], pair[4]), ("1", "2.250"), "{stdout}");
        let paragraph = stdout.lines().skip_while(|line| !line.starts_with("Method"));
        let paragraph: Vec<_> = paragraph.take_while(|line| !line.is_empty()).collect();
        named.push(format!("{}; impact at {} s", paragraph.join("\n"), pair[3]));
    }
    assert_snapshot!(named.join("\n"));
}

#[test]
fn reference_let_go_from_a_displacement() {
    let mut scene = good_scene();
    let structure = |name: &str, yield_force: Value| {
        let mut structure = json!({
            "name": name, "mass_kg": 1000, "stiffness_n_per_m": 1e6, "damping": {"ratio": 0},
            "initial_displacement_m": -0.02
        });
        if !yield_force.is_null() {
            structure["yield_force_n"] = yield_force;
        }
        json!({ "sdof": structure })
    };
    scene["structures"] = json!([structure("elastic", Value::Null), structure("yielding", json!(8000))]);
    scene.as_object_mut().expect("fields").remove("contacts");
    let ended = run("let_go", &scene.to_string(), Some(&quiet(10)));
    // T = 2π√(m/k); 20 mm · 1 MN/m = 20 kN, cut off at 8 kN, which is 8 mm: a ductility of 2.5.
    let stdout = printed(&ended);
    assert_eq!(line(stdout, "elastic"), ["0.1987", "0", "-20.00", "0", "-20.00", "–", "0"]);
    assert_eq!(line(stdout, "yielding"), ["0.1987", "0", "-20.00", "0", "-8.000", "2.500", "0"]);
    assert!(stdout.contains("none: no contact is modelled"), "{stdout}");
}

#[test]
fn extreme_long_names_walls_and_large_numbers() {
    let mut scene = good_scene();
    let long = "the department store with the soft first storey at the corner";
    let mut hit = free(long, 1e12, 2.0);
    hit["sdof"]["stiffness_n_per_m"] = json!(1e15);
    scene["structures"] = json!(["wall", hit, free("a kiosk", 1.0, 0.0), free("a far one", 1.0, 0.0)]);
    let contact = |gap: f64, restitution: f64| json!({"gap_m": gap, "law": {"stereomechanical": {"restitution": restitution}}});
    scene["contacts"] = json!([contact(0.0, 1.0), contact(0.05, 0.5), contact(1e6, 0.0)]);
    scene["duration_s"] = json!(2.0);
    scene["name"] = json!("a ".repeat(60));
    let ended = run("long_names", &scene.to_string(), Some(&quiet(10)));
    assert_snapshot!(printed(&ended));
}

#[test]
fn limit_record_in_either_unit_and_scaled() {
    let scene = good_scene();
    let wave = |values: [f64; 4], unit: &str| {
        let lines = values.iter().zip(0..).map(|(value, index)| format!("0.{index},{value}\n"));
        format!("time_s,acceleration_{unit}\n{}", lines.collect::<String>())
    };
    let in_si = run("in_si", &scene.to_string(), Some(&wave([0.0, 2.0, -4.0, 1.0], "m_per_s2")));
    let mut with_g = scene.clone();
    with_g["record"]["gravity_m_per_s2"] = json!(10);
    with_g["record"]["scale"] = json!(-0.5);
    with_g["record"]["reversed"] = json!(false);
    let in_g = run("in_g", &with_g.to_string(), Some(&wave([0.0, 0.4, -0.8, 0.2], "g")));
    let (in_si, in_g) = (printed(&in_si), printed(&in_g));
    let has = |text: &str, words: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").contains(words);
    let used = "as used: 4 samples, 0.1 s apart, 0.3 s long; peak";
    assert!(has(in_si, &format!("{used} 0.4077 g = 4.000 m/s² at 0.2 s")), "{in_si}");
    assert!(has(in_g, &format!("{used} 0.4000 g = 4.000 m/s² at 0.2 s")), "{in_g}");
    assert_eq!(line(in_si, "weak  "), line(in_g, "weak  "), "the same shaking");
    assert_eq!(line(in_si, "stiff"), line(in_g, "stiff"), "the same shaking");
}

/// Features that a scene does not need cost time and do not change the output.
#[test]
fn limit_the_full_model_prints_the_same() {
    let here = Path::new(HERE);
    for scene in [
        EXAMPLE,
        "../../studies/examples/towers.toml",
        "../../studies/examples/wall-and-neighbour.json",
    ] {
        let numbers = |arguments: &[&str]| {
            let ended = pounding(here, arguments);
            let (numbers, _) = printed(&ended).split_once("\nWork").expect("work");
            numbers.to_string()
        };
        let lean = numbers(&["run", scene, "--details"]);
        assert_eq!(lean, numbers(&["run", scene, "--full", "--details"]), "{scene}");
    }
    // Separate structures then have pairs out of reach, which are not printed.
    let mut scene = good_scene();
    scene.as_object_mut().expect("fields").remove("contacts");
    let folder = crate::folder("full_apart");
    std::fs::write(folder.join("scene.json"), scene.to_string()).expect("written");
    std::fs::write(folder.join("record.csv"), quiet(10)).expect("written");
    let out = pounding(&folder, &["run", "scene.json", "--full", "--out", "out"]);
    assert_eq!((out.code, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.contains("none: no contact is modelled"), "{}", out.stdout);
}

#[test]
fn reference_completions_of_every_shell() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let ended = pounding(Path::new(HERE), &["completions", shell]);
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{shell}");
        for word in ["compare", "overwrite"] {
            assert!(ended.stdout.contains(word), "{shell} knows {word}");
        }
    }
    assert_eq!(pounding(Path::new(HERE), &["completions", "dos"]).code, 2);
}
