//! The summary in a sweep file, and its errors.

use pounding_text::{Refused, plain};
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

impl TryFrom<SummaryFile> for Summary {
    type Error = Refused;

    fn try_from(words: SummaryFile) -> Result<Self, Refused> {
        let mut quantiles = words.quantiles.iter();
        if let Some(wrong) = quantiles.find(|part| !(0.0..=1.0).contains(*part)) {
            let wrong = Refused::at("quantiles").found(plain(*wrong));
            return Err(wrong.allowed_are("shares of the runs from 0 to 1, such as 0.95"));
        }
        for (name, thresholds) in &words.exceedance {
            if thresholds.is_empty() {
                let none = Refused::at("exceedance").found(format!("no threshold of `{name}`"));
                return Err(none.allowed_is("one number or more").help("delete the entry"));
            }
            if let Some(found) = thresholds.iter().find(|number| !number.is_finite()) {
                let found = Refused::at("exceedance").found(format!("{} for `{name}`", plain(*found)));
                return Err(found.allowed_are("finite numbers"));
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
