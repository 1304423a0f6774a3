//! Links between floors: their branch between events, and their force as a power series.
//!
//! Springs and restrainers lie on a line between events, F = h + a k δ + c δ̇. The part h = k′ (δ − origin), k′ = (1 − a) k, stays within
//! limits; a restrainer lets go at h = 0. A braced damper has the state F, whose rate is a product of series. Floors that a link joins move
//! as one body.

use crate::exact::ExactRun;
use crate::exact::member::Member;
use crate::exact::rounding::weighed;
use crate::exact::watch::{Event, Watch};
use crate::model::link::Braced;
use crate::roots::{CAPACITY, SHORTEST_WAY};
use crate::span::{Power, value};
use crate::{Link, LinkLaw, Motion, Point, Recorder, Relation, RestoringForce, Row, RunError, Travel};

/// The branch of a spring or a restrainer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Branch {
    Elastic,
    /// At the upper limit of h: yielding in compression.
    Upper,
    /// At the lower limit: yielding in tension.
    Lower,
    /// A restrainer without a force.
    Slack,
}

/// The part h of a spring or a restrainer.
#[derive(Debug, Clone, Copy)]
struct Line {
    /// k′ \[N/m\].
    stiffness: f64,
    /// a k \[N/m\].
    hardened: f64,
    /// c \[N·s/m\].
    damping: f64,
    /// Limits of h \[N\], the lower first.
    limits: [f64; 2],
    /// Whether h ends at zero from below, and the branch beyond.
    lets_go: bool,
    branch: Branch,
    /// Deformation at which h is zero \[m\].
    origin: f64,
    /// h at the start of the piece \[N\].
    force: f64,
}

/// A braced damper: its force at the start of the piece \[N\], and series of the part |F|/c and its powers.
#[derive(Debug, Clone)]
struct Flow {
    damper: Braced,
    force: f64,
    /// Sign of the force.
    sign: f64,
    powers: Vec<[f64; CAPACITY]>,
}

/// The force of a link that deforms.
#[derive(Debug, Clone)]
enum Law {
    Line(Line),
    Flow(Flow),
}

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
    /// Deformation, its rate and the force, in the variable of the body.
    deformation: [f64; CAPACITY],
    rate: [f64; CAPACITY],
    pub(super) force: [f64; CAPACITY],
}

/// Forces of links on a floor, as series of what they add to the forces against its motion.
#[derive(Debug, Clone)]
pub(super) struct Linked {
    pub(super) against: [f64; CAPACITY],
    /// Magnitude of the terms of these forces \[N\].
    pub(super) magnitude: f64,
    /// Sums of the stiffness \[N/m\], dashpots \[N·s/m\] and relaxation rates \[1/s\] of its links.
    pub(super) stiffness: f64,
    pub(super) damping: f64,
    pub(super) relaxation: f64,
}

impl Linked {
    /// The links of a node; `None` if there are none.
    pub(super) fn at<Column: RestoringForce>(row: &Row<Column>, node: usize) -> Option<Box<Self>> {
        let at = row.linking().at(node);
        if at.is_empty() {
            return None;
        }
        let mut linked = Self {
            against: [0.0; CAPACITY],
            magnitude: 0.0,
            stiffness: 0.0,
            damping: 0.0,
            relaxation: 0.0,
        };
        for link in at {
            let law = row.links()[link.pair].law;
            linked.stiffness += law.stiffness();
            linked.damping += law.dashpot();
            if let LinkLaw::Braced(damper) = law {
                linked.relaxation = linked.relaxation.max(damper.stiffness / damper.coefficient);
            }
        }
        Some(Box::new(linked))
    }
}

impl Law {
    /// `None` for a law that the exact method has no series for.
    fn new(law: LinkLaw) -> Option<Self> {
        let line = |stiffness: f64, hardened: f64, damping: f64, limits: [f64; 2]| Line {
            stiffness,
            hardened,
            damping,
            limits,
            lets_go: false,
            branch: Branch::Elastic,
            origin: 0.0,
            force: 0.0,
        };
        Some(match law {
            LinkLaw::Spring(spring) => {
                // A spring that never yields is elastic.
                let hardening = if spring.yield_force.is_finite() { spring.hardening } else { 0.0 };
                let part = 1.0 - hardening;
                let limit = part * spring.yield_force;
                let hardened = hardening * spring.stiffness;
                Self::Line(line(part * spring.stiffness, hardened, spring.damping, [-limit, limit]))
            }
            LinkLaw::Restrainer(restrainer) => Self::Line(Line {
                lets_go: true,
                branch: Branch::Slack,
                origin: -restrainer.slack,
                ..line(restrainer.stiffness, 0.0, 0.0, [-restrainer.yield_force, 0.0])
            }),
            LinkLaw::Braced(damper) => Self::Flow(Flow {
                damper,
                force: 0.0,
                sign: 0.0,
                powers: vec![[0.0; CAPACITY]; damper.inverse_exponent as usize],
            }),
            LinkLaw::Viscous(_) => return None,
        })
    }

