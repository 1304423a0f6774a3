//! A folder of results: written beside its place under another name and synced, then put there, so that nobody finds half of it.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use pounding::files::{Lock, Users, folder_of, sync_folder};
use pounding::report::{AssessmentReport, Report};

use crate::new_file;

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

/// A folder that this process alone writes, until it is dropped.
#[derive(Debug)]
pub(crate) struct ResultFolder {
    path: PathBuf,
    /// Hidden names beside it: what is being written, and what it replaces.
    new: PathBuf,
    old: PathBuf,
    _lock: Lock,
}

impl ResultFolder {
    /// Takes a folder and checks that it can be written, before anything runs.
    ///
    /// # Errors
    /// What stands in the way, and what to do about it.
    pub(crate) fn open(path: &Path, overwrite: bool) -> Result<Self, String> {
        let [new, old] = ["new", "old"].map(|end| beside(path, end));
        found(path)?;
        let lock = Lock::of(path, Users::One).map_err(|error| format!("--out: {error}"))?;
        let folder = Self {
            path: path.to_path_buf(),
            new: new?,
            old: old?,
            _lock: lock,
        };
        folder.restore().map_err(|error| folder.refused(&error))?;
        match found(path)? {
            Found::Other(name) if !overwrite => Err(format!(
                "--out: {} holds other things than results, such as \"{name}\"; allowed is a folder that does not exist, is empty or \
                 holds the results of an earlier run: name another, or let --overwrite put the results beside them",
                path.display()
            )),
            Found::Nothing | Found::Results | Found::Other(_) => Ok(folder),
        }
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Refuses a folder whose results are among the files that were read.
    ///
    /// # Errors
    /// Names the file.
    pub(crate) fn keep(&self, inputs: &[PathBuf]) -> Result<(), String> {
        let entries = fs::read_dir(&self.path).into_iter().flatten().flatten();
        let mut results = entries.filter(|entry| is_result(&entry.file_name().to_string_lossy()));
        results.try_for_each(|entry| new_file::keep(&entry.path(), inputs))
    }

    /// Writes files into the folder; what it holds besides results stays. They are on disk when this returns, and before it nobody
    /// finds some of them.
    ///
    /// # Errors
    /// What cannot be written, and what the system says.
    pub(crate) fn write(&self, files: &BTreeMap<String, Vec<u8>>) -> Result<(), String> {
        let found = found(&self.path)?;
        let placed = self.fill(files).and_then(|()| match found {
            Found::Nothing => fs::rename(&self.new, &self.path),
            Found::Results => self.replace(),
            Found::Other(_) => self.mix(files),
        });
        let placed = placed.and_then(|()| sync_folder(folder_of(&self.path)));
        placed.map_err(|error| {
            // What was begun is of no use to anybody.
            let _ = fs::remove_dir_all(&self.new);
            self.refused(&error)
        })
    }

    fn refused(&self, error: &io::Error) -> String {
        format!("--out: {} cannot be written: {error}", self.path.display())
    }

    /// Undoes what an earlier process was ended in.
    fn restore(&self) -> io::Result<()> {
        if self.new.exists() {
            fs::remove_dir_all(&self.new)?;
        }
        match (self.old.exists(), self.path.exists()) {
            (true, false) => fs::rename(&self.old, &self.path),
            (true, true) => fs::remove_dir_all(&self.old),
            (false, _) => Ok(()),
        }
    }

    /// Writes files under the hidden name.
    fn fill(&self, files: &BTreeMap<String, Vec<u8>>) -> io::Result<()> {
        fs::create_dir_all(&self.new)?;
        for (name, bytes) in files {
            let mut file = File::create_new(self.new.join(name))?;
            file.write_all(bytes)?;
            file.sync_all()?;
        }
        sync_folder(&self.new)
    }

    /// Puts the new folder in the place of the old one.
    fn replace(&self) -> io::Result<()> {
        fs::rename(&self.path, &self.old)?;
        fs::rename(&self.new, &self.path)?;
        sync_folder(folder_of(&self.path))?;
        fs::remove_dir_all(&self.old)
    }

    /// Puts files among others; then results of an earlier run go.
    fn mix(&self, files: &BTreeMap<String, Vec<u8>>) -> io::Result<()> {
        for name in files.keys() {
            fs::rename(self.new.join(name), self.path.join(name))?;
        }
        sync_folder(&self.path)?;
        for entry in fs::read_dir(&self.path)? {
            let name = entry?.file_name();
            let stale = name
                .to_str()
                .is_some_and(|name| is_result(name) && !files.contains_key(name));
            if stale {
                fs::remove_file(self.path.join(name))?;
            }
        }
        fs::remove_dir(&self.new)
    }
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
            if !names.iter().any(|name| {
                ["summary.json", "runs.json", "assess.json"].contains(&name.as_str())
            }) =>
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

#[cfg(test)]
mod tests {
    use super::*;

    fn results(word: &str) -> BTreeMap<String, Vec<u8>> {
        let names = ["summary.json", "impacts.csv"];
        names.map(|name| (name.into(), word.into())).into()
    }

    /// A process can be killed between any two of its steps; whoever comes next finds one run, whole, and tidies up.
    #[test]
    fn issue_a_kill_between_two_renames_loses_no_results() {
        type Step = fn(&ResultFolder) -> io::Result<()>;
        let steps: [(Step, &str); 3] = [
            (|_| Ok(()), "earlier"),
            (|folder| fs::rename(&folder.path, &folder.old), "earlier"),
            (
                |folder| {
                    fs::rename(&folder.path, &folder.old)?;
                    fs::rename(&folder.new, &folder.path)
                },
                "later",
            ),
        ];
        for (step, left) in steps {
            let home = tempfile::tempdir().unwrap();
            let path = home.path().join("out");
            let killed = ResultFolder::open(&path, false).unwrap();
            killed.write(&results("earlier")).unwrap();
            killed.fill(&results("later")).unwrap();
            step(&killed).unwrap();
            drop(killed);
            let next = ResultFolder::open(&path, false).unwrap();
            for (name, bytes) in results(left) {
                assert_eq!(fs::read(path.join(name)).unwrap(), bytes);
            }
            drop(next);
            assert_eq!(fs::read_dir(home.path()).unwrap().count(), 1, "{left}");
        }
    }
}
