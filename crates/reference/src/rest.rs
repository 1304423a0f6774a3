//! Rest: pairs of an impulsive law that press.
//!
//! With a₀ the absolute accelerations without their forces F, 0 ≤ F ⟂ W F − G a₀ ≥ 0. A pair presses and does not close, or it opens
//! without a force. This also holds for grounds that move differently.
//!
//! A pair that closes or opens within rounding is *idle*: it stays together without a force until its motion exceeds rounding. This decides
//! ties: the time between an acceleration of zero and one of ten thousand roundings is too short to affect any result.

use std::convert::identity;

use super::block::{Block, best, groups};
use super::equations::{Equations, NOW};
use super::model::{Neighbours, TIME, displacement, velocity};
use super::phases::ContactPhase;
use super::storey::sign;

/// Rounding of a closing acceleration, relative to its terms.
pub(super) const IDLE: f64 = 1e-13;

/// How the rate of the force of a pair at rest is computed.
#[derive(Debug, Clone, Copy)]
struct Probe {
    /// Time over which the force is differenced \[s\], along a straight line of the unknowns.
    time: f64,
    /// Rounding of the rate, as a part of the forces \[1/s\].
    rounding: f64,
}

impl Probe {
    /// For forces of columns and grounds, which are straight along the line.
    const STRAIGHT: Self = Self {
        time: 1e-4,
        rounding: 1e-10,
    };
    /// For forces of compliant contacts, which bend.
    const BENT: Self = Self {
        time: 1e-6,
        rounding: 1e-8,
    };
}

impl Equations {
    /// Whether any pair is at rest, or friction could hold a floor.
    pub(super) fn rests(&self) -> bool {
        let mut pairs = self.phases.pairs.iter();
        pairs.any(|phase| matches!(phase.contact, ContactPhase::Resting { .. })) || self.model.frictions().next().is_some()
    }

    /// Sets the accelerations of floors at rest and the forces of their pairs; `slope` has absolute accelerations.
    pub(super) fn lean(&self, slope: &mut [f64]) {
        let Self { model, block, .. } = self;
        if block.pairs.is_empty() {
            return;
        }
        let without = self.floors(slope);
        for (pair, force) in block.pairs.iter().zip(block.forces(identity, &without)) {
            slope[model.impulse(*pair)] = force;
            self.brace(*pair, force, slope);
        }
        let accelerations = block.accelerations(identity, &without);
        for (floor, acceleration) in accelerations.into_iter().enumerate() {
            slope[velocity(floor)] = acceleration;
        }
    }

    /// Absolute accelerations of floors and walls \[m/s²\].
    fn floors(&self, slope: &[f64]) -> Vec<f64> {
        let floors = 0..self.model.structures.len();
        floors.map(|floor| slope[velocity(floor)]).collect()
    }

    /// Magnitude of the terms of the force on every floor \[N\], without those of pairs at rest.
    pub(super) fn loads(&self, y: &[f64]) -> Vec<f64> {
        let structures = self.model.structures.iter().enumerate();
        let mut forces = vec![0.0; self.model.structures.len()];
        for (index, structure) in structures {
            let size = |unknown: fn(usize) -> usize| {
                let below = structure.below.map_or(0.0, |below| y[unknown(below)].abs());
                y[unknown(index)].abs() + below
            };
            let force = structure.columns.stiffness * size(displacement)
                + (structure.damping + structure.ground_damping) * size(velocity)
                + self.restoring_force(index, y).abs();
            forces[index] += force;
            if let Some(below) = structure.below {
                forces[below] += force;
            }
        }
        for (index, pair) in self.model.pairs.iter().enumerate() {
            let force = self
                .pounding_force(index, self.model.deformation(index, y), self.model.rate(index, y))
                .abs();
            for (floor, part) in pair.ends.parts() {
                forces[floor] += part.abs() * force;
            }
        }
        for (index, link) in self.model.links.iter().enumerate() {
            let [stiffness, damping] = link.rates();
            let size = |unknown: fn(usize) -> usize| link.ends.size(|floor| y[unknown(floor)].abs());
            let force = stiffness * size(displacement) + damping * size(velocity) + self.link_force(index, y).abs();
            for (floor, part) in link.ends.parts() {
                forces[floor] += part.abs() * force;
            }
        }
        for (index, friction) in self.model.frictions() {
            forces[index] += friction.limit + self.segment.ground(index, y[TIME]).abs() / friction.inverse_mass;
        }
        forces
    }

