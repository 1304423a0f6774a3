//! Newton's method for the equilibrium of a cluster: one structure, or neighbours that touch.
//!
//! The unknowns are the accelerations at the end of the step. With displacement increments as unknowns the terms
//! 4u/Δt² would cancel and leave a residual of 1e-9 at Δt = 1e-4 s; accelerations do not cancel.
//!
//! A correction is halved until the residual falls: the damper of the viscoelastic element starts like δ^(1/4), and a
//! full correction can jump out of contact and back for ever.

use pounding_contact::Overlap;

use crate::{Node, Pair, Response, RestoringForce, Row, State, Work};

/// Largest residual of equilibrium accepted, relative to the sum of the magnitudes of its terms.
///
/// Rounding of those terms leaves about 1e-15; what rounding of displacements and velocities leaves is added.
pub(crate) const TOLERANCE: f64 = 1e-12;
/// Relative rounding of a displacement, a velocity or a deformation: each goes through up to four operations.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Iterations after which a cluster is given up.
pub(crate) const MAX_ITERATIONS: u32 = 50;
/// Halvings of one correction after which a cluster is given up.
const MAX_HALVINGS: u32 = 30;

/// One structure during a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trial<Memory> {
    /// Acceleration at the end of the step, the unknown \[m/s²\].
    pub(crate) acceleration: f64,
    /// Displacement and velocity at the end of the step for acceleration 0.
    pub(crate) predicted: (f64, f64),
    /// What the start of the step adds to the equation, per unit of mass \[m/s²\]; 0 where equilibrium is asked for at
    /// the end alone.
    pub(crate) carried: f64,
    /// Displacement at the end of the step \[m\].
    pub(crate) displacement: f64,
    /// Velocity at the end of the step \[m/s\].
    pub(crate) velocity: f64,
    /// The columns' answer there.
    pub(crate) response: Response<Memory>,
    /// Approach speed of the present contact with the right neighbour \[m/s\]; nothing while apart.
    pub(crate) approach_speed: Option<f64>,
    /// Memory of the columns at the start of the step.
    pub(crate) memory: Memory,
    /// Pounding force from the left neighbour \[N\].
    pub(crate) force_from_left: f64,
    /// Pounding force from the right neighbour \[N\].
    pub(crate) force_from_right: f64,
    residual: f64,
    /// Sum of the magnitudes of the residual's terms.
    scale: f64,
    /// What rounding of displacement and velocity alone can do to the residual.
    rounding: f64,
    /// The correction under way.
    correction: f64,
    /// ∂residual/∂acceleration of the structure itself.
    pub(crate) diagonal: f64,
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
            carried: 0.0,
            displacement: 0.0,
            velocity: 0.0,
            response: Response {
                force: 0.0,
                tangent: 0.0,
                memory: Memory::default(),
            },
            approach_speed: None,
            memory: Memory::default(),
            force_from_left: 0.0,
            force_from_right: 0.0,
            residual: 0.0,
            scale: 0.0,
            rounding: 0.0,
            correction: 0.0,
            diagonal: 0.0,
            lower: 0.0,
            upper: 0.0,
        }
    }
}

impl<Memory> Trial<Memory> {
    /// The state at the end of the step.
    pub(crate) fn state(&self) -> State {
        State {
            displacement: self.displacement,
            velocity: self.velocity,
            acceleration: self.acceleration,
            restoring_force: self.response.force,
            force_from_left: self.force_from_left,
            force_from_right: self.force_from_right,
        }
    }

    /// What equilibrium, once found, leaves open of the acceleration \[m/s²\].
    pub(crate) fn uncertain_acceleration(&self) -> f64 {
        self.allowed_residual() / self.diagonal
    }

    fn allowed_residual(&self) -> f64 {
        TOLERANCE * self.scale + self.rounding
    }

    /// Adds a pounding force (its magnitude) to the tangent and the bounds of a structure's equation.
    fn push(&mut self, inverse_mass: f64, force: f64, (tangent, rounding): (f64, f64)) {
        self.scale += inverse_mass * force;
        self.rounding += inverse_mass * rounding;
        self.diagonal += inverse_mass * tangent;
    }
}

