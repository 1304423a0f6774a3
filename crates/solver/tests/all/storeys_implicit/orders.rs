//! Orders of the implicit methods on towers, and their common limit.

use pounding_solver::{Hysteretic, Integrator, Row, TransferredMomentum};

use super::{DAMPING, IMPLICIT, SPRING, apart, bilinear, elastic, facing, off, plastic, run, sampled, smooth, towers};
use crate::common::{RK4, VISCOELASTIC, clock, ground, slope};
use crate::towers::{row, uniform};

#[test]
fn order_without_contact_is_two() {
    let (row, _) = row(&[uniform(3, 1e5, elastic(5e7))], DAMPING, |_, _, _| None);
    let (truth, _) = sampled(&row, RK4, &ground(), clock(2e-4, 5.0));
    let steps = [0.01, 0.005, 0.0025, 0.00125];
    for (name, method) in IMPLICIT {
        let error = |step: &f64| apart(&sampled(&row, method, &ground(), clock(*step, 5.0)).0, &truth);
        let errors: Vec<_> = steps.iter().map(error).collect();
        let slope = slope(&steps, &errors);
        assert!((slope - 2.0).abs() < 0.15, "{name}: {slope} {errors:?}");
    }
}

/// Momentum transferred by all pairs of a row \[N·s\], for smaller and smaller steps, and finally by the Runge–Kutta method.
fn totals<Column: Hysteretic>(row: &Row<Column>, method: Integrator, step: f64) -> Vec<f64> {
    let mut momentum = TransferredMomentum::new(row.nodes().len());
    let work = run(row, method, (&ground(), clock(step, 2.0)), &mut momentum);
    assert!(work.touching_steps > 0, "the row must collide");
    (0..row.nodes().len()).map(|node| momentum.of(node)).collect()
}

#[test]
fn order_pounding_towers_converge_to_the_totals_of_the_runge_kutta_method() {
    for (law, allowed) in [(SPRING, 1e-4), (VISCOELASTIC, 1e-3)] {
        let (row, _) = row(&towers(elastic), DAMPING, facing(0.005, law));
        let truth = totals(&row, RK4, 1e-5);
        for (name, method) in IMPLICIT {
            let errors = [1e-3, 1e-4].map(|step| off(&totals(&row, method, step), &truth));
            assert!(errors[1] < allowed && errors[1] < 0.3 * errors[0], "{name}: {errors:?}");
        }
    }
}

/// The implicit methods against the Runge–Kutta method at a small step.
fn compare<Column: Hysteretic>(name: &str, column: impl Fn(f64) -> Column, allowed: f64) {
    let (row, _) = row(&towers(column), DAMPING, facing(0.005, SPRING));
    let truth = sampled(&row, RK4, &ground(), clock(1e-5, 2.0)).0;
    for (method_name, method) in IMPLICIT {
        let errors = [1e-3, 1e-4].map(|step| {
            let (states, work) = sampled(&row, method, &ground(), clock(step, 2.0));
            assert!(work.touching_steps > 0, "the row must collide");
            apart(&states, &truth)
        });
        assert!(
            errors[1] < allowed && errors[1] < 0.5 * errors[0],
            "{name}, {method_name}: {errors:?}"
        );
    }
}

#[test]
fn order_yielding_storeys_converge() {
    compare("elastic", elastic, 1e-5);
    compare("perfectly plastic", plastic, 1e-5);
    compare("bilinear", bilinear, 1e-5);
    compare("Bouc-Wen", smooth, 1e-5);
}
