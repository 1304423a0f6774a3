//! The entries of a folder: files, and everything else.

use std::fs;
use std::path::{Path, PathBuf};

use pounding_files::shown_name;
use pounding_scene::Error;
use pounding_text::Refused;

use super::{LeftOut, LeftOutKind, RecordFile, Suite};

/// An entry of a folder, or a named file.
pub(super) enum FolderEntry {
    File(RecordFile),
    Other(LeftOut),
}

/// Returns the entries of folders, each in the order of its names, and the files that are named themselves.
///
/// # Errors
/// Refuses a folder that cannot be read.
pub(super) fn entries_of(paths: &[PathBuf]) -> Result<Vec<FolderEntry>, Error> {
    let mut entries = Vec::new();
    for path in paths {
        if path.is_dir() {
            let found = names_in(path)?.into_iter();
            entries.extend(found.map(|(path, about)| entry(path, about)));
        } else {
            entries.push(FolderEntry::File(RecordFile {
                path: path.clone(),
                named: true,
            }));
        }
    }
    Ok(entries)
}

impl Suite {
    /// Returns the regular files of a folder in the order of their names, without hidden files.
    ///
    /// # Errors
    /// Refuses a folder that cannot be read.
    pub fn files_in(folder: &Path) -> Result<Vec<PathBuf>, Error> {
        let found = names_in(folder)?.into_iter();
        let files = found.filter(|(_, about)| about.as_ref().is_ok_and(fs::Metadata::is_file));
        Ok(files.map(|(path, _)| path).collect())
    }
}

/// Path of an entry, and its metadata behind links.
type NamedEntry = (PathBuf, std::io::Result<fs::Metadata>);

/// Returns the entries of a folder in the order of their names. Names that begin with a dot are skipped, and names that end with
/// `.provenance.json`: such a file describes the origin of the record beside it.
fn names_in(folder: &Path) -> Result<Vec<NamedEntry>, Error> {
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

fn entry(path: PathBuf, about: std::io::Result<fs::Metadata>) -> FolderEntry {
    let reason = match about {
        Ok(about) if about.is_file() => return FolderEntry::File(RecordFile { path, named: false }),
        Ok(about) if about.is_dir() => LeftOutKind::Folder.saying(""),
        Ok(_) => LeftOutKind::NoFile.saying(""),
        Err(error) => LeftOutKind::Unreadable.saying(format!("cannot be read: {error}")),
    };
    FolderEntry::Other(LeftOut {
        name: shown_name(&path),
        path,
        reason,
        motion: None,
    })
}
