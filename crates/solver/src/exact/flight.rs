//! Free flight of a whole row from sample to sample in closed form, as long as nothing happens.
//!
//! The state of an elastic structure at the next sample follows from its velocity, its force and the ground at this sample, with weights
//! that are computed once per run. Bounds of the motion in between show whether any event is possible. If one is, the pieces of the general
//! method take over until the next sample.

use crate::exact::ExactRun;
use crate::exact::body::in_flight;
use crate::exact::columns::Branch;
use crate::exact::contact::Join;
use crate::exact::landing::Room;
use crate::exact::look_ahead::CARRIED;
use crate::exact::member::Ahead;
use crate::exact::member::Member;
use crate::exact::rounding::weighed;
use crate::{Flight, Path, Recorder, Relation, Span, State};

/// Longest time between two samples, as a part of the reach of the series: a single piece covers it.
pub const LONGEST: f64 = 0.999;

/// Part of the drift at which a storey falls up to which it surely stands \[–\].
const STANDS: f64 = 0.99;

/// Free flights of the structures of a row between two samples.
#[derive(Debug)]
pub(super) struct Flights {
    /// Weights of every structure that stands on the ground, is shaken at t = 0, has columns with a sharp knee, and a period that the
    /// samples resolve; `None` for walls and other structures.
    leaps: Vec<Option<Leap>>,
    /// Whether all structures have weights: the row can then fly as a whole.
    whole: bool,
}

/// The ground between two samples.
#[derive(Debug, Clone, Copy)]
struct Interval {
    /// Instants of the samples \[s\].
    from: f64,
    to: f64,
    /// First sample as time since the start of the run, independent of the clock \[s\].
    origin: f64,
    /// Acceleration at the start \[m/s²\], its slope \[m/s³\], and acceleration at the end.
    value: f64,
    slope: f64,
    last: f64,
}

/// Weights of the flight of a structure between two samples.
#[derive(Debug, Clone, Copy)]
struct Leap {
    /// Change of displacement, and final velocity, per unit of: initial velocity; constant load over mass; load over mass that grows by one
    /// per second.
    displacement: [f64; 3],
    velocity: [f64; 3],
    /// c/m \[1/s\] and k/m \[1/s²\].
    damping: f64,
    stiffness: f64,
    /// Bound of the acceleration in between, relative to its values at both ends and the load.
    growth: f64,
    /// Number of coefficients of the series, down to rounding.
    len: usize,
}

impl Flights {
    pub(super) fn new(members: &[Member], step: f64) -> Self {
        let leap = |member: &Member| {
            let flies = member.plain && at_once(member) && member.fastest_rate * step <= LONGEST;
            (flies && !member.is_wall()).then(|| Leap::new(member, step))
        };
        let leaps: Vec<_> = members.iter().map(leap).collect();
        let mut nodes = members.iter().zip(&leaps);
        Self {
            whole: nodes.all(|(member, leap)| leap.is_some() || (member.is_wall() && at_once(member))),
            leaps,
        }
    }
}

/// Whether the ground motion arrives at t = 0.
fn at_once(member: &Member) -> bool {
    member.arrival.total_cmp(&0.0).is_eq()
}

impl Leap {
    fn new(member: &Member, step: f64) -> Self {
        let len = in_flight(member.fastest_rate * step);
        let by = |velocity: f64, ground: [f64; 2]| {
            let flight = Flight {
                origin: 0.0,
                displacement: 0.0,
                velocity,
                restoring_force: 0.0,
                stiffness: member.tangent(),
                damping: member.damping,
                inverse_mass: member.inverse_mass,
                ground,
                len,
            };
            flight.ends(step)
        };
        let columns = [by(1.0, [0.0; 2]), by(0.0, [1.0, 0.0]), by(0.0, [0.0, 1.0])];
        let damping = member.damping * member.inverse_mass;
        let stiffness = member.tangent().abs() * member.inverse_mass;
        Self {
            displacement: columns.map(|[displacement, _]| displacement),
            velocity: columns.map(|[_, velocity]| velocity),
            damping,
            stiffness,
            // Every instant is at most half a step from one of the ends.
            growth: 1.0 / (1.0 - 0.5 * step * (damping + 0.5 * step * stiffness)),
            len,
        }
    }

