//! Newton's method for the equilibrium of a cluster: a single building, or neighbours that touch.
//!
//! The unknowns are the accelerations at the end of the step. With displacement increments as unknowns, the terms 4u/Δt² would cancel and
//! leave a residual of 1e-9 at Δt = 1e-4 s; accelerations do not cancel.
//!
//! A correction is halved until the residual falls: the damper of the viscoelastic element starts like δ^(1/4), and a full correction can
//! jump out of contact and back for ever.

use crate::implicit::equation::{Cluster, Failure, StepEnd};
use crate::implicit::equilibrium::residual;
use crate::implicit::trial::{PairTrial, Trial};
use crate::{Node, RestoringForce, Row, Work};

/// Most iterations for a cluster. The run is given up beyond.
pub(crate) const MAX_ITERATIONS: u32 = 50;
/// Most halvings of a correction. The run is given up beyond.
const MAX_HALVINGS: u32 = 30;

/// Finds the accelerations of a cluster in equilibrium over the ground at the end of a step.
///
/// Nothing outside the cluster is read or written.
pub(crate) fn solve<Column: RestoringForce, C: Cluster>(
    row: &Row<Column>,
    trials: &mut [Trial<Column::Memory>],
    pairs: &mut [PairTrial],
    cluster: &mut C,
    end: StepEnd<'_>,
    work: &mut Work,
) -> Result<(), Failure> {
    let mut merit = residual(row, trials, pairs, cluster, end, work);
    let mut iterations = 0;
    // A motion that has decayed below 1e-150 m leaves residuals whose squares underflow: they cannot fall further.
    while merit != 0.0 && !is_balanced(trials, cluster) {
        if !merit.is_finite() {
            return Err(not_finite(trials, cluster));
        }
        let failure = not_converged(trials, cluster, iterations);
        if iterations == MAX_ITERATIONS {
            return Err(failure);
        }
        iterations += 1;
        work.newton_iterations += 1;
        cluster.correct(row, trials, pairs);
        let mut halvings = 0;
        loop {
            let tried = residual(row, trials, pairs, cluster, end, work);
            // When balance holds within rounding, the merit may no longer fall. NaN never passes.
            if tried < merit || is_balanced(trials, cluster) {
                merit = tried;
                break;
            }
            if halvings == MAX_HALVINGS {
                return Err(failure);
            }
            halvings += 1;
            for node in cluster.nodes() {
                trials[node].correction *= 0.5;
                trials[node].acceleration -= trials[node].correction;
            }
        }
    }
    Ok(())
}

fn is_balanced<Memory>(trials: &[Trial<Memory>], cluster: &impl Cluster) -> bool {
    cluster.nodes().all(|node| trials[node].is_balanced())
}

/// The error with the largest remaining residual.
fn not_converged<Memory>(trials: &[Trial<Memory>], cluster: &impl Cluster, iterations: u32) -> Failure {
    let residuals = cluster.nodes().map(|node| trials[node].relative_residual());
    Failure::NotConverged {
        iterations,
        residual: residuals.fold(0.0, f64::max),
    }
}

/// The first structure with a non-finite residual, or the first with a residual that overflows when squared.
fn not_finite<Memory>(trials: &[Trial<Memory>], cluster: &impl Cluster) -> Failure {
    let overflows = |node: &usize| !(trials[*node].residual * trials[*node].residual).is_finite();
    let first = cluster.nodes().filter(overflows).min();
    Failure::NotFinite {
        structure: first.or(cluster.nodes().min()).unwrap_or(0),
    }
}

/// Velocity of each structure in a step under a unit impulse, with its forces at the end of the step \[1/kg\]. The response of neighbours
/// across compliant pairs is included.
pub(crate) fn mobilities<Column: RestoringForce>(nodes: &[Node<Column>], trials: &[Trial<Column::Memory>], mobilities: &mut [f64]) {
    // The diagonal of the inverse of a tridiagonal matrix, by elimination from the left and then from the right.
    let mut taken = 0.0;
    for (index, (mobility, trial)) in mobilities.iter_mut().zip(trials).enumerate() {
        *mobility = taken;
        if let Some(next) = trials.get(index + 1) {
            taken = trial.upper * next.lower / (trial.diagonal - taken);
        }
    }
    taken = 0.0;
    for index in (0..nodes.len()).rev() {
        let trial = &trials[index];
        mobilities[index] = nodes[index].inverse_mass / (trial.diagonal - mobilities[index] - taken);
        if let Some(before) = index.checked_sub(1) {
            taken = trials[before].upper * trial.lower / (trial.diagonal - taken);
        }
    }
}
