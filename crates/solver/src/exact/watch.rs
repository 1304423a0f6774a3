//! The search for the first event of a piece.

use crate::exact::columns::{Branch, LoadingLine};
use crate::exact::contact::{Join, OnSlope, PairState, Phase};
use crate::exact::link_laws::Change;
use crate::exact::member::Member;
use crate::exact::{ExactRun, Touching, rounding};
use crate::roots::{CAPACITY, LOST, SHORTEST_WAY, first_root};
use crate::span::Power;
use crate::{Recorder, RunError};

/// Events that end a piece, besides the samples of the record and the reach of the series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Event {
    /// The velocity of a node on the ground is zero: yielding ends.
    Turn(usize),
    /// The rate of the drift of a storey above the ground is zero: its yielding ends.
    TurnOfDrift(usize),
    /// A node begins to yield.
    Yield(usize, Branch),
    /// The elastic part of the drift of a node with smooth columns changes sign.
    Cross(usize),
    /// The storey of a node falls under gravity.
    Fall,
    /// The net pounding force on a node changes sign.
    Balance(usize),
    /// The net pounding force on a node has an extremum.
    Extremum(usize),
    /// The pounding force of a pair has an extremum.
    Peak(usize),
    /// The contact force of a pair at rest fades.
    Fade(usize),
    /// The rate of deformation of a pair changes sign.
    Reversal(usize),
    /// The deformation of a pair passes to the other slope of its law.
    Bend(usize),
    /// The law of a pair begins to pull.
    Clamp(usize),
    /// The law of a pair that pulled pushes again.
    Grip(usize),
    /// A pair parts.
    Part(usize),
    /// The friction that holds a node has an extremum.
    PeakOfFriction(usize),
    /// Something changes in a link.
    Link(usize, Change),
}

impl Event {
    /// Whether a floor that sticks lets go.
    pub(super) fn lets_go(&self, members: &[Member]) -> bool {
        matches!(self, Self::Yield(node, _) if members[*node].stick.is_some())
    }

    /// Whether the event concerns pounding forces only: fading, a change of sign or an extremum.
    pub(super) fn is_of_forces(&self) -> bool {
        matches!(self, Self::Fade(_) | Self::Balance(_) | Self::Extremum(_) | Self::Peak(_))
    }
}

/// The search for the first event of a piece.
pub(super) struct Watch {
    /// Time since the start of the run \[s\]. Its rounding could find the same zero again.
    pub(super) start: f64,
    pub(super) power: Power,
    /// Length of the search. Every search covers all of it, so that an event does not depend on the order of searches.
    pub(super) reach: f64,
    /// Length to the first event so far, or the reach.
    pub(super) length: f64,
    /// Events at this length.
    pub(super) events: Vec<Event>,
}

impl Watch {
    /// Searches for a rise of the polynomial with these coefficients through zero.
    pub(super) fn rise(&mut self, len: usize, coefficient: impl Fn(usize) -> f64, event: Event) {
        let mut polynomial = [0.0; CAPACITY];
        for (n, place) in polynomial[..len].iter_mut().enumerate() {
            *place = coefficient(n);
        }
        if let Some(x) = first_root(&polynomial[..len], self.reach) {
            self.take(x, event);
        }
    }

    /// Searches for a change of sign. A zero that is `known` to be at the start does not count.
    pub(super) fn change_of(&mut self, len: usize, known: bool, coefficient: impl Fn(usize) -> f64, event: Event) {
        let mut polynomial = [0.0; CAPACITY];
        for (n, place) in polynomial[..len].iter_mut().enumerate() {
            *place = coefficient(n);
        }
        let polynomial = &mut polynomial[..len];
        if known {
            polynomial[0] = 0.0;
        }
        let begins_at_zero = polynomial.first() == Some(&0.0);
        while let Some(leading) = polynomial.iter().position(|c| *c != 0.0) {
            let sign = -polynomial[leading].signum();
            for coefficient in polynomial.iter_mut() {
                *coefficient *= sign;
            }
            let Some(x) = first_root(polynomial, self.reach) else {
                return;
            };
            let after = self.power.time(x);
            // Near 0 s the clock resolves any two instants.
            let at_start = after < SHORTEST_WAY || self.start + after <= self.start;
            if !(begins_at_zero && at_start) {
                self.take(x, event);
                return;
            }
            // This is the same zero again: the distance between the two is rounding.
            polynomial[leading] = 0.0;
        }
    }

    fn take(&mut self, x: f64, event: Event) {
        if x > self.length {
            return;
        }
        if x < self.length {
            self.events.clear();
        }
        self.length = x;
        self.events.push(event);
    }
}

