//! Errors of studies.

use std::path::{Path, PathBuf};

use pounding_plot::PlotError;

/// An error between a study file and its results. Each message names the place, the value found and the values allowed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A file cannot be read, or a scene cannot be modelled or run.
    #[error(transparent)]
    Scene(#[from] pounding_scene::Error),
    /// A CSV file of the project does not have the expected form.
    #[error("{}: {}", path.display(), counted_from_one(source))]
    Csv {
        /// The file.
        path: PathBuf,
        /// The value found and the value expected.
        source: csv::Error,
    },
    /// A study asks for something that its scenes do not give.
    #[error("{}: {place}: found {found}, allowed {allowed}", path.display())]
    Study {
        /// The study file.
        path: PathBuf,
        /// The field.
        place: &'static str,
        /// The value found.
        found: String,
        /// The values allowed.
        allowed: &'static str,
    },
    /// No study has a scene that a claim of the paper is tested on.
    #[error("studies/{study}.json: found no scene \"{scene}\"; the claims of the paper are tested on it")]
    MissingScene {
        /// Name of the study.
        study: String,
        /// Name of the scene.
        scene: String,
    },
    /// A figure cannot be drawn.
    #[error("{}: {source}", path.display())]
    Plot {
        /// The study file.
        path: PathBuf,
        /// The fault of the figure.
        source: PlotError,
    },
}

impl StudyError {
    /// An error about a field of a study file.
    pub(crate) fn refused(path: &Path, place: &'static str, found: String, allowed: &'static str) -> Self {
        Self::Study {
            path: path.to_path_buf(),
            place,
            found,
            allowed,
        }
    }

    /// An error for a study that is missing together with all its scenes.
    pub(crate) fn no_scene_of(study: &str) -> Self {
        Self::MissingScene {
            study: study.into(),
            scene: "any".into(),
        }
    }

    /// Adds the scene's file and the line of the field to the message, unless the message already names them.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        if let Self::Scene(error) = self {
            Self::Scene(error.in_file(path))
        } else {
            self
        }
    }
}

/// Describes a fault of a CSV file. Line and field are counted from 1, as in messages about records.
fn counted_from_one(error: &csv::Error) -> String {
    if let csv::ErrorKind::Deserialize { pos: Some(pos), err } = error.kind() {
        let field = err.field().map_or_else(String::new, |field| format!(", field {}", field + 1));
        format!("line {}{field}: {}", pos.line(), err.kind())
    } else {
        error.to_string()
    }
}
