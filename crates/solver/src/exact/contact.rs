//! State of a pair between events: whether it touches, its deformation and its force.

use pounding_contact::{Action, ContactLaw, Form, Power as Exponent, Term};

use crate::exact::clock::Past;
use crate::exact::member::Member;
use crate::exact::rounding::noise;
use crate::model::incidence::Incidence;
use crate::roots::CAPACITY;
use crate::span::Power;
use crate::{Pair, Point, Relation};

/// How a pair is joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Join {
    /// The pair is apart, or touches without a force.
    Apart,
    /// Impulsive contact at rest: the neighbours move together while they press.
    Resting,
    /// Compliant contact.
    Touching(Phase),
}

/// Phase of compliant contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Phase {
    Approach,
    Restitution,
    /// The law would pull: the force is zero until the law pushes again.
    Clamped,
    /// The rest of the force is below the tolerance; the neighbours part.
    Parting,
}

/// The slope of a law on which a deformation is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum OnSlope {
    /// The only one, or the first of two.
    First,
    Second,
}

/// State of the gap of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Gap {
    /// The deformation and its rate describe the gap.
    Known,
    /// A touch has been found and is not yet resolved.
    Touches,
    /// The gap is closed without a rate and opens now.
    Parts,
}

/// How the grounds of a pair move relative to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Grounds {
    Alike,
    /// The ground motion arrives at the two sides at different times.
    Apart,
}

/// A pair between events.
#[derive(Debug, Clone)]
pub(super) struct PairState {
    pub(super) relation: Relation,
    pub(super) law: ContactLaw,
    pub(super) reduced_mass: f64,
    pub(super) grounds: Grounds,
    /// Form of the present contact, which may contain its approach speed; `None` before the first contact.
    pub(super) form: Option<Form>,
    /// The slope of the form on which the deformation is.
    pub(super) slope: OnSlope,
    /// Rate of deformation at the touch.
    pub(super) approach_speed: f64,
    /// Pieces of the present contact, if its law depends on the approach speed.
    pub(super) pieces: u32,
    pub(super) join: Join,
    /// The pair rests without a force, held by other pairs.
    pub(super) idle: bool,
    /// The instant at which `deformation` and `rate` hold.
    pub(super) time: f64,
    pub(super) deformation: f64,
    pub(super) rate: f64,
    /// Largest displacement or gap so far \[m\]: the scale of the rounding of a deformation.
    pub(super) scale: f64,
    /// State of the gap if it has just closed.
    pub(super) gap: Gap,
    /// The contact force has just faded: the relative acceleration is zero.
    pub(super) faded: bool,
    /// Number of orders in time, starting with the acceleration, in which the neighbours move alike when they begin to touch.
    pub(super) alike: usize,
    /// The force has an extremum at this instant.
    pub(super) peaked: bool,
    /// Instant at which the force before the clamp last changed sign.
    pub(super) crossed: f64,
    /// The next touch according to the pieces on both sides; infinite if there is none.
    pub(super) meets: f64,
    /// The next touch in the variable of `series`, without the rounding of time.
    pub(super) meets_at: f64,
    /// Instant of the last impact.
    pub(super) hit: f64,
    /// Impacts before `hit` that followed each other within the shortest remainder.
    pub(super) burst: u32,
    /// Impacts since the pair was last at rest.
    pub(super) bounces: u32,
    pub(super) series: Deformation,
    /// Pounding force, in the variable of its body.
    pub(super) force: [f64; CAPACITY],
    /// A series with the sign of the force before the clamp.
    pub(super) pull: [f64; CAPACITY],
    /// Deformation and its rate during a touch, in the variable of the body.
    pub(super) deformations: [f64; CAPACITY],
    pub(super) rates: [f64; CAPACITY],
    pub(super) spring: [f64; CAPACITY],
    pub(super) damper: [f64; CAPACITY],
}

/// Deformation as a series in x − `offset`, with t = `origin` + x^p.
#[derive(Debug, Clone)]
pub(super) struct Deformation {
    pub(super) coefficients: [f64; CAPACITY],
    pub(super) len: usize,
    pub(super) origin: Past,
    pub(super) offset: f64,
    pub(super) power: Power,
}

/// The parts from which bodies are built.
#[derive(Clone, Copy)]
pub(super) struct System<'a> {
    pub(super) members: &'a [Member],
    pub(super) contacts: &'a [PairState],
    pub(super) incidence: &'a Incidence,
}

impl PairState {
    pub(super) fn new(pair: &Pair, reduced_mass: f64, [deformation, rate]: [f64; 2]) -> Self {
        Self {
            relation: pair.relation,
            law: pair.law,
            reduced_mass,
            grounds: Grounds::Alike,
            form: None,
            slope: OnSlope::First,
            approach_speed: 0.0,
            pieces: 0,
            join: Join::Apart,
            idle: false,
            time: 0.0,
            deformation,
            rate,
            scale: 0.0,
            gap: Gap::Known,
            faded: false,
            alike: 0,
            peaked: false,
            crossed: f64::NEG_INFINITY,
            meets: f64::INFINITY,
            meets_at: 0.0,
            hit: f64::NEG_INFINITY,
            burst: 0,
            bounces: 0,
            series: Deformation {
                coefficients: [0.0; CAPACITY],
                len: 0,
                origin: Past::default(),
                offset: 0.0,
                power: Power::One,
            },
            force: [0.0; CAPACITY],
            pull: [0.0; CAPACITY],
            deformations: [0.0; CAPACITY],
            rates: [0.0; CAPACITY],
            spring: [0.0; CAPACITY],
            damper: [0.0; CAPACITY],
        }
    }

