//! Words for the structures of a row in sentences.

use crate::file::link::Law;
use crate::{Scene, Structure};

/// Words for the structures of a row and their storeys. A structure without storeys may be a deck or a tank.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RowWords {
    /// "building", or "structure" if none has storeys.
    pub building: &'static str,
    /// "storey" or "structure".
    pub storey: &'static str,
    /// How structures stand between which nothing touches: "alone", or "while nothing touches" if links tie them.
    pub alone: &'static str,
}

impl Scene {
    /// Whether a contact has a seat.
    pub fn has_seats(&self) -> bool {
        self.contacts.iter().flatten().any(|one| one.seat_width_m.is_some())
    }

    /// Whether decks of a bridge stand in the row, by seats or restrainers.
    pub fn is_bridge(&self) -> bool {
        self.has_seats() || self.links.iter().any(|one| matches!(one.law, Law::Restrainer { .. }))
    }

    /// Words for the structures of the row and their storeys.
    pub fn words(&self) -> RowWords {
        let is_building = |one: &Structure| matches!(one, Structure::Building(_));
        let [building, storey] = if self.structures.iter().any(is_building) {
            ["building", "storey"]
        } else {
            ["structure"; 2]
        };
        let alone = if self.links.is_empty() { "alone" } else { "while nothing touches" };
        RowWords { building, storey, alone }
    }
}
