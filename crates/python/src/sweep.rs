//! Sweeps: many runs of one scene.

use std::path::PathBuf;

use pounding_sweep::{Sweep, SweepColumn, SweepFile};
use pounding_text::Refused;
use pyo3::prelude::*;

use crate::refused::OrRefused;
use crate::table::{Column, Table};
use crate::waiting::wait;

/// Runs a sweep with all cores. `text` is the sweep as JSON or TOML; `path` is its file, whose folder other files are named from.
///
/// Calls `progress` with the number of finished runs and the number of all runs. Returns the table, the records that were left out with
/// their reasons, the remarks on records whose direction is unknown, and the implausible values.
#[pyfunction]
#[pyo3(signature = (text, path, progress=None))]
pub(crate) fn sweep(py: Python<'_>, text: &str, path: PathBuf, progress: Option<&Bound<'_, PyAny>>) -> PyResult<(Table, Vec<String>)> {
    let ran = wait(py, progress, |watch| -> Result<_, Refused> {
        let file = SweepFile::parse(text.as_bytes(), &path)?;
        let sweep = Sweep::of(&file, text.as_bytes(), &path, Some(watch.stop))?;
        let of = sweep.n_runs();
        let columns = sweep.table(&|runs| watch.step(runs, of));
        let columns = columns.ok_or("stopped")?;
        let unusual = sweep.unusual().iter().map(ToString::to_string).collect();
        let remarks = sweep.suite().map(|suite| suite.said(true));
        Ok((columns, [unusual, remarks.unwrap_or_default()].concat()))
    })?;
    let (columns, remarks) = ran.or_refused(py)?;
    let columns = columns.into_iter().map(|(name, column)| {
        let column = match column {
            SweepColumn::Counts(counts) => Column::Counts(counts.into()),
            SweepColumn::Flags(flags) => Column::Flags(flags.into_iter().map(Some).collect()),
            SweepColumn::Numbers(numbers) => Column::Numbers(numbers.into()),
            SweepColumn::Texts(texts) => Column::Texts(texts),
        };
        (name, column)
    });
    Ok((Table::new(columns), remarks))
}
