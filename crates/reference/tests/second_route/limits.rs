//! Models that must agree, balances that must hold, edges.

use std::sync::atomic::AtomicBool;

use pounding_reference::{Fineness, Response, SecondRouteError};
use pounding_solver::{Bilinear, Elastic, Excitation, Node, Pair, Row};

use super::{FREE, close, moving, pairs, run, stereomechanical, viscoelastic};

const MASSES: [f64; 3] = [75e3, 3e6, 1e5];
const STIFFNESSES: [f64; 3] = [2.056e6, 1.316e9, 4e6];

/// Three undamped structures with gaps of 1 cm and these initial velocities.
fn undamped(law: pounding_contact::ContactLaw) -> Row<Elastic> {
    let node = |index: usize| {
        let stiffness = STIFFNESSES[index];
        moving(MASSES[index], [0.5, 0.2, -0.4][index], Elastic { stiffness })
    };
    Row::new((0..3).map(node).collect(), pairs(3, 0.01, law)).expect("a valid row")
}

fn energy(state: impl Fn(usize) -> (f64, f64)) -> f64 {
    let of = |index: usize| {
        let (displacement, velocity) = state(index);
        MASSES[index] * velocity * velocity + STIFFNESSES[index] * displacement * displacement
    };
    0.5 * (0..3).map(of).sum::<f64>()
}

#[test]
fn limit_energy_is_kept_without_damping() {
    for law in [stereomechanical(1.0), viscoelastic(0.0)] {
        let row = undamped(law);
        let response = run(&row, &[0.0], 5.0);
        let before = energy(|index| (0.0, row.nodes()[index].initial_velocity));
        let after = energy(|index| {
            let structure = &response.structures[index];
            (structure.end_displacement, structure.end_velocity)
        });
        let apart = response.collisions.iter().flatten().all(|collision| collision.end < 5.0);
        let many = response.collisions.iter().all(|pair| pair.len() > 3);
        assert!(many && apart, "pairs collide and stand apart at the end");
        close(after, before, 1e-13, "energy");
    }
}

#[test]
fn limit_momentum_is_kept_by_free_masses() {
    for law in [stereomechanical(0.5), viscoelastic(0.35)] {
        let velocities = [1.0, 0.1, -0.8];
        let node = |index: usize| moving(MASSES[index], velocities[index], FREE);
        let row = Row::new((0..3).map(node).collect(), pairs(3, 0.02, law)).unwrap();
        let response = run(&row, &[0.0], 2.0);
        let impulse = |pair: usize| -> f64 { response.collisions[pair].iter().map(|collision| collision.impulse).sum() };
        let net = [-impulse(0), impulse(0) - impulse(1), impulse(1)];
        for index in 0..3 {
            let gained = MASSES[index] * (response.structures[index].end_velocity - velocities[index]);
            assert!(
                (gained - net[index]).abs() < 1e-14 * MASSES[1],
                "{index}: {gained} against {} N·s",
                net[index]
            );
        }
    }
}

#[test]
fn limit_structures_that_do_not_collide_keep_apart() {
    let node = |initial_velocity| Node {
        initial_velocity,
        ..Node::structure(75e3, 23e3, Elastic { stiffness: 2.056e6 })
    };
    let nodes = vec![node(0.3), node(-0.2)];
    let wide = Row::new(nodes.clone(), pairs(2, 1.0, viscoelastic(0.35))).unwrap();
    let none = Row::new(nodes, vec![]).unwrap();
    let (wide, none) = (run(&wide, &[0.5, 0.0], 3.0), run(&none, &[0.5, 0.0], 3.0));
    for (found, wanted) in wide.structures.iter().zip(&none.structures) {
        close(found.end_displacement, wanted.end_displacement, 1e-13, "displacement");
        close(found.displacement.value, wanted.displacement.value, 1e-13, "peak");
    }
    assert!(wide.collisions[0].is_empty(), "{:?}", wide.collisions);
}

#[test]
fn limit_a_yield_force_never_reached_is_elastic() {
    let elastic = undamped(viscoelastic(0.35));
    let node = |node: &Node<Elastic>| Node {
        inverse_mass: node.inverse_mass,
        damping: node.damping,
        elastic_damping: node.elastic_damping,
        support: node.support,
        initial_displacement: node.initial_displacement,
        initial_velocity: node.initial_velocity,
        column: Bilinear {
            stiffness: node.column.stiffness,
            yield_force: f64::INFINITY,
            hardening: 0.0,
        },
    };
    let nodes = elastic.nodes().iter().map(node).collect();
    let rich = Row::new(nodes, elastic.pairs().to_vec()).unwrap();
    assert_eq!(run(&elastic, &[1.0, 0.0], 2.0), run(&rich, &[1.0, 0.0], 2.0));
}

