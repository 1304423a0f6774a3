//! Every law of the literature under every method, compared with its response for a free pair.

use crate::common::{METHODS, RK4, STIFF, WEAK, clock, elastic, ground, pairs};
use crate::watch::Watch;
use pounding_contact::{Calibration, ContactLaw, FreeImpact, FreePair, LawName};
use pounding_solver::{
    Clock, Collisions, Elastic, Exact, Excitation, Histories, Impact, Integrator, Node, Recorder, Row, Span, TransferredMomentum,
};

const MASSES: [f64; 2] = [75e3, 3e6];
const SPEED: f64 = 0.5;
const PAIR: FreePair = FreePair {
    reduced_mass: MASSES[0] * MASSES[1] / (MASSES[0] + MASSES[1]),
    approach_speed: SPEED,
};

/// The compliant laws calibrated to these e, and the springs.
fn laws(restitutions: &[f64]) -> Vec<(f64, ContactLaw)> {
    let mut laws = Vec::new();
    for name in LawName::ALL {
        let stiffness = match name.stiffness_unit() {
            Some("N/m") => 9.35e7,
            Some(_) => 2.75e9,
            None => continue,
        };
        for &e in restitutions {
            if let Ok(law) = name.calibrated(stiffness, e, Calibration::Exact, &PAIR) {
                laws.push((e, law));
            }
        }
    }
    assert!(laws.len() > 9 * restitutions.len(), "no law is left out");
    laws
}

struct Delivered {
    restitution: f64,
    impulse: f64,
    collisions: Collisions,
}

fn collide(law: ContactLaw, method: Integrator, clock: Clock) -> Delivered {
    let free = Elastic { stiffness: 0.0 };
    let mut nodes = MASSES.map(|mass| Node::structure(mass, 0.0, free)).to_vec();
    nodes[0].initial_velocity = SPEED;
    let row = Row::new(nodes, pairs(2, 0.01, law)).expect("as built");
    let mut recorders = (
        TransferredMomentum::new(2),
        Collisions::new(2, row.pairs()),
        LastVelocities([SPEED, 0.0]),
    );
    let excitation = Excitation::new(1.0, &[0.0]).expect("as built");
    method.watch(&row, excitation, clock, &mut recorders).expect("as built");
    let (momentum, collisions, LastVelocities([left, right])) = recorders;
    Delivered {
        restitution: (right - left) / SPEED,
        impulse: momentum.of(1),
        collisions,
    }
}

#[test]
fn reference_the_exact_method_delivers_every_law() {
    for (e, law) in laws(&[0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95, 0.999, 1.0]) {
        let found = collide(law, Integrator::Exact(Exact::default()), clock(0.01, 0.6));
        let close = |found: f64, known: f64, what: &str| {
            assert!(
                (found / known - 1.0).abs() < 1e-9,
                "{law:?} for {e}, {what}: {found} against {known}"
            );
        };
        let known = FreeImpact::of(&law, &PAIR).expect("as built");
        close(found.restitution, e, "restitution");
        close(found.impulse, known.impulse, "impulse");
        let [collision] = found.collisions.all() else {
            panic!("{law:?}: {} collisions", found.collisions.all().len());
        };
        close(collision.peak_force.unwrap(), known.peak_force, "peak force");
        // A free pair without loss has its largest force half way.
        if e >= 1.0 {
            let half = 0.5 * (collision.end - collision.start);
            let peak = collision.peak_force_time.unwrap() - collision.start;
            close(peak, half, "time of the peak force");
        }
    }
}

#[test]
fn order_every_method_tends_to_what_a_law_delivers() {
    for (e, law) in laws(&[0.4, 1.0]) {
        for (name, method) in METHODS {
            let error = |time_step| {
                let found = collide(law, method, clock(time_step, 0.25));
                let impulse = found.impulse / PAIR.impulse(e) - 1.0;
                (found.restitution - e).abs().max(impulse.abs())
            };
            for time_step in [2e-5, 5e-6] {
                // Order one, with random parts: the first overlap is found up to a step late.
                let n_steps = FreeImpact::of(&law, &PAIR).unwrap().duration / time_step;
                let error = error(time_step);
                assert!(error < 5.0 / n_steps, "{name}, {law:?}: {error} in {n_steps} steps");
            }
        }
    }
}

/// Velocities of a free pair at the end of the run.
struct LastVelocities([f64; 2]);

impl Recorder for LastVelocities {
    fn span(&mut self, span: &Span<'_>) {
        self.0[span.structure] = span.end.velocity;
    }

    fn impact(&mut self, _: &Impact) {}
}

/// Displacements of two shaken structures that collide, every 0.01 s.
fn shaken(law: ContactLaw, method: Integrator, time_step: f64) -> (Vec<f64>, usize) {
    let row = Row::new(vec![elastic(WEAK), elastic(STIFF)], pairs(2, 0.002, law)).expect("as built");
    let duration = 1.5;
    let mut recorders = (Histories::new(2, 0.01, duration), Collisions::new(2, row.pairs()));
    let ground = ground();
    let excitation = Excitation::new(0.01, &ground).expect("as built");
    method
        .watch(&row, excitation, clock(time_step, duration), &mut recorders)
        .expect("as built");
    let states = &recorders.0.of(0).states;
    let displacements = states.iter().map(|state| state.displacement).collect();
    (displacements, recorders.1.all().len())
}

#[test]
fn reference_shaken_pairs_move_alike_under_two_methods() {
    // With little restitution the clamp acts, and the ground drives pairs together and apart while they touch.
    for (e, law) in laws(&[0.1, 0.5, 1.0]) {
        let (known, collisions) = shaken(law, Integrator::Exact(Exact::default()), 0.01);
        assert!(collisions > 0, "{law:?} for {e}: they collide");
        let largest = known.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
        let (found, _) = shaken(law, RK4, 1e-5);
        let apart = known.iter().zip(&found).map(|(a, b)| (a - b).abs());
        let apart = apart.fold(0.0, f64::max) / largest;
        assert!(apart < 1e-3, "{law:?} for {e}: {apart:e}");
    }
}
