//! Words of damping that follows the tangent stiffness.

use std::path::Path;

use pounding_scene::{Scene, Simulation};
use pounding_solver::AnyRow;

use crate::beside::prepared;

/// A building of two storeys and a structure, with these words for damping, columns and method.
fn scene([damping, yields, method]: [&str; 3]) -> String {
    format!(
        r#"
name = "softening"
record.generated.half_sine = {{ amplitude_m_per_s2 = 3, duration_s = 0.4, time_step_s = 0.01 }}
duration_s = 2
{method}
structures = [
  {{ building = {{ name = "a", damping.{damping}, storeys = [
    {{ mass_kg = 2e5, stiffness_n_per_m = 4e7, yield_displacement_m = 0.006, hardening_ratio = 0.1, height_m = 3 }},
    {{ mass_kg = 1e5, stiffness_n_per_m = 3e7, {yields} height_m = 3 }},
  ] }} }},
  {{ sdof = {{ name = "b", mass_kg = 75e3, stiffness_n_per_m = 2e6, yield_displacement_m = 0.02, damping.rayleigh = {{ alpha_per_s = 0.3, beta_s = 0.01, stiffness = "tangent" }} }} }},
]
"#
    )
}

const MODES: &str = r#"modes = { modes = [1, 2], ratios = [0.05, 0.05], stiffness = "tangent" }"#;

#[test]
fn reference_what_yielding_takes_of_the_damping() {
    let simulation = prepared(&scene([MODES, "", ""]));
    let AnyRow::Bilinear(row) = simulation.row() else {
        panic!("it yields");
    };
    let near = |found: f64, wanted: f64| assert!((found - wanted).abs() <= 1e-12 * wanted, "{found} {wanted}");
    // Nodes level by level: the first floor, the structure, the second floor, which never yields.
    let [first, structure, second] = [0, 1, 2].map(|node| row.nodes()[node]);
    near(structure.elastic_damping, 0.01 * 2e6);
    near(structure.damping, 0.3 * 75e3 + 0.01 * 2e6);
    near(second.elastic_damping, 0.0);
    let beta = second.damping / 3e7;
    near(first.elastic_damping, beta * 0.9 * 4e7);
    let initial = prepared(&scene([&MODES.replace("tangent", "initial"), "", ""]));
    let AnyRow::Bilinear(row) = initial.row() else {
        panic!("it yields");
    };
    assert!(row.nodes()[0].elastic_damping.abs() < 1e-300, "{:?}", row.nodes()[0]);
}

#[test]
fn extreme_tangent_damping_that_is_refused() {
    let refused = |words: [&str; 3]| {
        Scene::parse(scene(words).as_bytes(), Path::new("scene.toml"))
            .and_then(|scene| Simulation::new(&scene, ""))
            .expect_err("it is refused")
            .to_string()
    };
    let bends = "yield_displacement_m = 0.01, bouc_wen.exponent = 2,";
    let all = [
        [MODES, "", "method.central_difference.time_step_s = 0.001"],
        ["ratio = 0.05", "", "method.hht = { time_step_s = 0.001, alpha = -0.1 }"],
        [MODES, bends, ""],
        [r#"rayleigh = { alpha_per_s = 0.1, beta_s = 0.01, stiffness = "secant" }"#, "", ""],
        [r#"ratio = { stiffness = "tangent" }"#, "", ""],
    ];
    insta::assert_snapshot!(all.map(refused).join("\n"), @r#"
    scene "softening": structures[0].building.damping.modes.stiffness: found tangent, under the method central_difference, which keeps its damping, allowed initial; exact, newmark and rk4 take tangent, of columns with one yield point
    scene "softening": structures[1].sdof.damping.rayleigh.stiffness: found tangent, under the method hht, which keeps its damping, allowed initial; exact, newmark and rk4 take tangent, of columns with one yield point
    scene "softening": structures[0].building.damping.modes.stiffness: found tangent, beside Bouc–Wen columns, whose tangent never jumps, allowed initial; exact, newmark and rk4 take tangent, of columns with one yield point
    scene.toml, line 7, column 97: structures[0].building.damping.rayleigh.stiffness: found `secant`, allowed are `initial`, `tangent`
    scene.toml, line 7, column 46: structures[0].building.damping.ratio: found a table, allowed is a number
    "#);
    for method in [
        "newmark = { time_step_s = 0.001, beta = 0.25, gamma = 0.5 }",
        "rk4.time_step_s = 0.001",
    ] {
        prepared(&scene([MODES, "", &format!("method.{method}")]));
    }
}
