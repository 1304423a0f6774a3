//! Columns of rows in which some storeys yield at a sharp knee and others smoothly.

use crate::{Bent, Bilinear, BoucWen, Hysteresis, Hysteretic, Response, RestoringForce, Sliding};

/// Columns that yield at a sharp knee, smoothly, or never, with a common memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mixed {
    /// Columns that yield at a sharp knee, or never.
    Sharp(Bilinear),
    /// Columns that yield smoothly.
    Smooth(BoucWen),
    /// Columns that stick and slide.
    Sliding(Sliding),
}

impl RestoringForce for Mixed {
    /// For sharp columns, the drift is unused and the elastic part holds the plastic displacement.
    type Memory = Bent;

    fn untouched(&self) -> Bent {
        Bent::default()
    }

    #[inline]
    fn respond(&self, displacement: f64, memory: Bent) -> Response<Bent> {
        match self {
            Self::Sharp(column) => sharp(displacement, column.respond(displacement, memory.elastic)),
            Self::Smooth(column) => column.respond(displacement, memory),
            Self::Sliding(column) => Response {
                force: column.respond(displacement, ()).force,
                tangent: column.stiffness,
                memory,
            },
        }
    }

    fn loaded(&self, displacement: f64) -> Response<Bent> {
        match self {
            Self::Sharp(column) => sharp(displacement, column.loaded(displacement)),
            Self::Smooth(column) => column.loaded(displacement),
            Self::Sliding(_) => self.respond(displacement, self.untouched()),
        }
    }
}

/// The response of sharp columns, with their memory in the form of smooth columns.
fn sharp(drift: f64, response: Response<f64>) -> Response<Bent> {
    let Response {
        force,
        tangent,
        memory: elastic,
    } = response;
    Response {
        force,
        tangent,
        memory: Bent { drift, elastic },
    }
}

impl Hysteretic for Mixed {
    fn hysteresis(&self) -> Hysteresis {
        match self {
            Self::Sharp(column) => column.hysteresis(),
            Self::Smooth(column) => column.hysteresis(),
            Self::Sliding(column) => column.hysteresis(),
        }
    }
}
