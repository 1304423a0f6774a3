//! Phases: states that events change and that stay constant in between.

use pounding_contact::SLOWEST_APPROACH;

use super::law::Law;
use super::links::LinkPhase;
use super::model::{Model, velocity};
use super::storey::{Branch, sign};

/// Phases of all structures, pairs and links.
#[derive(Debug, Clone)]
pub(super) struct Phases {
    pub structures: Vec<StructurePhase>,
    pub pairs: Vec<PairPhase>,
    pub links: Vec<LinkPhase>,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct StructurePhase {
    /// Sign of the velocity.
    pub direction: f64,
    /// Sign of the drift rate of the storey below; on the ground, the sign of the velocity.
    pub drift_direction: f64,
    /// Sign of the net pounding force while both neighbours touch.
    pub push: Option<f64>,
    /// Sign of the rate of the friction that holds the floor; `None` if it slides in its `direction`, or has no friction.
    pub held: Option<f64>,
    pub branch: Branch,
    /// Sign of the tangent stiffness of columns that yield smoothly.
    pub hardens: f64,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct PairPhase {
    /// Sign of the deformation rate.
    pub direction: f64,
    pub contact: ContactPhase,
    /// Whether the deformation is on the second slope of the law.
    pub bent: bool,
    /// Deformation rate at the first touch of the present contact \[m/s\], at least [`SLOWEST_APPROACH`].
    pub approach_speed: f64,
}

/// Phase of a contact. Impulsive pairs are apart or at rest.
#[derive(Debug, Clone, Copy)]
pub(super) enum ContactPhase {
    Apart,
    /// The deformation grows.
    Approach {
        /// First touch on the clock of the segment \[s\] (negative if earlier); `None` after a second approach.
        touch: Option<f64>,
        /// Sign of the force's rate.
        rising: f64,
    },
    /// The deformation falls.
    Restitution {
        /// Sign of the force's rate.
        rising: f64,
    },
    /// The formula would pull: there is no force.
    Clamped,
    /// An impulsive pair stays together.
    Resting {
        /// Whether a force prevents an overlap; otherwise both sides move alike without a force.
        presses: bool,
        /// Sign of the force's rate.
        rising: f64,
    },
}

impl ContactPhase {
    /// At rest without a force.
    pub(super) const IDLE: Self = Self::Resting {
        presses: false,
        rising: -1.0,
    };

    /// Whether there may be a force.
    pub(super) fn touches(self) -> bool {
        !matches!(self, Self::Apart | Self::Resting { presses: false, .. })
    }

    /// The phase after the deformation rate of a touching pair has changed its sign to `direction`.
    pub(super) fn turned(self, direction: f64) -> Self {
        match self {
            Self::Apart | Self::Resting { .. } => self,
            Self::Approach { .. } | Self::Restitution { .. } | Self::Clamped if direction < 0.0 => Self::Restitution { rising: -1.0 },
            Self::Approach { .. } | Self::Restitution { .. } | Self::Clamped => Self::Approach { touch: None, rising: 1.0 },
        }
    }
}

impl Phases {
    /// Phases at t = 0.
    pub(super) fn new(model: &Model) -> Self {
        let structure = |structure: &super::storey::Structure| {
            let own = structure.initial_velocity;
            let below = structure.below.map(|below| model.structures[below].initial_velocity);
            let drift = model.initial_drift(structure);
            StructurePhase {
                direction: sign(own),
                drift_direction: sign(own - below.unwrap_or(0.0)),
                push: None,
                held: None,
                branch: structure.columns.first_branch(drift),
                hardens: 1.0,
            }
        };
        let pair = |pair: &super::model::Neighbours| {
            let [deformation, rate] = model.initial_deformation(pair);
            let closed = deformation == 0.0 && rate == 0.0;
            PairPhase {
                direction: sign(rate),
                contact: match pair.law {
                    Law::Impulsive { .. } if closed => ContactPhase::IDLE,
                    Law::Impulsive { .. } | Law::Compliant(_) => ContactPhase::Apart,
                },
                bent: false,
                approach_speed: SLOWEST_APPROACH,
            }
        };
        Self {
            structures: model.structures.iter().map(structure).collect(),
            pairs: model.pairs.iter().map(pair).collect(),
            links: model.links.iter().map(|link| LinkPhase::new(link, &model.structures)).collect(),
        }
    }

    /// Whether a pair is at rest with a force.
    pub(super) fn presses(&self, pair: usize) -> bool {
        let contact = self.pairs[pair].contact;
        matches!(contact, ContactPhase::Resting { presses: true, .. })
    }

    /// Turns a structure, and with it a storey on the ground.
    pub(super) fn turn(&mut self, structure: usize, model: &Model, unknowns: &[f64]) {
        let phase = &mut self.structures[structure];
        phase.direction = -phase.direction;
        if model.structures[structure].below.is_none() {
            self.turn_drift(structure, model, unknowns);
        }
    }

    /// Turns the drift of a storey; yielding columns unload.
    pub(super) fn turn_drift(&mut self, structure: usize, model: &Model, unknowns: &[f64]) {
        let phase = &mut self.structures[structure];
        phase.drift_direction = -phase.drift_direction;
        if let Branch::Yielding { force } = phase.branch
            && force * phase.drift_direction < 0.0
        {
            let drift = model.drift(structure, unknowns);
            phase.branch = model.structures[structure].columns.unloading(force, drift);
        }
        self.structures[structure].hardens = sign(self.tangent(structure, model, unknowns));
    }

    /// Tangent stiffness of columns that yield smoothly \[N/m\]; 0 for others.
    pub(super) fn tangent(&self, structure: usize, model: &Model, unknowns: &[f64]) -> f64 {
        let StructurePhase {
            branch, drift_direction, ..
        } = self.structures[structure];
        let columns = &model.structures[structure].columns;
        match (branch, columns.smooth) {
            (Branch::Smooth { side }, Some(smooth)) => {
                let bend = columns.bend(smooth, unknowns[smooth.unknown], side, drift_direction);
                columns.stiffness * (columns.hardening + (1.0 - columns.hardening) * bend)
            }
            (Branch::Smooth { .. } | Branch::Elastic { .. } | Branch::Yielding { .. }, _) => 0.0,
        }
    }

    /// Changes the sign of the elastic part of the drift of columns that yield smoothly.
    pub(super) fn straighten(&mut self, structure: usize) {
        if let Branch::Smooth { side } = &mut self.structures[structure].branch {
            *side = -*side;
        }
    }

    /// Updates all directions after velocity jumps.
    pub(super) fn redirect(&mut self, model: &Model, unknowns: &[f64]) {
        for index in 0..self.structures.len() {
            let direction = sign(unknowns[velocity(index)]);
            if direction * self.structures[index].direction < 0.0 {
                self.turn(index, model, unknowns);
            }
            let drifting = sign(model.drift_rate(index, unknowns));
            if drifting * self.structures[index].drift_direction < 0.0 {
                self.turn_drift(index, model, unknowns);
            }
        }
        for index in 0..self.pairs.len() {
            let direction = sign(model.rate(index, unknowns));
            let phase = &mut self.pairs[index];
            if direction * phase.direction < 0.0 {
                phase.contact = phase.contact.turned(direction);
            }
            phase.direction = direction;
        }
    }

    /// Sets the clock back by `length` \[s\] at the start of a new segment.
    pub(super) fn shift(&mut self, length: f64) {
        for phase in &mut self.pairs {
            if let ContactPhase::Approach { touch: Some(touch), .. } = &mut phase.contact {
                *touch -= length;
            }
        }
    }
}
