//! A tower of bilinear storeys in as many scenes as a vector has room for.
//!
//! The equations are those of the central difference method. Floors are solved for each alone; the dashpots between them
//! then cost a product and a sum per floor on the way down, and again on the way up. No more than that waits for the
//! floor before.

#![expect(
    clippy::inline_always,
    reason = "instructions exist only inside the function that found the machine to have them"
)]

use pounding_solver::{Bilinear, Storey};

use super::vector::Vectors;
use super::{GROUP, LEVELS};

/// Floors from the ground up.
pub(super) struct Tower<V: Vectors, const N: usize> {
    pub(super) floors: [Floor<V>; N],
    pub(super) motions: [Motion<V>; N],
    pub(super) peaks: [Peak<V>; N],
}

/// Constants of a floor and of the storey below it.
#[derive(Clone, Copy)]
pub(super) struct Floor<V: Vectors> {
    pub(super) inverse_mass: V::Vector,
    stiffness: V::Vector,
    /// Stiffness that yielding takes.
    hysteretic: V::Vector,
    yield_drift: V::Vector,
    solve: V::Vector,
    carry: V::Vector,
    /// c/(2mΔt) of the dashpot to the floor below; 0 on the ground.
    below: V::Vector,
    /// Share of the last and the next increment of the floor above in the next one of this floor.
    from_above: V::Vector,
    /// Share of the next increment of the floor below in it.
    from_below: V::Vector,
    rates: Rates<V>,
}

/// Damping coefficients over the mass of a floor, which only impacts ask for.
#[derive(Clone, Copy)]
struct Rates<V: Vectors> {
    storey: V::Vector,
    ground: V::Vector,
    above: V::Vector,
}

/// What a floor carries from step to step.
#[derive(Clone, Copy)]
pub(super) struct Motion<V: Vectors> {
    pub(super) displacement: V::Vector,
    pub(super) increment: V::Vector,
    plastic: V::Vector,
}

/// Largest magnitudes.
#[derive(Clone, Copy)]
pub(super) struct Peak<V: Vectors> {
    pub(super) displacement: V::Vector,
    pub(super) drift: V::Vector,
}

/// A tower at a node at which floors were hit.
pub(super) struct Struck<V: Vectors, const N: usize> {
    pub(super) before: [Motion<V>; N],
    /// After the impacts.
    pub(super) velocities: [V::Vector; N],
    /// Without damping.
    pub(super) accelerations: [V::Vector; N],
}

/// The storeys of a tower, of a group of scenes.
type Storeys<const N: usize> = [[Storey<Bilinear>; N]; GROUP];

impl<V: Vectors, const N: usize> Tower<V, N> {
    /// At rest, in the scenes from the first of these on.
    #[inline(always)]
    pub(super) fn at_rest(
        v: V,
        (storeys, first): (&Storeys<N>, usize),
        dt: f64,
        ground: f64,
    ) -> Self {
        let zero = v.all(0.0);
        let motion = Motion {
            displacement: zero,
            // The textbook start from rest: u₀ − u₋₁ = −Δt² ü₀/2 with ü₀ = −a_g.
            increment: v.all(dt * (0.5 * dt * ground)),
            plastic: zero,
        };
        let peak = Peak {
            displacement: zero,
            drift: zero,
        };
        Self {
            floors: floors(v, (storeys, first), dt),
            motions: [motion; N],
            peaks: [peak; N],
        }
    }

    /// Lets all floors go on under forces at the lowest levels, if there are any; their accelerations without damping.
    #[inline(always)]
    pub(super) fn step<const PUSHED: bool>(
        &mut self,
        v: V,
        ground: V::Vector,
        forces: &[V::Vector; LEVELS],
    ) -> [V::Vector; N] {
        let zero = v.all(0.0);
        let (mut accelerations, mut next) = ([zero; N], [zero; N]);
        let mut carried = zero;
        for level in (0..N).rev() {
            let own = &self.floors[level];
            let below = level.checked_sub(1).map(|below| self.motions[below]);
            let motion = &mut self.motions[level];
            let peak = &mut self.peaks[level];
            let mut drift = motion.displacement;
            peak.displacement = v.max(peak.displacement, v.abs(motion.displacement));
            if let Some(below) = below {
                drift = v.sub(drift, below.displacement);
                peak.drift = v.max(peak.drift, v.abs(drift));
            }
            let yielded = v.min(motion.plastic, v.add(drift, own.yield_drift));
            motion.plastic = v.max(yielded, v.sub(drift, own.yield_drift));
            let lost = v.mul(own.hysteretic, motion.plastic);
            let force = v.sub(v.mul(own.stiffness, drift), lost);
            let mut load = v.sub(carried, force);
            if PUSHED && level < LEVELS {
                load = v.add(load, forces[level]);
            }
            carried = force;
            let acceleration = v.sub(v.mul(own.inverse_mass, load), ground);
            accelerations[level] = acceleration;
            let mut sum = v.add(acceleration, v.mul(own.carry, motion.increment));
            if let Some(below) = below {
                sum = v.add(sum, v.mul(own.below, below.increment));
            }
            next[level] = v.mul(own.solve, sum);
        }
        self.join(v, next);
        accelerations
    }

