//! Pieces of the motion of floors that move together, and the start of each piece.

use std::ops::Range;

use crate::exact::clock::Past;
use crate::exact::contact::{Join, PairState, Phase};
use crate::exact::groups::beside;
use crate::exact::member::{self, Member};
use crate::exact::series;
use crate::exact::watch::{Event, Watch, reach};
use crate::exact::{ExactRun, Moving, Touching, rounding};
use crate::model::incidence::Incident;
use crate::span::Power;
use crate::{Recorder, RunError};

/// The current piece of the motion of floors that move together.
#[derive(Debug, Clone)]
pub(super) struct Body {
    pub(super) start: Past,
    /// End of the piece on the clock.
    pub(super) end: f64,
    pub(super) power: Power,
    /// Length of the piece in x, t = start + x^p.
    pub(super) length: f64,
    /// Number of coefficients.
    pub(super) len: usize,
    /// Events at the end of the piece.
    pub(super) events: Vec<Event>,
}

/// Number of coefficients in free flight, for a piece that takes the part s of the reach of the series: sⁿ/n! < 1e-21.
const IN_FLIGHT: [(f64, usize); 4] = [(0.125, 13), (0.25, 15), (0.5, 18), (1.0, 22)];
/// Number of coefficients in compliant contact.
const IN_CONTACT: usize = 32;
/// Number of coefficients just after the first touch of compliant contact, in the fourth root of time.
const AT_TOUCH: usize = 56;
/// Largest coefficient that is kept: the next one might not be finite.
const LARGEST: f64 = 1e250;
/// Most pieces of a contact whose law has δ̇/v₀. The run is given up beyond.
const MOST_IN_CONTACT: u32 = 100_000;

impl Body {
    /// The body at t = 0.
    pub(super) fn at_start() -> Self {
        Self {
            start: Past::default(),
            end: 0.0,
            power: Power::One,
            length: 0.0,
            len: 0,
            events: Vec::with_capacity(8),
        }
    }

    /// x at an instant of the piece.
    pub(super) fn position(&self, now: Past) -> f64 {
        if now.time() >= self.end {
            self.length
        } else {
            self.power.root(now.since(self.start).max(0.0))
        }
    }
}

