//! Chains of impacts in lanes: several pairs hit at an instant.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_lanes::{ExactSideBySide, RowsOf, SceneSums, SideBySide};
use pounding_solver::{Collision, Collisions, Elastic, Exact, Excitation, Integrator, Node, Pair, Point, Row};

use crate::common::VISCOELASTIC;
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

/// Several pairs between two floors, and a floor beside a column on the ground: central differences run them, the exact method leaves them
/// alone.
#[test]
fn limit_pairs_that_are_no_chain_give_the_bits_of_a_scene_alone() {
    let ground: Vec<f64> = (0..200).map(|n| 5.0 * libm::sin(0.37 * f64::from(n))).collect();
    for law in [ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.5 }), VISCOELASTIC] {
        let structure = |stiffness| Node::structure(1e5, 1e4, Elastic { stiffness });
        let floors = |gap| Pair::of_floors(0, 1, gap, law);
        let above_the_ground = |part| Pair::new(Point::Floor(0), Point::between(None, 1, part).expect("above the ground"), 0.01, law);
        let row = |pairs| Row::new(vec![structure(1e7), structure(3e6)], pairs).expect("valid");
        for (pairs, is_chain) in [
            (vec![floors(0.01)], true),
            (vec![floors(0.01), floors(0.012)], false),
            (vec![above_the_ground(0.6)], false),
            (vec![above_the_ground(0.3), floors(0.02)], false),
        ] {
            let row = row(pairs);
            assert_eq!(row.is_chain(), is_chain);
            assert!(SideBySide::are_alike(&row, &row));
            let settings = Exact {
                tolerance: 1e-9,
                ..Exact::default()
            };
            assert_eq!(ExactSideBySide::takes(&row, settings), is_chain);
            let rows = vec![row; SCENES[0]];
            let found = compare((&all(&rows), RowsOf::Elastic), &ground);
            assert!(found.is_ok(), "{found:?}");
        }
    }
}

/// Closings are those of chains.
#[test]
fn limit_closings_of_other_pairs_are_left_to_runs_alone() {
    let structure = || Node::structure(1e5, 0.0, Elastic { stiffness: 1e7 });
    let pair = Pair::of_floors(0, 1, 0.01, VISCOELASTIC);
    let row = Row::new(vec![structure(), structure()], vec![pair, pair]).expect("valid");
    let excitation = Excitation::new(0.01, &[0.0]).expect("valid");
    let together = SideBySide::new(SETTINGS, excitation, CLOCK).expect("valid");
    let mut found = SceneSums::default();
    for closings in [false, true] {
        let together = together.clone().with_closings(closings);
        assert_eq!(together.run(RowsOf::Elastic(&[&row]), &[CLOCK.n_steps], &mut found), !closings);
    }
}
