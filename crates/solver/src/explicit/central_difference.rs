//! Central difference method: compliant contact by forces at nodes, impulsive contact by velocity jumps.
//!
//! Source: the paper, equations (1)–(3); Chopra, *Dynamics of Structures*, 5.3. The equations are written per unit of mass, so that a wall
//! is a node of inverse mass 0. The unknown is the increment of the displacement instead of the displacement. The equation is equivalent,
//! but rounding then grows with the number of steps instead of its square. The square would spoil the fourth digit at Δt = 5e-7 s over 3 s.
//!
//! Where the velocity jumps or the step changes its length, the increment is restarted like a run in the textbook. It follows from the
//! velocity and the acceleration at the node: Δt u̇ + Δt² ü/2. For a smooth motion this is the same equation, so that a restart costs no
//! accuracy.
//!
//! Links pull at nodes before the equations are solved. Their springs follow the displacements there. Their dashpots follow velocities that
//! the last two increments extrapolate to the node, which is of second order.
//!
//! Floors that stand on floors share M/Δt² + C/2Δt through the dashpots between them: a tridiagonal system for every building
//! (`building.rs`). Rows of structures of one storey have a separate loop.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

pub(crate) mod building;
pub(crate) mod coefficients;
mod contact;
mod links;
mod storeys;

use pounding_contact::Number;

use coefficients::Coefficients;
use storeys::Storeys;

use crate::error::require;
use crate::impact::impacts::Impacts;
use crate::link_forces::LinkForces;
use crate::march::{ClockStep, Stepping, march};
use crate::model::approach::Approaches;
use crate::model::ground::Ground;
use crate::pushes::Pushes;
use crate::span::{Load, StoreyForces, Weights};
use crate::{Course, Excitation, Node, Recorder, RestoringForce, Row, RunError, Span, State, Work};

/// Settings of the central difference method. Order 2 while nothing touches, critical time step 2/ω = T/π.
///
/// A run begins from equilibrium, as in textbooks: u₋₁ = u₀ − Δt u̇₀ + Δt² ü₀/2. Impulsive contact is a jump of the velocities at the node
/// at which an overlap is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CentralDifference {
    /// Substeps of a time step for structures that touch, 1 to 1000.
    ///
    /// A structure sub-steps from a node at which it overlaps a neighbour, or would overlap a neighbour at the next node, to the next node.
    /// A building sub-steps with all its floors. Others take the whole step.
    pub contact_substeps: u32,
}

/// Most substeps. A larger number would make the run many times longer than its time step suggests.
const MOST_SUBSTEPS: u32 = 1000;

impl Default for CentralDifference {
    /// Whole steps everywhere.
    fn default() -> Self {
        Self { contact_substeps: 1 }
    }
}

impl CentralDifference {
    /// Checks the settings.
    ///
    /// # Errors
    /// [`RunError::Setting`] if a setting is out of range.
    pub fn check(self) -> Result<(), RunError> {
        let valid = (1..=MOST_SUBSTEPS).contains(&self.contact_substeps);
        let found = self.contact_substeps.into();
        require(valid, "contact_substeps", found, "1 to 1000")
    }
}

/// State of a structure from step to step.
struct Body<Memory> {
    displacement: f64,
    /// Displacement minus that of the node before \[m\].
    increment: f64,
    /// The increment before \[m\].
    earlier: f64,
    /// Whether the node before is a sub-step back.
    fine: bool,
    /// Central-difference velocity at the node before, before its jump. The damping force of the equation belongs to this velocity.
    velocity: f64,
    memory: Memory,
    /// Start of the present span.
    start: State,
    start_time: f64,
    start_ground: f64,
    force_from_left: f64,
    force_from_right: f64,
    /// Net force of links \[N\].
    link_force: f64,
    /// Excess impulses of a whole step from the left and from the right \[N·s\]. They arise if a neighbour that sub-steps is met at the end
    /// of the step: the force acts on both sides for half a sub-step.
    excess: (f64, f64),
}

impl<Memory> Body<Memory> {
    /// Sets the next increment from the state at this node, for a step of this length.
    fn restart(&mut self, time_step: f64) {
        let State {
            velocity, acceleration, ..
        } = self.start;
        self.increment = Coefficients::restarted(time_step, velocity, acceleration);
        self.earlier = first_increment([velocity, acceleration], time_step);
        self.displacement = self.start.displacement + self.increment;
    }

    /// Net force of neighbours and links \[N\].
    #[inline]
    fn pushed(&self) -> f64 {
        self.force_from_left + self.force_from_right + self.link_force
    }

