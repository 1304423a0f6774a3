//! Output of a summary: a tidy table, and a few numbers for people.

use pounding_assess::{Distribution, wilson_of};
use pounding_text::{Cell, CellKind, Table};
use serde_json::Value;

use super::exact::Sums;
use super::form::{Form, Summed};
use super::octaves::Octaves;
use super::tally::{CellTally, ColumnTally, Tally};
use crate::column::SweepColumn;
use crate::output::{collapse_column, is_of_all};

/// Value of `column` for counts of runs.
const RUN: &str = "run";

/// A summary of runs.
#[derive(Debug, Clone, PartialEq)]
pub struct SummaryTable {
    form: Form,
    tally: Tally,
}

/// A cell, for people.
#[derive(Debug, Clone, PartialEq)]
pub struct SummedCell {
    /// Its value on every axis.
    pub name: String,
    /// Every column.
    pub columns: Vec<SummedColumn>,
}

/// A column of a cell, or of all cells together, for people.
#[derive(Debug, Clone, PartialEq)]
pub struct SummedColumn {
    /// Its name, in `abs(…)` if magnitudes are summed up.
    pub name: String,
    /// Number of runs that have this number.
    pub numbers: u64,
    /// Mean; `None` without numbers.
    pub mean: Option<f64>,
    /// Standard deviation, with n − 1; `None` for fewer than two numbers.
    pub standard_deviation: Option<f64>,
    /// Number of independent samples among the runs: of several events, that of the events.
    pub samples: u64,
    /// Bounds of the median; `None` for fewer than [`Distribution::ENOUGH`] samples, which have no quantiles.
    pub median: Option<(f64, f64)>,
    /// Bounds of the 84 % quantile; `None` as for the median.
    pub p84: Option<(f64, f64)>,
    /// The largest number.
    pub largest: Option<f64>,
    /// Probability of exceedance of each threshold.
    pub exceedances: Vec<Exceedance>,
}

/// Exceedance of a threshold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exceedance {
    /// The threshold, in the unit of its column.
    pub threshold: f64,
    /// Part of the runs that succeeded \[–\].
    pub probability: f64,
    /// 95 % bounds of the probability \[–\]. Both directions and all components of a record count as one sample.
    pub bounds: (f64, f64),
}

/// A line of the table, without its cell.
struct SummaryLine {
    column: String,
    statistic: &'static str,
    at: Option<f64>,
    value: Option<f64>,
    bounds: Option<(f64, f64)>,
}

impl SummaryTable {
    pub(crate) fn new(form: Form, tally: Tally) -> Self {
        Self { form, tally }
    }

    /// The table as CSV: a row for every statistic of every column of every cell.
    pub fn csv(&self) -> String {
        self.table().csv()
    }

