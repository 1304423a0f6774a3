//! Isolators in words: cases with closed forms in `tests/reach`.

use std::path::Path;

use pounding_scene::{ExcessKind, Scene, Simulation, Structure};

use crate::beside::{case, number, prepared};

/// A rigid building of 400 t on isolators, let go at a displacement.
fn rigid(isolator: &str, displacement: f64) -> String {
    format!(
        r#"
name = "isolated"
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
duration_s = 8
structures = [{{ building = {{ name = "a", damping.ratio = 0.02, storeys = [
  {{ mass_kg = 4e5, {isolator}, displacement_capacity_m = 0.35, initial_displacement_m = {displacement} }},
] }} }}]
"#
    )
}

fn lowest(simulation: &Simulation) -> pounding_scene::Storey {
    match &simulation.scene().structures[0] {
        Structure::Building(building) => building.storeys[0],
        Structure::Sdof(_) | Structure::Wall => panic!("a building"),
    }
}

#[test]
fn reference_lead_rubber() {
    let (inputs, expected) = case("isolator-lead-rubber.json");
    let of = |name: &str| number(&inputs, name);
    let words = format!(
        "isolator.lead_rubber = {{ strength_n = {}, stiffness_after_n_per_m = {}, yield_displacement_m = {} }}",
        of("Q_n"),
        of("K2_n_per_m"),
        of("Dy_m")
    );
    let simulation = prepared(&rigid(&words, 0.0));
    let storey = lowest(&simulation);
    // Records are compared with spectra up to twice the period on the isolators.
    let mass: f64 = match &simulation.scene().structures[0] {
        Structure::Building(building) => building.storeys.iter().map(|one| one.mass_kg).sum(),
        Structure::Sdof(_) | Structure::Wall => panic!("a building"),
    };
    let wanted = 2.0 * std::f64::consts::PI * (mass / of("K2_n_per_m")).sqrt();
    let longest = simulation.scene().structures[0].longest_period().expect("it moves");
    assert!((longest / wanted - 1.0).abs() < 1e-12, "{longest} {wanted}");
    let found = [
        (storey.columns.stiffness_n_per_m, "K1_n_per_m"),
        (storey.columns.yield_force_n.expect("it yields"), "yield_force_n"),
        (storey.columns.hardening_ratio.expect("it hardens"), "hardening_ratio"),
    ];
    for (found, name) in found {
        assert!((found / number(&expected, name) - 1.0).abs() < 1e-12, "{name}: {found}");
    }
    assert_eq!(storey.capacities.isolation_layer, Some(true));
}

/// Turning points fall by 2µR each half period, and it sticks at 50 mm. Pendulums that slide after a tenth of a millimetre come within a
/// millimetre.
#[test]
fn reference_friction_pendulums_that_stick() {
    let (inputs, expected) = case("isolator-friction-pendulum.json");
    let of = |name: &str| number(&inputs, name);
    let scene = |slides: f64| {
        let words = format!(
            "isolator.friction_pendulum = {{ radius_m = {}, friction = {}, yield_displacement_m = {slides} }}",
            of("R_m"),
            of("mu")
        );
        rigid(&words, of("u0_m"))
    };
    let wanted: Vec<f64> = serde_json::from_value(expected["turning_points_m"].clone()).expect("numbers");
    for (slides, within, at_end) in [(1e-4, 1e-3, 1e-3), (0.0, 2e-6, 1e-14)] {
        let run = prepared(&scene(slides)).run(Some(0.001)).expect("it runs");
        let states = &run.histories.as_ref().expect("asked for").of(0).states;
        let turns = (1..states.len() - 1).filter(|row| states[*row].velocity * states[row - 1].velocity < 0.0);
        let turns: Vec<f64> = turns.map(|row| states[row].displacement).collect();
        for (found, wanted) in turns.iter().zip(&wanted[1..3]) {
            assert!((found - wanted).abs() < within, "{slides}: {found} {wanted}");
        }
        let residual = states[states.len() - 1].displacement;
        assert!((residual - number(&expected, "residual_m")).abs() < at_end, "{slides}: {residual}");
    }
    let simulation = prepared(&scene(0.0));
    let run = simulation.run(None).expect("it runs");
    // The scene that a result keeps, and that sweeps change, is the same scene.
    let kept = serde_json::to_string(simulation.scene()).expect("JSON");
    assert_eq!(prepared(&kept).scene(), simulation.scene());
    let excesses = simulation.excesses(&run);
    let beyond = excesses
        .iter()
        .find(|one| one.kind == ExcessKind::Displacement)
        .expect("0.4 m is too far");
    insta::assert_snapshot!(beyond, @"a, storey 1: displacement of 400.0 mm of its isolators, above their capacity of 350.0 mm: they may tear, stiffen or slide off, which the model leaves out");
}

