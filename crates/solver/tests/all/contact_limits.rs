//! Stability limits of a pair that stays in touch, compared with the methods themselves.

use pounding_contact::{ContactLaw, KelvinVoigt};
use pounding_solver::{Clock, Elastic, Excitation, Histories, Integrator, Node, Oscillation, Pair, Row};

use crate::common::{AVERAGE, CENTRAL, HHT, LINEAR, MOREAU_JEAN, RK4, SUBSTEPPED, VERLET};
use crate::watch::Watch;

const MASS: f64 = 75e3;
const STIFFNESS: f64 = 9.35e7;
/// Ground acceleration that presses the structure against the wall \[m/s²\].
const PUSH: f64 = -1.0;

/// Largest distance from the deformation at rest over the last hundred steps, relative to it \[–\].
fn unrest(method: &Integrator, damping_ratio: f64, time_step: f64) -> f64 {
    const N_STEPS: usize = 20_000;
    // The columns are very weak: the motion depends on mass, spring and dashpot of the contact.
    let structure = Node::structure(MASS, 0.0, Elastic { stiffness: 1.0 });
    let pair = Pair::of_floors(
        0,
        1,
        0.0,
        ContactLaw::KelvinVoigt(KelvinVoigt {
            impact_stiffness: STIFFNESS,
            impact_damping_ratio: damping_ratio,
        }),
    );
    let row = Row::new(vec![structure, Node::wall(Elastic { stiffness: 1.0 })], vec![pair]).expect("a good row");
    // Pressed slowly: a swing back would reach the clamp, where the motion is nonlinear.
    let ramp = |step: usize| PUSH * (2.0 * step as f64 / N_STEPS as f64).min(1.0);
    let samples: Vec<_> = (0..N_STEPS + 2).map(ramp).collect();
    let excitation = Excitation::new(time_step, &samples).expect("good samples");
    let clock = Clock {
        time_step,
        n_steps: N_STEPS,
    };
    let mut histories = Histories::new(2, time_step, clock.time(N_STEPS));
    if method.watch(&row, excitation, clock, &mut histories).is_err() {
        return f64::INFINITY;
    }
    let rest = -PUSH * MASS / STIFFNESS;
    let states = &histories.of(0).states;
    let last = states[states.len() - 100..].iter();
    last.map(|state| (state.displacement / rest - 1.0).abs()).fold(0.0, f64::max)
}

#[test]
fn limit_a_pair_comes_to_rest_below_the_critical_time_step_and_not_above() {
    for (name, method) in [
        ("central difference", CENTRAL),
        ("CD, sub-steps", SUBSTEPPED),
        ("Verlet", VERLET),
        ("RK4", RK4),
    ] {
        // With less damping the first steps away from δ = 0 swing back to the clamp.
        for damping_ratio in [0.2, 0.5, 0.9] {
            let pair = Oscillation {
                angular_frequency: (STIFFNESS / MASS).sqrt(),
                damping_ratio,
            };
            let limit = method.critical_time_step_in_contact(&pair).unwrap();
            let (below, above) = (0.98 * limit, 1.02 * limit);
            let [below, above] = [below, above].map(|dt| unrest(&method, damping_ratio, dt));
            assert!(below < 1e-3, "{name}, ζ = {damping_ratio}: {below} below");
            assert!(above > 0.02, "{name}, ζ = {damping_ratio}: {above} above");
        }
    }
}

#[test]
fn limit_implicit_methods_come_to_rest_at_any_step() {
    let pair = Oscillation {
        angular_frequency: (STIFFNESS / MASS).sqrt(),
        damping_ratio: 0.2,
    };
    for method in [AVERAGE, HHT, MOREAU_JEAN] {
        assert_eq!(method.critical_time_step_in_contact(&pair), None);
    }
    let limit = LINEAR.critical_time_step_in_contact(&pair).unwrap();
    assert!((limit - 12.0_f64.sqrt() / pair.angular_frequency).abs() < 1e-12);
}
