//! What is decided by events and stays as it is between them.

use pounding_contact::SLOWEST_APPROACH;

use super::model::{Model, displacement, velocity};

/// Sign of a number as a factor, 1 or −1.
///
/// Zero counts as negative: if the number then rises, that is an event like any other, at once.
pub(super) fn sign(value: f64) -> f64 {
    if value > 0.0 { 1.0 } else { -1.0 }
}

/// Phases of all structures and pairs.
#[derive(Debug, Clone)]
pub(super) struct Phases {
    pub structures: Vec<StructurePhase>,
    pub pairs: Vec<PairPhase>,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct StructurePhase {
    /// Sign of the velocity.
    pub direction: f64,
    /// Sign of the net pounding force while both neighbours touch.
    pub push: Option<f64>,
    pub columns: Columns,
}

/// Branch of the columns.
#[derive(Debug, Clone, Copy)]
pub(super) enum Columns {
    Elastic { plastic_displacement: f64 },
    Yielding { force: f64 },
}

#[derive(Debug, Clone, Copy)]
pub(super) struct PairPhase {
    /// Sign of the deformation rate.
    pub direction: f64,
    pub contact: Contact,
    /// Deformation rate at the first touch of the present contact \[m/s\], not below [`SLOWEST_APPROACH`].
    pub approach_speed: f64,
}

/// Phase of a contact; impulsive pairs always stand apart.
#[derive(Debug, Clone, Copy)]
pub(super) enum Contact {
    Apart,
    /// The deformation grows.
    Approach {
        /// First touch on the clock of the segment \[s\] (negative when earlier); nothing after a second approach.
        touch: Option<f64>,
        /// Sign of the force's rate.
        rising: f64,
    },
    /// The deformation falls.
    Restitution {
        /// Sign of the force's rate.
        rising: f64,
    },
    /// The formula would pull: no force.
    Clamped,
}

impl Contact {
    pub(super) fn touches(self) -> bool {
        !matches!(self, Self::Apart)
    }
}

impl Phases {
    /// Phases at t = 0.
    pub(super) fn new(model: &Model) -> Self {
        let structure = |structure: &super::model::Structure| {
            let force = structure.stiffness * structure.initial_displacement;
            let excess = force - force.clamp(-structure.yield_force, structure.yield_force);
            let plastic_displacement = if excess == 0.0 {
                0.0
            } else {
                excess / structure.stiffness
            };
            StructurePhase {
                direction: sign(structure.initial_velocity),
                push: None,
                columns: Columns::Elastic {
                    plastic_displacement,
                },
            }
        };
        let pair = |pair: &super::model::Neighbours| {
            let speed = |index: usize| model.structures[index].initial_velocity;
            PairPhase {
                direction: sign(speed(pair.left) - speed(pair.right)),
                contact: Contact::Apart,
                approach_speed: SLOWEST_APPROACH,
            }
        };
        Self {
            structures: model.structures.iter().map(structure).collect(),
            pairs: model.pairs.iter().map(pair).collect(),
        }
    }

    /// Turns a structure; yielding columns unload.
    pub(super) fn turn(&mut self, structure: usize, model: &Model, unknowns: &[f64]) {
        let phase = &mut self.structures[structure];
        phase.direction = -phase.direction;
        if let Columns::Yielding { force } = phase.columns
            && force * phase.direction < 0.0
        {
            let elastic = force / model.structures[structure].stiffness;
            phase.columns = Columns::Elastic {
                plastic_displacement: unknowns[displacement(structure)] - elastic,
            };
        }
    }

    /// Takes all directions anew after velocities have jumped.
    ///
    /// A pair that approaches by no more than `noise` \[m/s\] does not.
    pub(super) fn redirect(&mut self, model: &Model, unknowns: &[f64], noise: f64) {
        for index in 0..self.structures.len() {
            let direction = sign(unknowns[velocity(index)]);
            if direction * self.structures[index].direction < 0.0 {
                self.turn(index, model, unknowns);
            }
        }
        for index in 0..self.pairs.len() {
            self.pairs[index].direction = sign(model.rate(index, unknowns) - noise);
        }
    }

    /// Sets the clock back at the start of a new segment, after one of `length` \[s\].
    pub(super) fn shift(&mut self, length: f64) {
        for phase in &mut self.pairs {
            if let Contact::Approach {
                touch: Some(touch), ..
            } = &mut phase.contact
            {
                *touch -= length;
            }
        }
    }
}