impl Touching<'_> {
    fn watch_pair(&self, watch: &mut Watch, pair: usize, len: usize) {
        let contact = &self.contacts[pair];
        let slope = |n: usize| (n + 1) as f64 * contact.force[n + 1];
        watch.change_of(len - 1, contact.peaked, slope, Event::Peak(pair));
        match contact.join {
            Join::Apart => {}
            Join::Resting => {
                // A force that has just faded and grows again starts at zero, not at its rounding.
                let known = |n: usize| n == 0 && contact.faded;
                let pull = |n: usize| if known(n) { 0.0 } else { -contact.force[n] };
                watch.rise(len, pull, Event::Fade(pair));
            }
            Join::Touching(Phase::Approach) => {
                watch.rise(len, |n| -contact.rates[n], Event::Reversal(pair));
            }
            Join::Touching(phase) => {
                if phase == Phase::Clamped {
                    watch.rise(len, |n| contact.pull[n], Event::Grip(pair));
                } else {
                    watch.rise(len, |n| contact.rates[n], Event::Reversal(pair));
                }
                if phase == Phase::Restitution && contact.can_pull() {
                    watch.rise(len, |n| -contact.pull[n], Event::Clamp(pair));
                }
                watch.rise(len, |n| -contact.deformations[n], Event::Part(pair));
            }
        }
        if let (Join::Touching(_), Some(form)) = (contact.join, contact.form)
            && form.second.is_some()
        {
            // Just after the event the distance is rounding.
            let at_bend = contact.way_beyond(&form, 0).abs() <= rounding::OF_SUMS * contact.scale;
            let side = if contact.slope == OnSlope::Second { -1.0 } else { 1.0 };
            let way = |n: usize| {
                if n == 0 && at_bend {
                    0.0
                } else {
                    side * contact.way_beyond(&form, n)
                }
            };
            watch.rise(len, way, Event::Bend(pair));
        }
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Finds the first event of a piece.
    pub(super) fn watch(&self, watch: &mut Watch, first: usize, len: usize, time: f64) -> Result<(), RunError> {
        let group = self.touching.groups.of(first);
        for &node in group.nodes() {
            let member = &self.moving.members[node];
            if member.is_wall() {
                continue;
            }
            self.agenda.guard.wait(time)?;
            if self.unloads_from(node) {
                watch.change_of(len, false, |n| member.velocity[n], Event::Turn(node));
            }
            watch_columns(watch, node, member, len);
            member.watch_friction(watch, node, len);
            if self.touching.joined_at(node).nth(1).is_some() {
                let pushed = |n: usize, on_left: bool| self.touching.pushed(node, on_left, |contact| contact.force[n]).unwrap_or(0.0);
                let net = |n: usize| pushed(n, false) - pushed(n, true);
                watch.change_of(len, member.balanced, net, Event::Balance(node));
                let slope = |n: usize| (n + 1) as f64 * net(n + 1);
                watch.change_of(len - 1, member.peaked, slope, Event::Extremum(node));
            }
        }
        for &link in group.links() {
            self.agenda.guard.wait(time)?;
            let order = watch.power.order();
            self.moving.links[link].watch(watch, link, &self.moving.members, order, len);
        }
        for pair in group.pairs() {
            self.agenda.guard.wait(time)?;
            self.touching.watch_pair(watch, *pair, len);
        }
        Ok(())
    }

    /// Whether the columns of a floor on the ground, or of a floor that shares its velocity, unload when it turns.
    fn unloads_from(&self, leader: usize) -> bool {
        let mut on_ground = self
            .touching
            .led_by(leader)
            .filter(|node| self.moving.members[*node].storey.is_none());
        on_ground.any(|node| self.moving.members[node].unloads())
    }

    /// Applies the effect of an event.
    pub(super) fn apply(&mut self, event: Event, time: f64) {
        match event {
            Event::Turn(leader) => {
                for node in leader..self.touching.led_by(leader).end {
                    if self.moving.members[node].storey.is_none() {
                        self.moving.members[node].go_on(Branch::Elastic);
                    }
                }
            }
            Event::TurnOfDrift(node) => {
                let member = &mut self.moving.members[node];
                member.go_on(Branch::Elastic);
                if let Some(storey) = &mut member.storey {
                    storey.still = true;
                }
            }
            // The recorder sees the drift of a fall, and the run ends.
            // The state of a link changes with that of its body.
            Event::Cross(_) | Event::Fall | Event::Link(..) => {}
            Event::Yield(node, branch) => {
                let member = &mut self.moving.members[node];
                member.let_go();
                member.go_on(branch);
                member.line = LoadingLine::Shifted;
            }
            Event::Balance(node) => self.moving.members[node].balanced = true,
            Event::Extremum(node) => self.moving.members[node].peaked = true,
            Event::PeakOfFriction(node) => {
                if let Some(stick) = &mut self.moving.members[node].stick {
                    stick.peaked = true;
                }
            }
            Event::Peak(pair) => self.touching.contacts[pair].peaked = true,
            Event::Fade(pair) => {
                let contact = &mut self.touching.contacts[pair];
                contact.join = Join::Apart;
                contact.faded = true;
                self.lean_no_more(pair);
            }
            Event::Reversal(pair) => {
                let contact = &mut self.touching.contacts[pair];
                contact.rate = 0.0;
                match contact.join {
                    Join::Touching(Phase::Approach) => {
                        contact.join = Join::Touching(Phase::Restitution);
                    }
                    Join::Touching(Phase::Restitution) => {
                        contact.join = Join::Touching(Phase::Approach);
                    }
                    // The remaining deformation is below the tolerance: a new touch may begin.
                    Join::Touching(Phase::Parting | Phase::Clamped) | Join::Apart | Join::Resting => {
                        (contact.join, contact.deformation) = (Join::Apart, 0.0);
                    }
                }
            }
            Event::Bend(pair) => self.touching.contacts[pair].bend(),
            Event::Clamp(pair) => self.touching.contacts[pair].cross(Phase::Clamped),
            Event::Grip(pair) => self.touching.contacts[pair].cross(Phase::Restitution),
            Event::Part(pair) => {
                let contact = &mut self.touching.contacts[pair];
                (contact.join, contact.deformation) = (Join::Apart, 0.0);
                contact.time = time;
            }
        }
    }
}

