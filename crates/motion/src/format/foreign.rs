//! Files without text and without a known record: packed ones, other encodings, pictures, web pages.

use super::{File, title};
use crate::Refused;
use crate::line::Line;
use pounding_text::Spot;

/// First bytes of files, the kind of file that they identify, and the remedy.
const SIGNATURES: [(&[u8], &str, &str); 11] = {
    const UNPACK: &str = "unpack it and give the file in it";
    const SAVE: &str = "save its numbers as text (CSV)";
    [
        (b"\x1f\x8b", "packed by gzip", "unpack it first (`gunzip FILE.gz`)"),
        (
            b"PK\x03\x04",
            "a ZIP archive, or a sheet of a program such as Excel",
            "unpack it and give a file in it, or save the sheet as CSV",
        ),
        (b"BZh", "packed by bzip2", "unpack it first (`bunzip2 FILE.bz2`)"),
        (b"\xfd7zXZ", "packed by xz", "unpack it first (`unxz FILE.xz`)"),
        (b"7z\xbc\xaf", "a 7z archive", UNPACK),
        (b"\x1f\x9d", "packed by compress", "unpack it first (`uncompress FILE.Z`)"),
        (b"%PDF", "a PDF", "fetch the record as a text file"),
        (b"\xd0\xcf\x11\xe0", "a document of an old office program such as .xls", SAVE),
        (b"\x89HDF", "an HDF5 file", SAVE),
        (b"MATLAB 5.0", "a MAT-file of MATLAB", SAVE),
        (b"\x89PNG", "a picture", "fetch the record as a text file"),
    ]
};

/// Number of bytes in which bytes that no text has are searched.
const SEARCHED: usize = 4096;

/// The refusal of a file of a kind that cannot be read.
pub(super) fn refusal(file: &File<'_>) -> Option<Refused> {
    let bytes = file.bytes;
    let known = SIGNATURES.iter().find(|(start, ..)| bytes.starts_with(start));
    if let Some(&(_, what, advice)) = known {
        return Some(foreign(what, advice));
    }
    if is_full_seed(bytes) {
        return Some(foreign(
            "a full SEED volume, whose headers are not read",
            "save its waveforms as miniSEED",
        ));
    }
    if is_table_of_records(file) {
        return Some(foreign("PEER's table of selected records", "take the .AT2 files that it lists"));
    }
    if is_utf16(bytes) {
        return Some(foreign(
            "text in UTF-16",
            "save it again as UTF-8 (an editor's \"Save as\", or `iconv -f UTF-16 -t UTF-8`)",
        ));
    }
    let begin = file.first()?.head().trim_ascii().to_ascii_lowercase();
    let is_page = [&b"<!doctype html"[..], b"<html"].iter().any(|tag| begin.starts_with(tag));
    is_page.then_some(foreign(
        "a web page",
        "fetch the record again; a site that wants a log-in sends such pages instead",
    ))
}

/// The first byte that no text has, as an error, in a file that no reader recognises.
pub(super) fn binary(bytes: &[u8]) -> Option<Refused> {
    let is_control = |byte: &u8| *byte < b' ' && !matches!(byte, b'\t' | b'\n' | b'\r' | 0x0c | 0x1a);
    let at = bytes.iter().take(SEARCHED).position(is_control)?;
    Some({
        let said = format!(
            "the file is binary (byte {} is {:#04x}) and neither SAC nor miniSEED, the binary formats that are read",
            at + 1,
            bytes[at]
        );
        Refused::that_at(Spot::Byte(at + 1), said).help("fetch the record as text or in one of them")
    })
}

/// A sequence number and the mark of a volume.
fn is_full_seed(bytes: &[u8]) -> bool {
    let begin = bytes.get(..8).unwrap_or(b"        ");
    begin[..6].iter().all(u8::is_ascii_digit) && &begin[6..] == b"V "
}

/// Number of lines in which the headings of PEER's table are searched.
const HEADINGS: usize = 200;

/// Whether the file is the table that PEER's search tool adds to the records.
fn is_table_of_records(file: &File<'_>) -> bool {
    let lines = file.lines.iter().take(HEADINGS);
    let is_heading = |line: &Line<'_>| {
        title::holds(*line, "-- SUMMARY OF") && (title::holds(*line, "SEARCH CRITERIA") || title::holds(*line, "OF SELECTED RECORDS"))
    };
    lines.filter(|line| !line.is_comment()).any(is_heading)
}

/// Whether letters have two bytes: by the mark, or because every second of the first bytes is zero.
fn is_utf16(bytes: &[u8]) -> bool {
    let marked = bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff");
    let pairs = bytes.get(..16).unwrap_or_default();
    let zeros = |offset: usize| {
        let mut chosen = pairs.iter().skip(offset).step_by(2);
        !pairs.is_empty() && chosen.all(|byte| *byte == 0)
    };
    let ascii = |offset: usize| {
        let mut chosen = pairs.iter().skip(offset).step_by(2);
        chosen.all(|byte| matches!(byte, b'\t' | b'\n' | b'\r' | b' '..=b'~'))
    };
    marked || (zeros(1) && ascii(0)) || (zeros(0) && ascii(1))
}

fn foreign(what: &'static str, advice: &'static str) -> Refused {
    let said = Refused::that(format!("the file is {what}"));
    said.allowed_is("a record as text, SAC or miniSEED").help(advice)
}
