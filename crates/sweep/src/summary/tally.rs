//! Stored sums of runs, cell by cell. Merged tallies do not depend on the order.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::form::{Form, Summed};
use super::octaves::Octaves;
use crate::batch::Batch;
use crate::checked::Checked;

/// Number of failed runs whose reason is stored.
const MOST_REASONS: usize = 3;

/// Summarised runs.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Tally {
    pub(super) cells: BTreeMap<u64, CellTally>,
    /// Reasons of the first failed runs.
    pub(super) reasons: BTreeMap<u64, String>,
}

/// Runs of a cell.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CellTally {
    pub(super) runs: u64,
    pub(super) failed: u64,
    /// Numbers of runs checked by their ledger, in lanes, and by both.
    pub(super) ledger: u64,
    pub(super) beside: u64,
    pub(super) both: u64,
    /// Motions of the runs, by their index; empty if all runs of the sweep have one.
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    pub(super) motions: BTreeSet<usize>,
    pub(super) columns: Vec<ColumnTally>,
}

/// Numbers of a column.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ColumnTally {
    /// Number of values above each threshold.
    pub(super) above: Vec<u64>,
    pub(super) numbers: Octaves,
}

impl Tally {
    /// Adds the runs of a batch.
    pub(crate) fn add_batch(&mut self, form: &Form, batch: &Batch) {
        let Range { start, end } = batch.runs;
        let place = |run: u64| usize::try_from(run - start).expect("a batch fits into memory");
        let mut run = start;
        while run < end {
            let next = form.next_cell(run).map_or(end, |next| next.min(end));
            let places = place(run)..place(next);
            let cell = self.cell(form, run);
            cell.runs += next - run;
            cell.shake(form, run, next);
            for checked in &batch.checked[places.clone()] {
                cell.check(*checked);
            }
            for ((column, of), numbers) in cell.columns.iter_mut().zip(&form.columns).zip(&batch.columns) {
                column.add(of, &numbers[places.clone()]);
            }
            let failed = batch.failed[places].iter().enumerate();
            let failed = failed.filter_map(|(index, reason)| Some((run + index as u64, reason.as_deref()?)));
            for (run, reason) in failed {
                self.fail(form, run, reason);
            }
            run = next;
        }
    }

    /// Adds runs from their rows; false if these do not fit this form.
    pub(crate) fn add_rows(&mut self, form: &Form, runs: Range<u64>, rows: &[u8]) -> bool {
        let mut reader = csv::ReaderBuilder::new();
        let mut reader = reader.has_headers(false).from_reader(rows);
        let mut record = csv::StringRecord::new();
        for run in runs {
            if !matches!(reader.read_record(&mut record), Ok(true)) || !self.add_row(form, run, &record) {
                return false;
            }
        }
        matches!(reader.read_record(&mut record), Ok(false))
    }

    fn add_row(&mut self, form: &Form, run: u64, row: &csv::StringRecord) -> bool {
        // After the numbers a row has its kind of check and its reason of failure.
        let Some(first) = row.len().checked_sub(form.columns.len() + 2) else {
            return false;
        };
        let cell = self.cell(form, run);
        cell.runs += 1;
        cell.shake(form, run, run + 1);
        for (index, (column, of)) in cell.columns.iter_mut().zip(&form.columns).enumerate() {
            let number = row[first + index].parse().unwrap_or(f64::NAN);
            column.add(of, &[number]);
        }
        if let Some(checked) = Checked::of(&row[row.len() - 2]) {
            cell.check(checked);
        }
        let reason = &row[row.len() - 1];
        if !reason.is_empty() {
            self.fail(form, run, reason);
        }
        true
    }

    fn cell(&mut self, form: &Form, run: u64) -> &mut CellTally {
        let cell = self.cells.entry(form.cell_of(run));
        cell.or_insert_with(|| CellTally::empty(form))
    }

    fn fail(&mut self, form: &Form, run: u64, reason: &str) {
        self.cell(form, run).failed += 1;
        self.reasons.insert(run, reason.into());
        self.keep_first_reasons();
    }

    fn keep_first_reasons(&mut self) {
        while self.reasons.len() > MOST_REASONS {
            self.reasons.pop_last();
        }
    }

