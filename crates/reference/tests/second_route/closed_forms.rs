//! A single structure without contact.

use libm::{acos, cos, exp, sin};
use pounding_solver::{Bilinear, Node, Row};

use super::{Elastic, close, run};

/// Displacement and velocity of a structure of unit mass at rest at t = 0, under a ground acceleration a + b t.
fn under_ramp(omega: f64, zeta: f64, [a, b]: [f64; 2], t: f64) -> (f64, f64) {
    let (stiffness, damping) = (omega * omega, 2.0 * zeta * omega);
    // u = p + q t satisfies the equation of motion; a free vibration from (−p, −q) is added.
    let q = -b / stiffness;
    let p = -(a + damping * q) / stiffness;
    let (u, v) = (-p, -q);
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    let (c, s, decay) = (cos(damped * t), sin(damped * t), exp(-zeta * omega * t));
    let slope = (v + zeta * omega * u) / damped;
    let free = decay * (u * c + slope * s);
    let rate = decay * ((slope * damped - zeta * omega * u) * c - (u * damped + zeta * omega * slope) * s);
    (p + q * t + free, q + rate)
}

#[test]
fn reference_a_structure_under_a_ramp() {
    for (omega, zeta) in [(5.24, 0.058), (20.9, 0.029), (3.0, 0.0)] {
        let ramp = [0.4, -0.3];
        let stiffness = omega * omega;
        let node = Node::structure(1.0, 2.0 * zeta * omega, Elastic { stiffness });
        let row = Row::new(vec![node], vec![]).unwrap();
        let ground: Vec<f64> = (0..32).map(|i| ramp[0] + 0.1 * ramp[1] * f64::from(i)).collect();
        let found = &run(&row, &ground, 3.0).structures[0];
        let (displacement, velocity) = under_ramp(omega, zeta, ramp, 3.0);
        let peak = found.displacement;
        let scale = peak.value.abs();
        assert!(
            (found.end_displacement - displacement).abs() < 1e-14 * scale,
            "{omega}, {zeta}: {} against {displacement}",
            found.end_displacement
        );
        assert!(
            (found.end_velocity - velocity).abs() < 1e-14 * omega * scale,
            "{omega}, {zeta}: {} against {velocity}",
            found.end_velocity
        );
        let (there, rate) = under_ramp(omega, zeta, ramp, peak.time);
        close(peak.value, there, 1e-14, "peak displacement");
        assert!(rate.abs() < 1e-14 * omega * scale, "velocity {rate} at the peak");
        close(found.restoring_force.value, stiffness * there, 1e-14, "peak restoring force");
    }
}

#[test]
fn extreme_the_ground_stops_at_the_last_sample() {
    // Ground acceleration 1 for 0.2 s, then 0: a free mass keeps its velocity.
    let row = Row::new(vec![Node::structure(1.0, 0.0, super::FREE)], vec![]).unwrap();
    let found = &run(&row, &[1.0, 1.0, 1.0], 0.5).structures[0];
    close(found.end_velocity, -0.2, 1e-15, "velocity");
    close(found.end_displacement, -(0.02 + 0.2 * 0.3), 1e-15, "displacement");
}

#[test]
fn reference_yield_and_unloading_under_a_constant_load() {
    let (omega, load, yield_force) = (7.0, 3.0, 4.0);
    let stiffness = omega * omega;
    let column = Bilinear {
        stiffness,
        yield_force,
        hardening: 0.0,
    };
    let row = Row::new(vec![Node::structure(1.0, 0.0, column)], vec![]).unwrap();
    let found = &run(&row, &[-load; 12], 1.0).structures[0];
    // Elastic from rest: u = (p/k)(1 − cos ωt), which reaches f_y/k while it rises.
    let cosine = 1.0 - yield_force / load;
    let first_yield = acos(cosine) / omega;
    let speed = load / omega * (1.0 - cosine * cosine).sqrt();
    // Plastic: constant deceleration to rest; then elastic again about a shifted centre.
    let deceleration = yield_force - load;
    let time = first_yield + speed / deceleration;
    let peak = yield_force / stiffness + 0.5 * speed * speed / deceleration;
    close(found.displacement.value, peak, 1e-14, "peak displacement");
    close(found.displacement.time, time, 1e-14, "its time");
    close(found.restoring_force.value, yield_force, 0.0, "peak restoring force");
    close(found.restoring_force.time, first_yield, 1e-14, "first yield");
    let centre = peak - (yield_force - load) / stiffness;
    let end = centre + (peak - centre) * cos(omega * (1.0 - time));
    close(found.end_displacement, end, 1e-14, "displacement after unloading");
}
