//! Newmark's method with Newton iterations and a consistent tangent.
//!
//! Source: N. M. Newmark, *J. Engng Mech. Div. ASCE* 85 (1959) 67; Chopra, *Dynamics of Structures*, 5.4 and 5.7. The paper that this
//! project reproduces used this method with Δt = 0.005 s to check its results.

use crate::error::require;
use crate::implicit::equation::Slopes;
use crate::implicit::step::{Scratch, arrive, balance, begin, commit, load};
use crate::march::{ClockStep, Stepping, march};
use crate::model::ground::Ground;
use crate::span::{Load, Weights};
use crate::{Course, Excitation, Recorder, RestoringForce, Row, RunError, Work};

/// Settings of Newmark's method, which computes u and u̇ from the accelerations at both ends of a step.
///
/// Average acceleration is β = 1/4, γ = 1/2 ([`Newmark::AVERAGE_ACCELERATION`]); linear acceleration is β = 1/6, γ = 1/2
/// ([`Newmark::LINEAR_ACCELERATION`]). The method has order 2 if γ = 1/2, and order 1 otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Newmark {
    /// β \[–\], 0 ..= 1/2.
    pub beta: f64,
    /// γ \[–\], 1/2 ..= 1. A smaller γ would make vibrations grow.
    pub gamma: f64,
}

impl Newmark {
    /// Constant average acceleration, unconditionally stable for linear structures.
    pub const AVERAGE_ACCELERATION: Self = Self { beta: 0.25, gamma: 0.5 };
    /// Linear acceleration. It is stable for linear structures if Δt is less than 0.551 times the shortest period.
    pub const LINEAR_ACCELERATION: Self = Self {
        beta: 1.0 / 6.0,
        gamma: 0.5,
    };

    pub(crate) fn check(&self) -> Result<(), RunError> {
        require((0.0..=0.5).contains(&self.beta), "beta", self.beta, "0 to 0.5")?;
        require((0.5..=1.0).contains(&self.gamma), "gamma", self.gamma, "0.5 to 1")
    }
}

/// The coefficients of methods whose steps follow Newmark's formulas.
#[derive(Clone, Copy)]
pub(crate) struct Family {
    pub(crate) beta: f64,
    pub(crate) gamma: f64,
    /// α of the HHT method \[–\], ≤ 0. The equation weighs the forces at the start of the step by −α and those at the end by 1 + α.
    pub(crate) alpha: f64,
    /// Whether the accelerations at the end of a step satisfy the equation of motion there, also after a velocity jump.
    pub(crate) in_equilibrium: bool,
}

/// The state of a run by Newmark's or the HHT method.
pub(crate) struct NewmarkRun<Memory> {
    family: Family,
    slopes: Slopes,
    scratch: Scratch<Memory>,
    /// Loads at the start of the previous step. The accelerations depend on them only if α < 0.
    earlier: Vec<Option<Load>>,
}

/// Integrates a row. Every method has a `run` function with these arguments.
///
/// Each building first finds its equilibrium alone. Then the buildings whose compliant contacts overlap are solved again, together, as a
/// cluster. A cluster grows as long as it overlaps another neighbour. Buildings outside it do not change a bit of its result.
/// An impulsive law changes the velocities at the end of a step. It acts if the gap is closed there and the neighbours approach each other.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: Newmark,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    settings.check()?;
    let family = Family {
        beta: settings.beta,
        gamma: settings.gamma,
        alpha: 0.0,
        in_equilibrium: true,
    };
    family.run(row, excitation, course, recorder)
}

