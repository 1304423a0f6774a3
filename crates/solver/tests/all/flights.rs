//! The exact method flies from sample to sample if possible; the general method must give an equal result.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    Bilinear, Clock, Collisions, Elastic, Exact, Excitation, FloorAccelerations, Histories, Integrator, Ledger, Node, Pair, Peaks, Row,
    Work,
};
use proptest::prelude::*;

use crate::common::VISCOELASTIC;
use crate::random_rows::config;
use crate::watch::Watch;

const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-14,
    simultaneous_impacts: pounding_solver::SimultaneousImpacts::Together,
});
/// Samples every 0.01 s.
const STEP: f64 = 0.01;
/// Interval between states of the histories \[s\].
const LOOK: f64 = 0.0037;
/// A delay \[s\] of a hundred intervals, and of 37 samples.
const LATER: f64 = 0.37;

#[derive(Debug, Clone)]
struct Case {
    /// Period \[s\], damping ratio, yield displacement \[m\].
    structures: Vec<[f64; 3]>,
    gap: f64,
    law: ContactLaw,
    ground: Vec<f64>,
}

fn cases() -> impl Strategy<Value = Case> {
    let yields = prop_oneof![2 => Just(f64::INFINITY), 1 => 0.005..0.05_f64];
    let structure = (0.07..2.0_f64, 0.0..0.3_f64, yields).prop_map(|(t, xi, u)| [t, xi, u]);
    let restitution = (0.2..0.9_f64).prop_map(|restitution| ContactLaw::Stereomechanical(Stereomechanical { restitution }));
    (
        prop::collection::vec(structure, 1..4),
        0.005..0.05_f64,
        prop_oneof![restitution, Just(VISCOELASTIC)],
        prop::collection::vec(-4.0..4.0_f64, 250),
    )
        .prop_map(|(structures, gap, law, ground)| Case {
            structures,
            gap,
            law,
            ground,
        })
}

fn node([period, ratio, yields]: [f64; 3]) -> Node<Bilinear> {
    let omega = 2.0 * std::f64::consts::PI / period;
    let (mass, stiffness) = (1e5, 1e5 * omega * omega);
    let column = Bilinear {
        stiffness,
        yield_force: stiffness * yields,
        hardening: 0.0,
    };
    Node::structure(mass, 2.0 * ratio * omega * mass, column)
}

/// A structure apart from the row.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Apart {
    Nothing,
    /// A structure whose period the samples do not resolve, so that the row does not fly as a whole.
    Stiff,
    /// No structure, but a later arrival of the ground motion: nothing flies.
    Late,
}

/// Results of the row, and their number of pieces.
fn run(case: &Case, apart: Apart) -> (Vec<f64>, Work) {
    let others: &[[f64; 3]] = match apart {
        Apart::Nothing | Apart::Late => &[],
        Apart::Stiff => &[[0.04, 0.05, f64::INFINITY]],
    };
    let n = case.structures.len();
    let nodes = case.structures.iter().chain(others).copied().map(node);
    let pair = |left: usize| Pair::of_floors(left, left + 1, case.gap, case.law);
    let pairs: Vec<_> = (0..n - 1).map(pair).collect();
    let mut row = Row::new(nodes.collect(), pairs).expect("the row is valid");
    if apart == Apart::Late {
        row = row.delayed(vec![LATER; n]).expect("they are valid");
    }
    let n_nodes = n + others.len();
    let clock = Clock {
        time_step: STEP,
        n_steps: case.ground.len() - 1 + if apart == Apart::Late { 37 } else { 0 },
    };
    let excitation = Excitation::new(STEP, &case.ground).expect("the record is finite");
    let mut recorder = (
        Peaks::new(n_nodes),
        FloorAccelerations::new(n_nodes, excitation).travelled(row.travel(excitation).as_ref()),
        Collisions::new(n_nodes, row.pairs()),
        Histories::new(n_nodes, LOOK, clock.time(clock.n_steps)),
    );
    let work = EXACT.watch(&row, excitation, clock, &mut recorder).expect("the row can be run");
    let (peaks, accelerations, collisions, histories) = recorder;
    let (later, before) = if apart == Apart::Late { (LATER, 100) } else { (0.0, 0) };
    let mut numbers = Vec::new();
    for structure in 0..n {
        let of = peaks.of(structure);
        numbers.extend([of.displacement.value, of.displacement.time - later]);
        numbers.push(accelerations.of(structure).value);
        let states = &histories.of(structure).states;
        numbers.extend(states[before..].iter().map(|state| state.displacement));
    }
    numbers.extend(collisions.all().iter().map(|one| one.impulse / 1e5));
    (numbers, work)
}

proptest! {
    #![proptest_config(config(64))]
    /// A row that flies as a whole has the same bits as its structures alone.
    #[test]
    fn limit_a_row_flies_as_its_structures_do(case in cases()) {
        let [whole, single] = [Apart::Nothing, Apart::Stiff].map(|apart| run(&case, apart).0);
        let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        prop_assert_eq!(bits(whole), bits(single));
    }

    #[test]
    fn reference_flights_and_pieces_come_to_the_same(case in cases()) {
        let (flown, _) = run(&case, Apart::Nothing);
        let (general, _) = run(&case, Apart::Late);
        prop_assert_eq!(flown.len(), general.len());
        let scale = general.iter().fold(0.0, |most: f64, number| most.max(number.abs()));
        for (index, (a, b)) in flown.iter().zip(&general).enumerate() {
            prop_assert!((a - b).abs() <= 1e-9 * scale, "{index}: {a} {b}");
        }
    }
}