    /// Stiffness \[N/m\] and dashpot \[N·s/m\].
    fn rates(&self) -> [f64; 2] {
        match self {
            Self::Line(line) => [line.stiffness + line.hardened, line.damping],
            Self::Flow(flow) => [flow.damper.stiffness, 0.0],
        }
    }
}

impl Line {
    /// h at a deformation on the present branch.
    fn at(&self, deformation: f64) -> f64 {
        match self.branch {
            Branch::Elastic => self.stiffness * (deformation - self.origin),
            Branch::Upper => self.limits[1],
            Branch::Lower => self.limits[0],
            Branch::Slack => 0.0,
        }
    }

    /// Tangent of h \[N/m\].
    fn tangent(&self) -> f64 {
        if self.branch == Branch::Elastic { self.stiffness } else { 0.0 }
    }

    /// Changes the branch at a deformation.
    fn go_to(&mut self, branch: Branch, deformation: f64) {
        match branch {
            Branch::Upper => self.force = self.limits[1],
            Branch::Lower => self.force = self.limits[0],
            Branch::Slack => (self.force, self.origin) = (0.0, deformation),
            Branch::Elastic if self.branch == Branch::Slack => self.force = 0.0,
            Branch::Elastic => self.origin = deformation - self.force / self.stiffness,
        }
        self.branch = branch;
    }

    /// Whether it yields against this rate of deformation.
    fn turns(&self, rate: f64) -> bool {
        match self.branch {
            Branch::Upper => rate < 0.0,
            Branch::Lower => rate > 0.0,
            Branch::Elastic | Branch::Slack => false,
        }
    }
}

impl Flow {
    /// Coefficient `n` of the rate at which the damper deforms, from those of the force up to `n`.
    fn flows(&mut self, force: &[f64; CAPACITY], n: usize) -> f64 {
        self.powers[0][n] = self.sign * force[n] / self.damper.coefficient;
        for index in 1..self.powers.len() {
            let (known, rest) = self.powers.split_at_mut(index);
            let (before, first) = (&known[index - 1], &known[0]);
            rest[0][n] = (0..=n).map(|m| before[m] * first[n - m]).sum();
        }
        let last = self.powers.len() - 1;
        self.sign * self.powers[last][n]
    }

    /// Whether the force passes through zero with a kink: an odd power needs no sign.
    fn has_kink(&self) -> bool {
        self.damper.inverse_exponent.is_multiple_of(2)
    }
}

