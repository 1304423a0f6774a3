//! The equations of a node of the run in a row in which floors stand on floors.
//!
//! The dashpots between floors join the next increments of a building: what the equation of a floor says of its increment
//! is found from the top floor down, the increments then from the ground up. All that follows from them may look at the
//! floors below and above as they were at the node before and as they are at this one, so that the bodies take on the new
//! state last.

use super::coefficients::Coefficients;
use super::{ImpactRule, Instant, Run};
use crate::span::Load;
use crate::{Motion, Recorder, RestoringForce, Row, RunError, Span, State};

/// What the equation of a floor says at a node.
#[derive(Clone, Copy, Default)]
pub(super) struct Solution {
    /// The next increment \[m\]; on the way down without what the floor below adds to it.
    increment: f64,
    /// Central-difference velocity, half way through a jump \[m/s\].
    velocity: f64,
    /// Jump of the velocity by the published rule \[m/s\].
    jump: f64,
    /// State at the node, before its impacts.
    end: State,
}

impl<Column: RestoringForce> Run<'_, Column> {
    /// Solves the equations of a node, reports the spans that end there, and lets the bodies go on from it.
    pub(super) fn advance_storeys<R: Recorder>(
        &mut self,
        node: Instant,
        recorder: &mut R,
    ) -> Result<(), RunError> {
        self.eliminate(node);
        let met_late = self.substitute(node)?;
        self.accelerate(node);
        if met_late {
            self.give_back();
        }
        for index in 0..self.solutions.len() {
            if self.has(index, node) && node.time > self.bodies[index].start_time {
                self.report_floor((index, node), recorder);
            }
        }
        self.accept(node);
        Ok(())
    }

    /// Whether a structure has a node at this instant.
    fn has(&self, index: usize, node: Instant) -> bool {
        self.bodies[index].fine || !node.fine
    }

    fn constants(&self, index: usize) -> &Coefficients {
        &self.coefficients[usize::from(self.bodies[index].fine)][index]
    }

    /// From the top down: forces, and what is known of the increments.
    fn eliminate(&mut self, node: Instant) {
        for index in (0..self.solutions.len()).rev() {
            if !self.has(index, node) {
                continue;
            }
            let (body, constants) = (&self.bodies[index], self.constants(index));
            let floor = &self.row.nodes()[index];
            let (mut drift, mut carried) = (body.displacement, 0.0);
            let mut known = constants.carry * body.increment;
            if let Some(below) = floor.support.below() {
                let below = &self.bodies[below];
                drift -= below.displacement;
                known += constants.coupling.below * below.increment;
            }
            if let Some(above) = self.row.above(index) {
                let found = &self.solutions[above];
                carried = found.end.restoring_force;
                known +=
                    constants.coupling.above * (self.bodies[above].increment + found.increment);
            }
            let response = floor.column.respond(drift, body.memory);
            let force = body.force_from_left + body.force_from_right - (response.force - carried);
            let smooth = constants.inverse_mass * force - constants.mobile * node.ground;
            let jump = constants.inverse_mass * body.impulse;
            let load = smooth + jump / constants.time_step;
            self.solutions[index] = Solution {
                increment: constants.solve * (load + known),
                velocity: 0.0,
                jump,
                end: State {
                    displacement: body.displacement,
                    velocity: 0.0,
                    acceleration: smooth,
                    restoring_force: response.force,
                    force_from_left: body.force_from_left,
                    force_from_right: body.force_from_right,
                },
            };
            self.bodies[index].memory = response.memory;
            self.work.force_evaluations += 1;
        }
    }

    /// From the ground up: increments and velocities; true when a whole step met a neighbour that sub-steps.
    fn substitute(&mut self, node: Instant) -> Result<bool, RunError> {
        let mut met_late = false;
        for index in 0..self.solutions.len() {
            if !self.has(index, node) {
                continue;
            }
            let (body, constants) = (&self.bodies[index], self.constants(index));
            let mut increment = self.solutions[index].increment;
            if let Some(below) = self.row.nodes()[index].support.below() {
                increment += constants.coupling.share * self.solutions[below].increment;
            }
            if !(body.displacement + increment).is_finite() {
                return Err(RunError::Diverged {
                    structure: index,
                    time: node.next,
                    time_step: self.steps[0],
                });
            }
            let velocity = (increment + body.increment) / (2.0 * constants.time_step);
            let solution = &mut self.solutions[index];
            solution.increment = increment;
            solution.velocity = velocity;
            solution.end.velocity = solution.velocity - 0.5 * solution.jump;
            met_late |= body.excess != (0.0, 0.0);
        }
        Ok(met_late)
    }

    /// Takes the damping out of the accelerations.
    fn accelerate(&mut self, node: Instant) {
        for index in 0..self.solutions.len() {
            if self.has(index, node) {
                let velocity = |floor: usize| self.solutions[floor].end.velocity;
                let rates = &self.constants(index).rates;
                let lost = rates.deceleration(self.row, index, velocity);
                self.solutions[index].end.acceleration -= lost;
            }
        }
    }

    /// Takes the excess of whole steps out of the velocities at their end; the increments are restarted after it.
    fn give_back(&mut self) {
        let Some(dashpots) = &mut self.dashpots else {
            return;
        };
        let bodies = &self.bodies;
        let floors = bodies.iter().zip(self.row.nodes());
        for (change, (body, floor)) in dashpots.values.iter_mut().zip(floors) {
            *change = floor.inverse_mass * (body.excess.0 + body.excess.1);
        }
        let whole = |index: usize| !bodies[index].fine;
        dashpots.solve(self.row, |index| whole(index).then_some(self.steps[0]));
        let change = |floor: usize| dashpots.values[floor];
        for (index, solution) in self.solutions.iter_mut().enumerate() {
            if whole(index) {
                let rates = &self.coefficients[0][index].rates;
                solution.end.velocity -= change(index);
                solution.end.acceleration += rates.deceleration(self.row, index, change);
                solution.velocity = solution.end.velocity;
            }
        }
    }

    /// Reports the span of a floor that ends at a node.
    fn report_floor<R: Recorder>(&self, (index, node): (usize, Instant), recorder: &mut R) {
        let (bodies, solutions) = (&self.bodies, &self.solutions);
        let body = &bodies[index];
        let ends = [body.start, solutions[index].end];
        let [mut first, mut last] = [(0.0, 0.0); 2];
        if R::READS_WEIGHED {
            first = (
                net(self.row, index, |floor| bodies[floor].start.restoring_force),
                self.row.damping_at(index, |floor| bodies[floor].velocity),
            );
            last = (
                net(self.row, index, |floor| {
                    solutions[floor].end.restoring_force
                }),
                self.row
                    .damping_at(index, |floor| solutions[floor].velocity),
            );
        }
        let loads = [
            Load::at(&ends[0], first, body.start_ground),
            Load::at(&ends[1], last, node.ground),
        ];
        let weights = [if body.solved { 1.0 } else { 0.0 }, 1.0];
        let weights = (0.5 * self.constants(index).time_step, weights);
        let times = (body.start_time, node.time);
        let below = |floor: usize| -> [Motion; 2] {
            [
                (&bodies[floor].start).into(),
                (&solutions[floor].end).into(),
            ]
        };
        let mut span = Span::step::<R, _>(index, times, ends, weights, loads)
            .over(self.row.nodes()[index].support.below().map(below));
        span.impulse_from_left -= body.excess.0;
        span.impulse_from_right -= body.excess.1;
        recorder.span(&span);
    }

    /// Lets the bodies go on from a node, after the impacts of the published rule.
    fn accept(&mut self, node: Instant) {
        for index in 0..self.solutions.len() {
            if !self.has(index, node) {
                continue;
            }
            let solution = self.solutions[index];
            let mut start = solution.end;
            if self.impacts == ImpactRule::AsPublished {
                let jump = |floor: usize| self.solutions[floor].jump;
                let rates = &self.constants(index).rates;
                start.velocity += solution.jump;
                start.acceleration -= rates.deceleration(self.row, index, jump);
            }
            let body = &mut self.bodies[index];
            body.displacement += solution.increment;
            body.increment = solution.increment;
            body.velocity = solution.velocity;
            body.start = start;
            body.start_time = node.time;
            body.start_ground = node.ground;
            body.solved = true;
        }
    }
}

/// Restoring force against a displacement of a floor, of these forces of its own storey and the one above.
fn net<Column: RestoringForce>(
    row: &Row<Column>,
    index: usize,
    force: impl Fn(usize) -> f64,
) -> f64 {
    match row.above(index) {
        None => force(index),
        Some(above) => force(index) - force(above),
    }
}
