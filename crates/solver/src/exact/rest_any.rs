//! Decision between rest and parting in a row that is no chain.
//!
//! Let c be the accelerations of touching points towards each other as series in time, for pairs without a rate, and F their forces. Then 0
//! ≤ F ⟂ −c ≥ 0 with c = c₀ − W F, decided by the first nonzero coefficient. The coefficients are treated in turn. A pair that presses
//! keeps c = 0 afterwards. A pair that parts leaves the problem. A pair that is still open goes on to the next coefficient. Pairs that stay
//! open stay together without a force.

use crate::exact::ExactRun;
use crate::exact::contact::{Gap, Join, System};
use crate::exact::hits::Hit;
use crate::exact::rest::OF_ACCELERATION;
use crate::exact::rounding::OF_COEFFICIENTS;
use crate::exact::tie;
use crate::impact::dense::ClosedIn;
use crate::impact::dense::basis::Basis;
use crate::{Recorder, RunError};

/// Decision of a coefficient about a pair.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Decision {
    Presses,
    Parts,
    Open,
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Puts pairs at rest or parts them.
    pub(super) fn rest_or_part_any(&mut self, hit: &Hit, time: f64) -> Result<(), RunError> {
        for pair in &hit.pairs {
            let contact = &mut self.touching.contacts[*pair];
            (contact.join, contact.idle, contact.gap) = (Join::Apart, false, Gap::Known);
        }
        let without_rate = hit.pairs.iter().filter(|pair| self.touching.contacts[**pair].rate == 0.0);
        let mut open: Vec<_> = without_rate.copied().collect();
        let (mut pressing, mut from) = (Vec::new(), 0);
        loop {
            self.regroup();
            self.expand_landed(time)?;
            let known = pressing.len();
            while known == pressing.len()
                && let Some(order) = self.next_order(&open, from)
            {
                self.agenda.guard.wait(time)?;
                from = order + 1;
                let decisions = self
                    .decide(&open, &pressing, order)
                    .map_err(|pair| self.touching.closed_in(pair, time))?;
                for (pair, decision) in open.iter().zip(&decisions) {
                    let contact = &mut self.touching.contacts[*pair];
                    match decision {
                        Decision::Presses => {
                            contact.join = Join::Resting;
                            pressing.push(*pair);
                        }
                        Decision::Parts => {
                            contact.gap = Gap::Parts;
                            // A fading force leaves no acceleration of this kind.
                            contact.faded &= order > OF_ACCELERATION;
                        }
                        Decision::Open => {}
                    }
                }
                let mut left = decisions.iter();
                open.retain(|_| left.next() == Some(&Decision::Open));
            }
            if known == pressing.len() {
                break;
            }
        }
        self.let_idle(&open, &pressing);
        self.regroup();
        self.pull(hit, time);
        Ok(())
    }

    /// The first coefficient from `from` on that rounding does not hide for all of these pairs.
    fn next_order(&self, open: &[usize], from: usize) -> Option<usize> {
        let first = |pair: &usize| {
            let mut orders = self.orders(*pair).filter(|order| *order >= from);
            orders.find(|order| self.closing_by(*pair, *order).0 != 0.0)
        };
        open.iter().filter_map(first).min()
    }

    /// Decisions of a coefficient about open pairs, given the pairs that press. A pair without room to move is an error.
    fn decide(&mut self, open: &[usize], pressing: &[usize], order: usize) -> Result<Vec<Decision>, usize> {
        let closing = open.iter().map(|pair| self.closing_by(*pair, order));
        let closing: Vec<_> = closing.collect();
        let system = System {
            members: &self.moving.members,
            contacts: &self.touching.contacts,
            incidence: self.touching.incidence,
        };
        let problem = &mut self.touching.rounds.problem;
        let all: Vec<_> = open.iter().chain(pressing).copied().collect();
        let floors = tie::floors(&all, system.contacts);
        let mut held = Basis::new(pressing.len(), floors.len());
        for pair in pressing {
            held.take(&tie::column(*pair, &floors, system));
        }
        let opens = all.iter().any(|pair| system.contacts[*pair].opens());
        let mut decisions = vec![Decision::Open; open.len()];
        let mut asked = Vec::with_capacity(open.len());
        problem.begin(floors.len(), 0);
        for (index, (pair, (value, noise))) in open.iter().zip(&closing).enumerate() {
            if !held.express(&tie::column(*pair, &floors, system)) {
                // Pairs that press hold it, unless their grounds move.
                if system.contacts[*pair].opens() && *value > 0.0 {
                    return Err(*pair);
                }
                if system.contacts[*pair].opens() && *value < 0.0 {
                    decisions[index] = Decision::Parts;
                }
                continue;
            }
            // A force that has just faded does not count yet.
            let fades = system.contacts[*pair].faded && order == OF_ACCELERATION;
            let demand = if fades { f64::NEG_INFINITY } else { *value };
            problem.push(held.rest().iter().copied().enumerate());
            problem.ask(asked.len(), demand, noise / OF_COEFFICIENTS);
            asked.push(index);
        }
        while let Err(ClosedIn { contact }) = problem.solve() {
            // On a common ground only rounding can leave no room.
            if opens {
                return Err(open[asked[contact]]);
            }
            problem.ask(contact, f64::NEG_INFINITY, 0.0);
        }
        for ((contact, impulse), index) in problem.impulses().enumerate().zip(&asked) {
            let ((value, noise), taken) = (closing[*index], problem.taken(contact));
            let rounding = noise + OF_COEFFICIENTS * (value.abs() + taken.abs());
            decisions[*index] = if impulse > 0.0 {
                Decision::Presses
            } else if taken - value > rounding {
                Decision::Parts
            } else {
                Decision::Open
            };
        }
        Ok(decisions)
    }

    /// Keeps pairs together that neither press nor part. Pairs that others hold carry no force.
    fn let_idle(&mut self, open: &[usize], pressing: &[usize]) {
        let system = System {
            members: &self.moving.members,
            contacts: &self.touching.contacts,
            incidence: self.touching.incidence,
        };
        let all: Vec<_> = pressing.iter().chain(open).copied().collect();
        let floors = tie::floors(&all, system.contacts);
        let mut held = Basis::new(all.len(), floors.len());
        let depends = |pair: &usize| !held.take(&tie::column(*pair, &floors, system));
        let idle: Vec<_> = all.iter().map(depends).collect();
        let idle = &idle[pressing.len()..];
        for (pair, idle) in open.iter().zip(idle) {
            let contact = &mut self.touching.contacts[*pair];
            (contact.join, contact.idle) = (Join::Resting, *idle);
            if *idle {
                contact.force.fill(0.0);
            }
        }
    }

    /// Removes the rounded rates of pairs that have come to rest, with the least change of energy.
    fn pull(&mut self, hit: &Hit, time: f64) {
        let pairs = hit.pairs.iter().enumerate();
        let mut resting = pairs.filter(|(_, pair)| self.touching.contacts[**pair].join == Join::Resting);
        if resting.all(|(index, pair)| hit.rests_on(index, &self.touching.contacts[*pair], &self.moving.members)) {
            return;
        }
        let floors = hit.pairs.iter().map(|pair| self.touching.contacts[*pair].floors()[0]);
        let mut bodies: Vec<_> = floors.map(|floor| self.touching.groups.body_of[floor]).collect();
        bodies.sort_unstable();
        bodies.dedup();
        for first in bodies {
            let Some(tie) = self.touching.groups.of(first).tie() else {
                continue;
            };
            let rate = |pair: &usize| {
                let contact = &self.touching.contacts[*pair];
                let faster = contact.relation.ahead(|node| self.moving.members[node].state.velocity);
                let opening = self.opening(*pair, time);
                opening.map_or(faster, |opening| faster + opening.velocity)
            };
            let mut impulses: Vec<_> = tie.pairs.iter().map(rate).collect();
            tie.solve(&mut impulses);
            for (pair, impulse) in tie.pairs.iter().zip(impulses) {
                self.touching.contacts[*pair].kick(impulse, &mut self.moving.members);
            }
        }
    }
}
