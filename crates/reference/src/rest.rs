//! Rest: pairs of an impulsive law that press.
//!
//! With a₀ the accelerations in space of all that no pair at rest pushes, F has 0 ≤ F ⟂ W F − G a₀ ≥ 0: a pair presses, and then it does
//! not close, or it opens without a force. Grounds that move differently change nothing in this.
//!
//! What closes and opens by no more than rounding is *idle*: it stays together without a force until it does more. That decides ties:
//! between an acceleration of zero and one of ten thousand roundings lies no time that a result could show.

use std::convert::identity;

use super::block::{Block, best, groups};
use super::branch::sign;
use super::model::{TIME, displacement, velocity};
use super::motion::{Motion, NOW};
use super::phases::Contact;

/// Closing acceleration, as a part of those it is the difference of, that is rounding.
const IDLE: f64 = 1e-13;

/// How the rate of the force of a pair at rest is found.
#[derive(Debug, Clone, Copy)]
struct Probe {
    /// Time over which the force is differenced \[s\], along a straight line of the unknowns.
    time: f64,
    /// Part of the forces it is the difference of that rounding leaves of the rate \[1/s\].
    rounding: f64,
}

impl Probe {
    /// Forces of columns and grounds are straight along the line.
    const STRAIGHT: Self = Self {
        time: 1e-4,
        rounding: 1e-10,
    };
    /// Those of compliant contacts bend.
    const BENT: Self = Self {
        time: 1e-6,
        rounding: 1e-8,
    };
}

/// Accelerations in space of all floors and walls while some pairs press, of those without \[m/s²\], and their terms.
fn with(blocks: &[Block], slope: &[f64], terms: &[f64]) -> [Vec<f64>; 2] {
    let own = |floor: usize| slope[velocity(floor)];
    let mut found = [(0..terms.len()).map(own).collect(), terms.to_vec()];
    for block in blocks {
        let accelerations = block.accelerations(identity, own);
        let sizes = block.accelerations(f64::abs, |floor| terms[floor]);
        for (found, of) in found.iter_mut().zip([accelerations, sizes]) {
            for (floor, value) in of {
                found[floor] = value;
            }
        }
    }
    found
}

impl Motion {
    /// Whether any pair is at rest.
    pub(super) fn rests(&self) -> bool {
        let mut pairs = self.phases.pairs.iter();
        pairs.any(|phase| matches!(phase.contact, Contact::Resting { .. }))
    }

    /// Gives floors at rest the accelerations of their blocks and the pairs their forces; `slope` has accelerations in space.
    pub(super) fn lean(&self, slope: &mut [f64]) {
        for block in &self.blocks {
            let forces = block.forces(identity, |floor| slope[velocity(floor)]);
            let accelerations = block.accelerations(identity, |floor| slope[velocity(floor)]);
            for (pair, force) in forces {
                slope[self.model.impulse(pair)] = force;
            }
            for (floor, acceleration) in accelerations {
                slope[velocity(floor)] = acceleration;
            }
        }
    }

