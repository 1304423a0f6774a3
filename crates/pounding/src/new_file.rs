//! Files that the program writes, and does not write over.

use std::fs::File;
use std::io::{ErrorKind, Write as _};
use std::path::Path;

/// Refuses a file that is there already unless `overwrite` is set, before anything is written.
pub(crate) fn check(path: &Path, overwrite: bool) -> Result<(), String> {
    if path.exists() && !overwrite {
        Err(there_already(path))
    } else {
        Ok(())
    }
}

fn there_already(path: &Path) -> String {
    format!(
        "{}: is there already, allowed is a new file; name another one or add --overwrite",
        path.display()
    )
}

/// Writes a file; one that is there already is refused unless `overwrite` is set.
pub(crate) fn write(path: &Path, bytes: &[u8], overwrite: bool) -> Result<(), String> {
    let file = if overwrite {
        File::create(path)
    } else {
        File::create_new(path)
    };
    let shown = path.display();
    let mut file = file.map_err(|error| {
        if error.kind() == ErrorKind::AlreadyExists {
            there_already(path)
        } else {
            format!("{shown}: cannot be written: {error}")
        }
    })?;
    file.write_all(bytes)
        .map_err(|error| format!("{shown}: cannot be written: {error}"))
}
