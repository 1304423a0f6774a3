//! Files that people write: JSON or TOML, of one form.

use std::io::Read;
use std::iter;
use std::path::Path;

use pounding_files::Length;
use serde::de::{DeserializeOwned, Error as _};
use serde_json::Value;

use super::position::Spot;
use super::refused::{Blames, Refused};
use super::tree::Tree;
use crate::{Contact, Error, Fault, Scene, SdofFile};

/// Reads what a stream gives to its end, as much as a file may have.
///
/// # Errors
/// What the system says of the stream.
pub fn bytes_of(stream: impl Read) -> std::io::Result<Vec<u8>> {
    pounding_files::read_stream(stream, LONGEST)
}

/// Reads a JSON or TOML file; an error names the line and the field.
///
/// # Errors
/// [`Error::Unreadable`] or [`Error::Form`].
pub fn read_file<T: DeserializeOwned>(path: &Path) -> Result<T, Error> {
    let text = bytes(path).map_err(|source| Error::Unreadable {
        path: path.to_path_buf(),
        source,
    })?;
    parse(&text, path)
}

/// Longest file that people write: some hundred thousand structures.
const LONGEST: Length = Length::new(64 << 20, "take fewer structures");
/// Longest record: ten million samples with time and acceleration to the last digit.
const LONGEST_RECORD: Length = Length::new(512 << 20, "cut the record to the shaking that matters");

/// The bytes of a file that people write; of one that has no end, or of a pipe that nobody fills, an error.
///
/// # Errors
/// What the system says of the file.
pub fn bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    pounding_files::read(path, LONGEST)
}

/// The bytes of the file of a record, within the same bounds but longer.
///
/// # Errors
/// What the system says of the file.
pub fn record_bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    pounding_files::read(path, LONGEST_RECORD)
}

/// What reads a type is large: it is compiled here once, and not with every program that reads a scene.
impl Scene {
    /// Reads a scene from a JSON or TOML file; an error names the line and the field.
    ///
    /// # Errors
    /// [`Error::Unreadable`] or [`Error::Form`].
    pub fn read(path: &Path) -> Result<Self, Error> {
        read_file(path)
    }

    /// Reads a scene from the text of a JSON or TOML file, as [`is_json`] tells them apart.
    ///
    /// # Errors
    /// [`Error::Form`], with the `path` that the text came from.
    pub fn parse(text: &[u8], path: &Path) -> Result<Self, Error> {
        parse(text, path)
    }
}

macro_rules! of_words {
    ($($read:ty),+) => {$(
        impl $read {
            /// Reads what is there in the words of JSON already.
            ///
            /// # Errors
            /// What is wrong, and at which place of the words.
            pub fn of_words(words: &Value) -> Result<Self, Refused> {
                of_words(words)
            }
        }
    )+};
}

of_words!(Contact, Scene, SdofFile);

/// Whether the text of a file is JSON and not TOML: its first letter is `{`, or the ending of its name says so.
pub fn is_json(text: &[u8], path: &Path) -> bool {
    let named = path.extension().is_some_and(|ending| ending == "json");
    named || text.trim_ascii_start().starts_with(b"{")
}

/// Reads the text of a JSON or TOML file, as [`is_json`] tells them apart.
///
/// # Errors
/// [`Error::Form`], with the `path` that the text came from.
pub fn parse<T: DeserializeOwned>(text: &[u8], path: &Path) -> Result<T, Error> {
    // What some editors put before UTF-8.
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let is_json = is_json(text, path);
    let (words, tree) = tree_of(text, is_json).map_err(|said| form(said, text, path))?;
    T::deserialize(&tree).map_err(|refused| form(blamed(words, is_json, refused), text, path))
}

/// Reads what is there in the words of JSON already.
fn of_words<T: DeserializeOwned>(words: &Value) -> Result<T, Refused> {
    let tree = Tree::grown(words, &mut String::new());
    T::deserialize(&tree.map_err(Refused::custom)?)
}

/// Line and column, field, and fault.
type Said = (Option<(usize, usize)>, Option<String>, Fault);

/// The text, and what it says.
fn tree_of(text: &[u8], is_json: bool) -> Result<(&str, Tree), Said> {
    let text = std::str::from_utf8(text).map_err(|error| {
        let byte = error.valid_up_to();
        (None, None, Fault::NotUtf8 { byte })
    })?;
    let mut place = String::new();
    let grown = if is_json { json(text, &mut place) } else { toml(text, &mut place) };
    let tree = grown.map_err(|((line, column), fault)| {
        let place = (fault == Fault::Beyond).then_some(place);
        let line_text = text.lines().nth(line - 1).filter(|_| place.is_none());
        let common = line_text.and_then(|line| Fault::of_line(line, is_json));
        (Some((line, column)), place, common.unwrap_or(fault))
    })?;
    Ok((text, tree))
}

