//! Events at t = 0, and refusals before it.

use crate::towers::{self, Rayleigh};
use crate::watch::Watch;
use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    BoucWen, Budget, Clock, Elastic, Exact, Excitation, Hysteretic, Integrator, Ledger, MoreauJean, Node, Pair, Row, RunError,
    SimultaneousImpacts, Smoothness,
};

const CLOCK: Clock = Clock {
    time_step: 1e-3,
    n_steps: 500,
};

const START: Clock = Clock {
    time_step: 1e-3,
    n_steps: 10,
};
const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-16,
    simultaneous_impacts: SimultaneousImpacts::Together,
});

/// Two structures that touch; the left one moves towards the other at 0.5 m/s and is displaced by 2 cm.
fn row(stiffness: f64) -> Row<Elastic> {
    let left = Node {
        initial_velocity: 0.5,
        initial_displacement: 0.02,
        ..Node::structure(1e5, 1e4, Elastic { stiffness })
    };
    let right = Node {
        initial_displacement: 0.02,
        ..Node::structure(3e5, 0.0, Elastic { stiffness: 2e7 })
    };
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.6 });
    let pair = Pair::of_floors(0, 1, 0.0, law);
    Row::new(vec![left, right], vec![pair]).expect("a row")
}

#[test]
fn issue_an_impact_at_the_very_start_was_left_out_of_the_balances() {
    let rest = Excitation::new(0.1, &[0.0]).expect("a record");
    let row = row(1e6);
    let methods = [
        Integrator::Exact(Exact::default()),
        Integrator::MoreauJean(MoreauJean { theta: 0.5 }),
    ];
    for method in methods {
        let mut ledger = Ledger::new(&row, rest);
        method.watch(&row, rest, CLOCK, &mut ledger).expect("the run ends");
        for balance in [ledger.identity(), ledger.momentum()] {
            assert!(balance < 1e-12, "{method:?}: {balance:e}");
        }
    }
}

#[test]
fn issue_a_high_tower_leaves_its_standstill() {
    // The drift of a high storey begins with a high power of time. Rounding of the lower powers turned the storey back, or its force
    // through zero, after 1e-24 s, and again and again without end.
    // Stiffness [MN/m], yield force [MN] and hardening.
    const STOREYS: [(f64, f64, f64); 12] = [
        (186.63, 4.9348, 0.25471),
        (181.18, 1.9018, 0.19487),
        (175.72, 2.1867, 0.2273),
        (170.27, 0.64935, 0.0),
        (164.81, 4.1478, 0.16133),
        (159.36, 1.597, 0.0),
        (153.9, 1.4074, 0.0),
        (148.45, 4.6367, 0.18186),
        (142.99, 3.7146, 0.080_426),
        (137.54, 4.0455, 0.0),
        (132.08, 2.1228, 0.23114),
        (126.63, 1.9158, 0.23964),
    ];
    let columns = STOREYS.map(|(stiffness, yield_force, hardening)| BoucWen {
        stiffness: 1e6 * stiffness,
        hardening,
        yield_force: 1e6 * yield_force,
        smoothness: Smoothness {
            exponent: 1,
            unloading: 0.937_955,
        },
    });
    let mut tower = columns.map(|column| (122_310.0, column)).to_vec();
    tower[11].0 = 62_133.0;
    for index in 0..1000 {
        let part = f64::from(index);
        let damping = Rayleigh {
            alpha: 0.36,
            beta: 5e-3 + 1e-6 * part,
        };
        let (row, _) = towers::row(&[tower.clone()], damping, |_, _, _| None);
        let samples = [0.0, 0.08 + 1e-4 * part];
        let shaking = Excitation::new(0.01, &samples).expect("a record");
        let run = EXACT.watch(&row, shaking, START, &mut ());
        assert!(run.is_ok(), "{index}: {run:?}");
    }
}

/// A tower of five storeys whose floors begin with a common velocity, for many velocities and dampings.
fn bends<Column: Hysteretic + Copy>(column: impl Fn(f64) -> Column) {
    let mut tower = [416.06, 369.86, 323.66, 277.46, 231.26]
        .map(|stiffness| (349_850.0, column(1e6 * stiffness)))
        .to_vec();
    tower[4].0 = 277_400.0;
    for index in 0..1000 {
        let part = f64::from(index);
        let damping = Rayleigh {
            alpha: 0.4 + 1e-4 * part,
            beta: 1.5e-3 + 1.7e-7 * part,
        };
        let (row, _) = towers::row(&[tower.clone()], damping, |_, _, _| None);
        let moving = |node: &Node<Column>| Node {
            initial_velocity: -0.38929 - 1e-3 * part,
            ..*node
        };
        let nodes = row.nodes().iter().map(moving).collect();
        let row = Row::new(nodes, Vec::new()).expect("a row");
        let shaking = Excitation::new(0.01, &[0.0]).expect("a record");
        let few = Budget {
            pieces: 1e4,
            ..Budget::default()
        };
        let run = EXACT.run(&row, shaking, START.within(few), &mut ());
        assert!(run.is_ok(), "{index}: {run:?}");
    }
}

#[test]
fn issue_a_tower_that_moves_as_one_bends() {
    // The drift of each storey begins with a higher power of time than that of the storey below, and rounding of lower powers turned it
    // back every 1e-16 s.
    bends(|stiffness| Elastic { stiffness });
    for exponent in [1, 2] {
        bends(|stiffness| BoucWen {
            stiffness,
            hardening: 0.1,
            yield_force: 2e6,
            smoothness: Smoothness { exponent, unloading: 0.5 },
        });
    }
}

#[test]
fn extreme_a_structure_too_stiff_for_the_exact_method_is_refused_at_once() {
    let rest = Excitation::new(0.1, &[0.0]).expect("a record");
    let run = Integrator::Exact(Exact::default()).watch(&row(1e300), rest, CLOCK, &mut ());
    assert!(matches!(run, Err(RunError::TooStiff { structure: 0, .. })), "{run:?}");
}
