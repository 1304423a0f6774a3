//! Values so large or small that series and counts overflow, found by fuzzing. Such runs end with an error.

use pounding_contact::{ContactLaw, LinearSpring};
use pounding_solver::{Clock, Exact, Excitation, Integrator, Peaks, Row, RunError, SimultaneousImpacts, Work};

use crate::common::{STIFF, VISCOELASTIC, WEAK, central, clock, elastic, pairs, yielding};
use crate::watch::Watch;

const EXACT: Integrator = Integrator::Exact(Exact {
    tolerance: 1e-16,
    simultaneous_impacts: SimultaneousImpacts::Together,
});

/// A weak and a stiff structure 1 cm apart; the weak one starts with a velocity \[m/s\].
fn run(law: ContactLaw, velocity: f64) -> Result<Work, RunError> {
    let mut nodes = vec![yielding(WEAK), yielding(STIFF)];
    nodes[0].initial_velocity = velocity;
    let row = Row::new(nodes, pairs(2, 0.01, law)).expect("a good row");
    let rest = Excitation::new(0.01, &[0.0]).expect("good samples");
    EXACT.watch(&row, rest, clock(0.1, 0.1), &mut ())
}

/// Coefficients of the contact force overflowed, and the search for its zeros went through its stretch in steps of 1e-15.
#[test]
fn issue_contact_too_stiff_for_numbers_ends_with_an_error() {
    for stiffness in [1e100, 1e160, 1e250, 1e300, f64::MAX] {
        let law = ContactLaw::LinearSpring(LinearSpring {
            impact_stiffness: stiffness,
        });
        let error = run(law, 1.0).expect_err("a contact shorter than time can tell");
        let known = matches!(
            error,
            RunError::OutOfNumbers { .. } | RunError::NoProgress { .. } | RunError::NoSeries { .. }
        );
        assert!(known, "{stiffness:e}: {error}");
    }
}

/// At a very fast touch the contact force overflowed.
#[test]
fn issue_a_touch_too_fast_for_numbers_ends_with_an_error() {
    for velocity in [5.21e154, 1e200, 1e300] {
        let error = run(VISCOELASTIC, velocity).expect_err("a force beyond all numbers");
        let known = matches!(error, RunError::OutOfNumbers { .. } | RunError::NoProgress { .. });
        assert!(known, "{velocity:e}: {error}");
    }
}

/// The number of samples before an instant overflowed.
#[test]
fn issue_a_record_of_almost_no_duration_is_over() {
    let row = Row::new(vec![elastic(WEAK)], Vec::new()).expect("a good row");
    for time_step in [1e-17, 1e-25, 1e-300, f64::MIN_POSITIVE] {
        let brief = Excitation::new(time_step, &[1.0, -1.0]).expect("good samples");
        let mut seen = Peaks::new(1);
        match EXACT.watch(&row, brief, clock(1.0, 1.0), &mut seen) {
            Ok(_) => {
                let peak = seen.of(0).displacement.value;
                assert!(peak.abs() < 1e-12, "{time_step:e}: {peak}");
            }
            // Its slope is not finite.
            Err(error) => {
                assert!(matches!(error, RunError::OutOfNumbers { .. }), "{error}");
                assert!(time_step < 1e-100, "{time_step:e}: {error}");
            }
        }
    }
}

/// Billions of sub-steps made a run of few steps last for hours.
#[test]
fn issue_substeps_have_a_limit() {
    let row = Row::new(vec![elastic(WEAK)], Vec::new()).expect("a good row");
    let rest = Excitation::new(0.01, &[0.0]).expect("good samples");
    let once = Clock {
        time_step: 0.01,
        n_steps: 1,
    };
    for (contact_substeps, good) in [(0, false), (1, true), (1000, true), (1001, false)] {
        let run = central(contact_substeps).watch(&row, rest, once, &mut ());
        assert_eq!(run.is_ok(), good, "{contact_substeps} sub-steps");
    }
}
