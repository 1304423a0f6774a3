//! The classical Runge–Kutta method of order four on displacements and velocities.
//!
//! Source: W. Kutta, *Z. Math. Phys.* 46 (1901) 435; Hairer, Nørsett & Wanner, *Solving Ordinary Differential
//! Equations I*, II.1.
//!
//! Compliant pairs push in every stage with the rate of deformation of that stage. In every stage the columns respond from their memory at
//! the start of the step. The memory changes only at the end of the step: yielding columns lower the order of the method. The ground
//! acceleration in the middle of a step is taken from the record.

use crate::impact::impacts::Impacts;
use crate::link_forces::LinkForces;
use crate::march::{ClockStep, Stepping, march};
use crate::model::approach::Approaches;
use crate::model::ground::Ground;
use crate::pushes::Pushes;
use crate::span::{Load, StoreyForces, Weights};
use crate::{Course, Excitation, Recorder, RestoringForce, Row, RunError, Span, State, Work};

/// Settings of the classical Runge–Kutta method (none). Order 4 while nothing touches or yields.
///
/// Impulsive laws act after a step, as a jump of the velocities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rk4;

impl Rk4 {
    /// Largest stable time step \[s\] for a linear structure of circular frequency ω \[rad/s\] and damping ratio ζ ≥ 0.
    ///
    /// It is 2√2/ω without damping, and 2.785/λ for an overdamped structure with the fastest decay rate λ \[1/s\].
    pub fn critical_time_step(angular_frequency: f64, damping_ratio: f64) -> f64 {
        // Slow and fast decay of an overdamped structure lie on the negative real axis; the fast one limits.
        let (real, imaginary, radius) = if damping_ratio < 1.0 {
            let imaginary = (1.0 - damping_ratio * damping_ratio).sqrt();
            (-damping_ratio, imaginary, 1.0)
        } else {
            let fast = damping_ratio + (damping_ratio * damping_ratio - 1.0).sqrt();
            (-1.0, 0.0, fast)
        };
        let grows = |r: f64| growth(r * real, r * imaginary) > 1.0;
        // The method is stable at 2 and unstable at 4 in every direction of the left half-plane.
        let (mut stable, mut unstable) = (2.0, 4.0);
        for _ in 0..60 {
            let middle = 0.5 * (stable + unstable);
            if grows(middle) {
                unstable = middle;
            } else {
                stable = middle;
            }
        }
        stable / (angular_frequency * radius)
    }
}

/// |1 + z + z²/2 + z³/6 + z⁴/24|²: growth per step of the method's solution of ẏ = λy, z = λΔt.
fn growth(x: f64, y: f64) -> f64 {
    let (mut real, mut imaginary) = (1.0, 0.0);
    for divisor in [4.0, 3.0, 2.0, 1.0] {
        (real, imaginary) = (1.0 + (real * x - imaginary * y) / divisor, (real * y + imaginary * x) / divisor);
    }
    real * real + imaginary * imaginary
}

/// Weights of the four stages, in sixths of a step.
const WEIGHTS: [f64; 4] = [1.0, 2.0, 2.0, 1.0];

/// Scratch of a run.
struct Scratch<Memory> {
    /// States at the start of the step, after impacts.
    states: Vec<State>,
    memories: Vec<Memory>,
    /// Tangent stiffnesses at the end of the last step \[N/m\].
    tangents: Vec<f64>,
    /// States of the present stage.
    stages: Vec<State>,
    /// Weighted sums of velocities and accelerations over the stages.
    slopes: Vec<(f64, f64)>,
    /// Loads on each structure in the stages.
    loads: Vec<[Load; 4]>,
    pushes: Pushes,
    approaches: Approaches,
    impacts: Impacts,
    /// `None` if the row has no links.
    links: Option<LinkForces>,
}

