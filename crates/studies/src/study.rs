//! A study: scenes, and what to print of them. One JSON file per table or figure.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::file::read_file;
use crate::paper::{PapersProgram, Program};
use crate::{AtlasSettings, BeyondSettings, Edges, Ladder, Scene, StudyError, Survey};

/// Scenes and what to print of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// What the table or figure shows.
    pub title: String,
    /// Choices the paper does not state, and where they come from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub notes: Option<String>,
    /// The paper's program, which then runs the scenes that name the central difference method.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<PapersProgram>,
    /// The scenes, in the order of the table or figure; none for [`Output::Beyond`], which takes those of other studies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub scenes: Vec<Scene>,
    /// What to print.
    pub output: Output,
}

impl Study {
    /// The program that runs a scene of it instead of the scene's method, where there is one.
    pub(crate) fn program_of(&self, scene: &Scene) -> Option<Program> {
        self.program.as_ref()?.of(scene)
    }
}

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

/// A study with the file it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyFile {
    /// Name of the file without ending, for example `table-2`.
    pub id: String,
    /// The file.
    pub path: PathBuf,
    /// What it holds.
    pub study: Study,
}

impl StudyFile {
    /// Reads one study.
    ///
    /// # Errors
    /// [`StudyError`] naming the file and the field.
    pub fn read(path: &Path) -> Result<Self, StudyError> {
        let study: Study = read_file(path)?;
        let refuse = |found: String, allowed| StudyError::Study {
            path: path.to_path_buf(),
            place: "scenes",
            found,
            allowed,
        };
        match (study.output.beyond(), study.scenes.len()) {
            (None, 0) => return Err(refuse("none".into(), "one or more scenes")),
            (Some(_), 1..) => {
                let allowed = "none: those of the paper's tables are run";
                return Err(refuse(study.scenes.len().to_string(), allowed));
            }
            (None, _) | (Some(_), 0) => {}
        }
        let mut names = BTreeSet::new();
        if let Some(twice) = study.scenes.iter().find(|scene| !names.insert(&scene.name)) {
            return Err(refuse(
                format!("\"{}\" twice", twice.name),
                "names that differ",
            ));
        }
        let id = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        Ok(Self {
            id,
            path: path.to_path_buf(),
            study,
        })
    }

    /// Reads every `*.json` of a folder, in the order of their names.
    ///
    /// # Errors
    /// [`StudyError`] for the first file that cannot be read.
    pub fn read_all(folder: &Path) -> Result<Vec<Self>, StudyError> {
        let unreadable = |source| StudyError::Unreadable {
            path: folder.to_path_buf(),
            source,
        };
        let mut paths = Vec::new();
        for entry in std::fs::read_dir(folder).map_err(unreadable)? {
            let path = entry.map_err(unreadable)?.path();
            if path
                .extension()
                .is_some_and(|extension| extension == "json")
            {
                paths.push(path);
            }
        }
        paths.sort();
        paths.iter().map(|path| Self::read(path)).collect()
    }

    /// Folder that the files named in its scenes are relative to.
    pub fn base(&self) -> &Path {
        self.path.parent().unwrap_or_else(|| Path::new(""))
    }
}
