//! Motion of links: their forces in the equations, and their changes at events.

use super::equations::Equations;
use super::links::{Branch, Change, Law, LinkPhase, unloaded};
use super::model::{TIME, displacement, velocity};
use super::storey::{self, StoreyColumns};

impl Equations {
    /// δ of a link \[m\].
    pub(super) fn link_deformation(&self, link: usize, y: &[f64]) -> f64 {
        let ends = &self.model.links[link].ends;
        ends.ahead(|floor| y[displacement(floor)]) + self.segment.farther(ends.grounds(), y[TIME])
    }

    /// Rate of the deformation of a link \[m/s\].
    fn link_rate(&self, link: usize, y: &[f64]) -> f64 {
        let ends = &self.model.links[link].ends;
        ends.ahead(|floor| y[velocity(floor)]) + self.segment.faster(ends.grounds(), y[TIME])
    }

    /// Force of a link \[N\].
    pub(super) fn link_force(&self, link: usize, y: &[f64]) -> f64 {
        let deformation = self.link_deformation(link, y);
        match (&self.model.links[link].law, self.phases.links[link].branch) {
            (Law::Spring { columns, damping }, Branch::Spring(branch)) => {
                columns.force(branch, deformation, y) + damping * self.link_rate(link, y)
            }
            (Law::Restrainer(restrainer), Branch::Taut { free }) => restrainer.stiffness * (deformation + free),
            (Law::Restrainer(restrainer), Branch::Yields) => -restrainer.yield_force,
            (Law::Braced { unknown, .. }, _) => y[*unknown],
            (Law::Spring { .. } | Law::Restrainer(_), _) => 0.0,
        }
    }

    /// Adds the forces of links on floors, and sets the rates of forces that are unknowns.
    pub(super) fn pull(&self, y: &[f64], dy: &mut [f64]) {
        for (index, link) in self.model.links.iter().enumerate() {
            let force = self.link_force(index, y);
            for (floor, part) in link.ends.parts() {
                dy[velocity(floor)] -= part * force;
            }
            if let (Law::Braced { damper, unknown }, Branch::Flows { side }) = (&link.law, self.phases.links[index].branch) {
                let mut flow = side;
                for _ in 0..damper.inverse_exponent {
                    flow *= side * force / damper.coefficient;
                }
                dy[*unknown] = damper.stiffness * (self.link_rate(index, y) - flow);
            }
        }
    }

    /// Yielding part of the force of a link that is a spring \[N\].
    fn yielding_link(&self, columns: &StoreyColumns, link: usize, y: &[f64]) -> f64 {
        let Branch::Spring(branch) = self.phases.links[link].branch else {
            return 0.0;
        };
        let deformation = self.link_deformation(link, y);
        columns.yielding_part(columns.force(branch, deformation, y), deformation)
    }

    /// A number that is negative once a link has changed.
    pub(super) fn before_change(&self, link: usize, change: Change, y: &[f64]) -> f64 {
        let LinkPhase { direction, branch } = self.phases.links[link];
        let elongation = || -self.link_deformation(link, y);
        match (change, branch, &self.model.links[link].law) {
            (Change::Turns, ..) => direction * self.link_rate(link, y),
            (Change::Yields, _, Law::Spring { columns, .. }) => columns.limit() - direction * self.yielding_link(columns, link, y),
            (Change::Yields, _, Law::Restrainer(restrainer)) => restrainer.yield_force + self.link_force(link, y),
            (Change::Tightens, Branch::Slack { free }, _) => free - elongation(),
            (Change::LetsGo, Branch::Taut { free }, _) => elongation() - free,
            (Change::Crosses, Branch::Flows { side }, _) => side * self.link_force(link, y),
            // Another change at the same instant came first.
            (Change::Yields | Change::Tightens | Change::LetsGo | Change::Crosses, ..) => 0.0,
        }
    }

    /// Changes a link.
    pub(super) fn change_link(&mut self, link: usize, change: Change, y: &[f64]) {
        let LinkPhase { direction, branch } = self.phases.links[link];
        let after = match (change, branch, &self.model.links[link].law) {
            (Change::Turns, ..) => {
                self.turn_link(link, y);
                return;
            }
            (Change::Yields, _, Law::Spring { columns, .. }) if direction * self.yielding_link(columns, link, y) > 0.0 => {
                let force = direction * columns.limit();
                Branch::Spring(storey::Branch::Yielding { force })
            }
            (Change::Yields, Branch::Taut { .. }, Law::Restrainer(_)) if direction < 0.0 => Branch::Yields,
            (Change::Tightens, Branch::Slack { free }, _) if direction < 0.0 => Branch::Taut { free },
            (Change::LetsGo, Branch::Taut { free }, _) if direction > 0.0 => Branch::Slack { free },
            (Change::Crosses, Branch::Flows { side }, _) => Branch::Flows { side: -side },
            // The link turned at the same instant.
            _ => return,
        };
        self.phases.links[link].branch = after;
    }

    /// Turns the deformation of a link; a link that yields unloads.
    fn turn_link(&mut self, link: usize, y: &[f64]) {
        let deformation = self.link_deformation(link, y);
        let phase = &mut self.phases.links[link];
        phase.direction = -phase.direction;
        match (&self.model.links[link].law, phase.branch) {
            (Law::Spring { columns, .. }, Branch::Spring(storey::Branch::Yielding { force })) if force * phase.direction < 0.0 => {
                phase.branch = Branch::Spring(columns.unloading(force, deformation));
            }
            (Law::Restrainer(restrainer), Branch::Yields) if phase.direction > 0.0 => {
                let free = unloaded(restrainer, -deformation);
                phase.branch = Branch::Taut { free };
            }
            _ => {}
        }
    }

    /// Updates the directions of links after velocity jumps.
    pub(super) fn redirect_links(&mut self, y: &[f64]) {
        for link in 0..self.phases.links.len() {
            if self.link_rate(link, y) * self.phases.links[link].direction < 0.0 {
                self.turn_link(link, y);
            }
        }
    }
}
