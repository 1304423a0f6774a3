//! A folder of results. It is written and synced under another name next to its place, then renamed, so that it never appears half written.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use crate::{Lock, Users, folder_of, sync_folder};

/// How to recognise a folder of results.
#[derive(Debug, Clone, Copy)]
pub struct ResultNames {
    /// Whether results may have a file with this name.
    pub has: fn(&str) -> bool,
    /// Every folder of results contains a file with at least one of these names.
    pub marks: &'static [&'static str],
}

/// Treatment of a folder that contains other things than results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Others<'a> {
    /// The folder is refused. The message names the option that keeps the other files, such as `--overwrite`.
    Refused(&'a str),
    /// The other files stay, and results are added.
    Stay,
}

/// Contents of the place at which a folder is to be written.
enum FolderContents {
    Nothing,
    /// An empty folder, or the results of an earlier run: only files with their names.
    Results,
    /// A folder with another file, for example this one.
    Other(String),
}

/// A folder that only this process writes, until the value is dropped.
#[derive(Debug)]
pub struct ResultFolder {
    path: PathBuf,
    names: ResultNames,
    /// Hidden names next to the folder: the new folder, and the folder that it replaces.
    new: PathBuf,
    old: PathBuf,
    lock: Lock,
}

impl ResultFolder {
    /// Opens a folder and checks that it can be written, before anything runs.
    ///
    /// # Errors
    /// The obstacle, and how to remove it.
    pub fn open(path: &Path, names: ResultNames, others: Others<'_>) -> Result<Self, String> {
        let [new, old] = ["new", "old"].map(|end| beside(path, end));
        names.found_in(path)?;
        let lock = Lock::of(path, Users::One).map_err(|error| error.to_string())?;
        let folder = Self {
            path: path.to_path_buf(),
            names,
            new: new?,
            old: old?,
            lock,
        };
        folder.restore().map_err(|error| folder.refused(&error))?;
        match (names.found_in(path)?, others) {
            (FolderContents::Other(name), Others::Refused(word)) => Err(format!(
                "{} holds other things than results, such as \"{name}\"; allowed is a folder that does not exist, is empty or \
                 holds the results of an earlier run: name another, or let {word} put the results beside them",
                path.display()
            )),
            (FolderContents::Nothing | FolderContents::Results | FolderContents::Other(_), _) => Ok(folder),
        }
    }

    /// Whether other processes are locked out; false if the disk has no locks.
    pub fn is_locked(&self) -> bool {
        self.lock.is_kept()
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Files of an earlier run, which [`write`](Self::write) replaces.
    pub fn earlier(&self) -> impl Iterator<Item = PathBuf> {
        let entries = fs::read_dir(&self.path).into_iter().flatten().flatten();
        let has = self.names.has;
        let results = entries.filter(move |entry| has(&entry.file_name().to_string_lossy()));
        results.map(|entry| entry.path())
    }

    /// Writes files into the folder; other files stay. The files are on disk when this returns, and become visible all at once.
    ///
    /// # Errors
    /// The file that cannot be written, and the message of the system.
    pub fn write(&self, files: &BTreeMap<String, Vec<u8>>) -> Result<(), String> {
        let found = self.names.found_in(&self.path)?;
        let placed = self.fill(files).and_then(|()| match found {
            FolderContents::Nothing => fs::rename(&self.new, &self.path),
            FolderContents::Results => self.replace(),
            FolderContents::Other(_) => self.mix(files),
        });
        let placed = placed.and_then(|()| sync_folder(folder_of(&self.path)));
        placed.map_err(|error| {
            // A half-written folder is useless.
            let _ = fs::remove_dir_all(&self.new);
            self.refused(&error)
        })
    }

    fn refused(&self, error: &io::Error) -> String {
        format!("{} cannot be written: {error}", self.path.display())
    }

    /// Completes or reverts what an interrupted process began.
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

    /// Renames the new folder to the place of the old one.
    fn replace(&self) -> io::Result<()> {
        fs::rename(&self.path, &self.old)?;
        if let Err(error) = fs::rename(&self.new, &self.path) {
            fs::rename(&self.old, &self.path)?;
            return Err(error);
        }
        sync_folder(folder_of(&self.path))?;
        fs::remove_dir_all(&self.old)
    }

    /// Moves files among others, then deletes results of an earlier run.
    fn mix(&self, files: &BTreeMap<String, Vec<u8>>) -> io::Result<()> {
        for name in files.keys() {
            fs::rename(self.new.join(name), self.path.join(name))?;
        }
        sync_folder(&self.path)?;
        for entry in fs::read_dir(&self.path)? {
            let name = entry?.file_name();
            let stale = name
                .to_str()
                .is_some_and(|name| (self.names.has)(name) && !files.contains_key(name));
            if stale {
                fs::remove_file(self.path.join(name))?;
            }
        }
        fs::remove_dir(&self.new)
    }
}

impl ResultNames {
    /// Contents of a folder.
    fn found_in(self, folder: &Path) -> Result<FolderContents, String> {
        let unreadable = |error: io::Error| format!("{}: {error}", folder.display());
        match fs::metadata(folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(FolderContents::Nothing),
            Err(error) => return Err(unreadable(error)),
            Ok(there) if !there.is_dir() => {
                return Err(format!("{} is a file, allowed is a folder; name another", folder.display()));
            }
            Ok(_) => {}
        }
        let entries = fs::read_dir(folder).map_err(unreadable)?;
        let names: Result<Vec<String>, io::Error> = entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned())).collect();
        let mut names = names.map_err(unreadable)?;
        names.sort();
        let is_other = |name: &&String| !(self.has)(name) || folder.join(name).is_dir();
        if let Some(other) = names.iter().find(is_other) {
            return Ok(FolderContents::Other(other.clone()));
        }
        // Files with these names that no run wrote together belong to the user.
        let is_marked = names.iter().any(|name| self.marks.contains(&name.as_str()));
        Ok(match names.first() {
            Some(first) if !is_marked => FolderContents::Other(first.clone()),
            _ => FolderContents::Results,
        })
    }
}

/// A hidden name next to a folder, in its parent folder, so that renaming moves no data.
fn beside(folder: &Path, end: &str) -> Result<PathBuf, String> {
    let Some(own) = folder.file_name() else {
        return Err(format!(
            "{} has no name to write a folder under; name a folder in it",
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

    const NAMES: ResultNames = ResultNames {
        has: |name| ["summary.json", "impacts.csv"].contains(&name),
        marks: &["summary.json"],
    };

    fn results(word: &str) -> BTreeMap<String, Vec<u8>> {
        let names = ["summary.json", "impacts.csv"];
        names.map(|name| (name.into(), word.into())).into()
    }

    /// A process can be killed between any two of its steps. The next process finds a single, complete run, and cleans up.
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
            let killed = ResultFolder::open(&path, NAMES, Others::Refused("force")).unwrap();
            killed.write(&results("earlier")).unwrap();
            killed.fill(&results("later")).unwrap();
            step(&killed).unwrap();
            drop(killed);
            let next = ResultFolder::open(&path, NAMES, Others::Refused("force")).unwrap();
            for (name, bytes) in results(left) {
                assert_eq!(fs::read(path.join(name)).unwrap(), bytes);
            }
            drop(next);
            assert_eq!(fs::read_dir(home.path()).unwrap().count(), 1, "{left}");
        }
    }
}
