//! Every law of the literature by two routes.

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName};
use pounding_reference::Collision;
use pounding_solver::{Bilinear, Clock, Collisions, Exact, Excitation, Integrator, Node, Row, TransferredMomentum};

use super::{close, pairs, run};

/// Masses and stiffnesses: the paper's left and middle structures, and a light structure on the other side.
const STRUCTURES: [(f64, f64); 3] = [(75e3, 2.056e6), (3e6, 1.316e9), (50e3, 4e6)];

/// Every compliant law, calibrated to some e; springs have only e = 1.
fn laws() -> Vec<(LawName, f64, ContactLaw)> {
    let pair = FreePair {
        reduced_mass: STRUCTURES[0].0 * STRUCTURES[1].0 / (STRUCTURES[0].0 + STRUCTURES[1].0),
        approach_speed: 0.3,
    };
    let mut laws = Vec::new();
    let compliant = LawName::ALL.into_iter().filter_map(|name| Some((name, name.stiffness_unit()?)));
    for (name, unit) in compliant {
        let stiffness = if unit == "N/m" { 9.35e7 } else { 2.75e9 };
        for e in [0.2, 0.65, 1.0] {
            if let Ok(law) = name.calibrated(stiffness, e, Calibration::Exact, &pair) {
                laws.push((name, e, law));
            }
        }
    }
    for name in LawName::ALL.into_iter().skip(1) {
        assert!(laws.iter().any(|law| law.0 == name), "{name:?} is left out");
    }
    laws
}

/// Four seconds of a smooth ground motion, sampled every 0.1 s.
fn ground() -> Vec<f64> {
    let acceleration = |t: f64| 2.5 * libm::sin(5.1 * t) + 1.7 * libm::sin(9.7 * t + 1.0);
    (0..=40).map(|i| acceleration(0.1 * f64::from(i))).collect()
}

/// The structures with gaps of a centimetre, elastic or yielding.
fn row(law: ContactLaw, yield_displacement: f64) -> Row<Bilinear> {
    let node = |(mass, stiffness): (f64, f64)| {
        let yield_force = stiffness * yield_displacement;
        let column = Bilinear {
            stiffness,
            yield_force,
            hardening: 0.0,
        };
        Node::structure(mass, 0.5712 * mass + 0.001_447 * stiffness, column)
    };
    let nodes = STRUCTURES.map(node).to_vec();
    Row::new(nodes, pairs(3, 0.01, law)).expect("as built")
}

/// Impulse and peak force of the exact method while a pair touches.
///
/// The exact method may count two collisions if a clamped law releases and pushes again.
fn during(collisions: &Collisions, (pair, touch): (usize, &Collision)) -> (f64, f64) {
    let within = collisions.all().iter().filter(|found| {
        let after = found.start > touch.start - 1e-9;
        found.pair == pair && after && found.start < touch.end
    });
    within.fold((0.0, 0.0), |(impulse, peak), found| {
        let force = found.peak_force.expect("a compliant law has one");
        (impulse + found.impulse, f64::max(peak, force))
    })
}

#[test]
fn reference_two_routes_agree_on_every_law() {
    for (name, e, law) in laws() {
        for yield_displacement in [f64::INFINITY, 0.05] {
            let row = row(law, yield_displacement);
            let ground = ground();
            let excitation = Excitation::new(0.1, &ground).expect("finite");
            let clock = Clock {
                time_step: 0.01,
                n_steps: 400,
            };
            let mut recorders = (TransferredMomentum::new(3), Collisions::new(3, row.pairs()));
            Integrator::Exact(Exact::default())
                .run(&row, excitation, clock, &mut recorders)
                .expect("the run ends");
            let response = run(&row, &ground, 4.0);
            let what = format!("{} for {e}", name.name());
            let (momentum, collisions) = recorders;
            for (index, known) in response.structures.iter().enumerate() {
                close(momentum.of(index), known.transferred_momentum, 1e-11, &what);
            }
            for (pair, known) in response.collisions.iter().enumerate() {
                assert!(!known.is_empty(), "{what}: pair {pair} collides");
                for known in known {
                    let (impulse, peak) = during(&collisions, (pair, known));
                    close(impulse, known.impulse, 1e-11, &what);
                    let known = known.peak_force.expect("a compliant law has one");
                    close(peak, known, 1e-11, &what);
                }
            }
        }
    }
}

/// Yielding takes β k of the damping: both routes meet the jumps, in contact and out of it.
#[test]
fn reference_two_routes_agree_on_damping_that_follows_the_tangent() {
    for name in [
        LawName::LinearSpring,
        LawName::HertzDamp,
        LawName::TwoSlopes,
        LawName::Stereomechanical,
    ] {
        let e = if name.is_elastic() { 1.0 } else { 0.65 };
        let stiffness = name.stiffness().map_or(0.0, |row| row.usual);
        let law = name
            .calibrated(stiffness, e, Calibration::Exact, &FreePair::UNIT)
            .expect("within range");
        // Damping of 0.01 k, on the initial or on the tangent stiffness.
        let damped = |part: f64| {
            let node = |node: &Node<Bilinear>| Node {
                damping: node.damping + 0.01 * node.column.stiffness,
                elastic_damping: part * 0.01 * node.column.stiffness,
                ..*node
            };
            let nodes = row(law, 0.02).nodes().iter().map(node).collect();
            Row::new(nodes, pairs(3, 0.01, law)).expect("as built")
        };
        let (whole, follows) = (damped(0.0), damped(1.0));
        let ground = ground();
        let excitation = Excitation::new(0.1, &ground).expect("finite");
        let clock = Clock {
            time_step: 0.01,
            n_steps: 400,
        };
        let momenta = |row: &Row<Bilinear>| {
            let mut momentum = TransferredMomentum::new(3);
            Integrator::Exact(Exact::default())
                .run(row, excitation, clock, &mut momentum)
                .expect("the run ends");
            [0, 1, 2].map(|index| momentum.of(index))
        };
        let (found, initial) = (momenta(&follows), momenta(&whole));
        let response = run(&follows, &ground, 4.0);
        for (index, known) in response.structures.iter().enumerate() {
            close(found[index], known.transferred_momentum, 1e-10, name.name());
        }
        let differs = |index: usize| (found[index] / initial[index] - 1.0).abs() > 0.01;
        assert!((0..3).any(differs), "{name:?}: {found:?} {initial:?}");
    }
}
