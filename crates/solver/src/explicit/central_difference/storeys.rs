//! The equations of a node of the run, in a row with floors on floors.
//!
//! `building.rs` solves the equations. The rest is done from the top down in a second pass: it carries values from the floor above, and the
//! floor below has not advanced yet.

use super::building::{FloorCoefficients, Floors, solve};
use super::{Body, CentralDifferenceRun, Instant};
use crate::link_forces::LinkForces;
use crate::model::dashpots::Dashpots;
use crate::pushes::Pushes;
use crate::span::{Load, StoreyForces, Weights};
use crate::{Motion, Recorder, RestoringForce, Row, RunError, Span, State, Work};

/// Data that only rows with floors on floors need, building by building.
pub(super) struct Storeys {
    /// Constants for whole steps and sub-steps.
    coefficients: [Vec<FloorCoefficients>; 2],
    solutions: Vec<Solution>,
    /// Shares a corrected velocity among the floors of a building.
    dashpots: Dashpots,
}

/// Result of the equation of a floor at a node.
#[derive(Clone, Copy, Default)]
struct Solution {
    /// The next increment \[m\].
    increment: f64,
    /// Central-difference velocity, before a jump \[m/s\].
    velocity: f64,
    /// Acceleration without damping; with damping where velocity was corrected \[m/s²\].
    acceleration: f64,
    /// Force of the storey below the floor \[N\].
    restoring_force: f64,
}

impl Storeys {
    /// Returns `None` for a row of structures of one storey.
    pub(super) fn of<Column: RestoringForce>(row: &Row<Column>, steps: [f64; 2]) -> Option<Self> {
        if row.buildings().are_single() {
            return None;
        }
        Some(Self {
            coefficients: steps.map(|dt| FloorCoefficients::of(row, dt)),
            solutions: vec![Solution::default(); row.nodes().len()],
            dashpots: Dashpots::new(row),
        })
    }
}

impl<Column: RestoringForce> CentralDifferenceRun<'_, Column> {
    /// Solves the equations of a node, building by building, and reports the spans that end there.
    #[inline(never)] // The loop over structures of one storey would otherwise share its registers.
    pub(super) fn advance_storeys<R: Recorder>(&mut self, node: Instant<'_>, work: &mut Work, recorder: &mut R) -> Result<(), RunError> {
        let divides = self.steps[1] < self.steps[0];
        let Some(storeys) = &mut self.storeys else {
            return Ok(());
        };
        for range in self.row.buildings().ranges() {
            let floors = &self.row.buildings().all()[range.clone()];
            let fine = self.bodies[floors[0]].fine;
            if node.fine && !fine {
                continue;
            }
            let coefficients = &storeys.coefficients[usize::from(fine)][range.clone()];
            let mut building = Building {
                row: self.row,
                floors,
                bodies: &mut self.bodies,
                coefficients,
                solutions: &mut storeys.solutions[range.clone()],
                pushes: &mut self.pushes,
                links: self.links.as_mut(),
                is_finite: true,
            };
            // All floors of a building stand on one ground.
            let ground = node.ground.under(floors[0]);
            solve(&mut building, coefficients, ground);
            if let Some(structure) = building.diverged() {
                return Err(RunError::Diverged {
                    structure,
                    time: node.next,
                    time_step: self.steps[0],
                });
            }
            let met_late = divides && !fine && building.met_late();
            if met_late {
                building.excess(&mut storeys.dashpots.values[range.clone()]);
                building.give_back(storeys.dashpots.solve(range, self.steps[0]));
            }
            building.go_on(node.time, ground, met_late, recorder);
            work.force_evaluations += floors.len() as u64;
        }
        Ok(())
    }
}

/// A building at a node. Arrays of its floors begin at the ground.
struct Building<'a, Column: RestoringForce> {
    row: &'a Row<Column>,
    /// Nodes of the floors.
    floors: &'a [usize],
    /// Bodies of the whole row.
    bodies: &'a mut [Body<Column::Memory>],
    coefficients: &'a [FloorCoefficients],
    solutions: &'a mut [Solution],
    /// Pushes of the whole row.
    pushes: &'a mut Pushes,
    links: Option<&'a mut LinkForces>,
    /// Whether all next displacements are finite numbers.
    is_finite: bool,
}

