//! The converged tables as CSV.

use super::quantities::{MEETINGS, Quantities, find};
use super::{Converged, LEVELS, TIME_STEPS};
use crate::paper::tables::{Value, to_csv};
use crate::statistics::quantile;
use pounding_text::digits;

/// Share of the noisy runs below the lower end of a band, and above the upper one.
const TAIL: f64 = 0.05;

impl Converged {
    /// The rows of a table as CSV text, beside the published ones.
    pub(super) fn table(&self, table: &str, published: &Quantities) -> String {
        let has_steps = self.finer.iter().any(|values| values.contains_key(table));
        let mut header = ["row", "quantity", "unit", "published", "as_stepped"].map(String::from).to_vec();
        if has_steps {
            header.extend(TIME_STEPS.map(|step| format!("stepped_{}_ms", digits(1e3 * step).replace('.', "_"))));
        }
        header.extend(["exact", "published_over_exact_minus_1"].map(String::from));
        for level in LEVELS {
            header.extend([5, 95].map(|quantile| format!("noise_{level:e}_quantile_{quantile}")));
        }
        let rows: Vec<_> = rows(&[&self.exact, published], table)
            .iter()
            .map(|row| self.row(table, row, published, has_steps))
            .collect();
        to_csv(&header, &rows)
    }

    fn row(&self, table: &str, row: &Value, published: &Quantities, has_steps: bool) -> Vec<String> {
        let number = |value: Option<f64>| value.map(digits).unwrap_or_default();
        let (printed, exact) = (find(published, table, row), find(&self.exact, table, row));
        let mut cells = vec![row.row.clone(), row.quantity.clone(), row.unit.into(), number(printed)];
        cells.push(number(find(&self.stepped, table, row)));
        if has_steps {
            cells.extend(self.finer.iter().map(|values| number(find(values, table, row))));
        }
        cells.push(number(exact));
        let relative = printed.zip(exact).filter(|(_, exact)| *exact != 0.0);
        cells.push(
            relative
                .map(|(printed, exact)| format!("{:.1e}", printed / exact - 1.0))
                .unwrap_or_default(),
        );
        for level in 0..LEVELS.len() {
            let band = self.band(level, table, row);
            cells.extend([band.map(|band| band.0), band.map(|band| band.1)].map(number));
        }
        cells
    }

    /// Lower and upper end of a band; nothing when some runs do not have the row, or have more or fewer meetings: the
    /// fifth may then be another one.
    pub(super) fn band(&self, level: usize, table: &str, row: &Value) -> Option<(f64, f64)> {
        let values = self
            .noisy
            .get(level)?
            .iter()
            .map(|values| find(values, table, row).filter(|_| self.meet_alike(values, table, row)));
        let mut values = values.collect::<Option<Vec<f64>>>()?;
        values.sort_by(f64::total_cmp);
        Some((quantile(&values, TAIL)?, quantile(&values, 1.0 - TAIL)?))
    }
}

impl Converged {
    /// Whether a run has as many meetings as the exact one in the scene of a row that is one of its meetings.
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

/// Rows of any of these, in the order of the first that has more.
fn rows<'a>(sources: &[&'a Quantities], table: &str) -> Vec<&'a Value> {
    let mut rows: Vec<&Value> = Vec::new();
    for value in sources.iter().filter_map(|source| source.get(table)).flatten() {
        if !rows.iter().any(|row| row.row == value.row && row.quantity == value.quantity) {
            rows.push(value);
        }
    }
    rows
}
