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
    /// Of every node its level.
    heights: Vec<usize>,
}

impl Levels {
    /// Of buildings with so many storeys, from left to right, whose floors are at equal heights.
    pub fn new(storeys: &[usize]) -> Self {
        let floors: Vec<Vec<usize>> = storeys.iter().map(|count| (0..*count).collect()).collect();
        Self::at(&floors)
    }

    /// Of buildings with floors at these levels, each list rising: a hall as high as two storeys of its neighbour has one
    /// floor, at level 1.
    pub fn at(floors: &[Vec<usize>]) -> Self {
        let mut order: Vec<_> = floors
            .iter()
            .enumerate()
            .flat_map(|(building, floors)| {
                let floors = floors.iter().enumerate();
                floors.map(move |(storey, level)| (*level, building, storey))
            })
            .collect();
        order.sort_unstable();
        let mut nodes = vec![Vec::new(); floors.len()];
        for (node, (_, building, _)) in order.iter().enumerate() {
            nodes[*building].push(node);
        }
        Self {
            nodes,
            places: order.iter().map(|(_, building, storey)| (*building, *storey)).collect(),
            heights: order.iter().map(|(level, ..)| *level).collect(),
        }
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

    /// Level of a node, as it was given.
    pub fn level(&self, node: usize) -> usize {
        self.heights[node]
    }

    /// Nodes of a building and of its right neighbour at one level, from the ground up.
    pub fn facing(&self, left: usize) -> impl Iterator<Item = (usize, usize)> {
        let faces = move |node: &usize| {
            let right = node + 1;
            let at_one_level = self.heights.get(right) == Some(&self.heights[*node]);
            (at_one_level && self.places[right].0 == left + 1).then_some((*node, right))
        };
        self.nodes[left].iter().filter_map(faces)
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
        assert_eq!(Levels::new(&[2, 3]).facing(0).collect::<Vec<_>>(), [(0, 1), (2, 3)]);
    }

    #[test]
    fn reference_a_hall_as_high_as_two_storeys() {
        let levels = Levels::at(&[vec![0, 1, 2], vec![1]]);
        assert_eq!(levels.of(0), [0, 1, 3]);
        assert_eq!(levels.of(1), [2]);
        assert_eq!(levels.facing(0).collect::<Vec<_>>(), [(1, 2)]);
        assert_eq!((levels.place(2), levels.level(2)), ((1, 0), 1));
    }
}
