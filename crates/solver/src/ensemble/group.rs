//! As many scenes as there are lanes, at one node after the other.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::Shaken;
use super::body::Body;
use super::books::Push;
use super::column::SideBySideColumn;
use super::jump::Jumps;
use super::law::Law;
use super::number::{Lanes, MOST_LANES, Mask};
use super::scenes::{Pair, Scenes, Structure};
use super::tally::SceneSum;
use crate::impact::rounds::Touching;
use crate::{CentralDifference, Node, RestoringForce, Row};

/// Scenes of one shape under one ground motion.
///
/// Structures and pairs are slices, so that code which knows how many there are gets loops of that length.
pub(super) struct Group<'a, S: Simd, Column: SideBySideColumn> {
    pub(super) simd: S,
    pub(super) time_step: f64,
    pub(super) structures: &'a mut [Structure<S, Column>],
    /// For every structure the pair that it is the left neighbour of.
    pub(super) pairs: &'a mut [Option<Pair<S>>],
    pub(super) jumps: Jumps<S>,
    /// Whether compliant pairs that touched at the node before have their books to close.
    pub(super) busy: bool,
    /// Steps in which some lane touches.
    pub(super) touching_steps: u64,
}

/// Rows of one shape, as many as there are lanes, or fewer; lanes without one repeat the last.
#[derive(Clone, Copy)]
pub(super) struct Rows<'a, Column>(pub(super) &'a [&'a Row<Column>]);

impl<'a, Column: SideBySideColumn> Rows<'a, Column> {
    /// The row of a lane.
    pub(super) fn lane(self, lane: usize) -> &'a Row<Column> {
        self.0[lane.min(self.0.len() - 1)]
    }

    /// A structure of all rows at t = 0, with the time step and the acceleration of the ground there.
    #[inline(always)]
    pub(super) fn structure<S: Simd>(
        self,
        simd: S,
        node: usize,
        start: (f64, f64),
    ) -> Structure<S, Column> {
        let gather = |number: &dyn Fn(&Node<Column>) -> f64| self.gather(simd, node, number);
        Body::new(gather, start)
    }

    /// A number of a structure of all rows.
    #[inline(always)]
    pub(super) fn gather<S: Simd>(
        self,
        simd: S,
        node: usize,
        number: &dyn Fn(&Node<Column>) -> f64,
    ) -> Lanes<S> {
        let mut values = [0.0; MOST_LANES];
        for (lane, value) in values.iter_mut().enumerate().take(Lanes::<S>::N) {
            *value = number(&self.lane(lane).nodes()[node]);
        }
        Lanes::new(simd, &values)
    }

    /// Both structures of rows that have two.
    #[inline(always)]
    pub(super) fn two<S: Simd>(self, simd: S, start: (f64, f64)) -> [Structure<S, Column>; 2] {
        [
            self.structure(simd, 0, start),
            self.structure(simd, 1, start),
        ]
    }

    /// The pair of a structure and its right neighbour, if the rows have one.
    #[inline(always)]
    pub(super) fn pair<S: Simd>(self, simd: S, left: usize) -> Option<Pair<S>> {
        let mut pairs = self.0[0].pairs().iter();
        let index = pairs.position(|pair| pair.left == left)?;
        let pairs: [_; MOST_LANES] = std::array::from_fn(|lane| &self.lane(lane).pairs()[index]);
        let mass = |lane: usize| self.lane(lane).reduced_mass(pairs[lane]);
        Some(Pair {
            index,
            lingers: false,
            gap: Lanes::new(simd, &pairs.map(|pair| pair.gap)),
            law: Law::new(simd, pairs.map(|pair| pair.law), std::array::from_fn(mass)),
            deformation: Lanes::splat(simd, 0.0),
            tally: SceneSum::new(simd),
        })
    }
}

