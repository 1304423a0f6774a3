//! The converged tables as CSV.

use super::quantities::{MEETINGS, Quantities, find};
use super::{Converged, LEVELS, TIME_STEPS};
use crate::paper::tables::Value;
use crate::statistics::{quantile, sorted};
use pounding_text::{Cell, Table, digits};

/// Share of the noisy runs below a band, and share above it \[–\].
const TAIL: f64 = 0.05;

impl Converged {
    /// The rows of a table with the published numbers, as CSV text.
    pub(super) fn table(&self, table: &str, published: &Quantities) -> String {
        let steps = TIME_STEPS
            .into_iter()
            .zip(&self.finer)
            .filter(|(_, values)| values.contains_key(table));
        let of = |values: &Quantities, row: &Value| find(values, table, row);
        let relative = |row: &Value| {
            let exact = of(&self.exact, row).filter(|exact| *exact != 0.0)?;
            Some(of(published, row)? / exact - 1.0)
        };
        let mut text = Table::of(rows(&[&self.exact, published], table))
            .column("row", |row| row.row.clone())
            .column("quantity", |row| row.quantity.clone())
            .column("unit", |row| row.unit)
            .column("published", |row| of(published, row))
            .column("as_stepped", |row| of(&self.stepped, row))
            .columns(
                steps,
                |(step, _)| format!("stepped_{}_ms", digits(1e3 * step).replace('.', "_")),
                |row, (_, values)| of(values, row),
            )
            .column("exact", |row| of(&self.exact, row))
            .column("published_over_exact_minus_1", |row| {
                Cell::number(relative(row), |value| format!("{value:.1e}"))
            });
        for (level, sigma) in LEVELS.into_iter().enumerate() {
            let band = move |row: &Value| self.band(level, table, row);
            text = text
                .column(format!("noise_{sigma:e}_quantile_5"), move |row| band(row).map(|band| band.0))
                .column(format!("noise_{sigma:e}_quantile_95"), move |row| band(row).map(|band| band.1));
        }
        text.csv()
    }

    /// Lower and upper end of a band. `None` if a run lacks the row, or has more or fewer meetings: its fifth meeting may then be another
    /// one.
    pub(super) fn band(&self, level: usize, table: &str, row: &Value) -> Option<(f64, f64)> {
        let values = self
            .noisy
            .get(level)?
            .iter()
            .map(|values| find(values, table, row).filter(|_| self.meet_alike(values, table, row)));
        let values = sorted(values.collect::<Option<Vec<f64>>>()?.into_iter());
        Some((quantile(&values, TAIL)?, quantile(&values, 1.0 - TAIL)?))
    }

    /// Whether a run has as many meetings as the exact run. Only rows of a single meeting are tested; every other row passes.
    fn meet_alike(&self, values: &Quantities, table: &str, row: &Value) -> bool {
        let counts = self
            .exact
            .get(table)
            .into_iter()
            .flatten()
            .filter(|value| value.quantity == MEETINGS && value.row != row.row && row.row.starts_with(&value.row));
        let same = |count: &Value| find(values, table, count) == Some(count.value);
        counts.into_iter().all(same)
    }
}

/// The distinct rows of all sources, in the order in which they first appear.
fn rows<'a>(sources: &[&'a Quantities], table: &str) -> Vec<&'a Value> {
    let mut rows: Vec<&Value> = Vec::new();
    for value in sources.iter().filter_map(|source| source.get(table)).flatten() {
        if !rows.iter().any(|row| row.row == value.row && row.quantity == value.quantity) {
            rows.push(value);
        }
    }
    rows
}
