//! Rows without gaps next to a wall, in which only rounding could move structures.

use std::f64::consts::PI;

use pounding_contact::{ContactLaw, KelvinVoigt, Stereomechanical};
use pounding_solver::{Clock, Collision, Collisions, Elastic, Exact, Excitation, Integrator, Node, Pair, Row};

use crate::common::moving;

const PLASTIC: ContactLaw = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 });

/// Collisions of a row of neighbours with these laws and no gaps, by the exact method with its ledger.
fn collisions(nodes: &[Node<Elastic>], laws: &[ContactLaw], (step, ground): (f64, &[f64])) -> Vec<Collision> {
    let pair = |(left, law): (usize, &ContactLaw)| Pair::of_floors(left, left + 1, 0.0, *law);
    let pairs = laws.iter().enumerate().map(pair).collect();
    let row = Row::new(nodes.to_vec(), pairs).expect("the row is valid");
    let excitation = Excitation::new(step, ground).expect("the record is finite");
    let clock = Clock {
        time_step: 0.005,
        n_steps: 400,
    };
    let mut recorder = Collisions::new(nodes.len(), row.pairs());
    let run = Integrator::Exact(Exact::default()).run(&row, excitation, clock, &mut recorder);
    run.expect("it keeps every law");
    recorder.all().to_vec()
}

/// Number of collisions of each pair.
fn counts(nodes: &[Node<Elastic>], laws: &[ContactLaw], ground: (f64, &[f64])) -> Vec<usize> {
    let all = collisions(nodes, laws, ground);
    let of = |pair: usize| all.iter().filter(|one| one.pair == pair).count();
    (0..laws.len()).map(of).collect()
}

fn wall() -> Node<Elastic> {
    Node::wall(Elastic { stiffness: 1.0 })
}

/// Samples of a half sine of 0.4 s.
fn push() -> Vec<f64> {
    let sample = |n: usize| 3.0 * libm::sin(PI * n as f64 / 20.0);
    (0..20).map(sample).chain([0.0]).collect()
}

/// A push holds structures against a wall, and nothing moves. As the push ends, the forces fade, and so does the difference of the forces
/// on a structure that rests on both sides. The rest ended within rounding of the sample: 1e-43 N·s, a hundred times.
#[test]
fn issue_what_a_push_holds_against_a_wall_does_not_move() {
    let at_rest = |mass: f64, period: f64| moving(mass, [period, 0.05], [0.0; 2]);
    let nodes = [wall(), at_rest(1e5, 0.5), at_rest(2e5, 0.7), at_rest(5e4, 0.9)];
    for n in 2..=4 {
        let laws = vec![PLASTIC; n - 1];
        let found = counts(&nodes[..n], &laws, (0.02, &push()));
        assert_eq!(found, vec![1; n - 1], "{n} nodes");
    }
}

/// The first structure hits the second, which rests against the wall; both then stand still.
#[test]
fn issue_chains_that_hit_a_wall_stand_still() {
    let hits = moving(3.66e5, [0.8, 0.02], [0.0, -0.32]);
    let between = moving(4.7e4, [0.33, 0.05], [0.0, -0.34]);
    let ground = (0.02, &[0.0; 100][..]);
    let found = counts(&[hits, between, wall()], &[PLASTIC; 2], ground);
    assert_eq!(found, [2, 2]);
    let mirrored = |node: Node<Elastic>| Node {
        initial_velocity: -node.initial_velocity,
        ..node
    };
    let nodes = [wall(), mirrored(between), mirrored(hits)];
    assert_eq!(counts(&nodes, &[PLASTIC; 2], ground), [2, 2]);
}

/// A structure reaches the wall exactly at a sample of the record.
#[test]
fn issue_what_hits_a_wall_at_a_sample_stands_still() {
    let period = 0.154_868_210_286_883_66;
    let nodes = [moving(1e5, [period, 0.05], [-0.028_056_178_580_986_683, 0.0]), wall()];
    let ground = (0.005, &[0.0; 200][..]);
    assert_eq!(counts(&nodes, &[PLASTIC], ground), [1]);
}

/// The force at rest touches zero at a sample and grows again: the pair never parts.
#[test]
fn issue_a_rest_is_one_collision_though_its_force_touches_zero() {
    let nodes = [moving(1e5, [0.5, 0.05], [0.0; 2]), wall()];
    let ground = [-1.0, -2.0, -1.0, 0.0, -1.0, -2.0, -1.0, 0.0];
    let found = collisions(&nodes, &[PLASTIC], (0.02, &ground));
    let [one] = found[..] else {
        panic!("{found:?}");
    };
    assert!((one.end - 0.14).abs() < 1e-15, "{one:?}");
    // Impulse for 1e5 kg: the area of the record.
    assert!((one.impulse - 15e3).abs() < 1e-9, "{one:?}");
}

/// If a compliant and an impulsive pair touch at an instant, their order must not matter.
#[test]
fn limit_a_row_with_both_kinds_of_contact_may_be_mirrored() {
    let kelvin = ContactLaw::KelvinVoigt(KelvinVoigt {
        impact_stiffness: 1.9e8,
        impact_damping_ratio: 0.19,
    });
    let nodes = |sign: f64| {
        [
            moving(5.3e5, [0.67, 0.02], [0.0, sign * 0.19]),
            moving(4.2e5, [0.8, 0.02], [0.0; 2]),
            moving(5e4, [0.7, 0.02], [0.0; 2]),
        ]
    };
    let ground: Vec<_> = push().iter().map(|a| -a).collect();
    let given = counts(&nodes(1.0), &[PLASTIC, kelvin], (0.02, &ground));
    let mut mirrored = nodes(-1.0);
    mirrored.reverse();
    let [right, left] = counts(&mirrored, &[kelvin, PLASTIC], (0.02, &push()))[..] else {
        panic!("two pairs");
    };
    assert_eq!(given, [left, right]);
}
