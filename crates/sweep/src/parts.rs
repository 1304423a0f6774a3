//! The parts of a table in their folder, and continuation of the sweep.

use std::fs;
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use pounding_files::{Existing, Lock, NewFile, Users};
use rayon::prelude::*;

use super::error::MANIFEST;
use super::join::{self, Joined, Sources};
use super::manifest::{Manifest, is_own, joined_beside, path_of};
use super::part::{self, sealed};
use super::{Shard, Sweep, error};
use pounding_text::{RefusalKind, Refused};

/// Most parts of a table: each needs a look into the folder.
const MOST: u64 = 1_000_000;

/// A part that took longer than this is synced at once, which takes about a hundredth of this.
const LONG: Duration = Duration::from_millis(500);

/// The folder of parts of a table, locked by this process, or shared by shards.
#[derive(Debug)]
pub struct Parts {
    out: PathBuf,
    folder: PathBuf,
    manifest: Manifest,
    shard: Shard,
    /// Missing parts of the shard, in order.
    missing: Vec<u64>,
    damaged: Vec<Refused>,
    lock: Lock,
}

impl Parts {
    /// The folder of the parts of a table at `out`: `out` followed by `.parts`.
    pub fn folder_of(out: &Path) -> PathBuf {
        let mut name = out.file_name().unwrap_or_default().to_os_string();
        name.push(".parts");
        out.with_file_name(name)
    }

    /// Whether the folder of parts of a table has any files, or the table exists and its clean-up is incomplete.
    pub fn are_begun(out: &Path) -> bool {
        joined_beside(out).exists() || fs::read_dir(Self::folder_of(out)).is_ok_and(|mut all| all.next().is_some())
    }

    /// Opens or creates the parts for `out`. A whole sweep locks other processes out; shards work together.
    ///
    /// With `overwritten`, an existing table and parts of another sweep are replaced, unless this is a shard. Returns `None` if an
    /// interrupted process of this sweep had already written its table: its remaining parts are now deleted.
    ///
    /// # Errors
    /// Refuses too many parts, a locked folder, a table without parts that exists already, parts of another sweep and a damaged manifest.
    /// Also refuses what the system refuses.
    pub fn open(sweep: &Sweep, out: &Path, shard: Shard, overwritten: bool) -> Result<Option<Self>, Refused> {
        let folder = Self::folder_of(out);
        let manifest = Manifest::of(sweep);
        if manifest.n_parts() > MOST {
            let (with, help) = if sweep.without_rows().is_none() {
                ("with rows", "add a `summary`, which needs none, or make several sweeps")
            } else {
                ("of what these cost", "take coarser grids or fewer samples")
            };
            let found = Refused::at("vary").found(format!("{} runs", manifest.runs));
            let most = format!("up to {} {with}", MOST * manifest.runs_per_part);
            return Err(found.allowed_are(most).help(help));
        }
        let users = if shard.is_whole() { Users::One } else { Users::Several };
        let lock = Lock::of(out, users).map_err(error::locked)?;
        let mut parts = Self {
            out: out.to_path_buf(),
            folder,
            manifest,
            shard,
            missing: Vec::new(),
            damaged: Vec::new(),
            lock,
        };
        if parts.ends_earlier_one()? {
            return Ok(None);
        }
        parts.claim(overwritten)?;
        parts.look()?;
        Ok(Some(parts))
    }

    /// Ends what an earlier process had to leave when its table was on disk; whether there was anything.
    fn ends_earlier_one(&self) -> Result<bool, Refused> {
        if !self.shard.is_whole() {
            return Ok(false);
        }
        let beside = joined_beside(&self.out);
        let joined = match Manifest::read(beside.clone()) {
            Ok(joined) => joined,
            // Whatever it is, it is not of this sweep.
            Err(refused) if refused.is_kind(RefusalKind::Damaged) => None,
            Err(error) => return Err(error),
        };
        if joined.as_ref() != Some(&self.manifest) {
            return Ok(false);
        }
        if self.out.exists() {
            self.clean_up()?;
            return Ok(true);
        }
        // Somebody took the table away: what is left of its parts is good.
        fs::remove_file(&beside).map_err(error::file(&beside))?;
        Ok(false)
    }

