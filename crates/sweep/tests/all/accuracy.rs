//! Sweeps whose scene requests an accuracy: the chosen method, and the reported errors.

use pounding_scene::Method;
use pounding_sweep::Sweep;
use pounding_text::RefusalKind;
use serde_json::{Value, json};

use crate::{STOPPED, folder, read, scene, sweep, table};

/// Three hundred periods of the left structure in a scene.
fn with_periods(scene: &Value) -> Value {
    json!({
        "scene": scene,
        "vary": [{"field": "structures[0].sdof.period_s", "log_uniform": {"from": 0.3, "to": 1.5}}],
        "samples": {"count": 300, "seed": 1, "method": "sobol"},
        "outputs": {"structures": ["peak_displacement_m"], "pairs": ["total_impulse_n_s"]},
        "verdict": false,
    })
}

/// An accuracy chooses a method that one could write by hand, and measures it.
#[test]
fn reference_an_accuracy_chooses_a_method_and_measures_it() {
    let folder = folder("accuracy");
    let words = |method: Value| {
        let mut scene = scene();
        scene["method"] = method;
        with_periods(&scene)
    };
    let chosen = sweep(&folder, &words(json!({"accuracy": 0.02})));
    let accuracy = chosen.accuracy().expect("it was asked for");
    assert_eq!(accuracy.method.name(), "central_difference");
    assert_eq!((accuracy.columns.len(), accuracy.rows.runs), (3, 128));
    assert!(accuracy.within > 0.8, "{accuracy:?}");
    let by_hand = sweep(&folder, &words(json!(accuracy.method)));
    assert_eq!(table(&chosen, 0..300), table(&by_hand, 0..300));
    // Exact runs of all rows give the same part within the error.
    let exact = table(&sweep(&folder, &words(json!("exact"))), 0..300);
    let numbers = |row: &[String]| {
        let numbers = row[4..7].iter().map(|field| field.parse().unwrap_or(f64::NAN));
        numbers.collect::<Vec<f64>>()
    };
    let within = |(a, b): &(&Vec<String>, &Vec<String>)| {
        let (a, b) = (numbers(a), numbers(b));
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 0.02 * a.abs().max(b.abs());
        a.iter().zip(&b).all(near)
    };
    let rows = table(&by_hand, 0..300);
    let within = rows.iter().zip(&exact).filter(within).count() as f64 / 300.0;
    assert!((within - accuracy.within).abs() < 0.08, "{within} {accuracy:?}");
    // No step of the ladder is this accurate, and columns that yield run alone.
    let exact = sweep(&folder, &words(json!({"accuracy": 1e-7})));
    let accuracy = exact.accuracy().expect("it was asked for");
    assert_eq!(accuracy.method.name(), "exact");
    assert_eq!(accuracy.rows.largest.to_bits(), 0.0_f64.to_bits());
}

/// Impacts at the ends of steps need such short steps that the exact method costs less.
#[test]
fn reference_impacts_are_left_to_the_exact_method() {
    let folder = folder("accuracy_impacts");
    let words = |method: Value| {
        let mut scene = scene();
        scene["contacts"][0]["law"] = json!({"stereomechanical": {"restitution": 0.6}});
        scene["method"] = method;
        with_periods(&scene)
    };
    let chosen = sweep(&folder, &words(json!({"accuracy": 0.002})));
    let accuracy = chosen.accuracy().expect("it was asked for");
    assert_eq!(accuracy.method.name(), "exact");
    // Shaken in two directions, the rows are those of runs alone.
    let mut both = words(json!({"central_difference": {"time_step_s": 0.005}}));
    both["directions"] = json!("both");
    let beside = sweep(&folder, &both);
    assert_eq!(beside.batch(0..600).beside, 600);
    both["outputs"]["pairs"] = json!(["total_impulse_n_s", "first_start_s"]);
    let alone = sweep(&folder, &both);
    assert_eq!(alone.batch(0..600).beside, 0);
    let numbers = |sweep: &Sweep| {
        let rows = table(sweep, 0..600).into_iter();
        rows.map(|row| row[..7].to_vec()).collect::<Vec<_>>()
    };
    assert_eq!(numbers(&beside), numbers(&alone));
}

