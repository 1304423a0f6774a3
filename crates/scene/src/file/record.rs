//! The ground motion of a scene and how it is used.

use pounding_motion::AccelerationUnit;
use pounding_text::{Naming, Refused, digits};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::choice;
use super::generated::Generated;
use super::processing::{Detrend, FilterBand, Interpolation, ScaleTo};

/// A ground motion and how a scene uses it.
///
/// The motion is taken from its source, detrended, filtered, made finer between its samples, resampled, scaled to a target, multiplied and reversed, in this order; steps
/// that are absent are skipped.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "RecordUseFile", into = "RecordUseFile")]
#[schemars(with = "RecordUseFile")]
pub struct RecordUse {
    /// Source of the ground motion.
    pub source: Source,
    /// Acceleration of gravity \[m/s²\].
    pub gravity_m_per_s2: f64,
    /// Straight line that is subtracted.
    pub detrend: Option<Detrend>,
    /// Band of frequencies that is kept.
    pub band_pass: Option<FilterBand>,
    /// What the motion is between its samples.
    pub interpolation: Interpolation,
    /// New time step \[s\], linear between samples.
    pub resample_s: Option<f64>,
    /// Target of the scaling.
    pub scale_to: Option<ScaleTo>,
    /// Factor on the ground acceleration \[–\].
    pub scale: f64,
    /// Whether the shaking is reversed (left becomes right).
    pub reversed: bool,
}

impl RecordUse {
    /// The direction of the shaking in words.
    pub fn direction(&self) -> &'static str {
        Self::direction_of(self.reversed)
    }

    /// A direction of shaking in words.
    pub fn direction_of(reversed: bool) -> &'static str {
        if reversed { "reversed" } else { "as given" }
    }

    /// Lists the processing of the ground motion between its source and the row, in its order; steps that change nothing are left out.
    pub fn processing(&self) -> Vec<String> {
        let axis = match &self.source {
            Source::File(file) => file.axis_deg,
            Source::Generated(_) => None,
        };
        let axis = axis.map(|axis| format!("two components along the axis of {}°", digits(axis)));
        let detrend = self.detrend.map(|line| match line {
            Detrend::Constant => "mean taken away".into(),
            Detrend::Linear => "straight line of least squares taken away".into(),
        });
        let band = self.band_pass.map(|band| {
            let passes = if band.causal { "forward" } else { "forward and backward" };
            format!(
                "band-pass {} to {} Hz, Butterworth, order {}, {passes}",
                digits(band.low_hz),
                digits(band.high_hz),
                band.order
            )
        });
        let finer = (!self.interpolation.is_linear()).then(|| "band-limited between samples".into());
        let resampled = self.resample_s.map(|step| format!("resampled every {step} s"));
        let target = self.scale_to.map(|target| match target {
            ScaleTo::PgaG(peak) => format!("scaled to a PGA of {peak} g"),
            ScaleTo::Sa {
                period_s,
                damping_ratio,
                sa_g,
            } => format!("scaled to Sa({period_s} s, damping {damping_ratio}) = {sa_g} g"),
        });
        let needs_g = target.is_some();
        let gravity = needs_g.then(|| format!("with g = {} m/s²", self.gravity_m_per_s2));
        let one = 1.0_f64.to_bits();
        let scale = (self.scale.to_bits() != one).then(|| format!("multiplied by {}", self.scale));
        let reversed = self.reversed.then(|| "reversed".into());
        let all = [axis, detrend, band, finer, resampled, target, gravity, scale, reversed];
        all.into_iter().flatten().collect()
    }

    /// Uses a ground motion unchanged.
    pub fn of(source: Source) -> Self {
        Self {
            source,
            gravity_m_per_s2: STANDARD_GRAVITY,
            detrend: None,
            band_pass: None,
            interpolation: Interpolation::Linear,
            resample_s: None,
            scale_to: None,
            scale: 1.0,
            reversed: false,
        }
    }
}

impl RecordUse {
    /// Returns the declarations of this record, for other files that replace it.
    pub fn declared(&self) -> FileUse {
        match &self.source {
            Source::File(file) => FileUse {
                file: String::new(),
                component: None,
                second_file: None,
                ..file.clone()
            },
            Source::Generated(_) => FileUse::default(),
        }
    }
}

/// Source of a ground motion.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A file.
    File(FileUse),
    /// A formula.
    Generated(Generated),
}

impl std::fmt::Display for Source {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::File(file) => formatter.write_str(&file.file),
            Self::Generated(generated) => generated.fmt(formatter),
        }
    }
}

