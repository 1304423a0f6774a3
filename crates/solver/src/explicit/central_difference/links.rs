//! Links in the central difference method.

use super::coefficients::Coefficients;
use super::{CentralDifferenceRun, Instant};
use crate::link_forces::LinkForces;
use crate::model::ground::Ground;
use crate::{Motion, RestoringForce, Row, State};

/// The links at t = 0; gives the states accelerations in equilibrium with them.
pub(super) fn begin<Column: RestoringForce>(row: &Row<Column>, states: &mut [State], ground: Ground<'_>) -> Option<LinkForces> {
    let mut links = LinkForces::of(row, states, ground)?;
    links.pull(row, |node| (&states[node]).into(), ground, 0.0, true);
    for node in 0..states.len() {
        settle(row, &links, node, states, ground);
    }
    Some(links)
}

/// Gives a node the acceleration in equilibrium with its links.
fn settle<Column: RestoringForce>(row: &Row<Column>, links: &LinkForces, node: usize, states: &mut [State], ground: Ground<'_>) {
    let mut load = row.load(node, states, ground.under(node));
    load.links = links.on(node);
    states[node].acceleration = row.acceleration_under(node, &load);
}

impl<Column: RestoringForce> CentralDifferenceRun<'_, Column> {
    /// Gives all floors the forces of their links at a node.
    pub(super) fn pull(&mut self, Instant { ground, .. }: Instant<'_>) {
        let Some(links) = &mut self.links else {
            return;
        };
        let bodies = &self.bodies;
        // All structures of a row with links sub-step together.
        let time_step = self.steps[usize::from(bodies[0].fine)];
        let motion = |node: usize| {
            let body = &bodies[node];
            Motion {
                displacement: body.displacement,
                velocity: Coefficients::extrapolated(time_step, [body.earlier, body.increment]),
            }
        };
        links.go_on(self.row);
        links.pull(self.row, motion, ground, time_step, true);
        for (node, body) in self.bodies.iter_mut().enumerate() {
            body.link_force = links.on(node);
        }
    }

    /// Finds again, after velocities have jumped, the forces of dashpots between floors and the accelerations that belong to all links.
    pub(super) fn relink(&mut self, ground: Ground<'_>) {
        let Some(links) = &mut self.links else {
            return;
        };
        let (bodies, states) = (&self.bodies, &mut self.states);
        self.relinked.fill(false);
        let jumped = |node: usize| self.jumps.has_jumped(node, states);
        links.jump(self.row, states, ground, jumped, &mut self.relinked);
        for node in 0..bodies.len() {
            if self.relinked[node] || self.jumps.feels_jump(self.row, node, states) {
                settle(self.row, links, node, states, ground);
            }
        }
    }
}
