//! A group of as many scenes as there are lanes, advanced node by node.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::books::Push;
use super::closings::Closings;
use super::column::SideBySideColumn;
use super::frame::Frame;
use super::law::Law;
use super::links::{self, LaneLink};
use super::number::{Lanes, Mask};
use super::rows::Rows;
use super::scenes::{LanePair, Structure};
use super::strikes::Strikes;
use super::{PairSums, SceneSums, Shaken};
use pounding_solver::formulas::{Rounds, Touching};

/// Scenes of a common shape.
pub(super) struct Group<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>> {
    pub(super) simd: S,
    time_step: f64,
    pub(super) structures: Vec<Structure<S, Column>>,
    /// In the order of the rows.
    pub(super) pairs: Vec<LanePair<S>>,
    /// In the order of the rows.
    links: Vec<LaneLink<S>>,
    frame: F,
    rounds: Rounds<Lanes<S>>,
    /// The scene of each lane if pairs form no chain, and the impulsive pairs that touch at this node.
    strikes: Vec<Strikes>,
    touching: Vec<(usize, Mask<S>)>,
    /// `None` if closings are not requested.
    closings: Option<Closings<S>>,
    /// Whether compliant pairs that touched at the node before must close their books.
    busy: bool,
    /// Steps in which some lane touches.
    pub(super) touching_steps: u64,
}

impl<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>> Group<S, Column, F> {
    /// The scenes of some rows.
    #[inline(always)]
    pub(super) fn new(simd: S, method: &Shaken, rows: Rows<'_, Column>) -> Self {
        let mut group = Self {
            simd,
            time_step: method.time_step,
            structures: Vec::new(),
            pairs: Vec::new(),
            links: Vec::new(),
            frame: F::of(simd, rows, method.time_step),
            rounds: Rounds::new(Vec::new(), 0),
            strikes: Vec::new(),
            touching: Vec::with_capacity(rows.lane(0).pairs().len()),
            closings: None,
            busy: false,
            touching_steps: 0,
        };
        group.gather(rows, method.closings);
        group
    }

    /// Replaces the scenes by those of other rows of this shape.
    #[inline(always)]
    pub(super) fn renew(&mut self, rows: Rows<'_, Column>) {
        self.frame = F::of(self.simd, rows, self.time_step);
        self.gather(rows, self.closings.is_some());
    }

    #[inline(always)]
    fn gather(&mut self, rows: Rows<'_, Column>, with_closings: bool) {
        let (frame, structures, pairs) = (&self.frame, &mut self.structures, &mut self.pairs);
        structures.clear();
        pairs.clear();
        let n = rows.lane(0).nodes().len();
        for place in 0..n {
            structures.push(rows.structure(self.simd, frame.node(place), self.time_step));
        }
        for index in 0..rows.lane(0).pairs().len() {
            pairs.push(rows.pair(self.simd, index, |node| frame.place(node)));
        }
        let link = |index| LaneLink::new(self.simd, rows, index, |node| frame.place(node));
        self.links = (0..rows.lane(0).links().len()).map(link).collect();
        let mobility = |node: usize| {
            let constants = &structures[frame.place(node)].constants;
            constants.coefficients.inverse_mass
        };
        self.rounds = Rounds::new((0..n).map(mobility).collect(), pairs.len());
        self.strikes = Strikes::of::<S, Column>(rows);
        let closings = || Closings::new(self.simd, self.time_step, n, pairs, |node| frame.place(node));
        self.closings = with_closings.then(closings);
        (self.busy, self.touching_steps) = (false, 0);
    }

    /// Begins a run on a ground with this acceleration at t = 0 \[m/s²\].
    #[inline(always)]
    pub(super) fn begin(&mut self, ground: Lanes<S>) {
        links::begin(&mut self.links, &mut self.structures);
        self.frame.begin(&mut self.structures, ground);
    }

    /// A step from a node under this ground acceleration \[m/s²\].
    #[inline(always)]
    pub(super) fn step(&mut self, ground: Lanes<S>) {
        let touches = self.deform();
        if let Some(closings) = &mut self.closings {
            closings.look(&self.structures);
        }
        let is_linked = !self.links.is_empty();
        if is_linked {
            links::pull_at_node(&mut self.links, &mut self.structures, self.time_step);
        }
        if touches || self.busy || is_linked {
            self.contact_step(ground);
            self.touching_steps += u64::from(touches);
        } else {
            self.frame.step(&mut self.structures, ground);
            self.arrive();
        }
    }

    /// Updates closings at a node, after the step from it and before velocities jump there.
    #[inline(always)]
    fn arrive(&mut self) {
        if let Some(closings) = &mut self.closings {
            closings.arrive(&self.structures);
        }
    }

    /// Reports the results of a lane as those of a scene.
    #[inline(always)]
    pub(super) fn tell(&self, lane: usize, scene: usize, tallies: &mut SceneSums) {
        for node in 0..self.structures.len() {
            let place = self.frame.place(node);
            let peaks = [
                self.structures[place].motion.peak(lane),
                self.frame.peak_drift(&self.structures, place, lane),
            ];
            tallies.take_floor(scene, node, peaks);
        }
        for pair in &self.pairs {
            let closings = self.closings.as_ref();
            let sums = PairSums {
                closing: closings.and_then(|closings| closings.of(pair.index, lane)),
                ..pair.tally.lane(lane)
            };
            tallies.take_pair(scene, pair.index, sums);
            if pair.tally.books.is_doubtful(lane) {
                tallies.doubt(scene);
            }
        }
    }

