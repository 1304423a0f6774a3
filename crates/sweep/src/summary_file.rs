//! The summary in a sweep file, and its errors.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Statistics over all runs instead of a row for each.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "SummaryFile")]
#[schemars(with = "SummaryFile")]
pub struct Summary {
    /// Fields with listed values. Each value, and each combination of several fields, has a separate summary: a cell.
    pub by: Vec<String>,
    /// Probabilities, 0 to 1, of the quantiles.
    pub quantiles: Vec<f64>,
    /// Thresholds of a quantity, or of a column by its name.
    pub exceedance: BTreeMap<String, Vec<f64>>,
    /// Whether rows are written, too.
    pub rows: bool,
}

/// A summary in the words of a file.
#[derive(Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(inline)]
struct SummaryFile {
    /// Fields of `vary` with a grid or a list of values, `record` or `reversed`. Each value, and each combination of several fields, has a
    /// separate summary.
    by: Vec<String>,
    /// Probabilities, 0 to 1, of the quantiles.
    quantiles: Vec<f64>,
    /// Thresholds whose exceedances are counted, by quantity (for all of its columns) or by column.
    exceedance: BTreeMap<String, Vec<f64>>,
    /// Whether the table of rows is written, too.
    rows: bool,
}

impl Default for SummaryFile {
    fn default() -> Self {
        Self {
            by: Vec::new(),
            quantiles: vec![0.05, 0.16, 0.5, 0.84, 0.95, 0.99],
            exceedance: BTreeMap::new(),
            rows: false,
        }
    }
}

/// Numbers of a summary that are out of range.
#[derive(Debug, thiserror::Error)]
enum WordsError {
    #[error("quantiles: found {}, allowed are shares of the runs from 0 to 1, such as 0.95", pounding_text::plain(*.0))]
    Quantile(f64),
    #[error("exceedance: found no threshold of `{0}`, allowed is one number or more; delete the entry")]
    NoThreshold(String),
    #[error("exceedance: found {} for `{name}`, allowed are finite numbers", pounding_text::plain(*found))]
    Threshold { name: String, found: f64 },
}

impl TryFrom<SummaryFile> for Summary {
    type Error = WordsError;

    fn try_from(words: SummaryFile) -> Result<Self, WordsError> {
        let mut quantiles = words.quantiles.iter();
        if let Some(wrong) = quantiles.find(|part| !(0.0..=1.0).contains(*part)) {
            return Err(WordsError::Quantile(*wrong));
        }
        for (name, thresholds) in &words.exceedance {
            if thresholds.is_empty() {
                return Err(WordsError::NoThreshold(name.clone()));
            }
            if let Some(found) = thresholds.iter().find(|number| !number.is_finite()) {
                return Err(WordsError::Threshold {
                    name: name.clone(),
                    found: *found,
                });
            }
        }
        Ok(Self {
            by: words.by,
            quantiles: words.quantiles,
            exceedance: words.exceedance,
            rows: words.rows,
        })
    }
}

/// Why a summary does not fit its sweep.
#[derive(Debug, thiserror::Error)]
pub enum SummaryError {
    /// A field without listed values.
    #[error("summary.by: found `{found}`, allowed are what has listed values: {allowed}; give the field a `grid` or `values` in `vary`")]
    By {
        /// The name found.
        found: String,
        /// The names allowed.
        allowed: String,
    },
    /// A field that is named twice.
    #[error("summary.by: found `{0}` a second time, allowed is once; delete one")]
    Twice(String),
    /// Too many cells.
    #[error("summary.by: found {found} cells, allowed are up to {allowed}; leave one out of `by`, or take fewer values")]
    Cells {
        /// Number of cells.
        found: u64,
        /// Number of cells allowed.
        allowed: u64,
    },
    /// A threshold of an unknown output.
    #[error(
        "summary.exceedance: found `{found}`, allowed are {allowed}, and names of columns; add the quantity to `outputs`, or name one of these"
    )]
    Column {
        /// The name found.
        found: String,
        /// The quantities allowed.
        allowed: String,
    },
}

impl SummaryError {
    /// The faulty entry of the file.
    pub(super) fn place(&self) -> &'static str {
        match self {
            Self::By { .. } | Self::Twice(_) | Self::Cells { .. } => "summary.by",
            Self::Column { .. } => "summary.exceedance",
        }
    }
}