#[test]
fn limit_a_mirrored_row_mirrors() {
    let column = |index: usize| Bilinear {
        stiffness: STIFFNESSES[index],
        yield_force: 2.0 * MASSES[index],
        hardening: 0.0,
    };
    let node = |index: usize| Node::structure(MASSES[index], 0.7 * MASSES[index], column(index));
    let ground: Vec<f64> = (0..40).map(|i| f64::from(i * 37 % 11 - 5)).collect();
    let reversed: Vec<f64> = ground.iter().map(|sample| -sample).collect();
    for law in [stereomechanical(0.65), viscoelastic(0.35)] {
        let row = Row::new((0..3).map(node).collect(), pairs(3, 0.01, law)).unwrap();
        let mirrored = Row::new((0..3).rev().map(node).collect(), pairs(3, 0.01, law)).unwrap();
        let (there, back) = (run(&row, &ground, 4.0), run(&mirrored, &reversed, 4.0));
        mirror(&there, &back);
    }
}

fn mirror(there: &Response, back: &Response) {
    for (one, other) in there.structures.iter().zip(back.structures.iter().rev()) {
        close(one.displacement.value, -other.displacement.value, 1e-12, "peak displacement");
        close(one.displacement.time, other.displacement.time, 1e-12, "its time");
        close(one.transferred_momentum, other.transferred_momentum, 1e-12, "momentum");
    }
    for (one, other) in there.collisions.iter().zip(back.collisions.iter().rev()) {
        assert!(one.len() > 1 && one.len() == other.len(), "{one:?} against {other:?}");
        for (one, other) in one.iter().zip(other) {
            close(one.start, other.start, 1e-12, "first touch");
            close(one.impulse, other.impulse, 1e-11, "impulse");
        }
    }
}

#[test]
fn extreme_settings_out_of_range_and_motions_without_end() {
    let row = undamped(viscoelastic(0.35));
    let try_with = |ground: &[f64], duration, tolerance, steps_per_sample| {
        let excitation = Excitation::new(0.1, ground).unwrap();
        let fineness = Fineness {
            tolerance,
            steps_per_sample,
            ..Fineness::FINE
        };
        pounding_reference::run(&row, excitation, duration, fineness)
    };
    for (duration, tolerance, steps) in [
        (1.0, 1e-15, 4),
        (1.0, f64::NAN, 4),
        (1.0, 1e-13, 0),
        (0.0, 1e-13, 4),
        (f64::INFINITY, 1e-13, 4),
    ] {
        let found = try_with(&[0.0], duration, tolerance, steps);
        let refused = matches!(found, Err(SecondRouteError::Setting { .. }));
        assert!(refused, "{duration}, {tolerance}, {steps}: {found:?}");
    }
    let excitation = Excitation::new(0.1, &[0.0]).unwrap();
    for shortest in [1e-15, 1e-8, f64::NAN] {
        let fineness = Fineness {
            shortest,
            ..Fineness::FINE
        };
        let found = pounding_reference::run(&row, excitation, 1.0, fineness);
        assert!(matches!(found, Err(SecondRouteError::Setting { .. })), "{shortest}: {found:?}");
    }
    let found = pounding_reference::run_until(&row, excitation, 1.0, Fineness::FINE, &AtomicBool::new(true));
    assert!(matches!(found, Err(SecondRouteError::Stopped { .. })), "{found:?}");
    // Beyond the range of numbers, or before that beyond the resolution of time.
    let found = try_with(&[1e300; 3], 1.0, 1e-13, 4);
    let ended = matches!(
        found,
        Err(SecondRouteError::NotFinite { .. } | SecondRouteError::TooManyEvents { .. })
    );
    assert!(ended, "{found:?}");
}

#[test]
fn extreme_a_pair_of_zero_gap_touches_from_the_start() {
    // Without a gap the first touch is at t = 0 with rate 0; a wall stops the mass at once.
    let nodes = vec![Node::structure(1e5, 0.0, FREE), Node::wall(FREE)];
    let gap_free = Pair::of_floors(0, 1, 0.0, viscoelastic(0.35));
    let response = run(&Row::new(nodes, vec![gap_free]).unwrap(), &[-2.0; 4], 0.2);
    let first = response.collisions[0][0];
    assert!(first.start < 1e-12 && first.impulse > 0.0, "{first:?}");
    let gained = 1e5 * (response.structures[0].end_velocity - 0.4);
    close(response.structures[0].transferred_momentum, -gained, 1e-13, "impulse of the load");
}
