//! Gravity on leaning storeys: cases with closed forms in `tests/reach`, and every method against the exact one.

use std::path::Path;

use pounding_scene::{FloorQuantity, Scene, Simulation};
use pounding_solver::{Elastic, Hysteretic, OnRow, Row, Storey, modes};
use serde_json::Value;

use crate::beside::{case, number, prepared};

/// One storey of 3 m, elastic-perfectly plastic, that starts with a velocity and has θ = P/(k h).
fn storey(inputs: &Value, velocity: f64) -> String {
    let of = |name: &str| number(inputs, name);
    let omega = std::f64::consts::TAU / of("T_s");
    let stiffness = of("m_kg") * omega * omega;
    format!(
        r#"
name = "leaning"
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
duration_s = 12
structures = [{{ sdof = {{ name = "a", mass_kg = {}, stiffness_n_per_m = {stiffness:e}, damping.ratio = 0, height_m = 3,
  yield_displacement_m = {}, gravity_load_n = {:e}, initial_velocity_m_per_s = {velocity:e} }} }}]
"#,
        of("m_kg"),
        of("uy_m"),
        of("theta") * stiffness * 3.0
    )
}

/// From rest it collapses above the velocity of the case, and turns below.
#[test]
fn reference_the_velocity_above_which_a_storey_collapses() {
    let (inputs, expected) = case("p-delta.json");
    let of = |name: &str| number(&expected, name);
    let drift = |factor: f64| {
        let simulation = prepared(&storey(&inputs, factor * of("critical_velocity")));
        simulation.run(None).map(|run| run.peaks.of(0).displacement.value)
    };
    let below = drift(1.0 - 1e-9).expect("it turns");
    assert!(below < of("unstable_equilibrium_m"), "{below:?}");
    let above = drift(1.0 + 1e-9).expect("it falls, and the run ends there");
    assert!((above / 0.6 - 1.0).abs() < 1e-9, "{above}");
    // The columns never give more than they bear; the ground gets less.
    let simulation = prepared(&storey(&inputs, 0.9 * of("critical_velocity")));
    let run = simulation.run(None).expect("it runs");
    let values = run.values(&simulation);
    let shear = values.of(FloorQuantity::PeakShearForceN, 0).expect("it moves");
    let columns = simulation.floors().all()[0].made_of.expect("a structure").columns;
    assert!((shear / columns.yield_force_n.expect("it yields") - 1.0).abs() < 1e-9, "{shear}");
    assert!(run.peaks.of(0).restoring_force.value < 0.95 * shear);
}

/// The period with gravity is that of k − P/h.
#[test]
fn reference_the_period_under_gravity() {
    let (inputs, expected) = case("p-delta.json");
    // So slow that nothing yields: half a period later it passes its rest again.
    let simulation = prepared(&storey(&inputs, 1e-3));
    let run = simulation.run(Some(0.001)).expect("it runs");
    let histories = run.histories.as_ref().expect("asked for");
    let states = &histories.of(0).states;
    let crossing = (1..states.len())
        .find(|row| states[*row].displacement <= 0.0)
        .expect("it swings back");
    let [before, after] = [crossing - 1, crossing].map(|row| states[row].displacement);
    let half = 0.001 * (crossing as f64 - 1.0 + before / (before - after));
    assert!(
        (2.0 * half / number(&expected, "period_with_gravity_s") - 1.0).abs() < 1e-6,
        "{half}"
    );
}

/// The stiffness of every column of a row, with its mass.
struct Columns;

impl OnRow for Columns {
    type Output = Vec<Storey<Elastic>>;

    fn on<Column: Hysteretic>(self, row: &Row<Column>) -> Self::Output {
        let storey = |node: &pounding_solver::Node<Column>| Storey {
            mass: 1.0 / node.inverse_mass,
            damping: 0.0,
            ground_damping: 0.0,
            column: Elastic {
                stiffness: node.column.stiffness(),
            },
        };
        row.nodes().iter().map(storey).collect()
    }
}

