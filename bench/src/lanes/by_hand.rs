//! A loop for exactly two buildings, written for the vectors of the machine, as a benchmark for lanes.
//!
//! It has the equations of the central difference method, specialised for its scenes. They have a fixed number of storeys, a single law at
//! every level, and a right building that is at most as tall. Structures of one storey are elastic, storeys of others bilinear. Floors are
//! solved separately. The dashpots between them then cost a product and a sum per floor on the way down, and again on the way up. Only
//! these wait for the floor before.

#![expect(
    clippy::inline_always,
    reason = "instructions exist only inside the function that found the machine to have them"
)]

use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch};
use pounding_contact::ContactLaw;

use super::tower::{Struck, Tower, V};
use crate::scenes::{GROUP, Group, numbers};

/// Peak displacements of all floors, those of the left building first; peak drifts in this order (0 for lowest storeys); and the sum of the
/// impulses at each level.
pub(super) type LoopNumbers = Vec<[f64; GROUP]>;

/// Numbers that the loop keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Keeps {
    /// Peaks and impulses.
    Peaks,
    /// Only impulses.
    Nothing,
}

/// Runs a group of scenes of `L` and `R` storeys through ground accelerations \[m/s²\] at steps \[s\].
///
/// `IN_STEP` vectors of scenes make each step together, without waiting for each other.
pub(super) fn run<const L: usize, const R: usize, const IN_STEP: usize>(
    level: Level,
    group: &Group<L, R>,
    law: ContactLaw,
    keeps: Keeps,
    ground: &[f64],
    dt: f64,
) -> LoopNumbers {
    let peaks = keeps == Keeps::Peaks;
    let (impulsive, law) = numbers(law);
    dispatch!(level, simd => match (peaks, impulsive) {
        (true, true) => Loop::<_, true, true> { simd, dt, law }.run::<L, R, IN_STEP>(group, ground),
        (true, false) => Loop::<_, true, false> { simd, dt, law }.run::<L, R, IN_STEP>(group, ground),
        (false, true) => Loop::<_, false, true> { simd, dt, law }.run::<L, R, IN_STEP>(group, ground),
        (false, false) => Loop::<_, false, false> { simd, dt, law }.run::<L, R, IN_STEP>(group, ground),
    })
}

/// As many scenes as fit into a vector.
struct Scenes<S: Simd, const L: usize, const R: usize> {
    left: Tower<S, L>,
    right: Tower<S, R>,
    gap: V<S>,
    pairs: [Pair<S>; R],
    /// Whether the element pushed anywhere at the node before: the impulse of the step in which it releases is open.
    pushed: bool,
}

/// The floors that face each other at a level.
#[derive(Clone, Copy)]
struct Pair<S: Simd> {
    reduced_mass: V<S>,
    force: V<S>,
    impulse: V<S>,
}

/// Common constants of all scenes: the step \[s\], and e, or β̄ \[N/m^1.5\] and ξ̄.
#[derive(Clone, Copy)]
struct Loop<S, const PEAKS: bool, const IMPULSIVE: bool> {
    simd: S,
    dt: f64,
    law: [f64; 2],
}

impl<S: Simd, const PEAKS: bool, const IMPULSIVE: bool> Loop<S, PEAKS, IMPULSIVE> {
    #[inline(always)]
    fn run<const L: usize, const R: usize, const IN_STEP: usize>(self, group: &Group<L, R>, ground: &[f64]) -> LoopNumbers {
        let mut found = vec![[0.0; GROUP]; 2 * (L + R) + R];
        let lanes = V::<S>::LEN;
        for first in (0..GROUP).step_by(IN_STEP * lanes) {
            let mut scenes: [Scenes<S, L, R>; IN_STEP] = std::array::from_fn(
                #[inline(always)]
                |vector| self.begin(group, first + vector * lanes, ground[0]),
            );
            self.steps(&mut scenes, ground);
            for (vector, scenes) in scenes.iter().enumerate() {
                scenes.tell(first + vector * lanes, &mut found);
            }
        }
        found
    }