    /// Removes the excess of a whole step from the velocity at its end. The increment is restarted afterwards.
    fn give_back(&mut self, end: &mut State, constants: &Coefficients) {
        let half_damping = 0.5 * constants.damping * constants.time_step;
        let excess = constants.inverse_mass * (self.excess.0 + self.excess.1);
        let change = excess / (1.0 + half_damping);
        end.velocity -= change;
        end.acceleration += constants.damping * change;
        self.velocity = end.velocity;
    }
}

/// A node of the run, or of the sub-steps of those that touch.
#[derive(Clone, Copy)]
struct Instant<'a> {
    ground: Ground<'a>,
    time: f64,
    /// Time of the next node, for messages \[s\].
    next: f64,
    /// Whether only structures that sub-step have a node here.
    fine: bool,
}

/// A run: its model and all its memory, allocated once.
struct CentralDifferenceRun<'a, Column: RestoringForce> {
    row: &'a Row<Column>,
    /// Whole step and sub-step \[s\].
    steps: [f64; 2],
    /// Coefficients of every structure, for both lengths.
    coefficients: [Vec<Coefficients>; 2],
    bodies: Vec<Body<Column::Memory>>,
    /// `None` if all structures have one storey.
    storeys: Option<Storeys>,
    /// States at a node with velocity jumps.
    states: Vec<State>,
    jumps: Impacts,
    /// The impulse of each push is the excess of a whole step until its span ends.
    pushes: Pushes,
    approaches: Approaches,
    /// `None` if the row has no links.
    links: Option<LinkForces>,
    /// Whether the force of a link on each floor has jumped, at a node with velocity jumps.
    relinked: Vec<bool>,
    substeps: u32,
}

/// Integrates a row. Every method has a `run` function with these arguments.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: CentralDifference,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    settings.check()?;
    let begin = |ground: Ground<'_>| CentralDifferenceRun::new(settings, row, ground, course.clock.time_step);
    let substeps = settings.contact_substeps as usize;
    march(row, excitation, course, substeps, begin, recorder)
}

impl<Column: RestoringForce> Stepping<Column> for CentralDifferenceRun<'_, Column> {
    /// Node n is reached by the second-last step; the last step gives it a velocity.
    const FIRST: usize = 0;

    #[inline]
    fn step<R: Recorder>(&mut self, _: &Row<Column>, step: ClockStep<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError> {
        let (number, clock, substeps) = (step.number, step.clock, self.substeps);
        let node = Instant {
            ground: step.ground(number),
            time: clock.time(number),
            next: clock.time(number + 1),
            fine: false,
        };
        self.node(node, work, recorder)?;
        let refines = substeps > 1 && number < clock.n_steps;
        if refines && self.refine([node.ground, step.ground(number + 1)]) {
            for part in 1..substeps {
                let fraction = f64::from(part) / f64::from(substeps);
                let between = Instant {
                    ground: step.within(number, fraction),
                    time: node.time + fraction * clock.time_step,
                    fine: true,
                    ..node
                };
                self.node(between, work, recorder)?;
            }
        }
        Ok(())
    }
}

/// Displacement at t = 0 minus displacement one step before \[m\], from the velocity and acceleration at t = 0.
#[inline(always)]
pub fn first_increment<N: Number>([velocity, acceleration]: [N; 2], dt: f64) -> N {
    let (step, half) = (velocity.like(dt), velocity.like(0.5 * dt));
    step * (velocity - half * acceleration)
}

/// The increment before the first one \[m\]: [`Coefficients::extrapolated`] makes the velocity at t = 0 of both.
#[inline(always)]
pub fn increment_before<N: Number>(first: N, acceleration: N, dt: f64) -> N {
    first - first.like(dt * dt) * acceleration
}

/// The body at t = 0.
fn begin<Memory>(state: State, memory: Memory, ground: f64, dt: f64) -> Body<Memory> {
    let increment = first_increment([state.velocity, state.acceleration], dt);
    Body {
        displacement: state.displacement,
        increment,
        earlier: increment_before(increment, state.acceleration, dt),
        fine: false,
        velocity: state.velocity,
        memory,
        start: state,
        start_time: 0.0,
        start_ground: ground,
        force_from_left: 0.0,
        force_from_right: 0.0,
        link_force: 0.0,
        excess: (0.0, 0.0),
    }
}