/// What is said of words that are refused, with line and column of what is to blame; of a field that is not there those of the
/// table that lacks it.
fn blamed(text: &str, is_json: bool, refused: Refused) -> Said {
    let mut ways = iter::successors(Some(refused.way()), |way| {
        let (outer, _) = way.rsplit_once(['.', '['])?;
        Some(outer)
    });
    let spot = ways.find_map(|way| Spot::find(text, is_json, way));
    let spot = spot.unwrap_or_default();
    let [name, value] = [spot.name, spot.value].map(|byte| line_and_column(text, byte));
    let is_value = refused.blames == Blames::Value && name.0 == value.0;
    let position = if is_value { value } else { name };
    let place = refused.place().into();
    (Some(position), Some(place), refused.into_fault())
}

fn form(said: Said, text: &[u8], path: &Path) -> Error {
    let of_record = of_record(text, path).map(|fault| (None, None, fault));
    let (position, place, fault) = of_record.unwrap_or(said);
    Error::Form {
        path: path.to_path_buf(),
        position,
        place,
        fault: Box::new(fault),
    }
}

/// What is said of a record where a scene is asked for.
fn of_record(text: &[u8], path: &Path) -> Option<Fault> {
    let ending = path.extension().unwrap_or_default();
    // A bad scene may hold a line of numbers alone, and so look like a record of plain text.
    if ending == "toml" || ending == "json" {
        return None;
    }
    let format = pounding_motion::recognised(text)?;
    Some(Fault::Record {
        format: format.name(),
        path: path.to_path_buf(),
    })
}

/// The words of JSON, or the place of a fault.
fn json(text: &str, place: &mut String) -> Result<Tree, ((usize, usize), Fault)> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let grown = Tree::grown(&mut reader, place);
    let grown = grown.and_then(|tree| reader.end().map(|()| tree));
    grown.map_err(|error| {
        let message = error.to_string();
        let fault = match message.rsplit_once(" at line ") {
            Some(("number out of range", _)) => Fault::Beyond,
            Some((message, _)) => Fault::Json(message.into()),
            None => Fault::Json(message),
        };
        ((error.line(), error.column()), fault)
    })
}

/// The words of TOML, or the place of a fault.
fn toml(text: &str, place: &mut String) -> Result<Tree, ((usize, usize), Fault)> {
    let grown = toml::Deserializer::parse(text).and_then(|reader| Tree::grown(reader, place));
    grown.map_err(|error| {
        let start = error.span().map_or(0, |span| span.start);
        let lines: Vec<_> = error.message().lines().collect();
        (line_and_column(text, start), Fault::Toml(lines.join(", ")))
    })
}

/// Line and column of a field of a file, counted from 1, as far as it can be found again; nothing in a file of one line.
pub fn position_in(path: &Path, place: &str) -> Option<(usize, usize)> {
    let bytes = bytes(path).ok()?;
    let text = std::str::from_utf8(&bytes).ok()?;
    let spot = Spot::find(text, is_json(&bytes, path), place)?;
    let is_one_line = text.trim_end().lines().count() < 2;
    (!is_one_line).then(|| line_and_column(text, spot.name))
}

impl Error {
    /// The field to blame in the file of its scene, as messages name it.
    pub fn place(&self) -> Option<String> {
        let message = if let Self::Scene { source, .. } = self {
            source.to_string()
        } else if matches!(self, Self::NoRecord { .. }) {
            self.to_string()
        } else {
            return None;
        };
        let (place, _) = message.split_once(": ")?;
        Some(place.into())
    }

    /// Names the file that holds the scene, and the line of the field, where the message does not yet.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        if matches!(
            self,
            Self::Scene { .. } | Self::Run { .. } | Self::Broken { .. } | Self::NoReference(_) | Self::NoRecord { .. }
        ) {
            Self::InFile {
                path: path.to_path_buf(),
                position: self.place().and_then(|place| position_in(path, &place)),
                source: Box::new(self),
            }
        } else {
            self
        }
    }
}

/// Line and column of a byte, counted from 1, the column in letters.
fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|letter| *letter != '\n').count() + 1;
    (line, column)
}
