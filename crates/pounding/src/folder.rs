//! A folder of results: written beside its place under another name, then put there, so that nobody finds half of it.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use pounding::report::{AssessmentReport, Report};

/// The files of a run under a folder of records.
pub(crate) const OF_RECORDS: [&str; 3] = ["runs.csv", "runs.json", "runs.txt"];

/// Whether results can have a file of this name.
fn is_result(name: &str) -> bool {
    Report::has_file(name) || AssessmentReport::has_file(name) || OF_RECORDS.contains(&name)
}

/// What lies where a folder is to be written.
enum Found {
    Nothing,
    /// An empty folder, or the results of an earlier run: files of their names and nothing else.
    Results,
    /// A folder with something else in it, for example this.
    Other(String),
}

/// Checks that a folder can be written, before anything runs.
///
/// # Errors
/// What stands in the way, and what to do about it.
pub(crate) fn check(folder: &Path, overwrite: bool) -> Result<(), String> {
    beside(folder, "new")?;
    match found(folder)? {
        Found::Other(name) if !overwrite => Err(format!(
            "--out: {} holds other things than results, such as \"{name}\"; allowed is a folder that does not exist, is empty or \
             holds the results of an earlier run: name another, or let --overwrite put the results beside them",
            folder.display()
        )),
        Found::Nothing | Found::Results | Found::Other(_) => Ok(()),
    }
}

/// Writes files into a folder; what it holds besides results stays.
///
/// # Errors
/// What cannot be written, and what the system says.
pub(crate) fn write(folder: &Path, files: &BTreeMap<String, Vec<u8>>) -> Result<(), String> {
    let found = found(folder)?;
    let new = beside(folder, "new")?;
    let failed = |path: &Path, error: &io::Error| {
        // What was begun is of no use to anybody.
        let _ = fs::remove_dir_all(&new);
        format!("--out: {} cannot be written: {error}", path.display())
    };
    let all = || {
        if new.exists() {
            fs::remove_dir_all(&new)?;
        }
        fs::create_dir_all(&new)?;
        files
            .iter()
            .try_for_each(|(name, bytes)| fs::write(new.join(name), bytes))
    };
    all().map_err(|error| failed(&new, &error))?;
    let placed = match found {
        Found::Nothing => fs::rename(&new, folder),
        Found::Results => replace(folder, &new, &beside(folder, "old")?),
        Found::Other(_) => mix(folder, &new, files),
    };
    placed.map_err(|error| failed(folder, &error))
}

/// Puts a folder in the place of another.
fn replace(folder: &Path, new: &Path, old: &Path) -> io::Result<()> {
    if old.exists() {
        fs::remove_dir_all(old)?;
    }
    fs::rename(folder, old)?;
    fs::rename(new, folder)?;
    fs::remove_dir_all(old)
}

/// Puts files among others; results of an earlier run go.
fn mix(folder: &Path, new: &Path, files: &BTreeMap<String, Vec<u8>>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name();
        let stale = name
            .to_str()
            .is_some_and(|name| is_result(name) && !files.contains_key(name));
        if stale {
            fs::remove_file(folder.join(name))?;
        }
    }
    for name in files.keys() {
        fs::rename(new.join(name), folder.join(name))?;
    }
    fs::remove_dir(new)
}

/// What lies there.
fn found(folder: &Path) -> Result<Found, String> {
    let unreadable = |error: io::Error| format!("--out: {}: {error}", folder.display());
    match fs::metadata(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Found::Nothing),
        Err(error) => return Err(unreadable(error)),
        Ok(there) if !there.is_dir() => {
            return Err(format!(
                "--out: {} is a file, allowed is a folder; name another",
                folder.display()
            ));
        }
        Ok(_) => {}
    }
    let entries = fs::read_dir(folder).map_err(unreadable)?;
    let names: Result<Vec<String>, io::Error> = entries
        .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
        .collect();
    let mut names = names.map_err(unreadable)?;
    names.sort();
    let is_other = |name: &&String| !is_result(name) || folder.join(name).is_dir();
    if let Some(other) = names.iter().find(is_other) {
        return Ok(Found::Other(other.clone()));
    }
    // Files of these names that no run wrote together are somebody else's.
    match names.first() {
        Some(first)
            if !names
                .iter()
                .any(|name| ["summary.json", "runs.json"].contains(&name.as_str())) =>
        {
            Ok(Found::Other(first.clone()))
        }
        _ => Ok(Found::Results),
    }
}

/// A hidden name beside a folder, in the same folder so that renaming moves nothing.
fn beside(folder: &Path, end: &str) -> Result<PathBuf, String> {
    let Some(own) = folder.file_name() else {
        return Err(format!(
            "--out: {} has no name to write a folder under; name a folder in it",
            folder.display()
        ));
    };
    let mut name = OsString::from(".");
    name.push(own);
    name.push(".pounding-");
    name.push(end);
    Ok(folder.with_file_name(name))
}
