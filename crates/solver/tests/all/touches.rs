//! Accuracy of the instant of a touch.

use pounding_contact::ContactLaw;
use pounding_solver::{Collision, Collisions, Elastic, Exact, Excitation, Integrator, Node, Row};

use crate::common::{METHODS, STEREOMECHANICAL, VISCOELASTIC, clock, pairs};
use crate::watch::Watch;

/// First collision of an oscillator (period 2π s, velocity 1 m/s at t = 0: u = sin t) with a wall.
fn first(gap: f64, law: ContactLaw, method: Integrator) -> Option<Collision> {
    let oscillator = Node {
        initial_velocity: 1.0,
        ..Node::structure(1.0, 0.0, Elastic { stiffness: 1.0 })
    };
    let wall = Node::wall(Elastic { stiffness: 1.0 });
    let row = Row::new(vec![oscillator, wall], pairs(2, gap, law)).expect("the row is valid");
    let mut collisions = Collisions::new(2, row.pairs());
    let excitation = Excitation::new(1.0, &[0.0]).expect("the ground motion is finite");
    method
        .watch(&row, excitation, clock(1e-3, 2.0), &mut collisions)
        .expect("the run ends");
    collisions.all().first().copied()
}

#[test]
fn limit_a_touch_moves_by_its_uncertainty() {
    // Rounding of displacement and gap near u = gap = 1 m.
    let rounding = 8.0 * f64::EPSILON * 2.0;
    let exact = Integrator::Exact(Exact::default());
    let touch = |gap: f64, law| {
        let collision = first(gap, law, exact).expect("it touches");
        (collision.start, collision.uncertainty.expect("a gap closed"))
    };
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        for above in [1.0, 3.0, 100.0] {
            // The peak is `above` roundings beyond the gap.
            let gap = 1.0 - above * rounding;
            let (start, uncertainty) = touch(gap, law);
            let (later, earlier) = (touch(gap + 0.9 * rounding, law).0, touch(gap - rounding, law).0);
            let moved = (later - start).max(start - earlier);
            assert!(
                (0.6..1.1).contains(&(moved / uncertainty)),
                "{above} roundings: {uncertainty:e} s stated, {moved:e} s moved"
            );
            assert!((start - libm::asin(gap)).abs() < 1.1 * uncertainty, "{above} roundings: {start} s");
            // √(2s/a) just below the peak, s/v far below it.
            let known = rounding / (2.0 * above * rounding).sqrt();
            assert!((0.9..2.1).contains(&(uncertainty / known)), "{uncertainty:e} {known:e}");
        }
        for gap in [0.01, 0.5, 0.99] {
            let (start, uncertainty) = touch(gap, law);
            assert!(uncertainty < 1e-12 && uncertainty > 0.0, "{uncertainty:e}");
            assert!((start - libm::asin(gap)).abs() < uncertainty, "{gap} m: {start} s");
            for moved in [gap + rounding * gap, gap - rounding * gap] {
                let distance = (touch(moved, law).0 - start).abs();
                assert!(distance < 1.1 * uncertainty, "{distance:e} {uncertainty:e}");
            }
        }
    }
}

#[test]
fn limit_a_step_states_no_uncertainty() {
    for (name, method) in METHODS {
        let collision = first(0.5, STEREOMECHANICAL, method).expect("it touches");
        assert_eq!(collision.uncertainty, None, "{name}");
    }
}
