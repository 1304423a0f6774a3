//! Files that the program writes: whole and durably, never over a file that was read, and over another one only when asked to.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use pounding::files::{Existing, input_at};
use pounding::text::Refused;

/// Whether a file that exists is replaced or kept.
pub(crate) fn existing(overwrite: bool) -> Existing {
    if overwrite { Existing::Replaced } else { Existing::Kept }
}

/// Refuses, before anything is written, a file that was read, and unless `overwrite` is set a file that exists.
pub(crate) fn check(path: &Path, inputs: &[PathBuf], overwrite: bool) -> Result<(), Refused> {
    keep(path, inputs)?;
    if path.exists() && !overwrite {
        Err(there_already(path))
    } else {
        Ok(())
    }
}

/// Refuses to write over a file that was read, under any of its names.
pub(crate) fn keep(path: &Path, inputs: &[PathBuf]) -> Result<(), Refused> {
    match input_at(path, inputs) {
        None => Ok(()),
        Some(input) => {
            let read = Refused::at(path).is(format!("is the file that is read ({})", input.display()));
            let another = "another, also with --overwrite: what was read cannot be made again";
            Err(read.allowed_is(another).help("name a new file"))
        }
    }
}

/// The refusal of a file that exists.
pub(crate) fn there_already(path: &Path) -> Refused {
    let there = Refused::at(path).is("is there already").allowed_is("a new file");
    there.help("name another one or add --overwrite")
}

/// Warns if no lock keeps other processes off.
pub(crate) fn say_if_unlocked(is_locked: bool) {
    if !is_locked {
        crate::say("this disk knows no locks: let no other process write the same place");
    }
}

/// Writes a file; refuses one that exists unless `overwrite` is set.
pub(crate) fn write(path: &Path, bytes: &[u8], overwrite: bool) -> Result<(), Refused> {
    pounding::files::write(path, bytes, existing(overwrite)).map_err(|error| {
        if error.kind() == ErrorKind::AlreadyExists {
            there_already(path)
        } else {
            Refused::at(path).is(format!("cannot be written: {error}"))
        }
    })
}
