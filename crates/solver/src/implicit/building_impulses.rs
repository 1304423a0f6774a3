//! Impulses of Moreau–Jean stepping on buildings of several storeys.
//!
//! An impulse on one floor moves the others of its building within the step, through the storeys, and those of buildings
//! that a compliant pair joins to it. Velocities follow impulses by the inverse of the matrix of the step's equations, and
//! all pairs of a cluster are solved with that.

use crate::impact::dense::{ClosedIn, Complementarity};
use crate::implicit::clusters::Clusters;
use crate::implicit::contacts::Contacts;
use crate::implicit::equation::Slopes;
use crate::implicit::step::Scratch;
use crate::{RestoringForce, Row};

/// Solutions of a step after which every other one is taken half way: columns that yield under one impulse and do not under
/// the next would else change their tangents for ever (one in 2400 random rows of light floors, Δt = 0.01 s).
const TRUSTED: u32 = 8;

/// Scratch of the clusters with storeys.
pub(crate) struct Joint {
    /// Closed impulsive pairs that belong to such a cluster.
    pub(crate) members: Vec<bool>,
    /// Those of the cluster under way.
    pairs: Vec<usize>,
    /// What equilibrium leaves open of the velocity of a node \[m/s\].
    uncertain: Vec<f64>,
    /// Places of its nodes, building by building.
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

    /// Finds anew the impulses of every cluster with storeys that has a pair which does not meet the law of impact; true
    /// when there was such a pair. Errors with a pair that walls on both sides leave no impulse.
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
                    let settled = self.settle(row, &mut clusters, (contacts, scratch), slopes);
                    lacked = lacked.and_then(|lacked| Ok(lacked | settled?));
                }
            }
        }
        scratch.clusters = Some(clusters);
        lacked
    }

    /// The same for one cluster.
    fn settle<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        clusters: &mut Clusters,
        (contacts, scratch): (&mut Contacts, &Scratch<Column::Memory>),
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
            // No impulse moves a floor more than if it were free.
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

    /// Solves for the impulses of the cluster under way.
    fn replace<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        contacts: &mut Contacts,
        scratch: &Scratch<Column::Memory>,
    ) -> Result<(), usize> {
        // Without the impulses found so far, which are to be replaced.
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
