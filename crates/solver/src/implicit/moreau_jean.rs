//! Moreau–Jean time stepping: a θ-method on velocities, with the law of impact for velocities.
//!
//! Source: J. J. Moreau, in *Nonsmooth Mechanics and Applications* (1988) 1; M. Jean, *Comput. Methods Appl. Mech.
//! Engng* 177 (1999) 235; V. Acary & B. Brogliato, *Numerical Methods for Nonsmooth Dynamical Systems* (2008), ch. 10.
//!
//! Over a step h: m(u̇⁺ − u̇) = h (θ r⁺ + (1−θ) r) + P and u⁺ = u + h (θ u̇⁺ + (1−θ) u̇). Here r is the sum of all smooth forces. A pair
//! takes part if its gap, predicted half a step ahead, is closed. Then 0 ≤ v⁺ + e v ⟂ P ≥ 0, with v its relative velocity (negative while
//! approaching) at both ends of the step. All pairs are solved together with the step.
//!
//! Two departures ensure that no impact creates energy. A pair that separates at the start of the step, or would separate at its end
//! without impulses, waits for the next step. If the smooth forces slow the approach down within the step, the remaining approach is
//! reversed, not the v of the start.
//!
//! Smooth forces are implicit, including those of compliant pairs. For yielding columns, and for neighbouring pairs of both kinds, the
//! solution is repeated with the last tangents.
//!
//! An impulse is reported at the end of its step, as a jump from the velocity that the smooth forces alone give. If buildings are hit on
//! several levels, the jumps of an instant together create no energy. Through the matrix of the step, velocities follow impulses at most as
//! far as free masses. A single jump may seem to create energy at a large step, because storeys passed on a part of the hits on other
//! levels.

use crate::error::require;
use crate::impact::chain::Together;
use crate::implicit::building_impulses::Joint;
use crate::implicit::contacts::Contacts;
use crate::implicit::equation::Slopes;
use crate::implicit::newton::{self};
use crate::implicit::step::{Scratch, arrive, balance, begin, commit, load, load_at};
use crate::march::{ClockStep, Stepping, march};
use crate::model::ground::Ground;
use crate::span::Weights;
use crate::{Course, Excitation, Pair, Recorder, RestoringForce, Row, RunError, Work};

/// Settings of Moreau–Jean time stepping. No critical time step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoreauJean {
    /// θ \[–\], from 1/2 (order 2 while nothing touches, no numerical damping) to 1 (order 1, most damping).
    pub theta: f64,
}

/// Most solutions of a step. The run is given up beyond.
const MAX_ITERATIONS: u32 = 50;

impl MoreauJean {
    pub(crate) fn check(self) -> Result<(), RunError> {
        let valid = (0.5..=1.0).contains(&self.theta);
        require(valid, "theta", self.theta, "0.5 to 1")
    }
}

/// The solution of a step: its impulses, and what finds them.
struct Solution {
    contacts: Contacts,
    /// Pairs that still violate the law of impact.
    lacking: Vec<bool>,
    /// Last impulse found for every pair \[N·s\].
    found: Vec<f64>,
    together: Together<f64>,
    /// Scratch for buildings of several storeys.
    joint: Option<Joint>,
}

/// Integrates a row. Every method has a `run` function with these arguments. Clusters of compliant pairs form as in Newmark's method.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: MoreauJean,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    settings.check()?;
    let (dt, theta) = (course.clock.time_step, settings.theta);
    let begin = |ground: Ground<'_>| {
        let scratch = begin(row, ground);
        let (n_nodes, n_pairs) = (row.nodes().len(), row.pairs().len());
        MoreauJeanRun {
            theta,
            slopes: Slopes {
                displacement: theta * theta * dt * dt,
                velocity: theta * dt,
                inertia: 1.0,
                time_step: dt,
            },
            solution: Solution::new(n_nodes, n_pairs, scratch.clusters.is_some()),
            scratch,
        }
    };
    march(row, excitation, course, 1, begin, recorder)
}

/// A run: its state and all its memory, allocated once.
struct MoreauJeanRun<Memory> {
    theta: f64,
    slopes: Slopes,
    solution: Solution,
    scratch: Scratch<Memory>,
}

impl<Column: RestoringForce> Stepping<Column> for MoreauJeanRun<Column::Memory> {
    #[inline]
    fn step<R: Recorder>(&mut self, row: &Row<Column>, step: ClockStep<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError> {
        let (dt, theta, at_ends) = (step.clock.time_step, self.theta, step.ends());
        let (scratch, reads_weighed) = (&mut self.scratch, recorder.reads_weighed());
        self.solution.solve(row, scratch, self.slopes, &step, work)?;
        let contacts = &self.solution.contacts;
        arrive(scratch, &step)?;
        let hit = contacts.impulses.iter().any(|impulse| *impulse > 0.0);
        if hit {
            contacts.release(row, &mut scratch.ends, at_ends[1]);
        }
        commit(row, scratch, &step, recorder, |node, ends| {
            // The smooth forces at the end belong to the velocities after the impulses.
            let after = |node: usize| ends[1][node].velocity + row.nodes()[node].inverse_mass * contacts.net[node];
            let start = load(reads_weighed, row, node, ends[0], at_ends[0].under(node));
            let end = load_at(reads_weighed, row, node, ends[1], at_ends[1].under(node), after);
            let of_loads = [1.0 - theta, theta];
            (Weights { scale: dt, of_loads }, [start, end])
        });
        work.touching_steps += contacts.n_touching(row, scratch, at_ends[1]);
        if hit {
            let Scratch { states, impacts, .. } = scratch;
            impacts.impose(row, states, &contacts.impulses, step.end(), recorder);
        }
        Ok(())
    }
}

impl Solution {
    fn new(n_structures: usize, n_pairs: usize, has_storeys: bool) -> Self {
        Self {
            contacts: Contacts::new(n_structures, n_pairs),
            lacking: vec![false; n_pairs],
            found: vec![0.0; n_pairs],
            together: Together::new(n_pairs),
            joint: has_storeys.then(|| Joint::new(n_structures, n_pairs)),
        }
    }

