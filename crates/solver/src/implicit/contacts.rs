//! The impulses of a step of the Moreau–Jean method: pairs that take part, and pairs that violate the law of impact.

use crate::implicit::equation::Slopes;
use crate::implicit::step::Scratch;
use crate::implicit::trial::Trial;
use crate::model::ground::Ground;
use crate::{Pair, RestoringForce, Row, RunError, State};

/// Accepted violation of the law of impact, relative to the velocities before and after.
const TOLERANCE: f64 = 1e-12;
/// Rounding of a velocity, relative to its terms.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The impulses of a step, and the data that determine them.
pub(crate) struct Contacts {
    /// Pairs that take part in this step.
    pub(crate) closed: Vec<bool>,
    /// Impulse of every pair \[N·s\].
    pub(crate) impulses: Vec<f64>,
    /// Net impulse on every structure \[N·s\].
    pub(crate) net: Vec<f64>,
    /// Velocity of each structure under a unit impulse, with its smooth forces \[1/kg\].
    pub(crate) mobilities: Vec<f64>,
    /// Smallest relative velocity of separation of each pair \[m/s\].
    pub(crate) bounce: Vec<f64>,
    /// Rate at which the grounds of each pair move towards each other at the end of the step \[m/s\]; 0 if they move alike.
    pub(crate) opening_rates: Vec<f64>,
    /// Number of the present solution.
    pub(crate) solution: u32,
}

impl Contacts {
    pub(crate) fn new(n_structures: usize, n_pairs: usize) -> Self {
        Self {
            closed: vec![false; n_pairs],
            impulses: vec![0.0; n_pairs],
            net: vec![0.0; n_structures],
            mobilities: vec![0.0; n_structures],
            bounce: vec![0.0; n_pairs],
            opening_rates: vec![0.0; n_pairs],
            solution: 0,
        }
    }

    /// Rate of deformation of a pair at the end of the step \[m/s\].
    pub(crate) fn rate<Memory>(&self, index: usize, pair: &Pair, trials: &[Trial<Memory>]) -> f64 {
        pair.relation.ahead(|floor| trials[floor].velocity) + self.opening_rates[index]
    }

