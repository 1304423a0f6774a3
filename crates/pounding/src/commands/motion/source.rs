//! Options that declare what a record file leaves out, and the opening of such files.

use std::path::Path;

use std::sync::Arc;

use pounding::assess::{FolderUse, HorizontalPair, SuiteMotion};
use pounding::motion::{Accelerogram, Record};
use pounding::scene::{Error, FileUse, GroundMotion, Origin, RecordUse, STANDARD_GRAVITY, Source};
use pounding::text::{Naming, Refused};

use crate::commands::{declared, positive};

/// Declarations for files that leave them out, the component that is taken, and the value of g.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(next_help_heading = "What the file does not say")]
pub(super) struct Declared {
    #[command(flatten)]
    of_file: declared::Declared,
    /// Which component: name, part of it, or number.
    #[arg(long, value_name = "NAME")]
    pub(super) component: Option<String>,
    /// What one g is worth [m/s²].
    #[arg(long, value_name = "G", default_value_t = STANDARD_GRAVITY, allow_negative_numbers = true, value_parser = positive)]
    pub(super) gravity: f64,
}

/// A record file that was read.
pub(super) struct Opened {
    /// The ground acceleration \[m/s²\], processed as asked.
    pub(super) record: Record,
    /// The file.
    pub(super) origin: Arc<Origin>,
}

impl Opened {
    /// What the file holds.
    pub(super) fn file(&self) -> &Accelerogram {
        &self.origin.file
    }

    /// Name of its component, as the file spells it.
    pub(super) fn component(&self) -> Option<String> {
        self.file().component().map(str::to_owned)
    }
}

impl Declared {
    /// Whether nothing is declared.
    pub(super) fn is_empty(&self) -> bool {
        let nothing = Self {
            of_file: declared::Declared::default(),
            component: None,
            gravity: STANDARD_GRAVITY,
        };
        *self == nothing
    }

    /// Whether two components are to shake along an axis.
    pub(super) fn has_axis(&self) -> bool {
        self.of_files().axis_deg.is_some()
    }

    /// The record of a file, unprocessed.
    pub(super) fn use_of(&self, path: &Path) -> RecordUse {
        let file = FileUse {
            file: path.to_string_lossy().into_owned(),
            ..self.of_files()
        };
        RecordUse {
            gravity_m_per_s2: self.gravity,
            ..RecordUse::of(Source::File(file))
        }
    }

    /// Reads a file without processing.
    pub(super) fn open(&self, path: &Path) -> Result<Opened, Refused> {
        processed(path, &self.use_of(path))
    }

    /// The same declarations for one component.
    pub(super) fn of_component(&self, component: Option<String>) -> Self {
        Self { component, ..self.clone() }
    }

    /// The declarations for the files of a folder.
    pub(super) fn of_files(&self) -> FileUse {
        self.of_file.over(FileUse {
            component: self.component.clone(),
            ..FileUse::default()
        })
    }

    /// How folders are read.
    pub(super) fn of_folder(&self) -> FolderUse {
        self.of_file.of_folder(self.of_files())
    }

    /// A motion that was read, unprocessed.
    pub(super) fn use_motion(&self, motion: &SuiteMotion) -> Result<Opened, Refused> {
        let record = self.use_of(&motion.path);
        used(&record, Arc::clone(motion.origin())).map_err(|error| by_options(&motion.path, error))
    }

    /// The records of a pair, unprocessed. A second component that is not quite at a right angle is turned to be.
    pub(super) fn use_pair(&self, pair: &HorizontalPair<'_>) -> Result<[Record; 2], Refused> {
        let [one, other] = pair.motions;
        let second = one.origin().rotated(other.origin(), pair.angles, pair.angles.degrees[0] + 90.0);
        let second = Arc::new(second.map_err(|refused| refused.in_file(&other.path))?);
        let second = used(&self.use_of(&other.path), second).map_err(|error| by_options(&other.path, error))?;
        Ok([self.use_motion(one)?.record, second.record])
    }

    /// Reads a file among several: a declaration holds only if the file leaves it out.
    pub(super) fn open_one_of_several(&self, path: &Path) -> Result<Opened, Refused> {
        let record = self.use_of(path);
        let read = || {
            let origin = Origin::of_silent(path, &Origin::bytes(path)?, file_of(&record))?.0;
            used(&record, Arc::new(origin))
        };
        read().map_err(|error| by_options(path, error))
    }
}

/// The declarations for the file of a record.
fn file_of(record: &RecordUse) -> &FileUse {
    match &record.source {
        Source::File(file) => file,
        Source::Generated(_) => unreachable!("the source is a file"),
    }
}

/// A file that was read, used as a scene says.
fn used(record: &RecordUse, origin: Arc<Origin>) -> Result<Opened, Error> {
    let motion = GroundMotion::of_file(record, origin);
    let motion = motion?;
    Ok(Opened {
        record: motion.record,
        origin: motion.origin.expect("the source is a file"),
    })
}

/// Reads a file and processes it.
pub(super) fn processed(path: &Path, record: &RecordUse) -> Result<Opened, Refused> {
    let read = Origin::read(path, file_of(record)).and_then(|origin| used(record, Arc::new(origin)));
    read.map_err(|error| by_options(path, error))
}

/// The refusal of a record, with options of the program in place of the fields of a scene.
fn by_options(path: &Path, error: Error) -> Refused {
    let mut refused = Refused::from(error).by(Naming::Option);
    refused.place_mut().scene = None;
    refused.in_file(path)
}
