//! Orders of convergence: two where theory says two, measured and printed where contact or yielding lowers it.

use std::fmt::Write;

use insta::assert_snapshot;
use pounding_solver::{
    Elastic, Excitation, Integrator, Node, PiecewiseLinear, Recorder, Row, TransferredMomentum,
};

use crate::common::{
    METHODS, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, elastic, ground, histories, pairs,
    slope, yielding,
};

/// Displacement of a damped structure released at u₀ under a load that rises linearly: closed form.
fn ramp(node: &Node<Elastic>, initial: f64, rate: f64, time: f64) -> f64 {
    let (omega2, c) = (
        node.column.stiffness * node.inverse_mass,
        node.damping * node.inverse_mass,
    );
    let decay = 0.5 * c;
    let frequency = (omega2 - decay * decay).sqrt();
    // u = p t + q + e^(−dt) (a cos ωt + b sin ωt) solves ü + c u̇ + ω² u = −rate·t.
    let p = -rate / omega2;
    let q = -c * p / omega2;
    let a = initial - q;
    let b = (decay * a - p) / frequency;
    p * time
        + q
        + libm::exp(-decay * time)
            * (a * libm::cos(frequency * time) + b * libm::sin(frequency * time))
}

#[test]
fn order_is_two_without_contact() {
    let node = Node {
        initial_displacement: 0.01,
        ..elastic(WEAK)
    };
    let samples: Vec<f64> = (0..=400).map(|i| 0.01 * f64::from(i)).collect();
    for (name, method) in METHODS {
        let row = Row::new(vec![node], vec![]).unwrap();
        let steps = [0.01, 0.005, 0.0025, 0.00125];
        let errors = steps.map(|dt| {
            let (histories, _) = histories(&row, method, &samples, clock(dt, 4.0));
            let errors = histories.of(0).states.iter().enumerate().map(|(i, state)| {
                (state.displacement - ramp(&node, 0.01, 1.0, i as f64 * dt)).abs()
            });
            errors.fold(0.0, f64::max)
        });
        let order = slope(&steps, &errors);
        assert!(
            (order - 2.0).abs() < 0.2,
            "{name}: order {order}, errors {errors:?}"
        );
    }
}

/// A quantity of a run at one time step.
fn measure<Column: PiecewiseLinear>(
    row: &Row<Column>,
    method: Integrator,
    time_step: f64,
    recorder: &mut impl Recorder,
) {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).expect("the motion is finite");
    // Up to the end of the first collisions only: later ones would multiply the errors of the first.
    method
        .run(row, excitation, clock(time_step, 3.0), recorder)
        .expect("the run ends");
}

/// Order of the transferred momentum, or of the last displacement where nothing touches.
fn observed(row: &Row<impl PiecewiseLinear>, method: Integrator) -> (f64, Vec<f64>) {
    let quantity = |time_step| {
        let mut recorder = (
            TransferredMomentum::new(row.nodes().len()),
            pounding_solver::Histories::new(row.nodes().len(), 0.01, 3.0),
        );
        measure(row, method, time_step, &mut recorder);
        if row.pairs().is_empty() {
            recorder
                .1
                .of(0)
                .states
                .last()
                .expect("states were recorded")
                .displacement
        } else {
            recorder.0.of(0)
        }
    };
    let steps: Vec<f64> = (0..8)
        .map(|halvings| 0.002 / f64::from(1 << halvings))
        .collect();
    let reference = quantity(0.002 / 4096.0);
    let errors: Vec<f64> = steps
        .iter()
        .map(|dt| (quantity(*dt) / reference - 1.0).abs())
        .collect();
    (slope(&steps, &errors), errors)
}

#[test]
fn order_with_yielding_and_contact_is_measured() {
    let mut table = String::new();
    let mut line = |what: &str, name: &str, (order, errors): (f64, Vec<f64>)| {
        let errors: Vec<_> = errors.iter().map(|error| format!("{error:.0e}")).collect();
        writeln!(
            table,
            "{what:<28} {name:<18} order {order:>4.1}   errors {}",
            errors.join(" ")
        )
        .expect("a string takes all");
    };
    for (name, method) in METHODS {
        let alone = Row::new(vec![yielding(WEAK)], vec![]).unwrap();
        line("yielding", name, observed(&alone, method));
        for (law_name, law) in [
            ("stereomechanical", STEREOMECHANICAL),
            ("viscoelastic", VISCOELASTIC),
        ] {
            let row = Row::new(vec![elastic(WEAK), elastic(STIFF)], pairs(2, 0.02, law)).unwrap();
            line(&format!("{law_name} elastic"), name, observed(&row, method));
            let row = Row::new(vec![yielding(WEAK), yielding(STIFF)], pairs(2, 0.02, law)).unwrap();
            line(
                &format!("{law_name} nonlinear"),
                name,
                observed(&row, method),
            );
        }
    }
    assert_snapshot!(table);
}
