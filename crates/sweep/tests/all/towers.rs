//! Sweeps of buildings of several storeys.

use pounding_scene::Quantity;
use pounding_sweep::Outputs;
use serde_json::{Value, json};

use crate::{folder, read, sweep, table};

/// Two towers of yielding storeys that touch at three levels, with these outputs.
pub(crate) fn words(outputs: &Value) -> Value {
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

/// Towers in lanes have the digits of their runs alone.
#[test]
fn issue_towers_run_side_by_side() {
    let folder = folder("towers");
    let structures = json!(["peak_displacement_m", "peak_drift_m", "ductility", "drift_ratio"]);
    let pairs = ["collisions", "peak_force_n", "total_impulse_n_s"];
    let fast = sweep(&folder, &words(&json!({"structures": structures, "pairs": pairs})));
    let batch = fast.batch(0..150);
    assert!(batch.beside > 140, "{}", batch.beside);
    assert!(batch.failed.iter().all(Option::is_none));
    let touches = batch.columns.iter().any(|column| column.contains(&3.0));
    assert!(touches, "some gap closes three times");
    // Lanes do not know the start of the first collision.
    let asked = ["collisions", "peak_force_n", "total_impulse_n_s", "first_start_s"];
    let slow = sweep(&folder, &words(&json!({"structures": structures, "pairs": asked})));
    assert_eq!(slow.batch(0..150).beside, 0);
    let names = slow.columns();
    let common = |row: Vec<String>| {
        let cells = row.into_iter().zip(&names);
        let common = cells.filter(|(_, name)| !name.contains("first_start_s") && *name != "checked");
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

/// Every number that a sweep can ask for: lanes give those of runs alone, or say that a run alone gives it.
#[test]
fn limit_every_number_of_lanes_is_that_of_a_run_alone() {
    let folder = folder("towers_every_number");
    let (mut known, mut unknown) = (0, 0);
    for quantity in Quantity::all() {
        let name = quantity.about().name;
        let (place, other) = match quantity {
            Quantity::Floor(_) => ("structures", "peak_displacement_time_s"),
            Quantity::Pair(_) => ("pairs", "first_start_s"),
            // This row has no links.
            Quantity::Link(_) => continue,
        };
        if serde_json::from_value::<Outputs>(json!({place: [name]})).is_err() {
            continue;
        }
        let asked = |names: &[&str]| sweep(&folder, &words(&json!({"structures": [], "pairs": [], place: names})));
        let fast = asked(&[name]);
        let found = fast.batch(0..40);
        if found.beside == 0 {
            let said = fast.alone_because().expect("a reason");
            assert!(said.contains(&format!("`{name}`")), "{said}");
            unknown += 1;
            continue;
        }
        let slow = asked(&[name, other]);
        let alone = slow.batch(0..40);
        assert_eq!(alone.beside, 0, "{name}");
        let names = slow.columns();
        // Behind run, record, direction and two fields.
        let wanted = names[5..].iter().zip(&alone.columns).filter(|(column, _)| !column.ends_with(other));
        for ((column, wanted), found) in wanted.zip(&found.columns) {
            let bits = |numbers: &[f64]| numbers.iter().map(|one| one.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(found), bits(wanted), "{column}");
        }
        known += 1;
    }
    assert_eq!((known, unknown), (10, 12));
}

/// The severest value over the floors of a building, and over the levels of two neighbours; in lanes and alone.
#[test]
fn reference_whole_buildings_have_the_severest_of_their_floors() {
    let folder = folder("whole_towers");
    let outputs = |last: &str| {
        json!({
            "structures": ["peak_displacement_m", "peak_drift_m", "ductility"], "buildings": ["peak_drift_m", "ductility"],
            "pairs": ["collisions", "peak_force_n", "least_opening_m", last],
            "neighbours": ["collisions", "peak_force_n", "least_opening_m", last],
        })
    };
    for (last, beside) in [("total_impulse_n_s", true), ("first_start_s", false)] {
        let sweep = sweep(&folder, &words(&outputs(last)));
        let (batch, names) = (sweep.batch(0..150), sweep.columns());
        assert_eq!(batch.beside > 140, beside, "{last}");
        // The drift of the storey on the ground is the displacement of its floor.
        let is_lowest = |name: &str| name.contains("floor 1: ");
        // After run, record, direction and two fields.
        let named: Vec<_> = names[5..].iter().zip(&batch.columns).collect();
        let mut compared = 0;
        for (whole, found) in named.iter().filter(|(name, _)| name.contains("(any ")) {
            let (of, quantity) = whole.split_once(": ").expect("a quantity");
            let of = of.split_once(" (any").expect("what it is of").0;
            let ends: Vec<_> = of.split(" - ").collect();
            let is_part = |name: &str| {
                let parts: Vec<_> = name.split(": ").next().unwrap_or("").split(" - ").collect();
                let quantity = match quantity {
                    "peak_drift_m" if is_lowest(name) => "peak_displacement_m",
                    other => other,
                };
                name.ends_with(&format!(": {quantity}"))
                    && !name.contains("(any ")
                    && parts.len() == ends.len()
                    && parts.iter().zip(&ends).all(|(part, end)| part.starts_with(end))
            };
            let parts: Vec<_> = named.iter().filter(|(name, _)| is_part(name)).collect();
            assert_eq!(parts.len(), if of == "tall" { 4 } else { 3 }, "{whole}");
            for (run, found) in found.iter().enumerate() {
                let numbers = parts.iter().map(|(_, column)| column[run]);
                let numbers: Vec<_> = numbers.filter(|number| !number.is_nan()).collect();
                let severest = match quantity {
                    "least_opening_m" | "first_start_s" => numbers.into_iter().reduce(f64::min),
                    _ => numbers
                        .into_iter()
                        .reduce(|one, other| if other.abs() > one.abs() { other } else { one }),
                };
                let severest = severest.unwrap_or(f64::NAN);
                assert_eq!(found.to_bits(), severest.to_bits(), "{whole}, run {run}");
                compared += usize::from(!found.is_nan());
            }
        }
        assert!(compared > 900, "{compared} numbers of {last}");
    }
}

/// An equal total number of floors, distributed differently over buildings, is another row: its columns would have wrong names.
#[test]
fn issue_floors_of_another_building_are_another_row() {
    let mut words = words(&json!({}));
    let turned = |storeys: [usize; 2]| {
        let mut both = words["scene"]["structures"].clone();
        for (one, number) in storeys.into_iter().enumerate() {
            both[one]["building"]["storeys"][0]["repeat"] = json!(number);
        }
        both
    };
    let values = [turned([4, 3]), turned([3, 4])];
    words["vary"] = json!([{"field": "structures", "values": values}]);
    words.as_object_mut().expect("words").remove("samples");
    let refused = read(&folder("other_rows"), &words, None).expect_err("another row");
    let text = refused.to_string();
    assert!(
        text.contains("the row has 3 + 4 floors and walls and 3 pairs, where the first run has 4 + 3"),
        "{text}"
    );
}

/// Runs with alternating contact laws and time steps share lanes by kind, with the bits of runs alone.
#[test]
fn issue_kinds_that_alternate_go_side_by_side() {
    let folder = folder("alternating");
    let laws = json!([
        {"stereomechanical": {"restitution": 0.6}},
        {"nonlinear_viscoelastic": {"impact_stiffness_n_per_m1_5": 2.75e9, "restitution": 0.65}},
        {"linear_spring": {"impact_stiffness_n_per_m": 1e8}},
    ]);
    let steps = json!([{"time_step_s": 0.001}, {"time_step_s": 0.0005}]);
    let alternating = |last: &str| {
        let mut words = words(&json!({
            "structures": ["peak_displacement_m", "peak_drift_m"],
            "pairs": ["collisions", "total_impulse_n_s", "least_opening_m", last],
        }));
        words["vary"] = json!([
            {"field": "contacts[0].gap_m", "grid": {"from": 0.001, "to": 0.02, "count": 10}},
            {"field": "contacts[0].law", "values": laws},
            {"field": "method.central_difference", "values": steps},
        ]);
        words.as_object_mut().expect("words").remove("samples");
        sweep(&folder, &words)
    };
    let [fast, slow] = ["largest_impulse_n_s", "touching_s"].map(alternating);
    let [beside, alone] = [&fast, &slow].map(|sweep| sweep.batch(0..60));
    // A floor that goes equally far to both sides needs a run alone.
    assert!(beside.beside > 56, "{}", beside.beside);
    assert_eq!(alone.beside, 0);
    let names = fast.columns();
    let mut touches = 0;
    for (column, (one, other)) in beside.columns.iter().zip(&alone.columns).enumerate() {
        let name = &names[6 + column];
        if name.ends_with("largest_impulse_n_s") {
            touches += one.iter().filter(|impulse| **impulse > 0.0).count();
            continue;
        }
        let bits = |numbers: &[f64]| numbers.iter().map(|one| one.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(one), bits(other), "{name}");
    }
    assert!(touches > 60, "{touches} pairs touch");
}
