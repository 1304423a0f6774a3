//! A sweep as columns in memory, for further computation.

use std::sync::Mutex;

use rayon::prelude::*;

use super::column::SweepColumn;
use super::manifest::Manifest;
use super::plan::{Axis, Setting};
use super::sampling::SamplePoint;
use super::summary::{Form, SummaryTable, Tally};
use super::{Batch, Sweep};

impl Sweep {
    /// Runs the whole sweep with all threads. Returns columns with the names of [`columns`](Self::columns) and the numbers of a table on
    /// disk; if the sweep writes no rows, those of its summary. `done` receives the number of runs of every batch. `None` if stopped before
    /// the end.
    pub fn table(&self, done: &(dyn Fn(u64) + Sync)) -> Option<Vec<(String, SweepColumn)>> {
        match self.without_rows() {
            Some(form) => Some(self.summed(form, done)?.columns()),
            None => self.table_of_rows(done),
        }
    }

    /// Runs the whole sweep and sums it up.
    fn summed(&self, form: &Form, done: &(dyn Fn(u64) + Sync)) -> Option<SummaryTable> {
        let (n_runs, batch) = (self.n_runs(), Manifest::runs_per_batch(self));
        let whole = Mutex::new(Tally::default());
        let batches: Vec<u64> = (0..n_runs.div_ceil(batch)).collect();
        let made = batches.into_par_iter().with_max_len(1).map(|index| {
            let runs = index * batch..n_runs.min((index + 1) * batch);
            let tally = self.summed_up(form, runs, batch, done)?;
            whole.lock().ok()?.merge(&tally);
            Some(())
        });
        made.collect::<Option<()>>()?;
        Some(SummaryTable::new(form.clone(), whole.into_inner().ok()?))
    }

    fn table_of_rows(&self, done: &(dyn Fn(u64) + Sync)) -> Option<Vec<(String, SweepColumn)>> {
        let n_runs = self.n_runs();
        // As in the parts of a table on disk: the grouping in lanes affects the bits of the exact method.
        let part = Manifest::runs_per_batch(self);
        let batches: Vec<u64> = (0..n_runs.div_ceil(part)).collect();
        let made = batches.into_par_iter().with_max_len(1).map(|batch| {
            if self.is_stopped() {
                return None;
            }
            let runs = batch * part..n_runs.min((batch + 1) * part);
            let made = self.batch_unless_stopped(runs.clone())?;
            done(runs.end - runs.start);
            Some(made)
        });
        let batches: Vec<Batch> = made.collect::<Option<_>>()?;
        let shaking: Vec<_> = (0..n_runs).map(|run| &self.motions.all[self.plan.motion(run).0]).collect();
        let names = shaking.iter().map(|one| Some(one.name.clone()));
        let reversed = shaking.iter().map(|one| one.is_reversed());
        let mut columns = vec![
            SweepColumn::Counts((0..n_runs).collect()),
            SweepColumn::Texts(names.collect()),
            SweepColumn::Flags(reversed.collect()),
        ];
        columns.extend(self.varied());
        columns.extend((0..self.outputs.len()).map(|column| {
            let numbers = batches.iter().flat_map(|batch| &batch.columns[column]);
            SweepColumn::Numbers(numbers.copied().collect())
        }));
        let checked = batches.iter().flat_map(|batch| &batch.checked);
        let checked = checked.map(|one| Some(one.name().to_owned()).filter(|name| !name.is_empty()));
        columns.push(SweepColumn::Texts(checked.collect()));
        let failed = batches.iter().flat_map(|batch| &batch.failed);
        columns.push(SweepColumn::Texts(failed.cloned().collect()));
        Some(self.columns().into_iter().zip(columns).collect())
    }

    /// The varying values, a column for each axis.
    fn varied(&self) -> Vec<SweepColumn> {
        let axes = self.plan.axes();
        let (mut point, mut settings) = (SamplePoint::default(), Vec::new());
        let mut values: Vec<Vec<Setting>> = vec![Vec::new(); axes.len()];
        for run in 0..self.n_runs() {
            self.plan.settings(run, &mut point, &mut settings);
            for (column, setting) in values.iter_mut().zip(&settings) {
                column.push(*setting);
            }
        }
        let columns = axes.iter().zip(&values);
        columns.map(|(axis, settings)| column(axis, settings)).collect()
    }
}

/// The values of an axis: numbers, or texts if a list has other values.
fn column(axis: &Axis, settings: &[Setting]) -> SweepColumn {
    let number = |setting: &Setting| match setting {
        Setting::Number(number) => Some(*number),
        Setting::Listed(_) => None,
    };
    let numbers: Option<Vec<f64>> = settings.iter().map(number).collect();
    numbers.map_or_else(
        || {
            let text = |setting: &Setting| Some(axis.text(*setting));
            SweepColumn::Texts(settings.iter().map(text).collect())
        },
        SweepColumn::Numbers,
    )
}
