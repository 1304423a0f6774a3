//! Links between floors: their state between events, and their force as a power series. Floors that a link joins move as one body.

use crate::exact::ExactRun;
use crate::exact::bend::{NOTHING, sign};
use crate::exact::link_laws::{Branch, Change, Law};
use crate::exact::member::Member;
use crate::exact::rounding::weighed;
use crate::exact::watch::{Event, Watch, last_quarter};
use crate::roots::{CAPACITY, INSTANT, LOST, SHORTEST_WAY};
use crate::span::{Power, value};
use crate::{Link, Motion, Point, Recorder, Relation, RestoringForce, Row, RunError, Travel};

/// A link between events.
#[derive(Debug, Clone)]
pub(super) struct LinkState {
    pub(super) relation: Relation,
    law: Law,
    /// How far the grounds have moved towards each other at the start of the piece; `None` if they move alike.
    opening: Option<Motion>,
    apart: bool,
    /// The rate of deformation is zero at this instant; the force has an extremum.
    turned: bool,
    peaked: bool,
    /// Magnitude of the terms of the rate \[m/s\], if the link stopped yielding at this instant.
    still: Option<f64>,
    /// Deformation, its rate and the force, in the variable of the body.
    deformation: [f64; CAPACITY],
    rate: [f64; CAPACITY],
    pub(super) force: [f64; CAPACITY],
}

impl LinkState {
    /// The links of a row; an error for a law without a series.
    pub(super) fn of<Column: RestoringForce>(row: &Row<Column>) -> Result<Vec<Self>, RunError> {
        let state = |(index, link): (usize, &Link)| {
            let mut law = Law::new(link.law).ok_or(RunError::LinkWithoutSeries { link: index })?;
            if let Law::Line(line) = &mut law {
                line.begin(link.relation.ahead(|node| row.nodes()[node].initial_displacement));
            }
            let points = link.relation.points();
            let [first, last] = points.map(|point| row.arrival(point.floor()));
            Ok(Self {
                relation: link.relation,
                law,
                opening: None,
                apart: first.total_cmp(&last).is_ne(),
                turned: false,
                peaked: false,
                still: None,
                deformation: [0.0; CAPACITY],
                rate: [0.0; CAPACITY],
                force: [0.0; CAPACITY],
            })
        };
        row.links().iter().enumerate().map(state).collect()
    }

    /// Sets the motion of the grounds at the start of a piece.
    fn open(&mut self, travel: &Travel, instant: [f64; 2]) {
        if self.apart {
            let nodes = self.relation.points().map(Point::floor);
            self.opening = Some(travel.opening_at(nodes, instant));
        }
    }

    fn over_grounds(&self, members: &[Member], ahead: f64, n: usize, [first, ground]: [f64; 2], later: impl Fn(&Member) -> f64) -> f64 {
        if self.opening.is_none() {
            return ahead;
        }
        let [left, right] = self.relation.points().map(|point| later(&members[point.floor()]));
        if n == 0 { ahead + first } else { ahead + ground + (left - right) }
    }

    /// Finds coefficient `n` of the force, and adds it to the forces on the floors.
    pub(super) fn find(&mut self, members: &mut [Member], p: usize, n: usize) {
        let opening = self.opening.unwrap_or_default();
        let at_rate = if n == p { opening.velocity } else { 0.0 };
        let ahead = self.relation.ahead(|node| members[node].displacement[n]);
        let ground = [opening.displacement, at_rate];
        self.deformation[n] = self.over_grounds(members, ahead, n, ground, |member| member.ground_displacement(p, n));
        let ahead = self.relation.ahead(|node| members[node].velocity[n]);
        self.rate[n] = self.over_grounds(members, ahead, n, [opening.velocity, 0.0], |member| member.ground_velocity(p, n));
        let (deformation, rate) = (self.deformation[n], self.rate[n]);
        match &mut self.law {
            Law::Line(line) => {
                let spring = match n {
                    0 => line.force + line.hardened * deformation,
                    _ => (line.tangent() + line.hardened) * deformation,
                };
                self.force[n] = spring + line.damping * rate;
            }
            Law::Flow(flow) => {
                if n == 0 {
                    self.force[..p].fill(0.0);
                    self.force[0] = flow.force;
                    flow.sign = sign(flow.force);
                }
                if flow.sign == 0.0 {
                    flow.sign = sign(rate);
                }
                let flows = flow.flows(&self.force, n);
                if n + p < CAPACITY {
                    self.force[n + p] = flow.damper.stiffness * (rate - flows) * (p as f64 / (n + p) as f64);
                }
            }
        }
        let force = self.force[n];
        for (floor, part) in self.relation.pushes() {
            if let Some(linked) = &mut members[floor].linked {
                linked.against[n] -= part * force;
            }
        }
        if n == 0 {
            self.measure(members);
        }
    }

