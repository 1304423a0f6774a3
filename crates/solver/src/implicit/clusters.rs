//! Clusters: buildings that pairs join and that move together.

use crate::implicit::cluster::{Joined, TouchingLine, couples};
use crate::model::buildings::Buildings;
use crate::model::incidence::Incident;
use crate::model::profile::Profile;
use crate::{Node, RestoringForce, Row};

/// Buildings that pairs join, updated whenever the joining pairs change; scratch of a run.
pub(crate) struct Clusters {
    /// For every building, an earlier building joined to it; for the first of a cluster, itself.
    earlier: Vec<usize>,
    /// For the first building of a cluster, the last building of the cluster.
    last: Vec<usize>,
    /// For every building, the next building of its cluster.
    next: Vec<Option<usize>>,
    /// Whether a pair joins a building to another one.
    joined: Vec<bool>,
    /// Nodes of the last gathered cluster, in the order of elimination: a floor comes after the floor below it.
    pub(crate) nodes: Vec<usize>,
    /// Pairs of this cluster.
    pub(crate) pairs: Vec<usize>,
    /// Pairs that couple its floors.
    pushing: Vec<usize>,
    /// Place of each of its nodes in that order.
    place: Vec<usize>,
    /// Mass of every node \[kg\]; 1 for a wall, whose equation keeps it in place.
    masses: Vec<f64>,
    /// Whether the pairs of the row are a chain.
    is_chain: bool,
    /// Whether the last gathered cluster has a building of several storeys.
    has_storeys: bool,
    /// Matrix of the cluster.
    profile: Profile,
}

impl Clusters {
    /// Clusters of a row with buildings of several storeys, or with pairs that are no chain; `None` for other rows, whose clusters are
    /// [lines](TouchingLine).
    pub(crate) fn new<Column: RestoringForce>(row: &Row<Column>) -> Option<Self> {
        let buildings = row.buildings();
        if buildings.are_single() && row.is_chain() {
            return None;
        }
        let mass = |node: &Node<Column>| {
            if node.is_wall() { 1.0 } else { 1.0 / node.inverse_mass }
        };
        let (n, n_buildings) = (row.nodes().len(), buildings.len());
        let tallest = buildings.each().map(<[usize]>::len).max();
        let width = tallest.unwrap_or(0).min(n_buildings);
        Some(Self {
            earlier: vec![0; n_buildings],
            last: vec![0; n_buildings],
            next: vec![None; n_buildings],
            joined: vec![false; n_buildings],
            nodes: Vec::with_capacity(n),
            pairs: Vec::with_capacity(row.pairs().len()),
            pushing: Vec::with_capacity(row.pairs().len()),
            place: vec![0; n],
            masses: row.nodes().iter().map(mass).collect(),
            is_chain: row.is_chain(),
            has_storeys: false,
            profile: Profile::with_capacity(n, n * (width + 1)),
        })
    }

    /// Joins buildings by pairs of nodes.
    pub(crate) fn join(&mut self, buildings: &Buildings, pairs: impl Iterator<Item = (usize, usize)>) {
        for (building, earlier) in self.earlier.iter_mut().enumerate() {
            *earlier = building;
        }
        self.joined.fill(false);
        for (left, right) in pairs {
            let [left, right] = [left, right].map(|node| buildings.of(node));
            self.joined[left] = true;
            self.joined[right] = true;
            let [left, right] = [self.first(left), self.first(right)];
            self.earlier[left.max(right)] = left.min(right);
        }
        for building in 0..self.earlier.len() {
            self.next[building] = None;
            self.last[building] = building;
            let first = self.first(building);
            if first != building {
                self.next[self.last[first]] = Some(building);
                self.last[first] = building;
            }
        }
    }

    /// The first building of the cluster of a building.
    fn first(&mut self, mut building: usize) -> usize {
        while self.earlier[building] != building {
            let earlier = self.earlier[building];
            self.earlier[building] = self.earlier[earlier];
            building = earlier;
        }
        building
    }

