//! The folder that `--out` names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use pounding::files::{Others, ResultFolder};
use pounding::report::RESULT_NAMES;

use crate::new_file;

/// The folder of `--out`, which this process alone writes.
#[derive(Debug)]
pub(crate) struct Out(ResultFolder);

impl Out {
    /// Takes a folder and checks that it can be written, before anything runs.
    ///
    /// # Errors
    /// What stands in the way, and what to do about it.
    pub(crate) fn open(path: &Path, overwrite: bool) -> Result<Self, String> {
        let others = if overwrite {
            Others::Stay
        } else {
            Others::Refused("--overwrite")
        };
        let folder = ResultFolder::open(path, RESULT_NAMES, others).map_err(of_option)?;
        Ok(Self(folder))
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        self.0.path()
    }

    /// Refuses a folder whose results are among the files that were read.
    ///
    /// # Errors
    /// Names the file.
    pub(crate) fn keep(&self, inputs: &[PathBuf]) -> Result<(), String> {
        let mut earlier = self.0.earlier();
        earlier.try_for_each(|path| new_file::keep(&path, inputs))
    }

    /// Writes files into the folder; what it holds besides results stays.
    ///
    /// # Errors
    /// What cannot be written, and what the system says.
    pub(crate) fn write(&self, files: &BTreeMap<String, Vec<u8>>) -> Result<(), String> {
        self.0.write(files).map_err(of_option)
    }
}

fn of_option(reason: String) -> String {
    format!("--out: {reason}")
}
