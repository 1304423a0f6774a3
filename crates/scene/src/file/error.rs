use std::path::{Path, PathBuf};

use pounding_motion::{Quantity, ReadError};
use pounding_solver::{LedgerError, RunError};

use crate::file::fault::FOR_A_BACKSLASH;
use crate::{Fault, SceneError};

/// What can go wrong between a file and a result; each names place, found and allowed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file that cannot be read.
    #[error("{}: cannot be read: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A record file that cannot be read.
    #[error(
        "record.file: {} cannot be read (it is looked for from the folder of the scene's file): {source}{}",
        path.display(),
        of_escapes(path)
    )]
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
        source: Box<Error>,
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
    /// A record file that cannot be understood.
    #[error("{}: {}", path.display(), by_fields(source))]
    Record {
        /// The file.
        path: PathBuf,
        /// What is wrong and where.
        source: ReadError,
    },
    /// A file whose name says that it holds no accelerations, and that does not say otherwise itself.
    #[error(
        "{name:?}: the name says {}, and the file does not say that its values are accelerations; take the record of accelerations, or \
         declare `record.acceleration` as true",
        named_quantity(*quantity)
    )]
    NameSaysOtherwise {
        /// Name of the file.
        name: String,
        /// What the name says.
        quantity: Quantity,
    },
    /// A folder in which nothing shakes a row.
    #[error(
        "{}: found {n_files} files and no record that shakes a row, allowed is a folder with one or more{}",
        folder.display(),
        left_out.iter().fold(String::new(), |said, line| said + "; " + line)
    )]
    NoMotion {
        /// The folder.
        folder: PathBuf,
        /// Number of files in it.
        n_files: usize,
        /// Why each is left out, a line for a reason.
        left_out: Vec<String>,
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
    #[error("scene \"{scene}\": {source}{}", named(structures))]
    Run {
        /// Name of the scene.
        scene: String,
        /// Index, from the left, and name of every structure concerned.
        structures: Vec<(usize, String)>,
        /// What happened, in which structure and when.
        source: RunError,
    },
    /// A run that broke a law of mechanics; an exact one also where its energies do not add up to rounding.
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
    NoReference(Box<Error>),
}

/// What a name says, in words.
fn named_quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Acceleration => "acceleration",
        Quantity::Velocity => "velocity",
        Quantity::Displacement => "displacement",
        Quantity::Spectrum => "spectrum",
    }
}

/// That a name has a letter which nobody types, such as the line break that `"records\new.csv"` has.
fn of_escapes(path: &Path) -> String {
    let is_escape = path.to_string_lossy().chars().any(char::is_control);
    let hint = is_escape.then(|| format!("; in double quotes a backslash begins an escape: write {}", FOR_A_BACKSLASH[0]));
    hint.unwrap_or_default()
}

/// What is wrong with a record file, with the fields of a scene that say what it leaves out.
fn by_fields(error: &ReadError) -> String {
    [
        ("`unit`", "`record.unit`"),
        ("`time_step`", "`record.time_step_s`"),
        ("`component`", "`record.component`"),
        ("`per_count`", "`record.per_count`"),
        ("`acceleration`", "`record.acceleration` as true"),
        ("`in_rows`", "`record.in_rows` as true"),
    ]
    .iter()
    .fold(error.to_string(), |text, (word, field)| text.replace(word, field))
}

/// A position, after the name of a file.
fn at(position: Option<(usize, usize)>) -> String {
    position.map_or_else(String::new, |(line, column)| format!(", line {line}, column {column}"))
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

impl Error {
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
}
