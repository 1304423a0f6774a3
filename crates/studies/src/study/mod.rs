//! Studies: scenes and the output to print of them. Each table or figure has one JSON file.

pub(crate) mod axis;
pub(crate) mod change;
pub(crate) mod completed;
pub(crate) mod laws;
pub(crate) mod other_motions;
pub(crate) mod output;
pub(crate) mod stress;
pub(crate) mod surveys;

use pounding_text::Refused;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use pounding_scene::{Scene, file};

use crate::program::{PapersProgram, Program};
use crate::{BeyondSettings, StudyError};
pub use output::Output;

/// Scenes and the output to print of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// Contents of the table or figure, in words.
    pub title: String,
    /// Choices that the paper does not state, with their origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub notes: Option<String>,
    /// The paper's program. If set, it runs the scenes that name the central difference method.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<PapersProgram>,
    /// The scenes, in the order of the table or figure. [`Output::Beyond`] has none: it takes those of other studies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub scenes: Vec<Scene>,
    /// The output.
    pub output: Output,
}

impl Study {
    /// The program that runs a scene in place of the scene's method, if any.
    pub(crate) fn program_of(&self, scene: &Scene) -> Option<Program> {
        self.program.as_ref()?.of(scene)
    }
}

/// A study with its file.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyFile {
    /// Name of the file without its extension, for example `table-2`.
    pub id: String,
    /// The file.
    pub path: PathBuf,
    /// The contents of the file.
    pub study: Study,
}

impl StudyFile {
    /// Reads one study.
    ///
    /// # Errors
    /// [`StudyError`] with the file and the field.
    pub fn read(path: &Path) -> Result<Self, StudyError> {
        let study: Study = file::read(path)?;
        let refuse = |found, allowed| StudyError::refused(path, "scenes", found, allowed);
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
            return Err(refuse(format!("\"{}\" twice", twice.name), "names that differ"));
        }
        let id = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
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
        let unreadable = |error| pounding_scene::Error::Refused(Refused::unreadable(folder, &error));
        let entries = std::fs::read_dir(folder).map_err(unreadable)?;
        let paths = entries.map(|entry| Ok(entry.map_err(unreadable)?.path()));
        let mut paths = paths.collect::<Result<Vec<_>, pounding_scene::Error>>()?;
        paths.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
        paths.sort();
        paths.iter().map(|path| Self::read(path)).collect()
    }

    /// The path and the list of the first study that lists ground motions.
    pub(crate) fn listing<'a>(files: impl IntoIterator<Item = &'a Self>) -> Option<(&'a Path, &'a BeyondSettings)> {
        files.into_iter().find_map(|file| Some((&*file.path, file.study.output.beyond()?)))
    }

    /// An error about this study's file.
    pub(crate) fn refuse(&self, place: &'static str, found: String, allowed: &'static str) -> StudyError {
        StudyError::refused(&self.path, place, found, allowed)
    }

    /// Folder that file names in the scenes are relative to.
    pub fn base(&self) -> &Path {
        self.path.parent().unwrap_or_else(|| Path::new(""))
    }
}