    /// Magnitude of the terms of the acceleration of every floor and wall \[m/s²\].
    pub(super) fn terms(&self, y: &[f64]) -> Vec<f64> {
        let mut forces = self.loads(y);
        for (index, force) in forces.iter_mut().enumerate() {
            *force = if self.model.is_wall(index) {
                self.segment.ground(index, y[TIME]).abs()
            } else {
                *force * self.model.structures[index].inverse_mass
            };
        }
        forces
    }

    /// Closing acceleration of a pair that is not at rest \[m/s²\]; `slope` is the derivative of the unknowns.
    pub(super) fn closing(&self, pair: usize, y: &[f64], slope: &[f64]) -> f64 {
        let neighbours = self.model.pairs[pair];
        let [left, right] = neighbours.ends.grounds().map(|one| self.segment.ground(one, y[TIME]));
        neighbours.ends.ahead(|floor| slope[velocity(floor)]) + (left - right)
    }

    /// Closing accelerations of pairs while a block presses, and their rounding \[m/s²\].
    ///
    /// Floors and walls have the accelerations `without` the block; `terms` is the size of their terms.
    fn closings(&self, block: &Block, without: &[f64], terms: &[f64]) -> Vec<[f64; 2]> {
        let accelerations = block.accelerations(identity, without);
        let terms = block.accelerations(f64::abs, terms);
        let closing = |pair: &Neighbours| {
            let rounding = IDLE * pair.ends.size(|floor| terms[floor]);
            [pair.ends.ahead(|floor| accelerations[floor]), rounding]
        };
        self.model.pairs.iter().map(closing).collect()
    }

    /// Negative once an idle pair closes or opens by more than rounding.
    pub(super) fn idles(&self, pair: usize, y: &[f64], scratch: &mut [f64]) -> f64 {
        self.accelerate(NOW, y, scratch);
        let closings = self.closings(&self.block, &self.floors(scratch), &self.terms(y));
        let [closing, rounding] = closings[pair];
        rounding - closing.abs()
    }

    /// Finds the block of some pairs at rest; returns the closing accelerations of all pairs and their rounding \[m/s²\].
    pub(super) fn press(&mut self, resting: &[usize], y: &[f64], scratch: &mut [f64]) -> Vec<[f64; 2]> {
        self.accelerate(NOW, y, scratch);
        let (without, terms) = (self.floors(scratch), self.terms(y));
        let groups = groups(&self.model, resting).into_iter();
        let pressing = groups.flat_map(|group| self.pressing(&group, &without, &terms));
        self.block = Block::new(&self.model, pressing.collect());
        self.closings(&self.block, &without, &terms)
    }

    /// Decides which floors stick, and which pairs at rest press, which part, and which are idle.
    ///
    /// `scratch` is the derivative of the unknowns afterwards.
    pub(super) fn decide(&mut self, y: &[f64], scratch: &mut [f64]) {
        let rests = |&pair: &usize| matches!(self.phases.pairs[pair].contact, ContactPhase::Resting { .. });
        let resting: Vec<usize> = (0..self.model.pairs.len()).filter(rests).collect();
        self.stick_or_slide(&resting, y, scratch);
        let closings = self.press(&resting, y, scratch);
        for &pair in &resting {
            let [closing, rounding] = closings[pair];
            let presses = self.block.pairs.contains(&pair);
            let phase = &mut self.phases.pairs[pair];
            phase.contact = ContactPhase::Resting { presses, rising: -1.0 };
            if !presses && closing < -rounding {
                phase.contact = ContactPhase::Apart;
                phase.direction = -1.0;
            }
        }
        self.slope(NOW, y, scratch);
        for &pair in &resting {
            if self.phases.presses(pair) {
                let rising = sign(self.resting_force_rate(pair, y, scratch)[0]);
                self.phases.pairs[pair].contact = ContactPhase::Resting { presses: true, rising };
            }
        }
        self.rise_or_fall(y, scratch);
    }