/// If no step is accurate enough, elastic structures run in lanes by the exact method.
#[test]
fn reference_a_fine_accuracy_is_met_side_by_side() {
    let folder = folder("accuracy_beside");
    let chosen = |accuracy: f64| {
        let mut scene = scene();
        let left = &mut scene["structures"][0]["sdof"];
        let fields = left.as_object_mut().expect("an object");
        fields.remove("yield_displacement_m");
        scene["method"] = json!({"accuracy": accuracy});
        sweep(&folder, &with_periods(&scene))
    };
    let flown = chosen(1e-7);
    let accuracy = flown.accuracy().expect("it was asked for");
    let tolerance = json!({"exact": {"tolerance": 1e-7 * 0.1}});
    let wanted: Method = serde_json::from_value(tolerance).expect("a method");
    assert_eq!(accuracy.method, wanted);
    let [_, _, p95, _] = accuracy.rows.quantiles;
    assert!(p95 < 1e-7 && accuracy.rows.largest > 0.0, "{accuracy:?}");
    // Results of a run do not depend on the other runs in lanes.
    let batch = flown.batch(0..300);
    assert!(batch.beside > 290, "{}", batch.beside);
    assert_eq!(table(&flown, 0..300)[131..150], table(&flown, 131..150));
    // Only the exact method alone is this accurate.
    let alone = chosen(1e-15);
    let accuracy = alone.accuracy().expect("it was asked for");
    assert_eq!(accuracy.method, Method::EXACT);
    assert_eq!(accuracy.rows.largest.to_bits(), 0.0_f64.to_bits());
}

#[test]
fn extreme_a_method_that_is_chosen_does_not_vary() {
    let folder = folder("accuracy_varies");
    let mut scene = scene();
    scene["method"] = json!({"accuracy": 0.02});
    let words = json!({
        "scene": scene,
        "vary": [{"field": "method.accuracy", "values": [0.01, 0.02]}],
    });
    let refused = read(&folder, &words, None).expect_err("there is one method");
    let text = refused.to_string();
    assert!(text.contains("asks for an accuracy"), "{text}");
}

/// A stop while a method was chosen ended the program silently.
#[test]
fn issue_a_stop_while_a_method_is_chosen_is_told() {
    let mut scene = scene();
    scene["method"] = json!({"accuracy": 0.02});
    let words = with_periods(&scene);
    let refused = read(&folder("accuracy_stopped"), &words, Some(&STOPPED));
    let refused = refused.expect_err("somebody said stop");
    assert!(refused.is_kind(RefusalKind::Stopped), "{refused}");
}

/// The chosen steps cost more than exact runs, after a search that cost even more. If there are fewer runs than measure a method, only the
/// exact method is useful.
#[test]
fn issue_the_exact_method_is_chosen_where_it_costs_less() {
    let folder = folder("accuracy_prices");
    let chosen = |count: u64| {
        let mut scene = scene();
        let left = &mut scene["structures"][0]["sdof"];
        let fields = left.as_object_mut().expect("an object");
        fields.remove("yield_displacement_m");
        scene["contacts"][0]["law"] = json!({"stereomechanical": {"restitution": 0.6}});
        scene["duration_s"] = json!(20.0);
        scene["record"]["generated"]["half_sine"]["time_step_s"] = json!(0.02);
        scene["method"] = json!({"accuracy": 1e-3});
        let mut words = with_periods(&scene);
        words["samples"]["count"] = json!(count);
        let sweep = sweep(&folder, &words);
        let accuracy = sweep.accuracy().expect("it was asked for").clone();
        (accuracy.method, accuracy.rows.runs)
    };
    // Elastic structures with impacts run exactly as fast as with steps of some milliseconds.
    for count in [190, 300] {
        assert_eq!(chosen(count), (Method::EXACT, 0));
    }
}
