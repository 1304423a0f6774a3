//! Contact in the central difference method: pounding forces at a node, impacts, and the choice of structures that sub-step.

use pounding_contact::Overlap;

use super::{Body, CentralDifferenceRun, Instant};
use crate::model::ground::{Ground, Now};
use crate::pushes::Pushes;
use crate::{Recorder, RestoringForce, Row, RunError, Work};

impl<Column: RestoringForce> CentralDifferenceRun<'_, Column> {
    /// Contact at a node, pair by pair; true if an impulsive pair is closed and may jump.
    ///
    /// The rate of deformation of compliant laws is the backward difference of the deformation, even if the deformation one step earlier
    /// was negative.
    pub(super) fn touch(&mut self, Instant { ground, fine, .. }: Instant<'_>, work: &mut Work) -> bool {
        let (row, bodies) = (self.row, &mut self.bodies);
        if !fine {
            self.pushes.pass();
        }
        for (index, body) in bodies.iter_mut().enumerate() {
            if body.fine || !fine {
                (body.force_from_left, body.force_from_right) = (0.0, 0.0);
                body.excess = (0.0, 0.0);
                self.pushes.go_on(row.incidence().slots_at(index));
            }
        }
        let mut hit = false;
        for (index, pair) in self.row.pairs().iter().enumerate() {
            self.jumps.touching[index] = false;
            let (left, right) = (&bodies[pair.left()], &bodies[pair.right()]);
            let ahead = pair.relation.ahead(|floor| bodies[floor].displacement);
            let deformation = ground.deformation(pair, ahead);
            // If either structure does not sub-step, the pair meets only at whole nodes.
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
            work.touching_steps += u64::from(overlaps);
            if pair.law.impulsive().is_some() {
                self.jumps.touching[index] = true;
                hit = true;
            } else if overlaps {
                let steps = [left, right].map(|body| self.steps[usize::from(body.fine)]);
                // The ground velocity is that half a step back.
                let half_back = 0.5 * steps[0].min(steps[1]) / self.steps[0];
                let (fine, [by_left, by_right]) = ([left.fine, right.fine], steps);
                let [left, right] = pair.relation.points();
                let [left, right] = [left, right].map(|point| point.of(|floor| bodies[floor].increment));
                // Backward difference of the deformation.
                let faster = if fine[0] == fine[1] {
                    (left - right) / by_left
                } else {
                    left / by_left - right / by_right
                };
                let rate = ground.earlier(half_back).rate(pair, faster);
                let overlap = Overlap {
                    deformation,
                    rate,
                    reduced_mass: self.row.reduced_mass(pair),
                    approach_speed: self.approaches.of(index, rate),
                };
                if let Some(contact) = pair.law.respond(&overlap) {
                    push(row, index, contact.force, steps, bodies, &mut self.pushes);
                }
            }
        }
        hit
    }

    /// Applies velocity jumps at a node; the increments of structures that jump are restarted.
    pub(super) fn jump<R: Recorder>(&mut self, node: Instant<'_>, recorder: &mut R) -> Result<(), RunError> {
        for (state, body) in self.states.iter_mut().zip(&self.bodies) {
            *state = body.start;
        }
        let now = Now {
            ground: node.ground,
            time: node.time,
        };
        if !self.jumps.jump(self.row, &mut self.states, now, recorder)? {
            return Ok(());
        }
        self.relink(node.ground);
        for ((state, body), relinked) in self.states.iter().zip(&mut self.bodies).zip(&self.relinked) {
            // Through dashpots, the acceleration of a floor jumps with the velocity of its neighbours in the building and of linked floors.
            let jumped = (state.velocity - body.start.velocity).abs() > 0.0 || (state.acceleration - body.start.acceleration).abs() > 0.0;
            if jumped || *relinked {
                body.start = *state;
                body.velocity = state.velocity;
                body.restart(self.steps[usize::from(body.fine)]);
            }
        }
        Ok(())
    }

    /// Chooses the structures that sub-step from this node, with the grounds here and at the next node; true if there are any.
    pub(super) fn refine(&mut self, grounds: [Ground<'_>; 2]) -> bool {
        for body in &mut self.bodies {
            if std::mem::take(&mut body.fine) {
                body.restart(self.steps[0]);
            }
        }
        let mut any = false;
        for pair in self.row.pairs() {
            let now = pair.relation.ahead(|floor| self.bodies[floor].start.displacement);
            let next = pair.relation.ahead(|floor| self.bodies[floor].displacement);
            let overlaps = |ground: Ground<'_>, ahead: f64| ground.deformation(pair, ahead) > 0.0;
            if overlaps(grounds[0], now) || overlaps(grounds[1], next) {
                for (floor, _) in pair.relation.pushes() {
                    self.bodies[floor].fine = true;
                }
                any = true;
            }
        }
        if any && self.links.is_some() {
            for body in &mut self.bodies {
                body.fine = true;
            }
        }
        if any && self.storeys.is_some() {
            let buildings = self.row.buildings();
            buildings.share(&mut self.bodies, |body| &mut body.fine);
        }
        for body in self.bodies.iter_mut().filter(|body| body.fine) {
            body.restart(self.steps[1]);
        }
        any
    }
}

/// Gives the floors of a pair its force. It acts on all of them for half of the shorter step.
fn push<Column: RestoringForce>(
    row: &Row<Column>,
    pair: usize,
    force: f64,
    [left, right]: [f64; 2],
    bodies: &mut [Body<Column::Memory>],
    pushes: &mut Pushes,
) {
    let shorter = left.min(right);
    let late = |on_left: bool| {
        if on_left { left - shorter } else { right - shorter }
    };
    pushes.act(row, pair, force, |floor, on_left, force| {
        let body = &mut bodies[floor];
        let excess = 0.5 * force * late(on_left);
        if on_left {
            body.force_from_right -= force;
            body.excess.1 -= excess;
        } else {
            body.force_from_left += force;
            body.excess.0 += excess;
        }
    });
    for slot in row.incidence().slots_of(pair) {
        let push = pushes.at(*slot);
        push.impulse = 0.5 * force * late(push.on_left);
    }
}
