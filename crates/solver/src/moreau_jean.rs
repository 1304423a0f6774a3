//! Moreau–Jean time stepping: a θ-method on velocities with the law of impact at the level of velocities.
//!
//! Source: J. J. Moreau, in *Nonsmooth Mechanics and Applications* (1988) 1; M. Jean, *Comput. Methods Appl. Mech.
//! Engng* 177 (1999) 235; V. Acary & B. Brogliato, *Numerical Methods for Nonsmooth Dynamical Systems* (2008), ch. 10.
//!
//! Over a step h: m(u̇⁺ − u̇) = h (θ r⁺ + (1−θ) r) + P and u⁺ = u + h (θ u̇⁺ + (1−θ) u̇), r all smooth forces. A pair takes
//! part where its gap, predicted half a step ahead, is closed; then 0 ≤ v⁺ + e v ⟂ P ≥ 0, v its relative velocity
//! (negative while approaching) at both ends of the step. All pairs are solved together with the step.
//!
//! Two departures, so that no impact creates energy. A pair that separates at the start of the step, or would at its end
//! without impulses, waits for the next step. And where the smooth forces slow the approach down within the step, what
//! they leave of it is turned round, not the v of the start.
//!
//! Smooth forces are implicit, compliant pairs among them; columns that yield and pairs of both kinds side by side are
//! met by repeating the solution with the tangents of the last one.
//!
//! An impulse is reported at the end of its step, as a jump from the velocity that the smooth forces alone give. Where
//! buildings are hit on several levels the jumps of one instant create no energy together: the matrix of the step lets
//! velocities follow impulses no further than free masses. One of them alone may seem to, at a large step: its pair
//! was turned round by what storeys passed on from other levels.

use crate::error::require;
use crate::ground::{Ground, Shaking};
use crate::impacts::impulsive;
use crate::joint::Joint;
use crate::newmark::{Scratch, arrive, balance, begin, commit, load, load_at};
use crate::newton::{self, Slopes};
use crate::together::Together;
use crate::trial::Trial;
use crate::{Course, Excitation, Pair, Recorder, RestoringForce, Row, RunError, State, Work};

/// Settings of Moreau–Jean time stepping. No critical time step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoreauJean {
    /// θ \[–\], 1/2 (order 2 while nothing touches, no damping of its own) ..= 1 (order 1, most damping).
    pub theta: f64,
}

/// What a pair may lack of its law, relative to its velocities before and after.
const TOLERANCE: f64 = 1e-12;
/// What rounding leaves of a velocity, relative to what it is a sum of.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Solutions after which a step is given up.
const MAX_ITERATIONS: u32 = 50;

impl MoreauJean {
    pub(crate) fn check(self) -> Result<(), RunError> {
        let valid = (0.5..=1.0).contains(&self.theta);
        require(valid, "theta", self.theta, "0.5 to 1")
    }
}

/// What the impulses of a step need.
pub(crate) struct Contacts {
    /// Pairs that take part in this step.
    pub(crate) closed: Vec<bool>,
    /// Impulse of every pair \[N·s\].
    pub(crate) impulses: Vec<f64>,
    /// Net impulse on every structure \[N·s\].
    net: Vec<f64>,
    /// Velocity a unit impulse gives to each structure, its smooth forces included \[1/kg\].
    pub(crate) mobilities: Vec<f64>,
    /// Relative velocity at which each pair is to separate at least \[m/s\].
    pub(crate) bounce: Vec<f64>,
    /// Rate at which the grounds of each pair move towards each other at the end of the step \[m/s\]; 0 where they move alike.
    opening_rates: Vec<f64>,
    /// Pairs that do not yet meet the law of impact.
    lacking: Vec<bool>,
    /// Impulse of every pair that was found last \[N·s\].
    found: Vec<f64>,
    /// Solutions of the step so far.
    pub(crate) solution: u32,
    together: Together<f64>,
    /// Of clusters with storeys; nothing in a row of structures of one storey.
    joint: Option<Joint>,
}