    /// Adds the magnitude of the terms of the force at its floors: a force near zero has the rounding of its amplitude.
    fn measure(&self, members: &mut [Member]) {
        let [stiffness, damping] = self.law.rates();
        let [left, right] = self.relation.points();
        let speed = |node: usize| members[node].state.velocity.abs();
        let speed = weighed(left, speed) + weighed(right, speed);
        let rates = self.relation.pushes().map(|(floor, _)| members[floor].fastest_rate);
        let rate = rates.fold(0.0, f64::max);
        let amplitude = if rate > 0.0 { speed / rate } else { 0.0 };
        let magnitude = self.force[0].abs() + stiffness * amplitude + damping * speed;
        for (floor, part) in self.relation.pushes() {
            if let Some(linked) = &mut members[floor].linked {
                linked.magnitude += part.abs() * magnitude;
            }
        }
    }

    /// Ends yielding if the motion leads back; true if it did.
    pub(super) fn turns_back(&mut self, members: &[Member], p: usize, len: usize) -> bool {
        let leads = Some(self.standstill(members, p, len)).filter(|n| *n < len);
        let Law::Line(line) = &mut self.law else {
            return false;
        };
        let turns = leads.is_some_and(|n| line.turns(self.rate[n]));
        if turns {
            line.go_to(Branch::Elastic, self.deformation[0]);
        }
        turns
    }

    /// Number of leading coefficients of the rate that are rounding.
    fn standstill(&self, members: &[Member], p: usize, len: usize) -> usize {
        let speed = |node: usize| members[node].state.velocity.abs();
        let [left, right] = self.relation.points();
        let start = self
            .still
            .map_or(0.0, |terms| STILL * (terms + weighed(left, speed) + weighed(right, speed)));
        // After a rest, the rounding of a rate may point against the motion for less than an instant.
        let overtaken = |n: usize| INSTANT * self.rate.get(n + p).map_or(0.0, |later| later.abs());
        let rounding = |n: usize| if n == 0 { start } else { self.noise(members, p, n) }.max(overtaken(n));
        let is_noise = |n: &usize| self.rate[*n].abs() <= rounding(*n);
        (0..len).take_while(is_noise).count()
    }

    /// Rounding of coefficient `n` of the rate.
    fn noise(&self, members: &[Member], p: usize, n: usize) -> f64 {
        let [left, right] = self.relation.points();
        let of = |node: usize| members[node].noise_of_velocity(p, n);
        weighed(left, of) + weighed(right, of)
    }

    /// Searches for the instants at which the link changes its branch.
    pub(super) fn watch(&self, watch: &mut Watch, link: usize, members: &[Member], p: usize, len: usize) {
        self.watch_extremes(watch, link, len);
        // A link that has just turned or let go is at a limit: the rounding of its rate would lead it beyond.
        let known = self.standstill(members, p, len);
        let deformation = |n: usize| if n < known + p { 0.0 } else { self.deformation[n] };
        let line = match &self.law {
            Law::Line(line) => line,
            Law::Flow(flow) => {
                if flow.has_kink() {
                    watch.change_of(len, false, |n| self.force[n], Event::Link(link, Change::PassesZero));
                }
                return;
            }
        };
        match line.branch {
            Branch::Elastic => {
                let beyond = |limit: f64, sign: f64| {
                    move |n: usize| match n {
                        // Rounding of the force is no excess.
                        0 => (sign * (line.force - limit)).min(0.0),
                        _ => sign * (line.stiffness * deformation(n)),
                    }
                };
                let [lower, upper] = line.limits;
                if lower.is_finite() {
                    watch.rise(len, beyond(lower, -1.0), Event::Link(link, Change::To(Branch::Lower)));
                }
                if upper.is_finite() {
                    let branch = if line.lets_go { Branch::Slack } else { Branch::Upper };
                    watch.rise(len, beyond(upper, 1.0), Event::Link(link, Change::To(branch)));
                }
            }
            Branch::Upper | Branch::Lower => {
                let rate = |n: usize| if n < known { 0.0 } else { self.rate[n] };
                watch.change_of(len, false, rate, Event::Link(link, Change::To(Branch::Elastic)));
            }
            Branch::Slack => {
                let pull = |n: usize| match n {
                    0 => line.stretch.min(0.0),
                    _ => -deformation(n),
                };
                watch.rise(len, pull, Event::Link(link, Change::To(Branch::Elastic)));
            }
        }
    }

