//! Central difference method, with contact as the paper applies it.
//!
//! Source: the paper, equations (1)–(3); Chopra, *Dynamics of Structures*, 5.3. Written per unit of mass, so that a
//! wall is a node of inverse mass 0, and for the increment of the displacement instead of the displacement: the same
//! equation, but rounding then grows with the number of steps and not with its square (at Δt = 5e-7 s over 3 s it
//! would spoil the fourth digit).

use pounding_contact::{ContactLaw, Overlap};
use serde::{Deserialize, Serialize};

use crate::span::Load;
use crate::{
    Clock, Excitation, Impact, Node, Recorder, RestoringForce, Row, RunError, Span, State,
    Velocities, Work,
};

/// Settings of the central difference method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentralDifference {
    /// How the first step begins.
    pub start: Start,
}

/// The three ways to begin a central difference run; u₋₁ is the displacement one step before t = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Start {
    /// The textbook start: u₋₁ = u₀ − Δt u̇₀ + Δt² ü₀/2 with ü₀ from equilibrium.
    Consistent,
    /// u₋₁ = u₀ − Δt u̇₀: one of the paper's two starts (u₋₁ = u₀ = 0 there).
    FirstLoadUsed,
    /// u₁ = u₀ + Δt u̇₀, the first equation being that of node 1: the paper's other start (u₀ = u₁ = 0 there).
    FirstLoadSkipped,
}

/// What each structure carries from step to step.
struct Body<Memory> {
    displacement: f64,
    /// Displacement minus that of the node before \[m\].
    increment: f64,
    /// Central-difference velocity at the node before; what the paper's impact rule looks at.
    velocity: f64,
    memory: Memory,
    /// Start of the span under way.
    start: State,
    force_from_left: f64,
    force_from_right: f64,
    /// Net impulse of the impacts at this node \[N·s\].
    impulse: f64,
}

/// Constants of one structure's equation (3), divided by its mass.
struct Coefficients {
    inverse_mass: f64,
    /// c/m.
    damping: f64,
    /// 1/(1/Δt² + c/(2mΔt)).
    solve: f64,
    /// 1/Δt² − c/(2mΔt).
    carry: f64,
    /// 1 for a structure, 0 for a wall: walls do not feel inertia.
    mobile: f64,
}

impl Coefficients {
    fn new<Column>(node: &Node<Column>, dt: f64) -> Self {
        let damping = node.inverse_mass * node.damping;
        let (inertia, half) = (1.0 / (dt * dt), 0.5 * damping / dt);
        Self {
            inverse_mass: node.inverse_mass,
            damping,
            solve: 1.0 / (inertia + half),
            carry: inertia - half,
            mobile: if node.is_wall() { 0.0 } else { 1.0 },
        }
    }
}

/// Integrates a row; the shared signature of all methods.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: CentralDifference,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    clock: Clock,
    recorder: &mut R,
) -> Result<Work, RunError> {
    let dt = clock.time_step;
    let ground = excitation.sampled(clock);
    let coefficients: Vec<_> = row
        .nodes()
        .iter()
        .map(|node| Coefficients::new(node, dt))
        .collect();
    let mut bodies: Vec<_> = row
        .nodes()
        .iter()
        .map(|node| begin(node, settings.start, ground[0], dt))
        .collect();
    let mut impulses = vec![0.0; row.pairs().len()];
    let mut work = Work::default();
    let first = usize::from(settings.start == Start::FirstLoadSkipped);
    // Node n is reached by the step before the last; the last one gives it a velocity.
    let mut before = 0.0;
    for (step, &ground) in ground.iter().enumerate().skip(first) {
        let hit = touch(row, &mut bodies, &mut impulses, dt, &mut work);
        let nodes = row.nodes().iter().zip(&coefficients);
        for (index, (body, (node, constants))) in bodies.iter_mut().zip(nodes).enumerate() {
            let central = body.velocity;
            let end = advance(body, constants, &node.column, ground, dt);
            if !body.displacement.is_finite() {
                return Err(RunError::Diverged {
                    structure: index,
                    time: clock.time(step + 1),
                    time_step: dt,
                });
            }
            if step > 0 {
                let times = (clock.time(step - 1), clock.time(step));
                let ends = [body.start, end];
                // The equation's damping force is that of the central velocity, half way through a jump.
                let loads = [
                    Load::at(&ends[0], node.damping * central, before),
                    Load::at(&ends[1], node.damping * body.velocity, ground),
                ];
                // The node before the first solved one has no equation.
                let weights = [if step > first { 1.0 } else { 0.0 }, 1.0];
                recorder.span(&Span::step::<R, _>(
                    index,
                    times,
                    ends,
                    (0.5 * dt, weights),
                    loads,
                ));
            }
            let jump = constants.inverse_mass * body.impulse;
            body.start = end;
            body.start.velocity += jump;
            body.start.acceleration -= constants.damping * jump;
        }
        if hit {
            report(row, &bodies, &impulses, clock.time(step), recorder);
        }
        before = ground;
        work.steps += 1;
        work.force_evaluations += bodies.len() as u64;
    }
    Ok(work)
}