/// Values carried down from the floor above; all 0 above the top floor.
#[derive(Default)]
struct Above {
    /// Velocity at the end of the span \[m/s\].
    velocity: f64,
    /// Forces of its columns and its dashpot at the start and at the end of the span.
    forces: [StoreyForces; 2],
}

/// The end of the span of a floor.
#[derive(Clone, Copy)]
struct SpanEnd {
    state: State,
    /// Velocity of the floor below \[m/s\].
    below_velocity: f64,
    /// Time \[s\].
    time: f64,
    /// Acceleration of the ground \[m/s²\].
    ground: f64,
}

impl<Column: RestoringForce> Floors<f64> for Building<'_, Column> {
    #[inline]
    fn motion(&self, level: usize) -> [f64; 2] {
        let body = &self.bodies[self.floors[level]];
        [body.displacement, body.increment]
    }

    #[inline]
    fn pounding(&self, level: usize) -> f64 {
        self.bodies[self.floors[level]].pushed()
    }

    #[inline]
    fn respond(&mut self, level: usize, drift: f64) -> f64 {
        let index = self.floors[level];
        let body = &mut self.bodies[index];
        let response = self.row.nodes()[index].column.respond(drift, body.memory);
        body.memory = response.memory;
        self.solutions[level].restoring_force = response.force;
        response.force
    }

    #[inline]
    fn hold(&mut self, level: usize, acceleration: f64, increment: f64) {
        let solution = &mut self.solutions[level];
        solution.acceleration = acceleration;
        solution.increment = increment;
    }

    #[inline]
    fn held(&self, level: usize) -> f64 {
        self.solutions[level].increment
    }

    #[inline]
    fn go_on(&mut self, level: usize, increment: f64) {
        let body = &self.bodies[self.floors[level]];
        let solution = &mut self.solutions[level];
        solution.increment = increment;
        let own = &self.coefficients[level].own;
        solution.velocity = own.velocity([body.increment, increment]);
        self.is_finite &= (body.displacement + increment).abs() <= f64::MAX;
    }
}

