//! Files that are written under a hidden name next to their place, synced, renamed, followed by a sync of the folder.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use crate::same::is_at;
use crate::{folder_of, hidden};

/// Treatment of an existing file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existing {
    /// The existing file stays, and writing fails with [`ErrorKind::AlreadyExists`].
    Kept,
    /// The existing file is replaced once the new file is on disk.
    Replaced,
}

/// Writes a file with these bytes. It is on disk when this returns. Deletes the remains of interrupted processes next to it.
///
/// # Errors
/// The error of the system; an existing file is then unchanged.
pub fn write(path: &Path, bytes: &[u8], existing: Existing) -> io::Result<()> {
    tidy(path);
    let mut file = NewFile::beside(path)?;
    file.write_all(bytes)?;
    file.put(existing)
}

/// End of the hidden name of an incomplete file.
const NEW: &str = ".new";
/// Number of random letters and digits before the end.
const DRAWN: usize = 6;

/// A file that is being written under a hidden name. It is deleted when dropped. A process that is ended by a signal drops nothing;
/// [`tidy`] later deletes the file.
#[derive(Debug)]
pub struct NewFile {
    hidden: NamedTempFile,
    place: PathBuf,
}

impl NewFile {
    /// Begins a file that will be at `path`. If `path` is a link, the file will be at its target.
    ///
    /// # Errors
    /// The error of the system, or an error if `path` is not a regular file.
    pub fn beside(path: &Path) -> io::Result<Self> {
        let place = place_of(path)?;
        let name = place.file_name().ok_or(ErrorKind::InvalidInput)?;
        let begin = [".".as_ref(), name, ".".as_ref()];
        let begin: OsString = begin.into_iter().collect();
        let mut builder = Builder::new();
        builder.prefix(&begin).suffix(NEW).rand_bytes(DRAWN);
        // By default only its owner may read it.
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        let hidden = loop {
            let hidden = builder.tempfile_in(folder_of(&place))?;
            // A process that cleans up may have found the file before it was locked.
            if is_held(hidden.as_file()) && is_at(hidden.as_file(), hidden.path())? {
                break hidden;
            }
        };
        if let Ok(old) = fs::metadata(&place) {
            hidden.as_file().set_permissions(old.permissions())?;
        }
        Ok(Self { hidden, place })
    }

    /// The hidden name.
    pub fn path(&self) -> &Path {
        self.hidden.path()
    }

    /// Moves the file to its place. It is on disk when this returns.
    ///
    /// # Errors
    /// [`ErrorKind::AlreadyExists`], or the error of the system; an existing file is then unchanged.
    pub fn put(self, existing: Existing) -> io::Result<()> {
        self.hidden.as_file().sync_all()?;
        let place = self.place.clone();
        self.show(existing)?;
        sync_folder(folder_of(&place))
    }

    /// Moves the file to its place, where it is complete. A power failure may still empty it until [`sync`](fn@crate::sync).
    ///
    /// # Errors
    /// Those of [`put`](Self::put).
    pub fn show(self, existing: Existing) -> io::Result<()> {
        let shown = match existing {
            Existing::Kept => self.hidden.persist_noclobber(&self.place),
            Existing::Replaced => self.hidden.persist(&self.place),
        };
        shown.map(drop).map_err(|error| error.error)
    }
}

impl Write for NewFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.hidden.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.hidden.flush()
    }
}

/// Destination of a file: `path`, or the target if it is a link.
fn place_of(path: &Path) -> io::Result<PathBuf> {
    let is_link = fs::symlink_metadata(path).is_ok_and(|about| about.is_symlink());
    let place = if is_link { fs::canonicalize(path)? } else { path.to_path_buf() };
    match fs::metadata(&place) {
        Ok(there) if !there.is_file() => Err(io::Error::new(
            ErrorKind::InvalidInput,
            "it is a folder, a pipe or a device, allowed is a file; name another one",
        )),
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        Ok(_) | Err(_) => Ok(place),
    }
}

/// Makes the contents of a file, but not its name, survive a power failure.
///
/// # Errors
/// The error of the system.
pub fn sync(path: &Path) -> io::Result<()> {
    // Windows syncs only files that are open for writing.
    OpenOptions::new().write(true).open(path)?.sync_all()
}

/// Makes the names in a folder survive a power failure.
///
/// # Errors
/// The error of the system. A system that cannot sync folders is no error.
pub fn sync_folder(folder: &Path) -> io::Result<()> {
    // Windows does not open folders, and keeps their names anyway.
    if !cfg!(unix) {
        return Ok(());
    }
    match File::open(folder)?.sync_all() {
        Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => Ok(()),
        synced => synced,
    }
}

