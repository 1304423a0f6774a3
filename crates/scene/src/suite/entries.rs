//! What lies in a folder: files, and what is none.

use std::fs;
use std::path::{Path, PathBuf};

use super::{File, LeftOut, ReasonKind};
use crate::Error;
use crate::ground_motion::shown_name;
use pounding_text::Refused;

/// An entry of a folder, or a file that was named.
pub(super) enum Entry {
    File(File),
    Other(LeftOut),
}

/// The entries of folders, and files that are named themselves, each folder in the order of its names.
///
/// # Errors
/// Refuses a folder that cannot be read.
pub(super) fn entries_of(paths: &[PathBuf]) -> Result<Vec<Entry>, Error> {
    let mut entries = Vec::new();
    for path in paths {
        if path.is_dir() {
            let found = names_in(path)?.into_iter();
            entries.extend(found.map(|(path, about)| entry(path, about)));
        } else {
            entries.push(Entry::File(File {
                path: path.clone(),
                named: true,
            }));
        }
    }
    Ok(entries)
}

/// The regular files of a folder in the order of their names, without those that it hides.
///
/// # Errors
/// Says so where the folder cannot be read.
pub fn files_in(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let found = names_in(folder)?.into_iter();
    let files = found.filter(|(_, about)| about.as_ref().is_ok_and(fs::Metadata::is_file));
    Ok(files.map(|(path, _)| path).collect())
}

/// An entry of a folder, and what the system says of it, behind links.
type Named = (PathBuf, std::io::Result<fs::Metadata>);

/// The entries of a folder in the order of their names. Those whose names begin with a dot are passed over, and those that end with
/// `.provenance.json`: such a file tells where the record beside it comes from.
fn names_in(folder: &Path) -> Result<Vec<Named>, Error> {
    let unreadable = |error| Refused::unreadable(folder, &error);
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let name = path.file_name().unwrap_or_default().as_encoded_bytes();
        if !(name.starts_with(b".") || name.ends_with(b".provenance.json")) {
            paths.push(path);
        }
    }
    paths.sort();
    let about = |path: PathBuf| {
        let about = fs::metadata(&path);
        (path, about)
    };
    Ok(paths.into_iter().map(about).collect())
}

fn entry(path: PathBuf, about: std::io::Result<fs::Metadata>) -> Entry {
    let reason = match about {
        Ok(about) if about.is_file() => return Entry::File(File { path, named: false }),
        Ok(about) if about.is_dir() => ReasonKind::Folder.saying(""),
        Ok(_) => ReasonKind::NoFile.saying(""),
        Err(error) => ReasonKind::Unreadable.saying(format!("cannot be read: {error}")),
    };
    Entry::Other(LeftOut {
        name: shown_name(&path),
        path,
        reason,
        motion: None,
    })
}
