//! Newmark's method with Newton iterations and a consistent tangent.
//!
//! Source: N. M. Newmark, *J. Engng Mech. Div. ASCE* 85 (1959) 67; Chopra, *Dynamics of Structures*, 5.4 and 5.7. The
//! paper compares itself with a result of this method at Δt = 0.005 s.

use crate::approach::speed;
use crate::error::require;
use crate::impacts::Impacts;
use crate::newton::{self, Failure, Slopes, Trial};
use crate::span::Load;
use crate::{Clock, Excitation, Recorder, RestoringForce, Row, RunError, Span, State, Work};

/// Settings of Newmark's method: u and u̇ follow from the accelerations at both ends of a step.
///
/// Average acceleration is β = 1/4, γ = 1/2 ([`Newmark::AVERAGE_ACCELERATION`]); linear acceleration is β = 1/6,
/// γ = 1/2 ([`Newmark::LINEAR_ACCELERATION`]). Order 2 for γ = 1/2, else 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Newmark {
    /// β \[–\], 0 ..= 1/2.
    pub beta: f64,
    /// γ \[–\], 1/2 ..= 1; below 1/2 the method amplifies.
    pub gamma: f64,
}

impl Newmark {
    /// Constant average acceleration, unconditionally stable for linear structures.
    pub const AVERAGE_ACCELERATION: Self = Self {
        beta: 0.25,
        gamma: 0.5,
    };
    /// Linear acceleration, stable for Δt < 0.551 T.
    pub const LINEAR_ACCELERATION: Self = Self {
        beta: 1.0 / 6.0,
        gamma: 0.5,
    };

    pub(crate) fn check(&self) -> Result<(), RunError> {
        require(
            (0.0..=0.5).contains(&self.beta),
            "beta",
            self.beta,
            "0 to 0.5",
        )?;
        require(
            (0.5..=1.0).contains(&self.gamma),
            "gamma",
            self.gamma,
            "0.5 to 1",
        )
    }
}

/// Scratch of an implicit run: everything a step needs, allocated once.
pub(crate) struct Scratch<Memory> {
    /// State at the start of the step, after impacts.
    pub(crate) states: Vec<State>,
    pub(crate) trials: Vec<Trial<Memory>>,
    /// Which pairs overlap during the step.
    touching: Vec<bool>,
    pub(crate) impacts: Impacts,
}

/// Integrates a row; the shared signature of all methods.
///
/// Each structure finds its equilibrium alone; those that then overlap do it again together. A cluster grows while it
/// overlaps further neighbours, and nothing outside a cluster changes its bits. Impulsive laws act at the end of the
/// step in which an overlap with approach is found, as a jump of the velocities.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: Newmark,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    clock: Clock,
    recorder: &mut R,
) -> Result<Work, RunError> {
    settings.check()?;
    let dt = clock.time_step;
    let ground = excitation.sampled(clock);
    let slopes = Slopes {
        displacement: settings.beta * dt * dt,
        velocity: settings.gamma * dt,
        inertia: 1.0,
        time_step: dt,
    };
    let mut scratch = begin(row, ground[0]);
    let mut work = Work::default();
    // The trapezoidal rule where γ = 1/2.
    let weights = (0.5 * dt, [2.0 - 2.0 * settings.gamma, 2.0 * settings.gamma]);
    for (step, at_ends) in (1..).zip(ground.windows(2)) {
        for (state, trial) in scratch.states.iter().zip(&mut scratch.trials) {
            trial.predicted = (
                state.displacement
                    + dt * (state.velocity + dt * (0.5 - settings.beta) * state.acceleration),
                state.velocity + dt * (1.0 - settings.gamma) * state.acceleration,
            );
        }
        let time = clock.time(step);
        balance(row, &mut scratch, (slopes, at_ends[1]), time, &mut work)?;
        commit(&mut scratch, (clock, step), recorder, |structure, ends| {
            let damping = row.nodes()[structure].damping;
            let load = |index: usize| {
                let state: &State = &ends[index];
                Load::at(
                    state,
                    (state.restoring_force, damping * state.velocity),
                    at_ends[index],
                )
            };
            (weights, [load(0), load(1)])
        })?;
        work.touching_steps += row.n_overlaps(&scratch.states);
        let instant = (at_ends[1], time);
        scratch
            .impacts
            .after_step(row, &mut scratch.states, instant, recorder);
        work.steps += 1;
    }
    Ok(work)
}

