//! What Newton's method knows of one floor while it looks for equilibrium.

use crate::{Response, State};

/// Largest residual of equilibrium accepted, relative to the sum of the magnitudes of its terms.
///
/// Rounding of those terms leaves about 1e-15; what rounding of displacements and velocities leaves is added.
pub(crate) const TOLERANCE: f64 = 1e-12;

/// One pair during a step.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PairTrial {
    /// Approach speed of the present contact \[m/s\]; nothing while apart.
    pub(crate) approach_speed: Option<f64>,
    /// Its force at the end of the step \[N\], ≥ 0.
    pub(crate) force: f64,
    /// How that changes with the acceleration at which the points close \[kg\].
    pub(crate) tangent: f64,
}

/// One floor during a step.
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
    /// The answer there of the columns below the floor.
    pub(crate) response: Response<Memory>,
    /// Memory of the columns at the start of the step.
    pub(crate) memory: Memory,
    /// Pounding force from the left neighbour \[N\].
    pub(crate) force_from_left: f64,
    /// Pounding force from the right neighbour \[N\].
    pub(crate) force_from_right: f64,
    pub(crate) residual: f64,
    /// Sum of the magnitudes of the residual's terms.
    pub(crate) scale: f64,
    /// What rounding of displacement and velocity alone can do to the residual.
    pub(crate) rounding: f64,
    /// The correction under way.
    pub(crate) correction: f64,
    /// ∂residual/∂acceleration of the floor itself.
    pub(crate) diagonal: f64,
    /// ∂residual/∂acceleration of the left neighbour.
    pub(crate) lower: f64,
    /// ∂residual/∂acceleration of the right neighbour.
    pub(crate) upper: f64,
    /// ∂residual/∂acceleration of the floor below.
    pub(crate) below: f64,
    /// ∂residual/∂acceleration of the floor above.
    pub(crate) above: f64,
}

impl<Memory: Copy> Trial<Memory> {
    /// Of a floor whose columns have this memory.
    pub(crate) fn new(memory: Memory) -> Self {
        Self {
            acceleration: 0.0,
            predicted: (0.0, 0.0),
            carried: 0.0,
            displacement: 0.0,
            velocity: 0.0,
            response: Response {
                force: 0.0,
                tangent: 0.0,
                memory,
            },
            memory,
            force_from_left: 0.0,
            force_from_right: 0.0,
            residual: 0.0,
            scale: 0.0,
            rounding: 0.0,
            correction: 0.0,
            diagonal: 0.0,
            lower: 0.0,
            upper: 0.0,
            below: 0.0,
            above: 0.0,
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

    /// What equilibrium, once found, leaves open of the acceleration \[m/s²\] of a floor without storeys above or below.
    pub(crate) fn uncertain_acceleration(&self) -> f64 {
        self.allowed_residual() / self.diagonal
    }

    pub(crate) fn allowed_residual(&self) -> f64 {
        TOLERANCE * self.scale + self.rounding
    }

    pub(crate) fn is_balanced(&self) -> bool {
        self.residual.abs() <= self.allowed_residual()
    }

    pub(crate) fn relative_residual(&self) -> f64 {
        if self.residual == 0.0 {
            0.0
        } else {
            self.residual.abs() / self.scale
        }
    }

    /// Adds a force (its magnitude) to the tangent and the bounds of a floor's equation.
    pub(crate) fn push(&mut self, inverse_mass: f64, force: f64, (tangent, rounding): (f64, f64)) {
        self.scale += inverse_mass * force;
        self.rounding += inverse_mass * rounding;
        self.diagonal += inverse_mass * tangent;
    }
}
