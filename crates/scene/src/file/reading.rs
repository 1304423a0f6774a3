//! Files that people write: JSON or TOML, of one form.

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
use crate::{Contact, Error, Scene, SdofFile};

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
/// What the system says of the file, or what is wrong in it and where.
pub fn read_file<T: DeserializeOwned>(path: &Path) -> Result<T, Error> {
    let text = bytes(path).map_err(|error| Refused::unreadable(path, &error))?;
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
    /// What the system says of the file, or what is wrong in it and where.
    pub fn read(path: &Path) -> Result<Self, Error> {
        read_file(path)
    }

    /// Reads a scene from the text of a JSON or TOML file, as [`is_json`] tells them apart.
    ///
    /// # Errors
    /// What is wrong in it and where, with the `path` that the text came from.
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
/// What is wrong in it and where, with the `path` that the text came from.
pub fn parse<T: DeserializeOwned>(text: &[u8], path: &Path) -> Result<T, Error> {
    // What some editors put before UTF-8.
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let is_json = is_json(text, path);
    let read = tree_of(text, is_json).and_then(|(words, tree)| {
        let made = T::deserialize(&tree);
        made.map_err(|unfit| blamed(words, is_json, unfit))
    });
    let refused = read.map_err(|refused| of_record(text, path).unwrap_or(refused).in_file(path));
    Ok(refused?)
}

/// Reads what is there in the words of JSON already.
fn of_words<T: DeserializeOwned>(words: &Value) -> Result<T, Refused> {
    let tree = Tree::grown(words, &mut String::new());
    let made = tree.map_err(Unfit::custom).and_then(|tree| T::deserialize(&tree));
    made.map_err(Unfit::into_refused)
}

/// The text, and what it says.
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

/// What is said of words that are refused, with line and column of what is to blame; of a field that is not there those of the
/// table that lacks it.
fn blamed(text: &str, is_json: bool, unfit: Unfit) -> Refused {
    let mut ways = iter::successors(Some(unfit.way()), |way| {
        let (outer, _) = way.rsplit_once(['.', '['])?;
        Some(outer)
    });
    let spot = ways.find_map(|way| position::Spot::find(text, is_json, way));
    let spot = spot.unwrap_or_default();
    let [name, value] = [spot.name, spot.value].map(|byte| line_and_column(text, byte));
    let is_value = unfit.blames == Blames::Value && name.0 == value.0;
    let (line, column) = if is_value { value } else { name };
    let mut refused = unfit.into_refused();
    refused.place_mut().spot = Some(Spot::Letter(line, column));
    refused
}

/// What is said of a record where a scene is asked for.
fn of_record(text: &[u8], path: &Path) -> Option<Refused> {
    let ending = path.extension().unwrap_or_default();
    // A bad scene may hold a line of numbers alone, and so look like a record of plain text.
    if ending == "toml" || ending == "json" {
        return None;
    }
    let format = pounding_motion::recognised(text)?;
    let found = Refused::default().found(format!("a record ({})", format.name()));
    let init = format!("`pounding init --record {}` writes one that it shakes", path.display());
    Some(found.allowed_is("a scene, a TOML or JSON file").help(init))
}

/// Line and column of a fault, and what its reader says; nothing of a number beyond all numbers.
type Faulty = ((usize, usize), Option<String>);

/// The words of JSON, or the place of a fault.
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

/// The words of TOML, or the place of a fault.
fn toml(text: &str, place: &mut String) -> Result<Tree, Faulty> {
    let grown = toml::Deserializer::parse(text).and_then(|reader| Tree::grown(reader, place));
    grown.map_err(|error| {
        let start = error.span().map_or(0, |span| span.start);
        let lines: Vec<_> = error.message().lines().collect();
        (line_and_column(text, start), Some(format!("not TOML: {}", lines.join(", "))))
    })
}

/// Line and column of a field of a file, counted from 1, as far as it can be found again; nothing in a file of one line.
pub(crate) fn position_in(path: &Path, place: &str) -> Option<Spot> {
    let bytes = bytes(path).ok()?;
    let text = std::str::from_utf8(&bytes).ok()?;
    let spot = position::Spot::find(text, is_json(&bytes, path), place)?;
    let is_one_line = text.trim_end().lines().count() < 2;
    let (line, column) = line_and_column(text, spot.name);
    (!is_one_line).then_some(Spot::Letter(line, column))
}

/// Line and column of a byte, counted from 1, the column in letters.
fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|letter| *letter != '\n').count() + 1;
    (line, column)
}

impl Error {
    /// Names the file that holds the scene, and the line of the field, where the message does not yet name a file.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        self.said(|refused| in_file(refused, path))
    }
}

/// Names the file of a field, and its line where it is found there, unless a file is named already.
pub fn in_file(mut refused: Refused, path: &Path) -> Refused {
    let place = refused.place_mut();
    if place.file.is_none() {
        let field = place.field.as_ref();
        place.spot = place.spot.or(field.and_then(|field| position_in(path, field.path())));
        place.file = Some(path.to_path_buf());
    }
    refused
}
