//! Links of random rows: every law, between any two floors, to walls and to the ground.

use std::f64::consts::PI;

use super::random::Random;
use pounding_scene::Structure;
use pounding_scene::file::{End, Law, Link, OfRow, Side};

/// Rate of deformation at which a viscous damper is as strong as a linear one \[m/s\].
const SPEED: f64 = 0.3;

/// One to four links of a row with a structure that moves.
pub(super) fn all(random: &mut Random, structures: &[Structure]) -> Vec<Link> {
    let n = 1 + random.below(4);
    let mut links = Vec::new();
    while links.len() < n {
        links.extend(one(random, structures));
    }
    links
}

/// A link, if its ends can move against each other.
fn one(random: &mut Random, structures: &[Structure]) -> Option<Link> {
    let [first, second] = [0; 2].map(|_| random.below(structures.len()));
    let mass = |floor: usize| match &structures[first] {
        Structure::Sdof(sdof) => Some(sdof.mass_kg),
        Structure::Building(building) => building.storeys.get(floor - 1).map(|storey| storey.mass_kg),
        Structure::Wall => None,
    };
    let floors = [first, second].map(|structure| match &structures[structure] {
        Structure::Sdof(_) => Some(1),
        Structure::Building(building) => Some(building.storeys.len()),
        Structure::Wall => None,
    });
    let own = 1 + random.below(floors[0]?);
    let to_ground = random.chance(0.2);
    let other = floors[1].map(|n| if to_ground { 0 } else { 1 + random.below(n) });
    let law = law(random, mass(own)?);
    let side = random.one_of(&[Side::Left, Side::Right]);
    let end = |structure: usize, floor| End {
        structure: OfRow::Place(structure + 1),
        floor,
    };
    let apart = first != second || other != Some(own);
    apart.then(|| Link {
        between: [end(first, Some(own)), end(second, other)],
        side: (first == second).then_some(side),
        law,
    })
}

/// A law for a floor with this mass \[kg\].
fn law(random: &mut Random, mass: f64) -> Law {
    let omega = 2.0 * PI / random.log_within(0.1, 2.0);
    let stiffness_n_per_m = mass * omega * omega;
    let damping_n_s_per_m = 2.0 * random.log_within(0.02, 0.5) * mass * omega;
    let yields = random.chance(0.6);
    let yield_force_n = yields.then_some(stiffness_n_per_m * random.log_within(1e-3, 3e-2));
    let hardens = yields && random.chance(0.5);
    let hardening_ratio = hardens.then_some(random.within(0.0, 0.3));
    match random.below(6) {
        0 => Law::Spring {
            stiffness_n_per_m,
            yield_force_n,
            hardening_ratio,
            damping_n_s_per_m: random.chance(0.5).then_some(damping_n_s_per_m),
        },
        1 => Law::Dashpot { damping_n_s_per_m },
        2 => Law::Maxwell {
            stiffness_n_per_m,
            damping_n_s_per_m,
        },
        3 => Law::Restrainer {
            stiffness_n_per_m,
            slack_m: if random.chance(0.3) { 0.0 } else { random.log_within(1e-3, 5e-2) },
            yield_force_n,
        },
        _ => {
            // 1/α is a whole number, and has few digits.
            let exponent = random.one_of(&[0.5, 0.5, 0.25, 0.2, 0.125, 0.1]);
            Law::Viscous {
                coefficient: damping_n_s_per_m * libm::pow(SPEED, 1.0 - exponent),
                exponent,
                brace_stiffness_n_per_m: Some(stiffness_n_per_m),
            }
        }
    }
}