impl<'a, Column: RestoringForce> CentralDifferenceRun<'a, Column> {
    fn new(settings: CentralDifference, row: &'a Row<Column>, ground: Ground<'_>, dt: f64) -> Self {
        let steps = [dt, dt / f64::from(settings.contact_substeps)];
        let constants = |dt: f64| {
            let nodes = row.nodes().iter();
            nodes.map(|node| Coefficients::new(node, dt)).collect()
        };
        let (mut states, memories) = row.initial(ground);
        let links = links::begin(row, &mut states, ground);
        let bodies: Vec<_> = states
            .into_iter()
            .zip(memories)
            .enumerate()
            .map(|(node, (state, memory))| begin(state, memory, ground.under(node), dt))
            .collect();
        Self {
            row,
            steps,
            coefficients: steps.map(constants),
            storeys: Storeys::of(row, steps),
            states: bodies.iter().map(|body| body.start).collect(),
            bodies,
            jumps: Impacts::new(row),
            pushes: Pushes::new(row.incidence()),
            approaches: Approaches::new(row.pairs().len()),
            relinked: vec![false; row.nodes().len()],
            links,
            substeps: settings.contact_substeps,
        }
    }

    /// One node: contact, the equations and spans of all structures with a node here, impacts.
    fn node<R: Recorder>(&mut self, node: Instant<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError> {
        let hit = self.touch(node, work);
        self.pull(node);
        if self.storeys.is_some() {
            self.advance_storeys(node, work, recorder)?;
        } else {
            self.advance(node, work, recorder)?;
        }
        if hit {
            self.jump(node, recorder)?;
        }
        Ok(())
    }

    /// Solves the equations of a node, structure by structure, and reports the spans that end there.
    fn advance<R: Recorder>(&mut self, node: Instant<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError> {
        let structures = self.bodies.iter_mut().zip(self.row.nodes());
        for (index, (body, structure)) in structures.enumerate() {
            if node.fine && !body.fine {
                continue;
            }
            let constants = &self.coefficients[usize::from(body.fine)][index];
            let Node { column, damping, .. } = structure;
            let central = body.velocity;
            let ground = node.ground.under(index);
            let mut end = advance(body, constants, column, ground);
            if body.excess != (0.0, 0.0) {
                body.give_back(&mut end, constants);
            }
            if !body.displacement.is_finite() {
                return Err(RunError::Diverged {
                    structure: index,
                    time: node.next,
                    time_step: self.steps[0],
                });
            }
            if node.time > body.start_time {
                let times = [body.start_time, node.time];
                let ends = [body.start, end];
                let load = |end: &State, velocity: f64, ground: f64| {
                    let forces = StoreyForces {
                        restoring: end.restoring_force,
                        damping: damping * velocity,
                    };
                    Load::at(end, forces, ground)
                };
                let loads = [load(&ends[0], central, body.start_ground), load(&ends[1], body.velocity, ground)];
                let weights = Weights::trapezoidal(0.5 * constants.time_step);
                let mut span = Span::step(recorder.reads_weighed(), index, times, ends, weights, loads);
                span.impulse_from_left -= body.excess.0;
                span.impulse_from_right -= body.excess.1;
                let slots = self.row.incidence().slots_at(index);
                self.pushes.end(slots.clone(), weights.scale);
                span.pushes = self.pushes.of(slots);
                if let Some(links) = &mut self.links {
                    span.links = links.end(self.row.linking().slots_at(index), weights.scale);
                }
                recorder.span(&span);
            }
            body.start = end;
            body.start_time = node.time;
            body.start_ground = ground;
            work.force_evaluations += 1;
        }
        Ok(())
    }
}

/// Solves equation (3) for the next displacement. Returns the state at the current node, before its velocity jumps.
#[inline]
fn advance<Column: RestoringForce>(body: &mut Body<Column::Memory>, constants: &Coefficients, column: &Column, ground: f64) -> State {
    let response = column.respond(body.displacement, body.memory);
    let pushed = body.pushed();
    let smooth = constants.smooth(pushed, response.force, constants.mobile * ground);
    let increment = constants.next(smooth, body.increment);
    let velocity = constants.velocity([body.increment, increment]);
    let state = State {
        displacement: body.displacement,
        velocity,
        acceleration: smooth - constants.damping * velocity,
        restoring_force: response.force,
        force_from_left: body.force_from_left,
        force_from_right: body.force_from_right,
    };
    body.displacement += increment;
    (body.earlier, body.increment) = (body.increment, increment);
    body.velocity = velocity;
    body.memory = response.memory;
    state
}