    /// The flight of a structure to the next sample; `None` if its columns could yield, or if it could turn more than once.
    #[inline]
    fn ahead(&self, member: &Member, ground: &Interval) -> Option<Ahead> {
        let half = 0.5 * (ground.to - ground.from);
        let start = &member.state;
        let flight = ground.flight(member, self.len);
        let load = ground.value + member.inverse_mass * start.restoring_force;
        let by = |[velocity, constant, growing]: [f64; 3]| velocity * start.velocity + constant * load + growing * ground.slope;
        let (change, velocity) = (by(self.displacement), by(self.velocity));
        let displacement = start.displacement + change;
        let hysteretic_force = member.hysteretic_force_at(displacement, change);
        let restoring_force = member.with_hardening(displacement, hysteretic_force);
        let acceleration = flight.acceleration(velocity, restoring_force, ground.last);
        let before = flight.acceleration(start.velocity, start.restoring_force, ground.value);
        let fastest = start.velocity.abs().max(velocity.abs());
        let load = self.stiffness * fastest + ground.slope.abs();
        let most = self.growth * (before.abs().max(acceleration.abs()) + half * load);
        let jerk = self.damping * most + self.stiffness * (fastest + half * most) + ground.slope.abs();
        // A curve between two ends lies within this factor times its second derivative of the line through them.
        let bow = 0.5 * half * half;
        let held = member.hysteretic_force.abs().max(hysteretic_force.abs()) + bow * member.hysteretic_stiffness * most;
        let slowest = start.velocity.abs().min(velocity.abs());
        let (on, least) = (start.velocity * velocity, before.abs().min(acceleration.abs()));
        let one_way = before * acceleration > 0.0 && least > bow * (self.damping * jerk + self.stiffness * most);
        let known = (on > 0.0 && slowest > bow * jerk) || (on != 0.0 && one_way);
        let farthest = start.displacement.abs().max(displacement.abs()) + bow * most;
        if !(known && held < member.limit && farthest < STANDS * member.falls_at) {
            return None;
        }
        Some(Ahead {
            flight,
            end: ground.to,
            state: State {
                displacement,
                velocity,
                acceleration,
                restoring_force,
                ..State::default()
            },
            hysteretic_force,
            acceleration: most,
        })
    }
}

