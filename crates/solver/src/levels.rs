//! Where the floors of buildings stand in a row.

use crate::{Floor, Node};

/// One storey of a building: a floor, and the columns and the damping between it and what they stand on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Storey<Column> {
    /// Mass of the floor \[kg\], > 0.
    pub mass: f64,
    /// Damping coefficient between the floor and what its columns stand on \[N·s/m\], ≥ 0: βk of Rayleigh damping.
    pub damping: f64,
    /// Damping coefficient of the floor against the ground \[N·s/m\], ≥ 0: αm of Rayleigh damping.
    pub ground_damping: f64,
    /// The columns.
    pub column: Column,
}

/// Nodes of the floors of buildings that stand in a row: level by level, in each from left to right.
///
/// Floors of one level that face each other so are neighbours in the row, and what holds for a row of one level holds for
/// each. A wall is a building of as many floors as it has levels, each a wall of its own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Levels {
    /// Of every building its nodes, from the ground up.
    nodes: Vec<Vec<usize>>,
    /// Of every node building and storey.
    places: Vec<(usize, usize)>,
}

impl Levels {
    /// Of buildings with so many storeys, from left to right.
    pub fn new(storeys: &[usize]) -> Self {
        let mut nodes = vec![Vec::new(); storeys.len()];
        let mut places = Vec::new();
        for level in 0..storeys.iter().copied().max().unwrap_or(0) {
            for (building, count) in storeys.iter().enumerate() {
                if level < *count {
                    nodes[building].push(places.len());
                    places.push((building, level));
                }
            }
        }
        Self { nodes, places }
    }

    /// Number of floors and walls of all buildings.
    pub fn n_nodes(&self) -> usize {
        self.places.len()
    }

    /// Nodes of a building, from the ground up.
    pub fn of(&self, building: usize) -> &[usize] {
        &self.nodes[building]
    }

    /// Building and storey of a node, both counted from 0.
    pub fn place(&self, node: usize) -> (usize, usize) {
        self.places[node]
    }

    /// Nodes of a building and of its right neighbour that face each other, from the ground up.
    pub fn facing(&self, left: usize) -> impl Iterator<Item = (usize, usize)> {
        let pair = |(left, right): (&usize, &usize)| (*left, *right);
        self.nodes[left].iter().zip(&self.nodes[left + 1]).map(pair)
    }

    /// The floor of a storey, as a node at rest.
    ///
    /// A building of one storey is the structure that it always was: all its damping is that of its storey.
    pub fn floor<Column>(&self, node: usize, storey: Storey<Column>) -> Node<Column> {
        let (building, level) = self.places[node];
        let Storey {
            mass,
            damping,
            ground_damping,
            column,
        } = storey;
        match level.checked_sub(1) {
            None => Node::structure(mass, ground_damping + damping, column),
            Some(lower) => Node::structure(mass, damping, column).on_floor(Floor {
                below: self.nodes[building][lower],
                ground_damping,
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_levels_from_left_to_right() {
        // A tower of three storeys, a house of one, a tower of two.
        let levels = Levels::new(&[3, 1, 2]);
        assert_eq!(levels.n_nodes(), 6);
        assert_eq!(levels.of(0), [0, 3, 5]);
        assert_eq!(levels.of(1), [1]);
        assert_eq!(levels.of(2), [2, 4]);
        assert_eq!(levels.place(4), (2, 1));
        assert_eq!(levels.facing(0).collect::<Vec<_>>(), [(0, 1)]);
        assert_eq!(levels.facing(1).collect::<Vec<_>>(), [(1, 2)]);
        assert_eq!(
            Levels::new(&[2, 3]).facing(0).collect::<Vec<_>>(),
            [(0, 1), (2, 3)]
        );
    }
}
