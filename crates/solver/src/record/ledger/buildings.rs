//! Which floors are of one building, and whether all of it has been seen at one instant.

use crate::{RestoringForce, Row};

/// The buildings of a row; a structure of one storey and a wall are buildings of one floor.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Buildings {
    /// All nodes, building by building, in each from the ground up.
    places: Vec<Place>,
    /// For every node its building.
    of: Vec<usize>,
    all: Vec<Building>,
    /// Buildings whose floors were last seen at different instants.
    n_apart: usize,
}

/// A floor in its building.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub(super) node: usize,
    /// Whether the building ends with it.
    pub(super) is_roof: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Building {
    /// Its floors among the places.
    first: usize,
    n_floors: usize,
    /// Last instant at which a floor was seen \[s\], and how many floors were seen then.
    time: f64,
    n_seen: usize,
}

impl Buildings {
    pub(super) fn new<Column: RestoringForce>(row: &Row<Column>) -> Self {
        let mut of = vec![0; row.nodes().len()];
        let (mut places, mut all) = (Vec::new(), Vec::new());
        for (ground, node) in row.nodes().iter().enumerate() {
            if node.support.below().is_some() {
                continue;
            }
            let first = places.len();
            for node in row.floors(ground) {
                of[node] = all.len();
                let is_roof = row.above(node).is_none();
                places.push(Place { node, is_roof });
            }
            let n_floors = places.len() - first;
            all.push(Building {
                first,
                n_floors,
                time: 0.0,
                n_seen: n_floors,
            });
        }
        Self {
            places,
            of,
            all,
            n_apart: 0,
        }
    }

    /// Whether no building has several storeys.
    #[inline]
    pub(super) fn are_single(&self) -> bool {
        self.all.len() == self.of.len()
    }

    /// All nodes, building by building.
    pub(super) fn places(&self) -> &[Place] {
        &self.places
    }

    /// The building that a node is of, from the ground up.
    pub(super) fn around(&self, node: usize) -> &[Place] {
        let building = self.all[self.of[node]];
        &self.places[building.first..][..building.n_floors]
    }

    /// Sees a floor at the end of a span.
    #[inline]
    pub(super) fn see(&mut self, node: usize, time: f64) {
        if !self.are_single() {
            self.count(node, time);
        }
    }

    fn count(&mut self, node: usize, time: f64) {
        let building = &mut self.all[self.of[node]];
        if time < building.time {
            return;
        }
        self.n_apart -= usize::from(building.n_seen < building.n_floors);
        if time > building.time {
            (building.time, building.n_seen) = (time, 0);
        }
        building.n_seen += 1;
        self.n_apart += usize::from(building.n_seen < building.n_floors);
    }

    /// Whether the floors of every building were last seen at one instant, that of the building.
    pub(super) fn are_whole(&self) -> bool {
        self.n_apart == 0
    }
}
