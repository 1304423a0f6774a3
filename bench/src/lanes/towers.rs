//! The scenes of two towers, at random: what varies, and between which bounds.

use std::f64::consts::PI;

use pounding_solver::{Bilinear, Levels, ModelError, Pair, Row, Storey};
use rand_pcg::Pcg64;

use super::by_hand::{FLOORS, GROUP, Law, Towers};
use super::contact;
use crate::setting::{self, DAMPING, GAPS, GRAVITY, MASS, between};

/// Scenes of each law.
pub(super) const SCENES: usize = 1024;
/// Least and largest mass of a floor, over that of the scenes of two structures.
const MASSES: [f64; 2] = [0.5, 1.5];
/// Least and largest period of a tower over its storeys \[s\].
const PERIODS: [f64; 2] = [0.06, 0.15];
/// Least and largest base shear at yield over the weight.
const SHEARS: [f64; 2] = [0.1, 0.4];
/// Stiffness after yielding over that before.
const HARDENING: f64 = 0.05;
/// Rayleigh damping has its ratio at the first mode, and at so many times its frequency.
const DAMPED_TO: f64 = 5.0;

/// Towers at random, in groups.
pub(crate) fn groups() -> Vec<Towers> {
    let mut random = setting::random();
    let mut group = || Towers {
        left: std::array::from_fn(|_| tower(&mut random)),
        right: std::array::from_fn(|_| tower(&mut random)),
        gaps: std::array::from_fn(|_| between(&mut random, GAPS)),
    };
    (0..SCENES / GROUP).map(|_| group()).collect()
}

/// A tower of equal floors and storeys, which yield from a share of the weight on that falls with the floors above.
fn tower<const N: usize>(random: &mut Pcg64) -> [Storey<Bilinear>; N] {
    let mass = MASS * between(random, MASSES);
    let omega = 2.0 * PI / (N as f64 * between(random, PERIODS));
    let shear = between(random, SHEARS);
    // The first mode of a row of equal masses and springs.
    let of_storey = omega / (2.0 * libm::sin(0.5 * PI / (2 * N + 1) as f64));
    let stiffness = mass * of_storey * of_storey;
    let sum = (1.0 + DAMPED_TO) * omega;
    std::array::from_fn(|level| Storey {
        mass,
        damping: 2.0 * DAMPING / sum * stiffness,
        ground_damping: 2.0 * DAMPING * DAMPED_TO * omega * omega / sum * mass,
        column: Bilinear {
            stiffness,
            yield_force: shear * GRAVITY * mass * (N - level) as f64,
            hardening: HARDENING,
        },
    })
}

/// The same scenes as rows.
pub(crate) fn rows(
    group: &Towers,
    levels: &Levels,
    law: Law,
) -> Vec<Result<Row<Bilinear>, ModelError>> {
    let row = |lane: usize| {
        let node = |node: usize| {
            let (tower, storey) = levels.place(node);
            let storey = match tower {
                0 => group.left[lane][storey],
                _ => group.right[lane][storey],
            };
            levels.floor(node, storey)
        };
        let pair = |(left, right)| Pair::of_floors(left, right, group.gaps[lane], contact(law));
        let nodes = (0..FLOORS).map(node).collect();
        Row::new(nodes, levels.facing(0).map(pair).collect())
    };
    (0..GROUP).map(row).collect()
}