/// A structure that only flies needs a piece per sample, wherever it turns, and its peak is at the turn.
#[test]
fn limit_a_free_structure_takes_a_piece_for_a_sample() {
    let case = Case {
        structures: vec![[0.5, 0.05, f64::INFINITY]],
        gap: 0.0,
        law: VISCOELASTIC,
        ground: (0..200).map(|n| libm::sin(0.1 * f64::from(n))).collect(),
    };
    let (numbers, work) = run(&case, Apart::Nothing);
    let displacements = &numbers[3..];
    let turns = displacements.windows(3).filter(|u| (u[1] - u[0]) * (u[2] - u[1]) < 0.0);
    assert!(turns.count() > 2, "{numbers:?}");
    let most = displacements.iter().fold(0.0, |most: f64, u| most.max(u.abs()));
    let (peak, time) = (numbers[0].abs(), numbers[1]);
    assert!(peak > most && peak < 1.01 * most, "{peak} {most}");
    assert!((time / STEP).fract() > 1e-3, "{time}");
    assert_eq!((work.segments, work.events), (199, 199), "{work:?}");
}

/// A structure that turns between two samples reaches farther than at either sample, and must not fly through a wall.
#[test]
fn extreme_a_touch_between_two_samples_is_not_flown_over() {
    let ground: Vec<f64> = (0..40).map(|n| if n < 3 { -2.0 } else { 0.0 }).collect();
    let excitation = Excitation::new(STEP, &ground).expect("the record is finite");
    let clock = Clock {
        time_step: STEP,
        n_steps: 39,
    };
    let run = |gap: f64| {
        let pair = Pair::of_floors(0, 1, gap, VISCOELASTIC);
        let structure = node([0.08, 0.05, f64::INFINITY]);
        let nodes = vec![structure, Node::wall(structure.column)];
        let row = Row::new(nodes, vec![pair]).expect("the row is valid");
        let mut recorder = (
            Peaks::new(2),
            Collisions::new(2, row.pairs()),
            Histories::new(2, STEP, clock.time(clock.n_steps)),
        );
        EXACT.watch(&row, excitation, clock, &mut recorder).expect("the row can be run");
        recorder
    };
    let (peaks, _, histories) = run(1.0);
    let reached = peaks.of(0).displacement.value;
    let seen = histories.of(0).states.iter();
    let seen = seen.fold(0.0, |most: f64, state| most.max(state.displacement));
    assert!(reached > 1.001 * seen, "{reached} {seen}");
    let (_, collisions, _) = run(0.5 * (reached + seen));
    assert!(!collisions.all().is_empty());
}

/// The uncertainty of a touch follows from the largest displacements, including those of flights.
#[test]
fn issue_the_uncertainty_of_a_touch_knows_what_was_flown() {
    // Strong shaking decays before the gap closes: the structures move far in flight, and touch near rest.
    let shaking = |n: i32| {
        if n < 160 { 3.0 * libm::sin(0.08 * f64::from(n)) } else { 0.0 }
    };
    let ground: Vec<f64> = (0..900).map(shaking).collect();
    let uncertainty = |arrival: f64| {
        let nodes = [[1.0, 0.02, f64::INFINITY], [0.9, 0.02, f64::INFINITY]].map(node);
        let pair = Pair::of_floors(0, 1, 0.1, VISCOELASTIC);
        let row = Row::new(nodes.to_vec(), vec![pair]).expect("the row is valid");
        let row = row.delayed(vec![arrival; 2]).expect("they are valid");
        let clock = Clock {
            time_step: STEP,
            n_steps: ground.len(),
        };
        let excitation = Excitation::new(STEP, &ground).expect("the record is finite");
        let mut collisions = Collisions::new(2, row.pairs()).travelled(row.travel(excitation));
        EXACT.watch(&row, excitation, clock, &mut collisions).expect("the row can be run");
        let touches = collisions.all().iter().filter_map(|one| one.uncertainty);
        touches.collect::<Vec<_>>()
    };
    let (flown, general) = (uncertainty(0.0), uncertainty(LATER));
    assert!(!flown.is_empty() && flown.len() == general.len());
    for (flown, general) in flown.iter().zip(&general) {
        // The general method evaluates both sides at an instant, a flight the largest displacement of each. Later times have more rounding.
        let ratio = flown / (general - LATER * f64::EPSILON);
        assert!((0.999..1.5).contains(&ratio), "{flown:e} {general:e}");
    }
}

/// The balances of a flight close to rounding: works are integrals over its series, which is expanded only for them.
#[test]
fn reference_the_ledger_of_a_flight() {
    let ground: Vec<f64> = (0..400).map(|n| 3.0 * libm::sin(0.13 * f64::from(n))).collect();
    let excitation = Excitation::new(STEP, &ground).expect("the record is finite");
    let column = Elastic { stiffness: 1e7 };
    let row = Row::new(vec![Node::structure(1e5, 2e4, column)], Vec::new()).expect("valid");
    let clock = Clock {
        time_step: STEP,
        n_steps: 399,
    };
    let mut ledger = Ledger::new(&row, excitation);
    EXACT.watch(&row, excitation, clock, &mut ledger).expect("the row can be run");
    assert!(ledger.residual() < 1e-13, "{}", ledger.residual());
}