/// Integrates a row. Every method has a `run` function with these arguments.
pub(crate) fn run<Column: RestoringForce, R: Recorder>(
    _: Rk4,
    row: &Row<Column>,
    excitation: Excitation<'_>,
    course: Course,
    recorder: &mut R,
) -> Result<Work, RunError> {
    let begin = |ground: Ground<'_>| Scratch::new(row, ground);
    march(row, excitation, course, 1, begin, recorder)
}

impl<Column: RestoringForce> Stepping<Column> for Scratch<Column::Memory> {
    const PARTS: usize = 2;

    fn tangent(&self, node: usize) -> f64 {
        self.tangents[node]
    }

    #[inline]
    fn step<R: Recorder>(&mut self, row: &Row<Column>, step: ClockStep<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError> {
        self.advance(row, step.parts(), step.clock.time_step);
        self.finish(row, step, recorder)?;
        step.collide(row, &mut self.states, &mut self.impacts, work, recorder)?;
        work.force_evaluations += 4 * row.nodes().len() as u64;
        Ok(())
    }
}

impl<Memory: Copy> Scratch<Memory> {
    fn new<Column: RestoringForce<Memory = Memory>>(row: &Row<Column>, ground: Ground<'_>) -> Self {
        let (states, memories) = row.initial(ground);
        let nothing = Load::at(&State::default(), StoreyForces::default(), 0.0);
        Self {
            tangents: vec![f64::INFINITY; states.len()],
            stages: states.clone(),
            slopes: vec![(0.0, 0.0); states.len()],
            loads: vec![[nothing; 4]; states.len()],
            pushes: Pushes::new(row.incidence()),
            approaches: Approaches::new(row.pairs().len()),
            impacts: Impacts::new(row),
            links: LinkForces::of(row, &states, ground),
            states,
            memories,
        }
    }

