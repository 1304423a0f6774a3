//! Impulses of Moreau–Jean stepping on buildings of several storeys.
//!
//! An impulse on a floor moves the other floors of its building within the step, through the storeys, and the floors of buildings that
//! compliant pairs join to it. Velocities follow from impulses by the inverse of the matrix of the step's equations. All pairs of a cluster
//! are solved with this inverse.

use crate::impact::dense::{ClosedIn, Complementarity};
use crate::implicit::clusters::Clusters;
use crate::implicit::contacts::Contacts;
use crate::implicit::equation::Slopes;
use crate::implicit::step::Scratch;
use crate::{RestoringForce, Row};

/// Solutions of a step after which every second one is taken half way. Otherwise columns that yield under one impulse and not under the
/// next could change their tangents for ever (1 in 2400 random rows of light floors, Δt = 0.01 s).
const TRUSTED: u32 = 8;

/// Scratch of the clusters with storeys.
pub(crate) struct Joint {
    /// Closed impulsive pairs of clusters with storeys.
    pub(crate) members: Vec<bool>,
    /// Pairs of the present cluster.
    pairs: Vec<usize>,
    /// Uncertainty of the velocity of each node after equilibrium \[m/s\].
    uncertain: Vec<f64>,
    /// Places of the nodes of the cluster, building by building.
    places: Vec<usize>,
    problem: Complementarity,
}

impl Joint {
    pub(crate) fn new(n_nodes: usize, n_pairs: usize) -> Self {
        Self {
            members: vec![false; n_pairs],
            pairs: Vec::with_capacity(n_pairs),
            uncertain: vec![0.0; n_nodes],
            places: Vec::with_capacity(n_nodes),
            problem: Complementarity::new(n_pairs, n_nodes),
        }
    }

    /// Finds new impulses for every cluster with storeys in which a pair violates the law of impact; true if there was such a pair. The
    /// error is a pair that walls on both sides leave no impulse.
    pub(crate) fn correct<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        contacts: &mut Contacts,
        scratch: &mut Scratch<Column::Memory>,
        slopes: Slopes,
    ) -> Result<bool, usize> {
        self.members.fill(false);
        let Some(mut clusters) = scratch.clusters.take() else {
            return Ok(false);
        };
        let mut lacked = Ok(false);
        if contacts.closed.contains(&true) {
            let joins = |pair: usize| contacts.closed[pair] || scratch.touching[pair];
            let pairs = row.pairs().iter().enumerate();
            let pairs = pairs.filter(|(index, _)| joins(*index));
            clusters.join(row.buildings(), pairs.map(|(_, pair)| (pair.left(), pair.right())));
            for first in 0..row.buildings().len() {
                let joins = |pair: usize| contacts.closed[pair] || scratch.touching[pair];
                if clusters.gather(row, first, joins) && clusters.is_general() {
                    let settled = self.settle(row, &mut clusters, contacts, scratch, slopes);
                    lacked = lacked.and_then(|lacked| Ok(lacked | settled?));
                }
            }
        }
        scratch.clusters = Some(clusters);
        lacked
    }

    /// Finds new impulses for a cluster.
    fn settle<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        clusters: &mut Clusters,
        contacts: &mut Contacts,
        scratch: &Scratch<Column::Memory>,
        slopes: Slopes,
    ) -> Result<bool, usize> {
        let pairs = clusters.pairs.iter().copied();
        self.pairs.clear();
        self.pairs.extend(pairs.filter(|pair| contacts.closed[*pair]));
        if self.pairs.is_empty() {
            return Ok(false);
        }
        let trials = &scratch.trials;
        let split = clusters.by_building(row.buildings(), &mut self.places);
        let mut joined = clusters.joined(row, |pair| scratch.touching[pair]);
        for (allowed, node) in joined.profile.vector.iter_mut().zip(joined.nodes) {
            *allowed = joined.masses[*node] * trials[*node].allowed_residual();
        }
        joined.solve(row, trials, &scratch.pairs);
        for (open, node) in joined.profile.vector.iter().zip(joined.nodes) {
            self.uncertain[*node] = slopes.velocity * open;
            // An impulse moves a floor at most as far as a free floor.
            contacts.mobilities[*node] = row.nodes()[*node].inverse_mass;
        }
        let mut lacked = false;
        for &index in &self.pairs {
            self.members[index] = true;
            let uncertain = |node: usize| self.uncertain[node];
            lacked |= contacts.lacks(index, &row.pairs()[index], scratch, uncertain);
        }
        if !lacked {
            return Ok(false);
        }
        self.problem.begin(joined.nodes.len(), split);
        for &index in &self.pairs {
            let pair = &row.pairs()[index];
            let vector = &mut joined.profile.vector;
            vector.fill(0.0);
            for (node, weight) in pair.relation.pushes() {
                if !row.nodes()[node].is_wall() {
                    vector[joined.place[node]] = weight;
                }
            }
            joined.profile.halve();
            let column = self.places.iter().map(|place| joined.profile.vector[*place]);
            self.problem.push(column.enumerate());
        }
        self.replace(row, contacts, scratch)?;
        Ok(true)
    }

    /// Solves for the impulses of the present cluster.
    fn replace<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        contacts: &mut Contacts,
        scratch: &Scratch<Column::Memory>,
    ) -> Result<(), usize> {
        // Remove the earlier impulses, which are about to be replaced.
        let earlier = self.pairs.iter().map(|index| contacts.impulses[*index]);
        self.problem.apply(earlier);
        for (place, &index) in self.pairs.iter().enumerate() {
            let pair = &row.pairs()[index];
            let rate = contacts.rate(index, pair, &scratch.trials);
            let demand = rate + contacts.bounce[index] + self.problem.taken(place);
            self.problem.ask(place, demand, demand.abs());
        }
        let solved = self.problem.solve();
        solved.map_err(|ClosedIn { contact }| self.pairs[contact])?;
        let halves = contacts.solution >= TRUSTED && contacts.solution.is_multiple_of(2);
        for (&index, impulse) in self.pairs.iter().zip(self.problem.impulses()) {
            let earlier = contacts.impulses[index];
            contacts.impulses[index] = if halves { 0.5 * (earlier + impulse) } else { impulse };
        }
        Ok(())
    }
}
