//! The same arithmetic as the central difference method with velocity jumps, for scenes that are known to have two structures, one
//! pair and no wall: two vectors of scenes in step, which do not wait for each other.

#![expect(
    clippy::inline_always,
    reason = "instructions exist only inside the function that found the machine to have them"
)]

use super::element::Element;
use super::vector::{Avx2, Avx512, Vectors};
use super::{Found, GROUP, Group, Law};

/// Vectors that go in step.
const IN_STEP: usize = 2;

/// The widest instructions of this machine that the loop knows.
pub(super) fn instructions() -> Option<&'static str> {
    let wide = Avx512::here().map(|_| "AVX-512");
    wide.or_else(|| Avx2::here().map(|_| "AVX2"))
}

/// Runs a group with the widest vectors of this machine, if it has any.
pub(super) fn run<const PEAKS: bool>(group: &Group, ground: &[f64], dt: f64) -> Option<Found> {
    if let Some(machine) = Avx512::here() {
        return Some(machine.run(
            #[inline(always)]
            || by_law::<Avx512, PEAKS>(machine, group, ground, dt),
        ));
    }
    let machine = Avx2::here()?;
    Some(machine.run(
        #[inline(always)]
        || by_law::<Avx2, PEAKS>(machine, group, ground, dt),
    ))
}

#[inline(always)]
fn by_law<V: Vectors, const PEAKS: bool>(v: V, group: &Group, ground: &[f64], dt: f64) -> Found {
    match group.law {
        Law::Stereomechanical(e) => Loop::<V, PEAKS, true> {
            v,
            dt,
            law: [e, 0.0],
        }
        .run(group, ground),
        Law::Viscoelastic(stiffness, ratio) => Loop::<V, PEAKS, false> {
            v,
            dt,
            law: [stiffness, ratio],
        }
        .run(group, ground),
    }
}

/// Constants and state of one structure in as many scenes as a vector has room for.
#[derive(Clone, Copy)]
struct Body<V: Vectors> {
    inverse_mass: V::Vector,
    stiffness: V::Vector,
    damping: V::Vector,
    solve: V::Vector,
    carry: V::Vector,
    displacement: V::Vector,
    increment: V::Vector,
    peak: V::Vector,
}

/// As many scenes as a vector has room for.
#[derive(Clone, Copy)]
struct Scenes<V: Vectors> {
    bodies: [Body<V>; 2],
    gap: V::Vector,
    reduced_mass: V::Vector,
    impulse: V::Vector,
    force: V::Vector,
}

/// What all scenes have in common: e, or β̄ and ξ̄, and the step \[s\].
#[derive(Clone, Copy)]
struct Loop<V, const PEAKS: bool, const IMPULSIVE: bool> {
    v: V,
    dt: f64,
    law: [f64; 2],
}

impl<V: Vectors, const PEAKS: bool, const IMPULSIVE: bool> Loop<V, PEAKS, IMPULSIVE> {
    #[inline(always)]
    fn run(self, group: &Group, ground: &[f64]) -> Found {
        let mut found = Found {
            peaks: [[0.0; GROUP]; 2],
            impulses: [0.0; GROUP],
        };
        for first in (0..GROUP).step_by(IN_STEP * V::LANES) {
            let mut scenes = [
                self.begin(group, first, ground[0]),
                self.begin(group, first + V::LANES, ground[0]),
            ];
            self.steps(&mut scenes, ground);
            for (vector, scenes) in scenes.iter().enumerate() {
                self.tell(scenes, first + vector * V::LANES, &mut found);
            }
        }
        found
    }

    #[inline(always)]
    fn begin(self, group: &Group, first: usize, ground: f64) -> Scenes<V> {
        let v = self.v;
        let bodies = [
            self.at_rest(group, 0, first, ground),
            self.at_rest(group, 1, first, ground),
        ];
        let both = v.add(bodies[0].inverse_mass, bodies[1].inverse_mass);
        Scenes {
            bodies,
            gap: v.load(&group.gaps[first..]),
            reduced_mass: v.div(v.all(1.0), both),
            impulse: v.all(0.0),
            force: v.all(0.0),
        }
    }

    #[inline(always)]
    fn at_rest(self, group: &Group, index: usize, first: usize, ground: f64) -> Body<V> {
        let Self { v, dt, .. } = self;
        let one = v.all(1.0);
        let inverse_mass = v.div(one, v.load(&group.masses[index][first..]));
        let damping = v.load(&group.dampings[index][first..]);
        let rate = v.mul(inverse_mass, damping);
        let half = v.div(v.mul(v.all(0.5), rate), v.all(dt));
        let inertia = v.all(1.0 / (dt * dt));
        Body {
            inverse_mass,
            stiffness: v.load(&group.stiffnesses[index][first..]),
            damping,
            solve: v.div(one, v.add(inertia, half)),
            carry: v.sub(inertia, half),
            displacement: v.all(0.0),
            // The textbook start from rest: u₀ − u₋₁ = −Δt² ü₀/2 with ü₀ = −a_g.
            increment: v.all(dt * (0.5 * dt * ground)),
            peak: v.all(0.0),
        }
    }

