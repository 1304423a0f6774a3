//! States of floors that stand on floors, at the end of a span of the velocity Verlet method.
//!
//! The damping at the end belongs to the velocities at the end, which the dashpots between floors couple. All floors of a building are due
//! together, so that its equations have a common step.

use super::{Body, Scratch};
use crate::march::ClockStep;
use crate::pushes::Pushes;
use crate::span::{Load, StoreyForces, Weights};
use crate::{Recorder, RestoringForce, Row, RunError, Span, State, Work};

impl<Memory: Copy> Scratch<Memory> {
    /// Does the work of [`finish`](Scratch::finish) building by building. Pounding forces and their impulses are known.
    #[inline(never)] // The loop over structures of one storey would otherwise share its registers.
    pub(super) fn finish_storeys<Column: RestoringForce<Memory = Memory>, R: Recorder>(
        &mut self,
        row: &Row<Column>,
        step: ClockStep<'_>,
        instant: f64,
        work: &mut Work,
        recorder: &mut R,
    ) -> Result<(), RunError> {
        let Some(dashpots) = &mut self.dashpots else {
            return Ok(());
        };
        for range in row.buildings().ranges() {
            let floors = &row.buildings().all()[range.clone()];
            let since = self.bodies[floors[0]].since;
            if !(self.bodies[floors[0]].due && instant > since) {
                continue;
            }
            // All floors of a building stand on one ground.
            let ends = [since, instant].map(|instant| step.at(instant));
            let mut building = Building {
                row,
                floors,
                bodies: &mut self.bodies,
                states: &mut self.states,
                ends: &mut self.ends,
                pushes: &mut self.pushes,
                length: instant - since,
                grounds: ends.map(|now| now.ground.under(floors[0])),
                times: ends.map(|now| now.time),
            };
            if let Some(structure) = building.diverged() {
                return Err(step.diverged(structure));
            }
            building.respond(&mut dashpots.values[range.clone()]);
            let velocities = dashpots.solve(range, instant - since);
            building.go_on(velocities, instant, recorder);
            work.force_evaluations += floors.len() as u64;
        }
        Ok(())
    }
}

/// A building over a span.
struct Building<'a, Column: RestoringForce> {
    row: &'a Row<Column>,
    /// Nodes of the floors, from the ground up.
    floors: &'a [usize],
    /// Bodies of the whole row, like the states at both ends.
    bodies: &'a mut [Body<Column::Memory>],
    states: &'a mut [State],
    ends: &'a mut [State],
    pushes: &'a mut Pushes,
    /// Length of the span \[s\].
    length: f64,
    /// Ground acceleration \[m/s²\] and time \[s\] at both ends.
    grounds: [f64; 2],
    times: [f64; 2],
}

impl<Column: RestoringForce> Building<'_, Column> {
    /// A floor whose displacement is not finite.
    fn diverged(&self) -> Option<usize> {
        let diverged = |index: &&usize| !self.ends[**index].displacement.is_finite();
        self.floors.iter().find(diverged).copied()
    }

    /// From the top down: computes the forces of columns, and the velocities without the damping at the end.
    fn respond(&mut self, velocities: &mut [f64]) {
        let (h, [_, ground]) = (self.length, self.grounds);
        let mut carried = 0.0;
        for (&index, velocity) in self.floors.iter().zip(velocities).rev() {
            let (floor, start) = (&self.row.nodes()[index], &self.states[index]);
            let drift = self.row.drift(index, self.ends);
            let body = &mut self.bodies[index];
            let response = floor.column.respond(drift, body.memory);
            body.memory = response.memory;
            self.ends[index].restoring_force = response.force;
            let restoring = response.force - carried;
            carried = response.force;
            let ground = if floor.is_wall() { 0.0 } else { ground };
            let half_way = start.velocity + 0.5 * h * start.acceleration;
            let smooth = floor.inverse_mass * (0.0 - restoring) - ground;
            let pushed = floor.inverse_mass * (body.impulses.0 + body.impulses.1);
            *velocity = half_way + 0.5 * h * smooth + pushed;
        }
    }

    /// From the top down: accepts the velocities at the end, reports the spans, and advances.
    fn go_on<R: Recorder>(&mut self, velocities: &[f64], instant: f64, recorder: &mut R) {
        // Forces of the columns and of the dashpot of the storey above, at both ends.
        let mut above = [StoreyForces::default(); 2];
        let (h, [first_ground, last_ground]) = (self.length, self.grounds);
        for (level, &index) in self.floors.iter().enumerate().rev() {
            let floor = &self.row.nodes()[index];
            let below = floor.support.below();
            let lower = level.checked_sub(1);
            let below_velocity = lower.map_or(0.0, |lower| velocities[lower]);
            if let Some(below) = below {
                self.ends[below].velocity = below_velocity;
            }
            let start = self.states[index];
            let before = below.map_or(0.0, |below| self.states[below].velocity);
            let end = &mut self.ends[index];
            end.velocity = velocities[level];
            let mut net = |at: usize, state: &State, below: f64| {
                let damping = floor.damping * (state.velocity - below);
                let all = damping + floor.support.ground_damping() * state.velocity;
                let (restoring, carried) = (state.restoring_force, above[at]);
                above[at] = StoreyForces { restoring, damping };
                StoreyForces {
                    restoring: restoring - carried.restoring,
                    damping: all - carried.damping,
                }
            };
            let first = if recorder.reads_weighed() {
                net(0, &start, before)
            } else {
                StoreyForces::default()
            };
            let last = net(1, end, below_velocity);
            let ground = if floor.is_wall() { 0.0 } else { last_ground };
            end.acceleration = floor.inverse_mass * (end.pounding_force() - last.damping - last.restoring) - ground;
            let end = *end;
            let loads = [Load::at(&start, first, first_ground), Load::at(&end, last, last_ground)];
            let weights = Weights::trapezoidal(0.5 * h);
            let body = &mut self.bodies[index];
            let slots = self.row.incidence().slots_at(index);
            self.pushes.start(slots.clone(), 0.5 * h);
            let mut span = Span::step(recorder.reads_weighed(), index, self.times, [start, end], weights, loads);
            span.impulse_from_left = 0.5 * h * start.force_from_left + body.impulses.0;
            span.impulse_from_right = 0.5 * h * start.force_from_right + body.impulses.1;
            span.below = self.row.below(index, [self.states, self.ends]);
            span.pushes = self.pushes.of(slots.clone());
            recorder.span(&span);
            self.pushes.go_on(slots);
            self.states[index] = end;
            body.since = instant;
        }
    }
}
