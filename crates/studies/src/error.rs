use std::path::{Path, PathBuf};

use pounding_motion::{ReadError, RecordError};
use pounding_solver::{LedgerError, ModelError, RunError};
use thiserror::Error;

use crate::floors::Floors;
use crate::plot::PlotError;
use crate::{Fault, MotionError, Scene, Vertical};

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

/// A scene with a value that cannot be modelled.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A value outside its valid range.
    #[error("{place}: found {found}, allowed {allowed}")]
    OutOfRange {
        /// The field, for example `structures[1].sdof.mass_kg`.
        place: String,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A name of nothing.
    #[error("{place}: found an empty name, allowed is {allowed}")]
    NoName {
        /// The field.
        place: String,
        /// What is allowed, in words.
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
    /// Another number of arrivals of the ground motion than of structures.
    #[error(
        "arrivals_s: found {found}, allowed {n_structures} (one for each of {n_structures} structures and walls), or no field \
         `arrivals_s` when all are shaken at once"
    )]
    ArrivalCount {
        /// Number of arrivals.
        found: usize,
        /// Number of structures.
        n_structures: usize,
    },
    /// A time step with which the method is unstable even without contact.
    #[error(
        "method.{method}.time_step_s: found {time_step}, allowed less than {} (structures[{structure}], \"{name}\", grows \
         without bound from there on); contact can ask for less",
        crate::digits(*limit)
    )]
    Unstable {
        /// Name of the method.
        method: &'static str,
        /// Time step found \[s\].
        time_step: f64,
        /// Critical time step \[s\].
        limit: f64,
        /// Index of the structure that sets it.
        structure: usize,
        /// Its name.
        name: String,
    },
    /// A run so long that the exact method would need too many pieces, though those of the record's duration are few.
    #[error(
        "duration_s: found {}, allowed up to about {} by the exact method, which would need {pieces:.1e} pieces of the motion of \
         structures[{structure}], \"{name}\", of {allowed:.0e} at most: use a shorter duration_s, or leave it out for that of the \
         record and two periods",
        crate::digits(*duration),
        crate::short(duration / pieces * allowed)
    )]
    TooLong {
        /// Duration found \[s\].
        duration: f64,
        /// Index of the structure with the most pieces.
        structure: usize,
        /// Its name.
        name: String,
        /// Pieces that it would need.
        pieces: f64,
        /// Most pieces that are allowed.
        allowed: f64,
    },
    /// A floor that would hit the columns of a neighbour.
    #[error(
        "contacts[{contact}]: found a floor of \"{floor}\" at {} m, beside the columns of \"{neighbour}\", whose floors are at {} m; \
         allowed are floors that face floors, up to the lower roof: change height_m of a storey, or leave out all height_m, and \
         storeys of one number count as level",
        crate::digits(*height),
        heights(others)
    )]
    LevelsDiffer {
        /// Index of the contact.
        contact: usize,
        /// Name of the structure whose floor it is.
        floor: String,
        /// Height of the floor above the ground \[m\].
        height: f64,
        /// Name of the neighbour.
        neighbour: String,
        /// Heights of its floors \[m\].
        others: Vec<f64>,
    },
    /// A scene without structures.
    #[error("structures: found none, allowed one or more")]
    NoStructures,
    /// Neighbours that already overlap at t = 0.
    #[error(
        "contacts[{contact}].gap_m: found {gap}, but the initial displacements of structures[{contact}] and [{}] close \
         that gap and overlap by {} m; allowed is a gap that they leave open, or other initial_displacement_m",
        contact + 1,
        crate::digits(*overlap)
    )]
    OverlapsAtStart {
        /// Index of the contact.
        contact: usize,
        /// Gap found \[m\].
        gap: f64,
        /// Deformation at t = 0 \[m\].
        overlap: f64,
    },
    /// A contact between two walls.
    #[error(
        "contacts[{contact}]: found a wall on either side, allowed at most one wall per contact"
    )]
    BetweenWalls {
        /// Index of the contact.
        contact: usize,
    },
    /// A row that the solver refuses.
    #[error(transparent)]
    Model(ModelError),
    /// A ground motion that cannot be made or used as asked.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A record that was changed, to measure what that does, and is no longer one.
    #[error("record: {0}")]
    Record(#[from] RecordError),
}

impl SceneError {
    /// Says in the words of the scene why the solver refuses its row.
    pub(crate) fn of_model(error: ModelError, (scene, floors): (&Scene, &Floors)) -> Self {
        let contact = |pair: usize| floors.facing().get(pair).map_or(0, |one| one.contact);
        if let ModelError::OverlapsAtStart { pair, overlap } = error {
            let index = contact(pair);
            let contact = scene.contacts.iter().flatten().nth(index);
            Self::OverlapsAtStart {
                contact: index,
                gap: contact.map_or(0.0, |contact| contact.gap_m),
                overlap,
            }
        } else if let ModelError::NotNeighbours { pair, .. } = error {
            // Contacts join neighbours in order: what remains is a wall on either side.
            Self::BetweenWalls {
                contact: contact(pair),
            }
        } else {
            Self::Model(error)
        }
    }
}

/// Heights in a list.
fn heights(heights: &[f64]) -> String {
    let heights: Vec<_> = heights
        .iter()
        .map(|height| crate::digits(*height))
        .collect();
    heights.join(", ")
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