    fn table(&self) -> Table<'_, (u64, SummaryLine)> {
        let by = &self.form.by;
        Table::of(self.lines())
            .columns(
                0..by.len(),
                |axis| by[axis].name.clone(),
                |(cell, _), axis| self.form.values_of(*cell)[axis].to_owned(),
            )
            .column("column", |(_, line)| line.column.clone())
            .column("statistic", |(_, line)| line.statistic)
            .column("at", |(_, line)| Cell::exact(line.at))
            .column("value", |(_, line)| Cell::exact(line.value))
            .column("low", |(_, line)| Cell::exact(line.bounds.map(|bounds| bounds.0)))
            .column("high", |(_, line)| Cell::exact(line.bounds.map(|bounds| bounds.1)))
    }

    /// The table as columns. The values of an axis are numbers if all of them are.
    pub(crate) fn columns(&self) -> Vec<(String, SweepColumn)> {
        let table = self.table();
        let columns = table.values().enumerate().map(|(index, (name, kind, values))| {
            let numbers = |number: fn(&Value) -> Option<f64>| values.iter().map(number).collect::<Option<Vec<f64>>>();
            let axis = numbers(|text| text.as_str()?.parse().ok()).filter(|_| index < self.form.by.len());
            let numbers = if kind == CellKind::Number {
                numbers(|number| Some(number.as_f64().unwrap_or(f64::NAN)))
            } else {
                axis
            };
            let texts = || values.iter().map(|text| text.as_str().map(String::from)).collect();
            (
                name.to_owned(),
                numbers.map_or_else(|| SweepColumn::Texts(texts()), SweepColumn::Numbers),
            )
        });
        columns.collect()
    }

    /// The lines of all cells, each with its cell.
    fn lines(&self) -> impl Iterator<Item = (u64, SummaryLine)> {
        let known = self.known();
        self.tally.cells.iter().flat_map(move |(cell, tally)| {
            let mut lines = of_runs(tally, &self.form);
            let columns = self.form.columns.iter().zip(&tally.columns).zip(&known);
            for ((of, column), is_known) in columns {
                self.of_column(tally, *is_known, of, column, &mut lines);
            }
            lines.into_iter().map(|line| (*cell, line))
        })
    }

    /// For every column, whether any run has the number.
    fn known(&self) -> Vec<bool> {
        let has_numbers = |column: usize| {
            let mut cells = self.tally.cells.values();
            cells.any(|cell| cell.columns[column].numbers != Octaves::default())
        };
        (0..self.form.columns.len()).map(has_numbers).collect()
    }

    /// Names of the columns with thresholds for which no run has a number.
    pub fn without_numbers(&self) -> Vec<String> {
        let columns = self.form.columns.iter().zip(self.known());
        let columns = columns.filter(|(of, is_known)| !is_known && !of.thresholds.is_empty());
        columns.map(|(of, _)| name_of(of)).collect()
    }

    /// Whether any column belongs to a whole building or to two neighbours.
    pub fn has_whole_buildings(&self) -> bool {
        self.form.columns.iter().any(|of| is_of_all(&of.name))
    }

    fn of_column(&self, cell: &CellTally, is_known: bool, of: &Summed, column: &ColumnTally, to: &mut Vec<SummaryLine>) {
        let name = name_of(of);
        let mut line = |statistic, at, value, bounds| {
            to.push(SummaryLine {
                column: name.clone(),
                statistic,
                at,
                value,
                bounds,
            });
        };
        let (numbers, sums) = (&column.numbers, Sums::of(&column.numbers));
        let count = numbers.count();
        let ends = numbers.ends();
        line("numbers", None, Some(count as f64), None);
        let without = cell.runs - cell.failed - count;
        line("without_number", None, Some(without as f64), None);
        line("least", None, ends.map(|ends| ends.0), None);
        line("largest", None, ends.map(|ends| ends.1), None);
        line("mean", None, sums.mean(), None);
        line("standard_deviation", None, sums.deviation(), None);
        for part in &self.form.quantiles {
            let bounds = numbers.quantile(*part);
            line("quantile", Some(*part), bounds.map(middle), bounds);
        }
        for one in exceedances(&self.form, cell, is_known, of, column) {
            let Exceedance {
                threshold,
                probability,
                bounds,
            } = one;
            line("exceedance", Some(threshold), Some(probability), Some(bounds));
        }
        for (near, far, count) in numbers.histogram() {
            let bounds = Some((near.min(far), near.max(far)));
            line("histogram", None, Some(count as f64), bounds);
        }
    }

    /// Number of summarised runs.
    pub fn n_runs(&self) -> u64 {
        self.tally.cells.values().map(|cell| cell.runs).sum()
    }

    /// Number of failed runs.
    pub fn n_failed(&self) -> u64 {
        self.tally.n_failed()
    }

    /// Number of runs that end in a collapse, which are no failures; `None` if gravity acts on no storey.
    pub fn n_collapsed(&self) -> Option<u64> {
        collapsed(&self.tally.whole(&self.form), &self.form)
    }

    /// Number of cells with runs.
    pub fn n_cells(&self) -> usize {
        self.tally.cells.len()
    }

    /// Names of the axes of cells.
    pub fn by(&self) -> String {
        let names: Vec<_> = self.form.by.iter().map(|by| by.name.as_str()).collect();
        names.join(", ")
    }

    /// Every cell with runs.
    pub fn cells(&self) -> Vec<SummedCell> {
        let cells = self.tally.cells.iter().map(|(cell, tally)| SummedCell {
            name: self.form.values_of(*cell).join(", "),
            columns: self.summed(tally),
        });
        cells.collect()
    }

    /// Number and reason of the first runs that failed.
    pub fn first_failed(&self) -> impl Iterator<Item = (u64, &str)> {
        let reasons = self.tally.reasons.iter();
        reasons.map(|(run, reason)| (*run, reason.as_str()))
    }

    /// Every column, of all cells together.
    pub fn whole(&self) -> Vec<SummedColumn> {
        self.summed(&self.tally.whole(&self.form))
    }

    fn summed(&self, cell: &CellTally) -> Vec<SummedColumn> {
        let columns = self.form.columns.iter().zip(&cell.columns).zip(self.known());
        let samples = cell.samples(&self.form);
        let summed = |((of, column), is_known): ((&Summed, &ColumnTally), bool)| {
            let (numbers, sums) = (&column.numbers, Sums::of(&column.numbers));
            let quantile = |part| numbers.quantile(part).filter(|_| samples >= Distribution::ENOUGH as u64);
            SummedColumn {
                name: name_of(of),
                numbers: numbers.count(),
                mean: sums.mean(),
                standard_deviation: sums.deviation(),
                samples,
                median: quantile(0.5),
                p84: quantile(0.84),
                largest: numbers.ends().map(|ends| ends.1),
                exceedances: exceedances(&self.form, cell, is_known, of, column),
            }
        };
        columns.map(summed).collect()
    }
}