    /// Joins the increments of floors, solved for one by one, by the dashpots between them, and lets the floors go on.
    #[inline(always)]
    fn join(&mut self, v: V, mut next: [V::Vector; N]) {
        let mut above = v.all(0.0);
        for level in (0..N).rev() {
            let (own, before) = (&self.floors[level], self.motions[level].increment);
            let own_both = v.add(before, next[level]);
            let share = v.mul(own.from_above, above);
            next[level] = v.add(next[level], share);
            above = v.add(own_both, share);
        }
        let mut below = v.all(0.0);
        for (level, next) in next.into_iter().enumerate() {
            let motion = &mut self.motions[level];
            let share = v.mul(self.floors[level].from_below, below);
            motion.increment = v.add(next, share);
            motion.displacement = v.add(motion.displacement, motion.increment);
            below = motion.increment;
        }
    }

    /// Lets floors begin anew from velocities after impacts, at the node before this one: those that were hit at the lowest levels,
    /// and those beside them, whose dashpots feel it.
    #[inline(always)]
    pub(super) fn restart(
        &mut self,
        v: V,
        dt: f64,
        hits: &[V::Mask; LEVELS],
        Struck {
            before,
            velocities,
            accelerations,
        }: &Struck<V, N>,
    ) {
        let zero = v.all(0.0);
        for level in 0..N.min(LEVELS + 1) {
            let mut feels = v.exceeds(zero, zero);
            for hit in &hits[level.saturating_sub(1).min(LEVELS)..(level + 2).min(LEVELS)] {
                feels = v.or(feels, *hit);
            }
            let Rates {
                storey,
                ground,
                above,
            } = self.floors[level].rates;
            let velocity = velocities[level];
            let below = level.checked_sub(1).map_or(zero, |below| velocities[below]);
            let mut damping = v.mul(storey, v.sub(velocity, below));
            damping = v.add(damping, v.mul(ground, velocity));
            if level + 1 < N {
                let drift_rate = v.sub(velocities[level + 1], velocity);
                damping = v.sub(damping, v.mul(above, drift_rate));
            }
            let acceleration = v.sub(accelerations[level], damping);
            let half = v.mul(v.all(0.5 * dt), acceleration);
            let increment = v.mul(v.all(dt), v.add(velocity, half));
            let displacement = v.add(before[level].displacement, increment);
            let motion = &mut self.motions[level];
            motion.increment = v.select(feels, increment, motion.increment);
            motion.displacement = v.select(feels, displacement, motion.displacement);
        }
    }
}

/// Constants of all floors, by elimination from the top floor down.
#[inline(always)]
fn floors<V: Vectors, const N: usize>(
    v: V,
    (storeys, first): (&Storeys<N>, usize),
    dt: f64,
) -> [Floor<V>; N] {
    let gather = |level: usize, number: &dyn Fn(&Storey<Bilinear>) -> f64| {
        let numbers = storeys.each_ref().map(|storeys| number(&storeys[level]));
        v.load(&numbers[first..])
    };
    let (zero, one) = (v.all(0.0), v.all(1.0));
    let (inertia, half) = (v.all(1.0 / (dt * dt)), v.all(0.5 / dt));
    // Of the floor above: dashpot, and diagonal elements with and without the dashpot below it.
    let (mut upper, mut pivot, mut free) = (zero, one, zero);
    let mut level = N;
    let mut floors = [(); N].map(|()| {
        level -= 1;
        let inverse_mass = v.div(one, gather(level, &|storey| storey.mass));
        let damping = gather(level, &|storey| storey.damping);
        let rates = Rates {
            storey: v.mul(inverse_mass, damping),
            ground: v.mul(inverse_mass, gather(level, &|storey| storey.ground_damping)),
            above: v.mul(inverse_mass, upper),
        };
        let [own, ground, above] = [rates.storey, rates.ground, rates.above].map(
            #[inline(always)]
            |rate| v.mul(half, rate),
        );
        let all = v.add(v.add(own, ground), above);
        let share = v.div(v.mul(above, free), pivot);
        free = v.add(v.add(inertia, ground), share);
        let mut below = own;
        if level == 0 {
            free = v.add(free, own);
            below = zero;
        }
        (pivot, upper) = (v.add(free, below), damping);
        let solve = v.div(one, pivot);
        Floor {
            inverse_mass,
            stiffness: gather(level, &|storey| storey.column.stiffness),
            hysteretic: gather(level, &|storey| {
                (1.0 - storey.column.hardening) * storey.column.stiffness
            }),
            yield_drift: gather(level, &|storey| {
                storey.column.yield_force / storey.column.stiffness
            }),
            solve,
            carry: v.sub(inertia, all),
            below,
            from_above: v.mul(solve, above),
            from_below: v.mul(solve, below),
            rates,
        }
    });
    floors.reverse();
    floors
}
