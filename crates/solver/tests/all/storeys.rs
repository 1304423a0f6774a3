//! Buildings of several storeys, by every method that supports them.

use pounding_contact::{ContactLaw, LinearSpring};
use pounding_solver::{Clock, Elastic, Excitation, Histories, Integrator, Pair, Rk4};

use crate::towers::{Rayleigh, row, uniform};
use crate::watch::Watch;

/// Undamped shear building of equal storeys: ω = 2 √(k/m) sin((2j − 1) π / (4n + 2)) in mode j; Chopra, *Dynamics of
/// Structures*, 12.8 gives five storeys.
#[test]
fn reference_rk4_vibrates_in_the_first_mode_of_five_storeys() {
    let (mass, stiffness) = (1e5, 5e7);
    let column = Elastic { stiffness };
    let damping = Rayleigh { alpha: 0.0, beta: 0.0 };
    let (row, levels) = row(&[uniform(5, mass, column)], damping, |_, _, _| None);
    let omega: f64 = 2.0 * (stiffness / mass).sqrt() * libm::sin(std::f64::consts::PI / 22.0);
    let shape: Vec<f64> = (1..=5)
        .map(|storey| libm::sin(f64::from(storey) * std::f64::consts::PI / 11.0))
        .collect();
    let nodes = row.nodes().iter().zip(&shape).map(|(node, shape)| pounding_solver::Node {
        initial_displacement: 0.01 * shape,
        ..*node
    });
    let row = pounding_solver::Row::new(nodes.collect(), vec![]).expect("a valid row");
    let ground = [0.0, 0.0];
    let excitation = Excitation::new(1.0, &ground).expect("a valid excitation");
    let clock = Clock {
        time_step: 1e-3,
        n_steps: 2000,
    };
    let mut histories = Histories::new(5, 0.1, 2.0);
    Integrator::Rk4(Rk4).watch(&row, excitation, clock, &mut histories).expect("a run");
    for (index, node) in levels.of(0).iter().enumerate() {
        for (n, state) in histories.of(*node).states.iter().enumerate() {
            let wanted = 0.01 * shape[index] * libm::cos(omega * 0.1 * n as f64);
            assert!(
                (state.displacement - wanted).abs() < 1e-8,
                "storey {index}, {n}: {} {wanted}",
                state.displacement
            );
        }
    }
}

/// Floors of two towers that meet push only each other.
#[test]
fn limit_floors_face_their_neighbours() {
    let column = Elastic { stiffness: 5e7 };
    let law = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: 1e8 });
    let damping = Rayleigh { alpha: 0.1, beta: 1e-3 };
    let towers = [uniform(3, 1e5, column), uniform(2, 3e5, column)];
    let (row, levels) = row(&towers, damping, |_, _, [left, right]| {
        Some(Pair::of_floors(left, right, 0.01, law))
    });
    assert_eq!(levels.of(0), [0, 2, 4]);
    assert_eq!(row.pairs().len(), 2);
    assert_eq!(row.above(2), Some(4));
    assert_eq!(row.above(3), None);
}
