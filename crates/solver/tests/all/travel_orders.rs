//! Methods against each other under a ground motion that travels: the exact one is the limit of all others.

use pounding_contact::ContactLaw;
use pounding_solver::{Elastic, Histories, Integrator, Row};

use crate::common::{
    METHODS, RK4, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, elastic, ground, histories,
    pairs, slope,
};
use crate::travel::{EXACT, towers};

/// Up to the first collisions only: later ones would multiply their errors.
const DURATION: f64 = 2.0;

/// A soft pair, which overlaps for many steps: what a step makes of a stiff one is the matter of other tests.
fn soft() -> ContactLaw {
    ContactLaw::LinearViscoelastic(pounding_contact::LinearViscoelastic {
        impact_stiffness: 2e7,
        impact_damping_ratio: 0.0,
    })
}

fn row(law: ContactLaw) -> Row<Elastic> {
    let nodes = vec![elastic(WEAK), elastic(STIFF), elastic(WEAK)];
    let row = Row::new(nodes, pairs(3, 0.01, law)).unwrap();
    row.delayed(vec![0.0, 0.06, 0.15]).unwrap()
}

fn towers_in_turn(law: ContactLaw) -> Row<Elastic> {
    let (row, of) = towers(law);
    let arrivals = of.iter().map(|of| [0.0, 0.06, 0.15][*of]).collect();
    row.delayed(arrivals).unwrap()
}

/// The largest distance of displacements at samples of the record, relative to the largest of them.
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
    let row = Row::new(vec![elastic(WEAK), elastic(STIFF)], vec![]).unwrap();
    let row = row.delayed(vec![0.0, 0.06]).unwrap();
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

#[test]
fn order_of_every_method_tends_to_the_exact_one() {
    for law in [soft(), STEREOMECHANICAL, VISCOELASTIC] {
        for row in [row(law), towers_in_turn(law)] {
            for (name, method) in METHODS {
                let published = method == crate::common::CENTRAL && law == STEREOMECHANICAL;
                // The published rule does not converge.
                if published {
                    continue;
                }
                let every = [10, 20, 40, 80];
                let found = errors(&row, method, &every);
                let steps = every.map(|every| 0.01 / every as f64);
                let order = slope(&steps, &found);
                println!(
                    "{name}, {law:?}, {}: {order:.2} {found:.1e?}",
                    row.nodes().len()
                );
                assert!(order > 0.7, "{name}, {law:?}: {order}, {found:?}");
                assert!(found[3] < 0.02, "{name}, {law:?}: {found:?}");
            }
        }
    }
}
