//! The ground motion that shakes a row, from the use of a record in a scene.

mod pair;

pub use pair::PairAngles;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::file::fault::FOR_A_BACKSLASH;
use crate::file::record_bytes;
use crate::file::{FileUse, Generated, Interpolation, ScaleTo, check};
use crate::settings::in_setting;
use crate::{Error, RecordUse, Source};
use pounding_files::shown_name;
use pounding_motion::{Accelerogram, Declared, NamedFile, Quantity, Record, read_declared};
use pounding_text::{Knob, RefusalKind, Refused};
use sha2::{Digest, Sha256};

/// A ground motion as a scene uses it, and its file.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundMotion {
    /// The ground acceleration \[m/s²\], processed, scaled, reversed.
    pub record: Record,
    /// Product of all factors on the source \[–\]; a reversal does not change its sign.
    pub scale: f64,
    /// The file; `None` for a motion from a formula.
    pub origin: Option<Arc<Origin>>,
}

/// The file of a ground motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Origin {
    /// Path of the file; empty if it was never opened.
    pub path: PathBuf,
    /// SHA-256 of its bytes, in hexadecimal digits.
    pub sha256: String,
    /// Content of the file.
    pub file: Accelerogram,
}

impl GroundMotion {
    /// Reads or generates the ground motion of a scene. `base` is the folder for relative paths of files.
    ///
    /// # Errors
    /// Refuses a file that is missing or cannot be read as a record, and processing in `scene` that does not suit it.
    pub fn of(record: &RecordUse, base: &Path, scene: &str) -> Result<Self, Error> {
        let in_scene = |refused| Error::in_scene(scene, refused);
        match &record.source {
            Source::File(file) => {
                // Before reading, which needs the axis of a pair.
                check::check_record(record).map_err(in_scene)?;
                let origin = Origin::read(&base.join(&file.file), file)?;
                Self::of_file(record, Arc::new(origin)).map_err(in_scene)
            }
            Source::Generated(generated) => Self::of_formula(record, generated).map_err(in_scene),
        }
    }

    /// Uses a file that was read as `record` says.
    ///
    /// # Errors
    /// [`Refused`] with the place of a field of `record`.
    pub fn of_file(record: &RecordUse, origin: Arc<Origin>) -> Result<Self, Refused> {
        check::check_record(record)?;
        let file = origin.file.clone();
        let read = file.into_record(record.gravity_m_per_s2).map_err(at("record.gravity_m_per_s2"))?;
        let (record, scale) = used(record, read)?;
        Ok(Self {
            record,
            scale,
            origin: Some(origin),
        })
    }

    /// Uses a motion from a formula as `record` says.
    ///
    /// # Errors
    /// [`Refused`] with the place of a field of `record`.
    pub fn of_formula(record: &RecordUse, generated: &Generated) -> Result<Self, Refused> {
        check::check_record(record)?;
        let made = generated.record()?;
        let (record, scale) = used(record, made)?;
        Ok(Self {
            record,
            scale,
            origin: None,
        })
    }
}

impl GroundMotion {
    /// Uses a given record as `record` says, whatever its source.
    ///
    /// # Errors
    /// [`Refused`] with the place of a field of `record`.
    pub fn of_record(record: &RecordUse, at_hand: Record) -> Result<Self, Refused> {
        check::check_record(record)?;
        let (record, scale) = used(record, at_hand)?;
        Ok(Self {
            record,
            scale,
            origin: None,
        })
    }

    /// Reads a record file from its bytes, which came from `path`, and uses it as `record` says.
    ///
    /// # Errors
    /// Refuses bytes that cannot be read as a record, and processing in `scene` that does not suit it.
    pub fn of_bytes(record: &RecordUse, path: &Path, bytes: &[u8], scene: &str) -> Result<Self, Error> {
        let declared = match &record.source {
            Source::File(file) => file,
            Source::Generated(_) => &FileUse::default(),
        };
        let origin = Origin::of(path, bytes, declared)?;
        Self::of_file(record, Arc::new(origin)).map_err(|refused| Error::in_scene(scene, refused))
    }
}

