//! Chains of impacts in lanes: several pairs hit at an instant.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_lanes::{ExactSideBySide, RowsOf, SceneSums, SideBySide};
use pounding_solver::{Collision, Collisions, Elastic, Exact, Excitation, Integrator, Node, Pair, Point, Relation, Row};

use crate::steps::{CLOCK, SCENES, SETTINGS, all, compare};
use crate::watch::Watch;

/// Number of pairs hit at an instant at which a neighbouring pair was hit.
fn hit_together(row: &Row<Elastic>, excitation: Excitation<'_>) -> usize {
    let mut recorder = Collisions::new(row.nodes().len(), row.pairs());
    let method = Integrator::CentralDifference(SETTINGS);
    let ran = method.watch(row, excitation, CLOCK, &mut recorder);
    assert!(ran.is_ok(), "the row runs alone");
    let all = recorder.all();
    let beside = |one: &Collision, other: &Collision| one.pair + 1 == other.pair && one.start.total_cmp(&other.start).is_eq();
    let joined = all.iter().filter(|one| all.iter().any(|other| beside(one, other)));
    joined.count()
}

/// Chains of pairs hit at an instant, with walls at the left, in the middle and at the right.
#[test]
fn limit_chains_of_impacts_give_the_bits_of_a_scene_alone() {
    let ground: Vec<f64> = (0..200).map(|n| 5.0 * libm::sin(0.37 * f64::from(n))).collect();
    let excitation = Excitation::new(0.01, &ground).expect("valid");
    for (structures, restitution, wall) in [
        (3, 0.0, None),
        (3, 1.0, Some(2)),
        (6, 0.5, None),
        (6, 1.0, Some(0)),
        (30, 0.0, Some(15)),
        (30, 0.9, None),
    ] {
        let row = |scene: usize| {
            let node = |index: usize| {
                let vary = libm::sin((7 * index + 3 * scene) as f64);
                let column = Elastic {
                    stiffness: 5e6 * (1.5 + vary),
                };
                if wall == Some(index) {
                    return Node::wall(column);
                }
                // All approach each other at the start.
                Node {
                    initial_velocity: 0.3 - 0.6 * index as f64 / (structures - 1) as f64,
                    ..Node::structure(libm::pow(10.0, 5.0 + vary), 2e4, column)
                }
            };
            let law = Stereomechanical {
                restitution: restitution / (1.0 + 0.01 * scene as f64),
            };
            let pair = |left: usize| {
                Pair::of_floors(
                    left,
                    left + 1,
                    if (left + scene).is_multiple_of(4) { 1e-3 } else { 0.0 },
                    ContactLaw::Stereomechanical(law),
                )
            };
            let pairs = (0..structures - 1).map(pair).collect();
            Row::new((0..structures).map(node).collect(), pairs).expect("valid")
        };
        let rows: Vec<_> = (0..SCENES[0]).map(row).collect();
        let together: usize = rows.iter().map(|row| hit_together(row, excitation)).sum();
        assert!(together >= structures, "{structures}: {together} neighbours hit at once");
        let found = compare((&all(&rows), RowsOf::Elastic), &ground);
        assert!(found.is_ok(), "{structures}, {restitution}, {wall:?}: {found:?}");
    }
}

/// Lanes support only pairs of a floor and its right neighbour: other rows are left to runs alone.
#[test]
fn extreme_pairs_that_are_no_chain_are_left_alone() {
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.5 });
    let structure = || Node::structure(1e5, 0.0, Elastic { stiffness: 1e7 });
    let floors = Pair::of_floors(0, 1, 0.01, law);
    let above_the_ground = Pair {
        relation: Relation {
            left: Point::Floor(0),
            right: Point::between(None, 1, 0.6).expect("above the ground"),
            offset: 0.01,
        },
        law,
    };
    let row = |pairs| Row::new(vec![structure(), structure()], pairs).expect("valid");
    let excitation = Excitation::new(0.01, &[0.0]).expect("valid");
    for (pairs, is_chain) in [(vec![floors], true), (vec![floors, floors], false), (vec![above_the_ground], false)] {
        let row = row(pairs);
        let together = SideBySide::new(SETTINGS, excitation, CLOCK).expect("valid");
        let mut found = SceneSums::default();
        let runs = together.run(RowsOf::Elastic(&[&row]), &[CLOCK.n_steps], &mut found);
        assert_eq!(runs, is_chain);
        assert_eq!(SideBySide::are_alike(&row, &row), is_chain);
        assert_eq!(ExactSideBySide::takes(&row, Exact::default()), is_chain);
    }
}
