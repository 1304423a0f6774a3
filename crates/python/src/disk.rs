//! Files on disk.

use std::collections::BTreeMap;
use std::path::PathBuf;

use pounding_files::{Others, ResultFolder};
use pounding_report::RESULT_NAMES;
use pyo3::prelude::*;

use crate::refused::OrRefused;

/// Writes a report into a folder: whole and on disk when this returns. One that holds other things is refused, or they stay.
#[pyfunction]
pub(crate) fn write_files(
    py: Python<'_>,
    folder: PathBuf,
    files: BTreeMap<String, Vec<u8>>,
    overwrite: bool,
) -> PyResult<()> {
    let others = if overwrite {
        Others::Stay
    } else {
        Others::Refused("overwrite=True")
    };
    let write = || -> Result<(), String> {
        ResultFolder::open(&folder, RESULT_NAMES, others)?.write(&files)
    };
    py.detach(write).or_refused(py)
}
