//! Newton's method for the equilibrium of a cluster: one structure, or neighbours that touch.
//!
//! The unknowns are the accelerations at the end of the step. With displacement increments as unknowns the terms
//! 4u/Δt² would cancel and leave a residual of 1e-9 at Δt = 1e-4 s; accelerations do not cancel.

use pounding_contact::{ContactLaw, Overlap};

use crate::{Node, Response, RestoringForce, Row, Work};

/// Largest residual of equilibrium accepted, relative to the sum of the magnitudes of its terms.
///
/// Rounding leaves about 1e-15; a tighter bound buys nothing.
pub(crate) const TOLERANCE: f64 = 1e-12;
/// Iterations after which a cluster is given up.
pub(crate) const MAX_ITERATIONS: u32 = 50;

/// One structure during a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trial<Memory> {
    /// Acceleration at the end of the step, the unknown \[m/s²\].
    pub(crate) acceleration: f64,
    /// Displacement and velocity at the end of the step for acceleration 0.
    pub(crate) predicted: (f64, f64),
    /// Displacement at the end of the step \[m\].
    pub(crate) displacement: f64,
    /// Velocity at the end of the step \[m/s\].
    pub(crate) velocity: f64,
    /// The columns' answer there.
    pub(crate) response: Response<Memory>,
    /// Memory of the columns at the start of the step.
    pub(crate) memory: Memory,
    /// Pounding force from the left neighbour \[N\].
    pub(crate) force_from_left: f64,
    /// Pounding force from the right neighbour \[N\].
    pub(crate) force_from_right: f64,
    residual: f64,
    scale: f64,
    diagonal: f64,
    /// ∂residual/∂acceleration of the left neighbour.
    lower: f64,
    /// ∂residual/∂acceleration of the right neighbour.
    upper: f64,
}

impl<Memory: Copy + Default> Trial<Memory> {
    pub(crate) fn new() -> Self {
        Self {
            acceleration: 0.0,
            predicted: (0.0, 0.0),
            displacement: 0.0,
            velocity: 0.0,
            response: Response {
                force: 0.0,
                tangent: 0.0,
                memory: Memory::default(),
            },
            memory: Memory::default(),
            force_from_left: 0.0,
            force_from_right: 0.0,
            residual: 0.0,
            scale: 0.0,
            diagonal: 0.0,
            lower: 0.0,
            upper: 0.0,
        }
    }
}

/// What a method's step looks like to Newton: how displacement and velocity follow the acceleration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slopes {
    /// ∂u/∂ü \[s²\].
    pub(crate) displacement: f64,
    /// ∂u̇/∂ü \[s\].
    pub(crate) velocity: f64,
}

/// An equilibrium that was not found: iterations and the relative residual left.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NotConverged {
    pub(crate) residual: f64,
}

/// Finds the accelerations of nodes `first..=last` that are in equilibrium under a ground acceleration.
///
/// Every pair inside that range counts as able to touch; nothing outside it is read or written.
pub(crate) fn solve<Column: RestoringForce>(
    row: &Row<Column>,
    trials: &mut [Trial<Column::Memory>],
    (first, last): (usize, usize),
    (slopes, ground): (Slopes, f64),
    work: &mut Work,
) -> Result<(), NotConverged> {
    let mut worst = f64::INFINITY;
    for iteration in 0..=MAX_ITERATIONS {
        for (node, trial) in row.nodes()[first..=last]
            .iter()
            .zip(&mut trials[first..=last])
        {
            evaluate(node, trial, slopes, ground);
        }
        work.force_evaluations += (last - first + 1) as u64;
        couple(row, trials, (first, last), slopes);
        let cluster = &mut trials[first..=last];
        worst = cluster.iter().map(relative_residual).fold(0.0, f64::max);
        if worst <= TOLERANCE {
            return Ok(());
        }
        if iteration < MAX_ITERATIONS {
            correct(cluster);
            work.newton_iterations += 1;
        }
    }
    Err(NotConverged { residual: worst })
}