    #[inline(always)]
    fn begin<const L: usize, const R: usize>(self, group: &Group<L, R>, first: usize, ground: f64) -> Scenes<S, L, R> {
        let Self { simd, dt, .. } = self;
        let left = Tower::at_rest(simd, &group.left, first, dt, ground);
        let right = Tower::at_rest(simd, &group.right, first, dt, ground);
        let (zero, one) = (V::<S>::splat(simd, 0.0), V::<S>::splat(simd, 1.0));
        let mut pairs = [Pair {
            reduced_mass: zero,
            force: zero,
            impulse: zero,
        }; R];
        for (level, pair) in pairs.iter_mut().enumerate() {
            pair.reduced_mass = one / (left.floors[level].inverse_mass + right.floors[level].inverse_mass);
        }
        Scenes {
            left,
            right,
            gap: V::<S>::from_slice(simd, &group.gaps[first..first + V::<S>::LEN]),
            pairs,
            pushed: false,
        }
    }

    #[inline(always)]
    fn steps<const L: usize, const R: usize, const IN_STEP: usize>(self, scenes: &mut [Scenes<S, L, R>; IN_STEP], ground: &[f64]) {
        let zero = V::<S>::splat(self.simd, 0.0);
        for acceleration in ground {
            let acceleration = V::<S>::splat(self.simd, *acceleration);
            let mut deformations = [[zero; R]; IN_STEP];
            let (mut touching, mut pushed) = (zero.simd_gt(zero), false);
            for (scenes, deformations) in scenes.iter().zip(&mut deformations) {
                pushed |= scenes.pushed;
                for (level, deformation) in deformations.iter_mut().enumerate() {
                    let [left, right] = [scenes.left.motions[level], scenes.right.motions[level]];
                    *deformation = left.displacement - right.displacement - scenes.gap;
                    touching |= deformation.simd_ge(zero);
                }
            }
            let apart = !(pushed || touching.any_true());
            for (scenes, deformations) in scenes.iter_mut().zip(&deformations) {
                if apart {
                    scenes.left.step::<PEAKS, false, R>(acceleration, deformations);
                    scenes.right.step::<PEAKS, false, R>(acceleration, deformations);
                } else if IMPULSIVE {
                    self.impact(scenes, acceleration, deformations);
                } else {
                    self.push(scenes, acceleration, deformations);
                }
            }
        }
    }

    /// A step with impacts after it, if touching floors approach.
    #[inline(always)]
    fn impact<const L: usize, const R: usize>(self, scenes: &mut Scenes<S, L, R>, ground: V<S>, deformations: &[V<S>; R]) {
        let zero = V::<S>::splat(self.simd, 0.0);
        let mut left = self.struck::<L, R>(&mut scenes.left, ground);
        let mut right = self.struck::<R, R>(&mut scenes.right, ground);
        let (mut hits, mut hit) = ([zero.simd_gt(zero); R], zero.simd_gt(zero));
        for (level, pair) in scenes.pairs.iter_mut().enumerate() {
            let velocities = [&mut left.velocities[level], &mut right.velocities[level]];
            let rate = *velocities[0] - *velocities[1];
            hits[level] = deformations[level].simd_ge(zero) & rate.simd_gt(zero);
            hit |= hits[level];
            let impulse = rate * (1.0 + self.law[0]) * pair.reduced_mass;
            let impulse = hits[level].select(impulse, zero);
            pair.impulse += impulse;
            *velocities[0] -= scenes.left.floors[level].inverse_mass * impulse;
            *velocities[1] += scenes.right.floors[level].inverse_mass * impulse;
        }
        if hit.any_true() {
            scenes.left.restart(self.dt, &hits, &left);
            scenes.right.restart(self.dt, &hits, &right);
        }
    }

