//! What happens at t = 0, and what is refused before it.

use crate::watch::Watch;
use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    Clock, Elastic, Exact, Excitation, Integrator, Ledger, MoreauJean, Node, Pair, Row, RunError,
};

const CLOCK: Clock = Clock {
    time_step: 1e-3,
    n_steps: 500,
};

/// Two structures that touch, the left one moving towards the other at 0.5 m/s and bent by 2 cm.
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
    let pair = Pair {
        left: 0,
        right: 1,
        gap: 0.0,
        law,
    };
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
        method
            .watch(&row, rest, CLOCK, &mut ledger)
            .expect("the run ends");
        for balance in [ledger.identity(), ledger.momentum()] {
            assert!(balance < 1e-12, "{method:?}: {balance:e}");
        }
    }
}

#[test]
fn extreme_a_structure_too_stiff_for_the_exact_method_is_refused_at_once() {
    let rest = Excitation::new(0.1, &[0.0]).expect("a record");
    let run = Integrator::Exact(Exact::default()).watch(&row(1e300), rest, CLOCK, &mut ());
    assert!(
        matches!(run, Err(RunError::TooStiff { structure: 0, .. })),
        "{run:?}"
    );
}
