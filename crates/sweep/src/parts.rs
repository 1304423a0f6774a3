//! The parts of a table: files of a fixed number of runs, each written under another name and then renamed, so that one that
//! is there is whole.

use std::fs::{self, File};
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::Write as _;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::error::MANIFEST;
use super::{Shard, Sweep, SweepError};

/// How a table is cut into parts.
struct Cut {
    /// About how many parts there are, so that little is lost with the one that is not whole.
    parts: u64,
    /// Least runs of a part.
    least: u64,
    /// Most runs of a part, which a thread holds in memory.
    most: u64,
}

/// Of runs that take longer than a file.
const ALONE: Cut = Cut {
    parts: 1024,
    least: 1,
    most: 4096,
};
/// Of runs side by side: the file of a part takes as long as some fifty of them.
const BESIDE: Cut = Cut {
    parts: 128,
    least: 512,
    most: 16_384,
};

/// Of what a folder holds parts.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Manifest {
    /// SHA-256 of everything that the rows depend on.
    pub(super) sweep: String,
    /// Number of runs.
    pub(super) runs: u64,
    /// Number of runs of every part but the last.
    pub(super) runs_per_part: u64,
    /// The row that names the columns.
    pub(super) header: String,
}

impl Manifest {
    fn of(sweep: &Sweep) -> Self {
        let runs = sweep.n_runs();
        let cut = if sweep.asks_for_tallies() {
            BESIDE
        } else {
            ALONE
        };
        let part = (runs / cut.parts).next_power_of_two();
        Self {
            sweep: sweep.sha256().into(),
            runs,
            runs_per_part: part.clamp(cut.least, cut.most),
            header: String::from_utf8_lossy(&sweep.header()).into_owned(),
        }
    }

    /// That of a folder; nothing where it has none.
    pub(super) fn read(folder: &Path) -> Result<Option<Self>, SweepError> {
        let path = folder.join(MANIFEST);
        if !path.exists() {
            return Ok(None);
        }
        let bytes = fs::read(&path).map_err(SweepError::file(&path))?;
        Ok(Some(pounding_scene::parse(&bytes, &path)?))
    }

    /// Whether the parts of another manifest are of the same rows, however they are cut.
    fn has_rows_of(&self, other: &Self) -> bool {
        let cut_alike = Self {
            runs_per_part: self.runs_per_part,
            ..other.clone()
        };
        *self == cut_alike && other.runs_per_part > 0
    }

    pub(super) fn n_parts(&self) -> u64 {
        self.runs.div_ceil(self.runs_per_part)
    }

    /// The runs of a part.
    pub(super) fn runs_of(&self, part: u64) -> Range<u64> {
        let start = part * self.runs_per_part;
        start..(start + self.runs_per_part).min(self.runs)
    }
}

/// The file of a part.
pub(super) fn path_of(folder: &Path, part: u64) -> PathBuf {
    folder.join(format!("part-{part:09}.csv"))
}

/// Whether a folder holds anything but what begins with a dot.
fn has_parts(folder: &Path) -> Result<bool, SweepError> {
    if !folder.exists() {
        return Ok(false);
    }
    let entries = fs::read_dir(folder).map_err(SweepError::file(folder))?;
    let shown = |entry: fs::DirEntry| !entry.file_name().to_string_lossy().starts_with('.');
    Ok(entries.flatten().any(shown))
}

/// Writes a file under another name, then gives it its own, so that nobody finds half of it. What is `kept` is also there after a
/// power failure.
fn write_whole(path: &Path, bytes: &[u8], kept: bool) -> Result<(), SweepError> {
    let beside = beside(path, &own_name());
    let write = || {
        let mut file = File::create(&beside)?;
        file.write_all(bytes)?;
        if kept { file.sync_all() } else { Ok(()) }
    };
    write().map_err(SweepError::file(&beside))?;
    fs::rename(&beside, path).map_err(SweepError::file(path))
}

/// A name of this call alone: processes of several machines may work in one folder, with the same numbers.
pub(super) fn own_name() -> String {
    format!("{:x}", RandomState::new().build_hasher().finish())
}