/// Searches for the instants at which the columns of a node turn, yield, pass through zero, or fall.
fn watch_columns(watch: &mut Watch, node: usize, member: &Member, len: usize) {
    if member.falls_at.is_finite() {
        let drift = member.drift();
        let beyond = |sign: f64| move |n: usize| sign * drift[n] - if n == 0 { member.falls_at } else { 0.0 };
        watch.rise(len, beyond(1.0), Event::Fall);
        watch.rise(len, beyond(-1.0), Event::Fall);
    }
    if let Some(storey) = member.storey.as_ref().filter(|_| member.unloads()) {
        watch.change_of(len, false, |n| storey.rate[n], Event::TurnOfDrift(node));
    }
    if let Some(bend) = &member.bend {
        watch.change_of(len, false, |n| bend.force[n], Event::Cross(node));
    } else if member.branch == Branch::Elastic && member.limit.is_finite() && member.stick.is_none() {
        let drift = member.drift();
        let excess = |sign: f64| {
            move |n: usize| {
                if n == 0 {
                    sign * member.hysteretic_force - member.limit
                } else {
                    sign * (member.hysteretic_stiffness * drift[n])
                }
            }
        };
        watch.rise(len, excess(1.0), Event::Yield(node, Branch::Right));
        watch.rise(len, excess(-1.0), Event::Yield(node, Branch::Left));
    }
}

/// Length up to which the series of a touching pair have converged to the tolerance; `None` if there is no such length. The force of a pair
/// whose sides both stand still changes no rate, and must converge itself.
pub(super) fn reach(contact: &PairState, stands: bool, power: Power, len: usize, length: f64, tolerance: f64) -> Option<f64> {
    if !matches!(contact.join, Join::Touching(_)) {
        return Some(length);
    }
    // Just after a touch the force is small compared with the moving forces, but its sign must be right.
    let lost = match contact.join {
        _ if stands => tolerance,
        Join::Touching(Phase::Approach) => LOST,
        Join::Touching(_) | Join::Apart | Join::Resting => f64::INFINITY,
    };
    let mut x = length;
    loop {
        let (sum, tail) = last_quarter(&contact.rates[..len], x);
        let pushes = || {
            let (sum, tail) = last_quarter(&contact.force[..len], x);
            tail <= lost * sum
        };
        if tail <= tolerance * sum && (lost.is_infinite() || pushes()) {
            return Some(x);
        }
        // A series that still grows at this length is not the series of this motion.
        if power.time(x) < SHORTEST_WAY {
            return (tail <= LOST * sum && (!stands || pushes())).then_some(x);
        }
        x *= 0.85;
    }
}

/// Magnitudes of the terms of a series at x: sums over all of them and over the last quarter.
pub(super) fn last_quarter(series: &[f64], x: f64) -> (f64, f64) {
    let (mut sum, mut tail, mut weight) = (0.0, 0.0, 1.0);
    for (n, coefficient) in series.iter().enumerate() {
        let term = weight * coefficient.abs();
        sum += term;
        if n + series.len() / 4 >= series.len() {
            tail += term;
        }
        weight *= x;
    }
    (sum, tail)
}