    /// Chooses the pairs that take part in the step ahead.
    pub(crate) fn choose<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &Scratch<Column::Memory>,
        dt: f64,
        ground: Ground<'_>,
    ) {
        self.impulses.fill(0.0);
        for (pair, closed) in row.pairs().iter().zip(&mut self.closed) {
            let rate = ground.rate_of(pair, &scratch.states);
            let ahead = ground.deformation_of(pair, &scratch.states) + 0.5 * dt * rate;
            *closed = pair.law.impulsive().is_some() && rate >= 0.0 && ahead >= 0.0;
        }
    }

    /// Keeps, of the chosen pairs, those that still approach at the end of the step without impulses.
    pub(crate) fn approach<Column: RestoringForce>(&mut self, row: &Row<Column>, scratch: &Scratch<Column::Memory>, start: Ground<'_>) {
        for (index, pair) in row.pairs().iter().enumerate() {
            if let Some(law) = pair.law.impulsive().filter(|_| self.closed[index]) {
                let left = self.rate(index, pair, &scratch.trials);
                self.closed[index] = left >= 0.0;
                self.bounce[index] = law.restitution * left.min(start.rate_of(pair, &scratch.states));
            }
        }
    }

    /// Displacements and velocities at the end of the step without the smooth forces at the end, but with the impulses.
    pub(crate) fn predict<Column: RestoringForce>(&mut self, row: &Row<Column>, scratch: &mut Scratch<Column::Memory>, slopes: Slopes) {
        self.net.fill(0.0);
        for (pair, impulse) in row.pairs().iter().zip(&self.impulses) {
            pair.relation.spread(*impulse, |floor, impulse| self.net[floor] += impulse);
        }
        let dt = slopes.time_step;
        let bodies = scratch.states.iter().zip(&mut scratch.trials);
        for ((state, trial), (node, net)) in bodies.zip(row.nodes().iter().zip(&self.net)) {
            let change = (dt - slopes.velocity) * state.acceleration + node.inverse_mass * net;
            trial.predicted = (
                state.displacement + dt * state.velocity + slopes.velocity * change,
                state.velocity + change,
            );
            // The same initial guess every time: a structure that was not hit gets the same bits again.
            trial.acceleration = state.acceleration;
        }
    }

    /// Whether a closed pair violates 0 ≤ v⁺ + e v ⟂ P ≥ 0 by more than balance and rounding allow.
    ///
    /// The criterion uses velocities, not the change of impulses: for a light structure between heavy ones, the rounding of the heavy
    /// velocities moves both impulses far, together and for ever.
    pub(crate) fn lacks<Memory>(&self, index: usize, pair: &Pair, scratch: &Scratch<Memory>, uncertain: impl Fn(usize) -> f64) -> bool {
        let Scratch { states, trials, .. } = scratch;
        let impulse = self.impulses[index];
        let open = |node: usize| {
            let (trial, mobility) = (&trials[node], self.mobilities[node]);
            let pushed = mobility * (self.net[node].abs() + impulse);
            let terms = states[node].velocity.abs() + trial.velocity.abs() + pushed;
            let terms = terms + self.opening_rates[index].abs();
            uncertain(node) + ROUNDING * terms
        };
        let [left, right] = pair.relation.points().map(|point| point.of(open));
        let rate = self.rate(index, pair, trials);
        let lacking = rate + self.bounce[index];
        let allowed = TOLERANCE * (rate.abs() + self.bounce[index]) + (left + right);
        lacking > allowed || (impulse > 0.0 && lacking < -allowed)
    }

    /// Removes the impulses from the velocities. They are added once the spans have been reported.
    ///
    /// Accelerations follow, also those of floors joined by a damper to a floor that was hit.
    pub(crate) fn release<Column: RestoringForce>(&self, row: &Row<Column>, ends: &mut [State], ground: Ground<'_>) {
        let is_hit = |node: usize| self.net[node].abs() > 0.0;
        for (index, (node, end)) in row.nodes().iter().zip(&mut *ends).enumerate() {
            if is_hit(index) {
                end.velocity -= node.inverse_mass * self.net[index];
            }
        }
        for (index, node) in row.nodes().iter().enumerate() {
            let (below, above) = (node.support.below(), row.above(index));
            if is_hit(index) || below.is_some_and(is_hit) || above.is_some_and(is_hit) {
                ends[index].acceleration = row.acceleration(index, ends, ground.under(index));
            }
        }
    }

    /// Number of pairs that overlap or took part.
    pub(crate) fn n_touching<Column: RestoringForce>(
        &self,
        row: &Row<Column>,
        scratch: &Scratch<Column::Memory>,
        ground: Ground<'_>,
    ) -> u64 {
        let pairs = row.pairs().iter().zip(&self.closed);
        let overlaps = |pair: &Pair| ground.deformation_of(pair, &scratch.states) > 0.0;
        let touches = |(pair, closed): (&Pair, &bool)| *closed || overlaps(pair);
        pairs.filter(|pair| touches(*pair)).count() as u64
    }

    /// Error of a step whose impulses still change.
    pub(crate) fn failure<Column: RestoringForce>(&self, row: &Row<Column>, time: f64) -> RunError {
        let closed = |(pair, closed): (&Pair, &bool)| closed.then_some((pair.left(), pair.right()));
        let mut pairs = row.pairs().iter().zip(&self.closed).filter_map(closed);
        let (first, mut last) = pairs.next().expect("impulses of closed pairs only change");
        for (_, right) in pairs {
            last = right;
        }
        RunError::ImpulsesNotFound {
            first,
            last,
            time,
            iterations: self.solution,
        }
    }
}
