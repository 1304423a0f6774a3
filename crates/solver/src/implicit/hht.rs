//! HHT-α method (Hilber, Hughes and Taylor) with Newton iterations and a consistent tangent.
//!
//! Source: H. M. Hilber, T. J. R. Hughes & R. L. Taylor, *Earthquake Engng Struct. Dyn.* 5 (1977) 283. Newmark's
//! formulas with β = (1−α)²/4 and γ = 1/2 − α, and an equation that weighs all forces but inertia over both ends of the
//! step: m ü⁺ + (1+α) r⁺ − α r = 0, r = c u̇ + `f_s` + m `a_g` − F. Pounding forces of compliant pairs are among
//! them.
//!
//! Its accelerations so are not in equilibrium with the other forces at a node. Where the velocity jumps they change by
//! what the damping force does, as if the velocity a step ago had jumped as well; restarting them from equilibrium would
//! give the two structures of a compliant pair different impulses when one of them is hit by its other neighbour.

use crate::error::require;
use crate::implicit::equation::Slopes;
use crate::implicit::newmark::{arrive, balance, begin, commit, load};
use crate::span::Load;
use crate::{Course, Excitation, Recorder, RestoringForce, Row, RunError, Work};

/// Settings of the HHT-α method: it damps what the time step cannot follow. Order 2, no critical time step.
///
/// Impulsive laws act after a step, as a jump of the velocities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hht {
    /// α \[–\], −1/3 (most damping) ..= 0 (none: Newmark's average acceleration).
    pub alpha: f64,
}

impl Hht {
    pub(crate) fn check(self) -> Result<(), RunError> {
        let valid = (-1.0 / 3.0..=0.0).contains(&self.alpha);
        require(valid, "alpha", self.alpha, "-1/3 to 0")
    }
}

/// Integrates a row; the shared signature of all methods. Clusters form as in Newmark's method.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: Hht,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    settings.check()?;
    let (clock, alpha) = (course.clock, settings.alpha);
    let (dt, gamma) = (clock.time_step, 0.5 - alpha);
    let beta = 0.25 * (1.0 - alpha) * (1.0 - alpha);
    let guard = course.begin(row.nodes().len());
    let shaking = row.shaken(excitation, clock);
    // Divided by 1+α, so that Newton sees the forces at the end of the step as they are.
    let slopes = Slopes {
        displacement: beta * dt * dt,
        velocity: gamma * dt,
        inertia: 1.0 / (1.0 + alpha),
        time_step: dt,
    };
    let mut scratch = begin(row, shaking.at(0));
    // What acted a step ago: the acceleration carries it.
    let mut earlier: Vec<Option<Load>> = vec![None; row.nodes().len()];
    let mut work = Work::default();
    for step in 1..=clock.n_steps {
        guard.step(step, clock)?;
        let at_ends = [step - 1, step].map(|node| shaking.at(node));
        let states = &scratch.states;
        for ((node, state), trial) in states.iter().enumerate().zip(&mut scratch.trials) {
            trial.predicted = (
                state.displacement + dt * (state.velocity + dt * (0.5 - beta) * state.acceleration),
                state.velocity + dt * (1.0 - gamma) * state.acceleration,
            );
            trial.carried =
                alpha * slopes.inertia * row.acceleration(node, states, at_ends[0].under(node));
        }
        let time = clock.time(step);
        balance(row, &mut scratch, slopes, at_ends, time, &mut work)?;
        arrive(&mut scratch, clock, step)?;
        commit(row, &mut scratch, clock, step, recorder, |node, ends| {
            let load = |at: usize| load::<_, R>(row, node, ends[at], at_ends[at].under(node));
            let (start, end) = (load(0), load(1));
            // m ü at the start is (1+α) times its own load less α times the one before; at t = 0 its own.
            let before = earlier[node].replace(start);
            let carried = if before.is_some() { -alpha } else { 0.0 };
            let weights = [
                (1.0 - gamma) * carried,
                (1.0 - gamma) * (1.0 - carried) - gamma * alpha,
                gamma * (1.0 + alpha),
            ];
            ((dt, weights), [before.unwrap_or(start), start, end])
        });
        work.touching_steps += row.n_overlaps(&scratch.states, at_ends[1]);
        let (states, instant) = (&mut scratch.states, (at_ends[1], time));
        if scratch.impacts.after_step(row, states, instant, recorder)? {
            let trials = &scratch.trials;
            for (index, (trial, earlier)) in trials.iter().zip(&mut earlier).enumerate() {
                let jump = |node: usize| states[node].velocity - trials[node].velocity;
                let change = row.damping_at(index, jump);
                let inverse_mass = row.nodes()[index].inverse_mass;
                states[index].acceleration = trial.acceleration - inverse_mass * change;
                if let Some(earlier) = earlier {
                    earlier.damping += change;
                }
            }
        }
        work.steps += 1;
    }
    Ok(work)
}