    /// Shifts all times to a clock that shows `by` less \[s\].
    pub(super) fn set_back(&mut self, by: f64) {
        self.time -= by;
        self.crossed -= by;
        self.meets -= by;
        self.hit -= by;
    }

    /// The floors of both points, on the grounds of both buildings; for a point between two floors, the nearer one.
    pub(super) fn floors(&self) -> [usize; 2] {
        self.relation.points().map(Point::floor)
    }

    /// Whether the grounds of the pair move relative to each other.
    pub(super) fn opens(&self) -> bool {
        self.grounds == Grounds::Apart
    }

    /// c/m \[1/s\] of a damper that does not depend on deformation and speed; 0 for other dampers.
    pub(super) fn relaxation(&self) -> f64 {
        let form = self.law.form(self.reduced_mass, 1.0);
        let same = |form: &Form| form.damper.power == Exponent::Zero && !self.law.knows_approach_speed();
        form.filter(same).map_or(0.0, |form| form.damper.coefficient / self.reduced_mass)
    }

    /// Begins compliant contact, with the rate of the touch as approach speed.
    pub(super) fn begin(&mut self) {
        (self.approach_speed, self.pieces, self.slope) = (self.rate.max(0.0), 0, OnSlope::First);
        self.form = self.law.form(self.reduced_mass, self.approach_speed);
        self.join = Join::Touching(Phase::Approach);
    }

    /// Whether the force would fall below zero without the clamp.
    pub(super) fn can_pull(&self) -> bool {
        let damped = |form: Form| form.action == Action::Both && form.damper.coefficient > 0.0;
        self.form.is_some_and(damped)
    }

    /// Notes that the force before the clamp has changed sign.
    pub(super) fn cross(&mut self, phase: Phase) {
        (self.join, self.crossed) = (Join::Touching(phase), self.time);
    }

    /// Continues on the other slope of the law.
    pub(super) fn bend(&mut self) {
        self.slope = match self.slope {
            OnSlope::First => OnSlope::Second,
            OnSlope::Second => OnSlope::First,
        };
        // The rounding of time would lead back across the bend at once.
        if let Some(second) = self.form.and_then(|form| form.second) {
            self.deformation = second.from;
        }
    }

    /// Gives the floors of the pair an impulse \[N·s\].
    pub(super) fn kick(&self, impulse: f64, members: &mut [Member]) {
        for (floor, part) in self.relation.pushes() {
            let member = &mut members[floor];
            member.state.velocity += member.inverse_mass * (part * impulse);
        }
    }

    /// Phase of compliant contact after a jump of deformation or rate.
    pub(super) fn phase(&self) -> Phase {
        let pulls = |form: &Form| form.action == Action::Both && form.unclamped(self.deformation, self.rate) < 0.0;
        if self.rate > 0.0 {
            Phase::Approach
        } else if self.form.as_ref().is_some_and(pulls) {
            Phase::Clamped
        } else {
            Phase::Restitution
        }
    }

    /// Coefficient of restitution of an impulsive law; `None` for a compliant law.
    pub(super) fn restitution(&self) -> Option<f64> {
        self.law.impulsive().map(|law| law.restitution)
    }

    /// `ahead` plus the difference of a ground quantity between the left and the right side, if the grounds move apart.
    #[inline]
    pub(super) fn over_grounds(&self, ahead: f64, ground: impl Fn(usize) -> f64) -> f64 {
        if self.opens() {
            let [left, right] = self.floors().map(ground);
            ahead + (left - right)
        } else {
            ahead
        }
    }

    /// Coefficient `n` of the displacement of a point, including its ground if the grounds move apart.
    pub(super) fn displacement_of(&self, members: &[Member], point: Point, p: usize, n: usize) -> f64 {
        let own = point.of(|node| members[node].displacement[n]);
        if self.opens() {
            own + members[point.floor()].ground_displacement(p, n)
        } else {
            own
        }
    }

    /// Finds in how many orders neighbours that begin to touch without a rate move alike up to rounding; true if in any. Rounding would
    /// otherwise part them, or press them together, at once.
    pub(super) fn find_alike(&mut self, members: &[Member], power: Power, len: usize) -> bool {
        let begins = matches!(self.join, Join::Touching(_));
        if !begins || self.deformation > 0.0 || self.rate != 0.0 {
            return false;
        }
        let p = power.order();
        let differ = |n: &usize| {
            let points = self.relation.points();
            let values = points.map(|point| self.displacement_of(members, point, p, *n));
            (values[0] - values[1]).abs() > noise(members, self.relation, values, p, *n)
        };
        let first = (2 * p..len).find(differ).unwrap_or(len);
        self.alike = first / p - 2;
        self.alike > 0
    }

    /// Energy \[J\] that the spring still holds if its force is not smooth at the parting, else `None`.
    pub(super) fn rough_remainder(&self) -> Option<f64> {
        let Term { coefficient, power } = self.form?.spring;
        let deformation = self.deformation.max(0.0);
        (power == Exponent::ThreeHalves).then(|| 0.4 * coefficient * deformation * deformation * deformation.sqrt())
    }

    /// Whether the deformation has passed the parting.
    pub(super) fn has_parted(&self) -> bool {
        let touching = matches!(self.join, Join::Touching(phase) if phase != Phase::Approach);
        touching && self.deformation <= 0.0 && self.rate < 0.0
    }
}
