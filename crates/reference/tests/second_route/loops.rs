//! Loops of columns that harden or yield smoothly, below a floor so heavy that they do not move it.

use libm::{exp, tan, tanh};
use pounding_reference::{Response, StructureResponse};
use pounding_solver::{Bilinear, BoucWen, Elastic, Floor, Hysteretic, Node, Row, Smoothness};

use super::{close, run};

const STIFFNESS: f64 = 1e5;
const YIELD_FORCE: f64 = 1e3;
const HARDENING: f64 = 0.1;
const UNIT: f64 = YIELD_FORCE / STIFFNESS;

/// A floor that starts with `speed` \[m/s\] and decelerates at 1 m/s²: its drift is speed·t − t²/2.
fn thrown<Column: Hysteretic>(column: Column, speed: f64, duration: f64) -> StructureResponse {
    let node = Node {
        initial_velocity: speed,
        ..Node::structure(1e25, 0.0, column)
    };
    let row = Row::new(vec![node], vec![]).expect("a valid row");
    run(&row, &[1.0; 100], duration).structures[0]
}

/// The floor as upper storey of a building whose first floor moves alike: the drift has no deceleration.
fn thrown_upstairs<Column: Hysteretic>(column: Column, speed: f64, duration: f64) -> StructureResponse {
    let lower = Node::structure(1e25, 0.0, column);
    let upper = Node {
        initial_velocity: speed,
        ..Node::structure(1e25, 0.0, column)
    };
    let upper = upper.on_floor(Floor {
        below: 0,
        ground_damping: 0.0,
    });
    let row = Row::new(vec![lower, upper], vec![]).expect("a valid row");
    // Both floors decelerate, so that the drift is speed·t.
    run(&row, &[1.0; 100], duration).structures[1]
}

/// A building of two storeys under two seconds of shaking.
fn shaken<Column: Hysteretic>(column: Column) -> Response {
    let upper = Node::structure(1e3, 200.0, column).on_floor(Floor {
        below: 0,
        ground_damping: 30.0,
    });
    let nodes = vec![Node::structure(2e3, 300.0, column), upper];
    let row = Row::new(nodes, vec![]).expect("a valid row");
    run(&row, &[0.0, 2.0, -3.0, 1.0, 4.0, -2.0], 2.0)
}

/// Time at which a floor with initial velocity √(2·`top`) returns to a drift \[s\].
fn back_at(top: f64, drift: f64) -> f64 {
    let speed = (2.0 * top).sqrt();
    speed + (2.0 * (top - drift)).sqrt()
}

#[test]
fn reference_a_bilinear_loop_by_hand() {
    let column = Bilinear {
        stiffness: STIFFNESS,
        yield_force: YIELD_FORCE,
        hardening: HARDENING,
    };
    // To 30 mm: 1000 + 0.1·100e3·0.02 = 1200 N. Back: yields after twice 10 mm, at −800 N. At −30 mm: −1200 N.
    for (drift, force) in [(0.02, 200.0), (0.0101, -790.0), (0.0099, -801.0), (-0.03, -1200.0)] {
        let found = thrown(column, 0.06_f64.sqrt(), back_at(0.03, drift));
        close(found.end_displacement, drift, 1e-13, "drift");
        close(found.end_restoring_force, force, 1e-12, "force");
        if force > -1100.0 {
            close(found.restoring_force.value, 1200.0, 1e-13, "peak force");
            close(found.drift.value, 0.03, 1e-13, "peak drift");
        }
    }
    for (drift, force) in [(0.004, 400.0), (0.03, 1200.0)] {
        let found = thrown_upstairs(column, drift, 1.0);
        close(found.drift.value, drift, 1e-13, "drift of an upper storey");
        close(found.end_restoring_force, force, 1e-12, "its force");
    }
}

/// y = z k/`f_y` after a first drift to `s` yield displacements.
fn loaded(exponent: u32, s: f64) -> f64 {
    match exponent {
        1 => 1.0 - exp(-s),
        _ => tanh(s),
    }
}