    /// Makes the folder this sweep's, unless it is another's.
    fn claim(&self, replaced: bool) -> Result<(), Refused> {
        let overwritten = replaced && self.shard.is_whole();
        let other = || error::other_sweep(&self.folder);
        // What a kill has left of a file is nobody's.
        let is_shown = |name: &String| !name.starts_with('.');
        // The names come first: a shard that begins at this moment writes its manifest before its first part.
        let names = self.names()?;
        let found = match Manifest::of_folder(&self.folder) {
            Err(refused) if overwritten && refused.is_kind(RefusalKind::Damaged) => None,
            found => found?,
        };
        match found {
            Some(found) if found == self.manifest => return Ok(()),
            Some(_) if !overwritten => return Err(other()),
            // The manifest is lost, the parts are not: a complete part shows that they are of this sweep.
            None if !overwritten && names.iter().any(is_shown) && !self.has_whole_part(&names) => {
                return Err(other());
            }
            // Another process finished while this process waited: nothing is written next to the table.
            None if !replaced && self.out.exists() && !names.iter().any(is_shown) => {
                return Err(error::there_already(&self.out));
            }
            Some(_) | None => {}
        }
        if overwritten {
            self.delete(&names)?;
        }
        fs::create_dir_all(&self.folder).map_err(error::file(&self.folder))?;
        let above = pounding_files::folder_of(&self.folder);
        pounding_files::sync_folder(above).map_err(error::file(above))?;
        let written = self.manifest.write(&self.folder);
        // Another shard was first.
        match Manifest::of_folder(&self.folder)? {
            Some(found) if found == self.manifest => Ok(()),
            Some(_) => Err(other()),
            None => written,
        }
    }

