//! Files that people write, in JSON or TOML.

use std::io::Read;
use std::iter;
use std::path::Path;

use pounding_files::Length;
use pounding_text::{Refused, Spot};
use serde::de::{DeserializeOwned, Error as _};
use serde_json::Value;

use super::tree::Tree;
use super::unfit::{Blames, Unfit};
use super::{fault, position};
use crate::file::SdofFile;
use crate::{Contact, Error, Scene};

/// Reads a stream to its end, up to the longest allowed file.
///
/// # Errors
/// Errors of the system, and a stream that is too long.
pub fn bytes_of(stream: impl Read) -> std::io::Result<Vec<u8>> {
    pounding_files::read_stream(stream, LONGEST)
}

/// Reads a JSON or TOML file. An error names the line and the field.
///
/// # Errors
/// Refuses a file that cannot be read, and content that does not fit, with its position.
pub fn read<T: DeserializeOwned>(path: &Path) -> Result<T, Error> {
    let text = bytes(path).map_err(|error| Refused::unreadable(path, &error))?;
    parse(&text, path)
}

/// Longest file that people write: some hundred thousand structures.
const LONGEST: Length = Length::new(64 << 20, "take fewer structures");
/// Longest record: ten million samples with time and acceleration to all digits.
const LONGEST_RECORD: Length = Length::new(512 << 20, "cut the record to the shaking that matters");

/// Reads the bytes of a file that people write. Refuses a file without end and a pipe without a writer.
///
/// # Errors
/// Errors of the system, and a file that is too long.
pub fn bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    pounding_files::read(path, LONGEST)
}

/// Reads the bytes of a record file, which may be longer.
///
/// # Errors
/// Errors of the system, and a file that is too long.
pub fn record_bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    pounding_files::read(path, LONGEST_RECORD)
}

/// Deserialisers are large. This one is compiled here once, instead of with every program that reads a scene.
impl Scene {
    /// Reads a scene from a JSON or TOML file. An error names the line and the field.
    ///
    /// # Errors
    /// Refuses a file that cannot be read, and content that does not fit, with its position.
    pub fn read(path: &Path) -> Result<Self, Error> {
        read(path)
    }

    /// Reads a scene from the text of a JSON or TOML file; [`is_json`] decides which.
    ///
    /// # Errors
    /// Refuses content that does not fit, with its position and the `path` of the text.
    pub fn parse(text: &[u8], path: &Path) -> Result<Self, Error> {
        parse(text, path)
    }
}

macro_rules! of_words {
    ($($read:ty),+) => {$(
        impl $read {
            /// Reads the value from a JSON tree.
            ///
            /// # Errors
            /// Refuses content that does not fit, with its place in the tree.
            pub fn of_words(words: &Value) -> Result<Self, Refused> {
                of_words(words)
            }
        }
    )+};
}

of_words!(Contact, Scene, SdofFile);

/// Whether the text of a file is JSON: it begins with `{`, or the name of the file ends with `.json`. Otherwise it is TOML.
pub fn is_json(text: &[u8], path: &Path) -> bool {
    let named = path.extension().is_some_and(|ending| ending == "json");
    named || text.trim_ascii_start().starts_with(b"{")
}

/// Reads the text of a JSON or TOML file; [`is_json`] decides which.
///
/// # Errors
/// Refuses content that does not fit, with its position and the `path` of the text.
pub fn parse<T: DeserializeOwned>(text: &[u8], path: &Path) -> Result<T, Error> {
    // Some editors put a byte order mark before UTF-8.
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let is_json = is_json(text, path);
    let read = tree_of(text, is_json).and_then(|(words, tree)| {
        let made = T::deserialize(&tree);
        made.map_err(|unfit| blamed(words, is_json, unfit))
    });
    let refused = read.map_err(|refused| of_record(text, path).unwrap_or(refused).in_file(path));
    Ok(refused?)
}

/// Reads a value from a JSON tree.
fn of_words<T: DeserializeOwned>(words: &Value) -> Result<T, Refused> {
    let tree = Tree::grown(words, &mut String::new());
    let made = tree.map_err(Unfit::custom).and_then(|tree| T::deserialize(&tree));
    made.map_err(Unfit::into_refused)
}