/// State of every structure at t = 0, accelerations from equilibrium.
pub(crate) fn begin<Column: RestoringForce>(
    row: &Row<Column>,
    ground: f64,
) -> Scratch<Column::Memory> {
    let mut trials = vec![Trial::new(); row.nodes().len()];
    let (states, memories) = row.initial(ground);
    for (trial, (state, memory)) in trials.iter_mut().zip(states.iter().zip(memories)) {
        trial.memory = memory;
        trial.acceleration = state.acceleration;
    }
    Scratch {
        states,
        trials,
        touching: vec![false; row.pairs().len()],
        impacts: Impacts::new(row),
    }
}

/// Equilibrium at the end of a step: every structure alone first, then the clusters that touch.
pub(crate) fn balance<Column: RestoringForce>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
    (slopes, ground): (Slopes, f64),
    time: f64,
    work: &mut Work,
) -> Result<(), RunError> {
    let mut solve = |trials: &mut [Trial<Column::Memory>], first, last| {
        newton::solve(row, trials, (first, last), (slopes, ground), work).map_err(|failure| {
            match failure {
                Failure::NotFinite { structure } => RunError::Diverged {
                    structure,
                    time,
                    time_step: slopes.time_step,
                },
                Failure::NotConverged {
                    iterations,
                    residual,
                } => RunError::NotConverged {
                    first,
                    last,
                    time,
                    iterations,
                    residual,
                    allowed: newton::TOLERANCE,
                },
            }
        })
    };
    for index in 0..scratch.trials.len() {
        solve(&mut scratch.trials, index, index)?;
    }
    for pair in row.pairs() {
        if pair.deformation(&scratch.states) <= 0.0 {
            scratch.trials[pair.left].approach_speed = None;
        }
    }
    scratch.touching.fill(false);
    while mark_overlaps(row, &mut scratch.trials, &mut scratch.touching) {
        let mut pair = 0;
        while pair < row.pairs().len() {
            if !scratch.touching[pair] {
                pair += 1;
                continue;
            }
            let first = row.pairs()[pair].left;
            let mut last = row.pairs()[pair].right;
            pair += 1;
            while pair < row.pairs().len()
                && scratch.touching[pair]
                && row.pairs()[pair].left == last
            {
                last = row.pairs()[pair].right;
                pair += 1;
            }
            solve(&mut scratch.trials, first, last)?;
        }
    }
    Ok(())
}

/// Marks the compliant pairs that overlap and were not marked yet; true when there are any.
///
/// Those that touch first approach as they do without each other's force.
fn mark_overlaps<Column: RestoringForce>(
    row: &Row<Column>,
    trials: &mut [Trial<Column::Memory>],
    touching: &mut [bool],
) -> bool {
    let mut grown = false;
    for (pair, touching) in row.pairs().iter().zip(touching) {
        let deformation =
            trials[pair.left].displacement - trials[pair.right].displacement - pair.gap;
        if pair.law.is_compliant() && !*touching && deformation > 0.0 {
            let rate = trials[pair.left].velocity - trials[pair.right].velocity;
            speed(&mut trials[pair.left].approach_speed, rate);
            *touching = true;
            grown = true;
        }
    }
    grown
}

/// Accepts the end of a step and reports its spans; of each structure with these ends, what the method made of which
/// loads.
pub(crate) fn commit<Memory: Copy, R: Recorder, const N: usize>(
    scratch: &mut Scratch<Memory>,
    (clock, step): (Clock, usize),
    recorder: &mut R,
    mut weighed: impl FnMut(usize, &[State; 2]) -> ((f64, [f64; N]), [Load; N]),
) -> Result<(), RunError> {
    let times = (clock.time(step - 1), clock.time(step));
    for (structure, (state, trial)) in scratch
        .states
        .iter_mut()
        .zip(&mut scratch.trials)
        .enumerate()
    {
        let end = trial.state();
        if !end.displacement.is_finite() {
            return Err(RunError::Diverged {
                structure,
                time: times.1,
                time_step: clock.time_step,
            });
        }
        let ends = [*state, end];
        let (weights, loads) = weighed(structure, &ends);
        recorder.span(&Span::step::<R, N>(structure, times, ends, weights, loads));
        *state = end;
        trial.memory = trial.response.memory;
    }
    Ok(())
}
