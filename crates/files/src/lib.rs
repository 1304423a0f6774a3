//! Files with guarantees: written completely and durably, read within bounds, by a single process at a time.
//!
//! - [`write`](fn@write) and [`NewFile`]: a file is either complete or absent, even after a power failure.
//! - [`ResultFolder`]: a folder of files with this guarantee.
//! - [`read`](fn@read): a regular file of bounded length. Devices and pipes are refused before they are opened.
//! - [`unpacked`]: the files of an archive, in memory and within bounds.
//! - [`Lock`]: a single process writes an output; another process learns which process holds it.
//! - [`input_at`]: whether an output is also an input, under any of its names.
//!
//! ```
//! use pounding_files::{Existing, Length, read, write};
//! # let folder = std::env::temp_dir().join(format!("pounding-files-{}", std::process::id()));
//! # std::fs::create_dir_all(&folder)?;
//! let path = folder.join("table.csv");
//! write(&path, b"a,b\n", Existing::Replaced)?;
//! assert_eq!(read(&path, Length::new(1 << 20, "take fewer rows"))?, b"a,b\n");
//! assert!(write(&path, b"other", Existing::Kept).is_err());
//! # std::fs::remove_dir_all(&folder)?;
//! # Ok::<(), std::io::Error>(())
//! ```
//!
//! Not in this crate: the contents of the files.

mod archive;
mod folder;
mod lock;
mod new_file;
mod read;
mod same;

pub use archive::{ArchiveBounds, Archived, is_archive, unpacked};
pub use folder::{Others, ResultFolder, ResultNames};
pub use lock::{Lock, LockError, Users};
pub use new_file::{Existing, NewFile, sync, sync_folder, tidy, write};
pub use read::{Length, holds, read, read_stream};
pub use same::input_at;

use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// The folder that a path lies in; `.` for a bare name.
pub fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// The name of a file for people. Bytes that are not UTF-8 are spelt as `\xff`, so that no two names look alike.
pub fn shown_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().as_encoded_bytes();
    name.utf8_chunks().fold(String::new(), |mut shown, chunk| {
        shown.push_str(chunk.valid());
        for byte in chunk.invalid() {
            write!(shown, "\\x{byte:02x}").expect("a string takes all");
        }
        shown
    })
}

/// A hidden name next to a file.
pub fn hidden(path: &Path, end: &str) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(".");
    name.push(end);
    path.with_file_name(name)
}
