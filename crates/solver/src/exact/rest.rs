//! Decision between rest and parting for pairs that touch without a rate.

use std::ops::Range;

use crate::exact::contact::{Gap, Join, System};
use crate::exact::groups::beside;
use crate::exact::hits::Hit;
use crate::exact::member::Member;
use crate::exact::noise::clean;
use crate::exact::rounding::noise;
use crate::exact::{ExactRun, Touching};
use crate::roots::CAPACITY;
use crate::span::Power;
use crate::{Recorder, RunError};

/// Coefficients that decide between pressing and parting, from that of the acceleration on.
const DECISIVE: usize = 12;
/// Coefficients of displacements that every expansion has, in orders of time.
const FEWEST: usize = 15;

/// The power of the fourth root of time with which an acceleration closes a gap.
pub(super) const OF_ACCELERATION: usize = 8;

impl Touching<'_> {
    /// Whether a touching pair is neither at rest nor parting with a rate.
    fn may_press(&self, pair: usize) -> bool {
        let contact = &self.contacts[pair];
        contact.join == Join::Apart && contact.rate == 0.0
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Decides which of the touching pairs without a rate press against each other. These are the pairs whose free motion would overlap.
    /// The set grows pair by pair; each is decided by the first coefficient of its deformation that is not rounding.
    ///
    /// In a chain, a pair that presses only drives other pairs together, so that the order does not matter. A pair that presses on another
    /// floor may part pairs there. It does so in a later coefficient than its deciding one. Of several chains, the chain with the lowest
    /// deciding coefficient therefore goes first.
    pub(super) fn rest_or_part<'h>(&mut self, hits: &'h [Hit], time: f64) -> Result<(), RunError> {
        let chains = || {
            let of = |hit: &'h Hit| {
                let pairs = hit.pairs.iter().enumerate();
                pairs.map(move |(index, pair)| (hit, index, *pair))
            };
            hits.iter().flat_map(of)
        };
        let pairs = || chains().map(|(.., pair)| pair);
        for pair in pairs() {
            self.touching.contacts[pair].join = Join::Apart;
        }
        loop {
            self.regroup();
            self.expand_landed(time)?;
            let order = |pair: usize| match self.press(pair) {
                Some((order, true)) => Some(order),
                Some((_, false)) | None => None,
            };
            let soonest = match hits {
                [_] => Some(usize::MAX),
                _ => pairs().filter(|pair| self.touching.may_press(*pair)).filter_map(order).min(),
            };
            let mut grown = false;
            for (hit, index, pair) in chains() {
                self.agenda.guard.wait(time)?;
                let presses = || matches!(self.press(pair), Some((n, true)) if Some(n) <= soonest);
                if self.touching.may_press(pair) && presses() {
                    if self.is_held(pair) {
                        return Err(self.touching.closed_in(pair, time));
                    }
                    self.join(hit, index, time);
                    grown = true;
                }
            }
            if !grown {
                break;
            }
        }
        // Neighbours that move alike without a force stay together. This excludes neighbours that walls hold on both sides: it is open
        // which of their forces is zero, as one must be.
        for (hit, index, pair) in chains() {
            self.agenda.guard.wait(time)?;
            if self.touching.may_press(pair) && self.press(pair).is_none() && !self.is_held(pair) {
                self.join(hit, index, time);
            }
            let parts = self.touching.may_press(pair) && matches!(self.press(pair), Some((_, false)));
            self.touching.contacts[pair].gap = if parts { Gap::Parts } else { Gap::Known };
        }
        self.regroup();
        Ok(())
    }

    /// Whether both sides of a pair already rest against walls, or floors that friction holds.
    fn is_held(&self, pair: usize) -> bool {
        if self.moving.walls < 2 && self.moving.members.iter().all(|member| member.held().is_none()) {
            return false;
        }
        let [left, _] = self.touching.contacts[pair].floors();
        let rests = |node: usize| {
            let [_, pair] = beside(self.touching.incidence, node);
            pair.is_some_and(|pair| self.touching.contacts[pair].join == Join::Resting)
        };
        let mut first = left;
        while first > 0 && rests(first - 1) {
            first -= 1;
        }
        let mut last = left + 1;
        while last < self.moving.members.len() && rests(last) {
            last += 1;
        }
        let holds = |mut nodes: Range<usize>| nodes.any(|node| self.moving.members[node].is_still());
        holds(first..left + 1) && holds(left + 1..last + 1)
    }

    /// Puts a pair at rest: the lighter side takes the velocity of the heavier side, over its ground.
    fn join(&mut self, hit: &Hit, index: usize, time: f64) {
        let pair = hit.pairs[index];
        self.touching.contacts[pair].join = Join::Resting;
        if hit.rests_on(index, &self.touching.contacts[pair], &self.moving.members) {
            return;
        }
        let [left, _] = self.touching.contacts[pair].floors();
        let carried = self.opening(pair, time).map(|opening| opening.velocity);
        let [a, b] = [left, left + 1].map(|node| &self.moving.members[node]);
        let [v, w] = [a.state.velocity, b.state.velocity];
        if a.mass >= b.mass {
            self.moving.members[left + 1].state.velocity = carried.map_or(v, |carried| v + carried);
        } else {
            self.moving.members[left].state.velocity = carried.map_or(w, |carried| w - carried);
        }
    }

    /// The power of the fourth root of time in which the free motion of a pair is decided, and whether it overlaps; `None` if rounding
    /// hides it.
    fn press(&self, pair: usize) -> Option<(usize, bool)> {
        let shown = |order: usize| {
            let (closing, _) = self.closing_by(pair, order);
            // A force that has just faded leaves no closing acceleration.
            let fades = self.touching.contacts[pair].faded && order == OF_ACCELERATION && closing > 0.0;
            (closing != 0.0 && !fades).then_some((order, closing > 0.0))
        };
        self.orders(pair).find_map(shown)
    }

    /// Powers of the fourth root of time in which pairs that touch without a rate may begin to close, among the deciding ones.
    pub(super) fn orders(&self, pair: usize) -> impl Iterator<Item = usize> + use<R> {
        let p = self.power(pair);
        let mut floors = self.touching.contacts[pair].floors().into_iter();
        let last = if floors.any(|node| self.moving.members[node].is_tied()) {
            // An event on a floor reaches the next floor two orders later.
            (FEWEST * p).min(CAPACITY)
        } else if self.touching.is_chain() {
            2 * p + DECISIVE
        } else {
            // A force that begins without a rate, like t³, moves a neighbouring pair like t⁵.
            3 * p + DECISIVE
        };
        (2 * p..last).map(move |n| 4 * n / p)
    }

    /// The finer power of the bodies on both sides of a pair.
    fn power(&self, pair: usize) -> usize {
        let floors = self.touching.contacts[pair].floors();
        let [left, right] = floors.map(|node| self.power_of(node));
        left.max(right)
    }

    fn power_of(&self, node: usize) -> usize {
        self.moving.bodies[self.touching.groups.body_of[node]].power.order()
    }

    /// The coefficient of the free deformation of a pair at a power of the fourth root of time (0 if rounding hides it), and its rounding.
    pub(super) fn closing_by(&self, pair: usize, order: usize) -> (f64, f64) {
        let (contact, p) = (&self.touching.contacts[pair], self.power(pair));
        let n = order * p / 4;
        let values = contact.relation.points().map(|point| {
            // A series in t next to a series in its fourth root.
            let stretched = p / self.power_of(point.floor());
            if n.is_multiple_of(stretched) && (n * 4).is_multiple_of(p) {
                contact.displacement_of(&self.moving.members, point, p / stretched, n / stretched)
            } else {
                0.0
            }
        });
        let closing = values[0] - values[1];
        let noise = noise(&self.moving.members, contact.relation, values, p, n);
        let shown = closing.abs() > noise && closing.is_finite();
        (if shown { closing } else { 0.0 }, noise)
    }

    /// Expands the bodies that have landed. This is most of the cost when a long row comes to rest.
    pub(super) fn expand_landed(&mut self, time: f64) -> Result<(), RunError> {
        self.agenda.guard.look(time, self.agenda.spent())?;
        // With other pairs at rest, a floor that begins to slide may have an acceleration.
        self.moving.members.iter_mut().for_each(Member::hurry);
        for first in 0..self.moving.bodies.len() {
            if self.touching.groups.body_of[first] == first && self.moving.landed[first] {
                self.agenda.guard.wait(time)?;
                let (power, _) = self.expand(first, time);
                self.moving.bodies[first].power = power;
                self.clean(first, time, power);
                self.agenda.tried += self.touching.groups.nodes_of(first).len() as u64;
            }
        }
        Ok(())
    }

    /// Measures the rounding of an expanded body; clears forces at rest that are only rounding.
    pub(super) fn clean(&mut self, first: usize, time: f64, power: Power) {
        // If grounds move apart, their positions have the rounding of the whole time.
        let time = if self.shaking.travel.is_some() {
            self.agenda.clock.absolute(time)
        } else {
            time
        };
        let (members, contacts) = (&mut self.moving.members, &mut self.touching.contacts);
        let group = self.touching.groups.of(first);
        clean(group, members, contacts, self.touching.incidence, time, power.order());
    }

    /// Updates the bodies from the links.
    pub(super) fn regroup(&mut self) {
        self.touching.groups.update(System {
            members: &self.moving.members,
            contacts: &self.touching.contacts,
            incidence: self.touching.incidence,
        });
    }
}
