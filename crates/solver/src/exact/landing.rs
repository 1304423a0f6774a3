//! Landing: the end of a piece, with its report and the new states.

use crate::exact::body::{Body, pushing};
use crate::exact::columns::Branch;
use crate::exact::contact::{Join, PairState};
use crate::exact::links::LinkState;
use crate::exact::member::{Ahead, Member};
use crate::exact::watch::Event;
use crate::exact::{ExactRun, Touching};
use crate::model::incidence::Incident;
use crate::roots::CAPACITY;
use crate::span::{Power, Series, rise, value};
use crate::{Motion, Path, Push, Recorder, Span, State};

impl Touching<'_> {
    /// Whether two points touch or rest without a gap and each moves with a single floor: if either floor is at zero, both are.
    fn touches_without_gap(&self, pair: usize, time: f64) -> bool {
        let contact = &self.contacts[pair];
        let touches = match contact.join {
            Join::Apart => contact.meets <= time,
            Join::Resting => true,
            Join::Touching(_) => false,
        };
        let impulsive = contact.restitution().is_some() && !contact.opens();
        let mut points = contact.relation.points().into_iter();
        contact.relation.offset == 0.0 && impulsive && touches && points.all(|point| point.parts().nth(1).is_none())
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Ends the piece of a body now: reports its spans and updates its state.
    pub(super) fn land(&mut self, first: usize, time: f64) {
        if self.moving.landed[first] {
            return;
        }
        let body = &self.moving.bodies[first];
        let now = self.agenda.clock.past(time);
        let (x, full) = (body.position(now), time >= body.end);
        let advanced = now.since(body.start) > 0.0;
        // A value that an event set to zero at the start stays known until the clock of the recorders has advanced.
        let later = now.absolute() > body.start.absolute();
        for place in self.touching.groups.nodes_of(first) {
            self.moving.landed[self.touching.groups.node(place)] = true;
        }
        for place in self.touching.groups.around(first) {
            self.carry_deformation(self.touching.groups.pair(place), time);
        }
        let events = std::mem::take(&mut self.moving.bodies[first].events);
        // From the ground up: the report of a floor contains the motion of the floor below, whose state must be new.
        for place in self.touching.groups.nodes_of(first) {
            let node = self.touching.groups.node(place);
            let ahead = self.moving.members[node].ahead;
            let at_wall = advanced && self.hits_wall_at_zero(node, time);
            let arrives = |ahead: &Ahead| full && time >= ahead.end && events.is_empty() && !at_wall;
            let (end, hysteretic) = match ahead.filter(arrives) {
                Some(ahead) => (ahead.state, ahead.hysteretic_force),
                None => self.end_state(node, x, at_wall, if full { &events } else { &[] }),
            };
            if advanced {
                self.report(node, first, time, x, end);
            }
            if later {
                let member = &mut self.moving.members[node];
                (member.balanced, member.peaked) = (false, false);
                member.go_by();
                if let Some(storey) = &mut member.storey {
                    storey.still = false;
                }
            }
            let member = &mut self.moving.members[node];
            (member.state, member.hysteretic_force) = (end, hysteretic);
        }
        self.land_links(first, x, later, if full { &events } else { &[] });
        for place in self.touching.groups.around(first) {
            self.refresh_deformation(self.touching.groups.pair(place), time);
        }
        if full {
            for event in &events {
                self.apply(*event, time);
            }
        }
        for place in self.touching.groups.around(first) {
            let pair = self.touching.groups.pair(place);
            // A pair that another event ends just behind the parting has parted. Its force would be a power of a negative number.
            if self.touching.contacts[pair].has_parted() {
                self.apply(Event::Part(pair), time);
            }
        }
        self.moving.bodies[first].events = events;
    }

    /// Whether a node now hits a wall without a gap, directly or through neighbours without gaps. It does so at displacement zero: a
    /// rounded displacement would move it later, when nothing else does.
    fn hits_wall_at_zero(&self, node: usize, time: f64) -> bool {
        if self.moving.walls == 0 {
            return false;
        }
        // No allocation if the node touches nobody.
        let (mut met, mut next) = (Vec::new(), Some(node));
        let mut looked = 0;
        while let Some(node) = next {
            for at in self.touching.incidence.at(node) {
                let floors = self.touching.contacts[at.pair].floors();
                let other = if at.on_left { floors[1] } else { floors[0] };
                if self.touching.touches_without_gap(at.pair, time) && !met.contains(&other) {
                    met.push(other);
                }
            }
            next = met.get(looked).copied();
            looked += 1;
        }
        met.into_iter().any(|met| self.moving.members[met].is_wall())
    }

    /// State of a node at the end of its piece (displacement zero if `at_wall`), and the hysteretic part of its force. The nodes below
    /// already have theirs.
    fn end_state(&self, node: usize, x: f64, at_wall: bool, events: &[Event]) -> (State, f64) {
        let body = &self.moving.bodies[self.touching.groups.body_of[node]];
        let (member, len) = (&self.moving.members[node], body.len);
        let force = |on_left| {
            let force = |contact: &PairState| pushing(value(&contact.force[..len], x));
            self.touching.pushed(node, on_left, force).unwrap_or(0.0)
        };
        let mut end = State {
            displacement: if at_wall {
                0.0
            } else {
                member.displacement[0] + rise(&member.displacement[..len], x)
            },
            velocity: value(&member.velocity[..len], x),
            acceleration: value(&member.acceleration[..len], x),
            restoring_force: 0.0,
            force_from_left: force(false),
            force_from_right: -force(true),
        };
        let drift = match &member.storey {
            None => end.displacement,
            Some(storey) => end.displacement - self.moving.members[storey.below].state.displacement,
        };
        let mut hysteretic = member.hysteretic_end(drift, len, x);
        for event in events {
            if matches!(*event, Event::Turn(turning) if turning == self.touching.leader(node)) {
                end.velocity = 0.0;
            }
            if *event == Event::Cross(node) {
                hysteretic = 0.0;
            }
            if let Event::Yield(yielding, branch) = *event
                && yielding == node
            {
                hysteretic = match branch {
                    Branch::Left => -member.limit,
                    Branch::Right | Branch::Elastic => member.limit,
                };
            }
        }
        end.restoring_force = member.with_hardening(drift, hysteretic);
        (end, hysteretic)
    }

    fn report(&mut self, node: usize, first: usize, time: f64, x: f64, end: State) {
        let body = &self.moving.bodies[first];
        let member = &self.moving.members[node];
        let (tangent, bent) = match (&member.bend, member.held()) {
            (None, None) => (member.tangent(), &[][..]),
            (None, Some(stick)) => (member.tangent(), &stick.force[..body.len]),
            (Some(bend), _) => (member.hardened_stiffness, &bend.force[..body.len]),
        };
        let storey = member.storey.as_ref();
        let below = storey.map(|storey| &self.moving.members[storey.below]);
        let (start_time, end_time) = (body.start.absolute(), self.agenda.clock.absolute(time));
        let mut room = Room::default();
        let incidents = self.touching.incidence.at(node);
        let pushes = room.of(incidents);
        for push in pushes.iter_mut() {
            let contact = &self.touching.contacts[push.pair];
            if contact.join != Join::Apart {
                contact.pushes(push, body, x);
            }
        }
        let mut linked = Room::default();
        let links = linked.of(self.moving.linking.at(node));
        for push in links.iter_mut() {
            self.moving.links[push.pair].pushes(push, body, x);
        }
        // Used only if several pairs push.
        let [left, right] = &mut [None, None];
        let (left, right) = (side(pushes, false, left), side(pushes, true, right));
        let span = Span {
            structure: node,
            start_time,
            end_time,
            start: member.state,
            end,
            impulse_from_left: impulse(pushes, false),
            impulse_from_right: -impulse(pushes, true),
            below: below.map(Member::ends),
            path: match &member.ahead {
                Some(ahead) => Path::Flight(ahead.flight),
                None => Path::Series(Series {
                    origin: start_time,
                    power: body.power,
                    end: x,
                    displacement: &member.displacement[..body.len],
                    velocity: &member.velocity[..body.len],
                    acceleration: &member.acceleration[..body.len],
                    below: below.map(|below| [&below.displacement[..body.len], &below.velocity[..body.len]]),
                    restoring_force: (member.state.restoring_force, tangent),
                    bent,
                    force_from_left: left,
                    force_from_right: right,
                }),
            },
            pushes,
            links,
        };
        self.recorder.span(&span);
    }

    /// Takes the states of links at x, the end of a piece, and changes their branches.
    fn land_links(&mut self, first: usize, x: f64, later: bool, events: &[Event]) {
        let len = self.moving.bodies[first].len;
        for place in self.touching.groups.links_of(first) {
            let link = self.touching.groups.link(place);
            self.moving.links[link].land(len, x, later);
        }
        for event in events {
            if let Event::Link(link, change) = *event {
                self.moving.links[link].change(change, len, x);
            }
        }
    }
}

