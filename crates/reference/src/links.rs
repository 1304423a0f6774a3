//! Links between floors, each law written from its rule.
//!
//! δ is the deformation, the left end minus the right one, with the grounds below them. The force F is positive if it pushes both ends
//! apart.

use pounding_solver::{self as solver, Hysteresis, Knee, LinkLaw};

use super::SecondRouteError;
use super::ends::Ends;
use super::equations::Equations;
use super::model::{Model, Structure, TIME, displacement, velocity};
use super::storey::{self, StoreyColumns, sign};

/// A link between two points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub ends: Ends,
    law: Law,
}

#[derive(Debug, Clone, Copy)]
enum Law {
    /// Columns between the ends, and a dashpot c \[N·s/m\] beside them.
    Spring {
        columns: StoreyColumns,
        damping: f64,
    },
    Restrainer(solver::Restrainer),
    /// Ḟ = k (δ̇ − sgn F (|F|/c)ᵐ).
    Braced {
        damper: solver::Braced,
        /// Index of F in the vector of unknowns.
        unknown: usize,
    },
}

/// Phase of a link.
#[derive(Debug, Clone, Copy)]
pub(super) struct LinkPhase {
    /// Sign of the rate of deformation.
    direction: f64,
    branch: Branch,
}

/// Branch of a link. `free` is the elongation −δ from which a restrainer pulls \[m\].
#[derive(Debug, Clone, Copy)]
enum Branch {
    Spring(storey::Branch),
    Slack {
        free: f64,
    },
    Taut {
        free: f64,
    },
    /// A restrainer pulls with its yield force.
    Yields,
    /// A damper with a brace while its force has the sign `side`.
    Flows {
        side: f64,
    },
}

/// A change of a link that ends a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Change {
    /// The rate of deformation changes its sign.
    Turns,
    /// A spring or a restrainer reaches its yield force.
    Yields,
    /// A restrainer begins to pull.
    Tightens,
    /// A restrainer lets go.
    LetsGo,
    /// The force of a damper changes its sign.
    Crosses,
}

impl Link {
    /// Link `index` of a row.
    pub(super) fn new(index: usize, link: &solver::Link, structures: &mut Vec<Structure>) -> Result<Self, SecondRouteError> {
        let law = match link.law {
            LinkLaw::Spring(spring) => Law::Spring {
                columns: StoreyColumns::of(Hysteresis {
                    stiffness: spring.stiffness,
                    hardening: spring.hardening,
                    yield_force: spring.yield_force,
                    knee: Knee::Sharp,
                }),
                damping: spring.damping,
            },
            LinkLaw::Restrainer(restrainer) => Law::Restrainer(restrainer),
            // The model numbers the unknown.
            LinkLaw::Braced(damper) => Law::Braced { damper, unknown: 0 },
            LinkLaw::Viscous(_) => return Err(SecondRouteError::NoBrace { link: index }),
        };
        let ends = Ends::new(link.relation, structures);
        Ok(Self { ends, law })
    }

    /// Numbers the unknowns from `next`; returns how many there are.
    pub(super) fn number(&mut self, next: usize) -> usize {
        match &mut self.law {
            Law::Braced { unknown, .. } => {
                *unknown = next;
                1
            }
            Law::Spring { .. } | Law::Restrainer(_) => 0,
        }
    }

    /// Index of a force that is an unknown.
    pub(super) fn unknown(&self) -> Option<usize> {
        match self.law {
            Law::Braced { unknown, .. } => Some(unknown),
            Law::Spring { .. } | Law::Restrainer(_) => None,
        }
    }

    /// Largest stiffness \[N/m\], and coefficient of the dashpot \[N·s/m\].
    pub(super) fn rates(&self) -> [f64; 2] {
        match self.law {
            Law::Spring { columns, damping } => [columns.stiffness, damping],
            Law::Restrainer(restrainer) => [restrainer.stiffness, 0.0],
            Law::Braced { damper, .. } => [damper.stiffness, 0.0],
        }
    }
}

/// Elongation from which a restrainer pulls, once it has yielded at an elongation \[m\].
fn unloaded(restrainer: &solver::Restrainer, elongation: f64) -> f64 {
    elongation - restrainer.yield_force / restrainer.stiffness
}

impl LinkPhase {
    /// The phase at t = 0, when grounds are at rest.
    pub(super) fn new(link: &Link, model: &Model) -> Self {
        let deformation = link.ends.ahead(|floor| model.structures[floor].initial_displacement);
        let direction = sign(link.ends.ahead(|floor| model.structures[floor].initial_velocity));
        let branch = match &link.law {
            Law::Spring { columns, .. } => Branch::Spring(columns.first_branch(deformation)),
            Law::Restrainer(restrainer) => {
                let [elongation, free] = [-deformation, restrainer.slack];
                if elongation <= free {
                    Branch::Slack { free }
                } else {
                    let free = free.max(unloaded(restrainer, elongation));
                    Branch::Taut { free }
                }
            }
            Law::Braced { .. } => Branch::Flows { side: direction },
        };
        Self { direction, branch }
    }

    /// The changes that can come next.
    pub(super) fn changes(&self, link: &Link) -> [Option<Change>; 2] {
        let lengthens = self.direction < 0.0;
        match (self.branch, &link.law) {
            (Branch::Spring(branch), Law::Spring { columns, .. }) if columns.yield_force.is_finite() => {
                let yields = matches!(branch, storey::Branch::Elastic { .. }).then_some(Change::Yields);
                [Some(Change::Turns), yields]
            }
            // Every change of the sign of the rate ends a step.
            (Branch::Slack { .. }, _) => [Some(Change::Turns), lengthens.then_some(Change::Tightens)],
            (Branch::Taut { .. }, _) if lengthens => [Some(Change::Turns), Some(Change::Yields)],
            (Branch::Taut { .. }, _) => [Some(Change::Turns), Some(Change::LetsGo)],
            (Branch::Yields, _) => [Some(Change::Turns), None],
            // An odd power needs no sign.
            (Branch::Flows { .. }, Law::Braced { damper, .. }) if damper.inverse_exponent % 2 == 0 => [Some(Change::Crosses), None],
            (Branch::Spring(_) | Branch::Flows { .. }, _) => [None; 2],
        }
    }
}

impl Equations {
    /// δ of a link \[m\].
    fn link_deformation(&self, link: usize, y: &[f64]) -> f64 {
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
