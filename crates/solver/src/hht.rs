//! HHT-α method (Hilber, Hughes and Taylor) with Newton iterations and a consistent tangent.
//!
//! Source: H. M. Hilber, T. J. R. Hughes & R. L. Taylor, *Earthquake Engng Struct. Dyn.* 5 (1977) 283. Newmark's
//! formulas with β = (1−α)²/4 and γ = 1/2 − α, and an equation that weighs all forces but inertia over both ends of the
//! step: m ü⁺ + (1+α) r⁺ − α r = 0, r = c u̇ + `f_s` + m `a_g` − F. Pounding forces of compliant pairs are among
//! them.
//!
//! Its accelerations so are not in equilibrium with the other forces at a node. Where the velocity jumps, the
//! acceleration restarts from equilibrium, as at t = 0.

use crate::error::require;
use crate::newmark::{balance, begin, commit};
use crate::newton::Slopes;
use crate::{Clock, Excitation, Recorder, RestoringForce, Row, RunError, Work};

/// Settings of the HHT-α method: it damps what the time step cannot follow. Order 2, no critical time step.
///
/// Impulsive laws act after a step, as a jump of the velocities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hht {
    /// α \[–\], −1/3 (most damping) ..= 0 (none: Newmark's average acceleration).
    pub alpha: f64,
}

impl Hht {
    fn check(self) -> Result<(), RunError> {
        let valid = (-1.0 / 3.0..=0.0).contains(&self.alpha);
        require(valid, "alpha", self.alpha, "-1/3 to 0")
    }
}

/// Integrates a row; the shared signature of all methods. Clusters form as in Newmark's method.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    settings: Hht,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    clock: Clock,
    recorder: &mut R,
) -> Result<Work, RunError> {
    settings.check()?;
    let (dt, alpha) = (clock.time_step, settings.alpha);
    let beta = 0.25 * (1.0 - alpha) * (1.0 - alpha);
    let gamma = 0.5 - alpha;
    let ground = excitation.sampled(clock);
    // Divided by 1+α, so that Newton sees the forces at the end of the step as they are.
    let slopes = Slopes {
        displacement: beta * dt * dt,
        velocity: gamma * dt,
        inertia: 1.0 / (1.0 + alpha),
        time_step: dt,
    };
    let mut scratch = begin(row, ground[0]);
    let mut work = Work::default();
    for (step, ends) in (1..).zip(ground.windows(2)) {
        let nodes = row.nodes().iter().zip(&scratch.states);
        for ((node, state), trial) in nodes.zip(&mut scratch.trials) {
            trial.predicted = (
                state.displacement + dt * (state.velocity + dt * (0.5 - beta) * state.acceleration),
                state.velocity + dt * (1.0 - gamma) * state.acceleration,
            );
            trial.carried = alpha * slopes.inertia * node.acceleration(state, ends[0]);
        }
        let time = clock.time(step);
        balance(row, &mut scratch, (slopes, ends[1]), time, &mut work)?;
        commit(&mut scratch, clock, step, recorder)?;
        work.touching_steps += row.n_overlaps(&scratch.states);
        let instant = (ends[1], time);
        scratch
            .impacts
            .after_step(row, &mut scratch.states, instant, recorder);
        work.steps += 1;
    }
    Ok(work)
}