impl PairState {
    /// Writes the action of the pair from the start of a piece of its body to x.
    fn pushes<'a>(&'a self, push: &mut Push<'a>, body: &Body, x: f64) {
        let series = &self.force[..body.len];
        push.forces = [pushing(series[0]), pushing(value(series, x))];
        push.impulse = integral(series, body.power, x);
        push.series = series;
    }
}

impl LinkState {
    /// Writes the action of the link from the start of a piece of its body to x.
    fn pushes<'a>(&'a self, push: &mut Push<'a>, body: &Body, x: f64) {
        let series = &self.force[..body.len];
        push.forces = [series[0], value(series, x)];
        push.impulse = integral(series, body.power, x);
        push.series = series;
    }
}

impl Member {
    /// Motion at both ends of a piece, for a member that has its new state.
    fn ends(&self) -> [Motion; 2] {
        let start = Motion {
            displacement: self.displacement[0],
            velocity: self.velocity[0],
        };
        [start, (&self.state).into()]
    }

    /// The hysteretic part of the force at x, at this drift.
    fn hysteretic_end(&self, drift: f64, len: usize, x: f64) -> f64 {
        match (&self.bend, self.held()) {
            (None, None) => self.hysteretic_force_at(drift, rise(&self.drift()[..len], x)),
            (None, Some(stick)) => value(&stick.force[..len], x),
            (Some(bend), _) => self.hysteretic_force + rise(&bend.force[..len], x),
        }
    }
}