    /// Searches for extremes of deformation and force: peaks are read at the ends of pieces. Yielding ends at one.
    fn watch_extremes(&self, watch: &mut Watch, link: usize, len: usize) {
        let (of_deformation, own_peaks) = match &self.law {
            Law::Line(line) => (matches!(line.branch, Branch::Elastic | Branch::Slack), line.damping > 0.0),
            Law::Flow(_) => (true, true),
        };
        if of_deformation {
            watch.change_of(len, self.turned, |n| self.rate[n], Event::Link(link, Change::Turns));
        }
        if own_peaks {
            let slope = |n: usize| (n + 1) as f64 * self.force[n + 1];
            watch.change_of(len - 1, self.peaked, slope, Event::Link(link, Change::Peaks));
        }
    }

    /// Takes the state at x, the end of a piece. `later` says whether the clock of the recorders has advanced.
    pub(super) fn land(&mut self, len: usize, x: f64, later: bool) {
        if later {
            (self.turned, self.peaked, self.still) = (false, false, None);
        }
        let deformation = value(&self.deformation[..len], x);
        match &mut self.law {
            Law::Line(line) => (line.force, line.stretch) = (line.at(deformation), line.origin - deformation),
            Law::Flow(flow) => flow.force = value(&self.force[..len], x),
        }
    }

    /// Applies an event at x, the end of a piece.
    pub(super) fn change(&mut self, change: Change, len: usize, x: f64) {
        match (change, &mut self.law) {
            (Change::To(branch), Law::Line(line)) => {
                if branch == Branch::Elastic && line.branch != Branch::Slack {
                    let terms = self.rate[..len].iter().rev();
                    self.still = Some(terms.fold(0.0, |sum, term| sum * x + term.abs()));
                }
                line.go_to(branch, value(&self.deformation[..len], x));
            }
            (Change::Turns, _) => self.turned = true,
            (Change::Peaks, _) => self.peaked = true,
            (Change::PassesZero, Law::Flow(flow)) => flow.force = 0.0,
            (Change::To(_), Law::Flow(_)) | (Change::PassesZero, Law::Line(_)) => {}
        }
    }

    /// Forgets, at an impact on an end, that the rate of deformation is zero and the force has an extremum.
    pub(super) fn jump(&mut self) {
        (self.turned, self.peaked) = (false, false);
    }

    /// Whether the series may converge more slowly than those of the floors.
    pub(super) fn bends(&self) -> bool {
        matches!(&self.law, Law::Flow(flow) if flow.damper.inverse_exponent > 1)
    }

    /// Length up to which the series has converged to the tolerance; `None` if there is no such length.
    pub(super) fn reach(&self, power: Power, len: usize, length: f64, tolerance: f64) -> Option<f64> {
        let Law::Flow(flow) = &self.law else {
            return Some(length);
        };
        let mut x = length;
        loop {
            let (sum, tail) = last_quarter(&self.force[..len], x);
            let small = tolerance.max(f64::EPSILON) * sum.max(NOTHING * flow.damper.coefficient);
            if tail <= small && flow.is_power(len, x, tolerance) {
                return Some(x);
            }
            if power.time(x) < SHORTEST_WAY {
                return (tail <= LOST * sum).then_some(x);
            }
            x *= 0.85;
        }
    }
}

/// Rounding of the rate of a link that has just stopped yielding, as a part of its terms.
const STILL: f64 = 64.0 * f64::EPSILON;

impl<R: Recorder> ExactRun<'_, R> {
    /// Notes how far the grounds of the links of a body have moved at the start of its piece.
    pub(super) fn open_links(&mut self, first: usize, time: f64) {
        let Some(travel) = &self.shaking.travel else {
            return;
        };
        let instant = self.agenda.clock.past(time).instant();
        for place in self.touching.groups.links_of(first) {
            let link = self.touching.groups.link(place);
            self.moving.links[link].open(travel, instant);
        }
    }
}
