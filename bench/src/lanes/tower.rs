//! A building in as many scenes as fit into a vector: structures of one storey are elastic, storeys of others bilinear.

#![expect(
    clippy::inline_always,
    reason = "instructions exist only inside the function that found the machine to have them"
)]

use fearless_simd::prelude::*;
use pounding_solver::{Bilinear, Storey};

use crate::scenes::GROUP;

/// A number of as many scenes as fit into a vector.
pub(super) type V<S> = <S as Simd>::f64s;

/// Floors from the ground up, and the largest magnitudes of their displacements and drifts.
pub(super) struct Tower<S: Simd, const N: usize> {
    pub(super) floors: [Floor<S>; N],
    pub(super) motions: [FloorState<S>; N],
    pub(super) peaks: [[V<S>; 2]; N],
}

/// Constants of a floor and of the storey below it.
#[derive(Clone, Copy)]
pub(super) struct Floor<S: Simd> {
    pub(super) inverse_mass: V<S>,
    stiffness: V<S>,
    /// The yielding part of the stiffness.
    hysteretic: V<S>,
    yield_drift: V<S>,
    solve: V<S>,
    carry: V<S>,
    /// c/(2mΔt) of the dashpot to the floor below; 0 on the ground.
    below: V<S>,
    /// Share of the last and the next increment of the floor above in the next one of this floor.
    from_above: V<S>,
    /// Share of the next increment of the floor below in it.
    from_below: V<S>,
    /// Damping coefficients over the mass, of the storey, against the ground and of the storey above; needed only for impacts.
    rates: [V<S>; 3],
}

/// State of a floor from step to step.
#[derive(Clone, Copy)]
pub(super) struct FloorState<S: Simd> {
    pub(super) displacement: V<S>,
    pub(super) increment: V<S>,
    plastic: V<S>,
}

/// A building at a node at which floors were hit.
pub(super) struct Struck<S: Simd, const N: usize> {
    pub(super) before: [FloorState<S>; N],
    /// Velocities after the impacts.
    pub(super) velocities: [V<S>; N],
    /// Accelerations without damping.
    pub(super) accelerations: [V<S>; N],
}

/// The storeys of a building, of a group of scenes.
type Storeys<const N: usize> = [[Storey<Bilinear>; N]; GROUP];

impl<S: Simd, const N: usize> Tower<S, N> {
    /// A tower at rest, in the scenes that start with `first`.
    #[inline(always)]
    pub(super) fn at_rest(simd: S, storeys: &Storeys<N>, first: usize, dt: f64, ground: f64) -> Self {
        let zero = V::<S>::splat(simd, 0.0);
        let motion = FloorState {
            displacement: zero,
            // The textbook start from rest: u₀ − u₋₁ = −Δt² ü₀/2 with ü₀ = −a_g.
            increment: V::<S>::splat(simd, dt * (0.5 * dt * ground)),
            plastic: zero,
        };
        Self {
            floors: floors(simd, storeys, first, dt),
            motions: [motion; N],
            peaks: [[zero; 2]; N],
        }
    }

    /// Advances all floors, with forces at the lowest levels if there are any; returns their accelerations without damping.
    #[inline(always)]
    pub(super) fn step<const PEAKS: bool, const PUSHED: bool, const LEVELS: usize>(
        &mut self,
        ground: V<S>,
        forces: &[V<S>; LEVELS],
    ) -> [V<S>; N] {
        let zero = V::<S>::splat(ground.token(), 0.0);
        let (mut accelerations, mut next) = ([zero; N], [zero; N]);
        let mut carried = zero;
        for level in (0..N).rev() {
            let own = &self.floors[level];
            let below = level.checked_sub(1).map(|below| self.motions[below]);
            let motion = &mut self.motions[level];
            let [displacement, drift_peak] = &mut self.peaks[level];
            let mut drift = motion.displacement;
            if PEAKS {
                *displacement = displacement.max(drift.abs());
            }
            if let Some(below) = below {
                drift -= below.displacement;
                if PEAKS {
                    *drift_peak = drift_peak.max(drift.abs());
                }
            }
            let mut force = own.stiffness * drift;
            if N > 1 {
                let yielded = motion.plastic.min(drift + own.yield_drift);
                motion.plastic = yielded.max(drift - own.yield_drift);
                force -= own.hysteretic * motion.plastic;
            }
            let mut load = carried - force;
            if PUSHED && level < LEVELS {
                load += forces[level];
            }
            carried = force;
            let acceleration = own.inverse_mass * load - ground;
            accelerations[level] = acceleration;
            let mut sum = acceleration + own.carry * motion.increment;
            if let Some(below) = below {
                sum += own.below * below.increment;
            }
            next[level] = own.solve * sum;
        }
        self.join(next);
        accelerations
    }

