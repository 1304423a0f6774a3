//! Joining of parts to a table.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use pounding_files::{Existing, Lock, NewFile, Users};
use rayon::prelude::*;
use ruzstd::encoding::{CompressionLevel, FrameCompressor};

use super::error;
use super::manifest::{Manifest, joined_beside, path_of};
use super::part::{self, PartFile, length_of_line};
use super::summary::{SummaryTable, Tally};
use pounding_text::Refused;

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
/// Refuses folders without parts, of another sweep or with a damaged manifest, missing or damaged parts, and folders that another process
/// has locked. Also refuses what the system refuses.
pub fn merge(out: &Path, folders: &[PathBuf], existing: Existing) -> Result<Joined, Refused> {
    let lock = Lock::of(out, Users::One).map_err(error::locked)?;
    put(out, &Sources::of(folders)?, existing, &lock)
}

/// All parts of a table, in order.
pub(super) struct Sources {
    manifest: Manifest,
    parts: Vec<PathBuf>,
}

impl Sources {
    /// What the folders hold parts of, and where each lies; all are there.
    pub(super) fn of(folders: &[PathBuf]) -> Result<Self, Refused> {
        let mut manifest: Option<Manifest> = None;
        let mut there = BTreeMap::new();
        for folder in folders {
            let own = Manifest::of_folder(folder)?;
            let own = own.ok_or_else(|| error::no_parts(folder))?;
            if manifest.as_ref().is_some_and(|first| *first != own) {
                return Err(error::other_sweep(folder));
            }
            for part in 0..own.n_parts() {
                let path = path_of(folder, part);
                if path.exists() {
                    there.entry(part).or_insert(path);
                }
            }
            manifest = Some(own);
        }
        let manifest = manifest.ok_or_else(|| error::no_parts(Path::new("")))?;
        let missing = missing(&manifest, &there);
        if !missing.is_empty() {
            let found = Refused::default().found(format!("{} of {} parts", there.len(), manifest.n_parts()));
            let again =
                "start again the shards that should have made them, or `pounding sweep` without a shard, which runs what is missing";
            return Err(found.so(": ", format!("the runs {} are missing; {again}", runs(&missing))));
        }
        let parts = there.into_values().collect();
        Ok(Self { manifest, parts })
    }
}

/// Makes the table, and puts it on disk.
pub(super) fn put(out: &Path, sources: &Sources, existing: Existing, lock: &Lock) -> Result<Joined, Refused> {
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
            return Err(error::file(&earlier)(error));
        }
        _ => {}
    }
    file.put(existing).map_err(error::file(out))?;
    Ok(joined)
}

/// Puts a file beside a table that goes to its place next; one of the same text may be of a process that was ended in between.
fn put_beside(path: &Path, text: &str, existing: Existing) -> Result<(), Refused> {
    if pounding_files::holds(path, text.as_bytes()).unwrap_or(false) {
        return Ok(());
    }
    pounding_files::write(path, text.as_bytes(), existing).map_err(|error| {
        if error.kind() == io::ErrorKind::AlreadyExists {
            error::there_already(path)
        } else {
            error::file(path)(error)
        }
    })
}

/// Whether a table has the bytes that these parts make.
pub(super) fn is_table_of(out: &Path, sources: &Sources) -> Result<bool, Refused> {
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
    is_same().map_err(error::file(out))
}

/// The table under a hidden name.
fn made(out: &Path, sources: &Sources) -> Result<(NewFile, Joined), Refused> {
    pounding_files::tidy(out);
    let file = NewFile::beside(out).map_err(error::file(out))?;
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
            .map_err(error::file(file.path()))?;
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

/// The parts summed up, with all threads; nothing where no summary is asked for.
fn summed_up(sources: &Sources) -> Result<Option<SummaryTable>, Refused> {
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
        let tally = tally.ok_or_else(|| error::damaged(path, "something else than this program writes"))?;
        whole.lock().expect("no thread panics").merge(&tally);
        Ok(())
    };
    let added: Vec<Result<(), Refused>> = parts.par_iter().enumerate().map(add).collect();
    // In order: of several damaged parts the first is named.
    added.into_iter().collect::<Result<(), Refused>>()?;
    let whole = whole.into_inner().expect("no thread panics");
    Ok(Some(SummaryTable::new(form.clone(), whole)))
}

/// Ranges of runs in words; of many the first ones.
fn runs(missing: &[(u64, u64)]) -> String {
    const SHOWN: usize = 5;
    let shown = missing.iter().take(SHOWN);
    let mut words: Vec<String> = shown.map(|(from, to)| format!("{from} to {to}")).collect();
    if missing.len() > SHOWN {
        words.push(format!("and {} more ranges", missing.len() - SHOWN));
    }
    words.join(", ")
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

/// Puts every part where it belongs in the table, with all threads; how many runs failed.
fn place(sources: &Sources, path: &Path) -> Result<u64, Refused> {
    let Sources { manifest, parts } = sources;
    let header = manifest.header.as_bytes();
    fs::write(path, header).map_err(error::file(path))?;
    let mut places = Vec::with_capacity(parts.len());
    let mut end = header.len() as u64;
    for (index, part) in parts.iter().enumerate() {
        let about = fs::metadata(part).map_err(error::file(part))?;
        let line = length_of_line(manifest, index as u64) as u64;
        let length = about.len().saturating_sub(line);
        places.push(end..end + length);
        end += length;
    }
    let write = |(index, place): (usize, std::ops::Range<u64>)| {
        let part = part::read(manifest, index as u64, &parts[index])?;
        if part.rows().len() as u64 != place.end - place.start {
            return Err(error::damaged(&parts[index], "another length than a moment before"));
        }
        let written = || {
            let mut file = OpenOptions::new().write(true).open(path)?;
            file.seek(SeekFrom::Start(place.start))?;
            file.write_all(part.rows())
        };
        written().map_err(error::file(path))?;
        Ok(part.n_failed())
    };
    let places: Vec<_> = places.into_iter().enumerate().collect();
    let written = places.into_par_iter().with_max_len(1).map(write);
    // In order: of several damaged parts the first is named.
    let written: Vec<Result<u64, Refused>> = written.collect();
    written.into_iter().sum()
}

/// Compresses the table, one part after the other; how many runs failed.
fn compress(sources: &Sources, path: &Path) -> Result<u64, Refused> {
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
    encoded.map_err(error::file(path))?;
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
    part: Option<PartFile>,
    read: usize,
    parts: Parts,
    manifest: &'a Manifest,
    failed: u64,
    refused: Option<Refused>,
}

impl<'a, Parts: Iterator<Item = (usize, &'a PathBuf)>> Table<'a, Parts> {
    /// The present bytes.
    fn current(&self) -> &[u8] {
        self.part.as_ref().map_or(self.header, PartFile::rows)
    }

    /// Goes on to the next part; whether there is one.
    fn next(&mut self) -> Result<bool, Refused> {
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