/// A ground motion that many scenes share, as in a sweep.
#[derive(Debug, Clone)]
pub struct SharedMotion {
    pub(crate) record: Arc<Record>,
    pub(crate) scale: f64,
    /// The file of the motion; `None` for a motion from a formula.
    pub origin: Option<Arc<Origin>>,
}

impl SharedMotion {
    /// Returns the ground acceleration, processed, scaled, reversed.
    pub fn record(&self) -> &Record {
        &self.record
    }

    /// Returns the product of all factors on the source \[–\]; a reversal does not change its sign.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Multiplies the motion by `factor`, which comes from `record.scale`.
    ///
    /// # Errors
    /// [`Refused`] if the factor is not finite or too large.
    pub fn scaled(&self, factor: f64) -> Result<Self, Refused> {
        let record = self.record.scaled(factor).map_err(at("record.scale"))?;
        Ok(Self {
            record: Arc::new(record),
            scale: self.scale * factor,
            origin: self.origin.clone(),
        })
    }
}

impl From<GroundMotion> for SharedMotion {
    fn from(motion: GroundMotion) -> Self {
        Self {
            record: Arc::new(motion.record),
            scale: motion.scale,
            origin: motion.origin,
        }
    }
}

impl Origin {
    /// Returns the bytes of a record file.
    ///
    /// # Errors
    /// Refuses a missing file.
    pub fn bytes(path: &Path) -> Result<Vec<u8>, Error> {
        record_bytes(path).map_err(|error| {
            let said = format!(
                "{} cannot be read (it is looked for from the folder of the scene's file): {error}",
                path.display()
            );
            let refused = Refused::at("record.file").is(said).kind(RefusalKind::System(error.kind()));
            // Nobody types a control character: the path `"records\\new.csv"` in double quotes has a line break.
            let is_escape = path.to_string_lossy().chars().any(char::is_control);
            let escape = format!("in double quotes a backslash begins an escape: write {}", FOR_A_BACKSLASH[0]);
            if is_escape { refused.help(escape) } else { refused }.into()
        })
    }

    /// Reads a file with these declarations.
    ///
    /// # Errors
    /// Refuses a missing file, and what [`Self::of`] refuses.
    pub fn read(path: &Path, declared: &FileUse) -> Result<Self, Error> {
        Self::of(path, &Self::bytes(path)?, declared)
    }

    /// Reads the bytes of the file `path` with these declarations.
    ///
    /// # Errors
    /// Refuses bytes that cannot be read as a record. Also refuses values that are not accelerations by the name of the file, if nothing
    /// else shows their quantity.
    pub fn of(path: &Path, bytes: &[u8], declared: &FileUse) -> Result<Self, Error> {
        if let Some(axis) = declared.axis_deg {
            return pair::along(axis, path, bytes, declared);
        }
        let file = read_declared(bytes, &declared.declared());
        let file = file.map_err(|refused| refused.by(declared.naming).in_file(path))?;
        let is_said = file.states_acceleration() || declared.acceleration;
        match name_says_otherwise(path, declared).filter(|_| !is_said) {
            Some(refused) => Err(refused.into()),
            None => Ok(Self {
                path: path.to_path_buf(),
                sha256: sha256(bytes),
                file,
            }),
        }
    }

    /// Reads the bytes of one of several files. It takes only the declarations that this file needs, and returns them, too.
    ///
    /// # Errors
    /// Errors of [`Self::of`].
    pub fn of_silent(path: &Path, bytes: &[u8], declared: &FileUse) -> Result<(Self, FileUse), Error> {
        let mut taken = FileUse {
            unit: None,
            time_step_s: None,
            per_count: None,
            acceleration: false,
            in_rows: false,
            ..declared.clone()
        };
        loop {
            let tried = Self::of(path, bytes, &taken);
            let before = taken.clone();
            match tried.as_ref().err().and_then(|error| error.refused().wanted()) {
                Some(Knob::TimeStep) => taken.time_step_s = declared.time_step_s,
                Some(Knob::Unit | Knob::PerCount) => (taken.unit, taken.per_count) = (declared.unit, declared.per_count),
                Some(Knob::Acceleration) => taken.acceleration = declared.acceleration,
                Some(Knob::InRows) => taken.in_rows = declared.in_rows,
                _ => {}
            }
            if taken == before {
                let tried = tried.map_err(|error| said_by_name(path, error, declared));
                return tried.map(|origin| (origin, taken));
            }
        }
    }
}

