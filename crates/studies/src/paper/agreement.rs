//! Published numbers against computed ones, number by number.

use crate::StudyError;
use crate::listed::listed;
use crate::paper::printed::{Printed, PrintedDigits};
use crate::paper::tables::Value;
use pounding_text::{Cell, Table};
use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;

/// Largest relative difference of a number that counts as reproduced.
pub const REPRODUCED: f64 = 1e-3;
/// Largest relative difference of a number that counts as close.
pub const CLOSE: f64 = 3e-2;

listed! {
    /// How a computed number compares with the published one.
    #[derive(Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Verdict { words: &'static str;
        /// Within [`REPRODUCED`]. A published 0 counts only if the computed number is 0 too.
        Reproduced = "reproduced",
        /// Within [`CLOSE`].
        Close = "close",
        /// Further away than [`CLOSE`], or not computed at all.
        Differs = "differs",
        /// Published by another work whose inputs are unknown; a difference says nothing.
        #[serde(rename = "not comparable")]
        NotComparable = "not comparable",
    }
}

impl Verdict {
    fn of(published: f64, computed: f64) -> Self {
        let difference = relative_difference(published, computed);
        if difference <= REPRODUCED {
            Self::Reproduced
        } else if difference <= CLOSE {
            Self::Close
        } else {
            Self::Differs
        }
    }
}

/// abs(computed − published)/abs(published). For a published 0 it is 0 if the computed number is 0, else infinite.
fn relative_difference(published: f64, computed: f64) -> f64 {
    let difference = (computed - published).abs();
    if difference == 0.0 {
        0.0
    } else {
        // A published 0 gives infinity: only a computed 0 reproduces it.
        difference / published.abs()
    }
}

/// A number as the paper prints it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// Table, or `text`.
    pub table: String,
    /// Row of the table.
    pub row: String,
    /// Quantity.
    pub quantity: String,
    /// Unit.
    pub unit: String,
    /// The number as printed.
    pub published: Printed,
}

/// A known disagreement: the reason why a number, or only its last printed digit, is not reproduced.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reason {
    /// Table, or `text`.
    pub table: String,
    /// Row of the table.
    pub row: String,
    /// Quantity.
    pub quantity: String,
    /// The known verdict.
    pub verdict: Verdict,
    /// The reason.
    pub reason: String,
}

/// One row of the agreement.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The published number.
    pub published: Published,
    /// The computed number; `None` if no study gives it.
    pub computed: Option<f64>,
    /// The verdict on both numbers.
    pub verdict: Verdict,
    /// Whether the computed number gives the printed digits.
    pub digits: PrintedDigits,
    /// The reason why the number, or its last printed digit, is not reproduced; empty if none is known.
    pub reason: String,
}

impl Comparison {
    /// abs(computed − published)/abs(published) \[–\]; infinite if 0 is published and another number computed. `None` if none is computed.
    pub(crate) fn relative_difference(&self) -> Option<f64> {
        let computed = self.computed?;
        Some(relative_difference(self.published.published.value, computed))
    }
}

/// The published numbers of the paper and the known disagreements with them.
#[derive(Debug, Clone, PartialEq)]
pub struct PublishedValues {
    values: Vec<Published>,
    reasons: Vec<Reason>,
}

type Key<'a> = (&'a str, &'a str, &'a str);

impl Published {
    fn key(&self) -> Key<'_> {
        (&self.table, &self.row, &self.quantity)
    }
}

impl Reason {
    fn key(&self) -> Key<'_> {
        (&self.table, &self.row, &self.quantity)
    }
}

impl PublishedValues {
    /// Reads `table-*.csv`, `text.csv` and `reasons.csv` of a folder.
    ///
    /// # Errors
    /// [`StudyError`] with the file, and with the line if the fault has one.
    pub fn read(folder: &Path) -> Result<Self, StudyError> {
        let mut values = Vec::new();
        for name in ["table-2", "table-4", "table-5", "table-6", "table-7", "text"] {
            values.extend(read_csv(&folder.join(name).with_extension("csv"))?);
        }
        Ok(Self {
            values,
            reasons: read_csv(&folder.join("reasons.csv"))?,
        })
    }

    /// The numbers as printed, in the order of the tables.
    pub(crate) fn values(&self) -> &[Published] {
        &self.values
    }