/// The file of a record, and declarations for what the file does not say itself.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FileUse {
    /// The file, relative to the folder of the file that names it.
    pub file: String,
    /// Unit of its values.
    pub unit: Option<Unit>,
    /// Time between samples \[s\].
    pub time_step_s: Option<f64>,
    /// Component, by its name or its number from 1.
    pub component: Option<String>,
    /// Value of one count, in `unit`.
    pub per_count: Option<f64>,
    /// Whether the values are accelerations although the file suggests otherwise.
    pub acceleration: bool,
    /// Whether several numbers to a line without names are consecutive values.
    pub in_rows: bool,
    /// The file with the other horizontal component, in the folder of `file`; `None` if `file` holds both, or without an axis.
    pub second_file: Option<String>,
    /// Axis along which two horizontal components shake the row, clockwise from north \[°\]; `None` takes one component as it is.
    pub axis_deg: Option<f64>,
    /// Names that messages use for these declarations.
    pub naming: Naming,
}

impl FileUse {
    /// Lists the declarations except for the component, as in a scene: `unit = "g"`; empty if there are none.
    pub fn words(&self) -> String {
        let unit = self.unit.map(|unit| format!("unit = {:?}", unit.to_motion().name()));
        let step = self.time_step_s.map(|step| format!("time_step_s = {step}"));
        let count = self.per_count.map(|count| format!("per_count = {count}"));
        let acceleration = self.acceleration.then(|| "acceleration = true".into());
        let in_rows = self.in_rows.then(|| "in_rows = true".into());
        let words = [unit, step, count, acceleration, in_rows].into_iter();
        let words: Vec<String> = words.flatten().collect();
        words.join(", ")
    }
}

/// Unit of the values of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Unit {
    /// Multiples of g.
    #[serde(rename = "g")]
    StandardGravity,
    /// m/s².
    #[serde(rename = "m_per_s2")]
    MetrePerSecondSquared,
    /// cm/s², gal.
    #[serde(rename = "cm_per_s2")]
    CentimetrePerSecondSquared,
    /// mm/s².
    #[serde(rename = "mm_per_s2")]
    MillimetrePerSecondSquared,
    /// Thousandths of g.
    #[serde(rename = "mg")]
    MilliG,
    /// Tenths of g.
    #[serde(rename = "g_per_10")]
    TenthG,
}

impl Unit {
    /// Converts the unit for the reader of records.
    pub fn to_motion(self) -> AccelerationUnit {
        match self {
            Self::StandardGravity => AccelerationUnit::StandardGravity,
            Self::MetrePerSecondSquared => AccelerationUnit::MetrePerSecondSquared,
            Self::CentimetrePerSecondSquared => AccelerationUnit::CentimetrePerSecondSquared,
            Self::MillimetrePerSecondSquared => AccelerationUnit::MillimetrePerSecondSquared,
            Self::MilliG => AccelerationUnit::MilliG,
            Self::TenthG => AccelerationUnit::TenthG,
        }
    }
}

/// Standard acceleration of gravity \[m/s²\], the default of a scene.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// A ground motion and its use, as files give them.
#[derive(Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct RecordUseFile {
    /// File, relative to the folder of the file that names it; or `generated`.
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<String>,
    /// Motion without a file; or `file`.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "choice::maybe")]
    generated: Option<Generated>,
    /// Unit of the file's values, if the file does not give it.
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<Unit>,
    /// Time between the file's samples \[s\], if the file does not give it.
    #[serde(skip_serializing_if = "Option::is_none")]
    time_step_s: Option<f64>,
    /// Component of a file that holds several, by its name or its number from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    component: Option<ComponentWord>,
    /// Value of one count of the file, in `unit`.
    #[serde(skip_serializing_if = "Option::is_none")]
    per_count: Option<f64>,
    /// Whether the file holds accelerations although a seismometer's channel, `cm/s` or values of one sign suggest otherwise.
    #[serde(default, skip_serializing_if = "is_false")]
    acceleration: bool,
    /// Whether several numbers to a line without names are consecutive values.
    #[serde(default, skip_serializing_if = "is_false")]
    in_rows: bool,
    /// File with the other horizontal component, in the folder of `file`, with `axis_deg`.
    #[serde(skip_serializing_if = "Option::is_none")]
    second_file: Option<String>,
    /// Axis along which two horizontal components shake the row, clockwise from north \[°\].
    #[serde(skip_serializing_if = "Option::is_none")]
    axis_deg: Option<f64>,
    /// Acceleration of gravity \[m/s²\]; 9.80665 by default.
    #[serde(default = "standard_gravity")]
    gravity_m_per_s2: f64,
    /// Straight line that is subtracted.
    #[serde(skip_serializing_if = "Option::is_none")]
    detrend: Option<Detrend>,
    /// Band of frequencies that is kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    band_pass: Option<FilterBand>,
    /// What the motion is between its samples; `linear` by default.
    #[serde(default, skip_serializing_if = "Interpolation::is_linear")]
    interpolation: Interpolation,
    /// New time step \[s\], linear between samples.
    #[serde(skip_serializing_if = "Option::is_none")]
    resample_s: Option<f64>,
    /// Target of the scaling.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "choice::maybe")]
    scale_to: Option<ScaleTo>,
    /// Factor on the ground acceleration \[–\], after `scale_to`.
    #[serde(default = "one")]
    scale: f64,
    /// Whether the shaking is reversed (left becomes right).
    #[serde(default)]
    reversed: bool,
}

