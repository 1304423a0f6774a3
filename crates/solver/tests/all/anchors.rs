//! Small results of other programs and books, and the closed forms behind them.

use std::f64::consts::PI;

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Damping, Elastic, Exact, Excitation, Histories, Integrator, Mode, Node, Row, Storey, modes};

use crate::common::{CENTRAL, LOCATED, clock, pairs};

/// suanPan's example of a mass against a wall: m = 1, distance 1, a constant acceleration of 2 towards the wall, e = 1. The mass meets the
/// wall at t = 1 with velocity 2. At t = 1.5 it has come back by 3/4 and has velocity 1. suanPan's own test, with steps of 0.01, gives
/// −0.24090 and 0.97841.
#[test]
fn reference_a_mass_against_a_wall_of_suanpan() {
    let free = Elastic { stiffness: 0.0 };
    let nodes = vec![Node::wall(free), Node::structure(1.0, 0.0, free)];
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 1.0 });
    let row = Row::new(nodes, pairs(2, 1.0, law)).expect("the row is valid");
    // The frame accelerates by 2 away from the wall, so that the mass is drawn towards it.
    let samples = [2.0, 2.0];
    let end = |method: Integrator| {
        let excitation = Excitation::new(1.5, &samples).expect("the motion is valid");
        let mut histories = Histories::new(2, 1.5, 1.5);
        method
            .run(&row, excitation, clock(0.01, 1.5), &mut histories)
            .expect("the run ends");
        *histories.of(1).states.last().expect("a state at the end")
    };
    for (method, allowed) in [
        (Integrator::Exact(Exact::default()), 1e-15),
        (LOCATED, 1e-13),
        // An impact is found to a step: 0.01 s at twice the velocity of 2.
        (CENTRAL, 0.04),
    ] {
        let found = end(method);
        assert!((found.displacement + 0.25).abs() <= allowed, "{found:?}");
        assert!((found.velocity - 1.0).abs() <= allowed, "{found:?}");
    }
}

fn storey(mass: f64, stiffness: f64) -> Storey<Elastic> {
    Storey {
        mass,
        damping: 0.0,
        ground_damping: 0.0,
        column: Elastic { stiffness },
    }
}

/// The determinant of K − ω²M of three storeys over k³; it is 0 at their frequencies.
fn residual([m1, m2, m3]: [f64; 3], k: f64, squared: f64) -> f64 {
    let (d1, d2, d3) = (2.0 * k - m1 * squared, 2.0 * k - m2 * squared, k - m3 * squared);
    (d1 * (d2 * d3 - k * k) - k * k * d3) / (k * k * k)
}

/// A frame with published measured frequencies of 17.8939, 49.7476 and 71.1199 rad/s.
#[test]
fn reference_a_measured_frame_of_three_storeys() {
    let (masses, stiffness) = ([1.8965, 1.8965, 1.7338], 2923.7);
    let found = modes(&masses.map(|mass| storey(mass, stiffness))).expect("good storeys");
    for ((mode, computed), published) in found.iter().zip([17.8936, 49.7469, 71.1188]).zip([17.8939, 49.7476, 71.1199]) {
        let omega = mode.angular_frequency;
        assert!((omega - computed).abs() <= 5e-5, "{omega}, {computed}");
        assert!((omega / published - 1.0).abs() <= 2e-5, "{omega}, {published}");
        let left = residual(masses, stiffness, omega * omega);
        assert!(left.abs() <= 1e-12, "{omega}: {left:e}");
    }
}

/// A. K. Chopra, *Dynamics of Structures*, section on base isolation: a structure of 0.4 s and 2 % on a slab of two thirds of its mass. The
/// isolators alone would give 2 s and 10 %. Periods with both: 2.0242 s and 0.24995 s.
#[test]
fn reference_a_base_isolated_building_of_chopra() {
    let mass = 1000.0;
    let slab = 2.0 / 3.0 * mass;
    let stiffness = |mass: f64, period: f64| mass * (2.0 * PI / period) * (2.0 * PI / period);
    let (isolators, columns) = (stiffness(mass + slab, 2.0), stiffness(mass, 0.4));
    let storeys = [
        Storey {
            damping: Damping::Ratio(0.1).coefficient(mass + slab, isolators),
            ..storey(slab, isolators)
        },
        Storey {
            damping: Damping::Ratio(0.02).coefficient(mass, columns),
            ..storey(mass, columns)
        },
    ];
    let found = modes(&storeys).expect("good storeys");
    let periods: Vec<f64> = found.iter().map(Mode::period).collect();
    for (found, printed) in periods.iter().zip([2.0242, 0.249_95]) {
        assert!((found - printed).abs() <= 5e-5, "{found} against {printed}");
    }
    // ω² of both: roots of m_b m_f ω⁴ − (m_f k_b + (m_b + m_f) k_f) ω² + k_b k_f.
    let half = 0.5 * (mass * isolators + (slab + mass) * columns) / (slab * mass);
    let root = (half * half - isolators * columns / (slab * mass)).sqrt();
    for (found, squared) in periods.iter().zip([half - root, half + root]) {
        let wanted = 2.0 * PI / squared.sqrt();
        assert!((found / wanted - 1.0).abs() <= 1e-13, "{found} against {wanted}");
    }
}
