//! The same arithmetic as the central difference method, for scenes that are known to have two towers, of eight and of five storeys,
//! which touch at five levels.

#![expect(
    clippy::inline_always,
    reason = "instructions exist only inside the function that found the machine to have them"
)]

use super::element::Element;
use super::tower::{Struck, Tower};
use super::vector::{Avx2, Avx512, Vectors};
use super::{FLOORS, FoundInTowers, GROUP, LEVELS, Law, STOREYS, Towers};

/// Runs a group with the widest vectors of this machine, if it has any.
pub(super) fn run(towers: &Towers, law: Law, ground: &[f64], dt: f64) -> Option<FoundInTowers> {
    let scenes = (towers, law);
    let wide = Avx512::here().map(|machine| run_by(machine, scenes, ground, dt));
    wide.or_else(|| Avx2::here().map(|machine| run_by(machine, scenes, ground, dt)))
}

fn run_by<V: Vectors>(v: V, scenes: (&Towers, Law), ground: &[f64], dt: f64) -> FoundInTowers {
    v.run(
        #[inline(always)]
        || by_law(v, scenes, ground, dt),
    )
}

#[inline(always)]
fn by_law<V: Vectors>(
    v: V,
    (towers, law): (&Towers, Law),
    ground: &[f64],
    dt: f64,
) -> FoundInTowers {
    match law {
        Law::Stereomechanical(restitution) => Loop::<V, true> {
            v,
            dt,
            factor: 1.0 + restitution,
            element: Element {
                stiffness: 0.0,
                ratio: 0.0,
            },
        }
        .run(towers, ground),
        Law::Viscoelastic(stiffness, ratio) => Loop::<V, false> {
            v,
            dt,
            factor: 0.0,
            element: Element { stiffness, ratio },
        }
        .run(towers, ground),
    }
}

/// As many scenes as a vector has room for.
struct Scenes<V: Vectors> {
    left: Tower<V, { STOREYS[0] }>,
    right: Tower<V, { STOREYS[1] }>,
    gap: V::Vector,
    pairs: [Pair<V>; LEVELS],
    /// Whether the element pushed somewhere at the node before: the impulse of the step in which it lets go is open.
    pushed: bool,
}

/// The floors that face each other at a level.
#[derive(Clone, Copy)]
struct Pair<V: Vectors> {
    reduced_mass: V::Vector,
    force: V::Vector,
    impulse: V::Vector,
}

/// What all scenes have in common: 1 + e, or the element, and the step \[s\].
#[derive(Clone, Copy)]
struct Loop<V, const IMPULSIVE: bool> {
    v: V,
    dt: f64,
    factor: f64,
    element: Element,
}

impl<V: Vectors, const IMPULSIVE: bool> Loop<V, IMPULSIVE> {
    #[inline(always)]
    fn run(self, towers: &Towers, ground: &[f64]) -> FoundInTowers {
        let mut found = FoundInTowers {
            displacements: [[0.0; GROUP]; FLOORS],
            drifts: [[0.0; GROUP]; FLOORS],
            impulses: [[0.0; GROUP]; LEVELS],
        };
        for first in (0..GROUP).step_by(V::LANES) {
            let mut scenes = self.begin(towers, first, ground[0]);
            for acceleration in ground {
                self.step(&mut scenes, self.v.all(*acceleration));
            }
            self.tell(&scenes, first, &mut found);
        }
        found
    }

    #[inline(always)]
    fn begin(self, towers: &Towers, first: usize, ground: f64) -> Scenes<V> {
        let Self { v, dt, .. } = self;
        let left = Tower::at_rest(v, (&towers.left, first), dt, ground);
        let right = Tower::at_rest(v, (&towers.right, first), dt, ground);
        let zero = v.all(0.0);
        let mut pairs = [Pair {
            reduced_mass: zero,
            force: zero,
            impulse: zero,
        }; LEVELS];
        for (level, pair) in pairs.iter_mut().enumerate() {
            let inverse = [
                left.floors[level].inverse_mass,
                right.floors[level].inverse_mass,
            ];
            pair.reduced_mass = v.div(v.all(1.0), v.add(inverse[0], inverse[1]));
        }
        Scenes {
            left,
            right,
            gap: v.load(&towers.gaps[first..]),
            pairs,
            pushed: false,
        }
    }

    #[inline(always)]
    fn step(self, scenes: &mut Scenes<V>, ground: V::Vector) {
        let v = self.v;
        let zero = v.all(0.0);
        let mut deformations = [zero; LEVELS];
        let mut touching = v.exceeds(zero, zero);
        for (level, deformation) in deformations.iter_mut().enumerate() {
            let [left, right] = [scenes.left.motions[level], scenes.right.motions[level]];
            *deformation = v.sub(v.sub(left.displacement, right.displacement), scenes.gap);
            touching = v.or(touching, v.reaches(*deformation, zero));
        }
        if !(v.any(touching) || scenes.pushed) {
            scenes.left.step::<false>(v, ground, &deformations);
            scenes.right.step::<false>(v, ground, &deformations);
        } else if IMPULSIVE {
            self.impact(scenes, ground, &deformations);
        } else {
            self.push(scenes, ground, &deformations);
        }
    }