#[test]
fn reference_two_storeys_under_gravity() {
    let (inputs, expected) = case("p-delta.json");
    let two = &inputs["two_storeys"];
    let list = |name: &str| -> Vec<f64> { serde_json::from_value(two[name].clone()).expect("numbers") };
    let (masses, stiffnesses, axial) = (list("masses"), list("stiffnesses"), list("axial"));
    let storey = |index: usize| {
        let above = axial.get(index + 1).copied().unwrap_or(0.0);
        format!(
            "{{ mass_kg = {:e}, stiffness_n_per_m = {:e}, height_m = {}, gravity_load_n = {:e} }}",
            masses[index],
            stiffnesses[index],
            number(two, "h"),
            axial[index] - above
        )
    };
    let text = format!(
        "name = \"two\"\nrecord.generated.ricker = {{ amplitude_m_per_s2 = 1, frequency_hz = 1, time_step_s = 0.01 }}\n\
         structures = [{{ building = {{ name = \"a\", damping.ratio = 0, storeys = [{}, {}] }} }}]\n",
        storey(0),
        storey(1)
    );
    let storeys = prepared(&text).on_row(Columns);
    let wanted: Vec<f64> = serde_json::from_value(expected["two_storeys_with_rad_s"].clone()).expect("numbers");
    for (mode, wanted) in modes(&storeys).expect("modes").iter().zip(wanted) {
        let found = mode.oscillation().angular_frequency;
        assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
    }
}

/// Every stepping method tends to the exact motion under gravity, with columns that lose more than they gain in yielding.
#[test]
fn order_every_method_under_gravity() {
    let text = |method: &str| {
        format!(
            r#"
name = "two"
p_delta = "from_masses"
duration_s = 6
{method}
record.generated.ricker = {{ amplitude_m_per_s2 = 4, frequency_hz = 1, time_step_s = 0.01 }}
structures = [
  {{ building = {{ name = "a", period_s = 0.8, damping.ratio = 0.05, storeys = [{{ mass_kg = 2e5, height_m = 3, repeat = 3, yield_drift_ratio = 0.003 }}] }} }},
  {{ building = {{ name = "b", period_s = 0.5, damping.ratio = 0.05, storeys = [{{ mass_kg = 2e5, height_m = 3, repeat = 2, yield_drift_ratio = 0.003, hardening_ratio = 0.02 }}] }} }},
]
contacts = [{{ gap_m = 0.02, law.linear_spring.impact_stiffness_n_per_m = 1e8 }}]
"#
        )
    };
    let peaks = |text: &str| {
        let simulation = prepared(text);
        let run = simulation.run(None).expect("it runs");
        let floors = 0..simulation.floors().all().len();
        floors.map(|floor| run.peaks.of(floor).displacement.value).collect::<Vec<f64>>()
    };
    let exact = peaks(&text(""));
    for method in [
        "newmark = { beta = 0.25, gamma = 0.5, time_step_s =",
        "central_difference = { time_step_s =",
        "hht = { alpha = -0.05, time_step_s =",
        "velocity_verlet = { time_step_s =",
        "rk4 = { time_step_s =",
    ] {
        let off = |step: f64| {
            let found = peaks(&text(&format!("method.{method} {step} }}")));
            let off = found.iter().zip(&exact).map(|(found, exact)| (found / exact - 1.0).abs());
            off.fold(0.0, f64::max)
        };
        let [coarse, fine] = [2e-3, 2.5e-4].map(off);
        assert!(fine < 2e-3 && fine < 0.5 * coarse, "{method}: {coarse} {fine}");
    }
    // Without gravity the drifts are smaller.
    let without = peaks(&text("").replace("p_delta = \"from_masses\"", ""));
    assert!(exact[0].abs() > without[0].abs(), "{exact:?} {without:?}");
}

/// A storey without height has no P-Δ, and a weight above k h brings a building down before it is shaken.
#[test]
fn extreme_weights_that_are_refused() {
    let (inputs, _) = case("p-delta.json");
    let text = storey(&inputs, 0.1);
    let refused = |text: &str| {
        let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml")).expect("a scene");
        Simulation::new(&scene, "").expect_err("it is refused").to_string()
    };
    insta::assert_snapshot!(refused(&text.replace("height_m = 3,", "")), @r#"scene "leaning": structures[0].sdof.height_m: found none, under a weight that acts on the leaning storey, allowed is the height of the storey; without it leave out p_delta and gravity_load_n"#);
    insta::assert_snapshot!(refused(&text.replace("height_m = 3,", "height_m = 0.1,")), @r#"scene "leaning": structures[0].sdof: found P/(k h) = 2.400 for a weight of 5922 kN, allowed less than 1: the elastic building stands under its weight; a stiffer storey, or a smaller gravity_load_n"#);
}
