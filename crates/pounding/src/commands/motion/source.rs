//! What a record file does not say itself, and the opening of such files.

use std::path::Path;

use std::sync::Arc;

use pounding::motion::{Accelerogram, Record};
use pounding::scene::{Error, FileUse, GroundMotion, Motion, Origin, RecordUse, STANDARD_GRAVITY, Source, opened};

use crate::commands::{declared, positive};

/// What files do not say themselves, which component is taken, and what one g is worth.
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

    /// The record of a file as it is.
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

    /// Reads a file as it is.
    pub(super) fn open(&self, path: &Path) -> Result<Opened, String> {
        processed(path, &self.use_of(path))
    }

    /// The same declarations for one component.
    pub(super) fn of_component(&self, component: Option<String>) -> Self {
        Self { component, ..self.clone() }
    }

    /// What is declared of the files of a folder.
    pub(super) fn of_files(&self) -> FileUse {
        self.of_file.over(FileUse {
            component: self.component.clone(),
            ..FileUse::default()
        })
    }

    /// A motion that was read, as it is.
    pub(super) fn use_motion(&self, motion: &Motion) -> Result<Opened, String> {
        let record = self.use_of(&motion.path);
        used(&record, Arc::clone(motion.origin())).map_err(|error| message(&motion.path, &error))
    }

    /// Reads one of several files: what is declared holds only where the file does not say it.
    pub(super) fn open_one_of_several(&self, path: &Path) -> Result<Opened, String> {
        let record = self.use_of(path);
        let read = || {
            let origin = Origin::of_silent(path, &opened(path)?, file_of(&record))?.0;
            used(&record, Arc::new(origin))
        };
        read().map_err(|error| message(path, &error))
    }
}

/// What is declared of the file of a record.
fn file_of(record: &RecordUse) -> &FileUse {
    match &record.source {
        Source::File(file) => file,
        Source::Generated(_) => unreachable!("the source is a file"),
    }
}

/// A file that was read, used as a scene says.
fn used(record: &RecordUse, origin: Arc<Origin>) -> Result<Opened, Error> {
    let motion = GroundMotion::of_file(record, origin);
    let motion = motion.map_err(|source| Error::Scene {
        scene: String::new(),
        source,
    })?;
    Ok(Opened {
        record: motion.record,
        origin: motion.origin.expect("the source is a file"),
    })
}

/// Reads a file and processes it.
pub(super) fn processed(path: &Path, record: &RecordUse) -> Result<Opened, String> {
    let read = Origin::read(path, file_of(record)).and_then(|origin| used(record, Arc::new(origin)));
    read.map_err(|error| message(path, &error))
}

/// Fields of a scene and the options that stand for them; a field comes before the table that it is in.
const OPTIONS: [(&str, &str); 15] = [
    ("`record.component`", "--component"),
    ("record.gravity_m_per_s2", "--gravity"),
    ("record.detrend", "--detrend"),
    ("record.band_pass.low_hz", "--band-pass LOW"),
    ("record.band_pass.high_hz", "--band-pass HIGH"),
    ("record.band_pass.order", "--order"),
    ("record.band_pass.causal", "--causal"),
    ("record.band_pass", "--band-pass"),
    ("record.resample_s", "--resample"),
    ("record.scale_to.pga_g", "--scale-to-pga"),
    ("record.scale_to.sa.period_s", "--scale-to-sa T"),
    ("record.scale_to.sa.damping_ratio", "--scale-to-sa Z"),
    ("record.scale_to.sa.sa_g", "--scale-to-sa SA"),
    ("record.scale_to.sa", "--scale-to-sa"),
    ("record.scale", "--scale"),
];

/// The message of a record that is refused, with the options of the program where a scene has fields.
fn message(path: &Path, error: &Error) -> String {
    let text = if let Error::NoRecord { source, .. } = error {
        format!("cannot be read: {source}")
    } else if let Error::Scene { source, .. } = error {
        source.to_string()
    } else {
        error.reason()
    };
    let by_options = OPTIONS
        .iter()
        .fold(declared::by_options(&text), |text, (field, option)| text.replace(field, option));
    format!("{}: {by_options}", path.display())
}
