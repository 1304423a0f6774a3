//! Chains of impulsive pairs that touch at one instant.

use std::ops::Range;

use crate::exact::contact::{Contact, Gap, Link};
use crate::exact::member::Member;
use crate::exact::{BURST, CHATTER, Run};
use crate::{Recorder, RunError};

/// A chain of impulsive pairs that touch at one instant.
pub(super) struct Hit {
    /// The first and the last pair.
    pub(super) first: usize,
    pub(super) last: usize,
    /// The leftmost node.
    pub(super) left: usize,
    /// Velocities of the grounds of the nodes where they move at different times, relative to that of a wall or else to
    /// the mean of the first and the last; empty where they move alike.
    pub(super) carried: Vec<f64>,
    /// Velocities of the nodes and rates of the pairs before.
    pub(super) before: Vec<f64>,
    pub(super) rates: Vec<f64>,
    /// Pairs that were at rest until now.
    pub(super) rested: Vec<bool>,
    /// Pairs that are closed without a rate, and open.
    pub(super) parts: Vec<bool>,
    /// Pairs that come to rest instead of bouncing on.
    pub(super) plastic: Vec<bool>,
    /// Impulse of every pair.
    pub(super) impulses: Vec<f64>,
}

impl Hit {
    /// The pair at the second of two walls of the chain whose grounds move towards each other: there is no room for what
    /// touches both.
    pub(super) fn closed_in(&self, members: &[Member]) -> Option<usize> {
        let mut before: Option<f64> = None;
        for (index, carried) in self.carried.iter().enumerate() {
            if !members[self.left + index].is_wall() {
                continue;
            }
            if before.is_some_and(|before| before > *carried) {
                return Some(self.first + index - 1);
            }
            before = Some(*carried);
        }
        None
    }

    /// Whether a pair goes on resting: both sides keep their velocities to the last bit, and what is known of them, such as
    /// that one of them passes zero.
    pub(super) fn rests_on(&self, pair: usize, members: &[Member]) -> bool {
        let index = pair - self.first;
        let keeps = |side: usize| {
            let velocity = members[self.left + side].state.velocity;
            velocity.total_cmp(&self.before[side]).is_eq()
        };
        self.rested[index] && keeps(index) && keeps(index + 1)
    }
}

impl<R: Recorder> Run<'_, R> {
    /// The chain that begins with a pair, and those after it that share a building with it, or with one that does.
    pub(super) fn hits_with(&self, pair: usize, time: f64) -> Result<Vec<Hit>, RunError> {
        self.guard.wait(time)?;
        let hit = self.hit(pair, time);
        let mut next = hit.last + 1;
        let mut hits = vec![hit];
        if self.members.iter().all(|member| member.storey.is_none()) {
            return Ok(hits);
        }
        let mut others = Vec::new();
        while next < self.contacts.len() {
            if !self.settled[next] && self.hits(next, time) {
                let hit = self.hit(next, time);
                next = hit.last;
                others.push(hit);
            }
            next += 1;
        }
        let mut index = 0;
        while let Some(hit) = hits.get(index) {
            self.guard.wait(time)?;
            let (joined, apart): (Vec<_>, Vec<_>) = others
                .into_iter()
                .partition(|other| self.share_a_building(hit, other));
            hits.extend(joined);
            others = apart;
            index += 1;
        }
        hits.sort_by_key(|hit| hit.first);
        Ok(hits)
    }

    /// The chain of touching pairs that begins with a pair.
    fn hit(&self, first: usize, time: f64) -> Hit {
        let mut last = first;
        while last + 1 < self.contacts.len()
            && self.lefts[last + 1] == self.lefts[last] + 1
            && self.hits(last + 1, time)
        {
            last += 1;
        }
        let contacts = &self.contacts[first..=last];
        let soon = |contact: &Contact| time - contact.hit < CHATTER;
        let rests = |contact: &Contact| contact.link == Link::Resting;
        // A floor that two neighbours hit in turn rests against one of them: all that this series would still give the other pair is
        // given at once.
        let caught = |index: usize| {
            let beside = [index.checked_sub(1), Some(index + 1)];
            let mut beside = beside
                .into_iter()
                .flatten()
                .filter_map(|other| contacts.get(other));
            beside.any(|other| rests(other) && soon(other))
        };
        let stops = |(index, contact): (usize, &Contact)| {
            soon(contact) && (contact.burst >= BURST || caught(index))
        };
        let parts = |contact: &Contact| contact.gap == Gap::Parts;
        let left = self.lefts[first];
        let members = &self.members[left..=self.lefts[last] + 1];
        Hit {
            first,
            last,
            left,
            carried: self.carried(left..self.lefts[last] + 2, time),
            before: members.iter().map(|member| member.state.velocity).collect(),
            rates: contacts.iter().map(|contact| contact.rate).collect(),
            rested: contacts.iter().map(rests).collect(),
            parts: contacts.iter().map(parts).collect(),
            plastic: contacts.iter().enumerate().map(stops).collect(),
            impulses: vec![0.0; contacts.len()],
        }
    }

    /// Velocities of the grounds of a chain, relative to one of them.
    fn carried(&self, nodes: Range<usize>, time: f64) -> Vec<f64> {
        let Some(travel) = &self.travel else {
            return Vec::new();
        };
        let instant = self.clock.past(time).instant();
        let wall = nodes.clone().find(|node| self.members[*node].is_wall());
        let ahead = |node: usize, of: usize| travel.opening_at([node, of], instant).velocity;
        let (first, last) = (nodes.start, nodes.end - 1);
        let velocity = |node: usize| match wall {
            Some(wall) => ahead(node, wall),
            None => 0.5 * (ahead(node, first) + ahead(node, last)),
        };
        nodes.map(velocity).collect()
    }

    fn share_a_building(&self, a: &Hit, b: &Hit) -> bool {
        let buildings = |hit: &Hit| &self.buildings[hit.left..hit.left + hit.before.len()];
        buildings(a)
            .iter()
            .any(|building| buildings(b).contains(building))
    }

    /// Whether an impulsive pair touches now.
    pub(super) fn hits(&self, pair: usize, time: f64) -> bool {
        self.contacts[pair].restitution().is_some() && self.touches_now(pair, time)
    }
}

impl Contact {
    /// Changes the rate by a jump; a compliant pair may turn from one phase to the other.
    pub(super) fn push(&mut self, jump: f64) {
        self.rate += jump;
        if matches!(self.link, Link::Touching(_)) && jump.abs() > 0.0 {
            self.link = Link::Touching(self.phase());
        }
    }
}