/// A residual that is not a number counts as infinite, so that it never passes.
fn relative_residual<Memory>(trial: &Trial<Memory>) -> f64 {
    let ratio = trial.residual.abs() / trial.scale;
    if trial.residual == 0.0 {
        0.0
    } else if ratio.is_nan() {
        f64::INFINITY
    } else {
        ratio
    }
}

/// Residual and tangent of one structure, its neighbours left out, per unit of mass.
fn evaluate<Column: RestoringForce>(
    node: &Node<Column>,
    trial: &mut Trial<Column::Memory>,
    slopes: Slopes,
    ground: f64,
) {
    let w = node.inverse_mass;
    trial.displacement = trial.predicted.0 + slopes.displacement * trial.acceleration;
    trial.velocity = trial.predicted.1 + slopes.velocity * trial.acceleration;
    trial.response = node.column.respond(trial.displacement, trial.memory);
    let ground = if node.is_wall() { 0.0 } else { ground };
    let (damping, restoring) = (w * node.damping * trial.velocity, w * trial.response.force);
    trial.residual = trial.acceleration + damping + restoring + ground;
    trial.scale = trial.acceleration.abs() + damping.abs() + restoring.abs() + ground.abs();
    trial.diagonal =
        1.0 + w * (node.damping * slopes.velocity + trial.response.tangent * slopes.displacement);
    (trial.lower, trial.upper) = (0.0, 0.0);
    (trial.force_from_left, trial.force_from_right) = (0.0, 0.0);
}

/// Adds the pounding forces between the structures of a cluster.
fn couple<Column: RestoringForce>(
    row: &Row<Column>,
    trials: &mut [Trial<Column::Memory>],
    (first, last): (usize, usize),
    slopes: Slopes,
) {
    for pair in row
        .pairs()
        .iter()
        .filter(|pair| first <= pair.left && pair.right <= last)
    {
        let (left, right) = (&trials[pair.left], &trials[pair.right]);
        let deformation = left.displacement - right.displacement - pair.gap;
        let ContactLaw::NonlinearViscoelastic(law) = pair.law else {
            continue;
        };
        if deformation > 0.0 {
            let rate = left.velocity - right.velocity;
            let reduced_mass = row.reduced_mass(pair);
            let contact = law.respond(&Overlap {
                deformation,
                rate,
                reduced_mass,
            });
            let tangent =
                contact.stiffness * slopes.displacement + contact.damping * slopes.velocity;
            let (w_left, w_right) = (
                row.nodes()[pair.left].inverse_mass,
                row.nodes()[pair.right].inverse_mass,
            );
            let left = &mut trials[pair.left];
            left.force_from_right = -contact.force;
            left.residual += w_left * contact.force;
            left.scale += w_left * contact.force;
            left.diagonal += w_left * tangent;
            left.upper = -w_left * tangent;
            let right = &mut trials[pair.right];
            right.force_from_left = contact.force;
            right.residual -= w_right * contact.force;
            right.scale += w_right * contact.force;
            right.diagonal += w_right * tangent;
            right.lower = -w_right * tangent;
        }
    }
}

/// One Newton correction: elimination in the tridiagonal system of a cluster, in place.
///
/// Rows are diagonally dominant as long as tangents are ≥ 0, so no pivoting is needed.
fn correct<Memory>(cluster: &mut [Trial<Memory>]) {
    for index in 1..cluster.len() {
        let (above, below) = cluster.split_at_mut(index);
        let (above, below) = (&above[index - 1], &mut below[0]);
        let factor = below.lower / above.diagonal;
        below.diagonal -= factor * above.upper;
        below.residual -= factor * above.residual;
    }
    let mut right = 0.0;
    for trial in cluster.iter_mut().rev() {
        right = (-trial.residual - trial.upper * right) / trial.diagonal;
        trial.acceleration += right;
    }
}
