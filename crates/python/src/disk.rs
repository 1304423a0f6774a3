//! Files on disk.

use std::collections::BTreeMap;
use std::path::PathBuf;

use pounding_files::{Others, ResultFolder, input_at};
use pounding_report::RESULT_NAMES;
use pounding_text::Refused;
use pyo3::prelude::*;

use crate::refused::OrRefused;

/// Writes a report into a folder; the report is whole and on disk when the function returns. Results of an earlier run are replaced, except
/// files that were read. Other files are refused or kept.
#[pyfunction]
pub(crate) fn write_files(
    py: Python<'_>,
    folder: PathBuf,
    files: BTreeMap<String, Vec<u8>>,
    overwrite: bool,
    inputs: Vec<PathBuf>,
) -> PyResult<()> {
    let others = if overwrite {
        Others::Stay
    } else {
        Others::Refused("overwrite=True")
    };
    let write = || -> Result<(), Refused> {
        let folder = ResultFolder::open(&folder, RESULT_NAMES, others)?;
        for path in folder.earlier() {
            if let Some(input) = input_at(&path, &inputs) {
                let read = Refused::at(path).is(format!("is the file that is read ({})", input.display()));
                return Err(read.allowed_is("another folder").so(": ", "what was read cannot be made again"));
            }
        }
        Ok(folder.write(&files)?)
    };
    py.detach(write).or_refused(py)
}
