//! Pieces of the structures that move together, and their launch.

use std::ops::Range;

use crate::exact::Run;
use crate::exact::contact::{Contact, Link, Phase};
use crate::exact::member::Member;
use crate::exact::series;
use crate::exact::watch::{Event, Watch, reach};
use crate::span::Power;
use crate::{Recorder, RunError};

/// Structures that move together, and the piece of their motion under way.
#[derive(Debug, Clone)]
pub(super) struct Body {
    pub(super) last: usize,
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) power: Power,
    /// Length of the piece in x, t = start + x^p.
    pub(super) length: f64,
    /// Number of coefficients.
    pub(super) len: usize,
    /// What happens at the end.
    pub(super) events: Vec<Event>,
}

/// Number of coefficients in free flight by the part s of the series' reach that a piece may take: sⁿ/n! < 1e-21.
const IN_FLIGHT: [(f64, usize); 4] = [(0.125, 13), (0.25, 15), (0.5, 18), (1.0, 22)];
/// In compliant contact.
const IN_CONTACT: usize = 32;
/// Just after the first touch of compliant contact, in the fourth root of time.
const AT_TOUCH: usize = 56;
/// Coefficients beyond this magnitude are left out: the next one might not be finite.
const LARGEST: f64 = 1e250;
/// Pieces of one contact of a law with δ̇/v₀ after which a run gives up.
const MOST_IN_CONTACT: u32 = 100_000;

impl Body {
    /// A structure alone at t = 0.
    pub(super) fn at_start(node: usize) -> Self {
        Self {
            last: node,
            start: 0.0,
            end: 0.0,
            power: Power::One,
            length: 0.0,
            len: 0,
            events: Vec::with_capacity(8),
        }
    }

    /// x at a time of the piece.
    pub(super) fn position(&self, time: f64) -> f64 {
        if time >= self.end {
            self.length
        } else {
            self.power.root((time - self.start).max(0.0))
        }
    }
}

