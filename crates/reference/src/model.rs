//! The row as plain numbers, and where each of them stands in the vector of unknowns.

use pounding_solver::{Hysteretic, Node, Row, Support};

use super::law::Law;
use super::storey::{Columns, Smooth};

/// Index of the time within the present segment of the record \[s\] in the vector of unknowns.
///
/// After it follow displacement and velocity of each structure, then the impulse of the present collision of each
/// pair, then the deformation of each pair and its rate, then the elastic part of the drift of each storey with columns
/// that yield smoothly.
///
/// A deformation is an unknown of its own, since the difference of two displacements would not know small bounces.
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
    /// Number of storeys with columns that yield smoothly.
    n_smooth: usize,
}

/// A floor with the storey below it, or, with inverse mass 0, a wall.
#[derive(Debug, Clone, Copy)]
pub(super) struct Structure {
    pub inverse_mass: f64,
    /// Floor on which the storey stands; nothing on the ground.
    pub below: Option<usize>,
    /// Damping coefficient of the storey \[N·s/m\].
    pub damping: f64,
    /// Damping coefficient of the floor against the ground, besides that of a storey that stands there \[N·s/m\].
    pub ground_damping: f64,
    pub columns: Columns,
    /// When the ground motion arrives \[s\].
    pub arrival: f64,
    pub initial_displacement: f64,
    pub initial_velocity: f64,
}

/// Two neighbours.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbours {
    pub left: usize,
    pub right: usize,
    pub gap: f64,
    /// Index of the deformation in the vector of unknowns, before that of its rate.
    pub deformation: usize,
    pub reduced_mass: f64,
    pub law: Law,
}

impl Model {
    pub(super) fn new<Column: Hysteretic>(row: &Row<Column>) -> Self {
        let nodes = row.nodes().iter().enumerate();
        let mut structures: Vec<_> = nodes
            .map(|(index, node)| structure(node, row.arrival(index)))
            .collect();
        let n_pairs = row.pairs().len();
        let of_pairs = 1 + 2 * structures.len() + n_pairs;
        let first = of_pairs + 2 * n_pairs;
        let mut next = first;
        for structure in &mut structures {
            if let Some(Smooth { unknown, .. }) = &mut structure.columns.smooth {
                *unknown = next;
                next += 1;
            }
        }
        let neighbours = |(index, pair): (usize, &pounding_solver::Pair)| {
            let inverse_mass = |index: usize| structures[index].inverse_mass;
            let reduced_mass = 1.0 / (inverse_mass(pair.left()) + inverse_mass(pair.right()));
            Neighbours {
                left: pair.left(),
                right: pair.right(),
                gap: pair.gap(),
                deformation: of_pairs + 2 * index,
                reduced_mass,
                law: Law::of(pair.law, reduced_mass),
            }
        };
        let pairs = row.pairs().iter().enumerate().map(neighbours).collect();
        Self {
            pairs,
            n_smooth: next - first,
            structures,
        }
    }

    /// Number of unknowns.
    pub(super) fn n_unknowns(&self) -> usize {
        1 + 2 * self.structures.len() + 3 * self.pairs.len() + self.n_smooth
    }

    /// Index of the impulse of a pair's present collision in the vector of unknowns.
    pub(super) fn impulse(&self, pair: usize) -> usize {
        1 + 2 * self.structures.len() + pair
    }

    /// Displacement of a floor relative to what its storey stands on \[m\].
    pub(super) fn drift(&self, structure: usize, unknowns: &[f64]) -> f64 {
        let of_floor = unknowns[displacement(structure)];
        match self.structures[structure].below {
            None => of_floor,
            Some(below) => of_floor - unknowns[displacement(below)],
        }
    }

    /// Its rate \[m/s\].
    pub(super) fn drift_rate(&self, structure: usize, unknowns: &[f64]) -> f64 {
        let of_floor = unknowns[velocity(structure)];
        match self.structures[structure].below {
            None => of_floor,
            Some(below) => of_floor - unknowns[velocity(below)],
        }
    }

    /// Drift at t = 0 \[m\].
    pub(super) fn initial_drift(&self, structure: &Structure) -> f64 {
        let below = structure
            .below
            .map(|below| self.structures[below].initial_displacement);
        structure.initial_displacement - below.unwrap_or(0.0)
    }

    /// Deformation δ of a pair \[m\]; negative while it stands apart.
    pub(super) fn deformation(&self, pair: usize, unknowns: &[f64]) -> f64 {
        unknowns[self.pairs[pair].deformation]
    }

    /// Rate of deformation of a pair \[m/s\], positive while approaching.
    pub(super) fn rate(&self, pair: usize, unknowns: &[f64]) -> f64 {
        unknowns[self.pairs[pair].deformation + 1]
    }

    /// Deformation of a pair at t = 0 and its rate \[m\], \[m/s\]; grounds are at rest then.
    pub(super) fn initial_deformation(&self, pair: &Neighbours) -> [f64; 2] {
        let [left, right] = [pair.left, pair.right].map(|index| &self.structures[index]);
        [
            left.initial_displacement - right.initial_displacement - pair.gap,
            left.initial_velocity - right.initial_velocity,
        ]
    }

    pub(super) fn is_wall(&self, structure: usize) -> bool {
        self.structures[structure].inverse_mass == 0.0
    }

    /// Gives a structure a velocity, and every pair it belongs to the rate that follows.
    pub(super) fn push(&self, structure: usize, gained: f64, unknowns: &mut [f64]) {
        unknowns[velocity(structure)] += gained;
        for pair in &self.pairs {
            if pair.left == structure {
                unknowns[pair.deformation + 1] += gained;
            } else if pair.right == structure {
                unknowns[pair.deformation + 1] -= gained;
            }
        }
    }
}

fn structure<Column: Hysteretic>(node: &Node<Column>, arrival: f64) -> Structure {
    let (below, ground_damping) = match node.support {
        Support::Ground => (None, 0.0),
        Support::Floor(floor) => (Some(floor.below), floor.ground_damping),
    };
    Structure {
        inverse_mass: node.inverse_mass,
        below,
        damping: node.damping,
        ground_damping,
        columns: Columns::of(node.column.hysteresis()),
        arrival,
        initial_displacement: node.initial_displacement,
        initial_velocity: node.initial_velocity,
    }
}

impl Model {
    /// Unknowns z with the storeys of their columns.
    pub(super) fn smooth(&self) -> impl Iterator<Item = (usize, Smooth)> {
        let storeys = self.structures.iter().enumerate();
        storeys.filter_map(|(index, storey)| Some((index, storey.columns.smooth?)))
    }
}
