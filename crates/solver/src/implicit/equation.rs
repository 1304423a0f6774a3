//! The equations of a step: how its unknowns follow from accelerations, and which floors find their equilibrium together.

use crate::implicit::trial::{PairTrial, Trial};
use crate::model::ground::Ground;
use crate::{RestoringForce, Row};

/// Slopes of a method's step for Newton's method: how displacement and velocity follow the acceleration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slopes {
    /// ∂u/∂ü \[s²\].
    pub(crate) displacement: f64,
    /// ∂u̇/∂ü \[s\].
    pub(crate) velocity: f64,
    /// Weight of the inertia if the other forces have weight 1 \[–\].
    pub(crate) inertia: f64,
    /// Δt, for messages \[s\].
    pub(crate) time_step: f64,
}

/// The end of a step, where the unknowns are sought.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StepEnd<'a> {
    pub(crate) slopes: Slopes,
    pub(crate) ground: Ground<'a>,
}

/// An equilibrium that was not found.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Failure {
    /// A number of this structure is not finite.
    NotFinite { structure: usize },
    /// The residual, relative to the sum of its terms' magnitudes, stays too large.
    NotConverged { iterations: u32, residual: f64 },
}

/// Floors that find their equilibrium together, and how the equations of motion couple them.
pub(crate) trait Cluster {
    /// Whether a floor may stand on another floor.
    const STOREYS: bool;

    /// All floors of the buildings; each comes after the floor below it.
    fn nodes(&self) -> impl Iterator<Item = usize> + Clone;

    /// The pairs that push.
    fn pairs(&self) -> impl Iterator<Item = usize>;

    /// Makes a Newton correction: solves the linearised equations and adds the result to the accelerations.
    fn correct<Column: RestoringForce>(&mut self, row: &Row<Column>, trials: &mut [Trial<Column::Memory>], pairs: &[PairTrial]);
}
