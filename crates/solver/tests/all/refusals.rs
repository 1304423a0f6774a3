//! Models and runs that are refused, with the place, the value found and the values allowed.

use insta::assert_snapshot;
use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    Clock, Elastic, Excitation, Floor, Hht, Integrator, ModelError, Newmark, Node, Oscillation, Pair, Rk4, Row, RunError,
};

use crate::common::{
    AVERAGE, CENTRAL, HHT, METHODS, MOREAU_JEAN, RK4, STEREOMECHANICAL, VERLET, WEAK, central, elastic, ground, moreau_jean, pairs,
};
use crate::watch::Watch;

fn row(nodes: Vec<Node<Elastic>>, pairs: Vec<Pair>) -> ModelError {
    Row::new(nodes, pairs).expect_err("the row must be refused")
}

fn run(row: &Row<Elastic>, method: Integrator, clock: Clock) -> RunError {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    method.watch(row, excitation, clock, &mut ()).expect_err("the run must end early")
}

#[test]
fn extreme_rows_that_cannot_be() {
    let mut messages = Vec::new();
    let weak = elastic(WEAK);
    let bad = |change: fn(&mut Node<Elastic>)| {
        let mut node = weak;
        change(&mut node);
        row(vec![weak, node], vec![])
    };
    messages.push(bad(|node| node.inverse_mass = -1.0).to_string());
    messages.push(bad(|node| node.damping = f64::NAN).to_string());
    messages.push(bad(|node| node.initial_velocity = f64::INFINITY).to_string());
    messages.push(bad(|node| (node.inverse_mass, node.initial_velocity) = (0.0, 1.0)).to_string());

    let pair = |left, right, gap| Pair::of_floors(left, right, gap, STEREOMECHANICAL);
    messages.push(row(vec![weak; 3], vec![pair(0, 3, 0.1)]).to_string());
    messages.push(row(vec![weak; 3], vec![pair(0, 1, 0.1), pair(1, 1, 0.1)]).to_string());
    messages.push(row(vec![weak; 2], vec![pair(0, 1, -0.1)]).to_string());
    let plastic = ContactLaw::Stereomechanical(Stereomechanical { restitution: 1.2 });
    messages.push(row(vec![weak; 2], pairs(2, 0.1, plastic)).to_string());
    let shifted = Node {
        initial_displacement: 0.15,
        ..weak
    };
    messages.push(row(vec![shifted, weak], vec![pair(0, 1, 0.1)]).to_string());
    assert_snapshot!(messages.join("\n"));
}

/// A row in the memory of a row of buildings with travelling ground motion equals a new row.
#[test]
fn limit_a_renewed_row_is_a_new_one() {
    let weak = elastic(WEAK);
    let storey = |below| {
        weak.on_floor(Floor {
            below,
            ground_damping: 0.0,
        })
    };
    let towers = || {
        let nodes = vec![weak, storey(0), weak, storey(2)];
        let row = Row::new(nodes, vec![]).expect("two buildings");
        row.delayed(vec![0.0, 0.0, 0.1, 0.1]).expect("valid")
    };
    assert!(towers().above(0).is_some(), "a floor above the first");
    let plain = (vec![weak; 3], pairs(3, 0.02, STEREOMECHANICAL));
    let renewed = towers().renewed(plain.0.clone(), plain.1.clone());
    assert_eq!(renewed, Row::new(plain.0, plain.1));
    let bad = vec![Node { damping: f64::NAN, ..weak }];
    let refused = towers().renewed(bad.clone(), vec![]);
    let wanted = row(bad, vec![]).to_string();
    assert_eq!(refused.expect_err("no number").to_string(), wanted);
}

#[test]
fn extreme_settings_out_of_range() {
    let mut messages = Vec::new();
    let row = Row::new(vec![elastic(WEAK)], vec![]).unwrap();
    let clock = Clock {
        time_step: 0.01,
        n_steps: 10,
    };
    messages.push(run(&row, CENTRAL, Clock { time_step: 0.0, ..clock }).to_string());
    messages.push(run(&row, Integrator::Newmark(Newmark { beta: 0.25, gamma: 0.4 }), clock).to_string());
    messages.push(run(&row, Integrator::Newmark(Newmark { beta: -0.1, gamma: 0.5 }), clock).to_string());
    for method in [
        central(0),
        central(1001),
        Integrator::Hht(Hht { alpha: -0.34 }),
        Integrator::Hht(Hht { alpha: 0.01 }),
        moreau_jean(0.49),
        moreau_jean(f64::NAN),
    ] {
        messages.push(run(&row, method, clock).to_string());
    }
    assert_snapshot!(messages.join("\n"));
}