/// A hidden name beside a file.
pub(super) fn beside(path: &Path, end: &str) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{end}"))
}

/// The folder of parts of a table.
#[derive(Debug)]
pub struct Parts {
    folder: PathBuf,
    manifest: Manifest,
}

impl Parts {
    /// The folder of the parts of a table that goes to `out`: `out` with `.parts` behind its name.
    pub fn folder_of(out: &Path) -> PathBuf {
        let name = out.file_name().unwrap_or_default().to_string_lossy();
        out.with_file_name(format!("{name}.parts"))
    }

    /// Goes on with the parts beside `out`, or begins with them; parts of another sweep go where they may be `overwritten`.
    ///
    /// # Errors
    /// [`SweepError::OtherSweep`], and what the system refuses.
    pub fn open(sweep: &Sweep, out: &Path, overwritten: bool) -> Result<Self, SweepError> {
        let (folder, manifest) = (Self::folder_of(out), Manifest::of(sweep));
        // Extras in this order: a shard that begins at the same moment writes its manifest before its first part.
        let has_parts = has_parts(&folder)?;
        let found = Manifest::read(&folder)?;
        let parts = match &found {
            // Another version may have cut the table otherwise: its parts stay what they are.
            Some(found) if manifest.has_rows_of(found) => {
                return Ok(Self {
                    folder,
                    manifest: found.clone(),
                });
            }
            _ => Self { folder, manifest },
        };
        if found.is_some() || has_parts {
            // What has no manifest is not ours to delete.
            if !overwritten || found.is_none() {
                return Err(SweepError::OtherSweep(parts.folder));
            }
            fs::remove_dir_all(&parts.folder).map_err(SweepError::file(&parts.folder))?;
        }
        fs::create_dir_all(&parts.folder).map_err(SweepError::file(&parts.folder))?;
        let mut text = serde_json::to_string_pretty(&parts.manifest).unwrap_or_default();
        text.push('\n');
        write_whole(&parts.folder.join(MANIFEST), text.as_bytes(), true)?;
        Ok(parts)
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Number of runs of a shard.
    pub fn runs_of(&self, shard: Shard) -> u64 {
        let parts = shard.of(self.manifest.n_parts());
        let run = |part: u64| (part * self.manifest.runs_per_part).min(self.manifest.runs);
        run(parts.end) - run(parts.start)
    }

    /// Number of runs of a shard that are there.
    pub fn runs_there(&self, shard: Shard) -> u64 {
        let there = shard
            .of(self.manifest.n_parts())
            .filter(|part| self.has(*part));
        there.map(|part| self.n_runs(part)).sum()
    }

    fn n_runs(&self, part: u64) -> u64 {
        let runs = self.manifest.runs_of(part);
        runs.end - runs.start
    }

    fn has(&self, part: u64) -> bool {
        path_of(&self.folder, part).exists()
    }

    /// Runs what is missing of a shard, with all threads; `done` is told of every part how many runs it has. When somebody says
    /// stop, runs that have begun end, and parts that are not whole are left out.
    ///
    /// # Errors
    /// What the system refuses to write.
    pub fn fill(
        &self,
        sweep: &Sweep,
        shard: Shard,
        stop: &'static AtomicBool,
        done: &(dyn Fn(u64) + Sync),
    ) -> Result<(), SweepError> {
        let missing: Vec<u64> = shard
            .of(self.manifest.n_parts())
            .filter(|part| !self.has(*part))
            .collect();
        // One part after the other to whoever is free: they differ in the time that they take.
        let parts = missing.into_par_iter().with_max_len(1);
        parts.try_for_each(|part| {
            if stop.load(Ordering::Relaxed) {
                return Ok(());
            }
            let Some(batch) = sweep.batch_until(self.manifest.runs_of(part), stop) else {
                return Ok(());
            };
            write_whole(&path_of(&self.folder, part), &sweep.rows(&batch), false)?;
            done(self.n_runs(part));
            Ok(())
        })
    }
}
