//! Laws of mechanics in free collisions: momentum, restitution, impulses.

use crate::common::{METHODS, STEREOMECHANICAL, VISCOELASTIC, clock, pairs};
use crate::watch::Watch;
use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Collisions, Elastic, Excitation, Histories, Integrator, Node, Row, TransferredMomentum};
use proptest::prelude::*;

/// Two free masses; the left one flies at `speed` towards the right one.
fn free_pair(masses: [f64; 2], speed: f64, law: ContactLaw) -> Row<Elastic> {
    let mut nodes = masses.map(|mass| Node::structure(mass, 0.0, Elastic { stiffness: 0.0 })).to_vec();
    nodes[0].initial_velocity = speed;
    Row::new(nodes, pairs(2, 0.01, law)).expect("the row is valid")
}

/// Final velocities, impulse of all collisions, transferred momenta.
fn collide(row: &Row<Elastic>, method: Integrator, time_step: f64) -> ([f64; 2], f64, [f64; 2]) {
    let duration = 0.02 / row.nodes()[0].initial_velocity + 0.15;
    let clock = clock(time_step, duration);
    let mut recorder = (
        Histories::new(2, time_step, duration),
        Collisions::new(2, row.pairs()),
        TransferredMomentum::new(2),
    );
    method
        .watch(row, Excitation::new(1.0, &[0.0]).expect("no shaking"), clock, &mut recorder)
        .expect("the run ends");
    let velocity = |index| recorder.0.of(index).states.last().expect("states were recorded").velocity;
    let impulse = recorder.1.all().iter().map(|collision| collision.impulse).sum();
    ([velocity(0), velocity(1)], impulse, [recorder.2.of(0), recorder.2.of(1)])
}

#[test]
fn reference_the_law_of_impact_is_delivered() {
    for (name, method) in METHODS {
        for restitution in [0.0, 0.3, 0.65, 1.0] {
            let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
            let row = free_pair([75e3, 3e6], 0.5, law);
            let ([left, right], impulse, _) = collide(&row, method, 0.001);
            assert!(
                ((right - left) / 0.5 - restitution).abs() < 1e-12,
                "{name}, e = {restitution}: {left} {right}"
            );
            let expected = (1.0 + restitution) * 75e3 * 3e6 / 3.075e6 * 0.5;
            assert!((impulse / expected - 1.0).abs() < 1e-12, "{name}, e = {restitution}: {impulse}");
        }
    }
}

#[test]
fn reference_the_viscoelastic_element_tends_to_its_exact_restitution() {
    let e = VISCOELASTIC.restitution().expect("a closed form");
    let row = free_pair([75e3, 3e6], 0.5, VISCOELASTIC);
    for (name, method) in METHODS {
        let error = |time_step| {
            let ([left, right], _, _) = collide(&row, method, time_step);
            ((right - left) / 0.5 - e).abs()
        };
        assert!(error(1e-5) < 2e-3, "{name}: {}", error(1e-5));
        assert!(error(1e-6) < 0.3 * error(1e-5), "{name}: {} then {}", error(1e-5), error(1e-6));
    }
}

proptest! {
    #[test]
    fn limit_momentum_is_kept(
        masses in prop::array::uniform2(1e3..1e7_f64),
        speed in 0.05..2.0_f64,
        restitution in 0.0..=1.0_f64,
        compliant in any::<bool>(),
        method in 0..METHODS.len(),
    ) {
        let law = if compliant {
            VISCOELASTIC
        } else {
            ContactLaw::Stereomechanical(Stereomechanical { restitution })
        };
        let row = free_pair(masses, speed, law);
        let (velocities, impulse, transferred) = collide(&row, METHODS[method].1, 0.000_5);
        let (before, after) = (masses[0] * speed, masses[0] * velocities[0] + masses[1] * velocities[1]);
        prop_assert!((after / before - 1.0).abs() < 1e-9, "momentum {before} became {after}");
        prop_assert!(velocities[1] >= velocities[0], "they must not pass through each other");
        prop_assert!(impulse > 0.0, "they must meet");
        // Both get the same impulse, and it is their change of momentum.
        prop_assert!((masses[1] * velocities[1] / impulse - 1.0).abs() < 1e-6, "{impulse}");
        prop_assert!((transferred[0] / impulse - 1.0).abs() < 1e-9 && (transferred[0] - transferred[1]).abs() == 0.0, "{transferred:?}");
    }
}

#[test]
fn limit_forces_from_both_sides_cancel_in_the_transferred_momentum() {
    // A light mass that equal neighbours hit at one instant gets nothing; each neighbour gets its impulse.
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        for (name, method) in METHODS {
            let free = |mass, velocity| Node {
                initial_velocity: velocity,
                ..Node::structure(mass, 0.0, Elastic { stiffness: 0.0 })
            };
            let row = Row::new(vec![free(1e6, 0.5), free(1e5, 0.0), free(1e6, -0.5)], pairs(3, 0.01, law)).unwrap();
            let mut recorder = (TransferredMomentum::new(3), Collisions::new(3, row.pairs()));
            let excitation = Excitation::new(1.0, &[0.0]).unwrap();
            method.watch(&row, excitation, clock(0.001, 0.05), &mut recorder).unwrap();
            let (momentum, collisions) = recorder;
            assert!(collisions.all().len() >= 2, "{name}: both neighbours must hit");
            assert!(momentum.of(1) < 1e-9 * momentum.of(0), "{name}: {}", momentum.of(1));
            assert!((momentum.of(0) / momentum.of(2) - 1.0).abs() < 1e-9, "{name}");
        }
    }
}
