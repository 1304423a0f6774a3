//! What happens to pairs that touch at one instant: impacts, rest, or parting.

use std::ops::Range;

use crate::exact::contact::{Gap, Link};
use crate::exact::hits::Hit;
use crate::exact::noise::clean;
use crate::exact::rounding::noise;
use crate::exact::storey::rate_of_drift;
use crate::exact::{CHATTER, Run, bounces_are_over};
use crate::roots::CAPACITY;
use crate::span::Power;
use crate::{Impact, Recorder, RunError, Struck, Velocities};

/// Impacts of a pair without coming to rest after which a run gives up: with e = 1 neighbours that press bounce for ever.
///
/// With e = 0.999 a bounce of 0.1 m/s is over after 25 000.
const MOST_BOUNCES: u32 = 100_000;
/// Coefficients that decide whether a pair presses or parts, from that of the acceleration on.
const DECISIVE: usize = 12;
/// Coefficients of displacements that every expansion finds, in orders of time.
const FEWEST: usize = 15;

impl<R: Recorder> Run<'_, R> {
    /// Resolves every chain of pairs that touch now.
    pub(super) fn resolve(&mut self, time: f64) -> Result<(), RunError> {
        self.settled.fill(false);
        // Compliant pairs first: whether others come to rest depends on their forces, on whichever side of them they are.
        for pair in 0..self.contacts.len() {
            if self.contacts[pair].restitution().is_none() && self.touches_now(pair, time) {
                let contact = &mut self.contacts[pair];
                contact.gap = Gap::Known;
                // A graze within rounding is none.
                if contact.rate >= 0.0 {
                    contact.begin();
                }
            }
        }
        for pair in 0..self.contacts.len() {
            if !self.settled[pair] && self.hits(pair, time) {
                let hits = self.hits_with(pair, time)?;
                self.collide(hits, time)?;
            }
        }
        self.regroup();
        Ok(())
    }

    /// Whether a pair has landed with its gap closed, in need of a decision.
    pub(super) fn touches_now(&self, pair: usize, time: f64) -> bool {
        let (contact, left) = (&self.contacts[pair], self.lefts[pair]);
        let landed = self.landed[left] && self.landed[left + 1];
        let closed = contact.time >= time && contact.deformation == 0.0;
        let open = match contact.link {
            Link::Apart => true,
            Link::Resting => contact.restitution().is_some(),
            Link::Touching(_) => false,
        };
        // A compliant pair that is just closed touches only where its deformation grows.
        landed && closed && open && (contact.restitution().is_some() || contact.gap == Gap::Touches)
    }

    /// Impacts of chains of touching pairs, then rest or parting.
    fn collide(&mut self, mut hits: Vec<Hit>, time: f64) -> Result<(), RunError> {
        let closed_in = |hit: &Hit| hit.closed_in(&self.members);
        if let Some(pair) = hits.iter().find_map(closed_in) {
            return Err(self.closed_in(pair, time));
        }
        loop {
            for hit in &mut hits {
                self.give_impulses(hit, time)?;
            }
            self.unload(&hits);
            self.rest_or_part(&hits, time)?;
            let mut grown = false;
            for hit in &mut hits {
                for pair in hit.first..=hit.last {
                    let index = pair - hit.first;
                    if !hit.plastic[index] && self.chatters(pair, hit.rates[index]) {
                        hit.plastic[index] = true;
                        grown = true;
                    }
                }
            }
            if !grown {
                break;
            }
        }
        for hit in &hits {
            self.push_neighbours(hit);
            for pair in hit.first..=hit.last {
                self.guard.wait(time)?;
                self.settled[pair] = true;
                let impulse = hit.impulses[pair - hit.first];
                if impulse > 0.0 {
                    self.report_impact(pair, time, hit);
                }
                self.count_bounce(pair, impulse > 0.0, time)?;
            }
        }
        Ok(())
    }

    /// Gives up a pair that bounces without coming to rest.
    fn count_bounce(&mut self, pair: usize, hit: bool, time: f64) -> Result<(), RunError> {
        let (contact, left) = (&mut self.contacts[pair], self.lefts[pair]);
        if contact.link == Link::Resting {
            contact.bounces = 0;
        } else if hit {
            contact.bounces += 1;
        }
        if contact.bounces <= MOST_BOUNCES {
            return Ok(());
        }
        Err(RunError::BouncesWithoutEnd {
            left,
            right: left + 1,
            time,
            impacts: contact.bounces,
            restitution: contact.restitution().unwrap_or(0.0),
        })
    }

    /// The jumps at both ends of a chain change the rates of the pairs beyond.
    fn push_neighbours(&mut self, hit: &Hit) {
        let (start, end) = (hit.left, hit.left + hit.before.len() - 1);
        let jump = |node: usize| self.members[node].state.velocity - hit.before[node - start];
        let (at_start, at_end) = (jump(start), jump(end));
        if let Some(pair) = start
            .checked_sub(1)
            .and_then(|left| self.pair_right_of[left])
        {
            self.contacts[pair].push(-at_start);
        }
        if let Some(pair) = self.pair_right_of[end] {
            self.contacts[pair].push(at_end);
        }
    }

    /// Velocities and rates after the impacts of a chain.
    fn give_impulses(&mut self, hit: &mut Hit, time: f64) -> Result<(), RunError> {
        let guard = &self.guard;
        let chain = &mut self.chain;
        chain.clear();
        chain.velocities.extend_from_slice(&hit.before);
        for (velocity, carried) in chain.velocities.iter_mut().zip(&hit.carried) {
            *velocity += carried;
        }
        chain.rates.extend_from_slice(&hit.rates);
        let contacts = &mut self.contacts[hit.first..=hit.last];
        let members = &mut self.members[hit.left..hit.left + hit.before.len()];
        chain
            .masses
            .extend(members.iter().map(|member| member.mass));
        for (contact, plastic) in contacts.iter().zip(&hit.plastic) {
            let restitution = if *plastic {
                0.0
            } else {
                contact.restitution().unwrap_or(0.0)
            };
            chain.restitutions.push(restitution);
        }
        let passes_on = hit.rates.iter().zip(&hit.parts);
        let passes_on = passes_on.map(|(rate, parts)| *rate >= 0.0 && !(*rate > 0.0 || *parts));
        chain.passes_on.extend(passes_on);
        let look = || guard.wait(time);
        chain.collide(self.settings.simultaneous_impacts, &look)?;
        for (member, velocity) in members.iter_mut().zip(&chain.velocities) {
            member.state.velocity = *velocity;
        }
        for (index, (member, carried)) in members.iter_mut().zip(&hit.carried).enumerate() {
            // What was not hit keeps its velocity to the last bit.
            let before = hit.before[index];
            let hit = member.state.velocity.total_cmp(&(before + carried)).is_ne();
            member.state.velocity = if hit {
                member.state.velocity - carried
            } else {
                before
            };
        }
        for (contact, rate) in contacts.iter_mut().zip(&chain.rates) {
            contact.rate = *rate;
        }
        hit.impulses.copy_from_slice(&chain.impulses);
        Ok(())
    }

    /// Columns below and above floors that were hit yield no longer where their drift has turned.
    fn unload(&mut self, hits: &[Hit]) {
        for hit in hits {
            for (node, before) in (hit.left..).zip(&hit.before) {
                let jumped = (self.members[node].state.velocity - before).abs() > 0.0;
                for storey in self.storeys_at(node) {
                    if let (true, Some(drift)) = (jumped, &mut self.members[storey].storey) {
                        drift.still = false;
                    }
                }
            }
        }
        for node in hits
            .iter()
            .flat_map(|hit| (hit.left..).take(hit.before.len()))
        {
            for storey in self.storeys_at(node) {
                let rate = rate_of_drift(&self.members, storey);
                self.members[storey].unload(rate);
            }
        }
    }

    /// The storeys below and above a floor.
    fn storeys_at(&self, node: usize) -> impl Iterator<Item = usize> + use<R> {
        [Some(node), self.members[node].above].into_iter().flatten()
    }

    /// Whether bounces that have just begun will be over within the shortest remainder, the pair closing all the while.
    fn chatters(&self, pair: usize, approach: f64) -> bool {
        let (contact, left) = (&self.contacts[pair], self.lefts[pair]);
        let restitution = contact.restitution().unwrap_or(0.0);
        if approach <= 0.0 {
            return false;
        }
        let [a, b] = [left, left + 1].map(|node| &self.members[node]);
        let mut closing = a.acceleration[0] - b.acceleration[0];
        if contact.opens() {
            closing += a.ground.value - b.ground.value;
        }
        bounces_are_over(contact.rate, closing, restitution)
    }

    fn report_impact(&mut self, pair: usize, time: f64, hit: &Hit) {
        let left = self.lefts[pair];
        let opening_rate = self
            .opening(pair, time)
            .map_or(0.0, |opening| opening.velocity);
        let contact = &mut self.contacts[pair];
        contact.burst = if time - contact.hit < CHATTER {
            contact.burst + 1
        } else {
            0
        };
        contact.hit = time;
        let index = pair - hit.first;
        let struck = |floor: usize, part: f64| {
            let before = hit.before[index + floor - left];
            let velocities = [before, self.members[floor].state.velocity];
            Some(Struck {
                floor,
                part,
                velocities,
            })
        };
        let floors = [struck(left, -1.0), struck(left + 1, 1.0), None, None];
        let impact = Impact {
            pair,
            left,
            right: left + 1,
            floors,
            time: self.clock.absolute(time),
            impulse: hit.impulses[index],
            before: Velocities {
                left: hit.before[index],
                right: hit.before[index + 1],
            },
            after: Velocities {
                left: self.members[left].state.velocity,
                right: self.members[left + 1].state.velocity,
            },
            opening_rate,
        };
        self.recorder.impact(&impact);
    }

    /// Decides which of the touching pairs without a rate press against each other: those whose free motion would
    /// overlap, found by growing their set, each by the first coefficient of its deformation that is not rounding.
    ///
    /// In a chain a pair that presses only drives others together, in whatever order they are taken. What presses on another
    /// floor may part them; it does so in a later coefficient than the one it is known by, so that of several chains those
    /// go first whose coefficient does.
    fn rest_or_part<'h>(&mut self, hits: &'h [Hit], time: f64) -> Result<(), RunError> {
        let chains = || {
            let of = |hit: &'h Hit| (hit.first..=hit.last).map(move |pair| (hit, pair));
            hits.iter().flat_map(of)
        };
        let pairs = || chains().map(|(_, pair)| pair);
        for pair in pairs() {
            self.contacts[pair].link = Link::Apart;
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
                _ => pairs()
                    .filter(|pair| self.may_press(*pair))
                    .filter_map(order)
                    .min(),
            };
            let mut grown = false;
            for (hit, pair) in chains() {
                self.guard.wait(time)?;
                let presses = || matches!(self.press(pair), Some((n, true)) if Some(n) <= soonest);
                if self.may_press(pair) && presses() {
                    if self.is_held(pair) {
                        return Err(self.closed_in(pair, time));
                    }
                    self.join(hit, pair, time);
                    grown = true;
                }
            }
            if !grown {
                break;
            }
        }
        // Neighbours that move alike without a force stay together; not what walls on both sides hold: which of its forces
        // is zero, as one must be, is free.
        for (hit, pair) in chains() {
            self.guard.wait(time)?;
            if self.may_press(pair) && self.press(pair).is_none() && !self.is_held(pair) {
                self.join(hit, pair, time);
            }
            let parts = self.may_press(pair) && matches!(self.press(pair), Some((_, false)));
            self.contacts[pair].gap = if parts { Gap::Parts } else { Gap::Known };
        }
        self.regroup();
        Ok(())
    }

    fn closed_in(&self, pair: usize, time: f64) -> RunError {
        let left = self.lefts[pair];
        RunError::ClosedIn {
            left,
            right: left + 1,
            time,
        }
    }

    /// Whether a pair that touches is neither at rest nor parting with a rate.
    fn may_press(&self, pair: usize) -> bool {
        let contact = &self.contacts[pair];
        contact.link == Link::Apart && contact.rate == 0.0
    }

    /// Whether both sides of a pair rest against walls already.
    fn is_held(&self, pair: usize) -> bool {
        if self.walls < 2 {
            return false;
        }
        let left = self.lefts[pair];
        let rests = |node: usize| {
            let pair = self.pair_right_of[node];
            pair.is_some_and(|pair| self.contacts[pair].link == Link::Resting)
        };
        let mut first = left;
        while first > 0 && rests(first - 1) {
            first -= 1;
        }
        let mut last = left + 1;
        while last < self.members.len() && rests(last) {
            last += 1;
        }
        let holds = |mut nodes: Range<usize>| nodes.any(|node| self.members[node].is_wall());
        holds(first..left + 1) && holds(left + 1..last + 1)
    }

    /// Lets a pair rest: the lighter side takes the velocity of the heavier one, over its own ground.
    fn join(&mut self, hit: &Hit, pair: usize, time: f64) {
        self.contacts[pair].link = Link::Resting;
        if hit.rests_on(pair, &self.members) {
            return;
        }
        let left = self.lefts[pair];
        let carried = self.opening(pair, time).map(|opening| opening.velocity);
        let [a, b] = [left, left + 1].map(|node| &self.members[node]);
        let [v, w] = [a.state.velocity, b.state.velocity];
        if a.mass >= b.mass {
            self.members[left + 1].state.velocity = carried.map_or(v, |carried| v + carried);
        } else {
            self.members[left].state.velocity = carried.map_or(w, |carried| w - carried);
        }
    }

    /// Whether the free motion of a pair overlaps, and by which power of the fourth root of time; nothing where rounding
    /// hides it.
    fn press(&self, pair: usize) -> Option<(usize, bool)> {
        let left = self.lefts[pair];
        let powers =
            [left, left + 1].map(|node| self.bodies[self.groups.body_of[node]].power.order());
        let p = powers[0].max(powers[1]);
        let contact = &self.contacts[pair];
        // A series in t beside one in its fourth root.
        let coefficient = |side: usize, n: usize| {
            let stretched = p / powers[side];
            if n.is_multiple_of(stretched) {
                let member = &self.members[left + side];
                contact.displacement_of(member, p / stretched, n / stretched)
            } else {
                0.0
            }
        };
        // What happens on one floor is felt two orders later on the next.
        let tied = (left..=left + 1).any(|node| self.members[node].is_tied());
        let last = if tied {
            (FEWEST * p).min(CAPACITY)
        } else {
            2 * p + DECISIVE
        };
        (2 * p..last)
            .map(|n| (n, [coefficient(0, n), coefficient(1, n)]))
            // A force that has just faded leaves no closing acceleration.
            .filter(|(n, [left, right])| !(contact.faded && *n == 2 * p && left > right))
            .find(|(n, values)| {
                let noise = noise(&self.members[left..left + 2], *values, p, *n);
                (values[0] - values[1]).abs() > noise
            })
            .map(|(n, [left, right])| (4 * n / p, left > right))
    }

    /// Expands the bodies that have landed; in a long row that comes to rest this is most of what it costs.
    fn expand_landed(&mut self, time: f64) -> Result<(), RunError> {
        self.guard.look(time, self.spent())?;
        for first in 0..self.bodies.len() {
            if self.groups.body_of[first] == first && self.landed[first] {
                self.guard.wait(time)?;
                let (power, _) = self.expand(first, time);
                self.bodies[first].power = power;
                self.clean(first, time, power);
                self.tried += self.groups.nodes_of(first).len() as u64;
            }
        }
        Ok(())
    }

    /// Measures the rounding of an expanded body; clears forces at rest that are nothing else.
    pub(super) fn clean(&mut self, first: usize, time: f64, power: Power) {
        // Where grounds move apart their positions have the rounding of the whole time.
        let time = if self.travel.is_some() {
            self.clock.absolute(time)
        } else {
            time
        };
        let system = (&mut self.members[..], &mut self.contacts[..]);
        clean(self.groups.of(first), system, time, power.order());
    }

    /// Bodies anew, from the links.
    fn regroup(&mut self) {
        self.groups
            .update(&self.members, &self.contacts, &self.pair_right_of);
    }
}