impl Touching<'_> {
    /// Whether some neighbours in a body rest against each other.
    fn rests(&self, first: usize) -> bool {
        let mut pairs = self.groups.of(first).pairs().iter();
        pairs.any(|pair| self.contacts[*pair].join == Join::Resting)
    }

    /// Ends the run if a contact goes on and on: each piece is as short as the relaxation time of its damper.
    fn count_pieces(&mut self, first: usize, time: f64) -> Result<(), RunError> {
        for pair in self.groups.of(first).pairs() {
            let contact = &mut self.contacts[*pair];
            if !(contact.law.knows_approach_speed() && matches!(contact.join, Join::Touching(_))) {
                continue;
            }
            contact.pieces += 1;
            if contact.pieces > MOST_IN_CONTACT {
                let [left, right] = contact.floors();
                return Err(RunError::CrawlsInContact {
                    left,
                    right,
                    time,
                    approach_speed: contact.approach_speed,
                    law: contact.law.name(),
                    pieces: contact.pieces,
                });
            }
        }
        Ok(())
    }

    /// Ends restitutions whose remaining energy is below the tolerance.
    fn find_partings(&mut self, first: usize, tolerance: f64) {
        for pair in self.groups.of(first).pairs() {
            let contact = &mut self.contacts[*pair];
            let Some(left) = contact.rough_remainder() else {
                continue;
            };
            let energy = contact.reduced_mass * contact.rate * contact.rate;
            let over = contact.rate < 0.0 && left <= tolerance * energy;
            if contact.join == Join::Touching(Phase::Restitution) && over {
                contact.join = Join::Touching(Phase::Parting);
            }
        }
    }

    /// First of the chain neighbours that share the velocity of this node because they rest against each other on grounds that move alike.
    pub(super) fn leader(&self, node: usize) -> usize {
        let mut leader = node;
        while self.is_led(leader) {
            leader -= 1;
        }
        leader
    }

    /// The nodes that share the velocity of `leader`; empty if `leader` is not the first of them.
    pub(super) fn led_by(&self, leader: usize) -> Range<usize> {
        let mut end = leader;
        while end < self.groups.body_of.len() && self.is_led(end) == (end > leader) {
            end += 1;
        }
        leader..end
    }

    /// Whether a node of a chain shares the velocity of its left neighbour. In other rows each node turns alone.
    fn is_led(&self, node: usize) -> bool {
        let alike = |contact: &PairState| contact.join == Join::Resting && !contact.opens();
        let left = beside(self.incidence, node)[0].filter(|_| self.is_chain());
        left.is_some_and(|pair| alike(&self.contacts[pair]))
    }

    /// The pairs at a node that touch or rest.
    pub(super) fn joined_at(&self, node: usize) -> impl Iterator<Item = &Incident> {
        let all = self.incidence.at(node).iter();
        all.filter(|at| self.contacts[at.pair].join != Join::Apart)
    }

    /// Sum of a quantity over the touching or resting pairs that have the node on their left (or right); `None` if there is no such pair.
    #[inline]
    pub(super) fn pushed(&self, node: usize, on_left: bool, quantity: impl Fn(&PairState) -> f64) -> Option<f64> {
        self.joined_at(node)
            .filter(|at| at.on_left == on_left)
            .map(|at| at.part * quantity(&self.contacts[at.pair]))
            .reduce(|sum, given| sum + given)
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Expands the motion of a body from now on; returns the power of time and the number of coefficients.
    pub(super) fn expand(&mut self, first: usize, time: f64) -> (Power, usize) {
        let stop = self.shake(first, time).min(self.agenda.end);
        self.open_links(first, time);
        let group = self.touching.groups.of(first);
        let any = |asked: fn(&PairState) -> bool| {
            let mut pairs = group.pairs().iter();
            pairs.any(|pair| asked(&self.touching.contacts[*pair]))
        };
        let bends = |node: &usize| self.moving.members[*node].bend.is_some();
        let flows = |link: &usize| self.moving.links[*link].bends();
        let (power, len) = if any(begins) {
            (Power::Four, AT_TOUCH)
        } else if any(touching) || group.followed().iter().any(bends) || group.links().iter().any(flows) {
            (Power::One, IN_CONTACT)
        } else {
            let radius = series::radius(&self.moving.members, group.nodes());
            (Power::One, in_flight((stop - time) / radius))
        };
        let Moving { members, links, .. } = &mut self.moving;
        let contacts = &mut self.touching.contacts;
        series::expand(group, members, contacts, links, self.touching.incidence, (power, len));
        let tame = |n: &usize| {
            let moves = |node: &usize| {
                let Member {
                    displacement: u,
                    velocity: v,
                    acceleration: a,
                    ..
                } = &self.moving.members[*node];
                u[*n].abs() < LARGEST && v[*n].abs() < LARGEST && a[*n].abs() < LARGEST
            };
            let pushes = |contact: &PairState| {
                let pulls = contact.can_pull() && contact.pull[*n].abs() >= LARGEST;
                contact.force[*n].abs() < LARGEST && !pulls
            };
            let tame = |contact: &PairState| !touching(contact) || pushes(contact);
            let mut pairs = group.pairs().iter();
            group.nodes().iter().all(moves) && pairs.all(|pair| tame(&self.touching.contacts[*pair]))
        };
        (power, (0..len).take_while(tame).count())
    }

    /// Starts the next piece of a body that has landed.
    pub(super) fn launch(&mut self, first: usize, time: f64) -> Result<(), RunError> {
        if time >= self.agenda.end {
            let body = &mut self.moving.bodies[first];
            (body.start, body.end) = (self.agenda.clock.past(time), f64::INFINITY);
            return Ok(());
        }
        self.touching.find_partings(first, self.settings.tolerance);
        self.look_to_sample(first, time);
        self.touching.count_pieces(first, time)?;
        let (power, len) = self.expand_corrected(first, time);
        for place in self.touching.groups.nodes_of(first) {
            self.fill_start(self.touching.groups.node(place), time, power, len)?;
        }
        let nodes = self.touching.groups.of(first).nodes();
        let stop = self.stop(nodes);
        let mut length = power.root(series::radius(&self.moving.members, nodes)).min(power.root(stop - time));
        self.agenda.work.segments += nodes.len() as u64;
        length = length.min(self.converged(first, power, len, length, time)?);
        let whole = length >= power.root(stop - time);
        let mut watch = Watch {
            start: self.agenda.clock.absolute(time),
            power,
            reach: length,
            length,
            events: std::mem::take(&mut self.moving.bodies[first].events),
        };
        watch.events.clear();
        self.watch(&mut watch, first, len, time)?;
        // What holds a floor beyond its friction is no force that another floor feels: the floor lets go before anything else.
        if watch.length == 0.0 && watch.events.iter().any(|event| event.lets_go(&self.moving.members)) {
            watch.events.retain(|event| event.lets_go(&self.moving.members));
        }
        // A force at rest that fades when the next sample arrives may continue after it.
        let left = power.time(length) - power.time(watch.length);
        let at_sample = whole && left <= rounding::OF_SUMS * self.agenda.clock.absolute(stop);
        if at_sample && self.touching.rests(first) && watch.events.iter().all(Event::is_of_forces) {
            watch.events.clear();
        }
        let end = if whole && watch.events.is_empty() {
            stop
        } else if watch.events.is_empty() {
            // If the series reach less than the resolution of the clock, the piece takes this resolution.
            (time + power.time(watch.length)).max(time.next_up()).min(stop)
        } else {
            (time + power.time(watch.length)).min(stop)
        };
        self.moving.bodies[first] = Body {
            start: self.agenda.clock.past(time),
            end,
            power,
            // The piece ends at the instant on the clock, not at the event itself: the ground and everything that flies alone end there,
            // too. Otherwise each event would shift the body in time against them.
            length: power.root(end - time),
            len,
            events: watch.events,
        };
        Ok(())
    }

    /// When the next sample arrives at a node, or the run ends.
    fn stop(&self, nodes: &[usize]) -> f64 {
        let members = nodes.iter().map(|node| &self.moving.members[*node]);
        // A wall needs no samples if all grounds move alike.
        if self.shaking.travel.is_none() && members.clone().all(Member::is_wall) {
            return self.agenda.end;
        }
        members.fold(self.agenda.end, |end, member| end.min(member.ground.end))
    }

    /// Length up to which the series of all touching pairs of a body, and of columns that yield smoothly, have converged.
    fn converged(&self, first: usize, power: Power, len: usize, longest: f64, time: f64) -> Result<f64, RunError> {
        let mut length = longest;
        let group = self.touching.groups.of(first);
        let tolerance = self.settings.tolerance;
        // Each pair starts from the same length, so that the order of pairs does not matter.
        for pair in group.pairs() {
            let contact = &self.touching.contacts[*pair];
            let [left, right] = contact.floors();
            let stands = contact.relation.pushes().all(|(floor, _)| self.moving.members[floor].is_still());
            let reach = reach(contact, stands, power, len, longest, tolerance);
            length = length.min(reach.ok_or(RunError::NoSeries { left, right, time })?);
        }
        for &node in group.followed() {
            if let Some(bend) = &self.moving.members[node].bend {
                let reach = bend.reach(power, len, longest, tolerance);
                let error = RunError::OutOfNumbers { structure: node, time };
                length = length.min(reach.ok_or(error)?);
            }
        }
        for &link in group.links() {
            let state = &self.moving.links[link];
            let reach = state.reach(power, len, longest, tolerance);
            length = length.min(reach.ok_or(RunError::NoLinkSeries { link, time })?);
        }
        Ok(length)
    }

    /// Expands a body. Expands it again if columns turn out to unload, or if the first coefficients are only rounding.
    fn expand_corrected(&mut self, first: usize, time: f64) -> (Power, usize) {
        let group = self.touching.groups.of(first);
        for pair in group.pairs() {
            self.touching.contacts[*pair].alike = 0;
        }
        for &node in group.followed() {
            if let Some(bend) = &mut self.moving.members[node].bend {
                bend.forget_direction();
            }
        }
        let (power, len) = self.expand(first, time);
        self.clean(first, time, power);
        let group = self.touching.groups.of(first);
        let members = &mut self.moving.members;
        let alone = group.pairs().is_empty();
        let mut corrected = false;
        for node in group.nodes() {
            if let Some((member, below)) = member::with_below(members, *node) {
                corrected |= member.turns_back(below, power.order(), len);
                corrected |= (alone || member.stick.is_some()) && member.goes_astray(below, power.order(), len);
            }
        }
        for link in group.links() {
            corrected |= self.moving.links[*link].turns_back(members, power.order(), len);
        }
        for pair in group.pairs() {
            corrected |= self.touching.contacts[*pair].find_alike(members, power, len);
        }
        if !corrected {
            return (power, len);
        }
        // A floor that has begun to stick changes the ties of its body.
        self.regroup();
        let (power, len) = self.expand(first, time);
        self.clean(first, time, power);
        for node in self.touching.groups.of(first).nodes() {
            if let Some((member, below)) = member::with_below(&mut self.moving.members, *node) {
                member.clear_standstill(below, power.order(), len);
            }
        }
        (power, len)
    }

    /// Completes the state of a node at the start of its piece.
    fn fill_start(&mut self, node: usize, time: f64, power: Power, len: usize) -> Result<(), RunError> {
        // As at the end of a piece, the rounding of a force that fades must not pull.
        let force = |on_left| {
            self.touching
                .pushed(node, on_left, |contact| pushing(contact.force[0]))
                .unwrap_or(0.0)
        };
        let (left, right) = (force(false), -force(true));
        let member = &mut self.moving.members[node];
        member.state.acceleration = member.acceleration[0];
        member.state.force_from_left = left;
        member.state.force_from_right = right;
        // Without a known acceleration there is no motion.
        if len > power.order() && member.state.acceleration.is_finite() {
            return Ok(());
        }
        Err(RunError::OutOfNumbers { structure: node, time })
    }
}

/// Number of coefficients in free flight, for a piece that takes this part of the reach of the series.
pub fn in_flight(part: f64) -> usize {
    let enough = IN_FLIGHT.iter().find(|(most, _)| part <= *most);
    enough.map_or(IN_FLIGHT[3].1, |(_, len)| *len)
}

/// A contact force without the pull that rounding leaves; NaN stays NaN.
pub(super) fn pushing(force: f64) -> f64 {
    if force < 0.0 { 0.0 } else { force }
}

fn touching(contact: &PairState) -> bool {
    matches!(contact.join, Join::Touching(_))
}

/// Whether compliant contact has just begun.
fn begins(contact: &PairState) -> bool {
    touching(contact) && contact.deformation <= 0.0
}
