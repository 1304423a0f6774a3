//! Forces and impulses of pairs on floors in the steps of a method.

use std::ops::Range;

use pounding_contact::{ContactForce, Overlap};

use crate::model::approach::Approaches;
use crate::model::ground::Ground;
use crate::model::incidence::{Incidence, Incident};
use crate::span::Weights;
use crate::{Push, RestoringForce, Row, State};

impl From<&Incident> for Push<'_> {
    /// A push without effect.
    fn from(at: &Incident) -> Self {
        Self {
            pair: at.pair,
            on_left: at.on_left,
            part: at.part,
            ..Self::default()
        }
    }
}

/// The pushes of a stepping method, slot by slot, over the present spans.
#[derive(Debug, Clone)]
pub(crate) struct Pushes {
    all: Vec<Push<'static>>,
    /// Forces at the start of the previous spans \[N\].
    earlier: Vec<f64>,
    /// Steps until everything is zero again, as long as no pair pushes.
    alive: u32,
}

/// Steps after which nothing is left of a push: it stands at the end of a span, at its start, and at the start of the span before.
const REMEMBERED: u32 = 4;

impl Pushes {
    /// Pushes of a row before t = 0: all are zero.
    pub(crate) fn new(incidence: &Incidence) -> Self {
        Self {
            all: incidence.incidents().iter().map(Push::from).collect(),
            earlier: vec![0.0; incidence.incidents().len()],
            alive: 0,
        }
    }

    /// Lets a step begin.
    #[inline]
    pub(crate) fn pass(&mut self) {
        self.alive = self.alive.saturating_sub(1);
    }

    /// Whether all forces and impulses are zero, and remain so unless a pair pushes.
    #[inline]
    pub(crate) fn are_idle(&self) -> bool {
        self.alive == 0
    }

    /// The pushes of some slots; none where all are idle.
    #[inline]
    fn live(&mut self, slots: Range<usize>) -> &mut [Push<'static>] {
        if self.are_idle() { &mut [] } else { &mut self.all[slots] }
    }

    /// The pushes in the slots of a floor.
    #[inline]
    pub(crate) fn of(&self, slots: Range<usize>) -> &[Push<'static>] {
        &self.all[slots]
    }

    #[inline]
    pub(crate) fn at(&mut self, slot: usize) -> &mut Push<'static> {
        &mut self.all[slot]
    }

    /// Clears the forces at the end of all present spans.
    #[inline]
    pub(crate) fn forget_ends(&mut self) {
        for push in self.live(0..self.all.len()) {
            push.forces[1] = 0.0;
        }
    }

    /// The force of a pair at the end of the spans under way.
    #[inline]
    pub(crate) fn set(&mut self, incidence: &Incidence, pair: usize, force: f64) {
        if force != 0.0 {
            self.alive = REMEMBERED;
        } else if self.are_idle() {
            return;
        }
        for slot in incidence.slots_of(pair) {
            self.all[*slot].forces[1] = force;
        }
    }

    /// Gives the force of a pair to its slots, at the end of the present spans. `give` receives every floor, whether it carries the left
    /// point, and its part.
    #[inline]
    pub(crate) fn act<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        pair: usize,
        force: f64,
        mut give: impl FnMut(usize, bool, f64),
    ) {
        self.set(row.incidence(), pair, force);
        let [left, right] = row.pairs()[pair].relation.points();
        left.spread(force, |floor, force| give(floor, true, force));
        right.spread(force, |floor, force| give(floor, false, force));
    }

    /// Begins all spans, with zero impulse.
    #[inline]
    pub(crate) fn begin(&mut self) {
        for push in self.live(0..self.all.len()) {
            push.forces[0] = push.forces[1];
            push.impulse = 0.0;
        }
    }

    /// Adds the forces at the end of the spans so far to their impulses, with this weight.
    #[inline]
    pub(crate) fn add(&mut self, weight: f64) {
        for push in self.live(0..self.all.len()) {
            push.impulse += weight * push.forces[1];
        }
    }

    /// Multiplies the sums of weighted forces by a factor \[s\].
    #[inline]
    pub(crate) fn scale(&mut self, by: f64) {
        for push in self.live(0..self.all.len()) {
            push.impulse *= by;
        }
    }

    /// Ends the spans of a floor by the trapezoidal rule: each force for `half` a step \[s\], minus the excess impulse.
    #[inline]
    pub(crate) fn end(&mut self, slots: Range<usize>, half: f64) {
        for push in self.live(slots) {
            push.impulse = half * (push.forces[0] + push.forces[1]) - push.impulse;
        }
    }

    /// Ends the spans of a floor, with the weights of the forces at their ends. The last N are those at the start of the previous spans, at
    /// the start and at the end.
    #[inline]
    pub(crate) fn weigh<const N: usize>(&mut self, slots: Range<usize>, weights: Weights<N>) {
        if self.are_idle() {
            return;
        }
        let ends = self.all[slots.clone()].iter_mut();
        for (push, earlier) in ends.zip(&mut self.earlier[slots]) {
            let known = [*earlier, push.forces[0], push.forces[1]];
            let terms = weights.of_loads.iter().zip(&known[3 - N..]);
            let terms = terms.map(|(weight, force)| weight * force);
            push.impulse = weights.scale * terms.reduce(|sum, term| sum + term).unwrap_or(0.0);
            *earlier = push.forces[0];
        }
    }

    /// Whether a pair pushed at the start of the present spans.
    #[inline]
    pub(crate) fn pushed(&self, incidence: &Incidence, pair: usize) -> bool {
        let first = incidence.slots_of(pair).first();
        first.is_some_and(|slot| self.all[*slot].forces[0] > 0.0)
    }

    /// The force of a pair at the end of the present spans \[N\]; it acts for half a step \[s\].
    #[inline]
    pub(crate) fn ends(&mut self, incidence: &Incidence, pair: usize, half: f64) -> f64 {
        if self.are_idle() {
            return 0.0;
        }
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
        for push in self.live(slots) {
            push.impulse += half * push.forces[0];
        }
    }

    /// Begins the next spans of a floor; their ends are open.
    #[inline]
    pub(crate) fn go_on(&mut self, slots: Range<usize>) {
        for push in self.live(slots) {
            push.forces = [push.forces[1], 0.0];
            push.impulse = 0.0;
        }
    }
}

impl<Column: RestoringForce> Row<Column> {
    /// Computes the pounding forces \[N\] of compliant pairs from the displacements and velocities of the states.
    pub(crate) fn push(&self, states: &mut [State], pushes: &mut Pushes, approaches: &mut Approaches, ground: Ground<'_>) {
        pushes.forget_ends();
        for state in states.iter_mut() {
            (state.force_from_left, state.force_from_right) = (0.0, 0.0);
        }
        for (index, pair) in self.pairs().iter().enumerate() {
            let deformation = ground.deformation_of(pair, states);
            // Impulsive contact acts between steps.
            if deformation > 0.0 && pair.law.is_compliant() {
                let rate = ground.rate_of(pair, states);
                let overlap = Overlap {
                    deformation,
                    rate,
                    reduced_mass: self.reduced_mass(pair),
                    approach_speed: approaches.of(index, rate),
                };
                if let Some(ContactForce { force, .. }) = pair.law.respond(&overlap) {
                    pushes.act(self, index, force, |floor, on_left, force| {
                        let state = &mut states[floor];
                        if on_left {
                            state.force_from_right -= force;
                        } else {
                            state.force_from_left += force;
                        }
                    });
                }
            }
        }
    }
}
