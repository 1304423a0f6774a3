//! Damping on the tangent stiffness: what columns take away when they yield.

use super::damping::DampedStiffness;
use crate::{Building, Columns, Sdof, Storey, Structure};

/// Part of a storey's damping that its columns take away when they yield \[N·s/m\].
fn elastic_damping(beta: f64, columns: &Columns) -> f64 {
    let remaining = columns.hardening_ratio.unwrap_or(0.0);
    let lost = columns.yield_force_n.map_or(0.0, |_| (1.0 - remaining) * columns.stiffness_n_per_m);
    beta * lost
}

impl Structure {
    /// Whether β of its damping follows the tangent stiffness.
    pub fn has_tangent_damping(&self) -> bool {
        let damping = match self {
            Self::Sdof(sdof) => sdof.damping,
            Self::Building(building) => building.damping,
            Self::Wall => return false,
        };
        damping.stiffness() == DampedStiffness::Tangent
    }
}

impl Sdof {
    /// Part of the damping that the columns take away when they yield \[N·s/m\]; 0 for damping on the initial stiffness.
    pub(crate) fn elastic_damping(&self) -> f64 {
        match self.damping.stiffness() {
            DampedStiffness::Initial => 0.0,
            DampedStiffness::Tangent => elastic_damping(self.damping.to_solver().beta(), &self.columns()),
        }
    }
}

impl Building {
    /// Part of each storey's damping that its columns take away when they yield \[N·s/m\]: 0 for damping on the initial stiffness, and of
    /// isolators, which have their own.
    pub(crate) fn elastic_dampings(&self) -> Vec<f64> {
        let isolated = self.isolator_damping().is_some();
        let beta = match self.damping.stiffness() {
            DampedStiffness::Initial => 0.0,
            DampedStiffness::Tangent if isolated => self.damping_above_isolators(),
            DampedStiffness::Tangent => self.rayleigh().beta(),
        };
        let of = |(index, storey): (usize, &Storey)| {
            let beta = if isolated && index == 0 { 0.0 } else { beta };
            elastic_damping(beta, &storey.columns)
        };
        self.storeys.iter().enumerate().map(of).collect()
    }
}