impl Interval {
    /// The flight of a structure from its present state.
    fn flight(&self, member: &Member, len: usize) -> Flight {
        Flight {
            origin: self.origin,
            displacement: member.state.displacement,
            velocity: member.state.velocity,
            restoring_force: member.state.restoring_force,
            stiffness: member.tangent(),
            damping: member.damping,
            inverse_mass: member.inverse_mass,
            ground: [self.value, self.slope],
            len,
        }
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Flies while nothing happens; returns the instant from which the general method continues.
    pub(super) fn fly(&mut self, mut now: f64) -> f64 {
        let mut flown = false;
        if self.moving.flights.whole && self.flies() {
            while !self.agenda.guard.is_over(self.agenda.spent())
                && let Some(interval) = self.interval_from(now)
                && self.leap(&interval)
            {
                self.land_flights(&interval);
                now = interval.to - self.set_clock(interval.to);
                flown = true;
            }
        }
        if flown {
            self.find_deformations(now);
        }
        now
    }

    /// The ground from the sample at exactly this instant to the next one; `None` if the run ends before it or there is no such sample.
    fn interval_from(&self, time: f64) -> Option<Interval> {
        let sampling = self.shaking.excitation.sampling();
        let step = sampling.step;
        let zero = self.agenda.clock.zero();
        let position = (self.agenda.clock.absolute(time) / step).round();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number >= 0; beyond the last sample there is none"
        )]
        let index = position as usize;
        let (value, last) = match self.shaking.excitation.samples().get(index..index.checked_add(2)?)? {
            [value, last] => (*value, *last),
            _ => return None,
        };
        let [from, to] = [index, index + 1].map(|index| sampling.on_clock(zero, index, 0.0));
        let starts = from.total_cmp(&time).is_eq();
        (starts && to <= self.agenda.end).then(|| Interval {
            from: time,
            to,
            origin: self.agenda.clock.absolute(time),
            value,
            slope: (last - value) / step,
            last,
        })
    }

    /// Whether all structures have landed, elastic and apart. Walls always fly.
    fn flies(&self) -> bool {
        let mut members = self.moving.members.iter().zip(&self.moving.landed);
        let mut contacts = self.touching.contacts.iter();
        members.all(|(member, landed)| *landed != member.is_wall() && member.branch == Branch::Elastic)
            && contacts.all(|contact| contact.join == Join::Apart)
    }

    /// Finds the flights of all structures to the next sample; false if any event could happen.
    fn leap(&mut self, interval: &Interval) -> bool {
        for (member, leap) in self.moving.members.iter_mut().zip(&self.moving.flights.leaps) {
            let Some(leap) = leap else {
                continue;
            };
            member.ahead = leap.ahead(member, interval);
            if member.ahead.is_none() {
                return false;
            }
        }
        let bow = 0.125 * (interval.to - interval.from) * (interval.to - interval.from);
        self.touching.contacts.iter().all(|contact| {
            let Relation { left, right, offset } = contact.relation;
            let at = |end: usize| contact.relation.ahead(|node| self.moving.members[node].way()[end]);
            let most = |node: usize| self.moving.members[node].most();
            let closest = at(0).max(at(1)) - offset + bow * (weighed(left, most) + weighed(right, most));
            closest < -2.0 * CARRIED * contact.scale
        })
    }

    /// Reports the flight of every structure to the next sample and updates its state.
    fn land_flights(&mut self, interval: &Interval) {
        self.agenda.work.events += 1;
        for contact in &mut self.touching.contacts {
            let Relation { left, right, offset } = contact.relation;
            let reach = |node: usize| self.moving.members[node].reach();
            let reach = weighed(left, reach) + weighed(right, reach) + offset;
            contact.scale = contact.scale.max(reach);
        }
        for (structure, member) in self.moving.members.iter_mut().enumerate() {
            let Some(ahead) = member.ahead.take() else {
                continue;
            };
            let (flight, clock) = (ahead.flight, &self.agenda.clock);
            let State {
                velocity, restoring_force, ..
            } = member.state;
            let start = State {
                acceleration: flight.acceleration(velocity, restoring_force, interval.value),
                ..member.state
            };
            self.agenda.work.segments += 1;
            let incidents = self.touching.incidence.at(structure);
            let mut room = Room::default();
            let pushes = room.of(incidents);
            self.recorder.span(&Span {
                structure,
                start_time: clock.absolute(interval.from),
                end_time: clock.absolute(interval.to),
                start,
                end: ahead.state,
                impulse_from_left: 0.0,
                impulse_from_right: 0.0,
                below: None,
                path: Path::Flight(flight),
                pushes,
                links: &[],
            });
            (member.state, member.hysteretic_force) = (ahead.state, ahead.hysteretic_force);
        }
    }

    /// Updates the deformations of all pairs after flights.
    fn find_deformations(&mut self, time: f64) {
        for pair in 0..self.touching.contacts.len() {
            let points = self.touching.contacts[pair].relation.points();
            let sides = points.map(|point| self.motion_of(point, time));
            let (deformation, rate) = self.closing(pair, time, sides);
            let contact = &mut self.touching.contacts[pair];
            (contact.deformation, contact.rate, contact.time) = (deformation, rate, time);
            (contact.faded, contact.peaked) = (false, false);
        }
    }

    /// Finds the flight to the next sample for a body that begins a piece. A structure that flies alone then arrives with the same bits
    /// whatever the others do.
    pub(super) fn look_to_sample(&mut self, first: usize, time: f64) {
        let nodes = self.touching.groups.of(first).nodes();
        let alone = nodes.len() == 1 && self.moving.members[first].branch == Branch::Elastic;
        for node in nodes {
            self.moving.members[*node].ahead = None;
        }
        if let Some(leap) = self.moving.flights.leaps[first].filter(|_| alone)
            && let Some(interval) = self.interval_from(time)
        {
            let member = &mut self.moving.members[first];
            member.ahead = leap.ahead(member, &interval);
        }
    }
}

impl Member {
    /// Displacements at both ends of the flight.
    fn way(&self) -> [f64; 2] {
        let start = self.state.displacement;
        let end = self.ahead.as_ref();
        [start, end.map_or(start, |ahead| ahead.state.displacement)]
    }

    /// Bound of the acceleration during the flight.
    fn most(&self) -> f64 {
        self.ahead.as_ref().map_or(0.0, |ahead| ahead.acceleration)
    }

    /// Magnitude of the displacement at the end of the flight.
    fn reach(&self) -> f64 {
        let end = self.ahead.map_or(self.state, |ahead| ahead.state);
        end.displacement.abs()
    }

    /// The restoring force at a drift, from its hysteretic part.
    pub(super) fn with_hardening(&self, drift: f64, hysteretic_force: f64) -> f64 {
        if self.hardened_stiffness.abs() > 0.0 {
            self.hardened_stiffness * drift + hysteretic_force
        } else {
            hysteretic_force
        }
    }
}