/// The name of a component, or its number.
#[derive(Clone, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(inline)]
enum ComponentWord {
    Name(String),
    Number(u32),
}

impl From<ComponentWord> for String {
    fn from(word: ComponentWord) -> Self {
        match word {
            ComponentWord::Name(name) => name,
            ComponentWord::Number(number) => number.to_string(),
        }
    }
}

fn one() -> f64 {
    1.0
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands a reference")]
fn is_false(value: &bool) -> bool {
    !value
}

fn standard_gravity() -> f64 {
    STANDARD_GRAVITY
}

impl TryFrom<RecordUseFile> for RecordUse {
    type Error = Refused;

    fn try_from(words: RecordUseFile) -> Result<Self, Refused> {
        let source = match (words.file, words.generated) {
            (None, None) => {
                let neither = Refused::default().found("neither `file` nor `generated`");
                return Err(neither.allowed_is("one of them").help("name the record"));
            }
            (Some(_), Some(_)) => {
                let both = Refused::default().found("both `file` and `generated`");
                return Err(both.allowed_is("one of them").help("delete the other"));
            }
            (Some(file), None) => Source::File(FileUse {
                file,
                second_file: words.second_file,
                axis_deg: words.axis_deg,
                unit: words.unit,
                time_step_s: words.time_step_s,
                component: words.component.map(String::from),
                per_count: words.per_count,
                acceleration: words.acceleration,
                in_rows: words.in_rows,
                naming: Naming::Scene,
            }),
            (None, Some(generated)) => {
                let of_file = [
                    ("unit", words.unit.is_some()),
                    ("time_step_s", words.time_step_s.is_some()),
                    ("component", words.component.is_some()),
                    ("per_count", words.per_count.is_some()),
                    ("acceleration", words.acceleration),
                    ("in_rows", words.in_rows),
                    ("second_file", words.second_file.is_some()),
                    ("axis_deg", words.axis_deg.is_some()),
                ];
                if let Some((field, _)) = of_file.into_iter().find(|(_, given)| *given) {
                    let found = Refused::default().found(format!("`{field}` beside `generated`"));
                    return Err(found.allowed_is("it beside `file`").help("delete it"));
                }
                Source::Generated(generated)
            }
        };
        Ok(Self {
            source,
            gravity_m_per_s2: words.gravity_m_per_s2,
            detrend: words.detrend,
            band_pass: words.band_pass,
            interpolation: words.interpolation,
            resample_s: words.resample_s,
            scale_to: words.scale_to,
            scale: words.scale,
            reversed: words.reversed,
        })
    }
}

impl From<RecordUse> for RecordUseFile {
    fn from(record: RecordUse) -> Self {
        let (file, generated) = match record.source {
            Source::File(file) => (Some(file), None),
            Source::Generated(generated) => (None, Some(generated)),
        };
        let of_file = file.clone().unwrap_or_default();
        Self {
            file: file.map(|file| file.file),
            generated,
            unit: of_file.unit,
            time_step_s: of_file.time_step_s,
            component: of_file.component.map(ComponentWord::Name),
            per_count: of_file.per_count,
            acceleration: of_file.acceleration,
            in_rows: of_file.in_rows,
            second_file: of_file.second_file,
            axis_deg: of_file.axis_deg,
            gravity_m_per_s2: record.gravity_m_per_s2,
            detrend: record.detrend,
            band_pass: record.band_pass,
            interpolation: record.interpolation,
            resample_s: record.resample_s,
            scale_to: record.scale_to,
            scale: record.scale,
            reversed: record.reversed,
        }
    }
}
