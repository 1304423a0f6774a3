//! Worked examples of A. K. Chopra, *Dynamics of Structures*, and closed forms for a single structure.

use pounding_solver::{Elastic, Excitation, Histories, Integrator, Node, Row};

use crate::common::{AVERAGE, CENTRAL, LINEAR, METHODS, clock, histories};
use crate::watch::Watch;

/// The structure of Examples 5.2 to 5.4: 0.2533 kip·s²/in, 10 kip/in, ζ = 5 %.
const MASS: f64 = 0.2533;

fn example() -> Row<Elastic> {
    Row::new(vec![Node::structure(MASS, 0.1592, Elastic { stiffness: 10.0 })], vec![]).expect("the row is valid")
}

/// The half-cycle sine load of 10 kip and 0.6 s as a ground acceleration.
fn load(time_step: f64) -> Vec<f64> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let n = (0.6 / time_step).round() as usize;
    (0..=n)
        .map(|i| -10.0 / MASS * libm::sin(std::f64::consts::PI * i as f64 / n as f64))
        .collect()
}

/// Displacements at 0, 0.1, … 1.0 s \[in\].
fn displacements(method: Integrator, time_step: f64) -> Vec<f64> {
    let samples = load(time_step);
    let mut histories = Histories::new(1, 0.1, 1.0);
    let excitation = Excitation::new(time_step, &samples).expect("the load is finite");
    method
        .watch(&example(), excitation, clock(time_step, 1.0), &mut histories)
        .expect("the run ends");
    histories.of(0).states.iter().map(|state| state.displacement).collect()
}

fn assert_close(found: &[f64], printed: &[f64], allowed: f64) {
    assert_eq!(found.len(), printed.len(), "one value every 0.1 s");
    for (i, (found, printed)) in found.iter().zip(printed).enumerate() {
        assert!((found - printed).abs() <= allowed, "{i}: {found} against {printed}");
    }
}

/// Half a unit of the fourth decimal, twice, because the book rounds its steps, too.
const PRINTED: f64 = 1.5e-4;

#[test]
fn reference_chopra_example_5_2_central_difference() {
    let printed = [0.0, 0.0, 0.1914, 0.6293, 1.1825, 1.5808, 1.5411, 0.9140, -0.0247, -0.8968, -1.3725];
    assert_close(&displacements(CENTRAL, 0.1), &printed, PRINTED);
}

#[test]
fn reference_chopra_example_5_3_average_acceleration() {
    let printed = [
        0.0, 0.0437, 0.2326, 0.6121, 1.0825, 1.4309, 1.4231, 0.9622, 0.1908, -0.6044, -1.1442,
    ];
    assert_close(&displacements(AVERAGE, 0.1), &printed, PRINTED);
}

#[test]
fn reference_chopra_example_5_4_linear_acceleration() {
    let printed = [
        0.0, 0.0300, 0.2193, 0.6166, 1.1130, 1.4782, 1.4625, 0.9514, 0.1273, -0.6954, -1.2208,
    ];
    assert_close(&displacements(LINEAR, 0.1), &printed, PRINTED);
}

#[test]
fn reference_chopra_example_5_2_theoretical_solution() {
    let printed = [
        0.0, 0.0328, 0.2332, 0.6487, 1.1605, 1.5241, 1.4813, 0.9245, 0.0593, -0.7751, -1.2717,
    ];
    for (_, method) in METHODS {
        assert_close(&displacements(method, 1e-4), &printed, PRINTED);
    }
}

/// Displacement at `time` of a structure that starts from (u₀, v₀) under a constant ground acceleration.
fn step_response(node: &Node<Elastic>, ground: f64, time: f64) -> f64 {
    let (omega2, decay) = (node.column.stiffness * node.inverse_mass, 0.5 * node.damping * node.inverse_mass);
    let frequency = (omega2 - decay * decay).sqrt();
    let rest = -ground / omega2;
    let a = node.initial_displacement - rest;
    let b = (node.initial_velocity + decay * a) / frequency;
    rest + libm::exp(-decay * time) * (a * libm::cos(frequency * time) + b * libm::sin(frequency * time))
}

#[test]
fn reference_free_vibration_and_a_suddenly_applied_load() {
    for damping in [0.0, 4e4] {
        for ground in [0.0, 2.0] {
            let node = Node {
                initial_displacement: 0.02,
                initial_velocity: -0.3,
                ..Node::structure(75e3, damping, Elastic { stiffness: 2.056e6 })
            };
            let row = Row::new(vec![node], vec![]).unwrap();
            for (name, method) in METHODS {
                let (histories, _) = histories(&row, method, &[ground; 501], clock(1e-4, 5.0));
                for (i, state) in histories.of(0).states.iter().enumerate() {
                    let exact = step_response(&node, ground, 1e-4 * i as f64);
                    let error = (state.displacement - exact).abs();
                    assert!(error < 1e-6, "{name}, c = {damping}, step {i}: {error:e}");
                }
            }
        }
    }
}