impl<Column: RestoringForce> Building<'_, Column> {
    /// A floor whose next displacement is not finite.
    fn diverged(&self) -> Option<usize> {
        if self.is_finite {
            return None;
        }
        let next = |(index, solution): (&usize, &Solution)| {
            let displacement = self.bodies[*index].displacement + solution.increment;
            (!displacement.is_finite()).then_some(*index)
        };
        self.floors.iter().zip(self.solutions.iter()).find_map(next)
    }

    /// Whether a whole step met a neighbour that sub-steps.
    fn met_late(&self) -> bool {
        let late = |index: &usize| self.bodies[*index].excess != (0.0, 0.0);
        self.floors.iter().any(late)
    }

    /// Excess velocities of whole steps, before the dashpots share them.
    fn excess(&self, velocities: &mut [f64]) {
        for ((&index, constants), velocity) in self.floors.iter().zip(self.coefficients).zip(velocities) {
            let (from_left, from_right) = self.bodies[index].excess;
            *velocity = constants.own.inverse_mass * (from_left + from_right);
        }
    }

    /// Removes the excess of whole steps from the velocities at their ends. The increments are restarted afterwards.
    fn give_back(&mut self, changes: &[f64]) {
        let solutions = &mut *self.solutions;
        let mut below = [0.0; 2];
        for (level, constants) in self.coefficients.iter().enumerate() {
            let rates = &constants.rates;
            let (own, upper) = (solutions[level].velocity, level + 1);
            let above = solutions.get(upper).map_or(0.0, |above| above.velocity);
            let change = changes.get(upper).copied().unwrap_or(0.0);
            let solution = &mut solutions[level];
            solution.acceleration -= rates.deceleration([below[0], own, above]);
            solution.acceleration += rates.deceleration([below[1], changes[level], change]);
            below = [own, changes[level]];
            solution.velocity -= changes[level];
        }
    }

    /// From the top down: reports the spans that end at a node, and advances the bodies.
    ///
    /// Accelerations may be `settled` already.
    fn go_on<R: Recorder>(&mut self, time: f64, ground: f64, settled: bool, recorder: &mut R) {
        let (mut above, n) = (Above::default(), self.floors.len());
        // The lengths are fixed here, so that no floor needs a bounds check.
        let coefficients = &self.coefficients[..n];
        for level in (0..n).rev() {
            let (index, found) = (self.floors[level], self.solutions[level]);
            let rates = &coefficients[level].rates;
            let velocity = found.velocity;
            let below = level.checked_sub(1);
            let below_velocity = below.map_or(0.0, |below| self.solutions[below].velocity);
            let mut acceleration = found.acceleration;
            if !settled {
                acceleration -= rates.deceleration([below_velocity, velocity, above.velocity]);
            }
            let body = &self.bodies[index];
            let end = State {
                displacement: body.displacement,
                velocity,
                acceleration,
                restoring_force: found.restoring_force,
                force_from_left: body.force_from_left,
                force_from_right: body.force_from_right,
            };
            if time > body.start_time {
                let span_end = SpanEnd {
                    state: end,
                    below_velocity,
                    time,
                    ground,
                };
                self.report(level, span_end, &mut above, recorder);
            }
            above.velocity = velocity;
            let body = &mut self.bodies[index];
            body.displacement += found.increment;
            (body.earlier, body.increment) = (body.increment, found.increment);
            body.velocity = found.velocity;
            body.start = end;
            body.start_time = time;
            body.start_ground = ground;
        }
    }

    /// Reports the span of a floor that ends at a node.
    fn report<R: Recorder>(&mut self, level: usize, end: SpanEnd, above: &mut Above, recorder: &mut R) {
        let index = self.floors[level];
        let body = &self.bodies[index];
        let below = level.checked_sub(1).map(|level| {
            let lower = &self.bodies[self.floors[level]];
            let end = Motion {
                displacement: lower.displacement,
                velocity: end.below_velocity,
            };
            [(&lower.start).into(), end]
        });
        let forces = if recorder.reads_weighed() {
            self.forces(level, &mut above.forces)
        } else {
            [StoreyForces::default(); 2]
        };
        let loads = [
            Load::at(&body.start, forces[0], body.start_ground),
            Load::at(&end.state, forces[1], end.ground),
        ];
        let weights = Weights::trapezoidal(0.5 * self.coefficients[level].own.time_step);
        let (times, ends) = ([body.start_time, end.time], [body.start, end.state]);
        let mut span = Span::step(recorder.reads_weighed(), index, times, ends, weights, loads);
        span.impulse_from_left -= body.excess.0;
        span.impulse_from_right -= body.excess.1;
        span.below = below;
        let slots = self.row.incidence().slots_at(index);
        self.pushes.end(slots.clone(), weights.scale);
        span.pushes = self.pushes.of(slots);
        if let Some(links) = &mut self.links {
            span.links = links.end(self.row.linking().slots_at(index), weights.scale);
        }
        recorder.span(&span);
    }

    /// Net forces on a floor at both ends of its span, at the velocities of the equations. Replaces the forces of the storey above by those
    /// of the floor's storey.
    fn forces(&self, level: usize, storey: &mut [StoreyForces; 2]) -> [StoreyForces; 2] {
        let index = self.floors[level];
        let (node, found) = (&self.row.nodes()[index], &self.solutions[level]);
        let start = &self.bodies[index];
        let mut below = [0.0; 2];
        if let Some(lower) = level.checked_sub(1) {
            let lower_velocity = self.bodies[self.floors[lower]].velocity;
            below = [lower_velocity, self.solutions[lower].velocity];
        }
        let own = [
            (start.start.restoring_force, start.velocity),
            (found.restoring_force, found.velocity),
        ];
        let mut net = [StoreyForces::default(); 2];
        for end in 0..2 {
            let (restoring, velocity) = own[end];
            let damping = node.damping * (velocity - below[end]);
            let all = damping + node.support.ground_damping() * velocity;
            net[end] = StoreyForces {
                restoring: restoring - storey[end].restoring,
                damping: all - storey[end].damping,
            };
            storey[end] = StoreyForces { restoring, damping };
        }
        net
    }
}
