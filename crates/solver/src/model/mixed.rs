//! Columns of rows in which some storeys yield at one point and others smoothly.

use crate::{Bent, Bilinear, BoucWen, Hysteresis, Hysteretic, Response, RestoringForce};

/// Columns that yield at one point, or never, or smoothly; what they remember is that of either.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mixed {
    /// That yield at one point, or never.
    Sharp(Bilinear),
    /// That yield smoothly.
    Smooth(BoucWen),
}

impl RestoringForce for Mixed {
    /// Of sharp columns the drift is not used, and the elastic part holds the plastic one.
    type Memory = Bent;

    fn untouched(&self) -> Bent {
        Bent::default()
    }

    #[inline]
    fn respond(&self, displacement: f64, memory: Bent) -> Response<Bent> {
        match self {
            Self::Sharp(column) => sharp(displacement, column.respond(displacement, memory.elastic)),
            Self::Smooth(column) => column.respond(displacement, memory),
        }
    }

    fn loaded(&self, displacement: f64) -> Response<Bent> {
        match self {
            Self::Sharp(column) => sharp(displacement, column.loaded(displacement)),
            Self::Smooth(column) => column.loaded(displacement),
        }
    }
}

/// What sharp columns answer, with what they remember where smooth ones have it.
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
        }
    }
}
