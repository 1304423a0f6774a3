//! Worked examples from the manuals of other programs, in the units of the manuals.

use pounding_contact::{ContactLaw, KelvinVoigt, LinearSpring, Stereomechanical};
use pounding_solver::{Clock, Collision, Collisions, Elastic, Exact, Excitation, Histories, Integrator, Node, Pair, Peaks, Row, State};

use crate::common::pairs;

/// Results of a run: the states at its end, the largest displacements and their instants, and the collisions.
struct Ran {
    last: Vec<State>,
    peaks: Vec<(f64, f64)>,
    collisions: Vec<Collision>,
}

/// A row under a constant pull to the right, by the exact method.
fn run(nodes: Vec<Node<Elastic>>, pairs: Vec<Pair>, (pull, end): (f64, f64)) -> Ran {
    let n = nodes.len();
    let row = Row::new(nodes, pairs).expect("the row is valid");
    let samples = [-pull; 2];
    let excitation = Excitation::new(end, &samples).expect("the pull is finite");
    let clock = Clock {
        time_step: end,
        n_steps: 1,
    };
    let mut histories = Histories::new(n, end, end);
    let mut peaks = Peaks::new(n);
    let mut collisions = Collisions::new(n, row.pairs());
    let mut recorders = (&mut histories, (&mut peaks, &mut collisions));
    Integrator::Exact(Exact::default())
        .run(&row, excitation, clock, &mut recorders)
        .expect("the run ends");
    let last = |node: usize| *histories.of(node).states.last().expect("a state at the end");
    let peak = |node: usize| {
        let peak = peaks.of(node).displacement;
        (peak.value, peak.time)
    };
    Ran {
        last: (0..n).map(last).collect(),
        peaks: (0..n).map(peak).collect(),
        collisions: collisions.all().to_vec(),
    }
}

fn mass(mass: f64, stiffness: f64) -> Node<Elastic> {
    Node::structure(mass, 0.0, Elastic { stiffness })
}

fn wall() -> Node<Elastic> {
    Node::wall(Elastic { stiffness: 0.0 })
}

fn spring(impact_stiffness: f64) -> ContactLaw {
    ContactLaw::LinearSpring(LinearSpring { impact_stiffness })
}

