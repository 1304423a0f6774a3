//! Support of the columns of a floor.

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
