//! The deformation of a pair from piece to piece, and its next touch.
//!
//! A small deformation is stored as a separate number from piece to piece. As a difference of displacements it would have lost its digits,
//! and bouncing could gain energy from rounding.

use std::cmp::Ordering;

use crate::exact::ExactRun;
use crate::exact::body::Body;
use crate::exact::clock::{LocalClock, Past};
use crate::exact::contact::{Gap, Join, PairState};
use crate::exact::rounding::{noise, weighed};
use crate::exact::shaking::Shaking;
use crate::roots::{CAPACITY, first_root, shift, value_and_slope};
use crate::span::{Power, value};
use crate::{Motion, Point, Recorder, Relation, Share};

/// A deformation below this part of the displacements is stored. A larger one is computed as their difference.
pub(super) const CARRIED: f64 = 1e-6;

/// Where a series begins.
#[derive(Clone, Copy)]
struct SeriesStart {
    instant: Past,
    /// Distance in x of the instant from the origin of the series.
    offset: f64,
}

impl Shaking<'_> {
    /// Adds the displacement of the ground of a node to its series; returns the length of the series.
    fn add_ground(&self, node: usize, start: SeriesStart, power: Power, series: &mut [f64; CAPACITY]) -> usize {
        let Some(travel) = &self.travel else {
            return 0;
        };
        let offset = start.offset;
        let cubic = travel.cubic_ground(node, start.instant.instant());
        let mut ground = [0.0; CAPACITY];
        ground[..cubic.len()].copy_from_slice(&cubic);
        let len = match power {
            Power::One => cubic.len(),
            Power::Four if offset > 0.0 => compose(&mut ground, cubic.len(), offset),
            Power::Four => spread(&mut ground, cubic.len()),
        };
        for (place, coefficient) in series.iter_mut().zip(&ground[..len]) {
            *place += coefficient;
        }
        len
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    /// Updates deformation and rate of a pair to this instant, from its series.
    pub(super) fn carry_deformation(&mut self, pair: usize, time: f64) {
        let contact = &self.touching.contacts[pair];
        let body = &self.moving.bodies[self.touching.groups.body_of[contact.floors()[0]]];
        if contact.time >= time {
            return;
        }
        let (deformation, rate) = match contact.join {
            Join::Resting => (0.0, 0.0),
            Join::Apart if contact.series.len == 0 => {
                let sides = contact.relation.points();
                let sides = sides.map(|point| self.motion_of(point, time));
                self.closing(pair, time, sides)
            }
            Join::Apart => contact.at(self.agenda.clock.past(time)),
            Join::Touching(_) => {
                let x = body.position(self.agenda.clock.past(time));
                let at = |series: &[f64]| value(&series[..body.len], x);
                (at(&contact.deformations), at(&contact.rates))
            }
        };
        let later = self.agenda.clock.absolute(time) > self.agenda.clock.absolute(contact.time);
        let contact = &mut self.touching.contacts[pair];
        (contact.deformation, contact.rate, contact.time) = (deformation, rate, time);
        if later {
            (contact.faded, contact.peaked) = (false, false);
        }
    }

    /// Computes a deformation that is not small from the displacements.
    pub(super) fn refresh_deformation(&mut self, pair: usize, time: f64) {
        let contact = &self.touching.contacts[pair];
        let (relation, [left, right]) = (contact.relation, contact.floors());
        let points = relation.points();
        let sides = points.map(|point| self.motion_of(point, time));
        let (deformation, rate) = self.closing(pair, time, sides);
        let scale = sides[0].displacement.abs() + sides[1].displacement.abs() + relation.offset;
        let travel = self.shaking.travel.as_ref().filter(|_| self.touching.contacts[pair].opens());
        let scale = match travel {
            None => scale,
            Some(travel) => {
                let time = self.agenda.clock.absolute(time);
                let ground = |node: usize| travel.ground(node, time).displacement.abs();
                scale + (ground(left) + ground(right))
            }
        };
        let is_chain = self.touching.is_chain();
        let contact = &mut self.touching.contacts[pair];
        contact.scale = contact.scale.max(scale);
        // At a touch the series knows both better than the rounded time.
        let touches = contact.meets <= time;
        // The rounding of displacements decays with the displacements.
        let coarse = !touches && deformation.abs() > CARRIED * scale;
        // A deformation that an impact has set to zero stays zero: at another impact of this instant the rounding of time would be an
        // overlap. In a row that is no chain, points of one floor touch in turn at an instant.
        let struck = contact.deformation == 0.0 && (contact.hit >= time || !is_chain);
        if coarse && !struck && contact.join != Join::Resting {
            contact.deformation = deformation;
            // A rate that an event has set to zero stays zero.
            if contact.rate != 0.0 {
                contact.rate = rate;
            }
        }
    }

    /// Displacement and velocity of a point now.
    pub(super) fn motion_of(&self, point: Point, time: f64) -> Motion {
        let Point::Share(Share { base, other, lean }) = point else {
            return self.motion(point.floor(), time);
        };
        let motion = |floor: Option<usize>| floor.map(|floor| self.motion(floor, time));
        let [base, other] = [base, other].map(|floor| motion(floor).unwrap_or_default());
        let between = |base: f64, other: f64| base + lean * (other - base);
        Motion {
            displacement: between(base.displacement, other.displacement),
            velocity: between(base.velocity, other.velocity),
        }
    }

    /// Displacement and velocity of a node now, landed or not.
    fn motion(&self, node: usize, time: f64) -> Motion {
        let member = &self.moving.members[node];
        if self.moving.landed[node] {
            return (&member.state).into();
        }
        let body = &self.moving.bodies[self.touching.groups.body_of[node]];
        let x = body.position(self.agenda.clock.past(time));
        Motion {
            displacement: value(&member.displacement[..body.len], x),
            velocity: value(&member.velocity[..body.len], x),
        }
    }

    /// The earlier of the two bodies of a pair if their pieces run in roots of time from different instants.
    ///
    /// `None` if the bodies cannot meet: a pair that never touches must not end a piece.
    pub(super) fn conflict(&self, pair: usize) -> Option<usize> {
        let earlier = self.earlier_root(pair)?;
        (!self.out_of_reach(pair)).then_some(earlier)
    }

    fn earlier_root(&self, pair: usize) -> Option<usize> {
        let floors = self.touching.contacts[pair].floors();
        let firsts = floors.map(|floor| self.touching.groups.body_of[floor]);
        let [a, b] = firsts.map(|first| &self.moving.bodies[first]);
        let rooted = a.power == Power::Four && b.power == Power::Four;
        match a.start.since(b.start).total_cmp(&0.0) {
            Ordering::Less if rooted => Some(firsts[0]),
            Ordering::Greater if rooted => Some(firsts[1]),
            Ordering::Less | Ordering::Equal | Ordering::Greater => None,
        }
    }

    /// Whether the largest possible displacements of both pieces leave the pair clearly open.
    fn out_of_reach(&self, pair: usize) -> bool {
        let contact = &self.touching.contacts[pair];
        let most = |node: usize, sign: f64| {
            let (body, member) = (&self.moving.bodies[self.touching.groups.body_of[node]], &self.moving.members[node]);
            let series = &member.displacement[1..body.len];
            let bound = |sum: f64, c: &f64| sum * body.length + c.abs();
            sign * member.displacement[0] + body.length * series.iter().rev().fold(0.0, bound)
        };
        let Relation { left, right, offset } = contact.relation;
        let mut closest = weighed(left, |node| most(node, 1.0)) + weighed(right, |node| most(node, -1.0)) - offset;
        if let Some(travel) = self.shaking.travel.as_ref().filter(|_| contact.opens()) {
            let floors = contact.floors();
            let bodies = floors.map(|node| &self.moving.bodies[self.touching.groups.body_of[node]]);
            let starts = bodies.map(|body| self.agenda.clock.shown(body.start));
            let start = starts[0].max(starts[1]);
            let length = (bodies[0].end.min(bodies[1].end) - start).max(0.0);
            let [opening, others @ ..] = travel.cubic_opening(floors, self.agenda.clock.past(start).instant());
            let bound = |sum: f64, c: &f64| sum * length + c.abs();
            closest += opening + length * others.iter().rev().fold(0.0, bound);
        }
        closest < -2.0 * CARRIED * contact.scale
    }

    /// Displacement of a node as a series; returns its length.
    fn displacement_from(&self, node: usize, start: SeriesStart, power: Power, series: &mut [f64; CAPACITY]) -> usize {
        let SeriesStart { instant, offset } = start;
        let (body, member) = (&self.moving.bodies[self.touching.groups.body_of[node]], &self.moving.members[node]);
        series[..body.len].copy_from_slice(&member.displacement[..body.len]);
        if body.power == Power::Four {
            if offset > 0.0 {
                shift(&mut series[..body.len], offset);
            }
            return body.len;
        }
        shift(&mut series[..body.len], instant.since(body.start));
        match power {
            Power::One => body.len,
            Power::Four if offset > 0.0 => compose(series, body.len, offset),
            Power::Four => spread(series, body.len),
        }
    }

    /// Displacements of both points of a pair as series, including their grounds if these move apart.
    fn sides_from(&self, pair: usize, start: SeriesStart, power: Power) -> ([[f64; CAPACITY]; 2], usize) {
        let contact = &self.touching.contacts[pair];
        let (mut sides, mut len) = ([[0.0; CAPACITY]; 2], 0);
        for (point, side) in contact.relation.points().into_iter().zip(&mut sides) {
            len = len.max(self.point_from(point, start, power, side));
            if contact.opens() {
                len = len.max(self.shaking.add_ground(point.floor(), start, power, side));
            }
        }
        (sides, len)
    }

    /// Displacement of a point as a series; returns its length.
    fn point_from(&self, point: Point, start: SeriesStart, power: Power, series: &mut [f64; CAPACITY]) -> usize {
        let Point::Share(Share { base, other, lean }) = point else {
            return self.displacement_from(point.floor(), start, power, series);
        };
        let mut others = [0.0; CAPACITY];
        let from = |floor: Option<usize>, series: &mut [f64; CAPACITY]| {
            floor.map_or(0, |floor| self.displacement_from(floor, start, power, series))
        };
        let len = from(base, series).max(from(other, &mut others));
        for (base, other) in series[..len].iter_mut().zip(&others) {
            *base += lean * (other - *base);
        }
        len
    }

    /// Finds the next touch of a pair within the pieces on both sides of it.
    pub(super) fn look_ahead(&mut self, pair: usize, time: f64) {
        let contact = &self.touching.contacts[pair];
        if contact.join != Join::Apart || time >= self.agenda.end {
            self.touching.contacts[pair].meets = f64::INFINITY;
            return;
        }
        if self.earlier_root(pair).is_some() {
            // The pair is out of reach: otherwise the pieces would have been ended.
            self.touching.contacts[pair].meets = f64::INFINITY;
            self.touching.contacts[pair].series.len = 0;
            return;
        }
        let floors = contact.floors();
        let bodies = floors.map(|node| &self.moving.bodies[self.touching.groups.body_of[node]]);
        let end = bodies[0].end.min(bodies[1].end);
        let rooted = bodies.iter().find(|body| body.power == Power::Four);
        let now = self.agenda.clock.past(time);
        let (origin, power) = rooted.map_or((now, Power::One), |body| (body.start, Power::Four));
        let offset = power.root(now.since(origin));
        // Before its start a series may be far beyond its reach. Both are then taken from now on.
        let late = |body: &&Body| body.power == Power::One && body.start.since(origin) > 0.0;
        let from_now = power == Power::Four && bodies.iter().any(late);
        let (instant, from) = if from_now { (now, offset) } else { (origin, 0.0) };
        let start = SeriesStart { instant, offset: from };
        let (sides, len) = self.sides_from(pair, start, power);
        let mut coefficients = [0.0; CAPACITY];
        for (n, coefficient) in coefficients[..len].iter_mut().enumerate() {
            *coefficient = sides[0][n] - sides[1][n];
        }
        if offset > 0.0 && !from_now {
            shift(&mut coefficients[..len], offset);
        }
        let members = &self.moving.members[..];
        let contact = &mut self.touching.contacts[pair];
        contact.begin_series(&mut coefficients[..len], power, offset);
        if contact.deformation == 0.0 && contact.rate == 0.0 {
            // The rounded difference of two equal motions is not a touch.
            let (relation, p) = (contact.relation, power.order());
            let rounding = |n: usize| noise(members, relation, [sides[0][n], sides[1][n]], p, n);
            let head = coefficients[..len].iter_mut().enumerate();
            for (n, coefficient) in head.skip(2 * power.order()) {
                if coefficient.abs() > rounding(n) {
                    break;
                }
                *coefficient = 0.0;
            }
        }
        contact.series.coefficients = coefficients;
        (contact.series.len, contact.series.origin) = (len, origin);
        (contact.series.offset, contact.series.power) = (offset, power);
        let length = power.root(self.agenda.clock.past(end).since(origin)) - offset;
        let origin = self.agenda.clock.shown(origin);
        let touch = first_root(&coefficients[..len], length);
        contact.meets_at = touch.unwrap_or(length);
        contact.meets = match touch {
            Some(x) if x >= length => end,
            Some(x) => (origin + power.time(offset + x)).clamp(time, end),
            None => f64::INFINITY,
        };
    }
}

