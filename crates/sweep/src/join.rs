//! Joining of parts to a table.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use pounding_files::{Existing, Lock, NewFile, Users};
use rayon::prelude::*;
use ruzstd::encoding::{CompressionLevel, FrameCompressor};

use super::SweepError;
use super::manifest::{Manifest, joined_beside, path_of};
use super::part::{self, Part, length_of_line};
use super::summary::{SummaryTable, Tally};

/// A joined table.
#[derive(Debug, Clone, PartialEq)]
pub struct Joined {
    /// Number of its runs, as rows or in the summary.
    pub runs: u64,
    /// Number of failed runs.
    pub failed: u64,
    /// The summary, if requested.
    pub summary: Option<SummaryTable>,
    /// Whether the table has a row for each run.
    pub has_rows: bool,
    /// Whether other processes were locked out; false if the disk has no locks.
    pub is_locked: bool,
}

/// Whether a table with this name is compressed (Zstandard): its name ends in `.zst`.
pub fn compresses(out: &Path) -> bool {
    out.extension().is_some_and(|ending| ending == "zst")
}

/// A file next to a table: its name with another ending.
pub fn beside_table(out: &Path, ending: &str) -> PathBuf {
    let table = if compresses(out) {
        out.with_extension("")
    } else {
        out.to_path_buf()
    };
    table.with_extension(ending)
}

/// Path of the summary of a table with rows.
pub fn summary_beside(out: &Path) -> PathBuf {
    beside_table(out, "summary.csv")
}

/// Joins the parts of a sweep, from any folders, to a table. The bytes do not depend on which process made which part. The table is on disk
/// when this returns; no other process writes it meanwhile.
///
/// # Errors
/// [`SweepError::NoParts`], [`SweepError::OtherSweep`] and [`SweepError::DamagedManifest`] for a folder; [`SweepError::Missing`],
/// [`SweepError::Damaged`], [`SweepError::Lock`]; and errors of the system.
pub fn merge(out: &Path, folders: &[PathBuf], existing: Existing) -> Result<Joined, SweepError> {
    let lock = Lock::of(out, Users::One)?;
    put(out, &Sources::of(folders)?, existing, &lock)
}

/// All parts of a table, in order.
pub(super) struct Sources {
    manifest: Manifest,
    parts: Vec<PathBuf>,
}

impl Sources {
    /// The sweep of these folders, and the path of each part; all must exist.
    pub(super) fn of(folders: &[PathBuf]) -> Result<Self, SweepError> {
        let mut manifest: Option<Manifest> = None;
        let mut there = BTreeMap::new();
        for folder in folders {
            let own = Manifest::of_folder(folder)?;
            let own = own.ok_or_else(|| SweepError::NoParts(folder.clone()))?;
            if manifest.as_ref().is_some_and(|first| *first != own) {
                return Err(SweepError::OtherSweep(folder.clone()));
            }
            for part in 0..own.n_parts() {
                let path = path_of(folder, part);
                if path.exists() {
                    there.entry(part).or_insert(path);
                }
            }
            manifest = Some(own);
        }
        let manifest = manifest.ok_or_else(|| SweepError::NoParts(PathBuf::new()))?;
        let missing = missing(&manifest, &there);
        if !missing.is_empty() {
            return Err(SweepError::Missing {
                found: there.len() as u64,
                allowed: manifest.n_parts(),
                missing,
            });
        }
        let parts = there.into_values().collect();
        Ok(Self { manifest, parts })
    }
}

/// Makes the table, and puts it on disk.
pub(super) fn put(out: &Path, sources: &Sources, existing: Existing, lock: &Lock) -> Result<Joined, SweepError> {
    let (file, joined) = made(out, sources)?;
    let joined = Joined {
        is_locked: lock.is_kept(),
        ..joined
    };
    if let Some(summary) = joined.summary.as_ref().filter(|_| joined.has_rows) {
        put_beside(&summary_beside(out), &summary.csv(), existing)?;
    }
    // The file of an earlier table would describe this table wrongly.
    let earlier = joined_beside(out);
    match fs::remove_file(&earlier) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => {
            return Err(SweepError::file(&earlier)(error));
        }
        _ => {}
    }
    file.put(existing).map_err(SweepError::file(out))?;
    Ok(joined)
}

