//! Short rows with the motions of their structures at hand: in registers, not in memory, from node to node.
//!
//! Two groups go in step, so that what one computes does not wait for the other. Three structures go on so while no lane touches, two also
//! over their impacts. The same for forces of two made the loop without contact longer by a sixth, and gained nothing in contact.
//!
//! Structures stand alone, each at the place of its node.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::Grounds;
use super::body::{AtNode, Passed};
use super::column::SideBySideColumn;
use super::frame::Frame;
use super::group::Group;
use super::jump::struck;
use super::law::Law;
use super::number::{Lanes, Mask};
use super::scenes::MotionOf;

/// Structures of the longest rows that go in step two groups at once. Structures of longer rows do not wait for each other, and a second
/// group doubles the memory in use.
pub(super) const SHORT: usize = 3;

/// Steps over nodes with motions at hand as far as that goes; returns how many it passed.
#[inline(always)]
pub(super) fn go_on<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>, G: Grounds>(
    groups: &mut [Group<S, Column, F>],
    nodes: &[G::Node],
) -> usize {
    let [one, other] = groups else {
        return 0;
    };
    if !(one.is_plain() && other.is_plain()) {
        return 0;
    }
    match one.structures.len() {
        2 => go_on_with::<S, Column, F, G, 2>([one, other], nodes),
        SHORT => go_on_with::<S, Column, F, G, SHORT>([one, other], nodes),
        _ => 0,
    }
}

/// `go_on` for rows of N structures, two or more.
#[inline(always)]
#[expect(
    clippy::needless_range_loop,
    reason = "iterators over the motions of both groups would keep them in memory"
)]
fn go_on_with<
    S: Simd,
    Column: SideBySideColumn,
    F: Frame<S, Column>,
    G: Grounds,
    const N: usize,
>(
    [one, other]: [&mut Group<S, Column, F>; 2],
    nodes: &[G::Node],
) -> usize {
    let simd = one.simd;
    let zero = Lanes::splat(simd, 0.0);
    let motion = |group: &Group<S, Column, F>, index: usize| group.structures[index].motion;
    let mut motions: [[_; N]; 2] = [
        std::array::from_fn(|index| motion(one, index)),
        std::array::from_fn(|index| motion(other, index)),
    ];
    let may_strike = N == 2 && one.has_impacts();
    let mut n_passed = 0;
    for node in nodes {
        let mut touching = [Mask::splat(simd, false); 2];
        for left in 1..N {
            for (group, pair) in [&one.pairs[left - 1], &other.pairs[left - 1]]
                .into_iter()
                .enumerate()
            {
                if let Some(pair) = pair {
                    let motions = &motions[group];
                    let ahead = motions[left - 1].displacement - motions[left].displacement;
                    touching[group] = touching[group] | (ahead - pair.gap).reaches(zero);
                }
            }
        }
        let grounds = G::at(simd, node);
        if Lanes::any(touching[0] | touching[1]) {
            if !may_strike {
                break;
            }
            let passed = step([one, other], &mut motions, grounds);
            one.strike(touching[0], &passed[0], &mut motions[0], grounds[0]);
            other.strike(touching[1], &passed[1], &mut motions[1], grounds[1]);
        } else {
            step([one, other], &mut motions, grounds);
        }
        n_passed += 1;
    }
    for index in 0..N {
        one.structures[index].motion = motions[0][index];
        other.structures[index].motion = motions[1][index];
    }
    n_passed
}

/// The step of two groups from a node without pounding forces; returns the displacements and forces that it found there.
#[inline(always)]
fn step<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>, const N: usize>(
    [one, other]: [&Group<S, Column, F>; 2],
    motions: &mut [[MotionOf<S, Column>; N]; 2],
    [ground, its]: [Lanes<S>; 2],
) -> [[Passed<S>; N]; 2] {
    let zero = ground.like(0.0);
    let mut passed = [[Passed {
        displacement: zero,
        restoring_force: zero,
    }; N]; 2];
    for index in 0..N {
        let constants = [
            &one.structures[index].constants,
            &other.structures[index].constants,
        ];
        passed[0][index] = constants[0].step(&mut motions[0][index], zero, ground);
        passed[1][index] = constants[1].step(&mut motions[1][index], zero, its);
    }
    passed
}

impl<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>> Group<S, Column, F> {
    /// Whether its first two structures have impacts.
    #[inline(always)]
    fn has_impacts(&self) -> bool {
        matches!(&self.pairs[0], Some(pair) if matches!(pair.law, Law::Impulsive(_)))
    }

    /// Strikes its first two structures where they touch at a node, with their motions after the step from it at hand.
    #[inline(always)]
    fn strike<const N: usize>(
        &mut self,
        touches: Mask<S>,
        passed: &[Passed<S>; N],
        motions: &mut [MotionOf<S, Column>; N],
        ground: Lanes<S>,
    ) {
        if !Lanes::any(touches) {
            return;
        }
        // Groups without impacts do not come here.
        let [Some(pair), ..] = &mut self.pairs[..] else {
            return;
        };
        let Law::Impulsive(law) = pair.law else {
            return;
        };
        self.touching_steps += 1;
        let [one, other] = [&self.structures[0].constants, &self.structures[1].constants];
        let velocities = [
            one.velocity_before(&motions[0]),
            other.velocity_before(&motions[1]),
        ];
        let mobilities = [
            one.coefficients.inverse_mass,
            other.coefficients.inverse_mass,
        ];
        let Some(struck) = struck((touches, law.factor), velocities, mobilities) else {
            return;
        };
        pair.tally.strike(struck.impulse);
        for index in 0..2 {
            let constants = &self.structures[index].constants;
            let node = AtNode {
                displacement: passed[index].displacement,
                velocity: velocities[index],
                restoring_force: passed[index].restoring_force,
                jumped: struck.velocities[index],
            };
            let acceleration = constants.acceleration(&node, ground.like(0.0), ground);
            constants.restart(&mut motions[index], &node, acceleration, node.jumps());
        }
    }
}
