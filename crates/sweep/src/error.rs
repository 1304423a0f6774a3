//! Errors of a sweep, before it begins and between its runs.

use std::path::{Path, PathBuf};

use super::place::PlaceError;
use super::summary_file::SummaryError;
use pounding_files::LockError;
use pounding_scene::{Error, Fault};

/// Name of the file that describes the parts in a folder.
pub(super) const MANIFEST: &str = "manifest.json";

/// Why a sweep is refused or cannot go on. A run that fails is no such error: it is a row.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// A file that cannot be read, or a scene that cannot be modelled.
    #[error(transparent)]
    Scene(#[from] Error),
    /// A fault of the sweep's file, at its line.
    #[error("{}{}: {source}", path.display(), at(*position))]
    InFile {
        /// The file.
        path: PathBuf,
        /// Line and column of the field, counted from 1, if known.
        position: Option<(usize, usize)>,
        /// The fault.
        source: Box<SweepError>,
    },
    /// A field that the scene does not have.
    #[error("{place}: {source}")]
    NoField {
        /// The entry of the file.
        place: String,
        /// The missing field.
        source: PlaceError,
    },
    /// A field that must not vary here.
    #[error("{place}: found the field `{field}`, which does not vary here: {instead}")]
    Fixed {
        /// The entry of the file.
        place: String,
        /// The field.
        field: String,
        /// Advice: the alternative.
        instead: &'static str,
    },
    /// A field that varies twice.
    #[error("{place}: found the field `{field}` a second time, by itself or within another field, allowed is once; delete one")]
    Twice {
        /// The entry of the file.
        place: String,
        /// The field.
        field: String,
    },
    /// A random value without a number of samples.
    #[error("{place}: varies at random, but `samples` is missing; add {{\"count\": 1024, \"seed\": 1, \"method\": \"sobol\"}}")]
    NoSamples {
        /// The entry of the file.
        place: String,
    },
    /// A number of samples without random values.
    #[error("samples: found samples, but nothing varies at random; delete them, or let a field be `uniform` or `normal`")]
    NothingSampled,
    /// More axes than a Sobol sequence has.
    #[error("samples.method: found `sobol` for {found} fields at random, allowed are up to {allowed}; use `latin_hypercube`")]
    TooManyAxes {
        /// Number of fields.
        found: usize,
        /// Most that are allowed.
        allowed: usize,
    },
    /// More runs than can be counted.
    #[error("vary: found {0:e} runs, allowed are up to 1e15; take coarser grids or fewer samples")]
    TooManyRuns(f64),
    /// More parts than a folder may have.
    #[error(
        "vary: found {found} runs, allowed are up to {allowed} {}",
        if *has_rows {
            "with rows; add a `summary`, which needs none, or make several sweeps"
        } else {
            "of what these cost; take coarser grids or fewer samples"
        }
    )]
    TooManyParts {
        /// Runs of the sweep.
        found: u64,
        /// Most runs that can be split into parts.
        allowed: u64,
        /// Whether a part holds rows.
        has_rows: bool,
    },
    /// A value that the scene refuses.
    #[error("{place}: found {field} = {value}, which the scene refuses: {reason}")]
    Refused {
        /// The entry of the file.
        place: String,
        /// The field.
        field: String,
        /// The value.
        value: String,
        /// The reason.
        reason: RefusedScene,
    },
    /// An invalid scene in the sweep's file.
    #[error("scene.{0}")]
    Inline(RefusedScene),
    /// A value that changes the number of floors or pairs.
    #[error(
        "{place}: found {field} = {value}, with which the row has {found}, where the first run has {allowed}; allowed are rows of one \
         kind: make a sweep of each"
    )]
    OtherRow {
        /// The entry of the file.
        place: String,
        /// The field.
        field: String,
        /// The value.
        value: String,
        /// Numbers of floors and walls of every structure, and of pairs, with this value.
        found: String,
        /// Numbers in the first run.
        allowed: String,
    },
    /// A method that is chosen by accuracy and also varies.
    #[error(
        "vary: found a field of `method` where scene.method asks for an accuracy, for which one method is chosen; leave one of them out"
    )]
    Accuracy,
    /// A record, or folder of records, that does not exist.
    #[error("records: found no file or folder {0}, allowed is one that is there, seen from the folder of the sweep")]
    NoSuchRecord(String),
    /// No readable record.
    #[error("records: found no record in {0}, allowed is a folder with one or more, or a file")]
    NoRecord(String),
    /// A summary that does not fit the sweep.
    #[error(transparent)]
    Summary(#[from] SummaryError),
    /// A file next to the table that already exists.
    #[error("{}: is there already, allowed is a new file; name another table or add --overwrite", .0.display())]
    ThereAlready(PathBuf),
    /// A shard outside the range.
    #[error("found the shard {index} of {count}, allowed are 1 to {count}, such as 1/{count}")]
    NoShard {
        /// The shard.
        index: u64,
        /// Number of shards.
        count: u64,
    },
    /// A file that cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The message of the system.
        source: std::io::Error,
    },
    /// Parts of another sweep.
    #[error(
        "{}: found parts of another sweep: its file, its scene, a record or the version of the program changed since; name another \
         file, delete the folder, or let --overwrite begin anew, which no shard does",
        .0.display()
    )]
    OtherSweep(PathBuf),
    /// A folder without parts.
    #[error("{}: found no parts of a sweep (no {}), allowed are folders that `pounding sweep` leaves, NAME.csv.parts", .0.display(), MANIFEST)]
    NoParts(PathBuf),
    /// A manifest that was changed.
    #[error(
        "{}: found other bytes than a sweep wrote, allowed is the file as it was; delete it, then the sweep goes on with the parts that \
         are whole",
        .0.display()
    )]
    DamagedManifest(PathBuf),
    /// Parts in the format of another version.
    #[error(
        "{}: found {} of the form of parts, allowed is version {allowed}: another version of the program wrote them; end the sweep with \
         that one, name another file, or let --overwrite begin anew",
        path.display(),
        found.map_or_else(|| "no version".into(), |found| format!("version {found}"))
    )]
    OtherForm {
        /// The manifest.
        path: PathBuf,
        /// Its version, if it has one.
        found: Option<u32>,
        /// The version of this program.
        allowed: u32,
    },
    /// A part that was changed.
    #[error(
        "{}: found {found}, allowed is the file as it was written; start the sweep again, or the shard that made it, which runs this part anew",
        path.display()
    )]
    Damaged {
        /// The part.
        path: PathBuf,
        /// What was found instead.
        found: &'static str,
    },
    /// Stopped while a method was chosen.
    #[error("stopped while a method was chosen; the same command begins with that again")]
    Stopped,
    /// An output on which another process works.
    #[error(transparent)]
    Lock(#[from] LockError),
    /// Missing parts.
    #[error(
        "found {found} of {allowed} parts: the runs {} are missing; start again the shards that should have made them, or \
         `pounding sweep` without a shard, which runs what is missing",
        runs(missing)
    )]
    Missing {
        /// Number of parts found.
        found: u64,
        /// Number of parts required.
        allowed: u64,
        /// First and last missing run of every gap.
        missing: Vec<(u64, u64)>,
    },
}

