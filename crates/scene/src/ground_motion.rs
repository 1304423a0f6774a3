//! From the use of a record in a scene to the ground motion that shakes a row.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::file::{FileUse, Generated, ScaleTo, check};
use crate::{Error, MotionError, RecordUse, SceneError, Source, record_bytes};
use pounding_motion::{Accelerogram, Declared, ReadError, Record, RecordError, read_declared};
use sha2::{Digest, Sha256};

/// A ground motion as a scene uses it, and where it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundMotion {
    /// The ground acceleration \[m/s²\], processed, scaled, reversed.
    pub record: Record,
    /// What its source was multiplied by, all scales together \[–\]; without the sign of a reversal.
    pub scale: f64,
    /// The file; nothing for a motion from a formula.
    pub origin: Option<Origin>,
}

/// A file that a ground motion came from.
#[derive(Debug, Clone, PartialEq)]
pub struct Origin {
    /// The file; empty for one that was never opened.
    pub path: PathBuf,
    /// SHA-256 of its bytes, in hexadecimal digits.
    pub sha256: String,
    /// What it holds.
    pub file: Accelerogram,
}

impl GroundMotion {
    /// Reads or generates the ground motion of a scene; `base` is the folder that its file is named from.
    ///
    /// # Errors
    /// [`Error::NoRecord`], [`Error::Record`] for a file that cannot be read, and what cannot be done to it in
    /// `scene`.
    pub fn of(record: &RecordUse, base: &Path, scene: &str) -> Result<Self, Error> {
        let in_scene = |source| Error::Scene {
            scene: scene.into(),
            source,
        };
        match &record.source {
            Source::File(file) => {
                let origin = Origin::read(file, base)?;
                Self::of_file(record, origin).map_err(in_scene)
            }
            Source::Generated(generated) => Self::of_formula(record, generated).map_err(in_scene),
        }
    }

    /// A file at hand, used as a scene says.
    ///
    /// # Errors
    /// [`SceneError`] of a field of `record`.
    pub fn of_file(record: &RecordUse, origin: Origin) -> Result<Self, SceneError> {
        check::record::check(record)?;
        let file = origin.file.clone();
        let read = file
            .into_record(record.gravity_m_per_s2)
            .map_err(at("record.gravity_m_per_s2"))?;
        let (record, scale) = used(record, read)?;
        Ok(Self {
            record,
            scale,
            origin: Some(origin),
        })
    }

    /// A motion from a formula, used as a scene says.
    ///
    /// # Errors
    /// [`SceneError`] of a field of `record`.
    pub fn of_formula(record: &RecordUse, generated: &Generated) -> Result<Self, SceneError> {
        check::record::check(record)?;
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
    /// A record at hand, used as a scene says, whatever its source.
    ///
    /// # Errors
    /// [`SceneError`] of a field of `record`.
    pub fn of_record(record: &RecordUse, at_hand: Record) -> Result<Self, SceneError> {
        check::record::check(record)?;
        let (record, scale) = used(record, at_hand)?;
        Ok(Self {
            record,
            scale,
            origin: None,
        })
    }

    /// Reads the file of a record from its bytes, which came from `path`, and uses it as a scene says.
    ///
    /// # Errors
    /// [`Error::Record`] for bytes that cannot be read, and what cannot be done to it in `scene`.
    pub fn of_bytes(
        record: &RecordUse,
        (path, bytes): (&Path, &[u8]),
        scene: &str,
    ) -> Result<Self, Error> {
        let declared = match &record.source {
            Source::File(file) => file.declared(),
            Source::Generated(_) => Declared::default(),
        };
        let origin = Origin::of(path.to_path_buf(), bytes, &declared)?;
        Self::of_file(record, origin).map_err(|source| Error::Scene {
            scene: scene.into(),
            source,
        })
    }
}

/// A ground motion that scenes share: a sweep runs many under one.
#[derive(Debug, Clone)]
pub struct SharedMotion {
    pub(crate) record: Arc<Record>,
    pub(crate) scale: f64,
    /// The file that it came from; nothing for one from a formula.
    pub origin: Option<Arc<Origin>>,
}

impl SharedMotion {
    /// Returns the ground acceleration, processed, scaled, reversed.
    pub fn record(&self) -> &Record {
        &self.record
    }

