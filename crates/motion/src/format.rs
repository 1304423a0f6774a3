//! Detection of the format of a file, and common steps of all formats.

mod afad;
mod at2;
mod bbp;
mod bhrc;
mod columns;
mod commas;
mod component;
mod cosmos;
mod csmip_v1;
mod csmip_v2;
mod csmip_v3;
mod csmnc;
mod csv;
mod cwb;
mod draft;
mod dyna;
mod emod3d;
mod eqsig;
mod esm;
mod foreign;
mod geonet;
mod identity;
mod knet;
mod miniseed;
mod numbers;
mod plain;
mod quotes;
mod renadic;
mod sac;
mod said;
mod simcenter;
mod smc;
mod spacing;
mod stamp;
mod table;
mod time_column;
mod title;
mod unam;
mod usc;
mod usgs_text;
mod values;

use std::borrow::Cow;

use crate::line::{Line, excerpt, lines, number};
use crate::refusals;
use crate::{Accelerogram, Channel, Contents, Declared, Direction, FilePlace, Format, Identity, Refused, Site};
use component::{Component, chosen};
use draft::{Draft, Peak, Scale, Stated, reading};
use pounding_text::{Naming, RefusalKind, Spot};
use spacing::Spacing;

/// Ctrl-Z, which old programs write at the end of a text.
const END_OF_TEXT: u8 = 0x1a;

/// The bytes of a file, with its lines if it is a text.
struct File<'t> {
    bytes: &'t [u8],
    lines: Vec<Line<'t>>,
    /// Whether the caller states that values follow each other in rows.
    in_rows: bool,
}

