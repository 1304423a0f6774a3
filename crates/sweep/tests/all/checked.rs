//! Checks of the laws of mechanics for rows.

use pounding_sweep::Checked;
use serde_json::{Value, json};

use crate::{folder, scene, sweep, table};

/// Gaps of a scene by a method, with further words in the sweep file.
fn words(method: &Value, more: &Value) -> Value {
    let mut scene = scene();
    scene["method"] = method.clone();
    if method.get("exact").is_some() {
        let left = &mut scene["structures"][0]["sdof"];
        let fields = left.as_object_mut().expect("an object");
        fields.remove("yield_displacement_m");
    }
    let mut words = json!({
        "scene": scene,
        "vary": [{"field": "contacts[0].gap_m", "uniform": {"from": 0.001, "to": 0.02}}],
        "samples": {"count": 700, "seed": 4, "method": "sobol"},
    });
    for (name, value) in more.as_object().expect("an object") {
        words[name] = value.clone();
    }
    words
}

/// Default settings give the rows of the settings for speed: in lanes, with a sample that also runs alone.
#[test]
fn issue_a_sweep_is_fast_without_a_word() {
    let folder = folder("checked");
    let all = json!({
        "verdict": false,
        "outputs": {
            "structures": ["peak_displacement_m"],
            "pairs": ["collisions", "peak_force_n", "total_impulse_n_s"],
        },
    });
    for method in [json!({"central_difference": {"time_step_s": 0.002}}), json!({"exact": {}})] {
        let plain = sweep(&folder, &words(&method, &json!({})));
        let batch = plain.batch(0..700);
        assert!(batch.beside > 690, "{method}: {}", batch.beside);
        assert!(batch.failed.iter().all(Option::is_none), "{method}");
        let count = |wanted: Checked| {
            let all = batch.checked.iter();
            all.filter(|checked| **checked == wanted).count()
        };
        assert!((1..20).contains(&count(Checked::Both)), "{method}");
        assert_eq!(count(Checked::No), 0, "{method}");
        let fast = sweep(&folder, &words(&method, &all));
        let number_of = |row: &Vec<String>| row[..row.len() - 2].to_vec();
        let [plain, fast] = [plain, fast].map(|sweep| table(&sweep, 0..700));
        let names: Vec<_> = plain.iter().map(|row| row[row.len() - 2].as_str()).collect();
        assert!(names.contains(&"beside") && names.contains(&"both"), "{method}");
        assert!(fast.iter().all(|row| row[row.len() - 2].is_empty()));
        let numbers = |rows: &[Vec<String>]| rows.iter().map(number_of).collect::<Vec<_>>();
        assert_eq!(numbers(&plain), numbers(&fast), "{method}");
    }
}

/// Laws broken by coarse steps are reported with the reason, whether all runs run alone or not.
#[test]
fn issue_a_row_that_breaks_a_law_is_refused_side_by_side() {
    let folder = folder("checked_refused");
    let coarse = json!({"central_difference": {"time_step_s": 0.005}});
    let failed = |more: &Value| {
        let mut words = words(&coarse, more);
        let structure =
            |name: &str, period: f64| json!({"sdof": {"name": name, "mass_kg": 1e5, "period_s": period, "damping": {"ratio": 0.05}}});
        let shaking = json!({"amplitude_m_per_s2": 4.0, "frequency_hz": 1.75, "duration_s": 3.0, "time_step_s": 0.01});
        let scene = &mut words["scene"];
        scene["record"] = json!({"generated": {"harmonic": shaking}});
        scene["structures"] = json!([structure("left", 0.7), structure("right", 0.4)]);
        // A step is longer than a fifth of the contact's period.
        scene["contacts"][0]["law"]["linear_spring"]["impact_stiffness_n_per_m"] = json!(5e9);
        let batch = sweep(&folder, &words).batch(0..700);
        (batch.failed, batch.beside)
    };
    let (alone, none) = failed(&json!({"outputs": {"pairs": ["first_start_s"]}}));
    let (together, beside) = failed(&json!({}));
    assert_eq!(none, 0);
    let refused = alone.iter().flatten().count();
    assert!(beside > 0 && refused > 0, "{beside} side by side, {refused} refused");
    assert_eq!(alone, together);
}

/// The initial motion of a heavy structure dominates the ground motion: the tolerance in its momentum is large relative to a small impulse,
/// which is no fault.
#[test]
fn issue_what_the_tolerance_leaves_of_a_small_impulse_is_no_fault() {
    let harmonic = json!({"amplitude_m_per_s2": 9.6, "frequency_hz": 1.0, "duration_s": 12.0, "time_step_s": 0.0025});
    let structure = json!({"sdof": {
        "name": "pile", "mass_kg": 5.7e5, "period_s": 0.071, "damping": {"ratio": 0.3},
        "initial_velocity_m_per_s": -0.3, "initial_displacement_m": -0.07,
    }});
    let law = json!({"hertz_damp": {"impact_stiffness_n_per_m1_5": 2e7, "restitution": 0.9}});
    let words = json!({
        "scene": {
            "name": "pile beside a wall",
            "record": {"generated": {"harmonic": harmonic}},
            "structures": [structure, {"wall": {}}],
            "contacts": [{"gap_m": 0.01, "law": law}],
            "method": {"exact": {"tolerance": 1e-12}},
        },
        "vary": [{"field": "contacts[0].gap_m", "values": [0.019]}],
    });
    let batch = sweep(&folder("checked_tolerance"), &words).batch(0..1);
    assert_eq!(batch.failed, [None]);
    assert_eq!(batch.checked, [Checked::Both]);
}
