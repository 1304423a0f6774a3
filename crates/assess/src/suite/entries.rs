//! The entries of folders and archives: files, and everything else.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use pounding_files::{ArchiveBounds, is_archive, shown_name, unpacked};
use pounding_scene::Error;
use pounding_scene::file::record_bytes;
use pounding_text::Refused;

use super::{LeftOut, LeftOutKind, Suite};

/// An entry of a folder or an archive, or a named file.
pub(super) enum FolderEntry {
    File(RecordFile),
    Other(LeftOut),
}

/// A file to read.
pub(super) struct RecordFile {
    /// Its path; of a file in an archive the path of the archive, and its path in it.
    pub(super) path: PathBuf,
    /// Whether the user named the file itself, not only its folder.
    pub(super) named: bool,
    /// Its bytes if they come from an archive, or the reason why there are none; `None` for a file of a disk.
    content: Option<io::Result<Vec<u8>>>,
    /// The archive.
    archive: Option<PathBuf>,
}

impl RecordFile {
    pub(super) fn on_disk(path: PathBuf, named: bool) -> Self {
        Self {
            path,
            named,
            content: None,
            archive: None,
        }
    }

    /// Gives the bytes of the file to a function.
    ///
    /// # Errors
    /// Refuses a file that cannot be read, with its path.
    pub(super) fn with_bytes<T>(&self, used: impl FnOnce(&[u8]) -> T) -> Result<T, Refused> {
        match &self.content {
            Some(Ok(bytes)) => Ok(used(bytes)),
            Some(Err(error)) => Err(Refused::unreadable(&self.path, error)),
            None => match record_bytes(&self.path) {
                Ok(bytes) => Ok(used(&bytes)),
                Err(error) => Err(Refused::unreadable(&self.path, &error)),
            },
        }
    }

    /// The file on the disk: itself, or its archive.
    pub(super) fn source(&self) -> &Path {
        self.archive.as_deref().unwrap_or(&self.path)
    }
}

/// Returns the entries of folders, each in the order of its names, the files that are named themselves, and the files of archives in the place
/// of the archives.
///
/// # Errors
/// Refuses a folder that cannot be read.
pub(super) fn entries_of(paths: &[PathBuf]) -> Result<Vec<FolderEntry>, Error> {
    let mut entries = Vec::new();
    for path in paths {
        if path.is_dir() {
            let found = names_in(path)?.into_iter();
            // Sub-folders that are read on request are among the paths.
            let found = found.filter(|(one, _)| !paths.contains(one));
            entries.extend(found.map(|(path, about)| entry(path, about)));
        } else {
            entries.push(FolderEntry::File(RecordFile::on_disk(path.clone(), true)));
        }
    }
    Ok(entries.into_iter().flat_map(opened).collect())
}

/// Ends of the names of archives that are opened, in small letters.
const ARCHIVES: [&str; 4] = [".zip", ".tar", ".tgz", ".gz"];

/// Returns the files of an archive in its place; any other entry itself.
fn opened(entry: FolderEntry) -> Vec<FolderEntry> {
    let FolderEntry::File(file) = entry else {
        return vec![entry];
    };
    let name = shown_name(&file.path);
    let lower = name.to_ascii_lowercase();
    if !ARCHIVES.iter().any(|end| lower.ends_with(end)) {
        return vec![FolderEntry::File(file)];
    }
    let bytes = match record_bytes(&file.path) {
        Ok(bytes) if is_archive(&bytes) => bytes,
        // Reading it as a record says what is wrong.
        _ => return vec![FolderEntry::File(file)],
    };
    let inside = |one: pounding_files::Archived| {
        FolderEntry::File(RecordFile {
            path: file.path.join(one.name),
            named: false,
            content: Some(one.bytes),
            archive: Some(file.path.clone()),
        })
    };
    match unpacked(&name, &bytes, ArchiveBounds::USUAL) {
        Ok(mut all) => {
            // The files of a folder follow each other, in the order of their names.
            let order = |name: &str| (Path::new(name).parent().map(Path::to_path_buf), name.to_owned());
            all.sort_by_cached_key(|one| order(&one.name));
            all.into_iter().map(inside).collect()
        }
        Err(error) => vec![FolderEntry::File(RecordFile {
            content: Some(Err(error)),
            ..file
        })],
    }
}

/// Largest number of folders within a folder that are read.
const MOST_FOLDERS: usize = 10_000;

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

    /// Returns a folder and all folders within it, in the order of their names. Links to folders are not followed.
    ///
    /// # Errors
    /// Refuses a folder that cannot be read, and more than ten thousand folders.
    pub fn folders_in(folder: &Path) -> Result<Vec<PathBuf>, Error> {
        let mut all = vec![folder.to_path_buf()];
        let mut next = 0;
        while next < all.len() {
            if all[next].is_dir() {
                let found = names_in(&all[next])?.into_iter();
                let folders = found.filter(|(path, about)| about.as_ref().is_ok_and(fs::Metadata::is_dir) && !path.is_symlink());
                all.extend(folders.map(|(path, _)| path));
            }
            if all.len() > MOST_FOLDERS {
                let found = Refused::at(folder).found(format!("more than {MOST_FOLDERS} folders"));
                return Err(found.allowed_is("a folder with fewer").into());
            }
            next += 1;
        }
        all[1..].sort();
        Ok(all)
    }
}

/// Path of an entry, and its metadata behind links.
type NamedEntry = (PathBuf, io::Result<fs::Metadata>);

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

fn entry(path: PathBuf, about: io::Result<fs::Metadata>) -> FolderEntry {
    let reason = match about {
        Ok(about) if about.is_file() => return FolderEntry::File(RecordFile::on_disk(path, false)),
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