    /// Compares every published number with the computed one of the same table, row and quantity.
    pub fn compare(&self, computed: &BTreeMap<String, Vec<Value>>) -> Vec<Comparison> {
        let mut found: BTreeMap<Key<'_>, (f64, &str)> = BTreeMap::new();
        for (table, values) in computed {
            for value in values {
                found.insert((table, &value.row, &value.quantity), (value.value, value.unit));
            }
        }
        let compare = |published: &Published| {
            let key = published.key();
            let computed = found.get(&key).filter(|(_, unit)| *unit == published.unit).map(|(value, _)| *value);
            let known = self.reasons.iter().find(|reason| reason.key() == key);
            let verdict = match known {
                Some(reason) if reason.verdict == Verdict::NotComparable => Verdict::NotComparable,
                _ => computed.map_or(Verdict::Differs, |value| Verdict::of(published.published.value, value)),
            };
            let digits = computed.map_or(PrintedDigits::Other, |value| PrintedDigits::of(&published.published, value));
            let reason = known.map(|known| known.reason.clone()).unwrap_or_default();
            Comparison {
                published: published.clone(),
                computed,
                verdict,
                digits,
                reason,
            }
        };
        self.values.iter().map(compare).collect()
    }

    /// Messages about disagreements that are not listed, and about listed ones that have vanished or changed.
    pub fn surprises(&self, comparisons: &[Comparison]) -> Vec<String> {
        let mut surprises = Vec::new();
        for Comparison {
            published,
            verdict,
            digits,
            reason,
            ..
        } in comparisons
        {
            let known = self.reasons.iter().find(|reason| reason.key() == published.key());
            let known = known.map_or(Verdict::Reproduced, |reason| reason.verdict);
            let number = format!("table {}, {}, {}", published.table, published.row, published.quantity);
            if known != *verdict {
                surprises.push(format!(
                    "{number}: found \"{}\", studies/published/reasons.csv says \"{}\"",
                    verdict.words(),
                    known.words()
                ));
            } else if *digits == PrintedDigits::Other && reason.is_empty() {
                surprises.push(format!(
                    "{number}: found other digits than printed, \
                     studies/published/reasons.csv gives no reason"
                ));
            } else if *digits != PrintedDigits::Other && *verdict == Verdict::Reproduced && !reason.is_empty() {
                surprises.push(format!(
                    "{number}: found as printed, studies/published/reasons.csv gives a reason why not"
                ));
            }
        }
        for reason in &self.reasons {
            let key = reason.key();
            if !self.values.iter().any(|value| value.key() == key) {
                surprises.push(format!("reasons.csv names a number that is not published: {key:?}"));
            }
        }
        surprises
    }
}

/// The agreement as CSV text.
pub fn agreement_csv(comparisons: &[Comparison]) -> String {
    Table::of(comparisons)
        .column("table", |one| one.published.table.clone())
        .column("row", |one| one.published.row.clone())
        .column("quantity", |one| one.published.quantity.clone())
        .column("unit", |one| one.published.unit.clone())
        .column("published", |one| one.published.published.text().to_string())
        .column("computed", |one| one.computed)
        .column("relative_difference", |one| {
            Cell::number(one.relative_difference(), |value| format!("{value:.1e}"))
        })
        .column("verdict", |one| one.verdict.words())
        .column("printed_digits", |one| one.digits.words())
        .column("reason", |one| one.reason.clone())
        .csv()
}

fn read_csv<Row: for<'de> Deserialize<'de>>(path: &Path) -> Result<Vec<Row>, StudyError> {
    let csv = |source| StudyError::Csv {
        path: path.to_path_buf(),
        source,
    };
    csv::Reader::from_path(path)
        .map_err(csv)?
        .deserialize()
        .collect::<Result<_, _>>()
        .map_err(csv)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_verdicts_at_their_bounds() {
        for (published, computed, verdict) in [
            (100.0, 100.1, Verdict::Reproduced),
            (100.0, 100.11, Verdict::Close),
            (-100.0, -97.0, Verdict::Close),
            (-100.0, -96.9, Verdict::Differs),
            (-100.0, 100.0, Verdict::Differs),
            (0.0, 0.0, Verdict::Reproduced),
            (0.0, 1e-300, Verdict::Differs),
            (1.0, f64::NAN, Verdict::Differs),
        ] {
            assert_eq!(Verdict::of(published, computed), verdict, "{published} against {computed}");
        }
    }
}
