//! What can go wrong with a study.

use std::path::{Path, PathBuf};

use pounding_plot::PlotError;

/// What can go wrong between the file of a study and its results; each names place, found and allowed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A file that cannot be read, or a scene that cannot be modelled or run.
    #[error(transparent)]
    Scene(#[from] pounding_scene::Error),
    /// A CSV file of the project that is not of the expected form.
    #[error("{}: {}", path.display(), counted_from_one(source))]
    Csv {
        /// The file.
        path: PathBuf,
        /// What was found and expected.
        source: csv::Error,
    },
    /// A study that asks for what its scenes do not give.
    #[error("{}: {place}: found {found}, allowed {allowed}", path.display())]
    Study {
        /// The file.
        path: PathBuf,
        /// The field.
        place: &'static str,
        /// What was found.
        found: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A scene that a claim of the paper is tested on and that no study has.
    #[error("studies/{study}.json: found no scene \"{scene}\"; the claims of the paper are tested on it")]
    MissingScene {
        /// Name of the study.
        study: String,
        /// Name of the scene.
        scene: String,
    },
    /// A figure that cannot be drawn.
    #[error("{}: {source}", path.display())]
    Plot {
        /// The study.
        path: PathBuf,
        /// What is wrong with the figure.
        source: PlotError,
    },
}

impl StudyError {
    /// Something in a study's file that is not allowed.
    pub(crate) fn refused(path: &Path, place: &'static str, found: String, allowed: &'static str) -> Self {
        Self::Study {
            path: path.to_path_buf(),
            place,
            found,
            allowed,
        }
    }

    /// A study that is missing with all of its scenes.
    pub(crate) fn no_scene_of(study: &str) -> Self {
        Self::MissingScene {
            study: study.into(),
            scene: "any".into(),
        }
    }

    /// Names the file that holds a scene, and the line of the field, where the message does not yet.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        if let Self::Scene(error) = self {
            Self::Scene(error.in_file(path))
        } else {
            self
        }
    }
}

/// The fault in a CSV file with its line and field, both counted from 1 as in messages about records.
fn counted_from_one(error: &csv::Error) -> String {
    if let csv::ErrorKind::Deserialize { pos: Some(pos), err } = error.kind() {
        let field = err.field().map_or_else(String::new, |field| format!(", field {}", field + 1));
        format!("line {}{field}: {}", pos.line(), err.kind())
    } else {
        error.to_string()
    }
}