    /// Adds another tally.
    pub(crate) fn merge(&mut self, other: &Self) {
        for (number, cell) in &other.cells {
            match self.cells.get_mut(number) {
                Some(own) => own.merge(cell),
                None => {
                    self.cells.insert(*number, cell.clone());
                }
            }
        }
        let reasons = other.reasons.iter();
        self.reasons.extend(reasons.map(|(run, reason)| (*run, reason.clone())));
        self.keep_first_reasons();
    }

    pub(crate) fn n_failed(&self) -> u64 {
        self.cells.values().map(|cell| cell.failed).sum()
    }

    /// All cells as one.
    pub(super) fn whole(&self, form: &Form) -> CellTally {
        let mut whole = CellTally::empty(form);
        for cell in self.cells.values() {
            whole.merge(cell);
        }
        whole
    }

    /// The tally as a line of JSON with whole numbers.
    pub(crate) fn line(&self) -> String {
        let mut line = serde_json::to_string(self).expect("counts and texts are JSON");
        line.push('\n');
        line
    }

    /// The tally of a line; `None` if it does not fit this form.
    pub(crate) fn of_line(form: &Form, line: &[u8]) -> Option<Self> {
        let tally: Self = serde_json::from_slice(line).ok()?;
        let fits = |cell: &CellTally| {
            let columns = cell.columns.iter().zip(&form.columns);
            let mut columns = columns.map(|(column, of)| column.above.len() == of.thresholds.len());
            cell.columns.len() == form.columns.len() && columns.all(|fits| fits)
        };
        tally.cells.values().all(fits).then_some(tally)
    }
}

impl CellTally {
    fn empty(form: &Form) -> Self {
        let columns = form.columns.iter().map(|of| ColumnTally {
            above: vec![0; of.thresholds.len()],
            numbers: Octaves::default(),
        });
        Self {
            runs: 0,
            failed: 0,
            ledger: 0,
            beside: 0,
            both: 0,
            motions: BTreeSet::new(),
            columns: columns.collect(),
        }
    }

    /// Notes the motions of runs, of which there is at least one.
    fn shake(&mut self, form: &Form, first: u64, end: u64) {
        if let Some(events) = &form.events {
            self.motions.extend(events.motion_of(first)..=events.motion_of(end - 1));
        }
    }

    /// Number of independent samples among the runs that succeeded. Runs under one event are no more than one sample; under a single event
    /// every set of values is one.
    pub(super) fn samples(&self, form: &Form) -> u64 {
        let runs = self.runs - self.failed;
        let Some(events) = &form.events else {
            return runs;
        };
        let of = self.motions.iter().filter_map(|motion| events.of_motion.get(*motion));
        match of.collect::<BTreeSet<_>>().len() as u64 {
            0 | 1 => runs.div_ceil((self.motions.len() as u64).max(1)),
            n => n.min(runs),
        }
    }

    fn check(&mut self, checked: Checked) {
        match checked {
            Checked::No => {}
            Checked::Ledger => self.ledger += 1,
            Checked::Beside => self.beside += 1,
            Checked::Both => self.both += 1,
        }
    }

    fn merge(&mut self, other: &Self) {
        self.runs += other.runs;
        self.failed += other.failed;
        self.ledger += other.ledger;
        self.beside += other.beside;
        self.both += other.both;
        self.motions.extend(&other.motions);
        for (column, other) in self.columns.iter_mut().zip(&other.columns) {
            column.merge(other);
        }
    }
}

impl ColumnTally {
    /// Adds numbers; non-finite ones are ignored.
    fn add(&mut self, of: &Summed, numbers: &[f64]) {
        for number in numbers.iter().filter(|number| number.is_finite()) {
            let number = if of.is_peak { number.abs() } else { *number };
            self.numbers.add(number);
            for (above, threshold) in self.above.iter_mut().zip(&of.thresholds) {
                *above += u64::from(number > *threshold);
            }
        }
    }

    fn merge(&mut self, other: &Self) {
        for (above, other) in self.above.iter_mut().zip(&other.above) {
            *above += other;
        }
        self.numbers.merge(&other.numbers);
    }
}
