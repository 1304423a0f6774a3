//! Impulsive neighbours in lanes that come to rest against each other, are pressed together by a slow ground, and part.

use std::f64::consts::PI;

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Collision, Collisions, Elastic, Exact, Excitation, Integrator, Node, Row};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use crate::common::moving;
use crate::exact::{CLOCK, GROUND_STEP, alone, beside, distance, row_of, scaled};
use crate::random_rows::config;

/// Effect of the rounding of the data.
const ROUNDING: f64 = 1e-13;

fn rows() -> impl Strategy<Value = Row<Elastic>> {
    let side = || {
        // Undamped structures return without speed to a neighbour that they left: rounding decides whether they touch.
        let column = (0.13..1.0_f64, 0.01..0.2_f64);
        let start = (-0.001..0.001_f64, -0.2..0.2_f64);
        let start = prop_oneof![2 => start, 1 => Just((0.0, 0.0))];
        let structure = (4.0..7.0_f64, column, start)
            .prop_map(|(log_mass, column, start)| moving(libm::pow(10.0, log_mass), column.into(), start.into()));
        prop_oneof![
            4 => structure,
            1 => Just(Node::wall(Elastic { stiffness: 1.0 })),
        ]
    };
    let neighbours = prop_oneof![
        6 => (side(), side()),
        1 => side().prop_map(|side| (side, side)),
    ];
    let restitution = prop_oneof![1 => Just(0.0), 4 => 0.0..0.99_f64, 1 => 0.99..=1.0_f64];
    let gap = prop_oneof![1 => Just(0.0), 2 => 0.002..0.02_f64];
    let is_clear = |(left, right): &(Node<Elastic>, Node<Elastic>), gap: f64| {
        left.inverse_mass + right.inverse_mass > 0.0 && left.initial_displacement - right.initial_displacement <= gap
    };
    let rows = (neighbours, gap, restitution);
    let rows = rows.prop_filter("two walls, or an overlap", move |row| is_clear(&row.0, row.1));
    rows.prop_map(|((left, right), gap, restitution)| {
        let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
        row_of([left, right], gap, law)
    })
}

/// A ground that pushes for about a second in one direction, or in steps with pauses, and stops.
fn slow_ground() -> impl Strategy<Value = Vec<f64>> {
    let wave = (1.0..4.0_f64, 0.0..6.3_f64, 1.0..6.0_f64);
    let waves = (wave, 100..190_usize).prop_map(|((period, phase, amplitude), n)| {
        let omega = 2.0 * PI * 0.02 / period;
        (0..n).map(|sample| amplitude * libm::sin(phase + omega * sample as f64)).collect()
    });
    let steps = prop::collection::vec((-3..=3_i32, 5..40_usize), 2..6);
    let steps = steps.prop_map(|steps| {
        let step = |(value, n): (i32, usize)| std::iter::repeat_n(f64::from(value), n);
        steps.into_iter().flat_map(step).take(190).collect()
    });
    prop_oneof![2 => waves, 1 => steps]
}

/// Collisions of a run alone; empty if it ends with an error.
fn collisions(row: &Row<Elastic>, ground: &[f64]) -> Vec<Collision> {
    let excitation = Excitation::new(GROUND_STEP, ground).expect("the record is finite");
    let mut collisions = Collisions::new(2, row.pairs());
    let run = Integrator::Exact(Exact::default()).run(row, excitation, CLOCK, &mut collisions);
    run.map_or(vec![], |_| collisions.all().to_vec())
}

proptest! {
    #![proptest_config(config(200))]

    #[test]
    fn reference_rest_in_lanes_is_that_of_a_run_alone(
        rows in prop::collection::vec(rows(), 11),
        ground in slow_ground(),
    ) {
        for (row, told) in rows.iter().zip(beside(&rows, &ground, 1e-9)) {
            let Some(told) = told else {
                continue;
            };
            let both = [1.0, 1.0 + ROUNDING].map(|by| alone(row, &scaled(&ground, by)));
            let [Some(exact), Some(moved)] = both else {
                return Err(TestCaseError::fail(format!("no run alone: {row:?}")));
            };
            let condition = distance(&exact, &moved.0);
            let error = distance(&exact, &told);
            prop_assert!(error <= 100.0 * (ROUNDING + condition), "{error:e} {condition:e} {row:?} {exact:?} {told:?}");
            if condition < 1e-6 {
                prop_assert!((told.1[1] - exact.0.1[1]).abs() < 0.5, "{row:?} {exact:?} {told:?}");
            }
        }
    }
}

/// Lanes give the results of most rows whose neighbours come to rest after a gap.
#[test]
fn limit_rows_that_rest_are_told() {
    let mut runner = TestRunner::deterministic();
    let (mut told, mut all) = (0, 0);
    for _ in 0..40 {
        let drawn = (prop::collection::vec(rows(), 11), slow_ground()).new_tree(&mut runner);
        let (rows, ground) = drawn.expect("rows are drawn").current();
        for (row, found) in rows.iter().zip(beside(&rows, &ground, 1e-9)) {
            let rests = |one: &Collision| one.end - one.start > 0.02;
            if row.pairs()[0].gap() > 0.0 && collisions(row, &ground).iter().any(rests) {
                all += 1;
                told += usize::from(found.is_some());
            }
        }
    }
    assert!(all >= 50, "{all} rest");
    assert!(10 * told >= 9 * all, "{told} of {all} are told");
}

/// A structure that swings against a wall without a gap hits it every half period, however small its motion is. The rounding of its force
/// from the first swing stayed when the motion decayed: the exact method alone counted 44 impacts instead of 80.
#[test]
fn issue_a_motion_that_dies_away_keeps_its_impacts() {
    for (period, ratio, restitution) in [(0.15, 0.1, 0.1), (0.2, 0.1, 0.3), (0.13, 0.02, 0.6), (0.3, 0.05, 0.01)] {
        let wall = Node::wall(Elastic { stiffness: 1.0 });
        let structure = moving(1e5, [period, ratio], [-0.03, 0.0]);
        let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
        let row = row_of([structure, wall], 0.0, law);
        let damped = libm::sqrt(1.0 - ratio * ratio) * 2.0 * PI / period;
        let first = (0.5 * PI + libm::asin(ratio)) / damped;
        let wanted = 1.0 + libm::floor((CLOCK.time(CLOCK.n_steps) - first) * damped / PI);
        let ground = [0.0; 10];
        let (exact, _) = alone(&row, &ground).expect("it runs");
        let told = beside(std::slice::from_ref(&row), &ground, 1e-9)[0].expect("told");
        for counted in [exact.1[1], told.1[1]] {
            assert!((counted - wanted).abs() < 0.5, "{period} {restitution}: {counted} of {wanted}");
        }
    }
}

/// A light structure starts farther to the left than a heavy structure pushes it back: only the heavy structure has its peak at rest.
#[test]
fn reference_one_of_two_at_rest_is_farther_than_ever() {
    let light = moving(1e4, [0.35, 0.05], [-0.03, 0.0]);
    let heavy = moving(1e6, [0.4, 0.05], [0.0, -0.3]);
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.0 });
    let row = row_of([light, heavy], 0.0, law);
    let ground = [0.0; 10];
    let exact = alone(&row, &ground).expect("it runs");
    let told = beside(std::slice::from_ref(&row), &ground, 1e-9)[0].expect("told");
    let error = distance(&exact, &told);
    assert!(error < 1e-12, "{error:e}: {exact:?} {told:?}");
}