    /// The four stages, under the ground acceleration at the start, middle and end of the step. The first stage is the state at the start.
    fn advance<Column: RestoringForce<Memory = Memory>>(&mut self, row: &Row<Column>, ground: [Ground<'_>; 3], dt: f64) {
        self.stages.copy_from_slice(&self.states);
        self.slopes.fill((0.0, 0.0));
        self.pushes.pass();
        self.pushes.begin();
        if let Some(links) = &mut self.links {
            links.pull(row, |node| (&self.stages[node]).into(), ground[0], 0.0, false);
            links.pushes.pass();
            links.pushes.begin();
        }
        self.weigh_stage(row, 0, ground[0]);
        for (stage, ahead, ground) in [(1, 0.5 * dt, ground[1]), (2, 0.5 * dt, ground[1]), (3, dt, ground[2])] {
            for (stage, state) in self.stages.iter_mut().zip(&self.states) {
                stage.displacement = state.displacement + ahead * stage.velocity;
                stage.velocity = state.velocity + ahead * stage.acceleration;
            }
            self.push(row, ground);
            if let Some(links) = &mut self.links {
                links.pull(row, |node| (&self.stages[node]).into(), ground, ahead, false);
            }
            for (index, (node, memory)) in row.nodes().iter().zip(&self.memories).enumerate() {
                // The memory of the columns after a stage is discarded.
                let drift = row.drift(index, &self.stages);
                self.stages[index].restoring_force = node.column.respond(drift, *memory).force;
            }
            self.weigh_stage(row, stage, ground);
        }
    }

    /// Computes the pounding forces of the present stage.
    fn push<Column: RestoringForce>(&mut self, row: &Row<Column>, ground: Ground<'_>) {
        let (pushes, approaches) = (&mut self.pushes, &mut self.approaches);
        row.push(&mut self.stages, pushes, approaches, ground);
    }

    /// Computes the accelerations of a stage from equilibrium, adds its slopes and keeps its loads.
    fn weigh_stage<Column: RestoringForce>(&mut self, row: &Row<Column>, index: usize, ground: Ground<'_>) {
        self.pushes.add(WEIGHTS[index]);
        if let Some(links) = &mut self.links {
            links.pushes.add(WEIGHTS[index]);
        }
        for (node, (slopes, loads)) in self.slopes.iter_mut().zip(&mut self.loads).enumerate() {
            let mut load = row.load(node, &self.stages, ground.under(node));
            load.links = self.links.as_ref().map_or(0.0, |links| links.on(node));
            let stage = &mut self.stages[node];
            stage.acceleration = row.acceleration_under(node, &load);
            slopes.0 += WEIGHTS[index] * stage.velocity;
            slopes.1 += WEIGHTS[index] * stage.acceleration;
            loads[index] = load;
        }
    }

    /// Accepts the end of the step, in equilibrium, and reports its spans.
    fn finish<Column: RestoringForce<Memory = Memory>, R: Recorder>(
        &mut self,
        row: &Row<Column>,
        step: ClockStep<'_>,
        recorder: &mut R,
    ) -> Result<(), RunError> {
        let (times, [_, _, ground]) = (step.times(), step.parts());
        let sixth = step.clock.time_step / 6.0;
        let bodies = self.stages.iter_mut().zip(&self.states);
        for ((end, start), slopes) in bodies.zip(&self.slopes) {
            end.displacement = start.displacement + sixth * slopes.0;
            end.velocity = start.velocity + sixth * slopes.1;
        }
        self.pushes.scale(sixth);
        self.push(row, ground);
        if let Some(links) = &mut self.links {
            links.pushes.scale(sixth);
            links.pull(row, |node| (&self.stages[node]).into(), ground, step.clock.time_step, true);
        }
        self.approaches.forget_parted(row.pairs(), &self.stages, ground);
        for (structure, node) in row.nodes().iter().enumerate() {
            if !self.stages[structure].displacement.is_finite() {
                return Err(step.diverged(structure));
            }
            let drift = row.drift(structure, &self.stages);
            let response = node.column.respond(drift, self.memories[structure]);
            self.stages[structure].restoring_force = response.force;
            (self.memories[structure], self.tangents[structure]) = (response.memory, response.tangent);
        }
        for node in 0..self.stages.len() {
            let mut load = row.load(node, &self.stages, ground.under(node));
            load.links = self.links.as_ref().map_or(0.0, |links| links.on(node));
            self.stages[node].acceleration = row.acceleration_under(node, &load);
        }
        let (starts, ends) = (&self.states, &self.stages);
        for (structure, (start, end)) in starts.iter().zip(ends).enumerate() {
            let weights = Weights {
                scale: sixth,
                of_loads: WEIGHTS,
            };
            let loads = self.loads[structure];
            let mut span = Span::step(recorder.reads_weighed(), structure, times, [*start, *end], weights, loads);
            span.below = row.below(structure, [starts, ends]);
            span.pushes = self.pushes.of(row.incidence().slots_at(structure));
            if let Some(links) = &self.links {
                span.links = links.pushes.of(row.linking().slots_at(structure));
            }
            recorder.span(&span);
        }
        self.states.copy_from_slice(&self.stages);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_limits_of_stability() {
        let limit = |ratio| Rk4::critical_time_step(2.0, ratio) * 2.0;
        assert!((limit(0.0) - 8.0_f64.sqrt()).abs() < 1e-12, "{}", limit(0.0));
        // The real root of 1 + z/2 + z²/6 + z³/24 = 0.
        let real = 2.785_293_563_405_282;
        assert!((limit(1.0) - real).abs() < 1e-12, "{}", limit(1.0));
        let fast = 3.0 + 8.0_f64.sqrt();
        assert!((limit(3.0) * fast - real).abs() < 1e-12, "{}", limit(3.0));
    }

    #[test]
    fn limit_every_smaller_step_is_stable() {
        for direction in 0..=90 {
            let angle = f64::from(direction).to_radians();
            let ratio = libm::sin(angle);
            let limit = Rk4::critical_time_step(1.0, ratio);
            for part in 1..1000 {
                let r = limit * f64::from(part) / 1000.0;
                let growth = growth(-r * ratio, r * libm::cos(angle));
                assert!(growth <= 1.0 + 1e-15, "{direction}°, {part}: {growth}");
            }
        }
    }
}