/// What a method's step looks like to Newton: how displacement and velocity follow the acceleration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slopes {
    /// ∂u/∂ü \[s²\].
    pub(crate) displacement: f64,
    /// ∂u̇/∂ü \[s\].
    pub(crate) velocity: f64,
    /// Weight of the inertia where that of the other forces is 1 \[–\].
    pub(crate) inertia: f64,
    /// Δt, for messages \[s\].
    pub(crate) time_step: f64,
}

/// An equilibrium that was not found.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Failure {
    /// A number of this structure is not finite.
    NotFinite { structure: usize },
    /// The residual, relative to the sum of its terms' magnitudes, stays too large.
    NotConverged { iterations: u32, residual: f64 },
}

/// Finds the accelerations of nodes `first..=last` that are in equilibrium under a ground acceleration.
///
/// Every pair inside that range counts as able to touch; nothing outside it is read or written.
pub(crate) fn solve<Column: RestoringForce>(
    row: &Row<Column>,
    trials: &mut [Trial<Column::Memory>],
    range: (usize, usize),
    step: (Slopes, f64),
    work: &mut Work,
) -> Result<(), Failure> {
    let (first, last) = range;
    let mut merit = residual(row, trials, range, step, work);
    let mut iterations = 0;
    // A motion that died out to less than 1e-150 m leaves residuals whose squares underflow: none can fall further.
    while merit != 0.0 && !trials[first..=last].iter().all(is_balanced) {
        if !merit.is_finite() {
            return Err(not_finite(trials, range));
        }
        let failure = Failure::NotConverged {
            iterations,
            residual: trials[first..=last]
                .iter()
                .map(relative_residual)
                .fold(0.0, f64::max),
        };
        if iterations == MAX_ITERATIONS {
            return Err(failure);
        }
        iterations += 1;
        work.newton_iterations += 1;
        correct(&mut trials[first..=last]);
        let mut halvings = 0;
        loop {
            let tried = residual(row, trials, range, step, work);
            // Balanced within rounding, the merit may no longer fall. Not a number never passes.
            if tried < merit || trials[first..=last].iter().all(is_balanced) {
                merit = tried;
                break;
            }
            if halvings == MAX_HALVINGS {
                return Err(failure);
            }
            halvings += 1;
            for trial in &mut trials[first..=last] {
                trial.correction *= 0.5;
                trial.acceleration -= trial.correction;
            }
        }
    }
    Ok(())
}

/// The first structure without a finite residual, or the one whose residual overflows when squared.
fn not_finite<Memory>(trials: &[Trial<Memory>], (first, last): (usize, usize)) -> Failure {
    let overflows =
        |index: &usize| !(trials[*index].residual * trials[*index].residual).is_finite();
    let structure = (first..=last).find(overflows).unwrap_or(first);
    Failure::NotFinite { structure }
}

fn is_balanced<Memory>(trial: &Trial<Memory>) -> bool {
    trial.residual.abs() <= trial.allowed_residual()
}

fn relative_residual<Memory>(trial: &Trial<Memory>) -> f64 {
    if trial.residual == 0.0 {
        0.0
    } else {
        trial.residual.abs() / trial.scale
    }
}

