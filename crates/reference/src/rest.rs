//! Rest: neighbours of impulsive pairs that press against each other.
//!
//! A block of them has one acceleration in space: all forces on it over all its mass, or that of its wall. With F the forces
//! on what lies left and right of a pair and M the masses there, the pair presses with (`M_r` `F_l` − `M_l` `F_r`)/(`M_l` + `M_r`).
//! Grounds that move differently change nothing in this.
//!
//! Which pairs press is found by growing: those that would close without a force do, and make others close. What closes and
//! opens by no more than rounding is *idle*: it stays together without a force until it does more. That decides ties: between
//! an acceleration of zero and one of ten thousand roundings lies no time that a result could show.

use std::ops::Range;

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

impl Motion {
    /// Whether any pair is at rest.
    pub(super) fn rests(&self) -> bool {
        let mut pairs = self.phases.pairs.iter();
        pairs.any(|phase| matches!(phase.contact, Contact::Resting { .. }))
    }

    /// Pairs that press on each other in a row, block by block; a wall ends one and may begin another.
    pub(super) fn blocks(&self) -> impl Iterator<Item = Range<usize>> {
        let pairs = &self.model.pairs;
        let goes_on = |pair: usize| {
            let shared = pairs[pair].left;
            pairs[pair - 1].right == shared && !self.model.is_wall(shared)
        };
        let mut next = 0;
        std::iter::from_fn(move || {
            let first = (next..pairs.len()).find(|&pair| self.phases.presses(pair))?;
            let mut rest = first + 1..pairs.len();
            next = rest
                .find(|&pair| !(self.phases.presses(pair) && goes_on(pair)))
                .unwrap_or(pairs.len());
            Some(first..next)
        })
    }

    /// Floors of a block, from the left.
    pub(super) fn floors(&self, block: Range<usize>) -> impl Iterator<Item = usize> {
        let first = self.model.pairs[block.start].left;
        std::iter::once(first).chain(block.map(|pair| self.model.pairs[pair].right))
    }

    fn mass(&self, structure: usize) -> f64 {
        1.0 / self.model.structures[structure].inverse_mass
    }

    /// What pushes a pair of a block together, less what pulls it apart, as two terms \[N\].
    ///
    /// `acceleration` is that of every floor without the block \[m/s²\].
    fn squeeze(
        &self,
        block: &Range<usize>,
        pair: usize,
        acceleration: impl Fn(usize) -> f64,
    ) -> [f64; 2] {
        let pairs = &self.model.pairs;
        let sum = |floors: &mut dyn Iterator<Item = usize>| {
            floors.fold([0.0; 2], |[force, mass], floor| {
                let own = self.mass(floor);
                [force + own * acceleration(floor), mass + own]
            })
        };
        let of_left = sum(&mut (block.start..=pair).map(|index| pairs[index].left));
        let of_right = sum(&mut (pair..block.end).rev().map(|index| pairs[index].right));
        let (first, last) = (pairs[block.start].left, pairs[block.end - 1].right);
        if self.model.is_wall(last) {
            [of_left[0], of_left[1] * acceleration(last)]
        } else if self.model.is_wall(first) {
            [of_right[1] * acceleration(first), of_right[0]]
        } else {
            let mass = of_left[1] + of_right[1];
            [
                of_right[1] / mass * of_left[0],
                of_left[1] / mass * of_right[0],
            ]
        }
    }

    /// Acceleration of a block \[m/s²\], of those of its floors without it.
    fn common(&self, block: &Range<usize>, acceleration: impl Fn(usize) -> f64) -> f64 {
        let mut sums = [0.0; 2];
        for floor in self.floors(block.clone()) {
            if self.model.is_wall(floor) {
                return acceleration(floor);
            }
            sums[0] += self.mass(floor) * acceleration(floor);
            sums[1] += self.mass(floor);
        }
        sums[0] / sums[1]
    }

