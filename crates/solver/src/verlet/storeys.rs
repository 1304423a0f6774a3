//! States of floors that stand on floors, at the end of a span of the velocity Verlet method.
//!
//! The damping of the end is that of its own velocities, which the dashpots between floors join. All floors of a building
//! are due together, so that the equations of one have one step.

use super::{Scratch, Step};
use crate::{Recorder, RestoringForce, Row, RunError, Span, Work};

impl<Memory: Copy> Scratch<Memory> {
    /// What [`finish`](Scratch::finish) does, where floors stand on floors; pounding forces and their impulses are known.
    pub(super) fn finish_floors<Column: RestoringForce<Memory = Memory>, R: Recorder>(
        &mut self,
        row: &Row<Column>,
        (step, instant): (Step, f64),
        work: &mut Work,
        recorder: &mut R,
    ) -> Result<(), RunError> {
        self.respond(row, (step, instant), work)?;
        let Self {
            dashpots, bodies, ..
        } = self;
        if let Some(dashpots) = dashpots {
            dashpots.solve(row, |index| bodies[index].step(instant));
            for (index, end) in self.ends.iter_mut().enumerate() {
                if bodies[index].step(instant).is_some() {
                    end.velocity = dashpots.values[index];
                }
            }
        }
        for index in 0..self.bodies.len() {
            if let Some(h) = self.bodies[index].step(instant) {
                let ground = step.at(instant).0;
                self.ends[index].acceleration = row.acceleration(index, &self.ends, ground);
                self.report(row, (index, h), (step, instant), recorder);
            }
        }
        for (index, body) in self.bodies.iter_mut().enumerate() {
            if body.step(instant).is_some() {
                self.states[index] = self.ends[index];
                body.since = instant;
            }
        }
        Ok(())
    }

    /// Lets all floors of a building be due with one of them; true when one was not.
    pub(super) fn gather_floors<Column: RestoringForce>(&mut self, row: &Row<Column>) -> bool {
        let mut grown = false;
        for index in 0..self.bodies.len() {
            let Some(below) = row.nodes()[index].support.below() else {
                continue;
            };
            let (lower, upper) = (self.bodies[below].due, self.bodies[index].due);
            grown |= lower != upper;
            self.bodies[below].due |= upper;
            self.bodies[index].due |= lower;
        }
        grown
    }

    /// From the top down: the forces of columns, and the velocities that would follow without the damping at the end.
    fn respond<Column: RestoringForce<Memory = Memory>>(
        &mut self,
        row: &Row<Column>,
        (step, instant): (Step, f64),
        work: &mut Work,
    ) -> Result<(), RunError> {
        let Some(dashpots) = &mut self.dashpots else {
            return Ok(());
        };
        let (ground, _) = step.at(instant);
        for (index, floor) in row.nodes().iter().enumerate().rev() {
            let body = &mut self.bodies[index];
            let Some(h) = body.step(instant) else {
                continue;
            };
            if !self.ends[index].displacement.is_finite() {
                return Err(RunError::Diverged {
                    structure: index,
                    time: step.times.1,
                    time_step: step.duration,
                });
            }
            let drift = row.drift(index, &self.ends);
            let response = floor.column.respond(drift, body.memory);
            body.memory = response.memory;
            work.force_evaluations += 1;
            self.ends[index].restoring_force = response.force;
            let restoring = row.restoring_force(index, &self.ends);
            let ground = if floor.is_wall() { 0.0 } else { ground };
            let start = &self.states[index];
            let smooth = start.acceleration + (floor.inverse_mass * (0.0 - restoring) - ground);
            let pounding = floor.inverse_mass * (body.impulses.0 + body.impulses.1);
            dashpots.values[index] = start.velocity + 0.5 * h * smooth + pounding;
        }
        Ok(())
    }

    /// Reports the span of a floor that has taken h \[s\].
    fn report<Column: RestoringForce<Memory = Memory>, R: Recorder>(
        &self,
        row: &Row<Column>,
        (index, h): (usize, f64),
        (step, instant): (Step, f64),
        recorder: &mut R,
    ) {
        let body = &self.bodies[index];
        let (starts, ends) = (&self.states, &self.ends);
        let ((first_ground, first), (last_ground, last)) = (step.at(body.since), step.at(instant));
        let loads = [
            row.load(index, starts, first_ground),
            row.load(index, ends, last_ground),
        ];
        let states = [starts[index], ends[index]];
        let weights = (0.5 * h, [1.0, 1.0]);
        recorder.span(&Span {
            impulse_from_left: 0.5 * h * states[0].force_from_left + body.impulses.0,
            impulse_from_right: 0.5 * h * states[0].force_from_right + body.impulses.1,
            ..Span::step::<R, _>(index, (first, last), states, weights, loads)
                .over(row.below(index, [starts, ends]))
        });
    }
}
