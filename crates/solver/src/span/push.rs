//! What pairs do to floors.

use std::ops::Range;

use crate::model::incidence::{Incidence, Incident};
use crate::{RestoringForce, Row};

/// What a pair does to a floor over a span of it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Push<'a> {
    /// Index of the pair.
    pub pair: usize,
    /// Whether the floor carries its left point, and is pushed to the left.
    pub on_left: bool,
    /// Part of the force that the floor carries \[–\], 0 < part ≤ 1.
    pub part: f64,
    /// Force of the pair at the start and at the end of the span \[N\], ≥ 0.
    pub forces: [f64; 2],
    /// Its impulse over the span \[N·s\], ≥ 0.
    pub impulse: f64,
    /// Coefficients of the force \[N\] in the variable of a [`Series`](crate::Series); empty for other paths.
    pub series: &'a [f64],
}

impl From<&Incident> for Push<'_> {
    /// One that does nothing.
    fn from(at: &Incident) -> Self {
        Self {
            pair: at.pair,
            on_left: at.on_left,
            part: at.part,
            ..Self::default()
        }
    }
}

impl Push<'_> {
    /// What the floor gets of a force of the pair \[N\], or of its impulse \[N·s\]: positive to the right.
    #[inline]
    pub fn given(&self, force: f64) -> f64 {
        let part = self.part * force;
        if self.on_left { -part } else { part }
    }

    /// Whether the pair does nothing to the floor.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.forces == [0.0, 0.0] && self.impulse == 0.0
    }
}

/// The pushes of a stepping method, slot by slot, over the spans under way.
#[derive(Debug, Clone)]
pub(crate) struct Pushes {
    all: Vec<Push<'static>>,
    /// Forces at the start of the spans before \[N\].
    earlier: Vec<f64>,
}

impl Pushes {
    /// Of a row before t = 0: nobody pushes.
    pub(crate) fn new(incidence: &Incidence) -> Self {
        Self {
            all: incidence.incidents().iter().map(Push::from).collect(),
            earlier: vec![0.0; incidence.incidents().len()],
        }
    }

    /// Of the slots of a floor.
    #[inline]
    pub(crate) fn of(&self, slots: Range<usize>) -> &[Push<'static>] {
        &self.all[slots]
    }

    #[inline]
    pub(crate) fn at(&mut self, slot: usize) -> &mut Push<'static> {
        &mut self.all[slot]
    }

    /// Forgets the forces at the end of all spans under way.
    #[inline]
    pub(crate) fn forget_ends(&mut self) {
        for push in &mut self.all {
            push.forces[1] = 0.0;
        }
    }

    /// Gives the force of a pair to its slots, at the end of the spans under way; `give` gets every floor, whether it carries the left
    /// point, and its part.
    #[inline]
    pub(crate) fn act<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        (pair, force): (usize, f64),
        mut give: impl FnMut(usize, bool, f64),
    ) {
        for slot in row.incidence().slots_of(pair) {
            self.all[*slot].forces[1] = force;
        }
        let [left, right] = row.pairs()[pair].relation.points();
        left.spread(force, |floor, force| give(floor, true, force));
        right.spread(force, |floor, force| give(floor, false, force));
    }

    /// Lets all spans begin, with no impulse so far.
    #[inline]
    pub(crate) fn begin(&mut self) {
        for push in &mut self.all {
            push.forces[0] = push.forces[1];
            push.impulse = 0.0;
        }
    }

    /// Adds the forces at the end of the spans so far to their impulses, with this weight.
    #[inline]
    pub(crate) fn add(&mut self, weight: f64) {
        for push in &mut self.all {
            push.impulse += weight * push.forces[1];
        }
    }

    /// Multiplies the sums of weighted forces by what they are to be multiplied by \[s\].
    #[inline]
    pub(crate) fn scale(&mut self, by: f64) {
        for push in &mut self.all {
            push.impulse *= by;
        }
    }

    /// Ends the spans of a floor by the trapezoidal rule: `half` a step \[s\] each force, less the impulse that is too much.
    #[inline]
    pub(crate) fn end(&mut self, slots: Range<usize>, half: f64) {
        for push in &mut self.all[slots] {
            push.impulse = half * (push.forces[0] + push.forces[1]) - push.impulse;
        }
    }

    /// Ends the spans of a floor: `scale` \[s\] times the weighted sum of the forces at their ends, the last N of those at the start of the
    /// spans before, at the start and at the end.
    #[inline]
    pub(crate) fn weigh<const N: usize>(
        &mut self,
        slots: Range<usize>,
        (scale, weights): (f64, [f64; N]),
    ) {
        let ends = self.all[slots.clone()].iter_mut();
        for (push, earlier) in ends.zip(&mut self.earlier[slots]) {
            let known = [*earlier, push.forces[0], push.forces[1]];
            let terms = weights.iter().zip(&known[3 - N..]);
            let terms = terms.map(|(weight, force)| weight * force);
            push.impulse = scale * terms.reduce(|sum, term| sum + term).unwrap_or(0.0);
            *earlier = push.forces[0];
        }
    }

    /// Whether a pair pushed at the start of the spans under way.
    #[inline]
    pub(crate) fn pushed(&self, incidence: &Incidence, pair: usize) -> bool {
        let first = incidence.slots_of(pair).first();
        first.is_some_and(|slot| self.all[*slot].forces[0] > 0.0)
    }

    /// The force of a pair at the end of the spans under way \[N\]; it acts for half a step \[s\].
    #[inline]
    pub(crate) fn ends(&mut self, incidence: &Incidence, pair: usize, half: f64) -> f64 {
        let mut force = 0.0;
        for slot in incidence.slots_of(pair) {
            let push = &mut self.all[*slot];
            force = push.forces[1];
            push.impulse = half * force;
        }
        force
    }

    /// Adds the impulses of the forces at the start of the spans of a floor, which act for half a step \[s\].
    #[inline]
    pub(crate) fn start(&mut self, slots: Range<usize>, half: f64) {
        for push in &mut self.all[slots] {
            push.impulse += half * push.forces[0];
        }
    }

    /// Lets the next spans of a floor begin; their ends are open.
    #[inline]
    pub(crate) fn go_on(&mut self, slots: Range<usize>) {
        for push in &mut self.all[slots] {
            push.forces = [push.forces[1], 0.0];
            push.impulse = 0.0;
        }
    }
}
