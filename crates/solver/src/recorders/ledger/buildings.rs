//! Which floors are of one building, and whether all of it has been seen at one instant.

use std::iter::successors;

use crate::Row;

/// The buildings of a row; a structure of one storey and a wall are buildings of one floor.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Buildings {
    /// For every node the floor that stands on it.
    above: Vec<Option<usize>>,
    /// For every node its building.
    of: Vec<usize>,
    all: Vec<Building>,
    /// Buildings whose floors were last seen at different instants.
    n_apart: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Building {
    /// Node of the floor on the ground.
    ground: usize,
    n_floors: usize,
    /// Last instant at which a floor was seen \[s\], and how many floors were seen then.
    time: f64,
    n_seen: usize,
}

impl Buildings {
    pub(super) fn new<Column: crate::RestoringForce>(row: &Row<Column>) -> Self {
        let nodes = 0..row.nodes().len();
        let above: Vec<_> = nodes.map(|node| row.above(node)).collect();
        let mut of = vec![0; above.len()];
        let mut all = Vec::new();
        for (ground, node) in row.nodes().iter().enumerate() {
            if node.support.below().is_some() {
                continue;
            }
            let mut n_floors = 0;
            for floor in successors(Some(ground), |floor| above[*floor]) {
                of[floor] = all.len();
                n_floors += 1;
            }
            all.push(Building {
                ground,
                n_floors,
                time: 0.0,
                n_seen: n_floors,
            });
        }
        Self {
            above,
            of,
            all,
            n_apart: 0,
        }
    }

    /// Nodes of the building that begins on the ground at a node, from there up.
    pub(super) fn floors(&self, ground: usize) -> impl Iterator<Item = usize> {
        successors(Some(ground), |floor| self.above[*floor])
    }

    /// Nodes on the ground, one of each building.
    pub(super) fn grounds(&self) -> impl Iterator<Item = usize> {
        self.all.iter().map(|building| building.ground)
    }

    /// Sees a floor at the end of a span.
    pub(super) fn see(&mut self, node: usize, time: f64) {
        let building = &mut self.all[self.of[node]];
        if building.n_floors == 1 || time < building.time {
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