impl Family {
    /// Integrates a row.
    pub(crate) fn run<Column: RestoringForce, R: Recorder>(
        self,
        row: &Row<Column>,
        excitation: Excitation<'_>,
        course: Course,
        recorder: &mut R,
    ) -> Result<Work, RunError> {
        let dt = course.clock.time_step;
        let begin = |ground: Ground<'_>| NewmarkRun {
            family: self,
            // The equation is divided by 1+α. The forces at the end of the step then have weight 1.
            slopes: Slopes {
                displacement: self.beta * dt * dt,
                velocity: self.gamma * dt,
                inertia: 1.0 / (1.0 + self.alpha),
                time_step: dt,
            },
            scratch: begin(row, ground),
            earlier: vec![None; row.nodes().len()],
        };
        march(row, excitation, course, 1, begin, recorder)
    }

    /// Returns three weights: of the load one step earlier, of the load at the start of the step, and of the load at its end.
    ///
    /// The acceleration at the start of a step comes from the previous step: m ü is 1+α times the load at the start minus α times the load
    /// one step earlier. At t = 0 there is no earlier load, so m ü is the load itself.
    fn weights(&self, is_first: bool) -> [f64; 3] {
        let Self { gamma, alpha, .. } = self;
        let carried = if is_first { 0.0 } else { -alpha };
        [
            (1.0 - gamma) * carried,
            (1.0 - gamma) * (1.0 - carried) - gamma * alpha,
            gamma * (1.0 + alpha),
        ]
    }
}

impl<Column: RestoringForce> Stepping<Column> for NewmarkRun<Column::Memory> {
    fn tangent(&self, node: usize) -> f64 {
        self.scratch.trials[node].response.tangent
    }

    #[inline]
    fn step<R: Recorder>(&mut self, row: &Row<Column>, step: ClockStep<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError> {
        let (dt, at_ends) = (step.clock.time_step, step.ends());
        let family = self.family;
        self.predict(row, dt, at_ends[0]);
        let scratch = &mut self.scratch;
        balance(row, scratch, self.slopes, &step, work)?;
        arrive(scratch, &step)?;
        let (earlier, reads_weighed) = (&mut self.earlier, recorder.reads_weighed());
        commit(row, scratch, &step, recorder, |node, ends| {
            let load = |at: usize| {
                let ground = at_ends[at].under(node);
                load(reads_weighed, row, node, ends[at], ground)
            };
            let (start, end) = (load(0), load(1));
            let before = earlier[node].replace(start);
            let of_loads = family.weights(before.is_none());
            (Weights { scale: dt, of_loads }, [before.unwrap_or(start), start, end])
        });
        let Scratch { states, impacts, .. } = scratch;
        if step.collide(row, states, impacts, work, recorder)? && !family.in_equilibrium {
            self.change_accelerations(row);
        }
        Ok(())
    }
}

impl<Memory: Copy> NewmarkRun<Memory> {
    /// Computes the displacements and velocities at the end of a step for an acceleration of 0 there, and the part of the equation that
    /// comes from the start of the step.
    fn predict<Column: RestoringForce<Memory = Memory>>(&mut self, row: &Row<Column>, dt: f64, ground: Ground<'_>) {
        let Family { beta, gamma, alpha, .. } = self.family;
        // Damping that follows the tangent may have jumped.
        if row.has_tangent_damping() {
            for node in 0..row.nodes().len() {
                let acceleration = row.acceleration(node, &self.scratch.states, ground.under(node));
                self.scratch.states[node].acceleration = acceleration;
            }
        }
        let states = &self.scratch.states;
        for ((node, state), trial) in states.iter().enumerate().zip(&mut self.scratch.trials) {
            trial.predicted = (
                state.displacement + dt * (state.velocity + dt * (0.5 - beta) * state.acceleration),
                state.velocity + dt * (1.0 - gamma) * state.acceleration,
            );
            if alpha < 0.0 {
                let acceleration = row.acceleration(node, states, ground.under(node));
                trial.carried = alpha * self.slopes.inertia * acceleration;
            }
        }
    }

    /// After a velocity jump, adjusts each acceleration to the new damping force. The adjustment treats the velocities one step earlier as
    /// if they had jumped too.
    fn change_accelerations<Column: RestoringForce<Memory = Memory>>(&mut self, row: &Row<Column>) {
        let Scratch { states, trials, .. } = &mut self.scratch;
        for (index, (trial, earlier)) in trials.iter().zip(&mut self.earlier).enumerate() {
            let jump = |node: usize| states[node].velocity - trials[node].velocity;
            let change = row.damping_at(index, jump);
            let inverse_mass = row.nodes()[index].inverse_mass;
            states[index].acceleration = trial.acceleration - inverse_mass * change;
            if let Some(earlier) = earlier {
                earlier.damping += change;
            }
        }
    }
}
