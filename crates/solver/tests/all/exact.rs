//! The exact method compared with closed forms, and with itself.

use pounding_contact::{ContactLaw, NonlinearViscoelastic, Stereomechanical};
use pounding_solver::{
    Clock, Collisions, Elastic, Exact, Excitation, Histories, Hysteretic, Integrator, Node, Pair, Peaks, Row, RunError,
    SimultaneousImpacts, TransferredMomentum, Work,
};

use crate::common::{STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, elastic, ground, pairs, yielding};
use crate::watch::Watch;

const FREE: Elastic = Elastic { stiffness: 0.0 };

fn stereomechanical(restitution: f64) -> ContactLaw {
    ContactLaw::Stereomechanical(Stereomechanical { restitution })
}

struct Outcome {
    collisions: Collisions,
    momentum: TransferredMomentum,
    peaks: Peaks,
    histories: Histories,
    work: Work,
}

fn run<Column: Hysteretic>(settings: Exact, row: &Row<Column>, ground: &[f64], clock: Clock) -> Outcome {
    let n = row.nodes().len();
    let duration = clock.time(clock.n_steps);
    let mut recorders = (
        Collisions::new(n, row.pairs()),
        TransferredMomentum::new(n),
        Peaks::new(n),
        Histories::new(n, clock.time_step, duration),
    );
    let excitation = Excitation::new(0.01, ground).expect("the ground motion is finite");
    let work = Integrator::Exact(settings)
        .watch(row, excitation, clock, &mut recorders)
        .expect("the run ends");
    let (collisions, momentum, peaks, histories) = recorders;
    Outcome {
        collisions,
        momentum,
        peaks,
        histories,
        work,
    }
}

fn close(found: f64, wanted: f64, tolerance: f64) {
    let error = (found - wanted).abs() / wanted.abs();
    assert!(error <= tolerance, "{found} instead of {wanted}: {error:e}");
}

#[test]
fn published_bouncing_ball_past_its_accumulation_point() {
    // A fall from 1 m with g = 9.81 m/s² onto a wall, e = 0.8; the bounces end at t₁(1 + e)/(1 − e).
    let (height, gravity, restitution) = (1.0, 9.81, 0.8);
    let ball = Node {
        initial_displacement: height,
        ..Node::structure(2.0, 0.0, FREE)
    };
    let pair = Pair::of_floors(0, 1, 0.0, stereomechanical(restitution));
    let row = Row::new(vec![Node::wall(FREE), ball], vec![pair]).unwrap();
    let outcome = run(Exact::default(), &row, &[gravity; 701], clock(0.01, 7.0));
    let first: f64 = (2.0 * height / gravity).sqrt();
    let over = first * (1.0 + restitution) / (1.0 - restitution);
    let bounces = outcome.collisions.all();
    close(bounces[0].start, first, 1e-15);
    // Every bounce lasts e times as long as the previous one.
    for k in 1..60 {
        let passed = libm::pow(restitution, f64::from(k));
        let at = first * (1.0 + 2.0 * restitution * (1.0 - passed) / (1.0 - restitution));
        let k = usize::try_from(k).unwrap();
        close(bounces[k].start, at, 1e-14);
        close(bounces[k].impulse, 2.0 * (1.0 + restitution) * gravity * first * passed, 1e-11);
    }
    let rest = bounces.last().unwrap();
    close(rest.start, over, 1e-12);
    close(rest.end, 7.0, 0.0);
    close(rest.impulse, 2.0 * gravity * (7.0 - over), 1e-12);
    // All momentum that gravity gave went into the wall.
    close(outcome.momentum.of(1), 2.0 * gravity * 7.0, 1e-14);
    let end = outcome.histories.of(1).states.last().unwrap();
    assert!(end.displacement.abs() < 1e-15, "{}", end.displacement);
    assert!(end.velocity == 0.0, "{}", end.velocity);
}

#[test]
fn extreme_neighbours_that_press_and_bounce_for_ever_end_the_run() {
    // Thrown upwards with 1e-8 m/s in 10 m/s²: with e = 1 the mass returns every 2e-9 s, 5e9 times in 10 s.
    let throw = |restitution: f64| {
        let ball = Node {
            initial_velocity: 1e-8,
            ..Node::structure(2.0, 0.0, FREE)
        };
        let pairs = pairs(2, 0.0, stereomechanical(restitution));
        let row = Row::new(vec![Node::wall(FREE), ball], pairs).unwrap();
        let excitation = Excitation::new(0.01, &[10.0; 1001]).unwrap();
        let mut collisions = Collisions::new(2, row.pairs());
        let clock = clock(0.01, 10.0);
        let outcome = Integrator::Exact(Exact::default()).watch(&row, excitation, clock, &mut collisions);
        (outcome, collisions.all().len())
    };
    let (outcome, impacts) = throw(1.0);
    let error = outcome.expect_err("it never rests");
    let RunError::BouncesWithoutEnd { left, right, time, .. } = error else {
        panic!("{error}");
    };
    assert_eq!((left, right, impacts), (0, 1, 100_001));
    close(time, 100_001.0 * 2e-9, 1e-10);
    // The e that the message advises comes to rest.
    let (outcome, impacts) = throw(0.999);
    assert!(outcome.is_ok() && impacts < 20_000, "{impacts} impacts, {outcome:?}");
}

