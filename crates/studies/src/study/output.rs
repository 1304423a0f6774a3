//! Outputs of studies.

use pounding_scene::Ladder;
use serde::{Deserialize, Serialize};

use super::laws::AtlasSettings;
use super::other_motions::BeyondSettings;
use super::stress::Edges;
use super::surveys::Survey;

/// The output of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Output {
    /// Dynamic characteristics of the structures of the first scene.
    StructuresTable,
    /// Time and force of every impact, or of every step in contact, one block per scene.
    PoundingForcesTable {
        /// Number of collisions to print, if the paper prints only the first ones.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        n_collisions: Option<usize>,
        /// Offset added to every printed time \[s\].
        #[serde(default)]
        label_offset_s: f64,
    },
    /// Impulse of the first collision of every scene.
    FirstCollisionTable,
    /// Transferred momentum of every structure of every scene.
    TransferredMomentumTable,
    /// Single numbers of the running text.
    TextTable {
        /// Scenes whose first structure's transferred momentum is printed.
        transferred_momentum: Vec<String>,
        /// Scenes whose first two collisions' peak forces are printed.
        peak_forces: Vec<String>,
    },
    /// No file. The scenes serve to test the paper's claims.
    Claims,
    /// A folder with the error against the work of every method on every scene.
    Trade(Ladder),
    /// A folder with the restitution that every contact law delivers, and its results in every scene.
    Laws(AtlasSettings),
    /// A folder with the results of extreme scenes.
    Extremes(Edges),
    /// A folder with the paper's scenes and claims under other ground motions.
    Beyond(BeyondSettings),
    /// A folder with the answers of thousands of runs to one question; the scenes are templates. [`SurveyStudy`](crate::SurveyStudy) makes
    /// it, not `reproduce`.
    Survey(Survey),
    /// The record of the first scene.
    RecordFigure,
    /// Displacements of the structures of the first scene, one panel each.
    DisplacementFigure,
    /// Displacements above pounding forces, for the structures of the first scene.
    PoundingFigure,
    /// Pounding force of the first collision, one panel per scene.
    FirstCollisionFigure,
    /// Drawings of the rows of all scenes.
    LayoutFigure,
    /// Shear force of one structure in every scene.
    ShearForceFigure {
        /// Name of the structure.
        structure: String,
    },
}

impl Output {
    /// The ladder of a trade study, else `None`.
    pub(crate) fn ladder(&self) -> Option<&Ladder> {
        if let Self::Trade(ladder) = self { Some(ladder) } else { None }
    }

    /// The list of other ground motions, else `None`.
    pub(crate) fn beyond(&self) -> Option<&BeyondSettings> {
        if let Self::Beyond(settings) = self { Some(settings) } else { None }
    }

    /// Whether the output shows step-by-step histories.
    pub(crate) fn needs_histories(&self) -> bool {
        self.shows_steps() || matches!(self, Self::DisplacementFigure | Self::ShearForceFigure { .. })
    }

    /// Whether the output shows details of a method's steps, such as the force of an impact as impulse over time step.
    pub(crate) fn shows_steps(&self) -> bool {
        matches!(
            self,
            Self::Claims | Self::PoundingForcesTable { .. } | Self::PoundingFigure | Self::FirstCollisionFigure
        )
    }
}
