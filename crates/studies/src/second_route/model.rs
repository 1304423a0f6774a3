//! The row as plain numbers, and where each of them stands in the vector of unknowns.

use pounding_solver::{Hysteretic, Row};

use super::law::Law;

/// Index of the time within the present segment of the record \[s\] in the vector of unknowns.
///
/// After it follow displacement and velocity of each structure, then the impulse of the present collision of each
/// pair.
pub(super) const TIME: usize = 0;

/// Index of a structure's displacement in the vector of unknowns.
pub(super) fn displacement(structure: usize) -> usize {
    1 + 2 * structure
}

/// Index of a structure's velocity in the vector of unknowns.
pub(super) fn velocity(structure: usize) -> usize {
    2 + 2 * structure
}

/// The row as plain numbers.
#[derive(Debug, Clone)]
pub(super) struct Model {
    pub structures: Vec<Structure>,
    pub pairs: Vec<Neighbours>,
}

/// A structure or, with inverse mass 0, a wall.
#[derive(Debug, Clone, Copy)]
pub(super) struct Structure {
    pub inverse_mass: f64,
    pub damping: f64,
    pub stiffness: f64,
    pub yield_force: f64,
    pub initial_displacement: f64,
    pub initial_velocity: f64,
}

/// Two neighbours.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbours {
    pub left: usize,
    pub right: usize,
    pub gap: f64,
    pub reduced_mass: f64,
    pub law: Law,
}

impl Model {
    pub(super) fn new<Column: Hysteretic>(row: &Row<Column>) -> Self {
        let structures: Vec<_> = row
            .nodes()
            .iter()
            .map(|node| Structure {
                inverse_mass: node.inverse_mass,
                damping: node.damping,
                stiffness: node.column.stiffness(),
                yield_force: node.column.yield_force(),
                initial_displacement: node.initial_displacement,
                initial_velocity: node.initial_velocity,
            })
            .collect();
        let neighbours = |pair: &pounding_solver::Pair| {
            let inverse_mass = |index: usize| structures[index].inverse_mass;
            let reduced_mass = 1.0 / (inverse_mass(pair.left) + inverse_mass(pair.right));
            Neighbours {
                left: pair.left,
                right: pair.right,
                gap: pair.gap,
                reduced_mass,
                law: Law::of(pair.law, reduced_mass),
            }
        };
        let pairs = row.pairs().iter().map(neighbours).collect();
        Self { structures, pairs }
    }

    /// Number of unknowns.
    pub(super) fn n_unknowns(&self) -> usize {
        1 + 2 * self.structures.len() + self.pairs.len()
    }

    /// Index of the impulse of a pair's present collision in the vector of unknowns.
    pub(super) fn impulse(&self, pair: usize) -> usize {
        1 + 2 * self.structures.len() + pair
    }

    /// Deformation δ of a pair \[m\]; negative while it stands apart.
    pub(super) fn deformation(&self, pair: usize, unknowns: &[f64]) -> f64 {
        let Neighbours {
            left, right, gap, ..
        } = self.pairs[pair];
        (unknowns[displacement(left)] - unknowns[displacement(right)]) - gap
    }

    /// Rate of deformation of a pair \[m/s\], positive while approaching.
    pub(super) fn rate(&self, pair: usize, unknowns: &[f64]) -> f64 {
        let Neighbours { left, right, .. } = self.pairs[pair];
        unknowns[velocity(left)] - unknowns[velocity(right)]
    }
}
