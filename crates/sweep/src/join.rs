//! Parts joined to one table.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use ruzstd::encoding::{CompressionLevel, FrameCompressor};

use super::SweepError;
use super::parts::{Manifest, beside, own_name, path_of};

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

/// Joins the parts of one sweep, wherever they lie, to a table: the same bytes whoever made which part.
///
/// The table is written under another name and then renamed.
///
/// # Errors
/// [`SweepError::NoParts`] and [`SweepError::OtherSweep`] of a folder, [`SweepError::Missing`], [`SweepError::Damaged`], and what
/// the system refuses.
pub fn merge(out: &Path, folders: &[PathBuf]) -> Result<Joined, SweepError> {
    let (manifest, parts) = found(folders)?;
    // What a kill has left. Another process that joins the same parts finds its file gone, and says so.
    for left in leftovers(out) {
        fs::remove_file(&left).map_err(SweepError::file(&left))?;
    }
    let beside = beside(out, &format!("{}{NEW}", own_name()));
    let written = write(&manifest, parts, (&beside, compresses(out)));
    match written {
        Ok(joined) => {
            fs::rename(&beside, out).map_err(SweepError::file(out))?;
            Ok(joined)
        }
        Err(error) => {
            // What was begun is of no use to anybody.
            let _ = fs::remove_file(&beside);
            Err(error)
        }
    }
}

/// End of the name of a table that is not whole.
const NEW: &str = ".new";

/// Tables beside one that were begun and not ended.
fn leftovers(out: &Path) -> Vec<PathBuf> {
    let begin = beside(out, "");
    let folder = match out.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let begun = |entry: &fs::DirEntry| {
        let name = entry.file_name().to_string_lossy().into_owned();
        let begin = begin.file_name().unwrap_or_default().to_string_lossy();
        let own = name
            .strip_prefix(&*begin)
            .and_then(|rest| rest.strip_suffix(NEW));
        // With a dot it is of a table with a longer name.
        own.is_some_and(|own| !own.contains('.'))
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.filter(begun).map(|entry| entry.path()).collect()
}

/// What the folders hold parts of, and where each lies; all are there.
fn found(folders: &[PathBuf]) -> Result<(Manifest, Vec<PathBuf>), SweepError> {
    let mut manifest: Option<Manifest> = None;
    let mut there = BTreeMap::new();
    for folder in folders {
        let own = Manifest::read(folder)?.ok_or_else(|| SweepError::NoParts(folder.clone()))?;
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
    Ok((manifest, there.into_values().collect()))
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

fn write(
    manifest: &Manifest,
    parts: Vec<PathBuf>,
    (path, compressed): (&Path, bool),
) -> Result<Joined, SweepError> {
    if compressed {
        compress(manifest, parts, path)
    } else {
        place(manifest, &parts, path)
    }
}

/// Puts every part where it belongs in the table, with all threads.
fn place(manifest: &Manifest, parts: &[PathBuf], path: &Path) -> Result<Joined, SweepError> {
    let header = manifest.header.as_bytes();
    fs::write(path, header).map_err(SweepError::file(path))?;
    let mut places = Vec::with_capacity(parts.len());
    let mut end = header.len() as u64;
    for part in parts {
        places.push(end);
        end += fs::metadata(part).map_err(SweepError::file(part))?.len();
    }
    let write = |(index, place): (usize, u64)| {
        let (bytes, joined) = read(manifest, index, &parts[index])?;
        let written = || {
            let mut file = OpenOptions::new().write(true).open(path)?;
            file.seek(SeekFrom::Start(place))?;
            file.write_all(&bytes)
        };
        written().map_err(SweepError::file(path))?;
        Ok(joined)
    };
    let places: Vec<_> = places.into_iter().enumerate().collect();
    let written = places.into_par_iter().with_max_len(1).map(write);
    // In order: of several damaged parts the first is named.
    let written: Vec<Result<Joined, SweepError>> = written.collect();
    let mut joined = Joined { runs: 0, failed: 0 };
    for part in written {
        let part = part?;
        joined.runs += part.runs;
        joined.failed += part.failed;
    }
    Ok(joined)
}

/// Compresses the table, one part after the other.
fn compress(manifest: &Manifest, parts: Vec<PathBuf>, path: &Path) -> Result<Joined, SweepError> {
    let file = File::create(path).map_err(SweepError::file(path))?;
    let mut table = Table {
        bytes: manifest.header.as_bytes().to_vec(),
        read: 0,
        parts: parts.into_iter().enumerate(),
        manifest,
        joined: Joined { runs: 0, failed: 0 },
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
    let joined = table.joined;
    drain.end().map_err(SweepError::file(path))?;
    Ok(joined)
}

/// A part, which has all of its rows, and what is in it.
fn read(manifest: &Manifest, index: usize, path: &Path) -> Result<(Vec<u8>, Joined), SweepError> {
    let bytes = fs::read(path).map_err(SweepError::file(path))?;
    let runs = manifest.runs_of(index as u64);
    let (mut found, mut empty, allowed) = (0, 0, runs.end - runs.start);
    // The reason is the last field of a row, and empty in one that did not fail.
    for end in memchr::memchr_iter(b'\n', &bytes) {
        found += 1;
        empty += u64::from(end > 0 && bytes[end - 1] == b',');
    }
    if found != allowed || bytes.last() != Some(&b'\n') {
        return Err(SweepError::Damaged {
            path: path.to_path_buf(),
            found,
            allowed,
        });
    }
    let joined = Joined {
        runs: found,
        failed: found - empty,
    };
    Ok((bytes, joined))
}

/// The bytes of a table, part after part. The encoder panics on errors: they are kept, and the table ends.
struct Table<'a, Parts> {
    /// The part that is read.
    bytes: Vec<u8>,
    read: usize,
    parts: Parts,
    manifest: &'a Manifest,
    joined: Joined,
    refused: Option<SweepError>,
}

impl<Parts: Iterator<Item = (usize, PathBuf)>> Table<'_, Parts> {
    /// Goes on to the next part; whether there is one.
    fn next(&mut self) -> Result<bool, SweepError> {
        let Some((index, path)) = self.parts.next() else {
            return Ok(false);
        };
        let (bytes, joined) = read(self.manifest, index, &path)?;
        (self.bytes, self.read) = (bytes, 0);
        self.joined.runs += joined.runs;
        self.joined.failed += joined.failed;
        Ok(true)
    }

    /// Whether there are bytes to read; those of the next part where all of this one were.
    fn goes_on(&mut self) -> bool {
        while self.read == self.bytes.len() {
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

impl<Parts: Iterator<Item = (usize, PathBuf)>> Read for Table<'_, Parts> {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        if !self.goes_on() {
            return Ok(0);
        }
        let rest = &self.bytes[self.read..];
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