/// Evaluates the residuals of a cluster; returns their sum of squares, each times its mass.
///
/// That weight makes light and heavy structures count alike. Walls have no residual.
fn residual<Column: RestoringForce>(
    row: &Row<Column>,
    trials: &mut [Trial<Column::Memory>],
    (first, last): (usize, usize),
    (slopes, ground): (Slopes, f64),
    work: &mut Work,
) -> f64 {
    let nodes = &row.nodes()[first..=last];
    for (node, trial) in nodes.iter().zip(&mut trials[first..=last]) {
        evaluate(node, trial, slopes, ground);
    }
    work.force_evaluations += nodes.len() as u64;
    let inside = |pair: &&Pair| first <= pair.left && pair.right <= last;
    for pair in row.pairs().iter().filter(inside) {
        couple(row, pair, trials, slopes);
    }
    // The net contact force is summed before it is added to anything: a mirrored row then gives mirrored bits.
    for (node, trial) in nodes.iter().zip(&mut trials[first..=last]) {
        trial.residual -= node.inverse_mass * (trial.force_from_left + trial.force_from_right);
    }
    let weighted = |(node, trial): (&Node<Column>, &Trial<Column::Memory>)| {
        if node.is_wall() {
            0.0
        } else {
            trial.residual * trial.residual / node.inverse_mass
        }
    };
    nodes.iter().zip(&trials[first..=last]).map(weighted).sum()
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
    let inertia = slopes.inertia * trial.acceleration;
    trial.residual = inertia + damping + restoring + ground + trial.carried;
    trial.scale = inertia.abs() + damping.abs() + restoring.abs() + ground.abs();
    trial.scale += trial.carried.abs();
    // Far beyond what the structure can follow, the prediction is large and cancels.
    let (displacement, velocity) = (
        trial.displacement.abs().max(trial.predicted.0.abs()),
        trial.velocity.abs().max(trial.predicted.1.abs()),
    );
    trial.rounding =
        ROUNDING * w * (trial.response.tangent * displacement + node.damping * velocity);
    trial.diagonal = slopes.inertia
        + w * (node.damping * slopes.velocity + trial.response.tangent * slopes.displacement);
    (trial.lower, trial.upper) = (0.0, 0.0);
    (trial.force_from_left, trial.force_from_right) = (0.0, 0.0);
}

/// Adds the pounding force of one pair.
fn couple<Column: RestoringForce>(
    row: &Row<Column>,
    pair: &Pair,
    trials: &mut [Trial<Column::Memory>],
    slopes: Slopes,
) {
    let (left, right) = (&trials[pair.left], &trials[pair.right]);
    let deformation = left.displacement - right.displacement - pair.gap;
    // Impulsive contact acts between steps; a compliant pair that this step brings together may touch a little earlier.
    let near = deformation > 0.0 || left.approach_speed.is_some();
    if near && pair.law.is_compliant() {
        let rate = left.velocity - right.velocity;
        let overlap = Overlap {
            deformation,
            rate,
            reduced_mass: row.reduced_mass(pair),
            // A structure alone sees no pair; those that overlap then were marked, with their speed.
            approach_speed: left.approach_speed.unwrap_or(0.0),
        };
        let contact = if deformation > 0.0 {
            pair.law.respond(&overlap)
        } else {
            pair.law.before_touch(&overlap)
        };
        let Some(contact) = contact else {
            return;
        };
        let rounding = ROUNDING
            * (contact.stiffness * (left.displacement.abs() + right.displacement.abs() + pair.gap)
                + contact.damping * (left.velocity.abs() + right.velocity.abs()));
        let tangent = contact.stiffness * slopes.displacement + contact.damping * slopes.velocity;
        let node = |index: usize| row.nodes()[index].inverse_mass;
        let left = &mut trials[pair.left];
        left.force_from_right = -contact.force;
        left.upper = -node(pair.left) * tangent;
        left.push(node(pair.left), contact.force, (tangent, rounding));
        let right = &mut trials[pair.right];
        right.force_from_left = contact.force;
        right.lower = -node(pair.right) * tangent;
        right.push(node(pair.right), contact.force, (tangent, rounding));
    }
}

/// Velocity that a unit impulse gives to each structure in a step, its forces at the end of the step included \[1/kg\]:
/// what it does to its neighbours across compliant pairs comes back to it.
pub(crate) fn mobilities<Column: RestoringForce>(
    nodes: &[Node<Column>],
    trials: &[Trial<Column::Memory>],
    mobilities: &mut [f64],
) {
    // The diagonal of the inverse of a tridiagonal matrix: what elimination from the left takes off, then from the right.
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
        mobilities[index] =
            nodes[index].inverse_mass / (trial.diagonal - mobilities[index] - taken);
        if let Some(before) = index.checked_sub(1) {
            taken = trials[before].upper * trial.lower / (trial.diagonal - taken);
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
        trial.correction = right;
        trial.acceleration += right;
    }
}