/// Number of runs of a cell, and their results.
fn of_runs(cell: &CellTally, form: &Form) -> Vec<SummaryLine> {
    let counts = [
        ("runs", cell.runs),
        ("failed", cell.failed),
        ("checked_ledger", cell.ledger),
        ("checked_beside", cell.beside),
        ("checked_both", cell.both),
    ];
    let line = |(statistic, count): (&'static str, u64)| SummaryLine {
        column: RUN.into(),
        statistic,
        at: None,
        value: Some(count as f64),
        bounds: None,
    };
    let collapsed = collapsed(cell, form).map(|count| ("collapsed", count));
    let samples = form.events.as_ref().map(|_| ("samples", cell.samples(form)));
    counts.into_iter().chain(collapsed).chain(samples).map(line).collect()
}

/// Number of runs that end in a collapse, which are no failures; `None` if gravity acts on no storey.
fn collapsed(cell: &CellTally, form: &Form) -> Option<u64> {
    let column = form.columns.iter().position(|of| of.name == collapse_column())?;
    Some(cell.columns[column].numbers.count())
}

/// Exceedances of each threshold; a run without the number does not exceed it. Empty if no run of the sweep has the number, or all runs of
/// the cell failed.
fn exceedances(form: &Form, cell: &CellTally, is_known: bool, of: &Summed, column: &ColumnTally) -> Vec<Exceedance> {
    let runs = cell.runs - cell.failed;
    if !is_known || runs == 0 {
        return Vec::new();
    }
    let above = of.thresholds.iter().zip(&column.above);
    let exceedance = |(threshold, above): (&f64, &u64)| {
        let probability = *above as f64 / runs as f64;
        Exceedance {
            threshold: *threshold,
            probability,
            bounds: wilson_of(probability, cell.samples(form)),
        }
    };
    above.map(exceedance).collect()
}

fn name_of(column: &Summed) -> String {
    if column.is_peak {
        format!("abs({})", column.name)
    } else {
        column.name.clone()
    }
}

/// The middle of bounds; the number itself if both are equal.
pub(crate) fn middle((low, high): (f64, f64)) -> f64 {
    low + 0.5 * (high - low)
}
