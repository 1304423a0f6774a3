//! Contact in the central difference method: pounding forces at a node, impacts, and who sub-steps.

use pounding_contact::Overlap;

use super::{Body, Instant, Run};
use crate::model::buildings::Buildings;
use crate::model::ground::Ground;
use crate::{Pair, Recorder, RestoringForce};

impl<Column: RestoringForce> Run<'_, Column> {
    /// Contact at a node, each pair alone; true when an impulsive pair is closed and may jump.
    ///
    /// Compliant laws see the backward difference of the deformation as its rate, also where the deformation one step
    /// earlier was negative.
    pub(super) fn touch(&mut self, Instant { ground, fine, .. }: Instant<'_>) -> bool {
        let bodies = &mut self.bodies;
        for body in bodies.iter_mut().filter(|body| body.fine || !fine) {
            (body.force_from_left, body.force_from_right) = (0.0, 0.0);
            body.excess = (0.0, 0.0);
        }
        let mut hit = false;
        for (index, pair) in self.row.pairs().iter().enumerate() {
            self.jumps.touching[index] = false;
            let (left, right) = (&bodies[pair.left()], &bodies[pair.right()]);
            let deformation = ground.deformation(pair, left.displacement - right.displacement);
            // Structures of which one does not sub-step meet at whole nodes only.
            if fine && !(left.fine && right.fine) {
                continue;
            }
            let overlaps = deformation > 0.0;
            if !overlaps {
                self.approaches.forget(index);
            }
            if deformation < 0.0 {
                continue;
            }
            self.work.touching_steps += u64::from(overlaps);
            if pair.law.impulsive().is_some() {
                self.jumps.touching[index] = true;
                hit = true;
            } else if overlaps {
                let steps = [left, right].map(|body| self.steps[usize::from(body.fine)]);
                // The grounds' own is that half way back.
                let half_back = 0.5 * steps[0].min(steps[1]) / self.steps[0];
                let rate = ground
                    .earlier(half_back)
                    .rate(pair, rate(left, right, steps));
                let overlap = Overlap {
                    deformation,
                    rate,
                    reduced_mass: self.row.reduced_mass(pair),
                    approach_speed: self.approaches.of(index, rate),
                };
                if let Some(contact) = pair.law.respond(&overlap) {
                    push(bodies, pair, contact.force, steps);
                }
            }
        }
        hit
    }

    /// Lets the velocities of a node jump; the increments of those that do are restarted.
    pub(super) fn jump<R: Recorder>(&mut self, node: Instant<'_>, recorder: &mut R) {
        for (state, body) in self.states.iter_mut().zip(&self.bodies) {
            *state = body.start;
        }
        let instant = (node.ground, node.time);
        self.jumps
            .jump(self.row, &mut self.states, instant, recorder);
        for (state, body) in self.states.iter().zip(&mut self.bodies) {
            // Dashpots let the acceleration of a floor jump with the velocity of its neighbours in the building.
            let jumped = (state.velocity - body.start.velocity).abs() > 0.0
                || (state.acceleration - body.start.acceleration).abs() > 0.0;
            if jumped {
                body.start = *state;
                body.velocity = state.velocity;
                body.restart(self.steps[usize::from(body.fine)]);
            }
        }
    }

    /// Chooses the structures that sub-step from this node on, with the grounds here and at the next one; true when there
    /// are any.
    pub(super) fn refine(&mut self, grounds: [Ground<'_>; 2]) -> bool {
        for body in &mut self.bodies {
            if std::mem::take(&mut body.fine) {
                body.restart(self.steps[0]);
            }
        }
        let mut any = false;
        for pair in self.row.pairs() {
            let (left, right) = (&self.bodies[pair.left()], &self.bodies[pair.right()]);
            let now = left.start.displacement - right.start.displacement;
            let next = left.displacement - right.displacement;
            let overlaps = |ground: Ground<'_>, ahead: f64| ground.deformation(pair, ahead) > 0.0;
            if overlaps(grounds[0], now) || overlaps(grounds[1], next) {
                self.bodies[pair.left()].fine = true;
                self.bodies[pair.right()].fine = true;
                any = true;
            }
        }
        if let Some(storeys) = self.storeys.as_ref().filter(|_| any) {
            refine_buildings(&storeys.buildings, &mut self.bodies);
        }
        for body in self.bodies.iter_mut().filter(|body| body.fine) {
            body.restart(self.steps[1]);
        }
        any
    }
}

/// Lets all floors of a building sub-step with one of them.
fn refine_buildings<Memory>(buildings: &Buildings, bodies: &mut [Body<Memory>]) {
    for floors in buildings.each() {
        let fine = floors.iter().any(|index| bodies[*index].fine);
        for index in floors {
            bodies[*index].fine = fine;
        }
    }
}

/// Backward difference of the deformation \[m/s\], for steps of these lengths.
fn rate<Memory>(left: &Body<Memory>, right: &Body<Memory>, steps: [f64; 2]) -> f64 {
    if left.fine == right.fine {
        (left.increment - right.increment) / steps[0]
    } else {
        left.increment / steps[0] - right.increment / steps[1]
    }
}

/// Gives a pair its force; on both neighbours it acts for half of the shorter step.
fn push<Memory>(bodies: &mut [Body<Memory>], pair: &Pair, force: f64, steps: [f64; 2]) {
    let [left, right] = steps;
    let excess = 0.5 * force;
    bodies[pair.left()].excess.1 = -excess * (left - left.min(right));
    bodies[pair.right()].excess.0 = excess * (right - left.min(right));
    bodies[pair.left()].force_from_right = -force;
    bodies[pair.right()].force_from_left = force;
}