/// Integrates a row; the shared signature of all methods. Clusters of compliant pairs form as in Newmark's method.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: MoreauJean,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    let clock = course.clock;
    settings.check()?;
    let (dt, theta) = (clock.time_step, settings.theta);
    let guard = course.begin(row.nodes().len());
    let shaking = Shaking::new(row, excitation, clock);
    let slopes = Slopes {
        displacement: theta * theta * dt * dt,
        velocity: theta * dt,
        inertia: 1.0,
        time_step: dt,
    };
    let mut scratch = begin(row, shaking.at(0));
    let size = (row.nodes().len(), row.pairs().len());
    let mut contacts = Contacts::new(size, scratch.clusters.is_some());
    let mut work = Work::default();
    for step in 1..=clock.n_steps {
        guard.step(step, clock)?;
        let at_ends = [step - 1, step].map(|node| shaking.at(node));
        let instant = (at_ends[1], clock.time(step));
        contacts.solve(row, &mut scratch, (slopes, (at_ends, instant.1)), &mut work)?;
        arrive(&mut scratch, (clock, step))?;
        let hit = contacts.impulses.iter().any(|impulse| *impulse > 0.0);
        if hit {
            contacts.release(row, &mut scratch.ends, at_ends[1]);
        }
        commit(row, &mut scratch, (clock, step), recorder, |node, ends| {
            // The smooth forces at the end are those of the velocities after the impulses.
            let after = |node: usize| {
                ends[1][node].velocity + row.nodes()[node].inverse_mass * contacts.net[node]
            };
            let start = load::<_, R>(row, node, ends[0], at_ends[0].under(node));
            let end = load_at::<_, R>(row, node, ends[1], (at_ends[1].under(node), after));
            ((dt, [1.0 - theta, theta]), [start, end])
        });
        work.touching_steps += contacts.n_touching(row, &scratch, at_ends[1]);
        if hit {
            let Scratch {
                states, impacts, ..
            } = &mut scratch;
            impacts.impose(row, (states, &contacts.impulses), instant, recorder);
        }
        work.steps += 1;
    }
    Ok(work)
}

impl Contacts {
    fn new((n_structures, n_pairs): (usize, usize), has_storeys: bool) -> Self {
        Self {
            closed: vec![false; n_pairs],
            impulses: vec![0.0; n_pairs],
            net: vec![0.0; n_structures],
            mobilities: vec![0.0; n_structures],
            bounce: vec![0.0; n_pairs],
            opening_rates: vec![0.0; n_pairs],
            lacking: vec![false; n_pairs],
            found: vec![0.0; n_pairs],
            solution: 0,
            together: Together::new(n_pairs),
            joint: has_storeys.then(|| Joint::new(n_structures, n_pairs)),
        }
    }

    /// Rate of deformation of a pair at the end of the step \[m/s\].
    pub(crate) fn rate<Memory>(&self, index: usize, pair: &Pair, trials: &[Trial<Memory>]) -> f64 {
        trials[pair.left].velocity - trials[pair.right].velocity + self.opening_rates[index]
    }

    /// Chooses the pairs that take part in the step ahead.
    fn choose<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &Scratch<Column::Memory>,
        (dt, ground): (f64, Ground<'_>),
    ) {
        self.impulses.fill(0.0);
        for (pair, closed) in row.pairs().iter().zip(&mut self.closed) {
            let rate = ground.rate_of(pair, &scratch.states);
            let ahead = ground.deformation_of(pair, &scratch.states) + 0.5 * dt * rate;
            *closed = impulsive(pair).is_some() && rate >= 0.0 && ahead >= 0.0;
        }
    }

    /// Solves a step: smooth forces with the impulses found so far, impulses with those forces, until neither changes.
    fn solve<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &mut Scratch<Column::Memory>,
        (slopes, (ground, time)): (Slopes, ([Ground<'_>; 2], f64)),
        work: &mut Work,
    ) -> Result<(), RunError> {
        self.choose(row, scratch, (slopes.time_step, ground[0]));
        for (rate, pair) in self.opening_rates.iter_mut().zip(row.pairs()) {
            *rate = ground[1].opening(pair).velocity;
        }
        for iterations in 0..=MAX_ITERATIONS {
            self.solution = iterations;
            self.predict(row, scratch, slopes);
            balance(row, scratch, (slopes, ground), time, work)?;
            if iterations == 0 {
                self.approach(row, scratch, ground[0]);
            }
            if !self.correct(row, scratch, slopes) {
                return Ok(());
            }
        }
        Err(self.failure(row, time))
    }

    /// Of the pairs chosen, leaves those that still approach at the end of the step without impulses.
    fn approach<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &Scratch<Column::Memory>,
        start: Ground<'_>,
    ) {
        for (index, pair) in row.pairs().iter().enumerate() {
            if let Some(law) = impulsive(pair).filter(|_| self.closed[index]) {
                let left = self.rate(index, pair, &scratch.trials);
                self.closed[index] = left >= 0.0;
                self.bounce[index] =
                    law.restitution * left.min(start.rate_of(pair, &scratch.states));
            }
        }
    }

    /// Displacements and velocities at the end of the step without its smooth forces there, but with the impulses.
    fn predict<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &mut Scratch<Column::Memory>,
        slopes: Slopes,
    ) {
        self.net.fill(0.0);
        for (pair, impulse) in row.pairs().iter().zip(&self.impulses) {
            self.net[pair.left] -= impulse;
            self.net[pair.right] += impulse;
        }
        let dt = slopes.time_step;
        let bodies = scratch.states.iter().zip(&mut scratch.trials);
        for ((state, trial), (node, net)) in bodies.zip(row.nodes().iter().zip(&self.net)) {
            let change = (dt - slopes.velocity) * state.acceleration + node.inverse_mass * net;
            trial.predicted = (
                state.displacement + dt * state.velocity + slopes.velocity * change,
                state.velocity + change,
            );
            // Always from the same guess: a structure that was not hit then gets the same bits again.
            trial.acceleration = state.acceleration;
        }
    }