/// Why a scene with the values of a run is refused.
#[derive(Debug, thiserror::Error)]
pub enum RefusedScene {
    /// A field with a wrong form.
    #[error("{place}: {fault}")]
    Form {
        /// The field.
        place: String,
        /// The value found and the values allowed.
        fault: Box<Fault>,
    },
    /// A number of the run that is not finite.
    #[error("{field}: found {}, allowed are finite numbers; its spread reaches beyond them", pounding_text::plain(*number))]
    NotFinite {
        /// The field.
        field: String,
        /// The drawn number.
        number: f64,
    },
    /// A scene that cannot be modelled, or did not run.
    #[error("{}", .0.reason())]
    Scene(Box<Error>),
}

impl From<Error> for RefusedScene {
    fn from(error: Error) -> Self {
        Self::Scene(Box::new(error))
    }
}

/// Ranges of runs in words; only the first if there are many.
fn runs(missing: &[(u64, u64)]) -> String {
    const SHOWN: usize = 5;
    let shown = missing.iter().take(SHOWN);
    let mut words: Vec<String> = shown.map(|(from, to)| format!("{from} to {to}")).collect();
    if missing.len() > SHOWN {
        words.push(format!("and {} more ranges", missing.len() - SHOWN));
    }
    words.join(", ")
}

fn at(position: Option<(usize, usize)>) -> String {
    position.map_or_else(String::new, |(line, column)| format!(", line {line}, column {column}"))
}

impl SweepError {
    /// Converts an error of the system for a file.
    pub(super) fn file(path: &Path) -> impl Fn(std::io::Error) -> Self {
        move |source| Self::File {
            path: path.to_path_buf(),
            source,
        }
    }

    /// Adds the file of the sweep, and the line of the faulty field.
    pub(super) fn in_file(self, path: &Path) -> Self {
        if let Self::Scene(error) = self {
            return Self::Scene(error.in_file(path));
        }
        let Some(place) = self.place() else {
            return self;
        };
        Self::InFile {
            path: path.to_path_buf(),
            position: pounding_scene::position_in(path, &place),
            source: Box::new(self),
        }
    }

    /// The faulty entry of the sweep's file, if there is one.
    fn place(&self) -> Option<String> {
        let place = match self {
            Self::NoField { place, .. }
            | Self::Fixed { place, .. }
            | Self::Twice { place, .. }
            | Self::NoSamples { place }
            | Self::Refused { place, .. }
            | Self::OtherRow { place, .. } => place,
            Self::Inline(RefusedScene::Form { place, .. }) => {
                return Some(format!("scene.{place}"));
            }
            Self::Inline(RefusedScene::NotFinite { .. } | RefusedScene::Scene(_)) => "scene",
            Self::NothingSampled => "samples",
            Self::TooManyAxes { .. } => "samples.method",
            Self::TooManyRuns(_) | Self::TooManyParts { .. } | Self::Accuracy => "vary",
            Self::NoSuchRecord(_) | Self::NoRecord(_) => "records",
            Self::Summary(error) => error.place(),
            Self::Scene(_)
            | Self::InFile { .. }
            | Self::NoShard { .. }
            | Self::ThereAlready(_)
            | Self::File { .. }
            | Self::OtherSweep(_)
            | Self::NoParts(_)
            | Self::DamagedManifest(_)
            | Self::OtherForm { .. }
            | Self::Damaged { .. }
            | Self::Stopped
            | Self::Lock(_)
            | Self::Missing { .. } => return None,
        };
        Some(place.into())
    }
}