/// Deletes incomplete files next to a file that no process is writing; a process that was ended by a signal leaves them. A file that cannot
/// be deleted stays. A disk without locks cannot tell whether a process is writing it.
pub fn tidy(path: &Path) {
    let Ok(place) = place_of(path) else { return };
    for left in leftovers(&place) {
        let is_left = || {
            let file = OpenOptions::new().write(true).open(&left)?;
            let is_left = cfg!(unix) && file.try_lock().is_ok() && is_at(&file, &left)?;
            if is_left {
                fs::remove_file(&left)?;
            }
            Ok::<_, io::Error>(())
        };
        // Errors are ignored: the next process tries again.
        let _ = is_left();
    }
}

/// Locks a file against cleaning up, if the disk has locks; false while a process that cleans up holds it.
fn is_held(file: &File) -> bool {
    // A lock of Windows would also exclude other threads of this process.
    !cfg!(unix) || !matches!(file.try_lock(), Err(TryLockError::WouldBlock))
}

/// Incomplete files next to a file.
fn leftovers(path: &Path) -> Vec<PathBuf> {
    let begin = hidden(path, "");
    let begin = begin.file_name().unwrap_or_default().as_encoded_bytes();
    let begun = |entry: &fs::DirEntry| {
        let name = entry.file_name();
        let own = name.as_encoded_bytes().strip_prefix(begin);
        let drawn = own.and_then(|rest| rest.strip_suffix(NEW.as_bytes()));
        let is_ours = |drawn: &[u8]| drawn.len() == DRAWN && drawn.iter().all(u8::is_ascii_alphanumeric);
        drawn.is_some_and(is_ours) && entry.file_type().is_ok_and(|kind| kind.is_file())
    };
    let entries = fs::read_dir(folder_of(path)).into_iter().flatten().flatten();
    entries.filter(begun).map(|entry| entry.path()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_file_is_there_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        let mut begun = NewFile::beside(&path).unwrap();
        begun.write_all(b"half").unwrap();
        assert!(!path.exists() && begun.path().exists());
        assert_eq!(leftovers(&path), [begun.path()]);
        assert!(leftovers(&folder.path().join("a")).is_empty(), "that of a longer name");
        drop(begun);
        assert!(leftovers(&path).is_empty(), "what was begun goes");
        write(&path, b"one", Existing::Kept).unwrap();
        let refused = write(&path, b"two", Existing::Kept).unwrap_err();
        assert_eq!(refused.kind(), ErrorKind::AlreadyExists);
        assert_eq!(fs::read(&path).unwrap(), b"one");
        write(&path, b"two", Existing::Replaced).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    /// A `convert` or `export` that was interrupted while it wrote left its file for ever.
    #[cfg(unix)]
    #[test]
    fn issue_what_a_kill_leaves_goes_with_the_next_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        let others = ["a.csv", ".a.csv.new", ".a.csv.aB3x_z.new", ".b.a.csv.aB3xyz.new"];
        for name in [".a.csv.aB3xyz.new", ".a.csv.000000.new"].iter().chain(&others) {
            fs::write(folder.path().join(name), b"half").unwrap();
        }
        let begun = NewFile::beside(&path).unwrap();
        write(&path, b"whole", Existing::Replaced).unwrap();
        assert!(begun.path().exists(), "somebody writes it");
        assert_eq!(leftovers(&path), [begun.path()]);
        drop(begun);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), others.len());
    }

    /// A process writes while others clean up: each file is complete, and nothing else is left.
    #[test]
    fn extreme_many_write_and_tidy_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    for _ in 0..50 {
                        write(&path, b"whole", Existing::Replaced).unwrap();
                        assert_eq!(fs::read(&path).unwrap(), b"whole");
                    }
                });
            }
        });
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn extreme_links_and_folders_as_outputs() {
        use std::os::unix::fs::{PermissionsExt as _, symlink};
        let folder = tempfile::tempdir().unwrap();
        let [file, link] = ["file", "link"].map(|name| folder.path().join(name));
        fs::write(&file, b"old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        symlink(&file, &link).unwrap();
        write(&link, b"new", Existing::Replaced).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink(), "links stay");
        assert_eq!(fs::read(&file).unwrap(), b"new");
        assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
        assert!(write(folder.path(), b"", Existing::Replaced).is_err());
        assert!(write(Path::new("/dev/null"), b"", Existing::Replaced).is_err());
    }
}