impl PairState {
    /// Deformation and rate of a pair that is apart.
    fn at(&self, now: Past) -> (f64, f64) {
        let series = &self.series;
        // A touch is located by the series: the time since an origin just before it has lost its digits.
        let at = if now.time() < self.meets {
            series.power.root(now.since(series.origin).max(0.0)) - series.offset
        } else {
            self.meets_at
        };
        let x = series.offset + at;
        let (deformation, slope) = value_and_slope(&series.coefficients[..series.len], at);
        let rate = match series.power {
            Power::One => slope,
            // At the origin nothing has changed yet.
            Power::Four if x == 0.0 => self.rate,
            Power::Four => slope / (4.0 * x * x * x),
        };
        (deformation, rate)
    }

    /// Writes the stored deformation and rate at the head of the series, and clears coefficients that are known to be zero.
    fn begin_series(&self, coefficients: &mut [f64], power: Power, offset: f64) {
        coefficients[0] = self.deformation;
        if offset > 0.0 {
            return;
        }
        if let Some(place) = coefficients.get_mut(power.order()) {
            *place = self.rate;
        }
        if self.faded
            && let Some(place) = coefficients.get_mut(2 * power.order())
        {
            *place = 0.0;
        }
    }

    /// Rate of deformation at the next touch, even if time cannot distinguish it from now.
    pub(super) fn rate_at_touch(&self, clock: LocalClock) -> f64 {
        self.at(clock.past(self.meets)).1
    }