#[test]
fn reference_three_ball_cradle() {
    let ball = |u: f64, v: f64| Node {
        initial_displacement: u,
        initial_velocity: v,
        ..Node::structure(1.0, 0.0, FREE)
    };
    let row = Row::new(
        vec![ball(-0.5, 3.0), ball(0.0, 0.0), ball(0.0, 0.0)],
        pairs(3, 0.0, stereomechanical(1.0)),
    )
    .unwrap();
    let ends = |simultaneous_impacts| {
        let settings = Exact {
            simultaneous_impacts,
            ..Exact::default()
        };
        let outcome = run(settings, &row, &[0.0], clock(0.01, 1.0));
        [0, 1, 2].map(|i| outcome.histories.of(i).states.last().unwrap().velocity)
    };
    for (found, wanted) in ends(SimultaneousImpacts::Together).into_iter().zip([-1.0, 2.0, 2.0]) {
        assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
    }
    let sequential = ends(SimultaneousImpacts::Sequential);
    for (found, wanted) in sequential.into_iter().zip([0.0, 0.0, 3.0]) {
        assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
    }
}

#[test]
fn reference_symmetric_double_hit() {
    let ball = |mass: f64, u: f64, v: f64| Node {
        initial_displacement: u,
        initial_velocity: v,
        ..Node::structure(mass, 0.0, FREE)
    };
    let row = Row::new(
        vec![ball(5.0, -0.5, 3.0), ball(1e-3, 0.0, 0.0), ball(5.0, 0.5, -3.0)],
        pairs(3, 0.0, stereomechanical(0.5)),
    )
    .unwrap();
    let outcome = run(Exact::default(), &row, &[0.0], clock(0.01, 1.0));
    let ends = [0, 1, 2].map(|i| outcome.histories.of(i).states.last().unwrap().velocity);
    for (found, wanted) in ends.into_iter().zip([-1.5, 0.0, 1.5]) {
        assert!((found - wanted).abs() < 1e-15, "{ends:?}");
    }
    assert!(ends[1] == 0.0 && ends[0] + ends[2] == 0.0, "mirror-symmetric to the bit: {ends:?}");
    assert_eq!(outcome.collisions.all().len(), 2);
}

#[test]
fn reference_free_viscoelastic_impact() {
    for ratio in [0.0, 0.05, 0.35, 1.0, 2.0] {
        for (speed, gap) in [(0.01, 0.05), (0.3, 0.01), (3.0, 0.0)] {
            let law = ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
                impact_stiffness: 2.75e9,
                impact_damping_ratio: ratio,
            });
            let e = law.restitution().expect("a closed form");
            let (left, right) = (75e3, 3e6);
            let moving = Node {
                initial_velocity: speed,
                ..Node::structure(left, 0.0, FREE)
            };
            let row = Row::new(vec![moving, Node::structure(right, 0.0, FREE)], pairs(2, gap, law)).unwrap();
            let outcome = run(Exact::default(), &row, &[0.0], clock(0.01, 6.0));
            let ends = [0, 1].map(|i| outcome.histories.of(i).states.last().unwrap().velocity);
            close((ends[1] - ends[0]) / speed, e, 1e-13);
            let [collision] = outcome.collisions.all() else {
                panic!("one collision, not {}", outcome.collisions.all().len());
            };
            let reduced_mass = left * right / (left + right);
            close(collision.impulse, reduced_mass * (1.0 + e) * speed, 1e-13);
            if gap > 0.0 {
                close(collision.start, gap / speed, 1e-15);
            }
            let depth = libm::pow(1.25 * reduced_mass * e * e * speed * speed / 2.75e9, 0.4);
            if ratio == 0.0 {
                let peak = 2.75e9 * depth * depth.sqrt();
                close(collision.peak_force.unwrap(), peak, 1e-13);
            }
        }
    }
}

