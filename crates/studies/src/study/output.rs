//! What a study prints.

use pounding_scene::Ladder;
use serde::{Deserialize, Serialize};

use super::laws::AtlasSettings;
use super::other_motions::BeyondSettings;
use super::stress::Edges;
use super::surveys::Survey;

/// What a study prints of its scenes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Output {
    /// Dynamic characteristics of the structures of the first scene.
    StructuresTable,
    /// Time and force of every impact, or of every step in contact, one block per scene.
    PoundingForcesTable {
        /// Only the first collisions, where the paper prints no more.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        n_collisions: Option<usize>,
        /// Added to every printed time \[s\].
        #[serde(default)]
        label_offset_s: f64,
    },
    /// Impulse of the first collision of every scene.
    FirstCollisionTable,
    /// Transferred momentum of every structure of every scene.
    TransferredMomentumTable,
    /// Single numbers of the running text.
    TextTable {
        /// Scenes of which the transferred momentum of the first structure is printed.
        transferred_momentum: Vec<String>,
        /// Scenes of which the peak forces of the first two collisions are printed.
        peak_forces: Vec<String>,
    },
    /// Nothing of its own: the scenes are needed to test the paper's claims.
    Claims,
    /// Error against work of every method on every scene; a folder of its own.
    Trade(Ladder),
    /// What every contact law delivers, and what it does in every scene; a folder of its own.
    Laws(AtlasSettings),
    /// What becomes of the scenes at the edge; a folder of its own.
    Extremes(Edges),
    /// The paper's scenes under other ground motions, and its claims; a folder of its own.
    Beyond(BeyondSettings),
    /// One question asked of thousands of runs of which the scenes are templates; a folder of its own, which
    /// [`SurveyStudy`](crate::SurveyStudy) makes and `reproduce` does not.
    Survey(Survey),
    /// The record of the first scene.
    RecordFigure,
    /// Displacements of the structures of the first scene, a panel each.
    DisplacementFigure,
    /// Displacements of the structures above, pounding forces below, of the first scene.
    PoundingFigure,
    /// Pounding force of the first collision, a panel per scene.
    FirstCollisionFigure,
    /// The rows of all scenes, drawn.
    LayoutFigure,
    /// Shear force of the structure of this name in every scene.
    ShearForceFigure {
        /// Name of the structure.
        structure: String,
    },
}

impl Output {
    /// The ladder of a trade study.
    pub(crate) fn ladder(&self) -> Option<&Ladder> {
        if let Self::Trade(ladder) = self { Some(ladder) } else { None }
    }

    /// The ground motions beyond the paper's.
    pub(crate) fn beyond(&self) -> Option<&BeyondSettings> {
        if let Self::Beyond(settings) = self { Some(settings) } else { None }
    }

    /// Whether the output shows what happened step by step.
    pub(crate) fn needs_histories(&self) -> bool {
        self.shows_steps() || matches!(self, Self::DisplacementFigure | Self::ShearForceFigure { .. })
    }

    /// Whether the output shows what a method did in a step, such as the force of an impact as impulse over time step.
    pub(crate) fn shows_steps(&self) -> bool {
        matches!(
            self,
            Self::Claims | Self::PoundingForcesTable { .. } | Self::PoundingFigure | Self::FirstCollisionFigure
        )
    }
}
