//! Which floors make a building.

use std::ops::Range;

use crate::{RestoringForce, Row};

/// The floors of a row building by building, from left to right, each from the ground up.
#[derive(Debug)]
pub struct Buildings {
    /// Their nodes.
    floors: Vec<usize>,
    /// Where each building lies in them.
    ranges: Vec<Range<usize>>,
}

impl Buildings {
    /// Nothing for a row in which no floor stands on another one.
    pub fn of_storeys<Column: RestoringForce>(row: &Row<Column>) -> Option<Self> {
        let mut nodes = row.nodes().iter();
        nodes
            .any(|node| node.support.below().is_some())
            .then(|| Self::of(row))
    }

    /// Of any row; a structure of one storey, or a wall, is a building of one floor.
    pub fn of<Column: RestoringForce>(row: &Row<Column>) -> Self {
        let stands = |index: &usize| row.nodes()[*index].support.below().is_some();
        let n = row.nodes().len();
        let (mut floors, mut ranges) = (Vec::with_capacity(n), Vec::new());
        for ground in (0..n).filter(|index| !stands(index)) {
            let first = floors.len();
            let mut floor = Some(ground);
            while let Some(index) = floor {
                floors.push(index);
                floor = row.above(index);
            }
            ranges.push(first..floors.len());
        }
        Self { floors, ranges }
    }

    /// Nodes of all floors.
    pub fn floors(&self) -> &[usize] {
        &self.floors
    }

    /// Where among the floors each building lies.
    pub fn ranges(&self) -> &[Range<usize>] {
        &self.ranges
    }

    /// The floors of each building.
    pub fn each(&self) -> impl Iterator<Item = &[usize]> {
        self.ranges.iter().map(|range| &self.floors[range.clone()])
    }
}
