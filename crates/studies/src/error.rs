use std::path::{Path, PathBuf};

use pounding_motion::ReadError;
use pounding_solver::{LedgerError, RunError};
use thiserror::Error;

use crate::plot::PlotError;
use crate::{Fault, SceneError, Vertical};

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
    /// A record file that cannot be read.
    #[error("record.file: {} cannot be read (it is looked for from the folder of the scene's file): {source}", path.display())]
    NoRecord {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A scene of a file that cannot be modelled or run.
    #[error("{}{}: {source}", path.display(), at(*position))]
    InFile {
        /// The file that holds the scene.
        path: PathBuf,
        /// Line and column of the field, counted from 1, where one is to blame and is found.
        position: Option<(usize, usize)>,
        /// What is wrong with it.
        source: Box<StudyError>,
    },
    /// A file that is neither good JSON nor good TOML, or not of the expected form.
    #[error("{}{}: {}{fault}", path.display(), at(*position), in_field(place.as_deref()))]
    Form {
        /// The file.
        path: PathBuf,
        /// Line and column of the fault, counted from 1, where known.
        position: Option<(usize, usize)>,
        /// The field, for example `scenes[0].structures[1].sdof.mass_kg`; nothing for a fault of the text itself.
        place: Option<String>,
        /// What was found, and what is allowed.
        fault: Box<Fault>,
    },
    /// A CSV file of the project that is not of the expected form.
    #[error("{}: {}", path.display(), counted_from_one(source))]
    Csv {
        /// The file.
        path: PathBuf,
        /// What was found and expected.
        source: csv::Error,
    },
    /// A record file that cannot be understood.
    #[error("{}: {}", path.display(), by_fields(source))]
    Record {
        /// The file.
        path: PathBuf,
        /// What is wrong and where.
        source: ReadError,
    },
    /// A vertical component, which shakes no row.
    #[error("{0}")]
    Vertical(Vertical),
    /// A scene with a value that cannot be modelled.
    #[error("scene \"{scene}\": {source}")]
    Scene {
        /// Name of the scene.
        scene: String,
        /// What is wrong and where.
        source: SceneError,
    },
    /// A run that ended early.
    #[error("scene \"{scene}\": {source}{}", named(structures))]
    Run {
        /// Name of the scene.
        scene: String,
        /// Index, from the left, and name of every structure concerned.
        structures: Vec<(usize, String)>,
        /// What happened, in which structure and when.
        source: RunError,
    },
    /// A run that broke a law of mechanics.
    #[error("scene \"{scene}\": {source}{}", named(structures))]
    Broken {
        /// Name of the scene.
        scene: String,
        /// Index, from the left, and name of every structure concerned.
        structures: Vec<(usize, String)>,
        /// The law, where and when it was broken, and by how much.
        source: LedgerError,
    },
    /// An exact run that failed, where others were to be measured by it.
    #[error("the exact run, by which every method is measured, fails: {0}")]
    NoReference(Box<StudyError>),
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

/// What is wrong with a record file, with the fields of a scene that say what it leaves out.
fn by_fields(error: &ReadError) -> String {
    [
        ("`unit`", "`record.unit`"),
        ("`time_step`", "`record.time_step_s`"),
        ("`component`", "`record.component`"),
        ("`per_count`", "`record.per_count`"),
    ]
    .iter()
    .fold(error.to_string(), |text, (word, field)| {
        text.replace(word, field)
    })
}

/// A position, after the name of a file.
fn at(position: Option<(usize, usize)>) -> String {
    position.map_or_else(String::new, |(line, column)| {
        format!(", line {line}, column {column}")
    })
}

/// A field, before its fault.
fn in_field(place: Option<&str>) -> String {
    place.map_or_else(String::new, |place| format!("{place}: "))
}

/// The names behind the indices of a run's error.
fn named(structures: &[(usize, String)]) -> String {
    let name = |(index, name): &(usize, String)| format!("; structure {index} is \"{name}\"");
    structures.iter().map(name).collect()
}

/// The fault in a CSV file with its line and field, both counted from 1 as in messages about records.
fn counted_from_one(error: &csv::Error) -> String {
    if let csv::ErrorKind::Deserialize {
        pos: Some(pos),
        err,
    } = error.kind()
    {
        let field = err
            .field()
            .map_or_else(String::new, |field| format!(", field {}", field + 1));
        format!("line {}{field}: {}", pos.line(), err.kind())
    } else {
        error.to_string()
    }
}

impl StudyError {
    /// Whether somebody ended the run.
    pub fn is_stopped(&self) -> bool {
        if let Self::NoReference(source) | Self::InFile { source, .. } = self {
            return source.is_stopped();
        }
        matches!(
            self,
            Self::Run {
                source: RunError::Stopped { .. },
                ..
            }
        )
    }

    /// The message without the name of a record file, beside which it stands.
    pub fn reason(&self) -> String {
        if let Self::Record { source, .. } = self {
            by_fields(source)
        } else {
            self.to_string()
        }
    }

    /// Line and column of the field to blame in the file of its scene.
    fn position_in(&self, path: &Path) -> Option<(usize, usize)> {
        let message = if let Self::Scene { source, .. } = self {
            source.to_string()
        } else if matches!(self, Self::NoRecord { .. }) {
            self.to_string()
        } else {
            return None;
        };
        let (place, _) = message.split_once(": ")?;
        crate::file::position_in(path, place)
    }

    /// Names the file that holds the scene, and the line of the field, where the message does not yet.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        if matches!(
            self,
            Self::Scene { .. }
                | Self::Run { .. }
                | Self::Broken { .. }
                | Self::NoReference(_)
                | Self::NoRecord { .. }
        ) {
            Self::InFile {
                path: path.to_path_buf(),
                position: self.position_in(path),
                source: Box::new(self),
            }
        } else {
            self
        }
    }
}
