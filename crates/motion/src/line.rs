//! Lines and numbers of a text that may hold any bytes.

use crate::refusals;
use pounding_text::Spot;
use std::borrow::Cow;

use crate::Refused;

/// Longest piece of a text that a message repeats, in characters.
const EXCERPT: usize = 60;

/// Most bytes of a line that are read as words; a line of values may be as long as its file.
const WORDS: usize = 4096;

/// One line of a text, without its end, and its number from 1.
///
/// The line stays bytes until a field is cut out: the columns of fixed-width data are counted in bytes, and old headers contain letters of
/// many code pages.
#[derive(Clone, Copy)]
pub(crate) struct Line<'a> {
    pub(crate) number: usize,
    pub(crate) bytes: &'a [u8],
}

impl<'a> Line<'a> {
    pub(crate) fn is_blank(self) -> bool {
        self.bytes.trim_ascii().is_empty()
    }

    pub(crate) fn is_comment(self) -> bool {
        self.bytes.starts_with(b"#")
    }

    /// The first part of the line, with at most as many bytes as words of a header take.
    pub(crate) fn head(self) -> &'a [u8] {
        &self.bytes[..self.bytes.len().min(WORDS)]
    }

    /// The [head](Self::head) as text; bytes that are not UTF-8 are letters of Latin-1, such as the `²` of a unit, or replacement
    /// characters.
    pub(crate) fn text(self) -> Cow<'a, str> {
        if let Ok(text) = std::str::from_utf8(self.head()) {
            return Cow::Borrowed(text);
        }
        let letter = |byte: u8| match byte {
            0x80..0xa0 => char::REPLACEMENT_CHARACTER,
            byte => char::from(byte),
        };
        Cow::Owned(self.head().iter().copied().map(letter).collect())
    }

    /// The start of the line, for a message.
    pub(crate) fn excerpt(self) -> String {
        excerpt(self.bytes)
    }

    /// The pieces between blanks.
    pub(crate) fn pieces(self) -> Fields<'a> {
        Fields {
            rest: self.bytes,
            is_over: false,
            commas: false,
        }
    }

    /// The fields between commas, or between blanks if there are no commas. Empty fields at the end, which spreadsheets add, are left out.
    pub(crate) fn fields(self) -> Fields<'a> {
        let is_empty = |byte: &u8| *byte == b',' || byte.is_ascii_whitespace();
        let end = self.bytes.iter().rposition(|byte| !is_empty(byte));
        let held = &self.bytes[..end.map_or(0, |last| last + 1)];
        Fields {
            rest: held,
            is_over: held.is_empty(),
            commas: memchr::memchr(b',', held).is_some(),
        }
    }

    /// The number in a field of this line; `field` counts from 1.
    pub(crate) fn finite(self, field: usize, bytes: &[u8]) -> Result<f64, Refused> {
        let line = self.number;
        match number(bytes) {
            None => Err(refusals::not_a_number(line, field, excerpt(bytes))),
            Some(value) if !value.is_finite() => Err(Refused::at(Spot::Field(line, field))
                .is("")
                .quoted(excerpt(bytes))
                .and(" is not finite")
                .but(", and ", "every number must be")
                .help("put a measured value there or cut the record before it")),
            Some(value) => Ok(value),
        }
    }
}

/// The fields of a line, cut one after the other because a line of values may hold the whole file.
#[derive(Clone, Debug)]
pub(crate) struct Fields<'a> {
    rest: &'a [u8],
    is_over: bool,
    commas: bool,
}

impl<'a> Iterator for Fields<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        if self.is_over {
            return None;
        }
        if !self.commas {
            self.rest = self.rest.trim_ascii_start();
        }
        let is_end = |byte: &u8| byte.is_ascii_whitespace();
        let end = if self.commas {
            memchr::memchr(b',', self.rest)
        } else {
            self.rest.iter().position(is_end)
        };
        let (field, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest.get(1..).unwrap_or_default();
        self.is_over = end.is_none();
        // A field between commas may be empty, a field between blanks may not.
        (self.commas || !field.is_empty()).then(|| field.trim_ascii())
    }
}

/// Most lines of a text: two for each sample of the longest record. They take 480 MB.
const MOST: usize = 20_000_000;
/// Most lines of a text with mostly empty lines, which is not a record: such lines take more memory than twelve times the text.
const MOST_EMPTY: usize = 1_000_000;

/// The lines of a text that end in LF, CR LF or CR, without a byte order mark.
///
/// # Errors
/// Refuses a text with too many lines before it takes memory for them.
pub(crate) fn lines(bytes: &[u8]) -> Result<Vec<Line<'_>>, Refused> {
    let mut rest = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let count = |end: u8| memchr::memchr_iter(end, rest).count();
    let n_ends = count(b'\n').max(count(b'\r'));
    let allowed = if 2 * n_ends > rest.len() { MOST_EMPTY } else { MOST };
    if n_ends > allowed {
        return Err(Refused::default()
            .found(format!("{n_ends} lines"))
            .allowed_are(allowed.to_string())
            .help("cut the record to the shaking that matters"));
    }
    let mut lines = Vec::with_capacity(n_ends + 1);
    while !rest.is_empty() {
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        let (bytes, after) = rest.split_at(end);
        lines.push(Line {
            number: lines.len() + 1,
            bytes,
        });
        rest = after.strip_prefix(b"\r\n").or_else(|| after.get(1..)).unwrap_or_default();
    }
    Ok(lines)
}

/// Most bytes of a number.
const NUMBER: usize = 400;

/// A number as C or Fortran writes it, including `1.5D-3`; blanks around it are skipped.
pub(crate) fn number(bytes: &[u8]) -> Option<f64> {
    let bytes = bytes.trim_ascii();
    if bytes.len() > NUMBER {
        return None;
    }
    let text = std::str::from_utf8(bytes).ok()?;
    text.parse().ok().or_else(|| text.replace(['D', 'd'], "E").parse().ok())
}

pub(crate) fn excerpt(bytes: &[u8]) -> String {
    let bytes = bytes.trim_ascii();
    // A letter takes at most four bytes.
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4 * EXCERPT + 4)]);
    match text.char_indices().nth(EXCERPT) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into_owned(),
    }
}