/// Writes a file next to a table that is about to be moved to its place. An existing file with this text may be from an interrupted
/// process.
fn put_beside(path: &Path, text: &str, existing: Existing) -> Result<(), SweepError> {
    if pounding_files::holds(path, text.as_bytes()).unwrap_or(false) {
        return Ok(());
    }
    pounding_files::write(path, text.as_bytes(), existing).map_err(|error| {
        if error.kind() == io::ErrorKind::AlreadyExists {
            SweepError::ThereAlready(path.to_path_buf())
        } else {
            SweepError::file(path)(error)
        }
    })
}

/// Whether a table has the bytes of these parts.
pub(super) fn is_table_of(out: &Path, sources: &Sources) -> Result<bool, SweepError> {
    let (file, _) = made(out, sources)?;
    let is_same = || {
        let (found, wanted) = (File::open(out)?, File::open(file.path())?);
        if found.metadata()?.len() != wanted.metadata()?.len() {
            return Ok(false);
        }
        let mut found = BufReader::new(found).bytes();
        let mut wanted = BufReader::new(wanted).bytes();
        loop {
            match (found.next().transpose()?, wanted.next().transpose()?) {
                (None, None) => return Ok(true),
                (one, other) if one != other => return Ok(false),
                _ => {}
            }
        }
    };
    is_same().map_err(SweepError::file(out))
}

/// The table under a hidden name.
fn made(out: &Path, sources: &Sources) -> Result<(NewFile, Joined), SweepError> {
    pounding_files::tidy(out);
    let file = NewFile::beside(out).map_err(SweepError::file(out))?;
    let summary = summed_up(sources)?;
    let (has_rows, manifest) = (sources.manifest.without_rows().is_none(), &sources.manifest);
    let failed = match &summary {
        Some(summary) if !has_rows => {
            let text = summary.csv();
            if compresses(out) {
                encode(text.as_bytes(), file.path())
            } else {
                fs::write(file.path(), text)
            }
            .map_err(SweepError::file(file.path()))?;
            summary.n_failed()
        }
        Some(_) | None if compresses(out) => compress(sources, file.path())?,
        Some(_) | None => place(sources, file.path())?,
    };
    let joined = Joined {
        runs: manifest.runs,
        failed,
        summary,
        has_rows,
        is_locked: false,
    };
    Ok((file, joined))
}

/// The summary over all parts, with all threads; `None` if not requested.
fn summed_up(sources: &Sources) -> Result<Option<SummaryTable>, SweepError> {
    let Sources { manifest, parts } = sources;
    let Some(form) = &manifest.summary else {
        return Ok(None);
    };
    let whole = Mutex::new(Tally::default());
    let add = |(index, path): (usize, &PathBuf)| {
        let part = part::read(manifest, index as u64, path)?;
        let tally = if form.rows {
            let (runs, mut tally) = (manifest.runs_of(index as u64), Tally::default());
            tally.add_rows(form, runs, part.rows()).then_some(tally)
        } else {
            Tally::of_line(form, part.rows())
        };
        let tally = tally.ok_or_else(|| SweepError::Damaged {
            path: path.clone(),
            found: "something else than this program writes",
        })?;
        whole.lock().expect("no thread panics").merge(&tally);
        Ok(())
    };
    let added: Vec<Result<(), SweepError>> = parts.par_iter().enumerate().map(add).collect();
    // In order: the first of several damaged parts is named.
    added.into_iter().collect::<Result<(), SweepError>>()?;
    let whole = whole.into_inner().expect("no thread panics");
    Ok(Some(SummaryTable::new(form.clone(), whole)))
}

/// First and last run of every gap.
fn missing(manifest: &Manifest, there: &BTreeMap<u64, PathBuf>) -> Vec<(u64, u64)> {
    let mut gaps: Vec<(u64, u64)> = Vec::new();
    for part in (0..manifest.n_parts()).filter(|part| !there.contains_key(part)) {
        let runs = manifest.runs_of(part);
        match gaps.last_mut() {
            Some((_, last)) if *last + 1 == runs.start => *last = runs.end - 1,
            _ => gaps.push((runs.start, runs.end - 1)),
        }
    }
    gaps
}

