//! Impulsive pairs that touch at an instant: chains, or in other rows all pairs that bodies join.

use crate::exact::contact::{Gap, Join, PairState};
use crate::exact::member::Member;
use crate::exact::tie;
use crate::exact::{BURST, CHATTER, ExactRun, Moving};
use crate::{Recorder, RunError};

/// Impulsive pairs that touch at an instant and are connected. In a chain their floors follow each other.
pub(super) struct Hit {
    /// The pairs, in ascending order.
    pub(super) pairs: Vec<usize>,
    /// Their nodes, in ascending order.
    pub(super) nodes: Vec<usize>,
    /// Velocities of the grounds of a chain's nodes, relative to the ground of a wall, or else to the mean of the first and the last. Empty
    /// if the grounds move alike.
    pub(super) carried: Vec<f64>,
    /// Velocities of the nodes and rates of the pairs before the impact.
    pub(super) before: Vec<f64>,
    pub(super) rates: Vec<f64>,
    /// Pairs that were at rest before.
    pub(super) rested: Vec<bool>,
    /// Pairs that are closed without a rate and open.
    pub(super) parts: Vec<bool>,
    /// Pairs that come to rest instead of bouncing on.
    pub(super) plastic: Vec<bool>,
    /// Impulse of every pair.
    pub(super) impulses: Vec<f64>,
}

impl Hit {
    /// The pair at the second of two walls of the chain whose grounds move towards each other: the floors between them have no room.
    pub(super) fn closed_in(&self, members: &[Member]) -> Option<usize> {
        let mut before: Option<f64> = None;
        for (index, carried) in self.carried.iter().enumerate() {
            if !members[self.nodes[index]].is_wall() {
                continue;
            }
            if before.is_some_and(|before| before > *carried) {
                return Some(self.pairs[index - 1]);
            }
            before = Some(*carried);
        }
        None
    }

    /// Coefficient of restitution of the pair at a place.
    pub(super) fn restitution(&self, place: usize, contacts: &[PairState]) -> f64 {
        let law = contacts[self.pairs[place]].restitution().unwrap_or(0.0);
        if self.plastic[place] { 0.0 } else { law }
    }

    /// Whether the pair at a place neither approaches nor separates, and passes on a hit.
    pub(super) fn passes_on(&self, place: usize) -> bool {
        self.rates[place] >= 0.0 && !(self.rates[place] > 0.0 || self.parts[place])
    }

    /// Velocity of a node before the impact.
    pub(super) fn before(&self, node: usize) -> f64 {
        self.before[self.nodes.binary_search(&node).unwrap_or_default()]
    }

    /// Whether the pair at a place stays at rest: all its floors keep their velocities to the last bit. Known facts about them, such as a
    /// passage through zero, remain valid.
    pub(super) fn rests_on(&self, index: usize, contact: &PairState, members: &[Member]) -> bool {
        let keeps = |floor: usize| {
            let velocity = members[floor].state.velocity;
            velocity.total_cmp(&self.before(floor)).is_eq()
        };
        self.rested[index] && contact.relation.pushes().all(|(floor, _)| keeps(floor))
    }
}

