//! Words for the structures of a row in sentences.

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