    /// Finds the pressing pairs of a group at rest, from absolute accelerations without them and the size of their terms.
    ///
    /// A pair presses if it would close without its force. A dependent pair presses if it shares the force of others.
    fn pressing(&self, group: &[usize], without: &[f64], terms: &[f64]) -> Vec<usize> {
        let tried = |set: &[usize]| {
            let pairs = set.iter().map(|member| group[*member]).collect();
            let block = Block::new(&self.model, pairs);
            let closings = self.closings(&block, without, terms);
            let excess = move |member: usize| closings[group[member]][0] - closings[group[member]][1];
            (block, excess)
        };
        let judge = |set: &[usize]| {
            let (all, excess) = tried(set);
            let forces = all.forces(identity, without);
            let sizes = all.forces(f64::abs, terms);
            let lack = |position: usize| {
                let others = [&set[..position], &set[position + 1..]].concat();
                let (others, excess) = tried(&others);
                let needed = if others.rank() < all.rank() {
                    excess(set[position])
                } else {
                    let own = forces[position] - IDLE * sizes[position];
                    own / self.model.pairs[all.pairs[position]].reduced_mass
                };
                if needed > 0.0 { 0.0 } else { f64::MIN_POSITIVE.max(-needed) }
            };
            let mut miss = (0..group.len()).map(excess).fold(0.0, f64::max);
            if miss == 0.0 {
                miss = (0..set.len()).map(lack).fold(0.0, f64::max);
            }
            let squares = forces.iter().map(|force| force * force).sum();
            (miss, squares, all.pairs)
        };
        best(group.len(), judge).unwrap_or_default()
    }

    /// Rate of the force of a pair at rest \[N/s\], and its rounding. `slope` is the derivative of the unknowns.
    fn resting_force_rate(&self, pair: usize, y: &[f64], slope: &[f64]) -> [f64; 2] {
        let sizes = self.block.forces(f64::abs, &self.terms(y));
        let sizes = self.block.pairs.iter().zip(sizes);
        let size = sizes.filter(|(of, _)| **of == pair).map(|(_, size)| size);
        self.rate_of(self.model.impulse(pair), size.sum(), y, slope)
    }

    /// Rate \[N/s\] of a force whose impulse is an unknown and whose terms have a size, and its rounding.
    pub(super) fn rate_of(&self, impulse: usize, size: f64, y: &[f64], slope: &[f64]) -> [f64; 2] {
        let force = |by: f64| {
            let near = y.iter().zip(slope).map(|(unknown, slope)| unknown + by * slope);
            let mut change = vec![0.0; y.len()];
            let near = near.collect::<Vec<_>>();
            self.slope(NOW, &near, &mut change);
            change[impulse]
        };
        let touches = |phase: &ContactPhase| phase.touches() && !matches!(phase, ContactPhase::Resting { .. });
        let bent = self.phases.pairs.iter().any(|phase| touches(&phase.contact));
        let Probe { time, rounding } = if bent { Probe::BENT } else { Probe::STRAIGHT };
        let rate = (force(time) - force(-time)) / (2.0 * time);
        [rate, rounding * size]
    }

    /// Negative once the force of a pair at rest has passed a maximum or minimum.
    pub(super) fn resting_peak(&self, pair: usize, y: &[f64], slope: &[f64]) -> f64 {
        let ContactPhase::Resting { rising, .. } = self.phases.pairs[pair].contact else {
            return 0.0;
        };
        let [rate, rounding] = self.resting_force_rate(pair, y, slope);
        rising * rate + rounding
    }
}
