//! Treatment of pairs that touch at an instant: impact, rest or parting.

use crate::exact::contact::{Gap, Join, System};
use crate::exact::hits::Hit;
use crate::exact::impacts::{Chain, Look, SimultaneousImpacts};
use crate::exact::member::Member;
use crate::exact::storey::rate_of_drift;
use crate::exact::tie;
use crate::exact::{CHATTER, ExactRun, bounces_are_over};
use crate::exact::{Moving, Touching};
use crate::impact::any_rounds::Closed;
use crate::impact::dense::ClosedIn;
use crate::{Impact, Recorder, RunError};

/// Most impacts of a pair without coming to rest; the run is given up beyond. With e = 1, neighbours that press bounce for ever.
///
/// With e = 0.999 a bounce of 0.1 m/s ends after 25 000 impacts.
const MOST_BOUNCES: u32 = 100_000;

impl Touching<'_> {
    /// Gives up if a pair bounces without coming to rest.
    fn count_bounce(&mut self, pair: usize, hit: bool, time: f64) -> Result<(), RunError> {
        let contact = &mut self.contacts[pair];
        if contact.join == Join::Resting {
            contact.bounces = 0;
        } else if hit {
            contact.bounces += 1;
        }
        if contact.bounces <= MOST_BOUNCES {
            return Ok(());
        }
        let [left, right] = contact.floors();
        Err(RunError::BouncesWithoutEnd {
            left,
            right,
            time,
            impacts: contact.bounces,
            restitution: contact.restitution().unwrap_or(0.0),
        })
    }

    pub(super) fn closed_in(&self, pair: usize, time: f64) -> RunError {
        let [left, right] = self.contacts[pair].floors();
        RunError::ClosedIn { left, right, time }
    }
}

