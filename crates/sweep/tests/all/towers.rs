//! Sweeps of buildings of several storeys.

use serde_json::{Value, json};

use crate::{folder, sweep, table};

/// Two towers of storeys that yield, which touch at three levels, and what is asked of them.
fn words(outputs: &Value) -> Value {
    let tower = |name: &str, period: f64, storeys: usize| {
        let storey = json!({
            "mass_kg": 2e5, "height_m": 3.5, "yield_displacement_m": 0.004, "hardening_ratio": 0.05, "repeat": storeys,
        });
        json!({"building": {"name": name, "period_s": period, "damping": {"ratio": 0.05}, "storeys": [storey]}})
    };
    let law = json!({"nonlinear_viscoelastic": {"impact_stiffness_n_per_m1_5": 2.75e9, "restitution": 0.65}});
    json!({
        "scene": {
            "name": "two towers",
            "record": {"generated": {"harmonic": {"amplitude_m_per_s2": 3.0, "frequency_hz": 1.6, "duration_s": 3.0, "time_step_s": 0.01}}},
            "structures": [tower("tall", 0.7, 4), tower("low", 0.4, 3)],
            "contacts": [{"gap_m": 0.01, "law": law}],
            "method": {"central_difference": {"time_step_s": 0.001}},
        },
        "vary": [
            {"field": "contacts[0].gap_m", "uniform": {"from": 0.001, "to": 0.02}},
            {"field": "structures[0].building.period_s", "uniform": {"from": 0.5, "to": 0.9}},
        ],
        "samples": {"count": 150, "seed": 4, "method": "sobol"},
        "outputs": outputs,
    })
}

/// Side by side they have the digits of their runs alone.
#[test]
fn issue_towers_run_side_by_side() {
    let folder = folder("towers");
    let structures = json!([
        "peak_displacement_m",
        "peak_drift_m",
        "ductility",
        "drift_ratio"
    ]);
    let pairs = ["collisions", "peak_force_n", "total_impulse_n_s"];
    let fast = sweep(
        &folder,
        &words(&json!({"structures": structures, "pairs": pairs})),
    );
    let batch = fast.batch(0..150);
    assert!(batch.beside > 140, "{}", batch.beside);
    assert!(batch.failed.iter().all(Option::is_none));
    let touches = batch.columns.iter().any(|column| column.contains(&3.0));
    assert!(touches, "some gap closes three times");
    // When the first collision begins is not known side by side.
    let asked = [
        "collisions",
        "peak_force_n",
        "total_impulse_n_s",
        "first_start_s",
    ];
    let slow = sweep(
        &folder,
        &words(&json!({"structures": structures, "pairs": asked})),
    );
    assert_eq!(slow.batch(0..150).beside, 0);
    let names = slow.columns();
    let common = |row: Vec<String>| {
        let cells = row.into_iter().zip(&names);
        let common =
            cells.filter(|(_, name)| !name.contains("first_start_s") && *name != "checked");
        common.map(|(cell, _)| cell).collect::<Vec<_>>()
    };
    let alone: Vec<_> = table(&slow, 0..150).into_iter().map(common).collect();
    let checked = fast.columns().iter().position(|name| name == "checked");
    let checked = checked.expect("a column");
    let mut beside = table(&fast, 0..150);
    for row in &mut beside {
        row.remove(checked);
    }
    assert_eq!(beside, alone);
}
