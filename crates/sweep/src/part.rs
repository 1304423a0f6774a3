//! The file of a part: a line with the sweep, the part, its runs and a checksum, followed by the rows or by the tally of the runs.

use std::path::Path;

use super::error;
use super::manifest::Manifest;
use pounding_files::Length;
use pounding_text::Refused;

/// Digits of the checksum.
const DIGITS: usize = 8;

/// The bytes of the file of a part.
pub(super) fn sealed(manifest: &Manifest, part: u64, rows: &[u8]) -> Vec<u8> {
    let mut bytes = begin(manifest, part).into_bytes();
    bytes.extend_from_slice(checksum(&bytes, rows).as_bytes());
    bytes.push(b'\n');
    bytes.extend_from_slice(rows);
    bytes
}

/// The line up to its checksum.
fn begin(manifest: &Manifest, part: u64) -> String {
    let runs = manifest.runs_of(part);
    format!(
        "pounding sweep {}, part {part}, runs {} to {}, crc32 ",
        manifest.sweep,
        runs.start,
        runs.end - 1
    )
}

/// Checksum of the line up to it and of the rows. It protects against accidents: it detects every change within four bytes of the rows, and
/// all other changes except one in four thousand million.
fn checksum(begin: &[u8], rows: &[u8]) -> String {
    let mut sum = crc32fast::Hasher::new();
    sum.update(begin);
    sum.update(rows);
    format!("{:08x}", sum.finalize())
}

/// The length of the line, including its end.
pub(super) fn length_of_line(manifest: &Manifest, part: u64) -> usize {
    begin(manifest, part).len() + DIGITS + 1
}

/// Longest file: 16 384 rows of about ten thousand columns.
const LONGEST: Length = Length::new(4 << 30, "it is none that a sweep wrote");

/// A complete part.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct PartFile {
    bytes: Vec<u8>,
    /// Length of the line.
    line: usize,
}

impl PartFile {
    /// The rows, or the tally.
    pub(super) fn rows(&self) -> &[u8] {
        &self.bytes[self.line..]
    }

    /// Number of rows of runs that failed.
    pub(super) fn n_failed(&self) -> u64 {
        let rows = self.rows();
        // The reason is the last field of a row, and empty if the run succeeded.
        let failed = |end: &usize| *end > 0 && rows[end - 1] != b',';
        memchr::memchr_iter(b'\n', rows).filter(failed).count() as u64
    }
}

/// Fault of the file of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Damage {
    /// It is another part, a part of another sweep, or no part.
    Other,
    /// Its rows do not match its checksum.
    Changed,
}

/// The part with these bytes.
///
/// # Errors
/// Its fault.
fn of(manifest: &Manifest, part: u64, bytes: Vec<u8>) -> Result<PartFile, Damage> {
    let begin = begin(manifest, part);
    if !bytes.starts_with(begin.as_bytes()) {
        return Err(Damage::Other);
    }
    let line = length_of_line(manifest, part);
    let (found, rows) = bytes.split_at_checked(line).ok_or(Damage::Changed)?;
    let wanted = format!("{begin}{}\n", checksum(begin.as_bytes(), rows));
    if found != wanted.as_bytes() {
        return Err(Damage::Changed);
    }
    Ok(PartFile { bytes, line })
}

/// Reads a complete part.
///
/// # Errors
/// Refuses a damaged file, and what the system refuses.
pub(super) fn read(manifest: &Manifest, part: u64, path: &Path) -> Result<PartFile, Refused> {
    let bytes = pounding_files::read(path, LONGEST).map_err(error::file(path))?;
    let length = bytes.len();
    of(manifest, part, bytes).map_err(|damage| {
        let found = match damage {
            Damage::Other if length == 0 => "no bytes",
            Damage::Other => "something else than this part of this sweep",
            Damage::Changed => "other bytes than were written",
        };
        error::damaged(path, found)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extreme_every_change_of_a_byte_is_found() {
        let manifest = Manifest::for_tests(20, 10);
        let rows = b"10,0.5\n11,0.25\n";
        let whole = sealed(&manifest, 1, rows);
        let part = of(&manifest, 1, whole.clone()).unwrap();
        assert_eq!((part.rows(), part.n_failed()), (&rows[..], 2));
        assert_eq!(whole.len(), length_of_line(&manifest, 1) + rows.len());
        for place in 0..whole.len() {
            for byte in 0..=u8::MAX {
                let mut changed = whole.clone();
                changed[place] = byte;
                let accepted = of(&manifest, 1, changed).is_ok();
                assert_eq!(accepted, byte == whole[place], "{place} {byte}");
            }
            assert!(of(&manifest, 1, whole[..place].to_vec()).is_err());
        }
        let longer = [&whole[..], b"\n"].concat();
        assert_eq!(of(&manifest, 1, longer), Err(Damage::Changed));
        assert_eq!(of(&manifest, 0, whole), Err(Damage::Other));
    }
}
