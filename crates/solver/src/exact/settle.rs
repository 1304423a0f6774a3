//! What happens to pairs that touch at one instant: impacts, rest, or parting.

use crate::exact::contact::{Contact, Link};
use crate::exact::noise::{clean, noise};
use crate::exact::{CHATTER, Run};
use crate::span::Power;
use crate::{Impact, Recorder, RunError, Velocities};

/// Impacts of a pair within the shortest remainder after which the next one is plastic.
const BURST: u32 = 50;
/// Impacts of a pair without coming to rest after which a run gives up: with e = 1 neighbours that press bounce for ever.
///
/// With e = 0.999 a bounce of 0.1 m/s is over after 25 000.
const MOST_BOUNCES: u32 = 100_000;
/// Coefficients that decide whether a pair presses or parts, from that of the acceleration on.
const DECISIVE: usize = 12;

impl<R: Recorder> Run<'_, R> {
    /// Resolves every chain of pairs that touch now.
    pub(super) fn resolve(&mut self, time: f64) -> Result<(), RunError> {
        let mut pair = 0;
        while pair < self.contacts.len() {
            if !self.touches_now(pair, time) {
                pair += 1;
                continue;
            }
            if self.contacts[pair].restitution().is_none() {
                let contact = &mut self.contacts[pair];
                contact.touching = false;
                // A graze within rounding is none.
                if contact.rate >= 0.0 {
                    contact.begin();
                }
                pair += 1;
                continue;
            }
            let mut last = pair;
            while last + 1 < self.contacts.len()
                && self.lefts[last + 1] == self.lefts[last] + 1
                && self.touches_now(last + 1, time)
                && self.contacts[last + 1].restitution().is_some()
            {
                last += 1;
            }
            self.collide(pair, last, time)?;
            pair = last + 1;
        }
        self.regroup();
        Ok(())
    }

    /// Whether a pair has landed with its gap closed, in need of a decision.
    fn touches_now(&self, pair: usize, time: f64) -> bool {
        let (contact, left) = (&self.contacts[pair], self.lefts[pair]);
        let landed = self.landed[left] && self.landed[left + 1];
        let closed = contact.time >= time && contact.deformation == 0.0;
        let open = match contact.link {
            Link::Apart => true,
            Link::Resting => contact.restitution().is_some(),
            Link::Touching(_) => false,
        };
        // A compliant pair that is just closed touches only where its deformation grows.
        landed && closed && open && (contact.restitution().is_some() || contact.touching)
    }

    /// Impacts of a chain of touching pairs, then rest or parting.
    fn collide(&mut self, first: usize, last: usize, time: f64) -> Result<(), RunError> {
        let nodes = self.lefts[first]..=self.lefts[last] + 1;
        let before: Vec<f64> = nodes
            .clone()
            .map(|node| self.members[node].state.velocity)
            .collect();
        let rates: Vec<f64> = (first..=last)
            .map(|pair| self.contacts[pair].rate)
            .collect();
        let mut plastic: Vec<bool> = (first..=last)
            .map(|pair| {
                let contact = &mut self.contacts[pair];
                let again = time - contact.hit < CHATTER;
                again && contact.burst >= BURST
            })
            .collect();
        loop {
            self.give_impulses((first, last), &before, &rates, &plastic);
            self.rest_or_part(first, last, time);
            let mut grown = false;
            for pair in first..=last {
                let index = pair - first;
                if !plastic[index] && self.chatters(pair, rates[index]) {
                    plastic[index] = true;
                    grown = true;
                }
            }
            if !grown {
                break;
            }
        }
        self.push_neighbours((first, last), &before);
        for pair in first..=last {
            let impulse = self.chain.impulses[pair - first];
            if impulse > 0.0 {
                self.report_impact(pair, impulse, time, (first, &before));
            }
            self.count_bounce(pair, impulse > 0.0, time)?;
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
    fn push_neighbours(&mut self, (first, last): (usize, usize), before: &[f64]) {
        let (start, end) = (self.lefts[first], self.lefts[last] + 1);
        let jump = |node: usize| self.members[node].state.velocity - before[node - start];
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
    fn give_impulses(
        &mut self,
        (first, last): (usize, usize),
        velocities: &[f64],
        rates: &[f64],
        plastic: &[bool],
    ) {
        let left = self.lefts[first];
        let chain = &mut self.chain;
        chain.clear();
        chain.velocities.extend_from_slice(velocities);
        chain.rates.extend_from_slice(rates);
        for index in 0..velocities.len() {
            chain.masses.push(self.members[left + index].mass);
        }
        for (contact, plastic) in self.contacts[first..=last].iter().zip(plastic) {
            let restitution = if *plastic {
                0.0
            } else {
                contact.restitution().unwrap_or(0.0)
            };
            chain.restitutions.push(restitution);
        }
        chain.collide(self.settings.simultaneous_impacts);
        for (index, velocity) in chain.velocities.iter().enumerate() {
            let member = &mut self.members[left + index];
            member.state.velocity = *velocity;
            member.unload();
        }
        for (contact, rate) in self.contacts[first..=last].iter_mut().zip(&chain.rates) {
            contact.rate = *rate;
        }
    }

    /// Whether bounces that have just begun will be over within the shortest remainder, the pair closing all the while.
    fn chatters(&self, pair: usize, approach: f64) -> bool {
        let (contact, left) = (&self.contacts[pair], self.lefts[pair]);
        let restitution = contact.restitution().unwrap_or(0.0);
        if approach <= 0.0 || contact.rate >= 0.0 || restitution >= 1.0 {
            return false;
        }
        let closing = self.members[left].acceleration[0] - self.members[left + 1].acceleration[0];
        closing > 0.0 && -2.0 * contact.rate < CHATTER * closing * (1.0 - restitution)
    }

    fn report_impact(
        &mut self,
        pair: usize,
        impulse: f64,
        time: f64,
        (first, before): (usize, &[f64]),
    ) {
        let left = self.lefts[pair];
        let contact = &mut self.contacts[pair];
        contact.burst = if time - contact.hit < CHATTER {
            contact.burst + 1
        } else {
            0
        };
        contact.hit = time;
        let index = pair - first;
        let impact = Impact {
            pair,
            left,
            right: left + 1,
            time,
            impulse,
            before: Velocities {
                left: before[index],
                right: before[index + 1],
            },
            after: Velocities {
                left: self.members[left].state.velocity,
                right: self.members[left + 1].state.velocity,
            },
        };
        self.recorder.impact(&impact);
    }

    /// Decides which of the touching pairs without a rate press against each other: those whose free motion would
    /// overlap, found by growing their set, each by the first coefficient of its deformation that is not rounding.
    fn rest_or_part(&mut self, first: usize, last: usize, time: f64) {
        for contact in &mut self.contacts[first..=last] {
            contact.link = Link::Apart;
        }
        loop {
            self.regroup();
            self.expand_landed(time);
            let mut grown = false;
            for pair in first..=last {
                if self.contacts[pair].link == Link::Apart
                    && self.contacts[pair].rate == 0.0
                    && self.presses(pair) == Some(true)
                {
                    self.join(pair);
                    grown = true;
                }
            }
            if !grown {
                break;
            }
        }
        // Neighbours that move alike without a force stay together.
        for pair in first..=last {
            let alike = self.contacts[pair].rate == 0.0 && self.presses(pair).is_none();
            if alike && self.contacts[pair].link == Link::Apart {
                self.join(pair);
            }
        }
        self.regroup();
    }

    fn join(&mut self, pair: usize) {
        self.contacts[pair].link = Link::Resting;
        let left = self.lefts[pair];
        let (a, b) = (&self.members[left], &self.members[left + 1]);
        let velocity = if a.mass >= b.mass {
            a.state.velocity
        } else {
            b.state.velocity
        };
        self.members[left].state.velocity = velocity;
        self.members[left + 1].state.velocity = velocity;
    }

    /// Whether the free motion of a pair overlaps; nothing where rounding hides it.
    fn presses(&self, pair: usize) -> Option<bool> {
        let left = self.lefts[pair];
        let powers = [left, left + 1].map(|node| self.bodies[self.body_of[node]].power.order());
        let p = powers[0].max(powers[1]);
        // A series in t beside one in its fourth root.
        let coefficient = |side: usize, n: usize| {
            let stretched = p / powers[side];
            if n.is_multiple_of(stretched) {
                self.members[left + side].displacement[n / stretched]
            } else {
                0.0
            }
        };
        let contact = &self.contacts[pair];
        (2 * p..2 * p + DECISIVE)
            .map(|n| (n, [coefficient(0, n), coefficient(1, n)]))
            // A force that has just faded leaves no closing acceleration.
            .filter(|(n, [left, right])| !(contact.faded && *n == 2 * p && left > right))
            .find(|(n, values)| {
                let noise = noise(&self.members[left..left + 2], *values, p, *n);
                (values[0] - values[1]).abs() > noise
            })
            .map(|(_, [left, right])| left > right)
    }

    /// Expands the bodies that have landed.
    fn expand_landed(&mut self, time: f64) {
        let mut first = 0;
        while first < self.body_of.len() {
            let mut last = first;
            while last + 1 < self.body_of.len() && self.body_of[last + 1] == first {
                last += 1;
            }
            if self.landed[first] {
                let (power, _) = self.expand((first, last), time);
                self.bodies[first].power = power;
                self.clean((first, last), time, power);
            }
            first = last + 1;
        }
    }

    /// Measures the rounding of an expanded body; clears forces at rest that are nothing else.
    pub(super) fn clean(&mut self, (first, last): (usize, usize), time: f64, power: Power) {
        let within = self.pairs_within(first, last);
        let ground = self.excitation.segment(time);
        let (members, contacts) = (&mut self.members[first..=last], &mut self.contacts[within]);
        clean(members, contacts, (ground, time), power.order());
    }

    /// Bodies anew, from the links.
    fn regroup(&mut self) {
        for node in 0..self.body_of.len() {
            let joined = node.checked_sub(1).is_some_and(|left| {
                self.pair_right_of[left].is_some_and(|pair| self.contacts[pair].link != Link::Apart)
            });
            self.body_of[node] = if joined { self.body_of[node - 1] } else { node };
        }
    }
}

impl Contact {
    /// Changes the rate by a jump; a compliant pair may turn from one phase to the other.
    fn push(&mut self, jump: f64) {
        self.rate += jump;
        if matches!(self.link, Link::Touching(_)) && jump.abs() > 0.0 {
            self.link = Link::Touching(self.phase());
        }
    }
}