/// Storage for the pushes on a floor: fixed for few of them, a list for more.
#[derive(Default)]
pub(super) struct Room<'a> {
    few: [Push<'a>; 4],
    many: Vec<Push<'a>>,
}

impl<'a> Room<'a> {
    /// Pushes without effect, one for each incident.
    pub(super) fn of(&mut self, incidents: &[Incident]) -> &mut [Push<'a>] {
        let pushes = if let Some(few) = self.few.get_mut(..incidents.len()) {
            few
        } else {
            self.many.resize(incidents.len(), Push::default());
            &mut self.many
        };
        for (push, at) in pushes.iter_mut().zip(incidents) {
            *push = at.into();
        }
        pushes
    }
}

/// The series of the pushes on one side of a floor: that of the only pair, or the sum of several pairs.
fn side<'a>(pushes: &[Push<'a>], on_left: bool, room: &'a mut Option<[f64; CAPACITY]>) -> &'a [f64] {
    let all = || {
        let pushes = pushes.iter().filter(|push| push.on_left == on_left);
        pushes.filter(|push| !push.series.is_empty())
    };
    let Some(first) = all().next() else {
        return &[];
    };
    if first.part >= 1.0 && all().nth(1).is_none() {
        return first.series;
    }
    let sum = room.insert([0.0; CAPACITY]);
    for push in all() {
        for (sum, force) in sum.iter_mut().zip(push.series) {
            *sum += push.part * force;
        }
    }
    &sum[..first.series.len()]
}

/// The impulse of the pairs on one side of a floor.
fn impulse(pushes: &[Push<'_>], on_left: bool) -> f64 {
    let pushes = pushes.iter().filter(|push| push.on_left == on_left);
    let given = pushes.map(|push| push.part * push.impulse);
    given.reduce(|sum, given| sum + given).unwrap_or(0.0)
}

/// ∫ F dt from the start of a piece to x.
fn integral(force: &[f64], power: Power, x: f64) -> f64 {
    let p = power.order();
    let mut sum = 0.0;
    for (n, coefficient) in force.iter().enumerate().rev() {
        sum = sum * x + p as f64 * coefficient / (n + p) as f64;
    }
    sum * power.time(x)
}
