//! A single writer per output, named in a hidden file next to it.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::same::is_at;
use crate::{folder_of, hidden};

/// How many processes may work on an output at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Users {
    /// Only this process.
    One,
    /// This process and other processes that share the output in this way.
    Several,
}

/// Number of attempts to lock: a process that leaves an output locks it for a moment, to clean up.
const PATIENCE: u32 = 20;
const PAUSE: Duration = Duration::from_millis(20);

/// Why an output cannot be locked.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LockError {
    /// Another process holds the output.
    #[error(
        "{}: found {holder} at work on it, allowed is one process; wait for its end, or name another output",
        output.display()
    )]
    Held {
        /// The output.
        output: PathBuf,
        /// The process that holds it.
        holder: String,
    },
    /// The system refuses the lock, although the disk has locks.
    #[error(
        "{}: found no lock ({source}), allowed is a lock that keeps other processes off; let whoever runs this disk mend it, or name \
         an output on another disk",
        path.display()
    )]
    Refused {
        /// The file of the lock.
        path: PathBuf,
        /// The message of the system.
        source: io::Error,
    },
    /// The system refuses the lock file.
    #[error("{}: {source}", path.display())]
    File {
        /// The file of the lock.
        path: PathBuf,
        /// The message of the system.
        source: io::Error,
    },
}

/// The right to write an output, until the value is dropped or the process ends in any way.
///
/// It is an advisory lock of the system. Machines that share a disk share the lock if the disk supports this: NFS version 4 or later and
/// SMB do. Without locks, [`is_kept`](Self::is_kept) is false.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    /// `None` if the system has no locks.
    file: Option<File>,
}

impl Lock {
    /// Locks an output, alone or together with others. Creates its folder if there is none.
    ///
    /// # Errors
    /// [`LockError`].
    pub fn of(output: &Path, users: Users) -> Result<Self, LockError> {
        let lock = match users {
            Users::One => File::try_lock,
            Users::Several => File::try_lock_shared,
        };
        Self::by(output, lock)
    }

    /// Locks an output by this system call.
    fn by(output: &Path, lock: impl Fn(&File) -> Result<(), TryLockError>) -> Result<Self, LockError> {
        let path = hidden(output, "lock");
        let fault = |source| LockError::File {
            path: path.clone(),
            source,
        };
        fs::create_dir_all(folder_of(output)).map_err(fault)?;
        let mut patience = PATIENCE;
        loop {
            let mut options = OpenOptions::new();
            options.read(true).write(true).create(true).truncate(false);
            let file = options.open(&path).map_err(fault)?;
            match lock(&file) {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) if patience > 0 => {
                    patience -= 1;
                    std::thread::sleep(PAUSE);
                    continue;
                }
                Err(TryLockError::WouldBlock) => {
                    return Err(LockError::Held {
                        output: output.to_path_buf(),
                        holder: holder(file),
                    });
                }
                Err(TryLockError::Error(source)) if source.kind() == io::ErrorKind::Unsupported => {
                    return Ok(Self { path, file: None });
                }
                Err(TryLockError::Error(source)) => {
                    return Err(LockError::Refused { path, source });
                }
            }
            // The last process may have deleted the file after this process opened it and before it locked it.
            if is_at(&file, &path).map_err(fault)? {
                sign(&file).map_err(fault)?;
                return Ok(Self { path, file: Some(file) });
            }
        }
    }

    /// Whether other processes are locked out; false if the disk has no locks.
    pub fn is_kept(&self) -> bool {
        self.file.is_some()
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let Some(file) = &self.file else { return };
        // A process that shares the lock leaves the file to the last process.
        let is_last = file.unlock().is_ok() && file.try_lock().is_ok();
        if is_last && is_at(file, &self.path).unwrap_or(false) {
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Writes the name of the holder for the next process.
fn sign(mut file: &File) -> io::Result<()> {
    file.set_len(0)?;
    write!(file, "process {}{}", std::process::id(), machine())
}

/// Name of this machine, if known.
fn machine() -> String {
    let told = fs::read_to_string("/proc/sys/kernel/hostname").ok();
    let told = told.or_else(|| ["HOSTNAME", "COMPUTERNAME"].iter().find_map(|name| std::env::var(name).ok()));
    told.map_or_else(String::new, |name| format!(" on {}", name.trim()))
}

/// The holder, if its name can be read.
fn holder(file: File) -> String {
    let mut signed = String::new();
    let longest = 200;
    let read = file.take(longest).read_to_string(&mut signed);
    if read.is_ok() && signed.starts_with("process ") && !signed.contains(char::is_control) {
        signed
    } else {
        "another process".into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_one_writes_or_several_do_together() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("table.csv");
        let one = Lock::of(&output, Users::One).unwrap();
        assert!(one.is_kept());
        for users in [Users::One, Users::Several] {
            let refused = Lock::of(&output, users).unwrap_err().to_string();
            let own = format!("found process {}", std::process::id());
            assert!(refused.contains(&own), "{refused}");
        }
        drop(one);
        let several = [(); 3].map(|()| Lock::of(&output, Users::Several).unwrap());
        assert!(Lock::of(&output, Users::One).is_err());
        drop(several);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "the last one tidies up");
        // The file that a killed process leaves locks nobody out.
        fs::write(hidden(&output, "lock"), "process 1").unwrap();
        assert!(Lock::of(&output, Users::One).is_ok());
    }

    #[test]
    fn issue_a_disk_without_locks_is_written_and_said() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("table.csv");
        let refused = |_: &File| Err(TryLockError::Error(io::ErrorKind::Unsupported.into()));
        let one = Lock::by(&output, refused).unwrap();
        assert!(!one.is_kept());
        drop(one);
        assert!(Lock::of(&output, Users::One).unwrap().is_kept());
    }

    /// A disk whose locks fail counted as a disk without locks: two processes could write the same table, without a message.
    #[test]
    fn issue_a_lock_that_fails_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("table.csv");
        // ENOLCK and EACCES of Linux, and an unknown number.
        for number in [37, 13, 9999] {
            let refused = |_: &File| {
                let error = io::Error::from_raw_os_error(number);
                Err(TryLockError::Error(error))
            };
            let said = Lock::by(&output, refused).unwrap_err().to_string();
            assert!(said.contains("found no lock"), "{said}");
        }
    }

    /// The lock file comes and goes, and there is still only one process at a time.
    #[test]
    fn extreme_many_take_turns() {
        use std::sync::atomic::{AtomicUsize, Ordering};
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("table.csv");
        let (inside, turns) = (AtomicUsize::new(0), AtomicUsize::new(0));
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    while turns.load(Ordering::SeqCst) < 500 {
                        if let Ok(_lock) = Lock::of(&output, Users::One) {
                            assert_eq!(inside.fetch_add(1, Ordering::SeqCst), 0, "two at once");
                            turns.fetch_add(1, Ordering::SeqCst);
                            inside.fetch_sub(1, Ordering::SeqCst);
                        }
                    }
                });
            }
        });
    }
}
