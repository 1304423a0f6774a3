//! What a record file does not say itself, and the opening of such files.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use pounding::motion::{AccelerationUnit, Accelerogram, Record};
use pounding::scene::{
    Error, FileUse, GroundMotion, Origin, RecordUse, STANDARD_GRAVITY, Source, Unit,
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
    #[arg(long, value_name = "DT", allow_negative_numbers = true, value_parser = positive)]
    time_step: Option<f64>,
    /// Which component: name, part of it, or number.
    #[arg(long, value_name = "NAME")]
    pub(super) component: Option<String>,
    /// What one count of a digitiser is worth, in --unit.
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    per_count: Option<f64>,
    /// Accelerations, though the file speaks for velocities.
    #[arg(long)]
    acceleration: bool,
    /// What one g is worth [m/s²].
    #[arg(long, value_name = "G", default_value_t = STANDARD_GRAVITY, allow_negative_numbers = true, value_parser = positive)]
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

impl Opened {
    /// Name of its component, as the file spells it.
    pub(super) fn component(&self) -> Option<String> {
        self.file.component().map(str::to_owned)
    }
}

/// A file, and how it was found.
#[derive(Debug, Clone)]
pub(super) struct Named {
    pub(super) path: PathBuf,
    /// Whether it is one of the files of a folder that was named.
    pub(super) in_folder: bool,
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
            acceleration: false,
            gravity: STANDARD_GRAVITY,
        };
        *self == nothing
    }

    /// The record of a file as it is.
    pub(super) fn use_of(&self, path: &Path) -> RecordUse {
        self.as_it_is(self.file(path))
    }

    fn file(&self, path: &Path) -> FileUse {
        FileUse {
            file: path.to_string_lossy().into_owned(),
            unit: self.unit,
            time_step_s: self.time_step,
            component: self.component.clone(),
            per_count: self.per_count,
            acceleration: self.acceleration,
        }
    }

    fn as_it_is(&self, file: FileUse) -> RecordUse {
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
        let declared = self.file(path);
        let read = declared.where_unsaid(|file| read(&self.as_it_is(file.clone())));
        read.map_err(|error| message(path, &error))
    }
}

fn read(record: &RecordUse) -> Result<Opened, Error> {
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
    read(record).map_err(|error| message(path, &error))
}

/// Fields of a scene and the options that stand for them; a field comes before the table that it is in.
const OPTIONS: [(&str, &str); 19] = [
    ("`record.unit`", "--unit"),
    ("`record.time_step_s`", "--time-step"),
    ("`record.component`", "--component"),
    ("`record.per_count`", "--per-count"),
    ("`record.acceleration` as true", "--acceleration"),
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
        .fold(text, |text, (field, option)| text.replace(field, option));
    format!("{}: {by_options}", path.display())
}

/// The files that are named, and every file of the folders that are.
pub(super) fn files(paths: &[PathBuf]) -> Result<Vec<Named>, String> {
    let named = |path: PathBuf, in_folder| Named { path, in_folder };
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            let found = pounding::scene::files_in(path).map_err(|error| error.to_string())?;
            if found.is_empty() {
                return Err(format!(
                    "{}: found no file, allowed is a folder with one record or more",
                    path.display()
                ));
            }
            files.extend(found.into_iter().map(|path| named(path, true)));
        } else {
            files.push(named(path.clone(), false));
        }
    }
    Ok(files)
}
