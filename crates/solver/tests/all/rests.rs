//! Impacts followed by rest: each counts once, including the rest.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Collision, Collisions, Elastic, Exact, Excitation, Integrator, Node, Row, SimultaneousImpacts};

use crate::common::{METHODS, clock, pairs};

const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-16,
    simultaneous_impacts: SimultaneousImpacts::Together,
});

/// Collisions of a mass that the ground presses against a wall from 0 to 0.5 s, and again from 0.7 s.
fn collisions(restitution: f64, method: Integrator) -> Vec<Collision> {
    let node = Node::structure(1.0, 0.1, Elastic { stiffness: 1.0 });
    let wall = Node::wall(Elastic { stiffness: 1.0 });
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
    let row = Row::new(vec![node, wall], pairs(2, 0.01, law)).expect("the row is valid");
    let away = 50..70;
    let ground = (0..=150).map(|n| if away.contains(&n) { 10.0 } else { -10.0 });
    let ground: Vec<f64> = ground.collect();
    let excitation = Excitation::new(0.01, &ground).expect("the ground motion is finite");
    let mut found = Collisions::new(2, row.pairs());
    let run = method.run(&row, excitation, clock(1e-3, 1.5), &mut found);
    run.expect("the run ends");
    found.all().to_vec()
}

/// An impact with e = 0 and the rest after it counted as two collisions in the exact method, and as a collision in every step of the
/// others.
#[test]
fn issue_an_impact_and_the_rest_after_it_count_once() {
    let exact = collisions(0.0, EXACT);
    let [first, second] = exact[..] else {
        panic!("two meetings: {exact:?}");
    };
    assert!((first.start - libm::sqrt(0.02 / 10.0)).abs() < 1e-3, "{first:?}");
    assert!((first.end - 0.495).abs() < 1e-3, "{first:?}");
    assert!((second.end - 1.5).abs() < 1e-12, "{second:?}");
    assert!(exact.iter().all(|one| one.peak_force.is_none()));
    for (name, method) in METHODS {
        let found = collisions(0.0, method);
        assert_eq!(found.len(), 2, "{name}: {found:?}");
        for (one, exact) in found.iter().zip(&exact) {
            let off = (one.impulse / exact.impulse - 1.0).abs();
            assert!(off < 0.01, "{name}: {one:?}, exact {exact:?}");
            let late = (one.start - exact.start).abs().max((one.end - exact.end).abs());
            assert!(late < 3e-3, "{name}: {one:?}, exact {exact:?}");
        }
    }
}

/// The rest after bounces counted as a separate collision, at the instant of the last bounce.
#[test]
fn issue_the_last_bounce_has_the_rest_after_it() {
    let exact = collisions(0.5, EXACT);
    let until_half: Vec<_> = exact.iter().filter(|one| one.start < 0.5).collect();
    let (last, bounces) = until_half.split_last().expect("the mass reaches the wall");
    assert!(bounces.len() > 20, "{exact:?}");
    assert!(bounces.iter().all(|one| one.end.total_cmp(&one.start).is_eq()));
    assert!((last.end - 0.495).abs() < 1e-3, "{last:?}");
    assert!(exact.iter().all(|one| one.peak_force.is_none()));
    for pair in exact.windows(2) {
        assert!(pair[0].end < pair[1].start, "{pair:?}");
    }
    // The momentum until the mass parts does not depend on the bounces.
    let total: f64 = until_half.iter().map(|one| one.impulse).sum();
    let plastic = collisions(0.0, EXACT)[0].impulse;
    assert!((total / plastic - 1.0).abs() < 0.01, "{total}, {plastic}");
}
