//! Methods compared under a travelling ground motion: the exact method is the limit of all others.

use pounding_contact::{ContactLaw, LinearSpring};
use pounding_solver::{Elastic, Histories, Integrator, Row};

use crate::common::{LOCATED, METHODS, RK4, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, elastic, ground, histories, pairs, slope};
use crate::travel::{EXACT, towers};

/// Up to the first collisions only: later ones would multiply their errors.
const DURATION: f64 = 2.0;

/// A soft pair, which overlaps for many steps. Other tests cover stiff pairs.
fn soft() -> ContactLaw {
    ContactLaw::LinearSpring(LinearSpring { impact_stiffness: 2e7 })
}

fn row(law: ContactLaw) -> Row<Elastic> {
    let nodes = vec![elastic(WEAK), elastic(STIFF), elastic(WEAK)];
    let row = Row::new(nodes, pairs(3, 0.01, law)).expect("it is valid");
    row.delayed(vec![0.0, 0.06, 0.15]).expect("it is valid")
}

fn towers_in_turn(law: ContactLaw) -> Row<Elastic> {
    let (row, of) = towers(law);
    let arrivals = of.iter().map(|of| [0.0, 0.06, 0.15][*of]).collect();
    row.delayed(arrivals).expect("it is valid")
}

/// The largest distance of displacements at samples of the record, relative to the largest displacement.
fn distance(found: &Histories, wanted: &Histories, n: usize, every: usize) -> f64 {
    let (mut apart, mut largest) = (0.0_f64, 0.0_f64);
    for node in 0..n {
        let wanted = wanted.of(node).states.iter();
        for (one, other) in found.of(node).states.iter().step_by(every).zip(wanted) {
            apart = apart.max((one.displacement - other.displacement).abs());
            largest = largest.max(other.displacement.abs());
        }
    }
    apart / largest
}

fn errors(row: &Row<Elastic>, method: Integrator, steps: &[usize]) -> Vec<f64> {
    let n = row.nodes().len();
    let (exact, _) = histories(row, EXACT, &ground(), clock(0.01, DURATION));
    let error = |every: &usize| {
        let clock = clock(0.01 / *every as f64, DURATION);
        let (found, _) = histories(row, method, &ground(), clock);
        distance(&found, &exact, n, *every)
    };
    steps.iter().map(error).collect()
}

#[test]
fn order_of_runge_kutta_under_a_travelling_motion_is_4() {
    let row = Row::new(vec![elastic(WEAK), elastic(STIFF)], vec![]).expect("it is valid");
    let row = row.delayed(vec![0.0, 0.06]).expect("it is valid");
    let every = [2, 4, 8, 16];
    let found = errors(&row, RK4, &every);
    let steps = every.map(|every| 0.01 / every as f64);
    let order = slope(&steps, &found);
    assert!((order - 4.0).abs() < 0.3, "{order}, {found:?}");
}

#[test]
fn order_of_runge_kutta_through_soft_contact_ends_at_the_exact_method() {
    for row in [row(soft()), towers_in_turn(soft())] {
        let found = errors(&row, RK4, &[512]);
        assert!(found[0] < 2e-8, "{found:?}");
    }
}

/// Order and errors, with steps of 1 ms to 125 µs.
fn order(row: &Row<Elastic>, method: Integrator) -> (f64, Vec<f64>) {
    let every = [10, 20, 40, 80];
    let found = errors(row, method, &every);
    (slope(&every.map(|every| 0.01 / every as f64), &found), found)
}

#[test]
fn order_of_every_method_through_soft_contact_is_2() {
    for row in [row(soft()), towers_in_turn(soft())] {
        for (name, method) in METHODS {
            let (order, errors) = order(&row, method);
            assert!(order > 1.9, "{name}: {order}, {errors:?}");
            assert!(errors[3] < 2e-6, "{name}: {errors:?}");
        }
    }
}

#[test]
fn order_of_located_impacts_on_grounds_that_move_apart_is_2() {
    let (order, errors) = order(&row(STEREOMECHANICAL), LOCATED);
    assert!((order - 2.0).abs() < 0.1, "{order}, {errors:?}");
}

#[test]
fn limit_every_method_comes_near_the_exact_one() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        for row in [row(law), towers_in_turn(law)] {
            for (name, method) in METHODS {
                let found = errors(&row, method, &[10, 320]);
                assert!(found[1] < 1.5e-3, "{name}, {law:?}: {found:?}");
                assert!(found[1] < 0.3 * found[0], "{name}, {law:?}: {found:?}");
            }
        }
    }
}
