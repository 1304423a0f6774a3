//! The form of a summary: cells and columns. Folders of parts store it, so that they do not need the sweep.

use serde::{Deserialize, Serialize};

use crate::summary_file::Summary;
use pounding_text::Refused;

/// Most cells: each holds about fifteen kilobytes for each of its columns.
const MOST_CELLS: u64 = 1000;

/// The cells and columns of a summary.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Form {
    pub(super) by: Vec<By>,
    pub(super) columns: Vec<Summed>,
    pub(super) quantiles: Vec<f64>,
    /// Events of the motions; `None` if all runs have one motion.
    #[serde(default)]
    pub(super) events: Option<EventsOfMotions>,
    /// Whether rows are written, too.
    pub(crate) rows: bool,
}

/// Events of the motions of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EventsOfMotions {
    /// The event of every motion: both directions and all components of a record are one event.
    pub(super) of_motion: Vec<usize>,
    /// Number of successive runs with a motion.
    pub(super) runs: u64,
}

impl EventsOfMotions {
    /// Index of the motion of a run.
    pub(super) fn motion_of(&self, run: u64) -> usize {
        usize::try_from(run / self.runs).unwrap_or(usize::MAX)
    }
}

/// Values of a sweep that take turns.
#[derive(Debug)]
pub(super) struct Listed {
    /// Name of their column.
    pub(super) name: String,
    /// Number of values.
    pub(super) count: u64,
    /// Number of successive runs with a value.
    pub(super) runs: u64,
}

/// An axis of cells: several values that take turns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct By {
    /// Name of its column.
    pub(super) name: String,
    /// Its values, as in tables.
    pub(super) values: Vec<String>,
    /// Number of successive runs with a value.
    pub(super) runs: u64,
}

/// A summarised column.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Summed {
    /// Its name.
    pub(super) name: String,
    /// Its quantity, as in files.
    pub(super) quantity: String,
    /// Whether its sign is only a direction, so that its magnitude counts.
    pub(super) is_peak: bool,
    /// Thresholds for the number of runs above them, in ascending order.
    pub(super) thresholds: Vec<f64>,
}

impl Form {
    /// The form for a sweep with these values, each a text by name and index, and with these columns without thresholds.
    ///
    /// # Errors
    /// The words that do not fit.
    pub(super) fn of(
        words: &Summary,
        listed: &[Listed],
        value: impl Fn(&str, u64) -> String,
        mut columns: Vec<Summed>,
    ) -> Result<Self, Refused> {
        let chosen = chosen(&words.by, listed)?;
        for (found, thresholds) in &words.exceedance {
            count_above(found, thresholds, &mut columns)?;
        }
        let by = chosen.into_iter().map(|one| By {
            name: one.name.clone(),
            values: (0..one.count).map(|place| value(&one.name, place)).collect(),
            runs: one.runs,
        });
        Ok(Self {
            by: by.collect(),
            columns,
            quantiles: words.quantiles.clone(),
            events: None,
            rows: words.rows,
        })
    }

    /// The cell of a run.
    pub(super) fn cell_of(&self, run: u64) -> u64 {
        self.by.iter().fold(0, |cell, by| {
            let count = by.values.len() as u64;
            cell * count + run / by.runs % count
        })
    }

    /// The first later run that may have another cell; `None` if all have this cell.
    pub(super) fn next_cell(&self, run: u64) -> Option<u64> {
        let runs = self.by.iter().map(|by| by.runs).min()?;
        Some((run / runs + 1) * runs)
    }

    /// The value of a cell on every axis.
    pub(super) fn values_of(&self, cell: u64) -> Vec<&str> {
        let mut rest = cell;
        let mut values: Vec<&str> = Vec::with_capacity(self.by.len());
        for by in self.by.iter().rev() {
            let count = by.values.len() as u64;
            let place = usize::try_from(rest % count).expect("below the length of a list");
            values.push(&by.values[place]);
            rest /= count;
        }
        values.reverse();
        values
    }
}

/// Those of what takes turns that make cells.
fn chosen<'l>(by: &[String], listed: &'l [Listed]) -> Result<Vec<&'l Listed>, Refused> {
    let mut chosen: Vec<&Listed> = Vec::new();
    for found in by {
        let is_named = |one: &&Listed| one.name == *found || one.name.split(" = ").any(|part| part == found);
        let one = listed.iter().find(is_named).ok_or_else(|| {
            let named = Refused::at("summary.by").found(format!("`{found}`"));
            let listed = listing(listed.iter().map(|one| &one.name));
            let named = named.allowed_are(format!("what has listed values: {listed}"));
            named.help("give the field a `grid` or `values` in `vary`")
        })?;
        if chosen.iter().any(|other| other.name == one.name) {
            let twice = Refused::at("summary.by").found(format!("`{found}` a second time"));
            return Err(twice.allowed_is("once").help("delete one"));
        }
        chosen.push(one);
    }
    let cells = chosen.iter().map(|one| one.count).fold(1, u64::saturating_mul);
    if cells > MOST_CELLS {
        let found = Refused::at("summary.by").found(format!("{cells} cells"));
        let found = found.allowed_are(format!("up to {MOST_CELLS}"));
        return Err(found.help("leave one out of `by`, or take fewer values"));
    }
    Ok(chosen)
}

/// Sets thresholds of a quantity, or of a column.
fn count_above(found: &str, thresholds: &[f64], columns: &mut [Summed]) -> Result<(), Refused> {
    // Names of pairs are told with a dash, too.
    let plain = found.replace(" – ", " - ");
    let is_named = |column: &&mut Summed| column.quantity == found || column.name == plain;
    let mut is_known = false;
    for column in columns.iter_mut().filter(is_named) {
        is_known = true;
        column.thresholds.extend(thresholds);
        column.thresholds.sort_by(f64::total_cmp);
        column.thresholds.dedup_by(|a, b| a.total_cmp(b).is_eq());
    }
    if is_known {
        return Ok(());
    }
    {
        let known = listing(columns.iter().map(|column| &column.quantity));
        let found = Refused::at("summary.exceedance").found(format!("`{found}`"));
        let found = found.allowed_are(format!("{known}, and names of columns"));
        Err(found.help("add the quantity to `outputs`, or name one of these"))
    }
}

/// Names in words, each once.
fn listing(names: impl Iterator<Item: AsRef<str>>) -> String {
    let mut listed: Vec<String> = Vec::new();
    for name in names.map(|name| format!("`{}`", name.as_ref())) {
        if !listed.contains(&name) {
            listed.push(name);
        }
    }
    listed.join(", ")
}
