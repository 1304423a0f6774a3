//! Impulsive neighbours in lanes that come to rest against each other, are pressed together by a slow ground, and part.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Elastic, Node, Row};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use crate::lanes_exact::{alone, beside, distance, row_of, scaled};
use crate::lanes_in_contact::moving;
use crate::random_rows::config;

/// What rounding of the data leaves open.
const ROUNDING: f64 = 1e-13;

fn rows() -> impl Strategy<Value = Row<Elastic>> {
    let side = || {
        let column = (0.13..1.0_f64, 0.0..0.2_f64);
        let start = (-0.001..0.001_f64, -0.2..0.2_f64);
        let structure = (4.0..7.0_f64, column, start).prop_map(|(log_mass, column, start)| {
            moving(libm::pow(10.0, log_mass), column.into(), start.into())
        });
        prop_oneof![
            4 => structure,
            1 => Just(Node::wall(Elastic { stiffness: 1.0 })),
        ]
    };
    let restitution = prop_oneof![1 => Just(0.0), 4 => 0.0..0.99_f64];
    let rows = (side(), side(), 0.002..0.02_f64, restitution);
    let two_walls = |row: &(Node<Elastic>, Node<Elastic>, f64, f64)| {
        row.0.inverse_mass + row.1.inverse_mass == 0.0
    };
    let rows = rows.prop_filter("two walls", move |row| !two_walls(row));
    rows.prop_map(|(left, right, gap, restitution)| {
        let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
        row_of([left, right], gap, law)
    })
}

/// A ground that pushes for a second or so in one direction, and stops.
fn slow_ground() -> impl Strategy<Value = Vec<f64>> {
    let wave = (1.0..4.0_f64, 0.0..6.3_f64, 1.0..6.0_f64);
    (wave, 100..190_usize).prop_map(|((period, phase, amplitude), n)| {
        let omega = 2.0 * std::f64::consts::PI * 0.02 / period;
        (0..n)
            .map(|sample| amplitude * libm::sin(phase + omega * sample as f64))
            .collect()
    })
}

proptest! {
    #![proptest_config(config(48))]

    #[test]
    fn reference_rest_in_lanes_is_that_of_a_run_alone(
        rows in prop::collection::vec(rows(), 11),
        ground in slow_ground(),
    ) {
        for (row, told) in rows.iter().zip(beside(&rows, &ground, 1e-9)) {
            let Some(told) = told else {
                continue;
            };
            let exact = alone(row, &ground);
            prop_assert!(exact.is_some(), "{row:?}");
            let exact = exact.expect("asserted");
            let moved = alone(row, &scaled(&ground, 1.0 + ROUNDING)).expect("it ran before");
            let condition = distance(&exact, &moved.0);
            let error = distance(&exact, &told);
            prop_assert!(error <= 100.0 * (ROUNDING + condition), "{error:e} {condition:e} {row:?} {exact:?} {told:?}");
            if condition < 1e-6 {
                prop_assert!((exact.0.1[1] - told.1[1]).abs() < 0.5, "{row:?} {exact:?} {told:?}");
            }
        }
    }
}

/// Rows that are not told run alone with a ledger, which costs thirty times what their lanes do.
#[test]
fn limit_rows_that_rest_are_told() {
    let mut runner = TestRunner::deterministic();
    let (mut told, mut all) = (0, 0);
    for _ in 0..40 {
        let drawn = (prop::collection::vec(rows(), 11), slow_ground()).new_tree(&mut runner);
        let (rows, ground) = drawn.expect("rows are drawn").current();
        told += beside(&rows, &ground, 1e-9).iter().flatten().count();
        all += rows.len();
    }
    assert!(100 * told >= 98 * all, "{told} of {all} are told");
}
