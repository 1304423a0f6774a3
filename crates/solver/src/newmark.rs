//! Newmark's method with Newton iterations and a consistent tangent.
//!
//! Source: N. M. Newmark, *J. Engng Mech. Div. ASCE* 85 (1959) 67; Chopra, *Dynamics of Structures*, 5.4 and 5.7. The
//! paper compares itself with a result of this method at Δt = 0.005 s.

use pounding_contact::ContactLaw;

use crate::newton::{self, Failure, Slopes, Trial};
use crate::span::Load;
use crate::{
    Clock, Excitation, Impact, Recorder, RestoringForce, Row, RunError, Span, State, Velocities,
    Work,
};

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

    fn check(&self) -> Result<(), RunError> {
        let require = |valid: bool, setting, found, allowed| {
            if valid {
                Ok(())
            } else {
                Err(RunError::Setting {
                    setting,
                    found,
                    allowed,
                })
            }
        };
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

/// Scratch of a run: everything a step needs, allocated once.
struct Scratch<Memory> {
    /// State at the start of the step, after impacts.
    states: Vec<State>,
    trials: Vec<Trial<Memory>>,
    /// Which pairs overlap during the step.
    touching: Vec<bool>,
    /// Impulse of every pair at the end of the step \[N·s\].
    impulses: Vec<f64>,
}

/// Integrates a row; the shared signature of all methods.
///
/// Each structure finds its equilibrium alone; those that then overlap do it again together. A cluster grows while it
/// overlaps further neighbours, and nothing outside a cluster changes its bits. Impulsive laws act at the end of the
/// step in which an overlap with approach is found, as a jump of the velocities, each pair alone.
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
        time_step: dt,
    };
    let mut scratch = begin(row, ground[0]);
    let mut work = Work::default();
    for step in 1..ground.len() {
        let at_ends = [ground[step - 1], ground[step]];
        for (state, trial) in scratch.states.iter().zip(&mut scratch.trials) {
            trial.predicted = (
                state.displacement
                    + dt * (state.velocity + dt * (0.5 - settings.beta) * state.acceleration),
                state.velocity + dt * (1.0 - settings.gamma) * state.acceleration,
            );
        }
        balance(
            row,
            &mut scratch,
            (slopes, ground[step]),
            clock.time(step),
            &mut work,
        )?;
        commit(
            row,
            &mut scratch,
            (clock, step),
            (settings.gamma, at_ends),
            recorder,
        )?;
        work.touching_steps += overlaps(row, &scratch.states);
        jump(
            row,
            &mut scratch,
            (ground[step], clock.time(step)),
            recorder,
        );
        work.steps += 1;
    }
    Ok(work)
}

/// State of every structure at t = 0, accelerations from equilibrium.
fn begin<Column: RestoringForce>(row: &Row<Column>, ground: f64) -> Scratch<Column::Memory> {
    let mut trials = vec![Trial::new(); row.nodes().len()];
    let state = |(node, trial): (&crate::Node<Column>, &mut Trial<Column::Memory>)| {
        let (u, v) = (node.initial_displacement, node.initial_velocity);
        let response = node.column.respond(u, Column::Memory::default());
        trial.memory = response.memory;
        let ground = if node.is_wall() { 0.0 } else { ground };
        let acceleration = -ground - node.inverse_mass * (node.damping * v + response.force);
        trial.acceleration = acceleration;
        State {
            displacement: u,
            velocity: v,
            acceleration,
            restoring_force: response.force,
            ..State::default()
        }
    };
    let states = row.nodes().iter().zip(&mut trials).map(state).collect();
    Scratch {
        states,
        trials,
        touching: vec![false; row.pairs().len()],
        impulses: vec![0.0; row.pairs().len()],
    }
}

