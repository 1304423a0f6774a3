//! Event-driven integration without a time step: power series between events, events found by bounds.
//!
//! Between two events the equation of motion of a floor is linear, with a load that is linear in time. Its solution is a power series whose
//! coefficients follow from the equation itself, on pieces so short that about twenty coefficients reach rounding. Storeys couple the
//! series of the floors of a building. Columns that yield smoothly have separate series.
//!
//! Events are the samples of the record, yielding, unloading (zeros of velocities and of rates of drifts), touching and parting. The fading
//! of a contact force and the reversal of the rate of deformation are events, too. Impulsive contact is a jump of velocities. Endless
//! bouncing is summed up, and the neighbours then move together while they press. Compliant contact couples the series of the structures
//! that touch. Just after the first touch, where the force is not smooth in time, the series run in the fourth root of time.
//!
//! Sources: the relations of several simultaneous impacts follow M. Frémond and F. Pfeiffer's complementarity form with Newton's
//! restitution; Taylor series as an integrator: À. Jorba and M. Zou, *Experimental Mathematics* 14 (2005) 99.

mod bend;
mod body;
mod clock;
mod columns;
mod contact;
mod cost;
mod flight;
mod force;
mod friction;
mod groups;
mod hits;
mod impacts;
mod landing;
mod link_laws;
mod links;
mod look_ahead;
mod member;
mod noise;
mod rest;
mod rest_any;
mod rounding;
mod series;
mod settle;
mod shaking;
mod stick;
mod storey;
mod tie;
mod watch;

use crate::budget::Guard;
use crate::error::require;
use crate::impact::any_rounds::AnyRounds;
use crate::model::buildings::Buildings;
use crate::model::ground::Ground;
use crate::model::incidence::Incidence;
use crate::{Course, Excitation, Hysteretic, Motion, Node, Recorder, Row, RunError, Touch, Work};

use crate::roots::SHORTEST_WAY;
use body::Body;
pub use body::in_flight;
use clock::LocalClock;
use contact::System;
use contact::{Grounds, PairState};
use flight::Flights;
pub use flight::LONGEST as LONGEST_LEAP;
use groups::Groups;
use impacts::Chain;
pub use impacts::SimultaneousImpacts;
use links::LinkState;
use member::Member;
pub use rounding::OF_COEFFICIENTS as ROUNDING_OF_COEFFICIENTS;
use shaking::Shaking;

/// Settings of the exact method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exact {
    /// Relative truncation error of a piece in compliant contact, or with columns that yield smoothly \[–\], 1e-16 ..= 1e-3.
    ///
    /// Free flight and impulsive contact are always exact to rounding. For two structures with ten viscoelastic collisions, 1e-4 takes 2134
    /// pieces, 1e-8 2186 and 1e-16 2600.
    pub tolerance: f64,
    /// What happens when several pairs touch at the same instant.
    pub simultaneous_impacts: SimultaneousImpacts,
}

impl Exact {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`RunError::Setting`] if a setting is out of range.
    pub fn check(&self) -> Result<(), RunError> {
        let valid = (1e-16..=1e-3).contains(&self.tolerance);
        require(valid, "tolerance", self.tolerance, "1e-16 to 1e-3")
    }
}

impl Default for Exact {
    fn default() -> Self {
        Self {
            tolerance: 1e-16,
            simultaneous_impacts: SimultaneousImpacts::Together,
        }
    }
}

/// Bounces with less remaining duration than this are summed \[s\].
pub const CHATTER: f64 = 1e-12;
/// Impacts of a pair within the shortest remainder after which the next one is plastic, whatever its neighbours do.
pub const BURST: u32 = 50;
/// Most events at an instant, and the number that each structure adds. The run is given up beyond.
const MOST_AT_ONCE: usize = 1000;
const MOST_AT_ONCE_EACH: usize = 10;
/// Whether bounces that start with this rate \[m/s\] (< 0 while the pair parts), under this acceleration towards each other \[m/s²\], end
/// at once.
pub fn bounces_are_over(rate: f64, closing: f64, restitution: f64) -> bool {
    let parts = rate < 0.0 && closing > 0.0 && restitution < 1.0;
    parts && -2.0 * rate < CHATTER * closing * (1.0 - restitution)
}