/// The reader of a format.
struct Reader {
    format: Format,
    /// Whether the contents of the file have this format.
    recognises: fn(&File<'_>) -> bool,
    /// The components in their order; none if the file holds a single one without a name.
    components: fn(&File<'_>) -> Result<Vec<Component>, Refused>,
    /// Reads the component with this index, 0 if none has a name.
    read: fn(&File<'_>, usize) -> Result<Draft, Refused>,
    /// Reads the place and time of the recording.
    identity: fn(&File<'_>) -> Identity,
}

/// The readers; the first that recognises a file reads it.
///
/// CSV comes first: its header is unmistakable, and its comments may contain the header of any other format.
const READERS: [Reader; 26] = [
    csv::READER,
    sac::READER,
    miniseed::READER,
    cosmos::READER,
    csmip_v3::READER,
    usc::READER,
    csmip_v2::READER,
    smc::READER,
    geonet::READER,
    renadic::READER,
    csmip_v1::READER,
    knet::READER,
    esm::READER,
    cwb::READER,
    afad::READER,
    unam::READER,
    bbp::READER,
    bhrc::READER,
    csmnc::READER,
    dyna::READER,
    usgs_text::READER,
    at2::READER,
    emod3d::READER,
    eqsig::READER,
    simcenter::READER,
    plain::READER,
];

/// Reads the bytes of a file in any [`Format`], which is recognised by the contents, not by the file name.
///
/// The file must contain all information; see [`read_declared`].
///
/// # Errors
/// [`Refused`] with the place, the value found, the values allowed and the remedy.
pub fn read(bytes: &[u8]) -> Result<Accelerogram, Refused> {
    read_declared(bytes, &Declared::default())
}

/// Reads the bytes of a file in any [`Format`], with the caller's knowledge of it.
///
/// If a header states the number of samples or their peak, the values must agree. The text may contain any bytes; bytes that are not UTF-8
/// are replaced in titles and refused in numbers.
///
/// # Errors
/// [`Refused`] with the place, the value found, the values allowed and the remedy: also for information that neither the file nor the
/// caller gives, and for contradictions between the two.
pub fn read_declared(bytes: &[u8], declared: &Declared) -> Result<Accelerogram, Refused> {
    let read = read_as_declared(bytes, declared);
    read.map_err(|refused| refused.by(Naming::Argument))
}

fn read_as_declared(bytes: &[u8], declared: &Declared) -> Result<Accelerogram, Refused> {
    let (text, commas) = with_bare_numbers(bytes);
    let file = File {
        in_rows: declared.in_rows,
        ..File::new(&text)?
    };
    let reader = reader(&file)?;
    let components = (reader.components)(&file)?;
    let index = chosen(&components, declared.component.as_deref())?;
    let draft = (reader.read)(&file, index).map(|mut draft| {
        let remark = |line| reading("decimal commas", Some(FilePlace::Line(line)), "read as points");
        draft.remarks.extend(commas.map(remark));
        draft
    });
    let settled = draft.and_then(|draft| {
        let ends = !continues(&file, draft.end);
        draft.settle(reader.format, components.get(index), declared, ends)
    });
    settled.map_err(|refused| located(refused, &file))
}

/// The text without quotes around numbers and with decimal points, and the number of its first row with decimal commas.
fn with_bare_numbers(bytes: &[u8]) -> (Cow<'_, [u8]>, Option<usize>) {
    match quotes::without(bytes) {
        Cow::Borrowed(bytes) => commas::with_points(bytes),
        Cow::Owned(text) => {
            let (text, line) = commas::with_points(&text);
            (Cow::Owned(text.into_owned()), line)
        }
    }
}

/// Returns the format of a file, by its content; `None` if it is unknown.
///
/// A file of a known format may still be refused when it is read.
pub fn recognised(bytes: &[u8]) -> Option<Format> {
    let (text, _) = with_bare_numbers(bytes);
    let file = File::new(&text).ok()?;
    reader(&file).ok().map(|reader| reader.format)
}

/// Returns the names of the components of a file, in their order; empty for a single component without a name.
///
/// # Errors
/// Refuses a file of unknown format, and one whose components are not found; see [`Refused`].
pub fn components(bytes: &[u8]) -> Result<Vec<String>, Refused> {
    let (text, _) = with_bare_numbers(bytes);
    let file = File::new(&text)?;
    let components = (reader(&file)?.components)(&file)?;
    Ok(names(components))
}

/// Returns the contents of a file before a component is chosen: its components with their directions and sensors, and place and time of the
/// recording.
///
/// # Errors
/// Refuses a file of unknown format, and one whose components are not found; see [`Refused`].
pub fn contents(bytes: &[u8]) -> Result<Contents, Refused> {
    let (text, _) = with_bare_numbers(bytes);
    let file = File::new(&text)?;
    let reader = reader(&file)?;
    let channel = |component: Component| Channel {
        direction: Direction::of_component(&component.name),
        name: Some(component.name),
        site: component.site,
    };
    let components = (reader.components)(&file)?;
    let mut channels: Vec<Channel> = components.into_iter().map(channel).collect();
    if channels.is_empty() {
        channels.push(Channel {
            name: None,
            direction: None,
            site: Site::Ground,
        });
    }
    Ok(Contents {
        format: reader.format,
        channels,
        identity: (reader.identity)(&file),
    })
}

fn names(components: impl IntoIterator<Item = Component>) -> Vec<String> {
    components.into_iter().map(|component| component.name).collect()
}

/// The blocks of lines, each from a line for which `begins` is true to the next one.
fn blocks<'l, 't>(lines: &'l [Line<'t>], begins: impl Fn(usize) -> bool) -> Vec<&'l [Line<'t>]> {
    let mut starts: Vec<usize> = (0..lines.len()).filter(|index| begins(*index)).collect();
    starts.push(lines.len());
    starts.windows(2).map(|pair| &lines[pair[0]..pair[1]]).collect()
}

/// For formats with a single component without a name.
#[expect(clippy::unnecessary_wraps, reason = "one signature for all formats")]
fn one_component(_: &File<'_>) -> Result<Vec<Component>, Refused> {
    Ok(Vec::new())
}

/// For formats without place and time.
fn no_identity(_: &File<'_>) -> Identity {
    Identity::default()
}

fn reader(file: &File<'_>) -> Result<&'static Reader, Refused> {
    let known = READERS.iter().find(|reader| (reader.recognises)(file));
    match known {
        Some(reader) if matches!(reader.format, Format::Sac | Format::MiniSeed) => Ok(reader),
        _ => match foreign::refusal(file) {
            Some(refusal) => Err(refusal),
            None => known.ok_or_else(|| unknown(file)),
        },
    }
}

fn unknown(file: &File<'_>) -> Refused {
    let begin = || match file.first() {
        None => refusals::empty(),
        Some(line) => {
            let said = format!("line {} begins none of the formats known: {}", line.number, Format::names());
            let refused = Refused::that_at(Spot::Line(line.number), said).kind(RefusalKind::NoRecord);
            refused.help("fetch the file again in one of them, or write one number to a line")
        }
    };
    foreign::binary(file.bytes).unwrap_or_else(begin)
}

impl<'t> File<'t> {
    /// Blank lines above the first line, rows of only commas below the last, and the DOS mark at the end are ignored.
    fn new(bytes: &'t [u8]) -> Result<Self, Refused> {
        let end = bytes.trim_ascii_end();
        let marks = end.iter().rev().take_while(|byte| **byte == END_OF_TEXT);
        let text = match marks.count() {
            0 => bytes,
            n_marks => &end[..end.len() - n_marks],
        };
        let mut lines = lines(text)?;
        let n_blank = lines.iter().take_while(|line| line.is_blank()).count();
        lines.drain(..n_blank);
        let is_empty = |byte: &u8| byte.is_ascii_whitespace() || matches!(byte, b',' | b';');
        while let Some(last) = lines.last()
            && last.bytes.iter().all(is_empty)
        {
            lines.pop();
        }
        Ok(Self {
            bytes,
            lines,
            in_rows: false,
        })
    }

    /// The lines through this one.
    fn through(&self, line: Line<'_>) -> &[Line<'t>] {
        let first = self.lines.first().map_or(0, |first| first.number);
        &self.lines[..=line.number - first]
    }

    /// The lines after this one.
    fn behind(&self, line: Line<'_>) -> &[Line<'t>] {
        &self.lines[self.through(line).len()..]
    }

    /// The first line that is neither blank nor a comment.
    fn first(&self) -> Option<Line<'t>> {
        let mut lines = self.lines.iter().copied();
        lines.find(|line| !line.is_blank() && !line.is_comment())
    }
}

/// The error, or an error about the field at which the values stopped.
fn located(error: Refused, file: &File<'_>) -> Refused {
    let Some(Spot::Line(last)) = error.place().spot.filter(|_| error.is_kind(RefusalKind::CutShort)) else {
        return error;
    };
    let mut behind = file.lines.iter().filter(|line| line.number > last && !line.is_blank());
    let Some(line) = behind.next() else {
        return error;
    };
    let is_bad = |piece: &&[u8]| number(piece).is_none_or(|value| !value.is_finite());
    let of_numbers = line.pieces().all(is_like_a_number);
    let bad = line.pieces().enumerate().find(|(_, piece)| is_bad(piece));
    match bad {
        Some((index, piece)) if of_numbers => refusals::not_a_number(line.number, index + 1, excerpt(piece)),
        _ => error.found_also(format!(" (line {} reads {:?})", line.number, line.excerpt())),
    }
}

/// Whether a line of numbers, sound or damaged, follows the last value.
fn continues(file: &File<'_>, end: FilePlace) -> bool {
    let last = end.line().unwrap_or(usize::MAX);
    let mut behind = file.lines.iter().filter(|line| line.number > last && !line.is_blank());
    let next = behind.next();
    next.is_some_and(|line| line.pieces().all(is_like_a_number))
}

/// Whether a piece is a number or remains of one: digits with commas, the asterisks of Fortran, the words of programs for NaN.
fn is_like_a_number(piece: &[u8]) -> bool {
    let of_digits = |byte: &u8| byte.is_ascii_digit() || b".,+-*?#eEdD".contains(byte);
    let has_digit = piece.iter().any(|byte| byte.is_ascii_digit() || matches!(byte, b'*' | b'?' | b'#'));
    let words = [
        &b"NA"[..],
        b"N/A",
        b"NULL",
        b"NONE",
        b"#N/A",
        b"#NUM!",
        b"#VALUE!",
        b"#REF!",
        b"#DIV/0!",
    ];
    number(piece).is_some() || (has_digit && piece.iter().all(of_digits)) || words.iter().any(|word| word.eq_ignore_ascii_case(piece))
}
