//! Moreau–Jean stepping in extreme rows.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Bilinear, Clock, Excitation, Integrator, Ledger, LedgerError, MoreauJean, Node, Pair, Row, RunError};
use proptest::prelude::*;

use crate::common::ground;
use crate::random_rows::{Case, SI, cases, config};
use crate::watch::Watch;

fn impulsive(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

/// Balances of a run, and violations of the laws of mechanics.
fn run(row: &Row<Bilinear>, theta: f64, ground: &[f64], clock: Clock) -> Result<([f64; 2], Result<(), LedgerError>), RunError> {
    let excitation = Excitation::new(0.01, ground).expect("the ground motion is finite");
    let mut ledger = Ledger::new(row, excitation);
    Integrator::MoreauJean(MoreauJean { theta }).watch(row, excitation, clock, &mut ledger)?;
    Ok(([ledger.identity(), ledger.momentum()], ledger.verdict().map(|_| ())))
}

/// Mass, damping and stiffness of every structure; gap and restitution of every pair.
fn row(structures: &[[f64; 4]], contacts: &[(f64, f64)]) -> Row<Bilinear> {
    let node = |&[mass, damping, stiffness, yield_force]: &[f64; 4]| {
        let column = Bilinear {
            stiffness,
            yield_force,
            hardening: 0.0,
        };
        Node::structure(mass, damping, column)
    };
    let pair = |(left, &(gap, restitution)): (usize, &(f64, f64))| Pair::of_floors(left, left + 1, gap, impulsive(restitution));
    Row::new(
        structures.iter().map(node).collect(),
        contacts.iter().enumerate().map(pair).collect(),
    )
    .expect("the row is valid")
}

#[test]
fn issue_impulses_that_rounding_alone_still_changed() {
    // A step was repeated until no impulse changed by more than the rounding of velocities. On a structure that is light compared with its
    // neighbours, the rounding of their velocities moves an impulse much further, and the run stopped.
    let infinite = f64::INFINITY;
    let pressed = row(
        &[
            [7_240_299.0, 1_130_915.0, 38_119_158.0, 31_235.0],
            [5.782_097, 0.0, 2790.843, infinite],
        ],
        &[(0.0, 0.2996)],
    );
    let between = row(
        &[
            [1_862_513.8, 28_887_400.0, 60_997_590.0, 3_906_465.0],
            [0.292_014, 0.146_311_7, 9.545_484, 0.032_273_8],
            [8_950_526.0, 133_386_390.0, 2_290_163_700.0, infinite],
        ],
        &[(2e-6, 1.0), (1.7e-5, 0.446)],
    );
    for (name, row) in [("pressed", pressed), ("between", between)] {
        for theta in [0.5, 0.7, 1.0] {
            for time_step in [1e-2, 1e-3, 1e-4] {
                let clock = crate::common::clock(time_step, 3.0);
                let (balances, laws) = run(&row, theta, &ground(), clock).unwrap_or_else(|error| panic!("{name}, theta {theta}: {error}"));
                assert!(balances.iter().all(|balance| *balance < 1e-11), "{name}: {balances:?}");
                assert_eq!(laws, Ok(()), "{name}, theta {theta}, step {time_step}");
            }
        }
    }
}

fn any_restitution() -> BoxedStrategy<ContactLaw> {
    prop_oneof![Just(0.0), Just(1.0), 0.0..=1.0_f64].prop_map(impulsive).boxed()
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn limit_every_row_gets_its_impulses(
        case in cases(any_restitution),
        theta in prop_oneof![Just(0.5), Just(1.0), 0.5..1.0_f64],
        time_step in prop_oneof![Just(1e-2), Just(1e-3), Just(1e-4)],
    ) {
        let Case { ground, .. } = &case;
        let outcome = run(&case.row(SI), theta, ground, crate::common::clock(time_step, 0.6));
        let (balances, laws) = outcome.map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert!(balances.iter().all(|balance| *balance < 1e-11), "{balances:?}");
        prop_assert_eq!(laws, Ok(()));
    }
}
