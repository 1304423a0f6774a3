//! Sweeps of runs that end in a collapse: these are no failures.

use std::ops::Range;

use serde_json::{Value, json};

use crate::{folder, sweep, table};

/// A storey that leans with θ = 0.08, from rest with a velocity; it collapses above 0.5327 m/s (see `tests/reach/p-delta.json` of the scenes).
fn words(more: &Value) -> Value {
    let omega = std::f64::consts::TAU / 0.8;
    let stiffness = 4e5 * omega * omega;
    let mut words = json!({
        "scene": {
            "name": "leaning",
            "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 0.0, "duration_s": 0.4, "time_step_s": 0.01}}},
            "duration_s": 12.0,
            "structures": [{"sdof": {
                "name": "a", "mass_kg": 4e5, "stiffness_n_per_m": stiffness, "damping": {"ratio": 0.0}, "height_m": 3.0,
                "yield_displacement_m": 0.02, "gravity_load_n": 0.08 * stiffness * 3.0,
            }}],
        },
        "vary": [{"field": "structures[0].sdof.initial_velocity_m_per_s", "values": [0.5, 0.53, 0.54, 0.6, -0.6]}],
        "outputs": {"structures": ["peak_displacement_m"], "pairs": []},
    });
    for (name, value) in more.as_object().expect("an object") {
        words[name] = value.clone();
    }
    words
}

const RUNS: Range<u64> = 0..5;

/// Runs that collapse were rows of failures.
#[test]
fn issue_runs_that_collapse_are_rows_with_the_instant() {
    let sweep = sweep(&folder("collapses"), &words(&json!({})));
    let instant = sweep.columns().iter().position(|name| name == "collapse_s");
    let instant = instant.expect("it is added under gravity");
    let rows = table(&sweep, RUNS);
    let fallen: Vec<bool> = rows.iter().map(|row| !row[instant].is_empty()).collect();
    assert_eq!(fallen, [false, false, true, true, true]);
    assert!(sweep.batch(RUNS).failed.iter().all(Option::is_none));
    // By symmetry, and the sooner the faster.
    assert_eq!(rows[3][instant], rows[4][instant]);
    let time = |row: usize| rows[row][instant].parse::<f64>().expect("a number");
    assert!(time(3) < time(2));
}

/// A summary counts them apart from failed runs.
#[test]
fn issue_a_summary_counts_collapses() {
    let folder = folder("collapses-summed");
    let sweep = sweep(&folder, &words(&json!({"summary": {}})));
    let out = folder.join("summary.csv");
    let parts = crate::opened(&sweep, &out, pounding_sweep::Shard::WHOLE);
    parts.fill(&sweep, &|_| {}).expect("it runs");
    parts.join(pounding_files::Existing::Kept).expect("it joins");
    let text = std::fs::read_to_string(&out).expect("a table");
    let count = |statistic: &str| {
        let line = text.lines().find(|line| line.starts_with(&format!("run,{statistic},")));
        line.map(|line| line.split(',').nth(3).expect("a value").to_owned())
    };
    assert_eq!(count("runs").as_deref(), Some("5"));
    assert_eq!(count("failed").as_deref(), Some("0"));
    assert_eq!(count("collapsed").as_deref(), Some("3"));
}
