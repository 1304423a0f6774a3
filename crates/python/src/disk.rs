//! Files on disk.

use std::collections::BTreeMap;
use std::path::PathBuf;

use pounding_files::Existing;
use pyo3::prelude::*;

use crate::refused::OrRefused;

/// Writes files into a folder, which is made where it is missing; each is whole and on disk when this returns.
#[pyfunction]
pub(crate) fn write_files(
    py: Python<'_>,
    folder: PathBuf,
    files: BTreeMap<String, Vec<u8>>,
) -> PyResult<()> {
    let write = || -> Result<(), String> {
        let refused = |path: &PathBuf, error: std::io::Error| {
            format!("{}: cannot be written: {error}", path.display())
        };
        std::fs::create_dir_all(&folder).map_err(|error| refused(&folder, error))?;
        for (name, bytes) in &files {
            let path = folder.join(name);
            pounding_files::write(&path, bytes, Existing::Replaced)
                .map_err(|error| refused(&path, error))?;
        }
        Ok(())
    };
    py.detach(write).or_refused(py)
}