/// Returns the error of a file that needs a declaration. If its name shows that it holds no accelerations, that is the error, because no
/// declaration helps.
fn said_by_name(path: &Path, error: Error, declared: &FileUse) -> Error {
    let wanted = error.refused().wanted();
    let lacks = wanted.is_some_and(|knob| [Knob::TimeStep, Knob::Unit, Knob::PerCount].contains(knob));
    let otherwise = name_says_otherwise(path, declared);
    match otherwise.filter(|_| lacks && !declared.acceleration) {
        Some(refused) => refused.into(),
        None => error,
    }
}

/// Returns the refusal of a file whose name shows that it holds no accelerations; `None` if the name does not.
fn name_says_otherwise(path: &Path, declared: &FileUse) -> Option<Refused> {
    let (what, kind) = match NamedFile::of(shown_name(path)).quantity? {
        Quantity::Acceleration => return None,
        Quantity::Velocity => ("velocity", RefusalKind::Velocity),
        Quantity::Displacement => ("displacement", RefusalKind::Displacement),
        Quantity::Spectrum => ("spectrum", RefusalKind::OtherQuantity),
    };
    let says = format!("the name says {what}, and the file does not say that its values are accelerations");
    let says = Refused::at(path).is(says).kind(kind).wants(Knob::Acceleration);
    let help = says.help("take the record of accelerations, or declare ").and(Knob::Acceleration);
    Some(help.by(declared.naming))
}

impl FileUse {
    /// Converts the declarations for the reader.
    fn declared(&self) -> Declared {
        Declared {
            unit: self.unit.map(crate::file::Unit::to_motion),
            time_step: self.time_step_s,
            component: self.component.clone(),
            per_count: self.per_count,
            acceleration: self.acceleration,
            in_rows: self.in_rows,
        }
    }
}

/// Returns the SHA-256 of bytes in hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

/// Writes bytes in hexadecimal digits.
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut digits, byte| {
        write!(digits, "{byte:02x}").expect("a string takes all");
        digits
    })
}

/// Adds the field of a scene to a refusal of its value.
fn at(place: &'static str) -> impl Fn(Refused) -> Refused {
    move |refused| in_setting(place, refused)
}

/// Processes a record as the scene asks for, and returns the product of all factors.
fn used(record: &RecordUse, mut used: Record) -> Result<(Record, f64), Refused> {
    if let Some(trend) = record.detrend {
        used = used.detrended(trend.to_motion()).map_err(at("record.detrend"))?;
    }
    if let Some(band) = record.band_pass {
        used = used.band_passed(&band.to_motion()).map_err(at("record.band_pass"))?;
    }
    if record.interpolation == Interpolation::BandLimited {
        used = used.band_limited().map_err(at("record"))?;
    }
    if let Some(time_step) = record.resample_s {
        used = used.resampled(time_step).map_err(at("record.resample_s"))?;
    }
    let (_, before) = used.peak();
    match record.scale_to {
        None => {}
        Some(ScaleTo::PgaG(peak)) => {
            used = used
                .scaled_to_peak(peak * record.gravity_m_per_s2)
                .map_err(at("record.scale_to.pga_g"))?;
        }
        Some(ScaleTo::Sa {
            period_s,
            damping_ratio,
            sa_g,
        }) => {
            let target = sa_g * record.gravity_m_per_s2;
            used = crate::scaled_to_sa(&used, period_s, damping_ratio, target).map_err(at("record.scale_to.sa"))?;
        }
    }
    let (_, after) = used.peak();
    let target = match record.scale_to {
        Some(_) if before != 0.0 => after / before,
        _ => 1.0,
    };
    used = used.scaled(record.scale).map_err(at("record.scale"))?;
    let scaled = if record.reversed { used.reversed() } else { used };
    Ok((scaled, target * record.scale))
}
