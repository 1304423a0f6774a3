//! The record of a scene and how it is used.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A record and how a scene uses it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Words", into = "Words")]
#[schemars(with = "Words")]
pub struct RecordUse {
    /// Where the ground motion comes from.
    pub source: Source,
    /// What one g is worth \[m/s²\].
    pub gravity_m_per_s2: f64,
    /// Factor on the ground acceleration \[–\].
    pub scale: f64,
    /// Whether the shaking is reversed (left becomes right).
    pub reversed: bool,
}

/// Where a ground motion comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A file.
    File(FileUse),
}

impl std::fmt::Display for Source {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::File(file) => formatter.write_str(&file.file),
        }
    }
}

/// A file of a record, and what it does not say of itself.
#[derive(Debug, Clone, PartialEq)]
pub struct FileUse {
    /// The file, relative to the folder of the file that names it.
    pub file: String,
}

/// One g \[m/s²\] where a scene does not say: the standard acceleration of gravity.
const STANDARD_GRAVITY: f64 = 9.80665;

/// A record and its use in the words of a file.
#[derive(Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct Words {
    /// File, relative to the folder of the file that names it.
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<String>,
    /// What one g is worth \[m/s²\], for files whose values are in g.
    #[serde(default = "standard_gravity")]
    gravity_m_per_s2: f64,
    /// Factor on the ground acceleration \[–\].
    #[serde(default = "one")]
    scale: f64,
    /// Whether the shaking is reversed (left becomes right).
    #[serde(default)]
    reversed: bool,
}

fn one() -> f64 {
    1.0
}

fn standard_gravity() -> f64 {
    STANDARD_GRAVITY
}

/// A record that a file gives in too few or too many words.
#[derive(Debug, thiserror::Error)]
enum WordsError {
    #[error("found no `file`, allowed is one; name the record")]
    NoSource,
}

impl TryFrom<Words> for RecordUse {
    type Error = WordsError;

    fn try_from(words: Words) -> Result<Self, WordsError> {
        let file = words.file.ok_or(WordsError::NoSource)?;
        Ok(Self {
            source: Source::File(FileUse { file }),
            gravity_m_per_s2: words.gravity_m_per_s2,
            scale: words.scale,
            reversed: words.reversed,
        })
    }
}

impl From<RecordUse> for Words {
    fn from(record: RecordUse) -> Self {
        let Source::File(FileUse { file }) = record.source;
        Self {
            file: Some(file),
            gravity_m_per_s2: record.gravity_m_per_s2,
            scale: record.scale,
            reversed: record.reversed,
        }
    }
}