#[test]
fn extreme_words_of_isolators_that_are_refused() {
    let words = |text: String| {
        Scene::parse(text.as_bytes(), Path::new("scene.toml"))
            .and_then(|scene| Simulation::new(&scene, ""))
            .expect_err("it is refused")
            .to_string()
    };
    let refused = |isolator: &str| words(rigid(isolator, 0.0));
    let sticks = "isolator.friction_pendulum = { radius_m = 2.5, friction = 0.05, yield_displacement_m = 0 }";
    insta::assert_snapshot!(words(format!("method.rk4.time_step_s = 0.001\n{}", rigid(sticks, 0.0))), @r#"scene "isolated": structures[0].building.storeys[0].isolator.friction_pendulum.yield_displacement_m: found 0, under the method rk4, which cannot let isolators stick, allowed a number > 0, or the exact method; leave `method` out: the exact method is the default"#);
    let all = [
        "isolator.friction_pendulum = { radius_m = 2.5, friction = 0.05, yield_displacement_m = -1 }",
        "stiffness_n_per_m = 1e6, friction_n = 1e5",
        "stiffness_n_per_m = 1e6, isolation_layer = true, friction_n = -1e5",
        "stiffness_n_per_m = 1e6, isolation_layer = true, friction_n = 1e5, yield_force_n = 1e5",
        "isolator.rubber.stiffness_n_per_m = 1e6, stiffness_n_per_m = 1e6",
        "stiffness_n_per_m = 1e6, isolator_damping_n_s_per_m = 1e5",
        "isolator.spring.stiffness_n_per_m = 1e6",
    ];
    insta::assert_snapshot!(all.map(refused).join("\n"), @r#"
    scene.toml, line 6, column 84: structures[0].building.storeys[0].isolator.friction_pendulum.yield_displacement_m: found -1, allowed a finite number >= 0
    scene.toml, line 6, column 45: structures[0].building.storeys[0].friction_n: found it without isolators, allowed is it beside isolation_layer = true; isolator.friction_pendulum sets it
    scene "isolated": structures[0].building.storeys[0].friction_n: found -100000, allowed a finite number > 0
    scene.toml, line 6, column 69: structures[0].building.storeys[0].friction_n: found it beside columns that yield, allowed is one of both; friction holds the storey until it slides
    scene.toml, line 6, column 20: structures[0].building.storeys[0].isolator: found isolators beside a stiffness or a yield point of the storey, allowed is one of both; isolators have their own stiffness
    scene.toml, line 6, column 45: structures[0].building.storeys[0].isolator_damping_n_s_per_m: found it without an isolator, allowed is it beside isolator, or beside isolation_layer = true
    scene.toml, line 6, column 29: structures[0].building.storeys[0].isolator: found `spring`, allowed are `lead_rubber`, `friction_pendulum`, `rubber`
    "#);
}

/// Rayleigh damping leaves the isolators out: they keep their own, and the building above has its ratio in its own first mode.
#[test]
fn reference_damping_above_isolators() {
    let text = r#"
name = "isolated"
record.generated.half_sine = { amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }
structures = [{ building = { name = "a", damping.ratio = 0.02, storeys = [
  { mass_kg = 4e5, isolator.rubber.stiffness_n_per_m = 8e6, isolator_damping_n_s_per_m = 1.5e5 },
  { mass_kg = 3e5, stiffness_n_per_m = 3e8, height_m = 3 },
] } }]
"#;
    let simulation = prepared(text);
    let Structure::Building(building) = &simulation.scene().structures[0] else {
        panic!("a building")
    };
    // 2ζ/ω k of one storey that is fixed at its foot: 2ζ √(k m).
    let wanted = 2.0 * 0.02 * (3e8_f64 * 3e5).sqrt();
    let [isolators, above] = building.dampings()[..] else {
        panic!("two storeys")
    };
    assert_eq!(isolators, (1.5e5, 0.0));
    assert!((above.0 / wanted - 1.0).abs() < 1e-12 && above.1 == 0.0, "{above:?}");
}