    /// Solves a step: alternates smooth forces for the last impulses with impulses for these forces, until neither changes.
    fn solve<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &mut Scratch<Column::Memory>,
        slopes: Slopes,
        step: &ClockStep<'_>,
        work: &mut Work,
    ) -> Result<(), RunError> {
        let (ground, time) = (step.ends(), step.end().time);
        self.contacts.choose(row, scratch, slopes.time_step, ground[0]);
        for (rate, pair) in self.contacts.opening_rates.iter_mut().zip(row.pairs()) {
            *rate = ground[1].opening(pair).velocity;
        }
        for iterations in 0..=MAX_ITERATIONS {
            self.contacts.solution = iterations;
            self.contacts.predict(row, scratch, slopes);
            balance(row, scratch, slopes, step, work)?;
            if iterations == 0 {
                self.contacts.approach(row, scratch, ground[0]);
            }
            let corrected = self.correct(row, scratch, slopes);
            let closed_in = |index: usize| {
                let pair = &row.pairs()[index];
                let [left, right] = [pair.left(), pair.right()];
                RunError::ClosedIn { left, right, time }
            };
            if !corrected.map_err(closed_in)? {
                return Ok(());
            }
        }
        Err(self.contacts.failure(row, time))
    }

    /// Finds new impulses if the last ones violate the law of impact; true if any pair violated it. The error is a pair that walls on both
    /// sides leave no impulse.
    fn correct<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        scratch: &mut Scratch<Column::Memory>,
        slopes: Slopes,
    ) -> Result<bool, usize> {
        newton::mobilities(row.nodes(), &scratch.trials, &mut self.contacts.mobilities);
        let mut lacked = false;
        if let Some(joint) = &mut self.joint {
            lacked = joint.correct(row, &mut self.contacts, scratch, slopes)?;
        }
        Ok(lacked | self.correct_lines(row, scratch, slopes))
    }

    /// Finds new impulses for clusters of structures of one storey.
    fn correct_lines<Column: RestoringForce>(&mut self, row: &Row<Column>, scratch: &Scratch<Column::Memory>, slopes: Slopes) -> bool {
        let trials = &scratch.trials;
        let uncertain = |node: usize| slopes.velocity * trials[node].uncertain_acceleration();
        let mut lacks = false;
        for (index, pair) in row.pairs().iter().enumerate() {
            self.lacking[index] = self.is_in_line(index) && self.contacts.lacks(index, pair, scratch, uncertain);
            lacks |= self.lacking[index];
        }
        if !lacks {
            return false;
        }
        let taken = |index: usize| self.contacts.mobilities[index] * self.contacts.net[index];
        self.together.clear();
        for (index, pair) in row.pairs().iter().enumerate() {
            if self.is_in_line(index) {
                let rate = self.contacts.rate(index, pair, trials);
                // Remove the earlier impulses, which are about to be replaced.
                let taken = taken(pair.right()) - taken(pair.left());
                let demand = rate + self.contacts.bounce[index] + taken;
                self.together.push(index, pair.left(), demand);
            }
        }
        self.replace(row.pairs());
        true
    }

    /// Whether a pair takes part and its impulse is found with mobilities, as for structures of one storey.
    fn is_in_line(&self, pair: usize) -> bool {
        let member = |joint: &Joint| joint.members[pair];
        self.contacts.closed[pair] && !self.joint.as_ref().is_some_and(member)
    }

    /// Solves for the impulses of neighbouring closed pairs if any of them violates the law; others keep every bit.
    fn replace(&mut self, pairs: &[Pair]) {
        self.together.solve(&self.contacts.mobilities);
        self.found.fill(0.0);
        for (link, impulse) in self.together.links.iter().zip(&self.together.impulses) {
            self.found[link.pair] = *impulse;
        }
        let mut first = 0;
        while first < pairs.len() {
            let mut end = first + 1;
            while end < pairs.len()
                && self.contacts.closed[first]
                && self.contacts.closed[end]
                && pairs[end].left() == pairs[end - 1].right()
            {
                end += 1;
            }
            if self.lacking[first..end].contains(&true) {
                self.contacts.impulses[first..end].copy_from_slice(&self.found[first..end]);
            }
            first = end;
        }
    }
}
