//! As many rows of a common shape as there are lanes.

use fearless_simd::Simd;

use super::body::Body;
use super::column::SideBySideColumn;
use super::law::Law;
use super::number::{Lanes, MOST_LANES};
use super::points::LaneRelation;
use super::scenes::{LanePair, Structure};
use super::tally::SceneSum;
use pounding_solver::{Node, Row};

/// Rows of a common shape, at most as many as there are lanes. Lanes without a row repeat the last row.
pub(super) struct Rows<'a, Column> {
    pub(super) rows: &'a [&'a Row<Column>],
    /// Index of the first row among all scenes.
    pub(super) first: usize,
}

impl<Column> Clone for Rows<'_, Column> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Column> Copy for Rows<'_, Column> {}

impl<'a, Column> Rows<'a, Column> {
    /// The row of a lane.
    pub(super) fn lane(self, lane: usize) -> &'a Row<Column> {
        self.rows[lane.min(self.rows.len() - 1)]
    }

    /// The scene of a lane.
    pub(super) fn scene(self, lane: usize) -> usize {
        self.first + lane.min(self.rows.len() - 1)
    }
}

impl<Column: SideBySideColumn> Rows<'_, Column> {
    /// A structure of all rows before it feels the ground, for a time step \[s\].
    #[inline(always)]
    pub(super) fn structure<S: Simd>(self, simd: S, node: usize, time_step: f64) -> Structure<S, Column> {
        let displacement = |node| self.gather(simd, node, &|node| node.initial_displacement);
        let drift = match self.rows[0].nodes()[node].support.below() {
            None => displacement(node),
            Some(below) => displacement(node) - displacement(below),
        };
        Body::new(|number| self.gather(simd, node, number), drift, time_step)
    }

    /// A number of a structure, from all rows.
    #[inline(always)]
    pub(super) fn gather<S: Simd>(self, simd: S, node: usize, number: &dyn Fn(&Node<Column>) -> f64) -> Lanes<S> {
        let mut values = [0.0; MOST_LANES];
        for (lane, value) in values.iter_mut().enumerate().take(Lanes::<S>::N) {
            *value = number(&self.lane(lane).nodes()[node]);
        }
        Lanes::new(simd, &values)
    }

    /// A pair, by its index in the rows; `place` gives the place of a node's structure.
    #[inline(always)]
    pub(super) fn pair<S: Simd>(self, simd: S, index: usize, place: impl Fn(usize) -> usize) -> LanePair<S> {
        let pairs: [_; MOST_LANES] = std::array::from_fn(|lane| &self.lane(lane).pairs()[index]);
        let mass = |lane: usize| self.lane(lane).reduced_mass(pairs[lane]);
        LanePair {
            index,
            left: pairs[0].left(),
            relation: LaneRelation::new(simd, &pairs.map(|pair| pair.relation), place),
            lingers: false,
            gap: Lanes::new(simd, &pairs.map(pounding_solver::Pair::gap)),
            law: Law::new(simd, pairs.map(|pair| pair.law), std::array::from_fn(mass)),
            deformation: Lanes::splat(simd, 0.0),
            tally: SceneSum::new(simd),
        }
    }
}
