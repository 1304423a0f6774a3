//! Refusals of files that a sweep writes, and of what several places of a sweep refuse alike.

use std::path::Path;

use pounding_files::LockError;
use pounding_text::{RefusalKind, Refused};

/// Name of the file that describes the parts in a folder.
pub(super) const MANIFEST: &str = "manifest.json";

/// A file that the system refuses.
pub(super) fn file(path: &Path) -> impl Fn(std::io::Error) -> Refused {
    move |error| Refused::by_system(path, &error)
}

/// A file beside the table that is there already.
pub(super) fn there_already(path: &Path) -> Refused {
    let there = Refused::at(path).is("is there already").allowed_is("a new file");
    there.help("name another table or add --overwrite")
}

/// Parts of another sweep.
pub(super) fn other_sweep(folder: &Path) -> Refused {
    let found = "parts of another sweep: its file, its scene, a record or the version of the program changed since";
    let help = "name another file, delete the folder, or let --overwrite begin anew, which no shard does";
    Refused::at(folder).found(found).help(help)
}

/// Something that is no folder of parts.
pub(super) fn no_parts(folder: &Path) -> Refused {
    let none = Refused::at(folder).found(format!("no parts of a sweep (no {MANIFEST})"));
    none.allowed_are("folders that `pounding sweep` leaves, NAME.csv.parts")
}

/// A part that is not as it was written.
pub(super) fn damaged(path: &Path, found: &'static str) -> Refused {
    let found = Refused::at(path)
        .found(found)
        .allowed_is("the file as it was written")
        .kind(RefusalKind::Damaged);
    found.help("start the sweep again, or the shard that made it, which runs this part anew")
}

/// An output at which another process is at work, or whose lock the system refuses.
pub(super) fn locked(error: LockError) -> Refused {
    match error {
        LockError::Held { output, holder } => {
            let held = Refused::at(output).found(format!("{holder} at work on it"));
            held.allowed_is("one process").help("wait for its end, or name another output")
        }
        LockError::Refused { path, source } => {
            let none = Refused::at(path).found(format!("no lock ({source})"));
            let none = none.allowed_is("a lock that keeps other processes off");
            none.help("let whoever runs this disk mend it, or name an output on another disk")
        }
        LockError::File { path, source } => Refused::by_system(&path, &source),
        other => Refused::that(other.to_string()),
    }
}