    /// Finds the impulses anew where the last ones do not meet the law of impact; true when there was such a pair.
    fn correct<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &mut Scratch<Column::Memory>,
        slopes: Slopes,
    ) -> bool {
        newton::mobilities(row.nodes(), &scratch.trials, &mut self.mobilities);
        let mut lacked = false;
        // Out of the struct while it changes the rest of it.
        if let Some(mut joint) = self.joint.take() {
            lacked = joint.correct(row, self, scratch, slopes);
            self.joint = Some(joint);
        }
        lacked | self.correct_lines(row, scratch, slopes)
    }

    /// The same for clusters of structures of one storey.
    fn correct_lines<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &Scratch<Column::Memory>,
        slopes: Slopes,
    ) -> bool {
        let trials = &scratch.trials;
        let uncertain = |node: usize| slopes.velocity * trials[node].uncertain_acceleration();
        let mut lacks = false;
        for (index, pair) in row.pairs().iter().enumerate() {
            self.lacking[index] =
                self.is_in_line(index) && self.lacks(index, pair, scratch, uncertain);
            lacks |= self.lacking[index];
        }
        if !lacks {
            return false;
        }
        let taken = |index: usize| self.mobilities[index] * self.net[index];
        self.together.clear();
        for (index, pair) in row.pairs().iter().enumerate() {
            if self.is_in_line(index) {
                let rate = self.rate(index, pair, trials);
                // Without the impulses found so far, which are to be replaced.
                let demand = rate + self.bounce[index] + (taken(pair.right) - taken(pair.left));
                self.together.push((index, pair.left), demand);
            }
        }
        self.replace(row.pairs());
        true
    }

    /// Whether a pair takes part whose impulse is found with mobilities: one of structures of one storey.
    fn is_in_line(&self, pair: usize) -> bool {
        let member = |joint: &Joint| joint.members[pair];
        self.closed[pair] && !self.joint.as_ref().is_some_and(member)
    }

    /// Whether a closed pair does not meet 0 ≤ v⁺ + e v ⟂ P ≥ 0, beyond what balance and rounding leave open.
    ///
    /// Judged by velocities, not by the change of impulses: on a light structure between heavy ones rounding of the
    /// heavy velocities moves both impulses far, and together, for ever.
    pub(crate) fn lacks<Memory>(
        &self,
        index: usize,
        pair: &Pair,
        scratch: &Scratch<Memory>,
        uncertain: impl Fn(usize) -> f64,
    ) -> bool {
        let Scratch { states, trials, .. } = scratch;
        let impulse = self.impulses[index];
        let [left, right] = [pair.left, pair.right].map(|node| {
            let (trial, mobility) = (&trials[node], self.mobilities[node]);
            let pushed = mobility * (self.net[node].abs() + impulse);
            let terms = states[node].velocity.abs() + trial.velocity.abs() + pushed;
            let terms = terms + self.opening_rates[index].abs();
            uncertain(node) + ROUNDING * terms
        });
        let rate = self.rate(index, pair, trials);
        let lacking = rate + self.bounce[index];
        let allowed = TOLERANCE * (rate.abs() + self.bounce[index]) + (left + right);
        lacking > allowed || (impulse > 0.0 && lacking < -allowed)
    }

    /// Solves for the impulses of neighbouring closed pairs one of which lacks something; others keep every bit.
    fn replace(&mut self, pairs: &[Pair]) {
        self.together.solve(&self.mobilities);
        self.found.fill(0.0);
        for (link, impulse) in self.together.links.iter().zip(&self.together.impulses) {
            self.found[link.pair] = *impulse;
        }
        let mut first = 0;
        while first < pairs.len() {
            let mut end = first + 1;
            while end < pairs.len()
                && self.closed[first]
                && self.closed[end]
                && pairs[end].left == pairs[end - 1].right
            {
                end += 1;
            }
            if self.lacking[first..end].contains(&true) {
                self.impulses[first..end].copy_from_slice(&self.found[first..end]);
            }
            first = end;
        }
    }

    /// Takes the impulses out of the velocities again: they are added when the spans have been reported.
    ///
    /// Accelerations follow, also of the floors that a damper joins to one that was hit.
    fn release<Column: RestoringForce>(
        &self,
        row: &Row<Column>,
        ends: &mut [State],
        ground: Ground<'_>,
    ) {
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
    fn n_touching<Column: RestoringForce>(
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

    /// Why a step is given up: its impulses still change.
    fn failure<Column: RestoringForce>(&self, row: &Row<Column>, time: f64) -> RunError {
        let closed = |(pair, closed): (&Pair, &bool)| closed.then_some((pair.left, pair.right));
        let mut pairs = row.pairs().iter().zip(&self.closed).filter_map(closed);
        let (first, mut last) = pairs.next().expect("impulses of closed pairs only change");
        for (_, right) in pairs {
            last = right;
        }
        RunError::ImpulsesNotFound {
            first,
            last,
            time,
            iterations: MAX_ITERATIONS,
        }
    }
}