    /// Computes deformations at a node; true if some lane touches.
    #[inline(always)]
    fn deform(&mut self) -> bool {
        let zero = Lanes::splat(self.simd, 0.0);
        let mut touching = Mask::splat(self.simd, false);
        let structures = &self.structures;
        for pair in &mut self.pairs {
            let ahead = pair.relation.ahead(|place| structures[place].motion.displacement);
            pair.deformation = ahead - pair.gap;
            touching = touching | pair.deformation.reaches(zero);
        }
        Lanes::any(touching)
    }

    /// A step from a node at which some lane touches, or touched at the node before.
    #[inline(always)]
    fn contact_step(&mut self, ground: Lanes<S>) {
        let zero = ground.like(0.0);
        let (mut jumps, mut busy) = (false, false);
        for pair in &mut self.pairs {
            let touches = pair.deformation.reaches(zero);
            if !(pair.lingers || Lanes::any(touches)) {
                continue;
            }
            pair.relation.each_place(|place| self.structures[place].contact.come_near());
            if let Law::Impulsive(law) = pair.law {
                jumps = true;
                if self.strikes.is_empty() {
                    let touching = Touching::on_one_ground(touches, law.factor);
                    self.rounds.push(pair.index, pair.left, touching);
                } else {
                    self.touching.push((pair.index, touches));
                }
            } else {
                push::<S, Column>(pair, &mut self.structures, self.time_step);
                pair.lingers = pair.tally.lingers();
                busy |= pair.lingers;
            }
        }
        self.busy = busy;
        self.frame.step_in_contact(&mut self.structures, ground, jumps);
        self.arrive();
        if jumps {
            self.jump(ground);
        }
    }

    /// Applies velocity jumps at a node to impulsive pairs that touch and approach. Structures that jump are restarted, and closings are
    /// updated.
    #[inline(always)]
    fn jump(&mut self, ground: Lanes<S>) {
        let strikes = if self.strikes.is_empty() {
            self.strike_chain()
        } else {
            self.strike_each()
        };
        if strikes {
            links::jump(&mut self.links, &mut self.structures);
            self.frame.restart(&mut self.structures, ground);
            if let Some(closings) = &mut self.closings {
                for (place, structure) in self.structures.iter().enumerate() {
                    closings.jump(place, structure.contact.at_node.jumped);
                }
            }
        }
        self.rounds.clear();
        self.touching.clear();
    }

    /// Strikes the pairs of a chain that touch; false if none approaches.
    #[inline(always)]
    fn strike_chain(&mut self) -> bool {
        let (rounds, frame, structures) = (&mut self.rounds, &self.frame, &mut self.structures);
        let strikes = rounds.strike_all(|node| structures[frame.place(node)].contact.at_node.velocity);
        if strikes {
            for (link, impulse) in rounds.struck() {
                self.pairs[link.pair].tally.strike(impulse);
                for node in [link.left, link.right] {
                    structures[frame.place(node)].contact.at_node.jumped = rounds.velocity(node);
                }
            }
        }
        strikes
    }

    /// Strikes other pairs that touch, lane by lane; false if none approaches.
    #[inline(always)]
    fn strike_each(&mut self) -> bool {
        let mut any = false;
        for (lane, scene) in self.strikes.iter_mut().enumerate() {
            for (node, velocity) in scene.velocities.iter_mut().enumerate() {
                *velocity = self.structures[self.frame.place(node)].contact.at_node.velocity.lane(lane);
            }
            let Some(struck) = scene.strike_all(lane, &self.touching) else {
                continue;
            };
            any = true;
            for (pair, impulse) in struck {
                let mut impulses = Lanes::splat(self.simd, 0.0);
                impulses.set(lane, impulse);
                self.pairs[pair].tally.strike(impulses);
            }
            for (node, velocity) in scene.velocities.iter().enumerate() {
                let at_node = &mut self.structures[self.frame.place(node)].contact.at_node;
                at_node.jumped.set(lane, *velocity);
            }
        }
        any
    }
}

/// Gives a compliant pair its force.
#[inline(always)]
fn push<S: Simd, Column: SideBySideColumn>(pair: &mut LanePair<S>, structures: &mut [Structure<S, Column>], time_step: f64) {
    let closing = pair.relation.ahead(|place| structures[place].motion.increment);
    let rate = closing / closing.like(time_step);
    let Some(force) = pair.law.force(pair.deformation, rate) else {
        return;
    };
    let overlaps = pair.deformation.exceeds(rate.like(0.0));
    let push = Push {
        force,
        impulse: force.like(0.5 * time_step) * (pair.tally.last() + force),
        rate: pair.relation.ahead(|place| structures[place].velocity_before()),
    };
    pair.tally.follow(push, overlaps);
    pair.relation.spread(force, |place, on_left, force| {
        let contact = &mut structures[place].contact;
        if on_left {
            contact.force_from_right = contact.force_from_right - force;
        } else {
            contact.force_from_left = contact.force_from_left + force;
        }
    });
}