    #[inline(always)]
    fn steps(self, scenes: &mut [Scenes<V>; IN_STEP], ground: &[f64]) {
        let v = self.v;
        for acceleration in ground {
            let acceleration = v.all(*acceleration);
            let deformations = [self.deformation(&scenes[0]), self.deformation(&scenes[1])];
            let touching = [
                self.touches(&scenes[0], deformations[0]),
                self.touches(&scenes[1], deformations[1]),
            ];
            if !v.any(v.or(touching[0], touching[1])) {
                self.free(&mut scenes[0], acceleration);
                self.free(&mut scenes[1], acceleration);
                continue;
            }
            for vector in 0..IN_STEP {
                if IMPULSIVE {
                    self.impact(&mut scenes[vector], acceleration, deformations[vector]);
                } else {
                    self.push(&mut scenes[vector], acceleration, deformations[vector]);
                }
            }
        }
    }

    /// How far the pair overlaps.
    #[inline(always)]
    fn deformation(self, scenes: &Scenes<V>) -> V::Vector {
        let [left, right] = &scenes.bodies;
        let apart = self.v.sub(left.displacement, right.displacement);
        self.v.sub(apart, scenes.gap)
    }

    /// Where a pair touches, or had a force: for the impulse of the step in which it parts.
    #[inline(always)]
    fn touches(self, scenes: &Scenes<V>, deformation: V::Vector) -> V::Mask {
        let v = self.v;
        let zero = v.all(0.0);
        let pushed = v.exceeds(scenes.force, zero);
        v.or(v.reaches(deformation, zero), pushed)
    }

    #[inline(always)]
    fn tell(self, scenes: &Scenes<V>, first: usize, found: &mut Found) {
        let v = self.v;
        v.store(scenes.impulse, &mut found.impulses[first..]);
        for (body, peaks) in scenes.bodies.iter().zip(&mut found.peaks) {
            // The last displacement keeps a bare loop from being optimised away.
            let last = v.mul(v.abs(body.displacement), v.all(1e-300));
            v.store(v.max(body.peak, last), &mut peaks[first..]);
        }
    }

    /// A step without contact.
    #[inline(always)]
    fn free(self, scenes: &mut Scenes<V>, ground: V::Vector) {
        let v = self.v;
        for body in &mut scenes.bodies {
            let force = v.mul(body.stiffness, body.displacement);
            self.advance(body, v.sub(v.all(0.0), force), ground);
        }
    }

    /// The next displacement under a force.
    #[inline(always)]
    fn advance(self, body: &mut Body<V>, force: V::Vector, ground: V::Vector) {
        let v = self.v;
        let load = v.sub(v.mul(body.inverse_mass, force), ground);
        let sum = v.add(load, v.mul(body.carry, body.increment));
        if PEAKS {
            body.peak = v.max(body.peak, v.abs(body.displacement));
        }
        body.increment = v.mul(body.solve, sum);
        body.displacement = v.add(body.displacement, body.increment);
    }

    /// A step with impacts after it, where a touching pair approaches.
    #[inline(always)]
    fn impact(self, scenes: &mut Scenes<V>, ground: V::Vector, deformation: V::Vector) {
        let Self { v, dt, law } = self;
        let zero = v.all(0.0);
        let before = scenes.bodies;
        self.free(scenes, ground);
        let two = v.all(2.0 * dt);
        let [left, right] = &scenes.bodies;
        let velocities = [
            v.div(v.add(left.increment, before[0].increment), two),
            v.div(v.add(right.increment, before[1].increment), two),
        ];
        let rate = v.sub(velocities[0], velocities[1]);
        let hit = v.and(v.reaches(deformation, zero), v.exceeds(rate, zero));
        if !v.any(hit) {
            return;
        }
        let demand = v.mul(v.all(1.0 + law[0]), rate);
        let mobility = v.add(before[0].inverse_mass, before[1].inverse_mass);
        let impulse = v.div(demand, mobility);
        scenes.impulse = v.select(hit, v.add(scenes.impulse, impulse), scenes.impulse);
        for (index, body) in scenes.bodies.iter_mut().enumerate() {
            let change = v.mul(body.inverse_mass, impulse);
            let velocity = if index == 0 {
                v.sub(velocities[index], change)
            } else {
                v.add(velocities[index], change)
            };
            let dashpot = v.sub(zero, v.mul(body.damping, velocity));
            let force = v.sub(dashpot, v.mul(body.stiffness, before[index].displacement));
            let acceleration = v.sub(v.mul(body.inverse_mass, force), ground);
            let half = v.mul(v.all(0.5 * dt), acceleration);
            let increment = v.mul(v.all(dt), v.add(velocity, half));
            let displacement = v.add(before[index].displacement, increment);
            body.increment = v.select(hit, increment, body.increment);
            body.displacement = v.select(hit, displacement, body.displacement);
        }
    }

    /// A step under the force of the nonlinear viscoelastic element.
    #[inline(always)]
    fn push(self, scenes: &mut Scenes<V>, ground: V::Vector, deformation: V::Vector) {
        let Self { v, dt, law } = self;
        let zero = v.all(0.0);
        let overlaps = v.exceeds(deformation, zero);
        let [left, right] = &scenes.bodies;
        let rate = v.div(v.sub(left.increment, right.increment), v.all(dt));
        let element = Element {
            stiffness: law[0],
            ratio: law[1],
        };
        let force = element.force(v, scenes.reduced_mass, [deformation, rate]);
        let force = v.select(overlaps, force, zero);
        let half = v.mul(v.all(0.5 * dt), v.add(scenes.force, force));
        scenes.impulse = v.add(scenes.impulse, half);
        scenes.force = force;
        for (index, body) in scenes.bodies.iter_mut().enumerate() {
            let own = if index == 0 {
                v.sub(zero, force)
            } else {
                force
            };
            let restoring = v.mul(body.stiffness, body.displacement);
            self.advance(body, v.sub(own, restoring), ground);
        }
    }
}