/// Writes every part to its place in the table, with all threads; returns the number of failed runs.
fn place(sources: &Sources, path: &Path) -> Result<u64, SweepError> {
    let Sources { manifest, parts } = sources;
    let header = manifest.header.as_bytes();
    fs::write(path, header).map_err(SweepError::file(path))?;
    let mut places = Vec::with_capacity(parts.len());
    let mut end = header.len() as u64;
    for (index, part) in parts.iter().enumerate() {
        let about = fs::metadata(part).map_err(SweepError::file(part))?;
        let line = length_of_line(manifest, index as u64) as u64;
        let length = about.len().saturating_sub(line);
        places.push(end..end + length);
        end += length;
    }
    let write = |(index, place): (usize, std::ops::Range<u64>)| {
        let part = part::read(manifest, index as u64, &parts[index])?;
        if part.rows().len() as u64 != place.end - place.start {
            return Err(SweepError::Damaged {
                path: parts[index].clone(),
                found: "another length than a moment before",
            });
        }
        let written = || {
            let mut file = OpenOptions::new().write(true).open(path)?;
            file.seek(SeekFrom::Start(place.start))?;
            file.write_all(part.rows())
        };
        written().map_err(SweepError::file(path))?;
        Ok(part.n_failed())
    };
    let places: Vec<_> = places.into_iter().enumerate().collect();
    let written = places.into_par_iter().with_max_len(1).map(write);
    // In order: the first of several damaged parts is named.
    let written: Vec<Result<u64, SweepError>> = written.collect();
    written.into_iter().sum()
}

/// Compresses the table, part by part; returns the number of failed runs.
fn compress(sources: &Sources, path: &Path) -> Result<u64, SweepError> {
    let manifest = &sources.manifest;
    let mut table = Table {
        header: manifest.header.as_bytes(),
        part: None,
        read: 0,
        parts: sources.parts.iter().enumerate(),
        manifest,
        failed: 0,
        refused: None,
    };
    let encoded = encode(&mut table, path);
    if let Some(error) = table.refused {
        return Err(error);
    }
    encoded.map_err(SweepError::file(path))?;
    Ok(table.failed)
}

/// Compresses bytes into an existing file.
fn encode(bytes: impl Read, path: &Path) -> io::Result<()> {
    let mut drain = Drain {
        file: BufWriter::new(OpenOptions::new().write(true).open(path)?),
        refused: None,
    };
    let mut encoder = FrameCompressor::new(CompressionLevel::Fastest);
    encoder.set_source(bytes);
    encoder.set_drain(&mut drain);
    encoder.compress();
    drain.end()
}

/// The bytes of a table, part by part. The encoder panics on errors: they are stored, and the table ends.
struct Table<'a, Parts> {
    header: &'a [u8],
    /// The present part; before the first part, the header.
    part: Option<Part>,
    read: usize,
    parts: Parts,
    manifest: &'a Manifest,
    failed: u64,
    refused: Option<SweepError>,
}

impl<'a, Parts: Iterator<Item = (usize, &'a PathBuf)>> Table<'a, Parts> {
    /// The present bytes.
    fn current(&self) -> &[u8] {
        self.part.as_ref().map_or(self.header, Part::rows)
    }

    /// Continues with the next part; false if there is none.
    fn next(&mut self) -> Result<bool, SweepError> {
        let Some((index, path)) = self.parts.next() else {
            return Ok(false);
        };
        let part = part::read(self.manifest, index as u64, path)?;
        self.failed += part.n_failed();
        (self.part, self.read) = (Some(part), 0);
        Ok(true)
    }

    /// Whether there are bytes to read; continues with the next part if needed.
    fn goes_on(&mut self) -> bool {
        while self.read == self.current().len() {
            match self.next() {
                Ok(true) => {}
                Ok(false) => return false,
                Err(error) => {
                    self.refused = Some(error);
                    return false;
                }
            }
        }
        true
    }
}

impl<'a, Parts: Iterator<Item = (usize, &'a PathBuf)>> Read for Table<'a, Parts> {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        if !self.goes_on() {
            return Ok(0);
        }
        let rest = &self.current()[self.read..];
        let n = rest.len().min(to.len());
        to[..n].copy_from_slice(&rest[..n]);
        self.read += n;
        Ok(n)
    }
}

/// Destination of a table; stores the first error.
struct Drain {
    file: BufWriter<File>,
    refused: Option<io::Error>,
}

impl Drain {
    fn end(mut self) -> io::Result<()> {
        match self.refused.take() {
            Some(error) => Err(error),
            None => self.file.flush(),
        }
    }
}

impl Write for Drain {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.refused.is_none() {
            self.refused = self.file.write_all(bytes).err();
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