impl<R: Recorder> Run<'_, R> {
    /// Pairs inside the body of nodes `first` ..= `last`.
    pub(super) fn pairs_within(&self, first: usize, last: usize) -> Range<usize> {
        match self.pair_right_of[first] {
            Some(pair) if last > first => pair..pair + (last - first),
            _ => 0..0,
        }
    }

    /// Expands the motion of a body from now on; returns the number of coefficients.
    pub(super) fn expand(&mut self, (first, last): (usize, usize), time: f64) -> (Power, usize) {
        let within = self.pairs_within(first, last);
        let contacts = &mut self.contacts[within];
        let touching = |contact: &Contact| matches!(contact.link, Link::Touching(_));
        let begins = |contact: &Contact| touching(contact) && contact.deformation <= 0.0;
        let segment = self.excitation.segment(time);
        let members = &mut self.members[first..=last];
        let (power, len) = if contacts.iter().any(begins) {
            (Power::Four, AT_TOUCH)
        } else if contacts.iter().any(touching) {
            (Power::One, IN_CONTACT)
        } else {
            let part = (segment.end.min(self.end) - time) / series::radius(members);
            let enough = IN_FLIGHT.iter().find(|(most, _)| part <= *most);
            (Power::One, enough.map_or(IN_FLIGHT[3].1, |(_, len)| *len))
        };
        series::expand(members, contacts, segment, power, len);
        let tame = |n: &usize| {
            let moves = |member: &Member| {
                let Member {
                    displacement: u,
                    velocity: v,
                    acceleration: a,
                    ..
                } = member;
                u[*n].abs() < LARGEST && v[*n].abs() < LARGEST && a[*n].abs() < LARGEST
            };
            let pushes = |contact: &Contact| {
                let pulls = contact.can_pull() && contact.pull[*n].abs() >= LARGEST;
                contact.force[*n].abs() < LARGEST && !pulls
            };
            members.iter().all(moves)
                && contacts
                    .iter()
                    .all(|contact| !touching(contact) || pushes(contact))
        };
        (power, (0..len).take_while(tame).count())
    }

    /// Begins the next piece of a body that has landed.
    pub(super) fn launch(&mut self, first: usize, time: f64) -> Result<(), RunError> {
        let mut last = first;
        while last + 1 < self.body_of.len() && self.body_of[last + 1] == first {
            last += 1;
        }
        if time >= self.end {
            (self.bodies[first].start, self.bodies[first].end) = (time, f64::INFINITY);
            return Ok(());
        }
        self.find_partings(first, last);
        self.count_pieces(first, last, time)?;
        let (power, len) = self.expand_corrected((first, last), time);
        for node in first..=last {
            self.fill_start(node, time, (power, len))?;
        }
        let members = &self.members[first..=last];
        let stop = self.excitation.segment(time).end.min(self.end);
        let wall = members.iter().all(Member::is_wall);
        let stop = if wall { self.end } else { stop };
        let mut length = power
            .root(series::radius(members))
            .min(power.root(stop - time));
        length = length.min(self.converged((first, last), (power, len), length, time)?);
        self.work.segments += members.len() as u64;
        let whole = length >= power.root(stop - time);
        let mut watch = Watch {
            start: time,
            power,
            reach: length,
            length,
            events: std::mem::take(&mut self.bodies[first].events),
        };
        watch.events.clear();
        self.watch(&mut watch, (first, last), (power, len));
        let end = if whole && watch.events.is_empty() {
            stop
        } else {
            (time + power.time(watch.length)).min(stop)
        };
        let body = &mut self.bodies[first];
        *body = Body {
            last,
            start: time,
            end,
            power,
            // What happens within rounding of the start happens at the start.
            length: if end > time { watch.length } else { 0.0 },
            len,
            events: watch.events,
        };
        Ok(())
    }

    /// Length up to which the series of every touching pair of a body have converged.
    fn converged(
        &self,
        (first, last): (usize, usize),
        (power, len): (Power, usize),
        longest: f64,
        time: f64,
    ) -> Result<f64, RunError> {
        let mut length = longest;
        // Each from the same start, so that their order does not matter.
        let contacts = &self.contacts[self.pairs_within(first, last)];
        for (left, contact) in (first..).zip(contacts) {
            let sides = &self.members[left..left + 2];
            let limits = (longest, self.settings.tolerance);
            let reach = reach(contact, sides, (power, len), limits);
            length = length.min(reach.ok_or(RunError::NoSeries {
                left,
                right: left + 1,
                time,
            })?);
        }
        Ok(length)
    }

    /// Expands a body; once more where the first expansion shows that columns unload, or what is but rounding.
    fn expand_corrected(&mut self, (first, last): (usize, usize), time: f64) -> (Power, usize) {
        let within = self.pairs_within(first, last);
        for contact in &mut self.contacts[within.clone()] {
            contact.alike = 0;
        }
        let (power, len) = self.expand((first, last), time);
        self.clean((first, last), time, power);
        let members = &mut self.members[first..=last];
        let mut corrected = false;
        for member in &mut *members {
            corrected |= member.turns_back(power.order());
        }
        for (index, contact) in self.contacts[within].iter_mut().enumerate() {
            corrected |= contact.find_alike(&members[index..index + 2], power, len);
        }
        if !corrected {
            return (power, len);
        }
        let (power, len) = self.expand((first, last), time);
        self.clean((first, last), time, power);
        for member in &mut self.members[first..=last] {
            member.clear_standstill(power.order());
        }
        (power, len)
    }

    /// Ends the run where a contact goes on and on: each piece is as short as the relaxation of its damper.
    fn count_pieces(&mut self, first: usize, last: usize, time: f64) -> Result<(), RunError> {
        let within = self.pairs_within(first, last);
        for (contact, left) in self.contacts[within].iter_mut().zip(first..) {
            if !(contact.law.knows_approach_speed() && matches!(contact.link, Link::Touching(_))) {
                continue;
            }
            contact.pieces += 1;
            if contact.pieces > MOST_IN_CONTACT {
                return Err(RunError::CrawlsInContact {
                    left,
                    right: left + 1,
                    time,
                    approach_speed: contact.approach_speed,
                    law: contact.law.name(),
                    pieces: contact.pieces,
                });
            }
        }
        Ok(())
    }

    /// Restitution whose remaining impulse is below the tolerance is over.
    fn find_partings(&mut self, first: usize, last: usize) {
        let within = self.pairs_within(first, last);
        for contact in &mut self.contacts[within] {
            let Some(left) = contact.rough_remainder() else {
                continue;
            };
            let momentum = contact.reduced_mass * contact.rate * contact.rate;
            let over = contact.rate < 0.0 && left <= self.settings.tolerance * momentum;
            if contact.link == Link::Touching(Phase::Restitution) && over {
                contact.link = Link::Touching(Phase::Parting);
            }
        }
    }

    /// Completes the state of a node at the start of its piece.
    fn fill_start(
        &mut self,
        node: usize,
        time: f64,
        (power, len): (Power, usize),
    ) -> Result<(), RunError> {
        let (left, right) = self.forces_on(node);
        let force = |pair: Option<usize>| pair.map_or(0.0, |pair| self.contacts[pair].force[0]);
        let (left, right) = (force(left), -force(right));
        let member = &mut self.members[node];
        member.state.acceleration = member.acceleration[0];
        member.state.force_from_left = left;
        member.state.force_from_right = right;
        // A motion of which not even the acceleration is known goes nowhere.
        if len > power.order() && member.state.acceleration.is_finite() {
            return Ok(());
        }
        Err(RunError::OutOfNumbers {
            structure: node,
            time,
        })
    }

    /// First of the structures that share this one's velocity because they rest against each other.
    pub(super) fn leader(&self, node: usize) -> usize {
        let rests = |left: usize| {
            self.pair_right_of[left].is_some_and(|pair| self.contacts[pair].link == Link::Resting)
        };
        let mut leader = node;
        while leader > 0 && rests(leader - 1) {
            leader -= 1;
        }
        leader
    }

    /// The pairs on the left and right of a node that carry a force.
    pub(super) fn forces_on(&self, node: usize) -> (Option<usize>, Option<usize>) {
        let joined = |pair: &usize| self.contacts[*pair].link != Link::Apart;
        let left = node
            .checked_sub(1)
            .and_then(|left| self.pair_right_of[left]);
        (left.filter(joined), self.pair_right_of[node].filter(joined))
    }
}