#[test]
fn reference_free_vibration_of_every_damping() {
    // u'' + 2ζω u' + ω² u = 0 from u₀, v₀ in closed form, through critical damping; also c = k = 0.
    let (omega, u0, v0): (f64, f64, f64) = (7.0, 0.02, -0.1);
    for zeta in [0.0, 0.05, 0.999_999, 1.0, 1.000_001, 3.0] {
        let node = Node {
            initial_displacement: u0,
            initial_velocity: v0,
            ..Node::structure(
                2.0,
                4.0 * zeta * omega,
                Elastic {
                    stiffness: 2.0 * omega * omega,
                },
            )
        };
        let row = Row::new(vec![node], vec![]).unwrap();
        let outcome = run(Exact::default(), &row, &[0.0], clock(0.05, 5.0));
        for (step, state) in outcome.histories.of(0).states.iter().enumerate() {
            let t = 0.05 * step as f64;
            let squared = omega * omega * (1.0 - zeta * zeta);
            // cos and sin x/ω_d, continued through ω_d = 0.
            let (c, s) = if squared > 1e-3 {
                let w = squared.sqrt();
                (libm::cos(w * t), libm::sin(w * t) / w)
            } else if squared < -1e-3 {
                let w = (-squared).sqrt();
                (libm::cosh(w * t), libm::sinh(w * t) / w)
            } else {
                let x = squared * t * t;
                (1.0 - x / 2.0 + x * x / 24.0, t * (1.0 - x / 6.0 + x * x / 120.0))
            };
            let decay = libm::exp(-zeta * omega * t);
            let wanted = decay * (u0 * c + (v0 + zeta * omega * u0) * s);
            assert!(
                (state.displacement - wanted).abs() < 1e-15,
                "ζ = {zeta}, t = {t}: {} {wanted}",
                state.displacement
            );
        }
    }
    let drifting = Node {
        initial_velocity: 0.3,
        ..Node::structure(2.0, 0.0, FREE)
    };
    let row = Row::new(vec![drifting], vec![]).unwrap();
    let outcome = run(Exact::default(), &row, &[-1.0; 201], clock(0.01, 2.0));
    let end = outcome.histories.of(0).states.last().unwrap();
    close(end.displacement, 0.3 * 2.0 + 0.5 * 4.0, 1e-15);
}

#[test]
fn limit_tolerance_halves_nothing_but_digits_asked_for() {
    let row = Row::new(vec![yielding(WEAK), yielding(STIFF), yielding(WEAK)], pairs(3, 0.02, VISCOELASTIC)).unwrap();
    let at = |tolerance| {
        let settings = Exact {
            tolerance,
            ..Exact::default()
        };
        run(settings, &row, &ground(), clock(0.01, 10.0))
    };
    let (fine, coarse) = (at(1e-16), at(1e-8));
    assert!(coarse.work.segments < fine.work.segments, "digits cost work");
    close(coarse.momentum.of(1), fine.momentum.of(1), 1e-5);
    close(at(1e-15).momentum.of(1), fine.momentum.of(1), 1e-11);
}

#[test]
fn limit_mirrored_rows_give_mirrored_histories() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let nodes = vec![elastic_among_yielding(WEAK), yielding(STIFF)];
        let mirrored: Vec<_> = nodes.iter().copied().rev().collect();
        let ground = ground();
        let reversed: Vec<_> = ground.iter().map(|a| -a).collect();
        let [one, other] = [(nodes, ground), (mirrored, reversed)].map(|(nodes, ground)| {
            let row = Row::new(nodes, pairs(2, 0.02, law)).unwrap();
            run(Exact::default(), &row, &ground, clock(0.01, 10.0))
        });
        assert!(one.collisions.all().len() > 3, "they collide");
        for (a, b) in [(0, 1), (1, 0)] {
            for (a, b) in one.histories.of(a).states.iter().zip(&other.histories.of(b).states) {
                assert_eq!((a.displacement, a.velocity), (-b.displacement, -b.velocity));
            }
        }
    }
}

fn elastic_among_yielding(structure: (f64, f64, f64)) -> Node<pounding_solver::Bilinear> {
    yielding((structure.0, structure.1, f64::INFINITY))
}

#[test]
fn limit_a_yield_force_never_reached_and_a_gap_too_wide_change_no_bit() {
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let lean = Row::new(vec![elastic(WEAK), elastic(STIFF)], pairs(2, 0.02, law)).unwrap();
        let mut between = pairs(3, 0.02, law);
        between[1].relation.offset = 10.0;
        let high = |s: (f64, f64, f64)| yielding((s.0, s.1, 1e12));
        let rich = Row::new(vec![high(WEAK), high(STIFF), high(WEAK)], between).unwrap();
        let lean = run(Exact::default(), &lean, &ground(), clock(0.01, 10.0));
        let rich = run(Exact::default(), &rich, &ground(), clock(0.01, 10.0));
        assert!(lean.collisions.all().len() > 3, "they collide");
        assert_eq!(lean.collisions.all(), rich.collisions.all());
        for index in [0, 1] {
            assert_eq!(lean.histories.of(index), rich.histories.of(index));
            assert_eq!(lean.peaks.of(index), rich.peaks.of(index));
        }
    }
}
