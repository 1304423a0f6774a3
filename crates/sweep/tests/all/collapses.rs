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

/// Runs under gravity go side by side with the digits of runs alone; those that collapse run alone, because a collapse ends a run.
#[test]
fn limit_runs_under_gravity_go_side_by_side_until_they_collapse() {
    let run = |name: &str, outputs: &[&str], beside: usize| {
        let mut words = words(&json!({"outputs": {"structures": outputs, "pairs": []}}));
        words["scene"]["method"] = json!({"central_difference": {"time_step_s": 0.005}});
        let sweep = sweep(&folder(name), &words);
        let batch = sweep.batch(RUNS);
        assert_eq!(batch.beside, beside, "{:?}", sweep.alone_because());
        assert!(batch.failed.iter().all(Option::is_none));
        let columns = sweep.columns();
        let of = |wanted: &str| {
            let place = columns.iter().position(|name| name.ends_with(wanted)).expect("a column");
            let rows = table(&sweep, RUNS).into_iter();
            rows.map(move |row| row[place].clone()).collect::<Vec<_>>()
        };
        [of(": peak_displacement_m"), of("collapse_s")]
    };
    let fast = run("leaning-beside", &["peak_displacement_m"], 2);
    let slow = run("leaning-alone", &["peak_displacement_m", "peak_displacement_time_s"], 0);
    assert_eq!(fast, slow);
    assert_eq!(fast[1].iter().filter(|instant| !instant.is_empty()).count(), 3);
}
