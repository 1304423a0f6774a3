//! Neighbours that touch very slowly under a law with δ̇/v₀ and are then pressed together by the ground.

use insta::assert_snapshot;
use pounding_contact::{ContactLaw, HertzDamp, ModifiedKelvin, PantWijeyewickrema};
use pounding_solver::{Elastic, Exact, Excitation, Histories, Integrator, Node, Row, RunError, Work};

use crate::common::{METHODS, RK4, clock, free, pairs};
use crate::watch::Watch;

const DURATION: f64 = 0.3;

fn hertz_damp(impact_stiffness: f64, impact_damping_factor: f64) -> ContactLaw {
    ContactLaw::HertzDamp(HertzDamp {
        impact_stiffness,
        impact_damping_factor,
    })
}

/// Laws with δ̇/v₀.
fn laws() -> [ContactLaw; 3] {
    let (impact_stiffness, impact_damping_factor) = (9.35e7, 1.0);
    [
        hertz_damp(2.75e9, impact_damping_factor),
        ContactLaw::ModifiedKelvin(ModifiedKelvin {
            impact_stiffness,
            impact_damping_factor,
        }),
        ContactLaw::PantWijeyewickrema(PantWijeyewickrema {
            impact_stiffness,
            impact_damping_factor,
        }),
    ]
}

/// A mass at a wall, without a gap, under a constant ground acceleration of 3 m/s² that presses it against the wall.
fn pressed(
    (law, mass, approach_speed): (ContactLaw, f64, f64),
    (method, time_step): (Integrator, f64),
) -> Result<(Work, Vec<f64>), RunError> {
    let nodes = vec![free(mass, approach_speed), Node::wall(Elastic { stiffness: 0.0 })];
    let row = Row::new(nodes, pairs(2, 0.0, law)).expect("as built");
    let mut histories = Histories::new(2, 0.01, DURATION);
    let ground = [-3.0; 32];
    let excitation = Excitation::new(0.01, &ground).expect("as built");
    let clock = clock(time_step, DURATION);
    let work = method.watch(&row, excitation, clock, &mut histories)?;
    let states = &histories.of(0).states;
    Ok((work, states.iter().map(|state| state.displacement).collect()))
}

/// Largest difference relative to the largest displacement.
fn distance(found: &[f64], known: &[f64]) -> f64 {
    let largest = known.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    let differences = found.iter().zip(known).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max) / largest
}

#[test]
fn issue_slow_touches_under_pressure_end_in_every_method() {
    // A damper a/v₀ without bound held the pair almost still, in ever shorter pieces of the exact method.
    let exact = (Integrator::Exact(Exact::default()), 0.01);
    for law in laws() {
        let run = |speed: f64, method| pressed((law, 75e3, speed), method);
        let (_, at_rest) = run(0.0, exact).expect("it ends");
        for speed in [1e-15, 1e-9, 1e-7, 1e-5, 9e-4] {
            let (work, found) = run(speed, exact).expect("it ends");
            assert!(work.segments < 1000, "{law:?}, {speed}: {work:?}");
            // The response is continuous on the way to v₀ = 0.
            let (apart, moved) = (distance(&found, &at_rest), 2e3 * speed);
            assert!(apart < 1e-9 + moved, "{law:?}, {speed}: {apart:e}");
            let (_, stepped) = run(speed, (RK4, 1e-5)).expect("it ends");
            let apart = distance(&stepped, &found);
            assert!(apart < 1e-3, "{law:?}, {speed}: {apart:e} in small steps");
            for (name, method) in METHODS {
                let (work, _) = run(speed, (method, 1e-3)).expect("it ends");
                assert!(work.steps >= 300, "{name}, {law:?}, {speed}: {work:?}");
            }
        }
    }
}

#[test]
fn extreme_a_contact_that_crawls_is_refused() {
    // A hundred kilograms between stone: the damper would hold for hours.
    let scene = (hertz_damp(1e11, 1e6), 100.0, 1e-7);
    let error = pressed(scene, (Integrator::Exact(Exact::default()), 0.01)).unwrap_err();
    assert_snapshot!(error);
    // Implicit steps pass over it.
    pressed(scene, (crate::common::AVERAGE, 1e-3)).expect("it ends");
}
