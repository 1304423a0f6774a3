//! Buildings that find their equilibrium together, and the elimination in their equations, by kind of coupling.

use std::ops::Range;

use crate::implicit::equation::Cluster;
use crate::implicit::trial::{PairTrial, Trial};
use crate::model::profile::Profile;
use crate::{RestoringForce, Row};

/// Neighbouring structures of one storey; each touches the next.
pub(crate) struct TouchingLine {
    pub(crate) nodes: Range<usize>,
    pub(crate) pairs: Range<usize>,
}

impl Cluster for TouchingLine {
    const STOREYS: bool = false;

    #[inline]
    fn nodes(&self) -> impl Iterator<Item = usize> + Clone {
        self.nodes.clone()
    }

    #[inline]
    fn pairs(&self) -> impl Iterator<Item = usize> {
        self.pairs.clone()
    }

    /// Elimination in the tridiagonal system, in place.
    ///
    /// Rows are diagonally dominant as long as tangents are ≥ 0, so no pivoting is needed.
    #[inline]
    fn correct<Column: RestoringForce>(&mut self, _: &Row<Column>, trials: &mut [Trial<Column::Memory>], _: &[PairTrial]) {
        let cluster = &mut trials[self.nodes.clone()];
        for index in 1..cluster.len() {
            let (above, below) = cluster.split_at_mut(index);
            let (above, below) = (&above[index - 1], &mut below[0]);
            let factor = below.lower / above.diagonal;
            below.diagonal -= factor * above.upper;
            below.residual -= factor * above.residual;
        }
        let mut right = 0.0;
        for trial in cluster.iter_mut().rev() {
            right = (-trial.residual - trial.upper * right) / trial.diagonal;
            trial.correction = right;
            trial.acceleration += right;
        }
    }
}

/// A building that touches nobody.
pub(crate) struct Alone<'a> {
    /// Its floors from the ground up.
    pub(crate) floors: &'a [usize],
}

impl Cluster for Alone<'_> {
    const STOREYS: bool = true;

    #[inline]
    fn nodes(&self) -> impl Iterator<Item = usize> + Clone {
        self.floors.iter().copied()
    }

    #[inline]
    fn pairs(&self) -> impl Iterator<Item = usize> {
        std::iter::empty()
    }

    /// Elimination in the tridiagonal system of its floors, as for a [`TouchingLine`].
    #[inline]
    fn correct<Column: RestoringForce>(&mut self, _: &Row<Column>, trials: &mut [Trial<Column::Memory>], _: &[PairTrial]) {
        for floors in self.floors.windows(2) {
            let under = &trials[floors[0]];
            let (above, residual, diagonal) = (under.above, under.residual, under.diagonal);
            let floor = &mut trials[floors[1]];
            let factor = floor.below / diagonal;
            floor.diagonal -= factor * above;
            floor.residual -= factor * residual;
        }
        let mut above = 0.0;
        for floor in self.floors.iter().rev() {
            let trial = &mut trials[*floor];
            above = (-trial.residual - trial.above * above) / trial.diagonal;
            trial.correction = above;
            trial.acceleration += above;
        }
    }
}

/// Buildings that touch each other.
pub(crate) struct Joined<'a> {
    /// Their floors in the order of elimination.
    pub(crate) nodes: &'a [usize],
    pub(crate) pairs: &'a [usize],
    /// The matrix, laid out for the cluster.
    pub(crate) profile: &'a mut Profile,
    /// Place of each node in the order of elimination.
    pub(crate) place: &'a [usize],
    /// Factor of the equation of each node.
    pub(crate) masses: &'a [f64],
}

impl Cluster for Joined<'_> {
    const STOREYS: bool = true;

    fn nodes(&self) -> impl Iterator<Item = usize> + Clone {
        self.nodes.iter().copied()
    }

    fn pairs(&self) -> impl Iterator<Item = usize> {
        self.pairs.iter().copied()
    }

    fn correct<Column: RestoringForce>(&mut self, row: &Row<Column>, trials: &mut [Trial<Column::Memory>], pairs: &[PairTrial]) {
        let nodes = self.nodes.iter();
        for (force, node) in self.profile.vector.iter_mut().zip(nodes) {
            *force = -self.masses[*node] * trials[*node].residual;
        }
        self.solve(row, trials, pairs);
        for (correction, node) in self.profile.vector.iter().zip(self.nodes) {
            trials[*node].correction = *correction;
            trials[*node].acceleration += correction;
        }
    }
}

impl Joined<'_> {
    /// Builds the matrix of the equations, each times its mass, and solves for the vector of the profile.
    ///
    /// Storeys and pairs push both of their ends equally, in proportion to their relative motion. The matrix is therefore symmetric and, as
    /// tangents are ≥ 0, positive definite.
    pub(crate) fn solve<Column: RestoringForce>(&mut self, row: &Row<Column>, trials: &[Trial<Column::Memory>], pairs: &[PairTrial]) {
        self.profile.clear();
        for (place, &node) in self.nodes.iter().enumerate() {
            let (mass, trial) = (self.masses[node], &trials[node]);
            self.profile.add(place, place, mass * trial.diagonal);
            if let Some(below) = row.nodes()[node].support.below() {
                let below = self.place[below];
                self.profile.add(place, below, mass * trial.below);
            }
        }
        for &pair in self.pairs {
            let (relation, tangent) = (&row.pairs()[pair].relation, pairs[pair].tangent);
            for (index, (one, part)) in relation.pushes().enumerate() {
                for (other, of_other) in relation.pushes().skip(index + 1) {
                    let [own, inverse_mass] = [self.masses[other], row.nodes()[other].inverse_mass];
                    if couples(row, one, other) {
                        let element = part * of_other * (own * (inverse_mass * tangent));
                        self.profile.add(self.place[one], self.place[other], element);
                    }
                }
            }
        }
        self.profile.solve();
    }
}

/// Whether two floors move each other; a wall never moves.
pub(crate) fn couples<Column: RestoringForce>(row: &Row<Column>, one: usize, other: usize) -> bool {
    let is_wall = |node: usize| row.nodes()[node].is_wall();
    !is_wall(one) && !is_wall(other)
}