/// All data of a run, in parts. A step that needs a single part is a method of this part; a step that joins several parts is a method of
/// the run.
struct ExactRun<'a, R> {
    settings: Exact,
    shaking: Shaking<'a>,
    moving: Moving<'a>,
    touching: Touching<'a>,
    agenda: Agenda,
    recorder: &'a mut R,
}

/// The moving parts: floors and walls, and the pieces of their motion.
struct Moving<'a> {
    members: Vec<Member>,
    links: Vec<LinkState>,
    /// Incidence of links and nodes.
    linking: &'a Incidence,
    /// Number of walls.
    walls: usize,
    buildings: &'a Buildings,
    /// The body that begins with each node.
    bodies: Vec<Body>,
    /// Members whose bodies wait for their next piece.
    landed: Vec<bool>,
    /// Free flight of the whole row from sample to sample.
    flights: Flights,
}

impl<'a> Moving<'a> {
    /// The state at t = 0: every body waits for its first piece.
    fn new<Column: Hysteretic>(row: &'a Row<Column>, members: Vec<Member>, links: Vec<LinkState>, step: f64) -> Self {
        Self {
            links,
            linking: row.linking(),
            walls: members.iter().filter(|member| member.is_wall()).count(),
            buildings: row.buildings(),
            bodies: vec![Body::at_start(); members.len()],
            landed: vec![true; members.len()],
            flights: Flights::new(&members, step),
            members,
        }
    }
}

/// The touching parts: the contacts, and the bodies that they form.
struct Touching<'a> {
    contacts: Vec<PairState>,
    /// Which pairs meet which nodes.
    incidence: &'a Incidence,
    /// The body of each node.
    groups: Groups,
    /// Pairs whose impacts at this instant are done.
    settled: Vec<bool>,
    /// Impulses in a chain.
    chain: Chain,
    /// Impulses in other rows, and the pairs that rest.
    rounds: AnyRounds,
}

impl<'a> Touching<'a> {
    /// The state before the first event.
    fn new(contacts: Vec<PairState>, incidence: &'a Incidence, groups: Groups) -> Self {
        Self {
            settled: vec![false; contacts.len()],
            contacts,
            incidence,
            groups,
            chain: Chain::default(),
            rounds: AnyRounds::new(0, 0),
        }
    }

    /// Whether the pairs form a chain of neighbours: pairs at rest then move as blocks, and impacts pass along the chain.
    fn is_chain(&self) -> bool {
        self.groups.is_chain
    }
}

/// The next events, and the work so far.
struct Agenda {
    clock: LocalClock,
    /// End of the run, on the clock.
    end: f64,
    guard: Guard,
    /// Pieces tried in the search for pairs at rest.
    tried: u64,
    work: Work,
}

impl Agenda {
    /// Pieces that count towards the budget.
    fn spent(&self) -> u64 {
        self.work.segments + self.tried
    }
}

/// Integrates a row. Every method has a `run` function with these arguments. This one uses only the end of the clock.
pub(crate) fn run<Column: Hysteretic, R: Recorder>(
    settings: Exact,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    Course { clock, budget }: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    settings.check()?;
    let n = row.nodes().len();
    let guard = clock.within(budget).begin(n);
    guard.wait(0.0)?;
    let contact = |pair: &crate::Pair| {
        let ahead = |quantity: fn(&Node<Column>) -> f64| pair.relation.ahead(|index| quantity(&row.nodes()[index]));
        let deformation = ahead(|node| node.initial_displacement) - pair.gap();
        let rate = ahead(|node| node.initial_velocity);
        let mut contact = PairState::new(pair, row.reduced_mass(pair), [deformation, rate]);
        let [first, last] = contact.floors().map(|index| row.arrival(index));
        if first.total_cmp(&last).is_ne() {
            contact.grounds = Grounds::Apart;
        }
        contact
    };
    let (initial, _) = row.initial(Ground::Common(0.0));
    let member = |node: usize| {
        let mut member = Member::new(row, node, &initial);
        member.falls_at = recorder.falls_at(node);
        member
    };
    let members: Vec<_> = (0..n).map(member).collect();
    let contacts: Vec<_> = row.pairs().iter().map(contact).collect();
    let system = System {
        members: &members,
        contacts: &contacts,
        incidence: row.incidence(),
    };
    let links = LinkState::of(row)?;
    let groups = Groups::new(system, links.iter().map(|link| link.relation).collect(), row.is_chain());
    guard.wait(0.0)?;
    let mut run = ExactRun {
        settings,
        shaking: Shaking::new(excitation, row.travel(excitation)),
        moving: Moving::new(row, members, links, excitation.time_step()),
        touching: Touching::new(contacts, row.incidence(), groups),
        agenda: Agenda {
            clock: LocalClock::new(excitation.sampling()),
            end: clock.time(clock.n_steps),
            guard,
            tried: 0,
            work: Work::default(),
        },
        recorder,
    };
    run.check_cost(budget.pieces)?;
    match run.run() {
        Ok(()) => Ok(run.agenda.work),
        Err(error) => Err(error.later(run.agenda.clock.zero())),
    }
}