impl LinkState {
    /// The links of a row; an error for a law without a series.
    pub(super) fn of<Column: RestoringForce>(row: &Row<Column>) -> Result<Vec<Self>, RunError> {
        let state = |(index, link): (usize, &Link)| {
            let law = Law::new(link.law).ok_or(RunError::LinkWithoutSeries { link: index })?;
            let points = link.relation.points();
            let [first, last] = points.map(|point| row.arrival(point.floor()));
            Ok(Self {
                relation: link.relation,
                law,
                opening: None,
                apart: first.total_cmp(&last).is_ne(),
                turned: false,
                peaked: false,
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
        let leads = (0..len).find(|n| self.rate[*n].abs() > self.noise(members, p, *n));
        let Law::Line(line) = &mut self.law else {
            return false;
        };
        let turns = leads.is_some_and(|n| line.turns(self.rate[n]));
        if turns {
            line.go_to(Branch::Elastic, self.deformation[0]);
        }
        turns
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
        let line = match &self.law {
            Law::Line(line) => line,
            Law::Flow(flow) => {
                if flow.has_kink() {
                    watch.change_of(len, false, |n| self.force[n], Event::FlowTurns(link));
                }
                return;
            }
        };
        // At a limit, rounding of force and rate does not lead beyond it: else a link that turns back yields again at once.
        let known = p + (0..len).take_while(|n| self.rate[*n].abs() <= self.noise(members, p, *n)).count();
        let beyond = |excess: f64, slope: f64| {
            let start = excess.min(0.0);
            move |n: usize| match n {
                0 => start,
                _ if start == 0.0 && n < known => 0.0,
                _ => slope * self.deformation[n],
            }
        };
        match line.branch {
            Branch::Elastic => {
                let beyond = |limit: f64, sign: f64| beyond(sign * (line.force - limit), sign * line.stiffness);
                let [lower, upper] = line.limits;
                if lower.is_finite() {
                    watch.rise(len, beyond(lower, -1.0), Event::Link(link, Branch::Lower));
                }
                if upper.is_finite() {
                    let branch = if line.lets_go { Branch::Slack } else { Branch::Upper };
                    watch.rise(len, beyond(upper, 1.0), Event::Link(link, branch));
                }
            }
            Branch::Upper | Branch::Lower => {
                let rate = |n: usize| if n + p < known { 0.0 } else { self.rate[n] };
                watch.change_of(len, false, rate, Event::Link(link, Branch::Elastic));
            }
            Branch::Slack => watch.rise(
                len,
                beyond(line.origin - self.deformation[0], -1.0),
                Event::Link(link, Branch::Elastic),
            ),
        }
    }

    /// Searches for extremes of deformation and force: peaks are read at the ends of pieces.
    fn watch_extremes(&self, watch: &mut Watch, link: usize, len: usize) {
        let (of_deformation, own_peaks) = match &self.law {
            Law::Line(line) => (line.branch == Branch::Elastic, line.damping > 0.0),
            Law::Flow(_) => (true, true),
        };
        if of_deformation {
            watch.change_of(len, self.turned, |n| self.rate[n], Event::LinkTurns(link));
        }
        if own_peaks {
            let slope = |n: usize| (n + 1) as f64 * self.force[n + 1];
            watch.change_of(len - 1, self.peaked, slope, Event::LinkPeaks(link));
        }
    }

    /// Takes the state at x, the end of a piece. `later` says whether the clock of the recorders has advanced.
    pub(super) fn land(&mut self, len: usize, x: f64, later: bool) {
        if later {
            (self.turned, self.peaked) = (false, false);
        }
        let deformation = value(&self.deformation[..len], x);
        match &mut self.law {
            Law::Line(line) => line.force = line.at(deformation),
            Law::Flow(flow) => flow.force = value(&self.force[..len], x),
        }
    }

    /// Changes the branch at x, the end of a piece.
    pub(super) fn go_to(&mut self, branch: Branch, len: usize, x: f64) {
        let deformation = value(&self.deformation[..len], x);
        if let Law::Line(line) = &mut self.law {
            line.go_to(branch, deformation);
        }
    }

    /// Notes that deformation or force has an extremum.
    pub(super) fn note(&mut self, event: &Event) {
        match event {
            Event::LinkTurns(_) => self.turned = true,
            Event::LinkPeaks(_) => self.peaked = true,
            _ => {}
        }
    }

    /// Clears the force of a damper that passes through zero.
    pub(super) fn pass_zero(&mut self) {
        if let Law::Flow(flow) = &mut self.law {
            flow.force = 0.0;
        }
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
            if self.is_bent(flow, len, x, tolerance.max(f64::EPSILON)) {
                return Some(x);
            }
            if power.time(x) < SHORTEST_WAY {
                return None;
            }
            x *= 0.85;
        }
    }

    /// Whether the last quarter of the series at x is this small a part of it, and the series of the flow is that power of the force.
    fn is_bent(&self, flow: &Flow, len: usize, x: f64, tolerance: f64) -> bool {
        let (mut sum, mut tail, mut weight) = (0.0, 0.0, 1.0);
        for (n, coefficient) in self.force[..len].iter().enumerate() {
            let term = weight * coefficient.abs();
            sum += term;
            if n + len / 4 >= len {
                tail += term;
            }
            weight *= x;
        }
        let small = tail <= tolerance * sum.max(NOTHING * flow.damper.coefficient);
        let ends = [0, flow.powers.len() - 1].map(|power| value(&flow.powers[power][..len], x));
        let power = (0..flow.damper.inverse_exponent).fold(1.0, |power, _| power * ends[0]);
        let rounding = 64.0 * f64::EPSILON * power.abs().max(NOTHING);
        small && (power - ends[1]).abs() <= rounding.max(tolerance)
    }
}

/// Part of a force, or a rate of flow \[m/s\], that counts as zero.
const NOTHING: f64 = 1e-20;

fn sign(number: f64) -> f64 {
    if number > 0.0 {
        1.0
    } else if number < 0.0 {
        -1.0
    } else {
        0.0
    }
}

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
