//! Links between floors, each law written from its rule.
//!
//! δ is the deformation, the left end minus the right one, with the grounds below them. The force F is positive if it pushes both ends
//! apart.

use pounding_solver::{self as solver, Hysteresis, Knee, LinkLaw};

use super::SecondRouteError;
use super::ends::Ends;
use super::storey::Structure;
use super::storey::{self, StoreyColumns, sign};

/// A link between two points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub ends: Ends,
    pub(super) law: Law,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Law {
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
    pub(super) direction: f64,
    pub(super) branch: Branch,
}

/// Branch of a link. `free` is the elongation −δ from which a restrainer pulls \[m\].
#[derive(Debug, Clone, Copy)]
pub(super) enum Branch {
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
pub(super) fn unloaded(restrainer: &solver::Restrainer, elongation: f64) -> f64 {
    elongation - restrainer.yield_force / restrainer.stiffness
}

impl LinkPhase {
    /// The phase at t = 0, when grounds are at rest.
    pub(super) fn new(link: &Link, structures: &[Structure]) -> Self {
        let deformation = link.ends.ahead(|floor| structures[floor].initial_displacement);
        let direction = sign(link.ends.ahead(|floor| structures[floor].initial_velocity));
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
            // An odd power needs no sign.
            (Branch::Flows { .. }, Law::Braced { damper, .. }) if damper.inverse_exponent % 2 == 0 => {
                [Some(Change::Turns), Some(Change::Crosses)]
            }
            // Without a change of branch it is the peak of its deformation.
            (Branch::Yields | Branch::Spring(_) | Branch::Flows { .. }, _) => [Some(Change::Turns), None],
        }
    }
}