    /// Names in the folder that are not hidden, or are ours.
    fn names(&self) -> Result<Vec<String>, Refused> {
        let entries = match fs::read_dir(&self.folder) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Vec::new()),
            entries => entries.map_err(error::file(&self.folder))?,
        };
        let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
        Ok(names.filter(|name| is_own(name) || !name.starts_with('.')).collect())
    }

    fn has_whole_part(&self, names: &[String]) -> bool {
        let is_whole = |part: &u64| {
            let path = path_of(&self.folder, *part);
            path.exists() && part::read(&self.manifest, *part, &path).is_ok()
        };
        names.iter().any(|name| is_own(name)) && (0..self.manifest.n_parts()).any(|part| is_whole(&part))
    }

    /// Deletes what a sweep wrote of these, the manifest last: cut short, it still tells whose the rest is.
    fn delete(&self, names: &[String]) -> Result<(), Refused> {
        let is_manifest = |name: &&String| name.as_str() == MANIFEST;
        let (manifests, parts): (Vec<_>, Vec<_>) = names.iter().filter(|name| is_own(name)).partition(is_manifest);
        for name in parts.into_iter().chain(manifests) {
            let path = self.folder.join(name);
            fs::remove_file(&path).map_err(error::file(&path))?;
        }
        Ok(())
    }

    /// Reads the parts of the shard that are there.
    fn look(&mut self) -> Result<(), Refused> {
        let parts: Vec<u64> = self.shard.of(self.manifest.n_parts()).collect();
        let look = |part: &u64| {
            let path = path_of(&self.folder, *part);
            if !path.exists() {
                return Ok((true, None));
            }
            match part::read(&self.manifest, *part, &path) {
                Ok(_) => Ok((false, None)),
                Err(damaged) if damaged.is_kind(RefusalKind::Damaged) => Ok((true, Some(damaged))),
                Err(error) => Err(error),
            }
        };
        let found: Result<Vec<_>, Refused> = parts.par_iter().map(look).collect();
        for (part, (is_missing, damaged)) in parts.into_iter().zip(found?) {
            if is_missing {
                self.missing.push(part);
            }
            self.damaged.extend(damaged);
        }
        Ok(())
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The shard.
    pub fn shard(&self) -> Shard {
        self.shard
    }

    /// What is wrong with parts that are there and are run again.
    pub fn damaged(&self) -> &[Refused] {
        &self.damaged
    }

    /// Whether other processes are locked out; false if the disk has no locks.
    pub fn is_locked(&self) -> bool {
        self.lock.is_kept()
    }

    /// Number of runs of the shard.
    pub fn n_runs(&self) -> u64 {
        self.runs_of(self.shard.of(self.manifest.n_parts()))
    }

    /// Number of runs of the shard that existed when it was opened.
    pub fn n_runs_there(&self) -> u64 {
        self.n_runs() - self.runs_of(self.missing.iter().copied())
    }

    fn runs_of(&self, parts: impl Iterator<Item = u64>) -> u64 {
        parts.map(|part| self.manifest.n_runs_of(part)).sum()
    }

    /// Runs the missing parts of the shard, with all threads. `done` receives numbers of finished runs. After a stop, started runs end and
    /// incomplete parts are dropped. Returns the number of existing runs of the shard.
    ///
    /// A part that took half a second is synced at once, the others before this returns. An earlier power failure may empty parts of the
    /// last half minute, which then run again. Parts of a complete table are not synced, because [`join`](Self::join) reads them now.
    ///
    /// # Errors
    /// What the system refuses to write.
    pub fn fill(&self, sweep: &Sweep, done: &(dyn Fn(u64) + Sync)) -> Result<u64, Refused> {
        // One part after the other to whoever is free: they differ in the time that they take.
        let parts = self.missing.par_iter().with_max_len(1);
        let made = parts.map(|part| {
            let begin = Instant::now();
            if sweep.is_stopped() {
                return Ok(None);
            }
            let Some(body) = self.body(sweep, *part, done) else {
                return Ok(None);
            };
            let bytes = sealed(&self.manifest, *part, &body);
            let is_synced = begin.elapsed() > LONG;
            self.write(*part, &bytes, is_synced)?;
            Ok(Some((*part, is_synced)))
        });
        let made = made.collect::<Result<Vec<_>, Refused>>()?;
        let made: Vec<(u64, bool)> = made.into_iter().flatten().collect();
        let there = self.n_runs_there() + self.runs_of(made.iter().map(|(part, _)| *part));
        if there < self.n_runs() || !self.shard.is_whole() {
            self.sync(&made)?;
        }
        Ok(there)
    }

    /// The rows of a part, or its tally; `None` after a stop.
    fn body(&self, sweep: &Sweep, part: u64, done: &(dyn Fn(u64) + Sync)) -> Option<Vec<u8>> {
        let runs = self.manifest.runs_of(part);
        if let Some(form) = self.manifest.without_rows() {
            let tally = sweep.summed_up(form, runs, Manifest::runs_per_batch(sweep), done)?;
            return Some(tally.line().into_bytes());
        }
        let batch = sweep.batch_unless_stopped(runs)?;
        done(self.manifest.n_runs_of(part));
        Some(sweep.rows(&batch))
    }

    fn write(&self, part: u64, bytes: &[u8], is_synced: bool) -> Result<(), Refused> {
        let path = path_of(&self.folder, part);
        let write = || {
            let mut file = NewFile::beside(&path)?;
            file.write_all(bytes)?;
            if is_synced {
                file.put(Existing::Replaced)
            } else {
                file.show(Existing::Replaced)
            }
        };
        write().map_err(error::file(&path))
    }

    /// Syncs those of these parts that are not yet.
    fn sync(&self, made: &[(u64, bool)]) -> Result<(), Refused> {
        let open = made.par_iter().filter(|(_, is_synced)| !is_synced);
        open.try_for_each(|(part, _)| {
            let path = path_of(&self.folder, *part);
            pounding_files::sync(&path).map_err(error::file(&path))
        })?;
        pounding_files::sync_folder(&self.folder).map_err(error::file(&self.folder))
    }

    /// Whether the existing table has the rows of these parts: a process was then interrupted between table and clean-up.
    ///
    /// # Errors
    /// What the system refuses.
    pub fn made_table(&self) -> Result<bool, Refused> {
        if !self.missing.is_empty() || !self.shard.is_whole() || !self.out.exists() {
            return Ok(false);
        }
        join::is_table_of(&self.out, &self.sources()?)
    }

    fn sources(&self) -> Result<Sources, Refused> {
        Sources::of(std::slice::from_ref(&self.folder))
    }

    /// Joins the parts to the table. When it is on disk, the parts are deleted; other files in the folder stay.
    ///
    /// # Errors
    /// Those of [`merge`](crate::merge).
    pub fn join(self, existing: Existing) -> Result<Joined, Refused> {
        let joined = join::put(&self.out, &self.sources()?, existing, &self.lock)?;
        self.clean_up()?;
        Ok(joined)
    }

    /// Deletes the parts of a table that is on disk.
    ///
    /// # Errors
    /// What the system refuses.
    pub fn clean_up(&self) -> Result<(), Refused> {
        // From here on the parts are not all there, and the table is.
        let beside = joined_beside(&self.out);
        self.manifest.put(&beside, Existing::Replaced)?;
        self.delete(&self.names()?)?;
        match fs::remove_dir(&self.folder) {
            // The user put files into it, or an earlier process was interrupted after this point.
            Err(error) if matches!(error.kind(), ErrorKind::DirectoryNotEmpty | ErrorKind::NotFound) => {}
            removed => removed.map_err(error::file(&self.folder))?,
        }
        fs::remove_file(&beside).map_err(error::file(&beside))
    }
}