impl<'a, S: Simd, Column: SideBySideColumn> Group<'a, S, Column> {
    #[inline(always)]
    pub(super) fn new(
        simd: S,
        method: &Shaken<'_, CentralDifference>,
        (structures, pairs): Scenes<'a, S, Column>,
    ) -> Self {
        Self {
            simd,
            time_step: method.time_step,
            jumps: Jumps::new::<Column>(structures, pairs),
            structures,
            pairs,
            busy: false,
            touching_steps: 0,
        }
    }

    /// A step from a node with this acceleration of the ground.
    #[inline(always)]
    pub(super) fn step(&mut self, acceleration: f64) {
        let touches = self.deform();
        let ground = Lanes::splat(self.simd, acceleration);
        if touches || self.busy {
            self.contact_step(ground);
            self.touching_steps += u64::from(touches);
        } else {
            for structure in self.structures.iter_mut() {
                structure.step(ground);
            }
        }
    }

    /// Deformations at a node; true where some lane touches.
    #[inline(always)]
    fn deform(&mut self) -> bool {
        let zero = Lanes::splat(self.simd, 0.0);
        let mut touching = Mask::splat(self.simd, false);
        for left in 1..self.structures.len() {
            let neighbours = (&self.structures[left - 1], &self.structures[left]);
            if let Some(pair) = &mut self.pairs[left - 1] {
                let ahead = neighbours.0.motion.displacement - neighbours.1.motion.displacement;
                pair.deformation = ahead - pair.gap;
                touching = touching | pair.deformation.reaches(zero);
            }
        }
        Lanes::any(touching)
    }

    /// A step from a node at which some lane touches, or did at the node before.
    #[inline(always)]
    fn contact_step(&mut self, ground: Lanes<S>) {
        let (mut jumps, mut busy) = (false, false);
        for left in 1..self.structures.len() {
            let Some(pair) = &mut self.pairs[left - 1] else {
                continue;
            };
            let touches = pair.deformation.reaches(ground.like(0.0));
            if !(pair.lingers || Lanes::any(touches)) {
                continue;
            }
            let (before, after) = self.structures.split_at_mut(left);
            let neighbours = [&mut before[left - 1], &mut after[0]];
            neighbours[0].contact.is_near = true;
            neighbours[1].contact.is_near = true;
            if let Law::Impulsive(law) = pair.law {
                jumps = true;
                let touching = Touching::on_one_ground(touches, law.factor);
                self.jumps.take((pair.index, left - 1), touching);
            } else {
                push(pair, neighbours, self.time_step);
                pair.lingers = pair.tally.lingers();
                busy |= pair.lingers;
            }
        }
        self.busy = busy;
        for structure in self.structures.iter_mut() {
            if structure.contact.is_near {
                structure.step_in_contact(ground, jumps);
            } else {
                structure.step(ground);
            }
        }
        if jumps {
            let scenes = (&mut *self.structures, &mut *self.pairs);
            self.jumps.jump::<Column>(scenes, ground);
        }
    }
}

/// A structure and its right neighbour.
type Neighbours<'a, S, Column> = [&'a mut Body<S, Column>; 2];

/// Gives a compliant pair its force.
#[inline(always)]
fn push<S: Simd, Column: RestoringForce<Lanes<S>>>(
    pair: &mut Pair<S>,
    [left, right]: Neighbours<'_, S, Column>,
    time_step: f64,
) {
    let closing = left.motion.increment - right.motion.increment;
    let rate = closing / closing.like(time_step);
    let Some(force) = pair.law.force(pair.deformation, rate) else {
        return;
    };
    let overlaps = pair.deformation.exceeds(rate.like(0.0));
    let push = Push {
        force,
        impulse: force.like(0.5 * time_step) * (pair.tally.last() + force),
        rate: left.velocity_before() - right.velocity_before(),
    };
    pair.tally.follow(push, overlaps);
    left.contact.force_from_right = -force;
    right.contact.force_from_left = force;
}