/// y after the drift has gone back by `s` from y₀ > 0: dy/ds = −(1 − c yⁿ) while y > 0, c = γ − β. A first drift to the other side follows.
fn unloaded(exponent: u32, unloading: f64, from: f64, s: f64) -> f64 {
    let c = 1.0 - 2.0 * unloading;
    // Drift at which y vanishes.
    let zero = match exponent {
        _ if c == 0.0 => from,
        1 => -libm::log(1.0 - c * from) / c,
        _ if c < 0.0 => libm::atan((-c).sqrt() * from) / (-c).sqrt(),
        _ => libm::atanh(c.sqrt() * from) / c.sqrt(),
    };
    let left = zero - s;
    if left < 0.0 {
        return -loaded(exponent, -left);
    }
    match exponent {
        _ if c == 0.0 => left,
        1 => (1.0 - exp(-c * left)) / c,
        _ if c < 0.0 => tan((-c).sqrt() * left) / (-c).sqrt(),
        _ => tanh(c.sqrt() * left) / c.sqrt(),
    }
}

fn force(drift: f64, y: f64) -> f64 {
    HARDENING * STIFFNESS * drift + (1.0 - HARDENING) * YIELD_FORCE * y
}

fn bouc_wen(exponent: u32, unloading: f64) -> BoucWen {
    BoucWen {
        stiffness: STIFFNESS,
        yield_force: YIELD_FORCE,
        hardening: HARDENING,
        smoothness: Smoothness { exponent, unloading },
    }
}

#[test]
fn reference_bouc_wen_loops_in_closed_form() {
    for (exponent, unloading) in [(1, 0.5), (1, 0.7), (1, 0.2), (2, 0.5), (2, 0.7), (2, 0.2)] {
        let column = bouc_wen(exponent, unloading);
        let top = 3.0;
        let there = loaded(exponent, top);
        for s in [2.5, 1.7, 0.4, -2.0] {
            let what = format!("n = {exponent}, β = {unloading}, back to {s}");
            let speed = (2.0 * top * UNIT).sqrt();
            let found = thrown(column, speed, back_at(top * UNIT, s * UNIT));
            let y = unloaded(exponent, unloading, there, top - s);
            let wanted = force(s * UNIT, y);
            let error = (found.end_restoring_force - wanted).abs();
            assert!(error < 1e-12 * YIELD_FORCE, "{what}: {error:e} N");
            close(found.restoring_force.value, force(top * UNIT, there), 1e-13, &what);
        }
        let found = thrown_upstairs(column, 2.0 * UNIT, 1.0);
        let wanted = force(2.0 * UNIT, loaded(exponent, 2.0));
        close(found.end_restoring_force, wanted, 1e-13, "upper storey");
    }
}

#[test]
fn reference_a_first_drift_at_the_start() {
    for exponent in [1, 2] {
        let drift = 0.7 * UNIT;
        let node = Node {
            initial_displacement: -drift,
            ..Node::structure(1e25, 0.0, bouc_wen(exponent, 0.4))
        };
        let row = Row::new(vec![node], vec![]).expect("a valid row");
        let found = run(&row, &[0.0], 0.1).structures[0];
        let wanted = -force(drift, loaded(exponent, 0.7));
        close(found.end_restoring_force, wanted, 1e-13, "force");
    }
}

#[test]
fn limit_a_yield_force_never_reached_is_elastic() {
    let end = |row: Response| {
        let of = row.structures[1];
        (of.end_displacement, of.end_velocity, of.drift)
    };
    let elastic = end(shaken(Elastic { stiffness: STIFFNESS }));
    let bilinear = |yield_force| Bilinear {
        stiffness: STIFFNESS,
        yield_force,
        hardening: HARDENING,
    };
    let endless = BoucWen {
        yield_force: f64::INFINITY,
        ..bouc_wen(2, 0.5)
    };
    assert_eq!(elastic, end(shaken(bilinear(f64::INFINITY))));
    assert_eq!(elastic, end(shaken(endless)));
    let (far, wanted) = (end(shaken(bilinear(1e9))), elastic);
    close(far.0, wanted.0, 1e-13, "displacement");
}
