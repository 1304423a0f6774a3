//! What the columns of a floor stand on.

/// What the columns of a floor stand on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Support {
    /// The ground, as those of a structure of one storey do; all damping of the floor is that of its storey.
    #[default]
    Ground,
    /// Another floor of the same building.
    Floor(Floor),
}

/// A floor that carries another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Floor {
    /// Its node index, less than that of the floor it carries.
    pub below: usize,
    /// Damping coefficient of the carried floor against the ground \[N·s/m\], ≥ 0, besides that of its storey: the part of
    /// Rayleigh damping that is proportional to mass.
    pub ground_damping: f64,
}

impl Support {
    /// The floor below; nothing on the ground.
    #[inline]
    pub fn below(&self) -> Option<usize> {
        match self {
            Self::Ground => None,
            Self::Floor(floor) => Some(floor.below),
        }
    }

    /// Damping coefficient against the ground \[N·s/m\] besides that of the storey: none on the ground.
    pub fn ground_damping(&self) -> f64 {
        match self {
            Self::Ground => 0.0,
            Self::Floor(floor) => floor.ground_damping,
        }
    }
}
