//! Files that the program writes, and does not write over.

use std::fs::File;
use std::io::{ErrorKind, Write as _};
use std::path::Path;

/// Writes a file; one that is there already is refused unless `overwrite` is set.
pub(crate) fn write(path: &Path, bytes: &[u8], overwrite: bool) -> Result<(), String> {
    let file = if overwrite {
        File::create(path)
    } else {
        File::create_new(path)
    };
    let path = path.display();
    let mut file = file.map_err(|error| {
        if error.kind() == ErrorKind::AlreadyExists {
            format!(
                "{path}: is there already, allowed is a new file; name another one or add --overwrite"
            )
        } else {
            format!("{path}: cannot be written: {error}")
        }
    })?;
    file.write_all(bytes)
        .map_err(|error| format!("{path}: cannot be written: {error}"))
}
