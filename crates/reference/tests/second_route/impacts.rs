//! Impacts of free masses.

use libm::{acos, acosh, exp, pow};
use pounding_reference::Collision;
use pounding_solver::{Node, Row};

use super::{FREE, close, moving, pairs, run, stereomechanical, viscoelastic};

/// A free impact of two masses 1 cm apart at a relative speed: the collision and both final velocities.
fn free_impact(ratio: f64, masses: [f64; 2], speed: f64) -> (Collision, [f64; 2]) {
    let nodes = vec![moving(masses[0], speed, FREE), moving(masses[1], 0.0, FREE)];
    let row = Row::new(nodes, pairs(2, 0.01, viscoelastic(ratio))).expect("a valid row");
    let response = run(&row, &[0.0], 0.01 / speed + 2.0);
    assert_eq!(response.collisions[0].len(), 1, "one collision");
    let velocity = |index: usize| response.structures[index].end_velocity;
    (response.collisions[0][0], [velocity(0), velocity(1)])
}

#[test]
fn reference_free_viscoelastic_impact() {
    for (ratio, speed) in [(0.0, 0.3), (0.1, 0.01), (0.35, 0.3), (0.8, 1.0), (1.5, 2.0)] {
        let zeta = 2.0 * ratio / 5.0_f64.sqrt();
        let arc = if zeta < 1.0 {
            acos(zeta) / (1.0 - zeta * zeta).sqrt()
        } else {
            acosh(zeta) / (zeta * zeta - 1.0).sqrt()
        };
        let restitution = exp(-zeta * arc);
        for masses in [[75e3, 3e6], [3e6, 75e3], [1e5, 1e5]] {
            let mass = masses[0] * masses[1] / (masses[0] + masses[1]);
            let (collision, [left, right]) = free_impact(ratio, masses, speed);
            close(right - left, restitution * speed, 1e-14, "restitution");
            let impulse = mass * (1.0 + restitution) * speed;
            close(collision.impulse, impulse, 1e-14, "impulse");
            close(masses[1] * right, impulse, 1e-14, "momentum of the right mass");
            close(collision.start, 0.01 / speed, 1e-14, "first touch");
        }
    }
}

#[test]
fn reference_largest_deformation_of_a_free_impact() {
    // At the largest deformation of the return, the spring holds all energy of the restitution: 2/5 β δ^2.5 = ½ m (e v)².
    for (ratio, speed) in [(0.0, 0.3), (0.35, 0.3), (0.35, 2.0)] {
        let nodes = vec![moving(75e3, speed, FREE), Node::wall(FREE)];
        let row = Row::new(nodes, pairs(2, 0.01, viscoelastic(ratio))).unwrap();
        // The end is before the mass returns to its start, 1 cm on the other side of the gap.
        let response = run(&row, &[0.0], 0.01 / speed + 0.06);
        let zeta = 2.0 * ratio / 5.0_f64.sqrt();
        let returned = exp(-zeta * acos(zeta) / (1.0 - zeta * zeta).sqrt()) * speed;
        let deformation = pow(5.0 * 75e3 * returned * returned / (4.0 * 2.75e9), 0.4);
        let found = response.structures[0].displacement.value - 0.01;
        close(found, deformation, 1e-14, "largest deformation");
        if ratio == 0.0 {
            let peak = 2.75e9 * deformation * deformation.sqrt();
            let found = response.collisions[0][0].peak_force.unwrap();
            close(found, peak, 1e-14, "peak force");
        }
    }
}

#[test]
fn reference_three_equal_masses_in_a_row() {
    // The two masses on the right touch at rest: the simultaneous rule gives (−1/3, 2/3, 2/3).
    let nodes = vec![moving(2.0, 1.0, FREE), moving(2.0, 0.0, FREE), moving(2.0, 0.0, FREE)];
    let mut contacts = pairs(3, 0.5, stereomechanical(1.0));
    contacts[1].relation.offset = 0.0;
    let response = run(&Row::new(nodes, contacts).unwrap(), &[0.0], 1.0);
    for (structure, third) in response.structures.iter().zip([-1.0, 2.0, 2.0]) {
        close(structure.end_velocity, third / 3.0, 1e-15, "velocity");
    }
    let count = |pair: usize| response.collisions[pair].len();
    assert_eq!([count(0), count(1)], [1, 1], "one impact of each pair");
    close(response.structures[1].transferred_momentum, 4.0 / 3.0, 1e-15, "net impulse");
}

#[test]
fn reference_a_light_mass_hit_from_both_sides_at_once() {
    for law in [stereomechanical(0.7), viscoelastic(0.35)] {
        let nodes = vec![moving(3e6, 0.5, FREE), moving(75e3, 0.0, FREE), moving(3e6, -0.5, FREE)];
        let response = run(&Row::new(nodes, pairs(3, 0.05, law)).unwrap(), &[0.0], 0.6);
        let [left, middle, right] = response.structures.as_slice() else {
            panic!("three structures");
        };
        let [of_left, of_right] = [&response.collisions[0], &response.collisions[1]];
        assert_eq!(of_left.len(), of_right.len(), "as often from either side");
        for (one, other) in of_left.iter().zip(of_right) {
            close(one.start, other.start, 1e-14, "touch from either side");
            close(one.impulse, other.impulse, 1e-12, "impulse from either side");
        }
        close(left.end_velocity, -right.end_velocity, 1e-13, "mirror image");
        assert!(middle.end_velocity.abs() < 1e-12, "{}", middle.end_velocity);
        let scale = left.transferred_momentum;
        assert!(middle.transferred_momentum < 1e-11 * scale, "{middle:?}");
    }
}