    /// Advances a building from a node, and keeps its state there, before impacts.
    #[inline(always)]
    fn struck<const N: usize, const R: usize>(self, tower: &mut Tower<S, N>, ground: V<S>) -> Struck<S, N> {
        let before = tower.motions;
        let accelerations = tower.step::<PEAKS, false, R>(ground, &[ground; R]);
        let mut velocities = [ground; N];
        for (level, velocity) in velocities.iter_mut().enumerate() {
            let both = tower.motions[level].increment + before[level].increment;
            *velocity = both * (0.5 / self.dt);
        }
        Struck {
            before,
            velocities,
            accelerations,
        }
    }

    /// A step under the forces of the nonlinear viscoelastic element.
    #[inline(always)]
    fn push<const L: usize, const R: usize>(self, scenes: &mut Scenes<S, L, R>, ground: V<S>, deformations: &[V<S>; R]) {
        let zero = V::<S>::splat(self.simd, 0.0);
        let (mut left, mut right) = ([zero; R], [zero; R]);
        scenes.pushed = false;
        for (level, pair) in scenes.pairs.iter_mut().enumerate() {
            let deformation = deformations[level];
            let overlaps = deformation.simd_gt(zero);
            if !(overlaps | pair.force.simd_gt(zero)).any_true() {
                continue;
            }
            let [one, other] = [scenes.left.motions[level], scenes.right.motions[level]];
            let rate = (one.increment - other.increment) * (1.0 / self.dt);
            let force = self.force(pair.reduced_mass, deformation, rate);
            let force = overlaps.select(force, zero);
            pair.impulse += (pair.force + force) * (0.5 * self.dt);
            pair.force = force;
            scenes.pushed |= force.simd_gt(zero).any_true();
            (left[level], right[level]) = (zero - force, force);
        }
        scenes.left.step::<PEAKS, true, R>(ground, &left);
        scenes.right.step::<PEAKS, true, R>(ground, &right);
    }

    /// The force of the element at a deformation and its rate; NaN if the pair is apart.
    #[inline(always)]
    fn force(self, reduced_mass: V<S>, deformation: V<S>, rate: V<S>) -> V<S> {
        let [stiffness, ratio] = self.law;
        let root = deformation.sqrt();
        let spring = deformation * stiffness * root;
        let damping = (root * stiffness * reduced_mass).sqrt() * (2.0 * ratio);
        let approach = rate.simd_gt(V::<S>::splat(self.simd, 0.0));
        approach.select(spring + damping * rate, spring)
    }
}

impl<S: Simd, const L: usize, const R: usize> Scenes<S, L, R> {
    #[inline(always)]
    fn tell(&self, first: usize, found: &mut LoopNumbers) {
        let lanes = first..first + self.gap.as_slice().len();
        let peaks = self.left.peaks.iter().chain(&self.right.peaks);
        let motions = self.left.motions.iter().chain(&self.right.motions);
        for (floor, (peak, motion)) in peaks.zip(motions).enumerate() {
            // The last displacement prevents a bare loop from being optimised away.
            let displacement = peak[0].max(motion.displacement.abs() * 1e-300);
            displacement.store_slice(&mut found[floor][lanes.clone()]);
            peak[1].store_slice(&mut found[L + R + floor][lanes.clone()]);
        }
        for (level, pair) in self.pairs.iter().enumerate() {
            let impulses = &mut found[2 * (L + R) + level][lanes.clone()];
            pair.impulse.store_slice(impulses);
        }
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;
    use crate::scenes::{laws, towers};

    #[test]
    fn limit_vectors_of_both_widths_give_the_same_bits() {
        let level = Level::new();
        let (Some(wide), Some(narrow)) = (level.as_avx512(), level.as_avx2()) else {
            return;
        };
        let pulses: Vec<f64> = (0..400).map(|step| 4.0 * libm::sin(0.06 * f64::from(step))).collect();
        for law in laws().unwrap() {
            let group = &towers()[0];
            let at = |level| run::<_, _, 1>(level, group, law, Keeps::Peaks, &pulses, 0.01);
            let (one, other) = (at(wide.level()), at(narrow.level()));
            assert_eq!(one, other);
            let impulses = one.last().unwrap();
            assert!(impulses.iter().any(|impulse| *impulse > 0.0));
        }
    }
}