    /// A step with impacts after it, where touching floors approach.
    #[inline(always)]
    fn impact(self, scenes: &mut Scenes<V>, ground: V::Vector, deformations: &[V::Vector; LEVELS]) {
        let Self { v, dt, .. } = self;
        let zero = v.all(0.0);
        let mut left = self.struck(&mut scenes.left, ground);
        let mut right = self.struck(&mut scenes.right, ground);
        let (mut hits, mut hit) = ([v.exceeds(zero, zero); LEVELS], v.exceeds(zero, zero));
        for (level, pair) in scenes.pairs.iter_mut().enumerate() {
            let velocities = [&mut left.velocities[level], &mut right.velocities[level]];
            let rate = v.sub(*velocities[0], *velocities[1]);
            hits[level] = v.and(v.reaches(deformations[level], zero), v.exceeds(rate, zero));
            hit = v.or(hit, hits[level]);
            let impulse = v.mul(v.mul(v.all(self.factor), rate), pair.reduced_mass);
            let impulse = v.select(hits[level], impulse, zero);
            pair.impulse = v.add(pair.impulse, impulse);
            let floors = [&scenes.left.floors[level], &scenes.right.floors[level]];
            let changes = floors.map(
                #[inline(always)]
                |floor| v.mul(floor.inverse_mass, impulse),
            );
            *velocities[0] = v.sub(*velocities[0], changes[0]);
            *velocities[1] = v.add(*velocities[1], changes[1]);
        }
        if v.any(hit) {
            scenes.left.restart(v, dt, &hits, &left);
            scenes.right.restart(v, dt, &hits, &right);
        }
    }

    /// Lets a tower go on from a node, and keeps how it was there, before impacts.
    #[inline(always)]
    fn struck<const N: usize>(self, tower: &mut Tower<V, N>, ground: V::Vector) -> Struck<V, N> {
        let v = self.v;
        let before = tower.motions;
        let accelerations = tower.step::<false>(v, ground, &[ground; LEVELS]);
        let inverse = v.all(0.5 / self.dt);
        let mut velocities = [inverse; N];
        for (level, velocity) in velocities.iter_mut().enumerate() {
            let both = v.add(tower.motions[level].increment, before[level].increment);
            *velocity = v.mul(inverse, both);
        }
        Struck {
            before,
            velocities,
            accelerations,
        }
    }

    /// A step under the forces of the nonlinear viscoelastic element.
    #[inline(always)]
    fn push(self, scenes: &mut Scenes<V>, ground: V::Vector, deformations: &[V::Vector; LEVELS]) {
        let Self { v, dt, element, .. } = self;
        let zero = v.all(0.0);
        let (mut left, mut right) = ([zero; LEVELS], [zero; LEVELS]);
        scenes.pushed = false;
        for (level, pair) in scenes.pairs.iter_mut().enumerate() {
            let overlaps = v.exceeds(deformations[level], zero);
            if !v.any(v.or(overlaps, v.exceeds(pair.force, zero))) {
                continue;
            }
            let increments = [
                scenes.left.motions[level].increment,
                scenes.right.motions[level].increment,
            ];
            let rate = v.mul(v.all(1.0 / dt), v.sub(increments[0], increments[1]));
            let force = element.force(v, pair.reduced_mass, [deformations[level], rate]);
            let force = v.select(overlaps, force, zero);
            let half = v.mul(v.all(0.5 * dt), v.add(pair.force, force));
            pair.impulse = v.add(pair.impulse, half);
            pair.force = force;
            scenes.pushed |= v.any(v.exceeds(force, zero));
            (left[level], right[level]) = (v.sub(zero, force), force);
        }
        scenes.left.step::<true>(v, ground, &left);
        scenes.right.step::<true>(v, ground, &right);
    }

    #[inline(always)]
    fn tell(self, scenes: &Scenes<V>, first: usize, found: &mut FoundInTowers) {
        let v = self.v;
        let peaks = scenes.left.peaks.iter().chain(&scenes.right.peaks);
        for (floor, peak) in peaks.enumerate() {
            v.store(peak.displacement, &mut found.displacements[floor][first..]);
            v.store(peak.drift, &mut found.drifts[floor][first..]);
        }
        for (pair, impulses) in scenes.pairs.iter().zip(&mut found.impulses) {
            v.store(pair.impulse, &mut impulses[first..]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::towers::groups;

    #[test]
    fn limit_vectors_of_both_widths_give_the_same_bits() {
        let (Some(wide), Some(narrow)) = (Avx512::here(), Avx2::here()) else {
            return;
        };
        let pulses: Vec<f64> = (0..400)
            .map(|step| 4.0 * libm::sin(0.06 * f64::from(step)))
            .collect();
        for law in [Law::Stereomechanical(0.65), Law::Viscoelastic(2.75e9, 0.35)] {
            let scenes = (&groups()[0], law);
            let one = run_by(wide, scenes, &pulses, 0.01);
            let other = run_by(narrow, scenes, &pulses, 0.01);
            assert_eq!(one.displacements, other.displacements);
            assert_eq!(one.drifts, other.drifts);
            assert_eq!(one.impulses, other.impulses);
            assert!(
                one.impulses[LEVELS - 1]
                    .iter()
                    .any(|impulse| *impulse > 0.0)
            );
        }
    }
}