/// Returns the text and its tree.
fn tree_of(text: &[u8], is_json: bool) -> Result<(&str, Tree), Refused> {
    let text = std::str::from_utf8(text).map_err(|error| {
        let said = Refused::that(format!("the text is not UTF-8 from byte {} on", error.valid_up_to()));
        said.help("save it as UTF-8")
    })?;
    let mut place = String::new();
    let grown = if is_json { json(text, &mut place) } else { toml(text, &mut place) };
    let tree = grown.map_err(|(spot, fault)| {
        let mut refused = match fault {
            Some(fault) => {
                let line = text.lines().nth(spot.0 - 1);
                let common = line.and_then(|line| fault::of_line(line, is_json));
                common.unwrap_or_else(|| Refused::that(fault))
            }
            None => Refused::at(place).found("a number beyond 1.8e308").allowed_are("smaller ones"),
        };
        refused.place_mut().spot = Some(Spot::Letter(spot.0, spot.1));
        refused
    })?;
    Ok((text, tree))
}

/// Adds the line and the column of the faulty field to a refusal; for a missing field those of the table that lacks it.
fn blamed(text: &str, is_json: bool, unfit: Unfit) -> Refused {
    let mut ways = iter::successors(Some(unfit.way()), |way| {
        let (outer, _) = way.rsplit_once(['.', '['])?;
        Some(outer)
    });
    let spot = ways.find_map(|way| position::FieldBytes::find(text, is_json, way));
    let spot = spot.unwrap_or_default();
    let [name, value] = [spot.name, spot.value].map(|byte| line_and_column(text, byte));
    let is_value = unfit.blames == Blames::Value && name.0 == value.0;
    let (line, column) = if is_value { value } else { name };
    let mut refused = unfit.into_refused();
    refused.place_mut().spot = Some(Spot::Letter(line, column));
    refused
}

/// Refusal of a record file where a scene is expected.
fn of_record(text: &[u8], path: &Path) -> Option<Refused> {
    let ending = path.extension().unwrap_or_default();
    // A bad scene may hold a line of numbers only, and thus look like a record in plain text.
    if ending == "toml" || ending == "json" {
        return None;
    }
    let format = pounding_motion::recognised(text)?;
    let found = Refused::default().found(format!("a record ({})", format.name()));
    let init = format!("`pounding init --record {}` writes one that it shakes", path.display());
    Some(found.allowed_is("a scene, a TOML or JSON file").help(init))
}

/// Line and column of a fault, and the message of its reader; `None` for a number out of range.
type Faulty = ((usize, usize), Option<String>);

/// Reads the tree of JSON, or finds the place of a fault.
fn json(text: &str, place: &mut String) -> Result<Tree, Faulty> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let grown = Tree::grown(&mut reader, place);
    let grown = grown.and_then(|tree| reader.end().map(|()| tree));
    grown.map_err(|error| {
        let message = error.to_string();
        let message = message.rsplit_once(" at line ").map_or(&*message, |(message, _)| message);
        let is_beyond = message == "number out of range";
        let said = (!is_beyond).then(|| format!("not JSON: {message}"));
        ((error.line(), error.column()), said)
    })
}

/// Reads the tree of TOML, or finds the place of a fault.
fn toml(text: &str, place: &mut String) -> Result<Tree, Faulty> {
    let grown = toml::Deserializer::parse(text).and_then(|reader| Tree::grown(reader, place));
    grown.map_err(|error| {
        let start = error.span().map_or(0, |span| span.start);
        let lines: Vec<_> = error.message().lines().collect();
        (line_and_column(text, start), Some(format!("not TOML: {}", lines.join(", "))))
    })
}

/// Line and column of a field of a file, counted from 1; `None` if it is not found, and for a file of one line.
pub(crate) fn position_in(path: &Path, place: &str) -> Option<Spot> {
    let bytes = bytes(path).ok()?;
    let text = std::str::from_utf8(&bytes).ok()?;
    let spot = position::FieldBytes::find(text, is_json(&bytes, path), place)?;
    let is_one_line = text.trim_end().lines().count() < 2;
    let (line, column) = line_and_column(text, spot.name);
    (!is_one_line).then_some(Spot::Letter(line, column))
}

/// Line and column of a byte, counted from 1; the column counts letters.
fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|letter| *letter != '\n').count() + 1;
    (line, column)
}

impl Error {
    /// Adds the file of the scene and the line of the field to the message, unless it names a file.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        self.said(|refused| in_file(refused, path))
    }
}

/// Adds the file of a field and its line to a refusal, unless it names a file.
pub fn in_file(mut refused: Refused, path: &Path) -> Refused {
    let place = refused.place_mut();
    if place.file.is_none() {
        let field = place.field.as_ref();
        place.spot = place.spot.or(field.and_then(|field| position_in(path, field.path())));
        place.file = Some(path.to_path_buf());
    }
    refused
}
