//! Storeys on the ground that stick and slide under friction.
//!
//! A floor whose storey sticks is held as by a wall: it has no acceleration, whatever pushes it. The friction that holds it follows from
//! the balance of its forces. Where it reaches its limit, the floor slides, and the friction is that limit against the motion. Impulses
//! are larger than any friction, so that an impact finds the floor with its own mass.

use crate::exact::ExactRun;
use crate::exact::columns::{Branch, LoadingLine};
use crate::exact::contact::{Join, PairState};
use crate::exact::groups::Block;
use crate::exact::hits::Hit;
use crate::exact::member::Member;
use crate::exact::rounding::OF_COEFFICIENTS;
use crate::exact::stick::Stick;
use crate::exact::storey::{need, own_force};
use crate::exact::watch::{Event, Watch};
use crate::model::incidence::{Incidence, Incident};
use crate::{Point, Recorder, Relation};

impl Member {
    /// The friction that holds the floor; `None` if the storey slides or is another one.
    pub(super) fn held(&self) -> Option<&Stick> {
        self.stick.as_deref().filter(|_| self.branch == Branch::Elastic)
    }

    /// Whether coefficient `n` of the acceleration is zero: of a wall, of a floor that sticks, and the first of one that begins to slide.
    pub(super) fn stands(&self, n: usize) -> bool {
        self.is_still() || (n == 0 && self.stick.as_ref().is_some_and(|stick| stick.begins))
    }

    /// Forgets that the floor begins to slide without an acceleration.
    pub(super) fn hurry(&mut self) {
        if let Some(stick) = &mut self.stick {
            stick.begins = false;
        }
    }

    /// Forgets, at a later instant, that the floor begins to slide, and that its friction has an extremum.
    pub(super) fn go_by(&mut self) {
        if let Some(stick) = &mut self.stick {
            (stick.begins, stick.peaked) = (false, false);
        }
    }

    /// Lets go of the floor. Unless something new pulls at it, the friction has just reached its limit.
    pub(super) fn let_go(&mut self) {
        let rounding = self.rounding_of_friction();
        let limit = self.limit;
        if let Some(stick) = &mut self.stick {
            stick.begins = stick.force[0].abs() <= limit + rounding;
        }
    }

    fn rounding_of_friction(&self) -> f64 {
        OF_COEFFICIENTS * (self.limit + self.terms.own)
    }

    /// Lets the floor move with its own mass, for an impact.
    fn release(&mut self) {
        if let Some(stick) = &self.stick {
            (self.mass, self.inverse_mass) = (stick.mass, 1.0 / stick.mass);
        }
    }

    /// Sets mass and friction to those of the present branch.
    pub(super) fn stick_or_slide(&mut self) {
        if self.stick.is_none() {
            return;
        }
        self.release();
        self.line = LoadingLine::Shifted;
        match self.branch {
            Branch::Elastic => {
                (self.mass, self.inverse_mass) = (f64::INFINITY, 0.0);
                // Pressed against a neighbour that stands still, it may have the rounding of an impact.
                self.state.velocity = 0.0;
            }
            Branch::Right => self.hysteretic_force = self.limit,
            Branch::Left => self.hysteretic_force = -self.limit,
        }
        self.state.restoring_force = self.with_hardening(self.state.displacement, self.hysteretic_force);
    }

    /// Slides in the direction of the velocity, or sticks if it is zero.
    pub(super) fn slide(&mut self) {
        if self.stick.is_some() {
            self.go_on(match self.state.velocity {
                right if right > 0.0 => Branch::Right,
                left if left < 0.0 => Branch::Left,
                _ => Branch::Elastic,
            });
        }
    }

    /// Stops a floor that only the rounding of an impact of velocities up to `fastest` moves: it would slide to a side that rounding chose, and
    /// pressed against a neighbour push with its own friction.
    pub(super) fn come_to_rest(&mut self, fastest: f64) {
        if self.stick.is_some() && self.state.velocity.abs() <= OF_COEFFICIENTS * fastest {
            self.state.velocity = 0.0;
        }
    }

    /// Continues after an impact. A floor that did not move in it sticks or slides as before: it may be pressed against a neighbour.
    pub(super) fn collide(&mut self, jumped: bool) {
        if jumped {
            self.go_by();
            self.slide();
        } else {
            self.stick_or_slide();
        }
    }

