//! What a record file does not say itself, and the opening of such files.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use pounding::motion::{AccelerationUnit, Accelerogram, ReadError, Record, RecordError};
use pounding::studies::{
    FileUse, GroundMotion, Origin, RecordUse, STANDARD_GRAVITY, SceneError, Source, StudyError,
    Unit,
};
use serde_json::json;

use crate::commands::positive;

/// Help of `--unit`.
const UNITS: &str = "One of g, mg, g_per_10, m_per_s2, cm_per_s2, mm_per_s2";

/// What files do not say themselves; the fields of `record` in a scene.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(next_help_heading = "What the file does not say")]
pub(super) struct Declared {
    /// Unit of the values.
    #[arg(long, value_name = "UNIT", help = UNITS, value_parser = unit(), hide_possible_values = true)]
    unit: Option<Unit>,
    /// Time between samples [s].
    #[arg(long, value_name = "DT", value_parser = positive)]
    time_step: Option<f64>,
    /// Which of several components: its name or number.
    #[arg(long, value_name = "NAME")]
    pub(super) component: Option<String>,
    /// What one count of a digitiser is worth, in --unit.
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    per_count: Option<f64>,
    /// What one g is worth [m/s²].
    #[arg(long, value_name = "G", default_value_t = STANDARD_GRAVITY, value_parser = positive)]
    pub(super) gravity: f64,
}

/// A record file that was read.
pub(super) struct Opened {
    /// The ground acceleration \[m/s²\], processed as asked.
    pub(super) record: Record,
    /// What the file holds.
    pub(super) file: Accelerogram,
    /// SHA-256 of its bytes.
    pub(super) sha256: String,
}

/// The units by the names that scenes give them.
fn unit() -> impl TypedValueParser<Value = Unit> {
    let names = AccelerationUnit::ALL.map(AccelerationUnit::name);
    PossibleValuesParser::new(names)
        .map(|name| serde_json::from_value(json!(name)).expect("scenes know every unit"))
}

impl Declared {
    /// Whether nothing is declared.
    pub(super) fn is_empty(&self) -> bool {
        let nothing = Self {
            unit: None,
            time_step: None,
            component: None,
            per_count: None,
            gravity: STANDARD_GRAVITY,
        };
        *self == nothing
    }

    /// The record of a file as it is.
    pub(super) fn use_of(&self, path: &Path) -> RecordUse {
        let file = FileUse {
            file: path.to_string_lossy().into_owned(),
            unit: self.unit,
            time_step_s: self.time_step,
            component: self.component.clone(),
            per_count: self.per_count,
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
        Self {
            component,
            ..self.clone()
        }
    }

    /// Reads one of several files: what is declared holds only where the file does not say it.
    pub(super) fn open_one_of_several(&self, path: &Path) -> Result<Opened, String> {
        let alone = Self {
            unit: None,
            time_step: None,
            per_count: None,
            ..self.clone()
        };
        let unsaid = |error: &StudyError| {
            let StudyError::Record { source, .. } = error else {
                return false;
            };
            matches!(
                source,
                ReadError::UnitNotStated | ReadError::TimeStepNotStated | ReadError::Counts { .. }
            )
        };
        match read(&alone.use_of(path)) {
            Err(error) if unsaid(&error) => self.open(path),
            read => read.map_err(|error| message(path, error)),
        }
    }
}

fn read(record: &RecordUse) -> Result<Opened, StudyError> {
    let motion = GroundMotion::of(record, Path::new(""), "")?;
    let Origin { file, sha256, .. } = motion.origin.expect("the source is a file");
    Ok(Opened {
        record: motion.record,
        file,
        sha256,
    })
}

/// Reads a file and processes it.
pub(super) fn processed(path: &Path, record: &RecordUse) -> Result<Opened, String> {
    read(record).map_err(|error| message(path, error))
}

/// The message of a record that is refused, with the options of the program where a scene has fields.
fn message(path: &Path, error: StudyError) -> String {
    let path = path.display();
    let text = if let StudyError::NoRecord { source, .. } = error {
        format!("{path}: cannot be read: {source}")
    } else if let StudyError::Scene { source, .. } = &error {
        format!("{path}: {}", of_use(source))
    } else {
        error.to_string()
    };
    [
        ("`unit`", "--unit"),
        ("`time_step`", "--time-step"),
        ("`component`", "--component"),
        ("`per_count`", "--per-count"),
    ]
    .iter()
    .fold(text, |text, (field, option)| text.replace(field, option))
}

/// Why a record cannot be used as asked, after the option that asks for it.
fn of_use(error: &SceneError) -> String {
    if let SceneError::Record(error) = error {
        format!("{}{error}", option(error))
    } else if let SceneError::ScaleTo(error) = error {
        format!("--scale-to-sa: {error}")
    } else {
        error.to_string()
    }
}

/// The option that asks for what is refused.
fn option(error: &RecordError) -> &'static str {
    match error {
        RecordError::Empty => "",
        RecordError::TimeStep { .. } | RecordError::TooManySamples { .. } => "--resample: ",
        RecordError::Sample { .. } | RecordError::Factor { .. } => "--scale or --gravity: ",
        RecordError::Gravity { .. } => "--gravity: ",
        RecordError::AllZero { .. } => "--scale-to-pga: ",
        RecordError::Setting { .. }
        | RecordError::Frequency { .. }
        | RecordError::Corners { .. }
        | RecordError::TooShort { .. } => "--band-pass: ",
    }
}

/// The files that are named, and every file of the folders that are.
pub(super) fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, String> {
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            let found = pounding::studies::files_in(path).map_err(|error| error.to_string())?;
            if found.is_empty() {
                return Err(format!(
                    "{}: found no file, allowed is a folder with one record or more",
                    path.display()
                ));
            }
            files.extend(found);
        } else {
            files.push(path.clone());
        }
    }
    Ok(files)
}
