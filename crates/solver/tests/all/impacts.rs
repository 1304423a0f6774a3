//! Impacts of several pairs at once, and the instant of an impact in a step.

use crate::common::{LOCATED, METHODS, STEREOMECHANICAL, VERLET, clock, free, histories, pairs};
use crate::watch::Watch;
use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Collisions, Elastic, Excitation, Histories, Integrator, Node, Row};
use proptest::prelude::*;

fn impulsive(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

/// Free masses (mass, velocity) in a row with a gap.
fn side_by_side(masses: &[(f64, f64)], gap: f64, restitutions: &[f64]) -> Row<Elastic> {
    let nodes = masses.iter().map(|(mass, velocity)| free(*mass, *velocity));
    let mut pairs = pairs(masses.len(), gap, STEREOMECHANICAL);
    for (pair, restitution) in pairs.iter_mut().zip(restitutions) {
        pair.law = impulsive(*restitution);
    }
    Row::new(nodes.collect(), pairs).expect("the row is valid")
}

/// Velocities at the end of a run.
fn velocities(row: &Row<Elastic>, method: Integrator, (dt, duration): (f64, f64)) -> Vec<f64> {
    let (histories, _) = histories(row, method, &[0.0], clock(dt, duration));
    (0..row.nodes().len())
        .map(|index| {
            let states = &histories.of(index).states;
            states.last().expect("states were recorded").velocity
        })
        .collect()
}

#[test]
fn reference_a_mass_hit_from_both_sides_is_turned_round() {
    // Both relative velocities are reversed, and the light mass keeps its position.
    for (name, method) in METHODS {
        for restitution in [0.0, 0.65, 1.0] {
            let row = side_by_side(&[(1e6, 0.5), (1e5, 0.0), (1e6, -0.5)], 0.01, &[restitution; 2]);
            let found = velocities(&row, method, (0.0007, 0.07));
            let expected = [-0.5 * restitution, 0.0, 0.5 * restitution];
            for (found, expected) in found.iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{name}, e = {restitution}: {found} against {expected}"
                );
            }
        }
    }
}

#[test]
fn reference_three_equal_masses_in_contact() {
    // The first mass arrives, the others touch already: the simultaneous rule gives (−1/3, 2/3, 2/3); pairs in sequence would give (0, 0,
    // 1).
    for (name, method) in METHODS {
        let mut row = vec![(1.0, 1.0), (1.0, 0.0), (1.0, 0.0)];
        let gaps = side_by_side(&row, 0.0, &[1.0; 2]);
        let found = velocities(&gaps, method, (0.01, 0.1));
        row[0].1 = 0.0;
        for (found, expected) in found.iter().zip([-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]) {
            assert!((found - expected).abs() < 1e-12, "{name}: {found} against {expected}");
        }
    }
}

#[test]
fn reference_a_located_impact_of_free_masses_is_exact() {
    let row = side_by_side(&[(2.0, 0.7), (3.0, 0.0)], 0.01, &[0.4]);
    let instant = 0.01 / 0.7;
    for dt in [0.1, 0.03, 0.0007] {
        let mut recorder = (Histories::new(2, dt, 0.3), Collisions::new(2, row.pairs()));
        let excitation = Excitation::new(1.0, &[0.0]).unwrap();
        LOCATED.watch(&row, excitation, clock(dt, 0.3), &mut recorder).unwrap();
        let (histories, collisions) = recorder;
        let [collision] = collisions.all() else {
            panic!("one impact: {:?}", collisions.all());
        };
        assert!((collision.start - instant).abs() < 1e-16, "{} against {instant}", collision.start);
        let after = 0.7 * (2.0 - 0.4 * 3.0) / 5.0;
        for (step, state) in histories.of(0).states.iter().enumerate() {
            let time = step as f64 * dt;
            let expected = 0.7 * time.min(instant) + after * (time - instant).max(0.0);
            assert!(
                (state.displacement - expected).abs() < 1e-15,
                "{dt} s, step {step}: {} against {expected}",
                state.displacement
            );
        }
    }
}

#[test]
fn reference_a_located_impact_finds_a_touch_between_two_nodes() {
    // Thrown against a wall and pulled back: 2.5 cm after 0.05 s, back home after 0.1 s. Both nodes are outside.
    let node = Node {
        initial_velocity: 1.0,
        ..Node::structure(1.0, 0.0, Elastic { stiffness: 0.0 })
    };
    let wall = Node::wall(Elastic { stiffness: 1.0 });
    let ground = [20.0; 20];
    for (gap, touches) in [(0.024, true), (0.026, false)] {
        let row = Row::new(vec![node, wall], pairs(2, gap, STEREOMECHANICAL)).unwrap();
        let run = |method| histories(&row, method, &ground, clock(0.1, 0.1)).1;
        assert_eq!(run(LOCATED).touching_steps > 0, touches, "gap {gap}");
        assert_eq!(run(VERLET).touching_steps, 0, "gap {gap}");
    }
}

#[test]
fn extreme_a_ball_that_comes_to_rest_ends_the_run() {
    // Pressed against a wall at 10 m/s², the mass bounces ever faster, then sinks in by half of 10 m/s² Δt² per step. The number of steps
    // stays bounded, and the depth is of order one.
    let node = Node::structure(1.0, 0.1, Elastic { stiffness: 1.0 });
    let wall = Node::wall(Elastic { stiffness: 1.0 });
    for restitution in [0.0, 0.5, 1.0] {
        let row = Row::new(vec![node, wall], pairs(2, 0.01, impulsive(restitution))).unwrap();
        for (name, method) in METHODS {
            let (dt, duration) = (1e-3, 4.0);
            let (histories, _) = histories(&row, method, &[-10.0; 500], clock(dt, duration));
            let deepest = histories.of(0).states.iter();
            let deepest = deepest.map(|state| state.displacement - 0.01).fold(0.0, f64::max);
            assert!(deepest < 0.5 * 10.0 * dt * duration, "{name}, e = {restitution}: {deepest}");
        }
    }
}

proptest! {
    #[test]
    fn limit_impacts_keep_momentum_and_never_create_energy(
        masses in prop::collection::vec((1e-3..1e3_f64, -2.0..2.0_f64), 2..7),
        restitutions in prop::array::uniform6(0.0..=1.0_f64),
        method in 0..METHODS.len(),
    ) {
        // All gaps are closed: every approaching pair is hit at once.
        let row = side_by_side(&masses, 0.0, &restitutions);
        let (name, method) = METHODS[method];
        let found = velocities(&row, method, (1e-3, 2e-3));
        let energy = |velocities: &mut dyn Iterator<Item = (f64, f64)>| {
            velocities.map(|(mass, velocity)| 0.5 * mass * velocity * velocity).sum::<f64>()
        };
        let momentum = |velocities: &mut dyn Iterator<Item = (f64, f64)>| {
            velocities.map(|(mass, velocity)| mass * velocity).sum::<f64>()
        };
        let mut after = masses.iter().map(|mass| mass.0).zip(found.iter().copied());
        let (before, after) = (
            (energy(&mut masses.iter().copied()), momentum(&mut masses.iter().copied())),
            (energy(&mut after.clone()), momentum(&mut after)),
        );
        let scale: f64 = masses.iter().map(|(mass, velocity)| mass * velocity.abs()).sum();
        prop_assert!(after.0 <= before.0 * (1.0 + 1e-12), "{name}: energy {} became {}", before.0, after.0);
        prop_assert!((after.1 - before.1).abs() <= 1e-12 * scale, "{name}: momentum {} became {}", before.1, after.1);
    }
}