    /// Searches for the instants at which the friction that holds the floor reaches its limit, or has an extremum.
    pub(super) fn watch_friction(&self, watch: &mut Watch, node: usize, len: usize) {
        let Some(stick) = self.held() else {
            return;
        };
        let beyond = |sign: f64| {
            move |n: usize| {
                let force = sign * stick.force[n];
                let excess = if n == 0 { force - self.limit } else { force };
                // At the limit the excess is rounding: the next coefficients decide.
                let rounded = n == 0 && excess.abs() <= self.rounding_of_friction();
                if rounded { 0.0 } else { excess }
            }
        };
        watch.rise(len, beyond(1.0), Event::Yield(node, Branch::Right));
        watch.rise(len, beyond(-1.0), Event::Yield(node, Branch::Left));
        let slope = |n: usize| (n + 1) as f64 * stick.force[n + 1];
        watch.change_of(len - 1, stick.peaked, slope, Event::PeakOfFriction(node));
    }
}

/// Finds coefficient `n` of the friction that holds floors, from the balance of all other forces.
pub(super) fn hold(nodes: &[usize], members: &mut [Member], contacts: &[PairState], incidence: &Incidence, p: usize, n: usize) {
    for &node in nodes {
        let Some(stick) = members[node].held() else {
            continue;
        };
        let joined = |at: &&Incident| contacts[at.pair].join != Join::Apart;
        let push = |at: &Incident| (if at.on_left { -at.part } else { at.part }) * contacts[at.pair].force[n];
        let pushed: f64 = incidence.at(node).iter().filter(joined).map(push).sum();
        let inertia = stick.mass * members[node].ground.coefficient(n, p);
        let force = pushed - own_force(members, node, n) - inertia;
        let member = &mut members[node];
        if n == 0 {
            member.hysteretic_force = force;
            member.state.restoring_force = member.with_hardening(member.state.displacement, force);
        }
        if let Some(stick) = &mut member.stick {
            stick.force[n] = force;
        }
    }
}

/// Finds coefficient `n` of the forces on floors of a chain between two that stand still. The force of one of both sides is open: each bears a
/// half, until one that would pull lets go.
pub(super) fn share_between(members: &[Member], contacts: &mut [PairState], block: &Block, p: usize, n: usize) {
    let mut still = (block.first..=block.last).filter(|node| members[*node].is_still());
    let Some(mut before) = still.next() else {
        return;
    };
    for next in still {
        let whole: f64 = (before + 1..next).map(|node| need(members, node, p, n)).sum();
        let mut force = 0.5 * whole;
        for node in before..next {
            if node > before {
                force -= need(members, node, p, n);
            }
            contacts[block.within + node - block.first].force[n] = force;
        }
        before = next;
    }
}

/// Clears coefficient `n` of the acceleration of a floor that rests against one that stands still: its rounding would make it stick and let
/// go in turn.
pub(super) fn press(contact: &PairState, members: &mut [Member], n: usize) {
    let Relation {
        left: Point::Floor(left),
        right: Point::Floor(right),
        ..
    } = contact.relation
    else {
        return;
    };
    for (one, other) in [(left, right), (right, left)] {
        if members[one].is_still() && members[other].stick.is_some() && !contact.opens() {
            members[other].acceleration[n] = 0.0;
        }
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Lets floors of a pair stick that slid against each other and no longer press: their friction would push the next neighbour.
    pub(super) fn lean_no_more(&mut self, pair: usize) {
        for node in self.touching.contacts[pair].floors() {
            let member = &mut self.moving.members[node];
            if member.stick.is_some() && member.state.velocity == 0.0 {
                member.go_on(Branch::Elastic);
            }
        }
    }

    /// Stops floors that an impact leaves against others that stand still, without the rounding of the flight before.
    pub(super) fn stop_against_still(&mut self, hits: &[Hit]) {
        if self.moving.members.iter().all(|member| member.stick.is_none()) {
            return;
        }
        let (members, contacts) = (&mut self.moving.members, &self.touching.contacts);
        let mut stopped = Vec::new();
        let mut grown = true;
        while grown {
            grown = false;
            for contact in hits.iter().flat_map(|hit| &hit.pairs).map(|pair| &contacts[*pair]) {
                let (Point::Floor(left), Point::Floor(right)) = (contact.relation.left, contact.relation.right) else {
                    continue;
                };
                let still = [left, right].map(|node| members[node].state.velocity == 0.0 || stopped.contains(&node));
                if contact.rate == 0.0 && !contact.opens() && still[0] != still[1] {
                    stopped.push(if still[0] { right } else { left });
                    grown = true;
                }
            }
        }
        for node in stopped {
            if members[node].stick.is_some() {
                members[node].state.velocity = 0.0;
            }
        }
    }

    /// Lets the floors of impacts move with their own masses.
    pub(super) fn release(&mut self, hits: &[Hit]) {
        for node in hits.iter().flat_map(|hit| &hit.nodes) {
            self.moving.members[*node].release();
        }
    }
}
