//! The folder that `--out` names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use pounding::files::{Others, ResultFolder};
use pounding::report::RESULT_NAMES;
use pounding::text::Refused;

use crate::new_file;

/// The folder of `--out`, which this process alone writes.
#[derive(Debug)]
pub(crate) struct Out(ResultFolder);

impl Out {
    /// Takes a folder and checks that it can be written, before anything runs.
    ///
    /// # Errors
    /// Refuses a folder that cannot be written, and says what to do.
    pub(crate) fn open(path: &Path, overwrite: bool) -> Result<Self, Refused> {
        let others = if overwrite { Others::Stay } else { Others::Refused("--overwrite") };
        let folder = ResultFolder::open(path, RESULT_NAMES, others);
        let folder = folder.map_err(|reason| of_option(&reason))?;
        new_file::say_if_unlocked(folder.is_locked());
        Ok(Self(folder))
    }

    /// Path of the folder.
    pub(crate) fn path(&self) -> &Path {
        self.0.path()
    }

    /// Refuses a folder whose results are among the files that were read.
    ///
    /// # Errors
    /// Names the file.
    pub(crate) fn keep(&self, inputs: &[PathBuf]) -> Result<(), Refused> {
        let mut earlier = self.0.earlier();
        earlier.try_for_each(|path| new_file::keep(&path, inputs))
    }

    /// Refuses the folder of the records itself: results in it would be taken for records.
    ///
    /// # Errors
    /// Names the folder.
    pub(crate) fn apart_from(&self, records: &Path) -> Result<(), Refused> {
        let own = self.path().canonicalize();
        match (own, records.canonicalize()) {
            (Ok(own), Ok(records)) if own == records => {
                let own = Refused::at("--out").is(format!("{} is the folder of the records", self.path().display()));
                let another = "another one: results would be taken for records";
                Err(own.allowed_is(another).help("name a new folder"))
            }
            _ => Ok(()),
        }
    }

    /// Writes files into the folder; what it holds besides results stays.
    ///
    /// # Errors
    /// Names the file that cannot be written, and repeats what the system says.
    pub(crate) fn write(&self, files: &BTreeMap<String, Vec<u8>>) -> Result<(), Refused> {
        let written = self.0.write(files);
        written.map_err(|reason| of_option(&reason))
    }
}

fn of_option(reason: &str) -> Refused {
    Refused::at("--out").is(reason.to_owned())
}