    /// Returns what its source was multiplied by, all scales together \[–\]; without the sign of a reversal.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The same, multiplied once more by `factor`, which comes from `record.scale`.
    ///
    /// # Errors
    /// [`SceneError`] of a factor that is not finite or too large.
    pub fn scaled(&self, factor: f64) -> Result<Self, SceneError> {
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
            origin: motion.origin.map(Arc::new),
        }
    }
}

impl Origin {
    fn read(file: &FileUse, base: &Path) -> Result<Self, Error> {
        let path = base.join(&file.file);
        let bytes = match record_bytes(&path) {
            Ok(bytes) => bytes,
            Err(source) => return Err(Error::NoRecord { path, source }),
        };
        Self::of(path, &bytes, &file.declared())
    }

    fn of(path: PathBuf, bytes: &[u8], declared: &Declared) -> Result<Self, Error> {
        match read_declared(bytes, declared) {
            Ok(file) => Ok(Self {
                path,
                sha256: sha256(bytes),
                file,
            }),
            Err(source) => Err(Error::Record { path, source }),
        }
    }
}

impl FileUse {
    /// What is said of the file that it may not say itself.
    fn declared(&self) -> Declared {
        Declared {
            unit: self.unit.map(crate::file::Unit::to_motion),
            time_step: self.time_step_s,
            component: self.component.clone(),
            per_count: self.per_count,
            acceleration: self.acceleration,
            in_rows: false,
        }
    }

    /// Tries a file as it is, and declares of it only what it is refused for not saying.
    ///
    /// # Errors
    /// Those of the attempt.
    pub fn where_unsaid<T>(
        &self,
        mut attempt: impl FnMut(&Self) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let mut file = Self {
            unit: None,
            time_step_s: None,
            per_count: None,
            ..self.clone()
        };
        // The time step, then the unit.
        for _ in 0..2 {
            let tried = attempt(&file);
            let Err(Error::Record { source, .. }) = &tried else {
                return tried;
            };
            let no_step = matches!(source, ReadError::TimeStepNotStated);
            let no_unit = matches!(source, ReadError::UnitNotStated | ReadError::Counts { .. });
            if no_step && file.time_step_s.is_none() && self.time_step_s.is_some() {
                file.time_step_s = self.time_step_s;
            } else if no_unit && file.unit.is_none() && self.unit.is_some() {
                (file.unit, file.per_count) = (self.unit, self.per_count);
            } else {
                return tried;
            }
        }
        attempt(&file)
    }
}

/// SHA-256 of some bytes in hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

/// Bytes in hexadecimal digits.
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut digits, byte| {
        write!(digits, "{byte:02x}").expect("a string takes all");
        digits
    })
}

/// Names the field of a scene that asks for what is refused.
fn at(place: &'static str) -> impl Fn(RecordError) -> MotionError {
    move |error| MotionError::of(place, &error)
}

/// The record as the scene uses it, and what it was multiplied by.
fn used(record: &RecordUse, mut used: Record) -> Result<(Record, f64), MotionError> {
    if let Some(trend) = record.detrend {
        used = used
            .detrended(trend.to_motion())
            .map_err(at("record.detrend"))?;
    }
    if let Some(band) = record.band_pass {
        used = used
            .band_passed(&band.to_motion())
            .map_err(at("record.band_pass"))?;
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
            used = crate::scaled_to_sa(&used, period_s, damping_ratio, target)
                .map_err(|error| MotionError::of_spectrum("record.scale_to.sa", error))?;
        }
    }
    let (_, after) = used.peak();
    let target = match record.scale_to {
        Some(_) if before != 0.0 => after / before,
        _ => 1.0,
    };
    used = used.scaled(record.scale).map_err(at("record.scale"))?;
    let scaled = if record.reversed {
        used.reversed()
    } else {
        used
    };
    Ok((scaled, target * record.scale))
}
