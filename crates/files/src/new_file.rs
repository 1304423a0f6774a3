//! Files written under a hidden name beside their own, synced, renamed, and the folder synced.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use crate::same::is_at;
use crate::{folder_of, hidden};

/// What becomes of a file that is there already.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existing {
    /// It stays, and writing fails with [`ErrorKind::AlreadyExists`].
    Kept,
    /// It goes when the new one is on disk.
    Replaced,
}

/// Writes a file of these bytes, which is on disk when this returns. What a process that was ended here left beside it goes.
///
/// # Errors
/// What the system refuses; then whatever was there is there still.
pub fn write(path: &Path, bytes: &[u8], existing: Existing) -> io::Result<()> {
    tidy(path);
    let mut file = NewFile::beside(path)?;
    file.write_all(bytes)?;
    file.put(existing)
}

/// End of the hidden name of a file that is not whole.
const NEW: &str = ".new";
/// Letters and digits before it, drawn at random.
const DRAWN: usize = 6;

/// A file that is being written under a hidden name. Dropped, it is deleted. A process that is ended by a signal drops nothing: then the
/// file stays until [`tidy`].
#[derive(Debug)]
pub struct NewFile {
    hidden: NamedTempFile,
    place: PathBuf,
}

impl NewFile {
    /// Begins a file that will be at `path`. Behind a link it will be where the link points.
    ///
    /// # Errors
    /// What the system refuses, and a `path` where something other than a regular file is.
    pub fn beside(path: &Path) -> io::Result<Self> {
        let place = place_of(path)?;
        let name = place.file_name().ok_or(ErrorKind::InvalidInput)?;
        let begin = [".".as_ref(), name, ".".as_ref()];
        let begin: OsString = begin.into_iter().collect();
        let mut builder = Builder::new();
        builder.prefix(&begin).suffix(NEW).rand_bytes(DRAWN);
        // Else only its owner may read it.
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        let hidden = loop {
            let hidden = builder.tempfile_in(folder_of(&place))?;
            // Whoever tidies up may have found it before it was held.
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

    /// Puts the file in its place. It is on disk when this returns.
    ///
    /// # Errors
    /// [`ErrorKind::AlreadyExists`], and what the system refuses; then whatever was there is there still.
    pub fn put(self, existing: Existing) -> io::Result<()> {
        self.hidden.as_file().sync_all()?;
        let place = self.place.clone();
        self.show(existing)?;
        sync_folder(folder_of(&place))
    }

    /// Puts the file in its place, where everybody finds it whole, and a power failure may still empty it: until
    /// [`sync`](fn@crate::sync).
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

/// Where a file goes: `path`, or what it is a link to.
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

/// Lets what a file holds survive a power failure, its name left out.
///
/// # Errors
/// What the system refuses.
pub fn sync(path: &Path) -> io::Result<()> {
    // Windows syncs only what is open for writing.
    OpenOptions::new().write(true).open(path)?.sync_all()
}

/// Lets the names in a folder survive a power failure.
///
/// # Errors
/// What the system refuses; a system that cannot sync folders is no error.
pub fn sync_folder(folder: &Path) -> io::Result<()> {
    // Windows opens no folders, and keeps their names by itself.
    if !cfg!(unix) {
        return Ok(());
    }
    match File::open(folder)?.sync_all() {
        Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => Ok(()),
        synced => synced,
    }
}

/// Deletes what was begun beside a file and is not being written: a process that was ended by a signal leaves it. Where it cannot be
/// deleted it stays; a disk without locks cannot tell whether somebody writes it.
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
        // Nobody asked for its end, and the next one tries again.
        let _ = is_left();
    }
}

/// Keeps a file from those who tidy up, as far as the disk has locks; false while one of them holds it.
fn is_held(file: &File) -> bool {
    // A lock of Windows would keep this process's other threads off, too.
    !cfg!(unix) || !matches!(file.try_lock(), Err(TryLockError::WouldBlock))
}

/// Files that were begun beside one and not ended.
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

    /// A `convert` or `export` that was ended while it wrote left its file for ever.
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

    /// One writes while others tidy up: each file is there, and nothing else.
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