    /// Gives floors at rest the accelerations of their blocks and the pairs their forces; `slope` has accelerations in space.
    pub(super) fn lean(&self, slope: &mut [f64]) {
        for block in self.blocks() {
            for pair in block.clone() {
                let [together, apart] = self.squeeze(&block, pair, |floor| slope[velocity(floor)]);
                slope[self.model.impulse(pair)] = together - apart;
            }
            let common = self.common(&block, |floor| slope[velocity(floor)]);
            for floor in self.floors(block) {
                slope[velocity(floor)] = common;
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
            forces[pair.left] += force;
            forces[pair.right] += force;
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

    /// How much the ground of the left neighbour of a pair accelerates beyond that of the right one \[m/s²\].
    fn carried(&self, pair: usize, y: &[f64]) -> f64 {
        let neighbours = self.model.pairs[pair];
        let ground = |floor: usize| self.segment.ground(floor, y[TIME]);
        ground(neighbours.left) - ground(neighbours.right)
    }

    /// Acceleration with which a pair closes, or would if it were not at rest \[m/s²\]; `slope` is the derivative of the
    /// unknowns.
    pub(super) fn closing(&self, pair: usize, y: &[f64], slope: &[f64]) -> f64 {
        let neighbours = self.model.pairs[pair];
        let ahead = slope[velocity(neighbours.left)] - slope[velocity(neighbours.right)];
        ahead + self.carried(pair, y)
    }

    /// What rounding leaves of it.
    fn rounding(&self, pair: usize, y: &[f64], terms: &[f64]) -> f64 {
        let neighbours = self.model.pairs[pair];
        IDLE * (terms[neighbours.left] + terms[neighbours.right] + self.carried(pair, y).abs())
    }

    /// The same magnitudes, those of floors in blocks being their blocks'.
    fn terms_of_blocks(&self, y: &[f64]) -> Vec<f64> {
        let alone = self.terms(y);
        let mut terms = alone.clone();
        for block in self.blocks() {
            let common = self.common(&block, |floor| alone[floor]);
            for floor in self.floors(block) {
                terms[floor] = common;
            }
        }
        terms
    }

    /// Negative once an idle pair closes or opens by more than rounding.
    pub(super) fn idles(&self, pair: usize, y: &[f64], scratch: &mut [f64]) -> f64 {
        self.slope(NOW, y, scratch);
        self.rounding(pair, y, &self.terms_of_blocks(y)) - self.closing(pair, y, scratch).abs()
    }

    /// Decides which pairs at rest press, which part, and which are idle.
    ///
    /// `scratch` is the derivative of the unknowns afterwards.
    pub(super) fn decide(&mut self, y: &[f64], scratch: &mut [f64]) {
        let rests =
            |&pair: &usize| matches!(self.phases.pairs[pair].contact, Contact::Resting { .. });
        let resting: Vec<usize> = (0..self.model.pairs.len()).filter(rests).collect();
        for &pair in &resting {
            self.phases.pairs[pair].contact = Contact::IDLE;
        }
        let mut idle = resting.clone();
        loop {
            self.slope(NOW, y, scratch);
            let terms = self.terms_of_blocks(y);
            let excess = |pair: usize, direction: f64| {
                direction * self.closing(pair, y, scratch) > self.rounding(pair, y, &terms)
            };
            let (pressed, left): (Vec<_>, Vec<_>) =
                idle.iter().partition(|&&pair| excess(pair, 1.0));
            idle = left;
            if pressed.is_empty() {
                idle.retain(|&pair| excess(pair, -1.0));
                break;
            }
            for pair in pressed {
                self.phases.pairs[pair].contact = Contact::Resting {
                    presses: true,
                    rising: 1.0,
                };
            }
        }
        for &pair in &idle {
            self.phases.pairs[pair].contact = Contact::Apart;
            self.phases.pairs[pair].direction = -1.0;
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
        let block = self.blocks().find(|block| block.contains(&pair));
        let sizes = block.map_or([0.0; 2], |block| {
            self.squeeze(&block, pair, |floor| terms[floor])
        });
        [rate, rounding * (sizes[0] + sizes[1])]
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
