//! Runs under separate ground motions.

use std::fmt::Write as _;
use std::fs;

use pounding_sweep::Sweep;
use serde_json::{Value, json};

use crate::{folder, scene, sweep};

/// Numbers of pairs that lanes know.
const PAIRS: [&str; 5] = [
    "collisions",
    "peak_force_n",
    "total_impulse_n_s",
    "largest_impulse_n_s",
    "least_opening_m",
];

/// Three scales of two records in both directions, for two gaps each. One record has a longer time step, and ends earlier.
fn words(method: &Value, yields: bool, structures: &[&str]) -> Value {
    let mut scene = scene();
    scene["method"] = method.clone();
    if !yields {
        let left = scene["structures"][0]["sdof"].as_object_mut();
        left.expect("a structure").remove("yield_displacement_m");
    }
    json!({
        "scene": scene,
        "records": ["fine.csv", "coarse.csv"],
        "directions": "both",
        "vary": [
            {"field": "record.scale", "values": [0.5, 1.0, 1.7]},
            {"field": "contacts[0].gap_m", "values": [0.004, 0.013]},
        ],
        "outputs": {"structures": structures, "pairs": PAIRS},
    })
}

fn both(name: &str, method: &Value, yields: bool) -> [Sweep; 2] {
    let folder = folder(name);
    for (name, step, n) in [("fine.csv", 0.01, 300), ("coarse.csv", 0.02, 90)] {
        let mut text = String::from("time_s,acceleration_m_per_s2\n");
        for index in 0..n {
            let time = step * f64::from(index);
            // A pulse to one side and one to the other, every 0.9 s.
            let phase = time / 0.9 % 1.0;
            let acceleration = 60.0 * phase * (0.5 - phase) * (1.0 - phase);
            writeln!(text, "{time:.2},{acceleration:.6}").expect("a line");
        }
        fs::write(folder.join(name), text).expect("a record");
    }
    let beside = ["peak_displacement_m", "ductility"];
    // Lanes do not know the time of a peak.
    let alone = ["peak_displacement_m", "ductility", "peak_displacement_time_s"];
    [&beside[..], &alone[..]].map(|structures| sweep(&folder, &words(method, yields, structures)))
}

/// Numbers of all rows, without the columns of runs alone, and the number of runs in lanes.
fn numbers(sweep: &Sweep) -> (Vec<f64>, usize) {
    let batch = sweep.batch(0..sweep.n_runs());
    assert_eq!(batch.failed, vec![None; 24], "no run fails");
    let names = sweep.columns();
    let of_columns = names.iter().skip_while(|name| !name.contains("peak_displacement_m"));
    let columns = of_columns.zip(&batch.columns);
    let common = columns.filter(|(name, _)| !name.contains("time_s"));
    let numbers: Vec<_> = common.flat_map(|(_, column)| column.iter().copied()).collect();
    assert_eq!(numbers.len(), 9 * 24, "two numbers of each structure, five of the pair");
    (numbers, batch.beside)
}

#[test]
fn limit_stepping_runs_with_motions_of_their_own_have_the_bits_of_runs_alone() {
    let method = json!({"central_difference": {"time_step_s": 0.002}});
    let [together, alone] = both("own-cd", &method, true).map(|sweep| numbers(&sweep));
    assert_eq!([together.1, alone.1], [24, 0]);
    let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
    assert_eq!(bits(together.0), bits(alone.0));
}

#[test]
fn reference_exact_runs_with_motions_of_their_own_are_those_alone() {
    let [together, alone] = both("own-exact", &json!({"exact": {}}), false).map(|sweep| numbers(&sweep));
    assert_eq!([together.1, alone.1], [24, 0]);
    for (one, other) in together.0.iter().zip(&alone.0) {
        // Openings are differences of centimetres.
        let apart = (one - other).abs() / other.abs().max(1e-2);
        assert!(one.is_nan() && other.is_nan() || apart < 1e-9, "{one:e} {other:e}");
    }
    let touches = alone.0.iter().filter(|number| **number > 1e4).count();
    assert!(touches > 12, "{touches} forces");
}

/// A batch of several shapes was refused as a whole: its runs ran alone.
#[test]
fn issue_kinds_of_laws_that_alternate_go_side_by_side() {
    let folder = folder("alternate");
    let laws = json!([
        {"linear_spring": {"impact_stiffness_n_per_m": 1e8}},
        {"stereomechanical": {"restitution": 0.6}},
    ]);
    let mut towards = scene();
    towards["record"]["generated"]["half_sine"]["amplitude_m_per_s2"] = json!(-4.0);
    let words = |pairs: &[&str]| {
        json!({
            "scene": towards,
            "vary": [
                {"field": "contacts[0].gap_m", "values": [0.004, 0.008, 0.012]},
                {"field": "contacts[0].law", "values": laws},
            ],
            "outputs": {"structures": [], "pairs": pairs},
        })
    };
    let [together, alone] = [
        &["collisions", "total_impulse_n_s"][..],
        &["collisions", "total_impulse_n_s", "touching_s"],
    ]
    .map(|pairs| sweep(&folder, &words(pairs)).batch(0..6));
    assert_eq!([together.beside, alone.beside], [6, 0]);
    assert_eq!(together.columns, alone.columns[..2], "the same bits");
    assert!(together.columns[0].iter().all(|count| *count > 0.0), "all touch");
}
