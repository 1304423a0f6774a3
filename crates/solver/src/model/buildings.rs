//! Buildings: the floors that belong together.

use std::ops::Range;

use crate::{Floor, ModelError, Node, Support};

/// The buildings of a row, from left to right. A structure of one storey, or a wall, is a building with one floor.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Buildings {
    /// Nodes, building by building, each from the ground up.
    floors: Vec<usize>,
    /// Start of the floors of each building in `floors`, and the end of the last ones.
    starts: Vec<usize>,
    /// Building of every node.
    of: Vec<usize>,
    /// For every node, the floor that stands on it.
    above: Vec<Option<usize>>,
}

impl Buildings {
    /// Finds the buildings of other nodes, with reuse of memory.
    ///
    /// # Errors
    /// [`ModelError`] if a floor does not stand on an earlier floor, or shares it with another floor.
    pub(crate) fn renew<Column>(&mut self, nodes: &[Node<Column>]) -> Result<(), ModelError> {
        find_above(nodes, &mut self.above)?;
        self.floors.clear();
        self.starts.clear();
        self.starts.push(0);
        self.of.clear();
        self.of.resize(nodes.len(), 0);
        for (ground, node) in nodes.iter().enumerate() {
            if node.support.below().is_some() {
                continue;
            }
            let mut floor = Some(ground);
            while let Some(node) = floor {
                self.of[node] = self.starts.len() - 1;
                self.floors.push(node);
                floor = self.above[node];
            }
            self.starts.push(self.floors.len());
        }
        Ok(())
    }

    /// Number of buildings.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.floors.is_empty()
    }

    /// Whether no floor stands on another one.
    #[inline]
    pub fn are_single(&self) -> bool {
        self.len() == self.floors.len()
    }

    /// Nodes of all floors, building by building.
    pub fn all(&self) -> &[usize] {
        &self.floors
    }

    /// Range of the floors of each building among all floors.
    pub fn ranges(&self) -> impl Iterator<Item = Range<usize>> {
        self.starts.windows(2).map(|ends| ends[0]..ends[1])
    }

    /// The floors of each building.
    pub fn each(&self) -> impl Iterator<Item = &[usize]> {
        self.ranges().map(|range| &self.floors[range])
    }

    /// The floors of a building.
    pub fn floors(&self, building: usize) -> &[usize] {
        &self.floors[self.starts[building]..self.starts[building + 1]]
    }

    /// Gives every floor a mark that any floor of its building has; true if a floor did not have it.
    pub(crate) fn share<Body>(&self, bodies: &mut [Body], mark: impl Fn(&mut Body) -> &mut bool) -> bool {
        let mut grown = false;
        for floors in self.each() {
            if floors.iter().any(|floor| *mark(&mut bodies[*floor])) {
                for floor in floors {
                    grown |= !std::mem::replace(mark(&mut bodies[*floor]), true);
                }
            }
        }
        grown
    }

    /// The building of a node.
    pub fn of(&self, node: usize) -> usize {
        self.of[node]
    }

    /// The floor that stands on a node; `None` for the top floor of a building and for a wall.
    pub fn above(&self, node: usize) -> Option<usize> {
        self.above[node]
    }
}

fn find_above<Column>(nodes: &[Node<Column>], above: &mut Vec<Option<usize>>) -> Result<(), ModelError> {
    above.clear();
    above.resize(nodes.len(), None);
    for (index, node) in nodes.iter().enumerate() {
        let Support::Floor(Floor { below, ground_damping }) = node.support else {
            continue;
        };
        if !(ground_damping >= 0.0 && ground_damping.is_finite()) {
            return Err(ModelError::Node {
                node: index,
                field: "support.ground_damping",
                found: ground_damping,
                allowed: "a finite number >= 0",
            });
        }
        let free = below < index && above[below].is_none();
        if !free || node.is_wall() || nodes[below].is_wall() {
            return Err(ModelError::NotAFloor { node: index, below });
        }
        above[below] = Some(index);
    }
    Ok(())
}
