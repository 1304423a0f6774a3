//! Numbering of the floors of buildings in a row.

use crate::{Floor, Node};

/// A storey of a building: a floor, and the columns and damping between it and its support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Storey<Column> {
    /// Mass of the floor \[kg\], > 0.
    pub mass: f64,
    /// Damping coefficient between the floor and the support of its columns \[N·s/m\], ≥ 0: βk of Rayleigh damping.
    pub damping: f64,
    /// Damping coefficient of the floor against the ground \[N·s/m\], ≥ 0: αm of Rayleigh damping.
    pub ground_damping: f64,
    /// The columns.
    pub column: Column,
}

/// Nodes of the floors of buildings in a row: level by level, and from left to right in each level.
///
/// Floors of a level that face each other are then neighbours in the row, and every level is a row of one level. A wall is a building with
/// as many floors as it has levels; each of them is a separate wall.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Levels {
    /// Nodes of every building, from the ground up.
    nodes: Vec<Vec<usize>>,
    /// Building and storey of every node.
    places: Vec<(usize, usize)>,
    /// Level of every node.
    heights: Vec<usize>,
}

impl Levels {
    /// Levels of buildings with these numbers of storeys, from left to right, with floors at equal heights.
    pub fn new(storeys: &[usize]) -> Self {
        let floors: Vec<Vec<usize>> = storeys.iter().map(|count| (0..*count).collect()).collect();
        Self::at(&floors)
    }

    /// Levels of buildings with floors at these levels, each list in ascending order. A hall as high as two storeys of its neighbour has a
    /// single floor, at level 1.
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

    /// Level of a node, as given.
    pub fn level(&self, node: usize) -> usize {
        self.heights[node]
    }

    /// Nodes of a building and of its right neighbour at common levels, from the ground up.
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
    /// In a building of one storey, all damping is that of the storey.
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
