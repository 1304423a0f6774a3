//! What is changed in the paper's scenes besides the ground motion.

use std::fmt;

use pounding_motion::Record;
use serde::{Deserialize, Serialize};

use super::twin::building;
use pounding_scene::{Scene, Structure};

/// A change under which the paper's claims are asked once more.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Buildings of so many storeys in place of the structures, 2 to 20.
    Storeys(usize),
    /// Every motion multiplied by this \[–\], between 0 and 1; gaps, yield forces and contact laws stay.
    Weaker(f64),
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Storeys(count) => write!(f, "buildings of {count} storeys"),
            Self::Weaker(part) => write!(f, "motions multiplied by {part}"),
        }
    }
}

/// Most storeys: more would take long and tell nothing of the paper's structures.
const MOST_STOREYS: usize = 20;

impl Change {
    /// Its own folder, and the end of its columns; a list has one change of a kind.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Storeys(_) => "storeys",
            Self::Weaker(_) => "weaker",
        }
    }

    /// Whether it takes so long that `reproduce` leaves it to `cargo xtask beyond`, whose results are known by their hashes.
    pub(crate) fn is_long(self) -> bool {
        matches!(self, Self::Storeys(_))
    }

    /// What was found and what is allowed, where it is not allowed.
    pub(crate) fn fault(self) -> Option<(String, &'static str)> {
        match self {
            Self::Storeys(count) if !(2..=MOST_STOREYS).contains(&count) => Some((format!("storeys: {count}"), "2 to 20")),
            Self::Weaker(part) if !(part > 0.0 && part < 1.0) => Some((format!("weaker: {part}"), "a number between 0 and 1")),
            Self::Storeys(_) | Self::Weaker(_) => None,
        }
    }

    /// The scene that runs in place of a scene of the paper. Its name stays: by it the claims find their scenes.
    pub(crate) fn of_scene(self, mut scene: Scene) -> Scene {
        if let Self::Storeys(count) = self {
            for structure in &mut scene.structures {
                if let Structure::Sdof(sdof) = structure {
                    *structure = Structure::Building(building(sdof, count));
                }
            }
        }
        scene
    }

    /// The motion that shakes it.
    pub(crate) fn of_record(self, record: Record) -> Record {
        match self {
            Self::Storeys(_) => record,
            Self::Weaker(part) => record.scaled(part).expect("less than a record of finite numbers is finite"),
        }
    }
}