    /// Magnitude of the terms of the acceleration of every floor and wall \[m/s²\].
    fn terms(&self, y: &[f64]) -> Vec<f64> {
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
                .pounding_force(
                    index,
                    self.model.deformation(index, y),
                    self.model.rate(index, y),
                )
                .abs();
            for (floor, part) in pair.parts() {
                forces[floor] += part.abs() * force;
            }
        }
        for (index, force) in forces.iter_mut().enumerate() {
            *force = if self.model.is_wall(index) {
                self.segment.ground(index, y[TIME]).abs()
            } else {
                *force * self.model.structures[index].inverse_mass
            };
        }
        forces
    }

    /// Acceleration with which a pair closes that is not at rest \[m/s²\]; `slope` is the derivative of the unknowns.
    pub(super) fn closing(&self, pair: usize, y: &[f64], slope: &[f64]) -> f64 {
        let neighbours = self.model.pairs[pair];
        let [left, right] = neighbours
            .grounds()
            .map(|one| self.segment.ground(one, y[TIME]));
        neighbours.ahead(|floor| slope[velocity(floor)]) + (left - right)
    }

    /// Acceleration with which a pair closes or opens \[m/s²\] while floors and walls move so in space, and what rounding leaves of it.
    fn apart(&self, pair: usize, [accelerations, terms]: &[Vec<f64>; 2]) -> [f64; 2] {
        let pair = &self.model.pairs[pair];
        [
            pair.ahead(|floor| accelerations[floor]),
            IDLE * pair.size(|floor| terms[floor]),
        ]
    }

    /// Negative once an idle pair closes or opens by more than rounding.
    pub(super) fn idles(&self, pair: usize, y: &[f64], scratch: &mut [f64]) -> f64 {
        self.accelerate(NOW, y, scratch);
        let moving = with(&self.blocks, scratch, &self.terms(y));
        let [closing, rounding] = self.apart(pair, &moving);
        rounding - closing.abs()
    }

    /// Decides which pairs at rest press, which part, and which are idle.
    ///
    /// `scratch` is the derivative of the unknowns afterwards.
    pub(super) fn decide(&mut self, y: &[f64], scratch: &mut [f64]) {
        let rests =
            |&pair: &usize| matches!(self.phases.pairs[pair].contact, Contact::Resting { .. });
        let resting: Vec<usize> = (0..self.model.pairs.len()).filter(rests).collect();
        self.blocks.clear();
        self.accelerate(NOW, y, scratch);
        let terms = self.terms(y);
        let groups = groups(&self.model, &resting).into_iter();
        let pressing = groups.filter_map(|group| self.pressing(&group, scratch, &terms));
        self.blocks = pressing
            .map(|pairs| Block::new(&self.model, pairs))
            .collect();
        let moving = with(&self.blocks, scratch, &terms);
        for &pair in &resting {
            let [closing, rounding] = self.apart(pair, &moving);
            let presses = self.blocks.iter().any(|block| block.has(pair));
            let phase = &mut self.phases.pairs[pair];
            phase.contact = Contact::Resting {
                presses,
                rising: -1.0,
            };
            if !presses && closing < -rounding {
                phase.contact = Contact::Apart;
                phase.direction = -1.0;
            }
        }
        self.slope(NOW, y, scratch);
        for &pair in &resting {
            if self.phases.presses(pair) {
                let rising = sign(self.resting_force_rate(pair, y, scratch)[0]);
                self.phases.pairs[pair].contact = Contact::Resting {
                    presses: true,
                    rising,
                };
            }
        }
    }

    /// Those of a group of pairs at rest that press; `slope` has accelerations in space without them, of the size of `terms`.
    ///
    /// A pair presses that would close without its force. Where others keep it from that, it presses if it shares their force.
    fn pressing(&self, group: &[usize], slope: &[f64], terms: &[f64]) -> Option<Vec<usize>> {
        let without = |floor: usize| slope[velocity(floor)];
        let block = |set: &mut dyn Iterator<Item = usize>| {
            Block::new(&self.model, set.map(|member| group[member]).collect())
        };
        let closing = |block: &Block, member: usize| {
            let moving = with(std::slice::from_ref(block), slope, terms);
            self.apart(group[member], &moving)
        };
        let judge = |set: &[usize]| {
            let all = block(&mut set.iter().copied());
            let forces = all.forces(identity, without);
            let sizes = all.forces(f64::abs, |floor| terms[floor]);
            let lacks = |position: usize| {
                let member = set[position];
                let others = block(&mut set.iter().copied().filter(|other| *other != member));
                let [excess, rounding] = if others.rank() < all.rank() {
                    closing(&others, member)
                } else {
                    [forces[position].1, IDLE * sizes[position].1]
                        .map(|force| force / self.model.pairs[group[member]].reduced_mass)
                };
                let lack = rounding - excess;
                if lack < 0.0 {
                    0.0
                } else {
                    lack.max(f64::MIN_POSITIVE)
                }
            };
            let closes = |member: usize| {
                let [closing, rounding] = closing(&all, member);
                closing - rounding
            };
            let mut miss = (0..group.len()).map(closes).fold(0.0, f64::max);
            if miss == 0.0 {
                miss = (0..set.len()).map(lacks).fold(0.0, f64::max);
            }
            let squares = forces.iter().map(|(_, force)| force * force).sum();
            (
                miss,
                squares,
                forces.iter().map(|(pair, _)| *pair).collect::<Vec<_>>(),
            )
        };
        best(group.len(), judge).filter(|pressing| !pressing.is_empty())
    }

    /// Rate of the force of a pair at rest \[N/s\], `slope` being the derivative of the unknowns, and what rounding leaves of it.
    fn resting_force_rate(&self, pair: usize, y: &[f64], slope: &[f64]) -> [f64; 2] {
        let force = |by: f64| {
            let near = y
                .iter()
                .zip(slope)
                .map(|(unknown, slope)| unknown + by * slope);
            let mut change = vec![0.0; y.len()];
            let near = near.collect::<Vec<_>>();
            self.slope(NOW, &near, &mut change);
            change[self.model.impulse(pair)]
        };
        let touches =
            |phase: &Contact| phase.touches() && !matches!(phase, Contact::Resting { .. });
        let bent = self
            .phases
            .pairs
            .iter()
            .any(|phase| touches(&phase.contact));
        let Probe { time, rounding } = if bent { Probe::BENT } else { Probe::STRAIGHT };
        let rate = (force(time) - force(-time)) / (2.0 * time);
        let terms = self.terms(y);
        let sizes = self
            .blocks
            .iter()
            .flat_map(|block| block.forces(f64::abs, |floor| terms[floor]));
        let size = sizes.filter(|(of, _)| *of == pair).map(|(_, size)| size);
        [rate, rounding * size.sum::<f64>()]
    }

    /// Negative once the force of a pair at rest has passed a maximum or minimum.
    pub(super) fn resting_peak(&self, pair: usize, y: &[f64], slope: &[f64]) -> f64 {
        let Contact::Resting { rising, .. } = self.phases.pairs[pair].contact else {
            return 0.0;
        };
        let [rate, rounding] = self.resting_force_rate(pair, y, slope);
        rising * rate + rounding
    }
}