impl<R: Recorder> ExactRun<'_, R> {
    fn run(&mut self) -> Result<(), RunError> {
        if self.agenda.end <= 0.0 {
            return Ok(());
        }
        self.go_on(0.0)?;
        let (mut now, mut at_once) = (0.0, 0);
        let most_at_once = MOST_AT_ONCE + MOST_AT_ONCE_EACH * self.moving.members.len();
        loop {
            let time = self.next_event();
            if time >= self.agenda.end && self.bodies_at_end() {
                return Ok(());
            }
            // Measured by the clock of recorders: less is no progress. Near 0 s this clock resolves any two instants.
            let [before, time_shown] = [now, time].map(|time| self.agenda.clock.absolute(time));
            let later = time_shown > before + SHORTEST_WAY;
            at_once = if later { 0 } else { at_once + 1 };
            self.agenda.guard.look(time, self.agenda.spent())?;
            // Set the clock before anything lands: the rounded duration of a piece then depends only on its ends.
            let time = time - self.set_clock(time);
            if at_once > most_at_once {
                let events = self.agenda.work.events;
                return Err(RunError::NoProgress { time, events });
            }
            self.agenda.work.events += 1;
            self.land_all(time)?;
            if self.recorder.fallen().is_some() {
                return self.end_at(time);
            }
            now = self.fly(time);
            self.go_on(now)?;
        }
    }

    /// Ends the run early: reports all motion until now.
    fn end_at(&mut self, time: f64) -> Result<(), RunError> {
        for first in 0..self.moving.bodies.len() {
            if self.touching.groups.body_of[first] == first {
                self.agenda.guard.wait(time)?;
                self.land(first, time);
            }
        }
        Ok(())
    }

    /// Gives a body the ground motion from an instant on; returns the time at which the next sample arrives at any of its nodes.
    fn shake(&mut self, first: usize, time: f64) -> f64 {
        let mut end = f64::INFINITY;
        for place in self.touching.groups.nodes_of(first) {
            let node = self.touching.groups.node(place);
            let segment = self.shaking.segment(self.agenda.clock, time, self.moving.members[node].arrival);
            self.moving.members[node].ground = segment;
            end = end.min(segment.end);
        }
        end
    }

    /// How far the grounds of a pair have moved towards each other, and at which rate; `None` if they move alike.
    fn opening(&self, pair: usize, time: f64) -> Option<Motion> {
        let contact = &self.touching.contacts[pair];
        self.shaking.opening(contact, self.agenda.clock.past(time))
    }

    /// Deformation and rate of a pair from the motions of its sides over their grounds.
    fn closing(&self, pair: usize, time: f64, [left, right]: [Motion; 2]) -> (f64, f64) {
        let ahead = left.since(right);
        let Motion { displacement, velocity } = match self.opening(pair, time) {
            None => ahead,
            Some(opening) => ahead.over(opening),
        };
        (displacement - self.touching.contacts[pair].relation.offset, velocity)
    }

    /// The next instant at which a piece ends or a pair touches.
    fn next_event(&self) -> f64 {
        let firsts = self.moving.bodies.iter().enumerate();
        let ends = firsts
            .filter(|(first, _)| self.touching.groups.body_of[*first] == *first)
            .map(|(_, body)| body.end);
        let touches = self.touching.contacts.iter().map(|contact| contact.meets);
        ends.chain(touches).fold(f64::INFINITY, f64::min)
    }

    fn bodies_at_end(&self) -> bool {
        self.touching
            .groups
            .body_of
            .iter()
            .all(|&first| self.agenda.clock.shown(self.moving.bodies[first].start) >= self.agenda.end)
    }

    /// Ends every piece that ends at this instant, and the pieces of pairs that touch at it.
    fn land_all(&mut self, time: f64) -> Result<(), RunError> {
        for first in 0..self.moving.bodies.len() {
            if self.touching.groups.body_of[first] == first && self.moving.bodies[first].end <= time {
                self.agenda.guard.wait(time)?;
                self.land(first, time);
            }
        }
        for pair in 0..self.touching.contacts.len() {
            if self.touching.contacts[pair].meets <= time {
                self.agenda.guard.wait(time)?;
                let rate = self.touching.contacts[pair].rate_at_touch(self.agenda.clock);
                for floor in self.touching.contacts[pair].floors() {
                    self.land(self.touching.groups.body_of[floor], time);
                }
                self.touching.contacts[pair].touch(time, rate);
                self.report_touch(pair, time);
            }
        }
        self.land_touching(time)
    }

    fn report_touch(&mut self, pair: usize, time: f64) {
        let contact = &self.touching.contacts[pair];
        let acceleration = |node: usize| self.moving.members[node].state.acceleration;
        let mut closing = contact.relation.ahead(acceleration);
        let now = self.agenda.clock.past(time);
        if let Some(acceleration) = self.shaking.opening_acceleration(contact, now) {
            closing += acceleration;
        }
        let time = self.agenda.clock.absolute(time);
        let uncertainty = Touch::uncertainty(time, rounding::OF_SUMS * contact.scale, contact.rate, closing);
        self.recorder.touch(&Touch {
            pair,
            time,
            approach_speed: contact.rate.max(0.0),
            uncertainty,
        });
    }

    /// Ends the pieces of neighbours with a closed gap to a landed body: they take part in this instant.
    fn land_touching(&mut self, time: f64) -> Result<(), RunError> {
        let mut grown = true;
        while grown {
            self.agenda.guard.wait(time)?;
            grown = false;
            for pair in 0..self.touching.contacts.len() {
                let contact = &self.touching.contacts[pair];
                let closed = contact.time >= time && contact.deformation == 0.0;
                let floors = contact.floors();
                if closed && self.moving.landed[floors[0]] != self.moving.landed[floors[1]] {
                    for floor in floors {
                        self.land(self.touching.groups.body_of[floor], time);
                    }
                    grown = true;
                }
            }
        }
        Ok(())
    }

    /// Resolves the events of this instant and starts the next piece of everything that has landed.
    fn go_on(&mut self, time: f64) -> Result<(), RunError> {
        self.resolve(time)?;
        for first in 0..self.moving.bodies.len() {
            if self.touching.groups.body_of[first] == first && self.moving.landed[first] {
                self.agenda.guard.wait(time)?;
                self.launch(first, time)?;
            }
        }
        self.part_roots(time)?;
        for pair in 0..self.touching.contacts.len() {
            let floors = self.touching.contacts[pair].floors();
            if floors.into_iter().any(|floor| self.moving.landed[floor]) {
                self.agenda.guard.wait(time)?;
                self.look_ahead(pair, time);
            }
        }
        self.moving.landed.fill(false);
        Ok(())
    }

    /// Ends the earlier of two neighbouring pieces that run in roots of time from different instants.
    fn part_roots(&mut self, time: f64) -> Result<(), RunError> {
        for pair in 0..self.touching.contacts.len() {
            while let Some(first) = self.conflict(pair) {
                self.agenda.guard.wait(time)?;
                self.land(first, time);
                self.launch(first, time)?;
            }
        }
        Ok(())
    }
}