    /// Couples the increments of floors, solved separately, by the dashpots between them, and advances the floors.
    #[inline(always)]
    fn join(&mut self, mut next: [V<S>; N]) {
        let mut above = next[N - 1] + self.motions[N - 1].increment;
        for level in (0..N - 1).rev() {
            let own_both = self.motions[level].increment + next[level];
            let share = self.floors[level].from_above * above;
            next[level] += share;
            above = own_both + share;
        }
        for (level, mut next) in next.into_iter().enumerate() {
            if level > 0 {
                next += self.floors[level].from_below * self.motions[level - 1].increment;
            }
            let motion = &mut self.motions[level];
            motion.increment = next;
            motion.displacement += next;
        }
    }

    /// Restarts floors from velocities after impacts, at the node before: floors that were hit at the lowest levels, and their neighbours,
    /// whose dashpots feel the jump.
    #[inline(always)]
    pub(super) fn restart<const LEVELS: usize>(&mut self, dt: f64, hits: &[S::mask64s; LEVELS], struck: &Struck<S, N>) {
        let velocities = &struck.velocities;
        for level in 0..N.min(LEVELS + 1) {
            let lowest = level.saturating_sub(1).min(LEVELS - 1);
            let mut feels = hits[lowest];
            for hit in &hits[lowest..(level + 2).min(LEVELS)] {
                feels |= *hit;
            }
            let [storey, ground, above] = self.floors[level].rates;
            let velocity = velocities[level];
            let mut drift_rate = velocity;
            if level > 0 {
                drift_rate -= velocities[level - 1];
            }
            let mut damping = storey * drift_rate + ground * velocity;
            if level + 1 < N {
                damping -= above * (velocities[level + 1] - velocity);
            }
            let acceleration = struck.accelerations[level] - damping;
            let increment = (velocity + acceleration * (0.5 * dt)) * dt;
            let displacement = struck.before[level].displacement + increment;
            let motion = &mut self.motions[level];
            motion.increment = feels.select(increment, motion.increment);
            motion.displacement = feels.select(displacement, motion.displacement);
        }
    }
}

/// Constants of all floors, by elimination from the top floor down.
#[inline(always)]
fn floors<S: Simd, const N: usize>(simd: S, storeys: &Storeys<N>, first: usize, dt: f64) -> [Floor<S>; N] {
    let gather = |level: usize, number: fn(&Storey<Bilinear>) -> f64| {
        let numbers = storeys.each_ref().map(|storeys| number(&storeys[level]));
        V::<S>::from_slice(simd, &numbers[first..first + V::<S>::LEN])
    };
    let (zero, one) = (V::<S>::splat(simd, 0.0), V::<S>::splat(simd, 1.0));
    let (inertia, half) = (V::<S>::splat(simd, 1.0 / (dt * dt)), 0.5 / dt);
    // Of the floor above: its dashpot, and diagonal elements with and without the dashpot below it.
    let (mut upper, mut pivot, mut free) = (zero, one, zero);
    let mut level = N;
    let mut floors = [(); N].map(|()| {
        level -= 1;
        let inverse_mass = one / gather(level, |storey| storey.mass);
        let damping = gather(level, |storey| storey.damping);
        let of_ground = gather(level, |storey| storey.ground_damping);
        let rates = [damping, of_ground, upper].map(|damping| inverse_mass * damping);
        let [own, ground, above] = rates.map(|rate| rate * half);
        let share = above * free / pivot;
        free = inertia + ground + share;
        let mut below = own;
        if level == 0 {
            free += own;
            below = zero;
        }
        (pivot, upper) = (free + below, damping);
        let solve = one / pivot;
        let stiffness = gather(level, |storey| storey.column.stiffness);
        Floor {
            inverse_mass,
            stiffness,
            hysteretic: stiffness * gather(level, |storey| 1.0 - storey.column.hardening),
            yield_drift: gather(level, |storey| storey.column.yield_force) / stiffness,
            solve,
            carry: inertia - (own + ground + above),
            below,
            from_above: solve * above,
            from_below: solve * below,
            rates,
        }
    });
    floors.reverse();
    floors
}