fn newton(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

/// Checks a number against a value printed with few digits.
fn is(found: f64, printed: f64, half_a_digit: f64) {
    assert!((found - printed).abs() <= half_a_digit, "{found} against {printed}");
}

/// A ball falls 2 m and rises by e² of this height. It meets the floor at t₁ and is highest at t₁(1 + e).
#[test]
fn reference_restitution_by_drops() {
    let (height, gravity) = (2.0, 9.81);
    let first = f64::sqrt(2.0 * height / gravity);
    for (restitution, share) in [(0.0, 0.0), (0.3, 0.09), (0.5, 0.25), (0.8, 0.64), (0.95, 0.9025), (1.0, 1.0)] {
        let end = first * (1.0 + restitution) + if restitution > 0.0 { 0.0 } else { 0.1 };
        let ran = run(vec![mass(3.0, 0.0), wall()], pairs(2, height, newton(restitution)), (gravity, end));
        is(ran.collisions[0].start, first, 1e-15);
        is((height - ran.last[0].displacement) / height, share, 1e-14);
    }
    // With e = 0.8 it rests at t₁(1 + e)/(1 − e).
    let ran = run(vec![mass(3.0, 0.0), wall()], pairs(2, height, newton(0.8)), (gravity, 6.0));
    let rest = ran.collisions.last().expect("it rests");
    is(rest.start, 5.746_96, 5e-6);
}

/// ANSYS VM65, also LS-DYNA (W. T. Thomson, *Vibration Theory and Applications*): a ball of 0.5 lb·s²/in falls 1 in onto a spring of
/// 1973.92 lb/in. Printed: 0.071982 s and 27.785 in/s at the touch. With d the depth, m g (1 + d) = k d²/2.
#[test]
fn reference_a_ball_on_a_spring_of_ansys_vm65() {
    let (inertia, stiffness, drop, gravity) = (0.5, 1973.92, 1.0, 386.0);
    let ran = run(vec![mass(inertia, 0.0), wall()], pairs(2, drop, spring(stiffness)), (gravity, 0.12));
    let touch = ran.collisions[0];
    is(touch.start, 0.071_982, 5e-7);
    is(touch.approach_speed.expect("it is known"), 27.785, 5e-4);
    let weight = inertia * gravity;
    let deep = (weight + (weight * weight + 2.0 * stiffness * weight * drop).sqrt()) / stiffness;
    let (lowest, time) = ran.peaks[0];
    is(lowest, drop + deep, 1e-14);
    is(lowest, 1.550_665_6, 5e-8);
    is(time, 0.100_444_9, 5e-8);
}

/// ANSYS VM74: an impulse of 10 lb·s on 0.5 lb·s²/in and 200 lb/in, after 0.1 s. Printed: 0.90930 in without damping, 0.34180 in with 70 %
/// of critical damping.
#[test]
fn reference_an_impulse_on_an_oscillator_of_ansys_vm74() {
    for (ratio, printed) in [(0.0, 0.909_297), (0.7, 0.341_80)] {
        let (inertia, stiffness): (f64, f64) = (0.5, 200.0);
        let damping = 2.0 * ratio * (inertia * stiffness).sqrt();
        let struck = Node {
            initial_velocity: 10.0 / inertia,
            ..Node::structure(inertia, damping, Elastic { stiffness })
        };
        let ran = run(vec![struck], vec![], (0.0, 0.1));
        is(ran.last[0].displacement, printed, 5e-6);
        let omega = 20.0 * f64::sqrt(1.0 - ratio * ratio);
        let swing = libm::exp(-2.0 * ratio) * libm::sin(0.1 * omega);
        is(ran.last[0].displacement, 20.0 / omega * swing, 1e-15);
    }
}

/// ANSYS VM83: 50 lb fall 72 in onto a pan of 25 lb on 100 lb/in and stay there. By momentum and energy the pan is lowest at 7.696222 in
/// and the block at 79.446222 in, 0.683200 s after its release. The manual's contact is soft and gives 0.689 s.
#[test]
fn reference_a_block_on_a_spring_scale_of_ansys_vm83() {
    let gravity = 386.0;
    let pan = Node {
        initial_displacement: 0.25,
        ..mass(25.0 / gravity, 100.0)
    };
    let ran = run(vec![mass(50.0 / gravity, 0.0), pan], pairs(2, 71.75, newton(0.0)), (gravity, 0.75));
    let [(block, at), (pan, with)] = [ran.peaks[0], ran.peaks[1]];
    is(block, 79.446_222, 5e-7);
    is(pan, 7.696_222, 5e-7);
    is(at, 0.683_200, 5e-7);
    is(with, at, 1e-12);
    is(at, 0.689, 6e-3);
}

/// `code_aster` SDND101 (V5.01.101): 100 kg on 1e4 N/m meet a stop of 1e6 N/m with 1 m/s: an oscillator on both springs for half a swing.
#[test]
fn reference_an_oscillator_at_a_stop_of_code_aster_sdnd101() {
    let striking = Node {
        initial_velocity: 1.0,
        ..mass(100.0, 1e4)
    };
    let ran = run(vec![striking, wall()], pairs(2, 0.0, spring(1e6)), (0.0, 0.05));
    let one = ran.collisions[0];
    let omega = f64::sqrt(1.01e6 / 100.0);
    is(one.end - one.start, std::f64::consts::PI / omega, 1e-15);
    is(one.end - one.start, 0.031_260_0, 5e-8);
    is(one.impulse, 198.019_8, 5e-5);
    is(one.peak_force.expect("a spring has one"), 9950.372, 5e-4);
}

/// `code_aster` V5.01.108, A and B: 1 kg under 10 m/s² moves towards a stop 2 m away with 1 m/s. The stop has 100 N/m, and in B also a
/// dashpot of 5 N·s/m that does not pull.
#[test]
fn reference_a_mass_on_a_damped_stop_of_code_aster_108() {
    let damped = ContactLaw::KelvinVoigt(KelvinVoigt {
        impact_stiffness: 100.0,
        impact_damping_ratio: 0.25,
    });
    for (law, lasts, force) in [(spring(100.0), 0.345_144, 74.8074), (damped, 0.325_389, 58.5029)] {
        let falling = Node {
            initial_velocity: 1.0,
            ..mass(1.0, 0.0)
        };
        let ran = run(vec![falling, wall()], pairs(2, 2.0, law), (10.0, 1.0));
        let one = ran.collisions[0];
        is(one.start, 0.540_312, 5e-7);
        is(one.end - one.start, lasts, 5e-7);
        is(one.peak_force.expect("it has one"), force, 5e-5);
    }
}
