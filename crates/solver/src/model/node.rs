//! Floors and walls.

use crate::{RestoringForce, State};

/// A floor of a building, or a fixed wall. The only floor of a building of one storey is a structure (SDOF).
///
/// Displacements and velocities are relative to the ground. Columns and their damping respond to the drift, which is the displacement
/// relative to their support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node<Column> {
    /// Inverse mass \[1/kg\], ≥ 0; 0 for a fixed wall, which never moves.
    pub inverse_mass: f64,
    /// Damping coefficient c of the storey below the floor \[N·s/m\], ≥ 0.
    pub damping: f64,
    /// Part of `damping` that the storey has only while its columns do not yield \[N·s/m\], 0 ..= `damping`: β (k − `k_t`) of Rayleigh damping
    /// on the tangent stiffness. 0 for damping on the initial stiffness, and for columns that yield smoothly.
    pub elastic_damping: f64,
    /// The columns of that storey.
    pub column: Column,
    /// Support of the columns.
    pub support: Support,
    /// Displacement at t = 0 \[m\].
    pub initial_displacement: f64,
    /// Velocity at t = 0 \[m/s\].
    pub initial_velocity: f64,
}

impl<Column> Node<Column> {
    /// A structure at rest with a mass \[kg\] and a damping coefficient \[N·s/m\].
    pub fn structure(mass: f64, damping: f64, column: Column) -> Self {
        Self {
            inverse_mass: 1.0 / mass,
            damping,
            elastic_damping: 0.0,
            column,
            support: Support::Ground,
            initial_displacement: 0.0,
            initial_velocity: 0.0,
        }
    }

    /// The structure on another floor of the building.
    #[must_use]
    pub fn on_floor(self, floor: Floor) -> Self {
        Self {
            support: Support::Floor(floor),
            ..self
        }
    }

    /// A fixed wall. Its column is evaluated only at displacement 0 and moves nothing.
    pub fn wall(column: Column) -> Self {
        Self {
            inverse_mass: 0.0,
            damping: 0.0,
            elastic_damping: 0.0,
            column,
            support: Support::Ground,
            initial_displacement: 0.0,
            initial_velocity: 0.0,
        }
    }

    /// Whether the node is a fixed wall.
    pub fn is_wall(&self) -> bool {
        self.inverse_mass == 0.0
    }
}

impl<Column> Node<Column> {
    /// 1 for a structure, 0 for a wall: walls do not feel inertia.
    pub fn mobile(&self) -> f64 {
        if self.is_wall() { 0.0 } else { 1.0 }
    }
}

impl<Column: RestoringForce> Node<Column> {
    /// Acceleration \[m/s²\] of a structure of one storey in equilibrium; 0 for a wall.
    pub(crate) fn acceleration(&self, state: &State, ground: f64) -> f64 {
        let ground = if self.is_wall() { 0.0 } else { ground };
        let force = state.pounding_force() - self.damping * state.velocity - state.restoring_force;
        self.inverse_mass * force - ground
    }
}

/// Support of the columns of a floor.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Support {
    /// The ground, as for a structure of one storey. All damping of the floor is then that of its storey.
    #[default]
    Ground,
    /// Another floor of the same building.
    Floor(Floor),
}

/// A floor as the support of another floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Floor {
    /// Node index of the supporting floor, less than that of the floor above.
    pub below: usize,
    /// Damping coefficient of the floor above against the ground \[N·s/m\], ≥ 0, in addition to that of its storey: the part of Rayleigh
    /// damping that is proportional to mass.
    pub ground_damping: f64,
}

impl Support {
    /// The floor below; `None` on the ground.
    #[inline]
    pub fn below(&self) -> Option<usize> {
        match self {
            Self::Ground => None,
            Self::Floor(floor) => Some(floor.below),
        }
    }

    /// Damping coefficient against the ground \[N·s/m\] in addition to that of the storey; 0 on the ground.
    pub fn ground_damping(&self) -> f64 {
        match self {
            Self::Ground => 0.0,
            Self::Floor(floor) => floor.ground_damping,
        }
    }
}