/// Equilibrium at the end of a step: every structure alone first, then the clusters that touch.
fn balance<Column: RestoringForce>(
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
    scratch.touching.fill(false);
    while mark_overlaps(row, &scratch.trials, &mut scratch.touching) {
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
fn mark_overlaps<Column: RestoringForce>(
    row: &Row<Column>,
    trials: &[Trial<Column::Memory>],
    touching: &mut [bool],
) -> bool {
    let mut grown = false;
    for (pair, touching) in row.pairs().iter().zip(touching) {
        let compliant = match pair.law {
            ContactLaw::NonlinearViscoelastic(_) => true,
            ContactLaw::Stereomechanical(_) => false,
        };
        let deformation =
            trials[pair.left].displacement - trials[pair.right].displacement - pair.gap;
        if compliant && !*touching && deformation > 0.0 {
            *touching = true;
            grown = true;
        }
    }
    grown
}

/// Accepts the end of a step and reports its spans.
fn commit<Column: RestoringForce, R: Recorder>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
    (clock, step): (Clock, usize),
    (gamma, ground): (f64, [f64; 2]),
    recorder: &mut R,
) -> Result<(), RunError> {
    let (start_time, end_time) = (clock.time(step - 1), clock.time(step));
    // The trapezoidal rule where γ = 1/2.
    let weights = [2.0 - 2.0 * gamma, 2.0 * gamma];
    for (structure, (state, trial)) in scratch
        .states
        .iter_mut()
        .zip(&mut scratch.trials)
        .enumerate()
    {
        let end = State {
            displacement: trial.displacement,
            velocity: trial.velocity,
            acceleration: trial.acceleration,
            restoring_force: trial.response.force,
            force_from_left: trial.force_from_left,
            force_from_right: trial.force_from_right,
        };
        if !end.displacement.is_finite() {
            return Err(RunError::Diverged {
                structure,
                time: end_time,
                time_step: clock.time_step,
            });
        }
        let damping = row.nodes()[structure].damping;
        let ends = [*state, end];
        let load = |index: usize| {
            let state: &State = &ends[index];
            Load::at(state, damping * state.velocity, ground[index])
        };
        recorder.span(&Span::step::<R, _>(
            structure,
            (start_time, end_time),
            ends,
            (0.5 * clock.time_step, weights),
            [load(0), load(1)],
        ));
        *state = end;
        trial.memory = trial.response.memory;
    }
    Ok(())
}

/// Number of pairs that overlap.
fn overlaps<Column: RestoringForce>(row: &Row<Column>, states: &[State]) -> u64 {
    let overlaps = |pair: &&crate::Pair| {
        states[pair.left].displacement - states[pair.right].displacement - pair.gap > 0.0
    };
    row.pairs().iter().filter(overlaps).count() as u64
}

/// Impulsive contact at the end of a step: velocities jump, then accelerations follow from equilibrium.
fn jump<Column: RestoringForce, R: Recorder>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
    (ground, time): (f64, f64),
    recorder: &mut R,
) {
    if !collide(row, scratch) {
        return;
    }
    // Until the next step the trials keep the velocities before the jump.
    let Scratch {
        states,
        trials,
        impulses,
        ..
    } = scratch;
    for (index, (pair, &impulse)) in row.pairs().iter().zip(&*impulses).enumerate() {
        if impulse > 0.0 {
            let (left, right) = (pair.left, pair.right);
            recorder.impact(&Impact {
                pair: index,
                left,
                right,
                time,
                impulse,
                before: Velocities {
                    left: trials[left].velocity,
                    right: trials[right].velocity,
                },
                after: Velocities {
                    left: states[left].velocity,
                    right: states[right].velocity,
                },
            });
        }
    }
    for ((node, state), trial) in row.nodes().iter().zip(states).zip(trials) {
        let jumped = (state.velocity - trial.velocity).abs() > 0.0;
        if jumped {
            let ground = if node.is_wall() { 0.0 } else { ground };
            let force =
                state.pounding_force() - node.damping * state.velocity - state.restoring_force;
            state.acceleration = node.inverse_mass * force - ground;
        }
    }
}

/// Gives every overlapping pair that approaches its impulse, each alone; true when there was one.
fn collide<Column: RestoringForce>(
    row: &Row<Column>,
    scratch: &mut Scratch<Column::Memory>,
) -> bool {
    let mut hit = false;
    for (pair, impulse) in row.pairs().iter().zip(&mut scratch.impulses) {
        *impulse = 0.0;
        let law = match pair.law {
            ContactLaw::Stereomechanical(law) => law,
            // Compliant contact took part in the equilibrium.
            ContactLaw::NonlinearViscoelastic(_) => continue,
        };
        let (left, right) = (&scratch.trials[pair.left], &scratch.trials[pair.right]);
        let rate = left.velocity - right.velocity;
        if left.displacement - right.displacement - pair.gap > 0.0 && rate > 0.0 {
            *impulse = law.impulse(rate, row.reduced_mass(pair));
            scratch.states[pair.left].velocity -= row.nodes()[pair.left].inverse_mass * *impulse;
            scratch.states[pair.right].velocity += row.nodes()[pair.right].inverse_mass * *impulse;
            hit = true;
        }
    }
    hit
}