impl Moving<'_> {
    fn share_a_building(&self, body: impl Fn(&usize) -> usize, a: &Hit, b: &Hit) -> bool {
        let building = |node: &usize| self.buildings.of(*node);
        let shared = |node: &usize| {
            b.nodes
                .iter()
                .any(|other| building(other) == building(node) || body(other) == body(node))
        };
        a.nodes.iter().any(shared)
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// The chain of touching pairs that begins with a pair.
    fn chain_from(&self, first: usize, time: f64) -> Vec<usize> {
        let left = |pair: usize| self.touching.contacts[pair].floors()[0];
        let mut last = first;
        while last + 1 < self.touching.contacts.len() && left(last + 1) == left(last) + 1 && self.hits(last + 1, time) {
            last += 1;
        }
        (first..=last).collect()
    }

    /// Whether an impulsive pair touches now.
    pub(super) fn hits(&self, pair: usize, time: f64) -> bool {
        self.touching.contacts[pair].restitution().is_some() && self.touches_now(pair, time)
    }

    /// The chain that begins with a pair, and the chains after it that are connected to it through buildings. In other rows all connected
    /// pairs form one hit.
    pub(super) fn hits_with(&self, pair: usize, time: f64) -> Result<Vec<Hit>, RunError> {
        self.agenda.guard.wait(time)?;
        if !self.touching.is_chain() {
            return Ok(vec![self.hit(self.hanging_together(pair, time)?, time)]);
        }
        let hit = self.hit(self.chain_from(pair, time), time);
        let mut next = pair + hit.pairs.len();
        let mut hits = vec![hit];
        if self
            .moving
            .members
            .iter()
            .all(|member| member.storey.is_none() && member.linked.is_none())
        {
            return Ok(hits);
        }
        let mut others = Vec::new();
        while next < self.touching.contacts.len() {
            if !self.touching.settled[next] && self.hits(next, time) {
                let hit = self.hit(self.chain_from(next, time), time);
                next += hit.pairs.len();
                others.push(hit);
            } else {
                next += 1;
            }
        }
        let body = |node: &usize| self.touching.groups.body_of[*node];
        let shares = |hit: &Hit, other: &Hit| self.moving.share_a_building(body, hit, other);
        hang(&mut hits, others, shares, || self.agenda.guard.wait(time))?;
        hits.sort_by_key(|hit| hit.pairs[0]);
        Ok(hits)
    }

    /// All touching pairs that are connected with a pair, through bodies and each other.
    fn hanging_together(&self, first: usize, time: f64) -> Result<Vec<usize>, RunError> {
        let bodies = |pair: usize| {
            let floors = self.touching.contacts[pair].floors();
            floors.map(|floor| self.touching.groups.body_of[floor])
        };
        let hits = |pair: &usize| !self.touching.settled[*pair] && self.hits(*pair, time);
        let others = (first + 1..self.touching.contacts.len()).filter(hits).collect();
        let hangs = |pair: &usize, other: &usize| {
            let of = bodies(*pair);
            bodies(*other).iter().any(|body| of.contains(body))
        };
        let mut pairs = vec![first];
        hang(&mut pairs, others, hangs, || self.agenda.guard.wait(time))?;
        pairs.sort_unstable();
        Ok(pairs)
    }

    fn hit(&self, pairs: Vec<usize>, time: f64) -> Hit {
        let contacts = || pairs.iter().map(|pair| &self.touching.contacts[*pair]);
        let nodes = tie::floors(&pairs, &self.touching.contacts);
        let soon = |contact: &PairState| time - contact.hit < CHATTER;
        let rests = |contact: &PairState| contact.join == Join::Resting;
        // A floor that two neighbours hit in turn ends at rest against one of them. The remaining impulses of this series on the other pair
        // are given at once.
        let caught = |contact: &PairState| {
            let beside = |other: &PairState| floors(other).any(|floor| floors(contact).any(|own| own == floor));
            contacts().any(|other| rests(other) && soon(other) && !std::ptr::eq(other, contact) && beside(other))
        };
        let stops = |contact: &PairState| soon(contact) && (contact.burst >= BURST || caught(contact));
        let parts = |contact: &PairState| contact.gap == Gap::Parts;
        Hit {
            carried: self.carried(&nodes, time),
            before: nodes.iter().map(|node| self.moving.members[*node].state.velocity).collect(),
            rates: contacts().map(|contact| contact.rate).collect(),
            rested: contacts().map(rests).collect(),
            parts: contacts().map(parts).collect(),
            plastic: contacts().map(stops).collect(),
            impulses: vec![0.0; pairs.len()],
            pairs,
            nodes,
        }
    }

    /// Velocities of the grounds of a chain, relative to one of them.
    fn carried(&self, nodes: &[usize], time: f64) -> Vec<f64> {
        let Some(travel) = self.shaking.travel.as_ref().filter(|_| self.touching.is_chain()) else {
            return Vec::new();
        };
        let instant = self.agenda.clock.past(time).instant();
        let wall = nodes.iter().copied().find(|node| self.moving.members[*node].is_wall());
        let ahead = |node: usize, of: usize| travel.opening_at([node, of], instant).velocity;
        let (first, last) = (nodes[0], nodes[nodes.len() - 1]);
        let velocity = |node: usize| match wall {
            Some(wall) => ahead(node, wall),
            None => 0.5 * (ahead(node, first) + ahead(node, last)),
        };
        nodes.iter().copied().map(velocity).collect()
    }
}

/// Moves everything that is connected, directly or indirectly, from the others to the found ones; `look` may end the search.
fn hang<T>(
    found: &mut Vec<T>,
    mut others: Vec<T>,
    hangs: impl Fn(&T, &T) -> bool,
    look: impl Fn() -> Result<(), RunError>,
) -> Result<(), RunError> {
    let mut index = 0;
    while let Some(one) = found.get(index) {
        look()?;
        let (joined, apart): (Vec<_>, Vec<_>) = others.into_iter().partition(|other| hangs(one, other));
        found.extend(joined);
        others = apart;
        index += 1;
    }
    Ok(())
}

/// The floors that carry both points of a pair.
fn floors(contact: &PairState) -> impl Iterator<Item = usize> {
    contact.relation.pushes().map(|(floor, _)| floor)
}

impl PairState {
    /// Changes the rate by a jump; a compliant pair may change its phase.
    pub(super) fn push(&mut self, jump: f64) {
        self.rate += jump;
        if matches!(self.join, Join::Touching(_)) && jump.abs() > 0.0 {
            self.join = Join::Touching(self.phase());
        }
    }
}