impl Moving<'_> {
    /// Ends yielding of columns below and above floors that were hit, if their drift has turned.
    fn unload(&mut self, hits: &[Hit]) {
        for hit in hits {
            let fastest = hit.before.iter().fold(0.0, |fastest: f64, velocity| fastest.max(velocity.abs()));
            for (&node, before) in hit.nodes.iter().zip(&hit.before) {
                self.members[node].come_to_rest(fastest);
                let jumped = (self.members[node].state.velocity - before).abs() > 0.0;
                self.members[node].collide(jumped);
                if jumped {
                    self.linking.at(node).iter().for_each(|at| self.links[at.pair].jump());
                }
                for storey in self.storeys_at(node) {
                    if let (true, Some(drift)) = (jumped, &mut self.members[storey].storey) {
                        drift.still = false;
                    }
                }
            }
        }
        for (&node, before) in hits.iter().flat_map(|hit| hit.nodes.iter().zip(&hit.before)) {
            // The velocity of a floor that did not jump may be rounding.
            if (self.members[node].state.velocity - before).abs() > 0.0 {
                for storey in self.storeys_at(node) {
                    let rate = rate_of_drift(&self.members, storey);
                    self.members[storey].unload(rate);
                }
            }
        }
    }

    /// The storeys below and above a floor.
    fn storeys_at(&self, node: usize) -> impl Iterator<Item = usize> + use<> {
        [Some(node), self.members[node].above].into_iter().flatten()
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Whether a pair has landed with its gap closed and needs a decision.
    pub(super) fn touches_now(&self, pair: usize, time: f64) -> bool {
        let contact = &self.touching.contacts[pair];
        let landed = contact.floors().into_iter().all(|floor| self.moving.landed[floor]);
        let closed = contact.time >= time && contact.deformation == 0.0;
        let open = match contact.join {
            Join::Apart => true,
            Join::Resting => contact.restitution().is_some(),
            Join::Touching(_) => false,
        };
        // A compliant pair that is just closed touches only if its deformation grows.
        landed && closed && open && (contact.restitution().is_some() || contact.gap == Gap::Touches)
    }

    /// Resolves every chain of pairs that touch now.
    pub(super) fn resolve(&mut self, time: f64) -> Result<(), RunError> {
        self.touching.settled.fill(false);
        // Compliant pairs come first: their forces decide whether other pairs come to rest, on both sides.
        for pair in 0..self.touching.contacts.len() {
            if self.touching.contacts[pair].restitution().is_none() && self.touches_now(pair, time) {
                let contact = &mut self.touching.contacts[pair];
                contact.gap = Gap::Known;
                // A graze within rounding does not count.
                if contact.rate >= 0.0 {
                    contact.begin();
                }
            }
        }
        for pair in 0..self.touching.contacts.len() {
            if !self.touching.settled[pair] && self.hits(pair, time) {
                let hits = self.hits_with(pair, time)?;
                self.collide(hits, time)?;
            }
        }
        self.regroup();
        Ok(())
    }

    /// Resolves the impacts of touching pairs, then rest or parting.
    fn collide(&mut self, mut hits: Vec<Hit>, time: f64) -> Result<(), RunError> {
        let closed_in = |hit: &Hit| hit.closed_in(&self.moving.members);
        if let Some(pair) = hits.iter().find_map(closed_in) {
            return Err(self.touching.closed_in(pair, time));
        }
        loop {
            self.release(&hits);
            for hit in &mut hits {
                self.give_impulses(hit, time)?;
            }
            self.stop_against_still(&hits);
            self.moving.unload(&hits);
            match &hits[..] {
                [hit] if !self.touching.is_chain() => self.rest_or_part_any(hit, time)?,
                chains => self.rest_or_part(chains, time)?,
            }
            let mut grown = false;
            for hit in &mut hits {
                for (index, &pair) in hit.pairs.iter().enumerate() {
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
            for (&pair, &impulse) in hit.pairs.iter().zip(&hit.impulses) {
                self.agenda.guard.wait(time)?;
                self.touching.settled[pair] = true;
                if impulse > 0.0 {
                    self.report_impact(pair, impulse, time, hit);
                }
                self.touching.count_bounce(pair, impulse > 0.0, time)?;
            }
        }
        Ok(())
    }

    /// Changes the rates of other pairs by the jumps of their floors.
    fn push_neighbours(&mut self, hit: &Hit) {
        for (node, before) in hit.nodes.iter().zip(&hit.before) {
            let jump = self.moving.members[*node].state.velocity - before;
            for at in self.touching.incidence.at(*node) {
                if hit.pairs.binary_search(&at.pair).is_err() {
                    let closing = at.part * jump;
                    let contact = &mut self.touching.contacts[at.pair];
                    contact.push(if at.on_left { closing } else { -closing });
                }
            }
        }
    }

    /// Finds velocities and rates after connected impacts.
    fn give_impulses(&mut self, hit: &mut Hit, time: f64) -> Result<(), RunError> {
        if !self.touching.groups.is_chain {
            return self.give_any(hit, time);
        }
        let (guard, chain, places) = (&self.agenda.guard, &mut self.touching.chain, 0..hit.pairs.len());
        let look = || guard.wait(time);
        chain.clear();
        chain.rates.extend_from_slice(&hit.rates);
        let restitution = |place| hit.restitution(place, &self.touching.contacts);
        chain.restitutions.extend(places.clone().map(restitution));
        chain.passes_on.extend(places.map(|place| hit.passes_on(place)));
        let rule = self.settings.simultaneous_impacts;
        give_along(chain, hit, &mut self.moving.members, rule, &look)?;
        for (pair, rate) in hit.pairs.iter().zip(&chain.rates) {
            self.touching.contacts[*pair].rate = *rate;
        }
        Ok(())
    }

    /// Finds velocities and rates after connected impacts of pairs that are no chain.
    fn give_any(&mut self, hit: &mut Hit, time: f64) -> Result<(), RunError> {
        let (members, contacts) = (&self.moving.members, &self.touching.contacts);
        let system = System {
            members,
            contacts,
            incidence: self.touching.incidence,
        };
        // A part of a body that is slower than this by far counts as at rest.
        let fastest = |pair: usize| {
            let bodies = contacts[pair].floors().map(|floor| self.touching.groups.body_of[floor]);
            let nodes = bodies.into_iter().flat_map(|body| self.touching.groups.of(body).nodes());
            let speeds = nodes.map(|node| members[*node].state.velocity.abs());
            speeds.fold(0.0, f64::max)
        };
        let rounds = &mut self.touching.rounds;
        rounds.pairs.clear();
        rounds.problem.begin(hit.nodes.len(), 0);
        for (place, pair) in hit.pairs.iter().enumerate() {
            rounds.pairs.push(Closed {
                rate: hit.rates[place],
                restitution: hit.restitution(place, contacts),
                passes_on: hit.passes_on(place),
                scale: fastest(*pair),
                impulse: 0.0,
            });
            let column = tie::elements(*pair, &hit.nodes, system);
            rounds.problem.push(column);
        }
        let opens = hit.pairs.iter().any(|pair| contacts[*pair].opens());
        let alone = self.settings.simultaneous_impacts == SimultaneousImpacts::Sequential;
        let collided = rounds.collide(alone, opens, || self.agenda.guard.wait(time))?;
        if let Err(ClosedIn { contact }) = collided {
            return Err(self.touching.closed_in(hit.pairs[contact], time));
        }
        for (node, before) in hit.nodes.iter().zip(&hit.before) {
            self.moving.members[*node].state.velocity = *before;
        }
        for (index, pair) in hit.pairs.iter().enumerate() {
            let (contact, closed) = (&mut self.touching.contacts[*pair], &self.touching.rounds.pairs[index]);
            contact.rate = closed.rate;
            contact.kick(closed.impulse, &mut self.moving.members);
            hit.impulses[index] = closed.impulse;
        }
        Ok(())
    }

    /// Whether bounces that have just begun end within the shortest remainder while the pair keeps closing.
    fn chatters(&self, pair: usize, approach: f64) -> bool {
        let contact = &self.touching.contacts[pair];
        let restitution = contact.restitution().unwrap_or(0.0);
        if approach <= 0.0 {
            return false;
        }
        let ahead = contact.relation.ahead(|node| self.moving.members[node].acceleration[0]);
        let closing = contact.over_grounds(ahead, |node| self.moving.members[node].ground.value);
        bounces_are_over(contact.rate, closing, restitution)
    }

    fn report_impact(&mut self, pair: usize, impulse: f64, time: f64, hit: &Hit) {
        let opening_rate = self.opening(pair, time).map_or(0.0, |opening| opening.velocity);
        let contact = &mut self.touching.contacts[pair];
        contact.burst = if time - contact.hit < CHATTER { contact.burst + 1 } else { 0 };
        contact.hit = time;
        let after = |floor: usize| self.moving.members[floor].state.velocity;
        let impact = Impact {
            pair,
            time: self.agenda.clock.absolute(time),
            impulse,
            opening_rate,
            ..Impact::of(&contact.relation, |floor| hit.before(floor), after)
        };
        self.recorder.impact(&impact);
    }
}

/// Applies velocity jumps in a chain.
fn give_along(chain: &mut Chain, hit: &mut Hit, members: &mut [Member], rule: SimultaneousImpacts, look: Look<'_>) -> Result<(), RunError> {
    chain.velocities.extend_from_slice(&hit.before);
    for (velocity, carried) in chain.velocities.iter_mut().zip(&hit.carried) {
        *velocity += carried;
    }
    let masses = hit.nodes.iter().map(|node| members[*node].mass);
    chain.masses.extend(masses);
    chain.collide(rule, look)?;
    for (index, node) in hit.nodes.iter().enumerate() {
        // A floor that was not hit keeps its velocity to the last bit.
        let (before, after) = (hit.before[index], chain.velocities[index]);
        members[*node].state.velocity = match hit.carried.get(index) {
            None => after,
            Some(carried) if after.total_cmp(&(before + carried)).is_ne() => after - carried,
            Some(_) => before,
        };
    }
    hit.impulses.copy_from_slice(&chain.impulses);
    Ok(())
}