    /// Notes that the pair touches now.
    pub(super) fn touch(&mut self, time: f64, rate: f64) {
        (self.deformation, self.time, self.meets) = (0.0, time, f64::INFINITY);
        self.rate = rate;
        self.gap = Gap::Touches;
    }
}

/// Converts a series in t to a series in x, t = x⁴, up to the capacity; returns its number of coefficients.
fn spread(coefficients: &mut [f64; CAPACITY], len: usize) -> usize {
    let kept = len.min(CAPACITY / 4);
    let old = *coefficients;
    coefficients.fill(0.0);
    for n in 0..kept {
        coefficients[4 * n] = old[n];
    }
    4 * kept - 3
}

/// Converts a series in τ to a series in y, τ = (offset + y)⁴ − offset⁴, up to the capacity; returns its number of coefficients.
fn compose(coefficients: &mut [f64; CAPACITY], len: usize, offset: f64) -> usize {
    let squared = offset * offset;
    let inner = [4.0 * squared * offset, 6.0 * squared, 4.0 * offset, 1.0];
    let outer = *coefficients;
    coefficients.fill(0.0);
    for coefficient in outer[..len].iter().rev() {
        let sum = *coefficients;
        coefficients.fill(0.0);
        coefficients[0] = *coefficient;
        for (power, factor) in (1..).zip(inner) {
            for (place, term) in coefficients[power..].iter_mut().zip(sum) {
                *place += factor * term;
            }
        }
    }
    (4 * len - 3).min(CAPACITY)
}
