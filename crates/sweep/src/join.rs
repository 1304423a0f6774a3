//! Parts joined to one table.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use pounding_files::{Existing, Lock, NewFile, Users};
use rayon::prelude::*;
use ruzstd::encoding::{CompressionLevel, FrameCompressor};

use super::SweepError;
use super::error::MANIFEST;
use super::manifest::{Manifest, path_of};
use super::part::{self, Part, length_of_line};

/// A table that was joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Joined {
    /// Its rows, the one with the names of the columns left out.
    pub runs: u64,
    /// Rows of runs that failed.
    pub failed: u64,
}

/// Whether a table of this name is compressed (Zstandard): one that ends in `.zst`.
pub fn compresses(out: &Path) -> bool {
    out.extension().is_some_and(|ending| ending == "zst")
}

/// Joins the parts of one sweep, wherever they lie, to a table: the same bytes whoever made which part. The table is on disk when
/// this returns; no other process writes it meanwhile.
///
/// # Errors
/// [`SweepError::NoParts`], [`SweepError::OtherSweep`] and [`SweepError::DamagedManifest`] of a folder, [`SweepError::Missing`],
/// [`SweepError::Damaged`], [`SweepError::Lock`], and what the system refuses.
pub fn merge(out: &Path, folders: &[PathBuf], existing: Existing) -> Result<Joined, SweepError> {
    let _lock = Lock::of(out, Users::One)?;
    put(out, &Sources::of(folders)?, existing)
}

/// What a table is made of: all of its parts, in order.
pub(super) struct Sources {
    manifest: Manifest,
    parts: Vec<PathBuf>,
}

impl Sources {
    /// What the folders hold parts of, and where each lies; all are there.
    pub(super) fn of(folders: &[PathBuf]) -> Result<Self, SweepError> {
        let mut manifest: Option<Manifest> = None;
        let mut there = BTreeMap::new();
        for folder in folders {
            let own = Manifest::read(folder, MANIFEST)?;
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

/// Makes the table, and puts it on disk. Call it under a lock.
pub(super) fn put(out: &Path, sources: &Sources, existing: Existing) -> Result<Joined, SweepError> {
    let (file, joined) = made(out, sources)?;
    file.put(existing).map_err(SweepError::file(out))?;
    Ok(joined)
}

/// Whether a table has the bytes that these parts make.
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
    for left in pounding_files::leftovers(out) {
        fs::remove_file(&left).map_err(SweepError::file(&left))?;
    }
    let file = NewFile::beside(out).map_err(SweepError::file(out))?;
    let joined = if compresses(out) {
        compress(sources, file.path())
    } else {
        place(sources, file.path())
    };
    Ok((file, joined?))
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

/// Puts every part where it belongs in the table, with all threads.
fn place(sources: &Sources, path: &Path) -> Result<Joined, SweepError> {
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
    // In order: of several damaged parts the first is named.
    let written: Vec<Result<u64, SweepError>> = written.collect();
    let failed = written.into_iter().sum::<Result<u64, SweepError>>()?;
    Ok(Joined {
        runs: manifest.runs,
        failed,
    })
}

/// Compresses the table, one part after the other.
fn compress(sources: &Sources, path: &Path) -> Result<Joined, SweepError> {
    let file = OpenOptions::new().write(true).open(path);
    let file = file.map_err(SweepError::file(path))?;
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
    let mut drain = Drain {
        file: BufWriter::new(file),
        refused: None,
    };
    let mut encoder = FrameCompressor::new(CompressionLevel::Fastest);
    encoder.set_source(&mut table);
    encoder.set_drain(&mut drain);
    encoder.compress();
    if let Some(error) = table.refused {
        return Err(error);
    }
    let failed = table.failed;
    drain.end().map_err(SweepError::file(path))?;
    Ok(Joined {
        runs: manifest.runs,
        failed,
    })
}

/// The bytes of a table, part after part. The encoder panics on errors: they are kept, and the table ends.
struct Table<'a, Parts> {
    header: &'a [u8],
    /// The part that is read; before the first one, the header is.
    part: Option<Part>,
    read: usize,
    parts: Parts,
    manifest: &'a Manifest,
    failed: u64,
    refused: Option<SweepError>,
}

impl<'a, Parts: Iterator<Item = (usize, &'a PathBuf)>> Table<'a, Parts> {
    /// What is read now.
    fn current(&self) -> &[u8] {
        self.part.as_ref().map_or(self.header, Part::rows)
    }

    /// Goes on to the next part; whether there is one.
    fn next(&mut self) -> Result<bool, SweepError> {
        let Some((index, path)) = self.parts.next() else {
            return Ok(false);
        };
        let part = part::read(self.manifest, index as u64, path)?;
        self.failed += part.n_failed();
        (self.part, self.read) = (Some(part), 0);
        Ok(true)
    }

    /// Whether there are bytes to read; those of the next part where all of this one were.
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

/// Where a table goes; of errors the first is kept.
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
