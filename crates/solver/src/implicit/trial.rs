//! State of a floor and of a pair during the Newton iteration.

use crate::{Response, State};

/// Largest accepted residual of equilibrium, relative to the sum of the magnitudes of its terms.
///
/// Rounding of the terms leaves about 1e-15. The rounding of displacements and velocities is added.
pub(crate) const TOLERANCE: f64 = 1e-12;

/// A pair during a step.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PairTrial {
    /// Approach speed of the present contact \[m/s\]; `None` while apart.
    pub(crate) approach_speed: Option<f64>,
    /// Force at the end of the step \[N\], ≥ 0.
    pub(crate) force: f64,
    /// Derivative of the force with respect to the closing acceleration of the points \[kg\].
    pub(crate) tangent: f64,
}

/// A floor during a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Trial<Memory> {
    /// Acceleration at the end of the step, the unknown \[m/s²\].
    pub(crate) acceleration: f64,
    /// Displacement and velocity at the end of the step for acceleration 0.
    pub(crate) predicted: (f64, f64),
    /// Contribution of the start of the step to the equation, per unit of mass \[m/s²\]; 0 if the equation is equilibrium at the end only.
    pub(crate) carried: f64,
    /// Displacement at the end of the step \[m\].
    pub(crate) displacement: f64,
    /// Velocity at the end of the step \[m/s\].
    pub(crate) velocity: f64,
    /// Response of the columns below the floor at this displacement.
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
    /// Effect of the rounding of displacement and velocity on the residual.
    pub(crate) rounding: f64,
    /// The present correction.
    pub(crate) correction: f64,
    /// ∂residual/∂acceleration of this floor.
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
    /// A trial of a floor whose columns have this memory.
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

    /// Uncertainty of the acceleration \[m/s²\] after equilibrium, for a floor without storeys above or below.
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
    pub(crate) fn push(&mut self, inverse_mass: f64, force: f64, tangent: f64, rounding: f64) {
        self.scale += inverse_mass * force;
        self.rounding += inverse_mass * rounding;
        self.diagonal += inverse_mass * tangent;
    }
}