/// The body at its first node to be solved: node 0, or node 1 when the first load is skipped.
fn begin<Column: RestoringForce>(
    node: &Node<Column>,
    start: Start,
    ground: f64,
    dt: f64,
) -> Body<Column::Memory> {
    let (u, v) = (node.initial_displacement, node.initial_velocity);
    let response = node.column.respond(u, Column::Memory::default());
    let ground = if node.is_wall() { 0.0 } else { ground };
    let acceleration = -ground - node.inverse_mass * (node.damping * v + response.force);
    let (displacement, increment) = match start {
        Start::Consistent => (u, dt * (v - 0.5 * dt * acceleration)),
        Start::FirstLoadUsed => (u, dt * v),
        Start::FirstLoadSkipped => (u + dt * v, dt * v),
    };
    Body {
        displacement,
        increment,
        velocity: v,
        memory: response.memory,
        start: State {
            displacement: u,
            velocity: v,
            acceleration,
            restoring_force: response.force,
            ..State::default()
        },
        force_from_left: 0.0,
        force_from_right: 0.0,
        impulse: 0.0,
    }
}

/// Contact at the current node, each pair alone; true when a pair received an impulse.
///
/// Compliant laws see the backward difference of the deformation as its rate, also where the deformation one step
/// earlier was negative. Impulsive laws follow the paper's rule: an overlap found now, the velocities of the node
/// before, one impulse per step, no correction of the displacements. The rule does not converge as Δt → 0.
fn touch<Column: RestoringForce, Memory>(
    row: &Row<Column>,
    bodies: &mut [Body<Memory>],
    impulses: &mut [f64],
    dt: f64,
    work: &mut Work,
) -> bool {
    for body in bodies.iter_mut() {
        (body.force_from_left, body.force_from_right, body.impulse) = (0.0, 0.0, 0.0);
    }
    let mut hit = false;
    for (pair, impulse) in row.pairs().iter().zip(impulses) {
        *impulse = 0.0;
        let (left, right) = (&bodies[pair.left], &bodies[pair.right]);
        let deformation = left.displacement - right.displacement - pair.gap;
        if deformation > 0.0 {
            work.touching_steps += 1;
            let reduced_mass = row.reduced_mass(pair);
            match pair.law {
                ContactLaw::NonlinearViscoelastic(law) => {
                    let rate = (left.increment - right.increment) / dt;
                    let force = law
                        .respond(&Overlap {
                            deformation,
                            rate,
                            reduced_mass,
                        })
                        .force;
                    bodies[pair.left].force_from_right = -force;
                    bodies[pair.right].force_from_left = force;
                }
                ContactLaw::Stereomechanical(law) => {
                    let rate = left.velocity - right.velocity;
                    if rate > 0.0 {
                        *impulse = law.impulse(rate, reduced_mass);
                        bodies[pair.left].impulse -= *impulse;
                        bodies[pair.right].impulse += *impulse;
                        hit = true;
                    }
                }
            }
        }
    }
    hit
}

/// Solves equation (3) for the next displacement; returns the state at the current node, before its impacts.
#[inline]
fn advance<Column: RestoringForce>(
    body: &mut Body<Column::Memory>,
    constants: &Coefficients,
    column: &Column,
    ground: f64,
    dt: f64,
) -> State {
    let response = column.respond(body.displacement, body.memory);
    let pounding_force = body.force_from_left + body.force_from_right;
    let smooth =
        constants.inverse_mass * (pounding_force - response.force) - constants.mobile * ground;
    let jump = constants.inverse_mass * body.impulse;
    let load = smooth + jump / dt;
    let increment = constants.solve * (load + constants.carry * body.increment);
    let velocity = (increment + body.increment) / (2.0 * dt);
    let state = State {
        displacement: body.displacement,
        // The central velocity lies in the middle of the jump.
        velocity: velocity - 0.5 * jump,
        acceleration: smooth - constants.damping * (velocity - 0.5 * jump),
        restoring_force: response.force,
        force_from_left: body.force_from_left,
        force_from_right: body.force_from_right,
    };
    body.displacement += increment;
    body.increment = increment;
    body.velocity = velocity;
    body.memory = response.memory;
    state
}

/// Reports the impacts of a node after its spans.
fn report<Column: RestoringForce, Memory, R: Recorder>(
    row: &Row<Column>,
    bodies: &[Body<Memory>],
    impulses: &[f64],
    time: f64,
    recorder: &mut R,
) {
    let before = |index: usize| {
        bodies[index].start.velocity - row.nodes()[index].inverse_mass * bodies[index].impulse
    };
    for (index, (pair, &impulse)) in row.pairs().iter().zip(impulses).enumerate() {
        if impulse > 0.0 {
            recorder.impact(&Impact {
                pair: index,
                left: pair.left,
                right: pair.right,
                time,
                impulse,
                before: Velocities {
                    left: before(pair.left),
                    right: before(pair.right),
                },
                after: Velocities {
                    left: bodies[pair.left].start.velocity,
                    right: bodies[pair.right].start.velocity,
                },
            });
        }
    }
}
