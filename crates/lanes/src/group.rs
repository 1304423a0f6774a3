//! A group of as many scenes as there are lanes, advanced node by node.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::body::Body;
use super::books::Push;
use super::closings::Closings;
use super::column::SideBySideColumn;
use super::frame::Frame;
use super::law::Law;
use super::number::{Lanes, Mask};
use super::rows::Rows;
use super::scenes::{LanePair, Structure};
use super::{PairSums, SceneSums, Shaken};
use pounding_solver::RestoringForce;
use pounding_solver::formulas::{Rounds, Touching};

/// Scenes of a common shape.
pub(super) struct Group<S: Simd, Column: SideBySideColumn, F: Frame<S, Column>> {
    pub(super) simd: S,
    time_step: f64,
    pub(super) structures: Vec<Structure<S, Column>>,
    /// For every node, the pair with its structure as left neighbour.
    pub(super) pairs: Vec<Option<LanePair<S>>>,
    frame: F,
    rounds: Rounds<Lanes<S>>,
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
            frame: F::of(simd, rows, method.time_step),
            rounds: Rounds::new(Vec::new(), rows.lane(0).pairs().len()),
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
        for left in 0..n {
            pairs.push(rows.pair(self.simd, left));
        }
        let mobility = |node: usize| {
            let constants = &structures[frame.place(node)].constants;
            constants.coefficients.inverse_mass
        };
        self.rounds.renew((0..n).map(mobility));
        let closings = || Closings::new(self.simd, self.time_step, pairs, |node| frame.place(node));
        self.closings = with_closings.then(closings);
        (self.busy, self.touching_steps) = (false, 0);
    }

    /// Begins a run on a ground with this acceleration at t = 0 \[m/s²\].
    #[inline(always)]
    pub(super) fn begin(&mut self, ground: Lanes<S>) {
        self.frame.begin(&mut self.structures, ground);
    }

    /// A step from a node under this ground acceleration \[m/s²\].
    #[inline(always)]
    pub(super) fn step(&mut self, ground: Lanes<S>) {
        let touches = self.deform();
        if let Some(closings) = &mut self.closings {
            closings.look(&self.structures);
        }
        if touches || self.busy {
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
        for pair in self.pairs.iter().flatten() {
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
        for left in 1..self.structures.len() {
            if let Some(pair) = &mut self.pairs[left - 1] {
                let displacement = |node| self.structures[self.frame.place(node)].motion.displacement;
                let ahead = displacement(left - 1) - displacement(left);
                pair.deformation = ahead - pair.gap;
                touching = touching | pair.deformation.reaches(zero);
            }
        }
        Lanes::any(touching)
    }

    /// A step from a node at which some lane touches, or touched at the node before.
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
            let places = [left - 1, left].map(|node| self.frame.place(node));
            let neighbours = self.structures.get_disjoint_mut(places);
            let neighbours = neighbours.expect("floors of a row lie at places of their own");
            neighbours[0].contact.is_near = true;
            neighbours[1].contact.is_near = true;
            if let Law::Impulsive(law) = pair.law {
                jumps = true;
                let touching = Touching::on_one_ground(touches, law.factor);
                self.rounds.push(pair.index, left - 1, touching);
            } else {
                push(pair, neighbours, self.time_step);
                pair.lingers = pair.tally.lingers();
                busy |= pair.lingers;
            }
        }
        self.busy = busy;
        self.frame.step_in_contact(&mut self.structures, ground, jumps);
        self.arrive();
        if jumps {
            let closings = self.closings.as_mut();
            let (structures, pairs) = (&mut self.structures, &mut self.pairs);
            jump(&mut self.rounds, &mut self.frame, structures, pairs, ground, closings);
        }
    }
}

/// A structure and its right neighbour.
type Neighbours<'a, S, Column> = [&'a mut Body<S, Column>; 2];

/// Gives a compliant pair its force.
#[inline(always)]
fn push<S: Simd, Column: RestoringForce<Lanes<S>>>(pair: &mut LanePair<S>, [left, right]: Neighbours<'_, S, Column>, time_step: f64) {
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

/// Applies velocity jumps at a node to impulsive pairs that touch and approach. Structures that jump are restarted, and closings are
/// updated.
#[inline(always)]
fn jump<S: Simd, Column: SideBySideColumn>(
    rounds: &mut Rounds<Lanes<S>>,
    frame: &mut impl Frame<S, Column>,
    structures: &mut [Structure<S, Column>],
    pairs: &mut [Option<LanePair<S>>],
    ground: Lanes<S>,
    closings: Option<&mut Closings<S>>,
) {
    if strike_all(rounds, frame, structures, pairs) {
        frame.restart(structures, rounds.links(), ground);
        if let Some(closings) = closings {
            for link in rounds.links() {
                for place in [link.left, link.right].map(|node| frame.place(node)) {
                    closings.jump(place, structures[place].contact.at_node.jumped);
                }
            }
        }
    }
    rounds.clear();
}

/// Strikes all pairs that touch; false if none approaches.
#[inline(always)]
fn strike_all<S: Simd, Column: SideBySideColumn>(
    rounds: &mut Rounds<Lanes<S>>,
    frame: &impl Frame<S, Column>,
    structures: &mut [Structure<S, Column>],
    pairs: &mut [Option<LanePair<S>>],
) -> bool {
    let strikes = rounds.strike_all(|node| structures[frame.place(node)].contact.at_node.velocity);
    if strikes {
        for (link, impulse) in rounds.struck() {
            if let Some(pair) = &mut pairs[link.left] {
                pair.tally.strike(impulse);
            }
            for node in [link.left, link.right] {
                structures[frame.place(node)].contact.at_node.jumped = rounds.velocity(node);
            }
        }
    }
    strikes
}