#[test]
fn extreme_a_step_beyond_the_limit_is_caught_and_one_below_is_not() {
    // Critical time step of the central difference and the Verlet method: T/π = 2/ω, for any damping.
    let (mass, stiffness, _) = WEAK;
    let omega = (stiffness / mass).sqrt();
    let node = elastic(WEAK);
    let row = Row::new(vec![node], vec![]).unwrap();
    let clock = |time_step: f64| Clock {
        time_step,
        n_steps: 100_000,
    };
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).unwrap();
    let ratio = node.damping / (2.0 * mass * omega);
    let damping = |beta, gamma| {
        let method = Integrator::Newmark(Newmark { beta, gamma });
        let structure = Oscillation {
            angular_frequency: omega,
            damping_ratio: ratio,
        };
        let critical = method.critical_time_step(&structure).expect("a limit");
        // Above the limit of an undamped structure.
        assert!(critical > 1.001 / (omega * (0.5 * gamma - beta).sqrt()));
        ("Newmark, damping", method, critical)
    };
    for (name, method, critical) in [
        ("central difference", CENTRAL, 2.0 / omega),
        ("Verlet", VERLET, 2.0 / omega),
        ("RK4", RK4, Rk4::critical_time_step(omega, ratio)),
        damping(0.0, 0.7),
        damping(0.1, 0.6),
    ] {
        let work = method.watch(&row, excitation, clock(0.999 * critical), &mut ());
        assert!(work.is_ok(), "{name}, just below the limit: {work:?}");
        let error = run(&row, method, clock(1.01 * critical));
        assert!(matches!(error, RunError::Diverged { .. }), "{name}: {error}");
    }
    assert_snapshot!(run(&row, CENTRAL, clock(1.01 * 2.0 / omega)));
    for method in [AVERAGE, HHT, MOREAU_JEAN] {
        let work = method.watch(&row, excitation, clock(100.0 / omega), &mut ());
        assert!(work.is_ok(), "no limit: {method:?}, {work:?}");
    }
}

#[test]
fn issue_a_motion_that_dies_out_ends_no_run() {
    // HHT damps motions that the step cannot resolve until the squares of its residuals underflow: Newton's method found nothing to halve.
    let row = Row::new(vec![elastic(WEAK)], vec![]).unwrap();
    let excitation = Excitation::new(0.01, &[1.0]).unwrap();
    let clock = Clock {
        time_step: 10.0,
        n_steps: 2000,
    };
    let work = Integrator::Hht(Hht { alpha: -0.3 }).watch(&row, excitation, clock, &mut ());
    assert!(work.is_ok(), "{work:?}");
}

#[test]
fn extreme_a_number_that_overflows_ends_the_run() {
    let samples = [1e308; 2000];
    for (name, method) in METHODS {
        let soft = Node::structure(1.0, 0.0, Elastic { stiffness: 1e-3 });
        let row = Row::new(vec![elastic(WEAK), soft], vec![]).unwrap();
        let excitation = Excitation::new(0.01, &samples).unwrap();
        let outcome = method.watch(
            &row,
            excitation,
            Clock {
                time_step: 0.01,
                n_steps: 2000,
            },
            &mut (),
        );
        let error = outcome.expect_err("infinite displacements are no answer");
        assert!(matches!(error, RunError::Diverged { .. }), "{name}: {error}");
    }
}

#[test]
fn extreme_mass_ratios_and_a_closed_gap() {
    // A mass ratio of a million and no gap: the runs end, and every result is finite.
    for law in [STEREOMECHANICAL, crate::common::VISCOELASTIC] {
        for ratio in [1e-6, 1e6] {
            let (mass, stiffness, yield_force) = WEAK;
            let other = elastic((ratio * mass, 4.0 * ratio * stiffness, yield_force));
            let row = Row::new(vec![elastic(WEAK), other], pairs(2, 0.0, law)).unwrap();
            for (name, method) in METHODS {
                let samples = ground();
                let excitation = Excitation::new(0.01, &samples).unwrap();
                let clock = Clock {
                    time_step: 0.000_1,
                    n_steps: 20_000,
                };
                let work = method.watch(&row, excitation, clock, &mut ());
                assert!(
                    work.as_ref().is_ok_and(|work| work.touching_steps > 0),
                    "{name}, {ratio}, {law:?}: {work:?}"
                );
            }
        }
    }
}
