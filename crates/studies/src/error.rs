use std::path::PathBuf;

use pounding_motion::{ReadError, RecordError};
use pounding_solver::{ModelError, RunError};
use thiserror::Error;

use crate::plot::PlotError;

/// What can go wrong between a file and a result; each names place, found and allowed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A file that cannot be read.
    #[error("{}: cannot be read: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A JSON file that is not of the expected form.
    #[error("{}: {place}: {source}", path.display())]
    Form {
        /// The file.
        path: PathBuf,
        /// The field, for example `scenes[0].structures[1].mass_kg`.
        place: String,
        /// What was found and expected, with line and column.
        source: serde_json::Error,
    },
    /// A CSV file of the project that is not of the expected form.
    #[error("{}: {source}", path.display())]
    Csv {
        /// The file.
        path: PathBuf,
        /// What was found and expected.
        source: csv::Error,
    },
    /// A record file that cannot be understood.
    #[error("{}: {source}", path.display())]
    Record {
        /// The file.
        path: PathBuf,
        /// What is wrong and where.
        source: ReadError,
    },
    /// A scene with a value that cannot be modelled.
    #[error("scene \"{scene}\": {source}")]
    Scene {
        /// Name of the scene.
        scene: String,
        /// What is wrong and where.
        source: SceneError,
    },
    /// A run that ended early.
    #[error("scene \"{scene}\": {source}")]
    Run {
        /// Name of the scene.
        scene: String,
        /// What happened, in which structure and when.
        source: RunError,
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
    #[error(
        "studies/{study}.json: found no scene \"{scene}\"; the claims of the paper are tested on it"
    )]
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

/// A scene with a value that cannot be modelled.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A value outside its valid range.
    #[error("{place}: found {found}, allowed {allowed}")]
    OutOfRange {
        /// The field, for example `structures[1].mass_kg`.
        place: String,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A number of contacts that does not fit the number of structures.
    #[error(
        "contacts: found {found} for {n_structures} structures, allowed {allowed} (one between each structure and its \
         right neighbour), or no field `contacts` when they stand apart"
    )]
    ContactCount {
        /// Number of contacts.
        found: usize,
        /// Number of contacts that would fit.
        allowed: usize,
        /// Number of structures.
        n_structures: usize,
    },
    /// A scene without structures.
    #[error("structures: found none, allowed one or more")]
    NoStructures,
    /// A row that the solver refuses.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A use of the record that is out of range.
    #[error("record: {0}")]
    Record(#[from] RecordError),
}