    /// Gathers the cluster that begins with a building; true if it has more than this building.
    pub(crate) fn gather<Column: RestoringForce>(&mut self, row: &Row<Column>, first: usize, is_taken: impl Fn(usize) -> bool) -> bool {
        if !self.joined[first] || self.earlier[first] != first {
            return false;
        }
        self.nodes.clear();
        let (mut n_buildings, mut tallest) = (0, 0);
        let mut building = Some(first);
        while let Some(index) = building {
            let floors = row.buildings().floors(index);
            self.nodes.extend_from_slice(floors);
            n_buildings += 1;
            tallest = tallest.max(floors.len());
            building = self.next[index];
        }
        self.has_storeys = tallest > 1;
        // Level by level the width of the matrix is the number of buildings; building by building it is the number of storeys.
        if n_buildings <= tallest {
            self.nodes.sort_unstable();
        }
        self.pairs.clear();
        for &node in &self.nodes {
            // If several floors carry the left point of a pair, the first floor gathered takes the pair.
            for Incident { pair, .. } in row.incidence().at(node).iter().filter(|at| at.on_left) {
                if is_taken(*pair) && !self.pairs.contains(pair) {
                    self.pairs.push(*pair);
                }
            }
        }
        true
    }

    /// Whether the last gathered cluster is more than a [`TouchingLine`]: it has a building of several storeys, or may branch.
    pub(crate) fn is_general(&self) -> bool {
        !self.is_chain || self.has_storeys
    }

    /// Lists the places of the nodes of the last gathered cluster, building by building; returns the number of nodes of the first building.
    pub(crate) fn by_building(&self, buildings: &Buildings, places: &mut Vec<usize>) -> usize {
        let building = |place: &usize| buildings.of(self.nodes[*place]);
        places.clear();
        places.extend(0..self.nodes.len());
        places.sort_unstable_by_key(|place| (building(place), *place));
        let first = places.first().map(building);
        places.partition_point(|place| Some(building(place)) == first)
    }

    /// The last gathered cluster if none of its buildings has several storeys: its structures are neighbours and each touches the next.
    /// Tall buildings elsewhere in the row then do not change their bits.
    pub(crate) fn line(&self) -> Option<TouchingLine> {
        let range = |indices: &[usize]| {
            let (first, last) = (indices.first()?, indices.last()?);
            Some(*first..*last + 1)
        };
        if self.is_general() {
            return None;
        }
        Some(TouchingLine {
            nodes: range(&self.nodes)?,
            pairs: range(&self.pairs)?,
        })
    }

    /// The last gathered cluster. Its pairs that push couple their floors.
    pub(crate) fn joined<Column: RestoringForce>(&mut self, row: &Row<Column>, pushes: impl Fn(usize) -> bool) -> Joined<'_> {
        for (place, node) in self.nodes.iter().enumerate() {
            self.place[*node] = place;
        }
        self.pushing.clear();
        let pairs = self.pairs.iter().copied();
        self.pushing.extend(pairs.filter(|pair| pushes(*pair)));
        self.profile.begin(self.nodes.len());
        for (place, node) in self.nodes.iter().enumerate() {
            if let Some(below) = row.nodes()[*node].support.below() {
                self.profile.join(place, self.place[below]);
            }
        }
        for pair in &self.pushing {
            let relation = &row.pairs()[*pair].relation;
            for (index, (one, _)) in relation.pushes().enumerate() {
                for (other, _) in relation.pushes().skip(index + 1) {
                    if couples(row, one, other) {
                        self.profile.join(self.place[one], self.place[other]);
                    }
                }
            }
        }
        self.profile.lay_out();
        Joined {
            nodes: &self.nodes,
            pairs: &self.pushing,
            profile: &mut self.profile,
            place: &self.place,
            masses: &self.masses,
        }
    }
}
