//! Files that people write: JSON or TOML, of one form.

use std::io::Read;
use std::path::Path;

use pounding_files::Length;
use serde::de::{DeserializeOwned, IgnoredAny};

use crate::{Error, Fault, Scene, file::position};

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

/// Deserialisers are large: they are compiled here once, and not with every program that reads a scene.
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
    let refused = if is_json { json(text) } else { toml(text) };
    refused.map_err(|refused| {
        let refused =
            record(text, path).unwrap_or_else(|| refused.of_common_mistake(text, is_json));
        Error::Form {
            path: path.to_path_buf(),
            position: refused.position,
            place: refused.place,
            fault: Box::new(refused.fault),
        }
    })
}

/// What is said of a record where a scene is asked for.
fn record(text: &[u8], path: &Path) -> Option<Refused> {
    let ending = path.extension().unwrap_or_default();
    // A bad scene may hold a line of numbers alone, and so look like a record of plain text.
    if ending == "toml" || ending == "json" {
        return None;
    }
    let format = pounding_motion::recognised(text)?;
    Some(Refused {
        position: None,
        place: None,
        fault: Fault::Record {
            format: format.name(),
            path: path.to_path_buf(),
        },
    })
}

/// Line and column of a field of a file, counted from 1, as far as it can be found again; nothing in a file of one line.
pub fn position_in(path: &Path, place: &str) -> Option<(usize, usize)> {
    let bytes = bytes(path).ok()?;
    let text = std::str::from_utf8(&bytes).ok()?;
    let byte = if is_json(&bytes, path) {
        position::in_json(&bytes, place)
    } else {
        position::in_toml(text, place)
    };
    let is_one_line = text.trim_end().lines().count() < 2;
    byte.filter(|_| !is_one_line)
        .map(|byte| line_and_column(text, byte))
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
            Self::Scene { .. }
                | Self::Run { .. }
                | Self::Broken { .. }
                | Self::NoReference(_)
                | Self::NoRecord { .. }
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

/// Why a text is refused.
struct Refused {
    position: Option<(usize, usize)>,
    place: Option<String>,
    fault: Fault,
}

impl Refused {
    /// What a deserialiser says of a field.
    fn of(message: &str, mut place: String, position: Option<(usize, usize)>) -> Self {
        let (field, message) = own_field(message);
        if let Some(field) = field {
            place = format!("{place}.{field}");
        }
        let fault = Fault::of(message, &place);
        // Of a choice that is not known the place is what makes it, and no field of that name.
        if let Fault::UnknownChoice { found, .. } = &fault
            && let Some(field) = place.strip_suffix(found.as_str())
            && let Some(field) = field.strip_suffix('.')
        {
            place = field.into();
        }
        Self {
            position,
            place: Some(place),
            fault,
        }
    }

    /// Bad syntax by the mistake that made it, if that is one of many people's.
    fn of_common_mistake(mut self, text: &[u8], is_json: bool) -> Self {
        let is_syntax = matches!(self.fault, Fault::Json(_) | Fault::Toml(_));
        let line = self.position.map_or(0, |(line, _)| line - 1);
        let text = String::from_utf8_lossy(text);
        let line = text.lines().nth(line).filter(|_| is_syntax);
        if let Some(fault) = line.and_then(|line| Fault::of_line(line, is_json)) {
            self.fault = fault;
        }
        self
    }

    /// At its field, where that is on another line than the one at which the parser noticed the fault.
    fn at_field(mut self, text: &str, find: impl Fn(&str) -> Option<usize>) -> Self {
        // A choice that is not known stands where the parser found it, behind its field.
        let field = match (&self.fault, &self.place) {
            (Fault::UnknownChoice { .. }, _) | (_, None) => None,
            (_, Some(place)) => find(place).map(|byte| line_and_column(text, byte)),
        };
        let is_new = |(line, _)| self.position.is_none_or(|(known, _)| known != line);
        self.position = field.filter(|field| is_new(*field)).or(self.position);
        self
    }
}

/// The field that a message of a whole table begins with, and the rest of it.
fn own_field(message: &str) -> (Option<&str>, &str) {
    let in_field = |letter: char| letter.is_ascii_alphanumeric() || "_.[]".contains(letter);
    match message.split_once(": ") {
        Some((field, rest)) if rest.starts_with("found ") && field.chars().all(in_field) => {
            (Some(field), rest)
        }
        _ => (None, message),
    }
}

fn json<T: DeserializeOwned>(text: &[u8]) -> Result<T, Refused> {
    let position = |error: &serde_json::Error| Some((error.line(), error.column()));
    // First as JSON of any form: the deserialiser of a type calls some fields of a wrong form bad syntax.
    serde_json::from_slice::<IgnoredAny>(text).map_err(|error| Refused {
        position: position(&error),
        place: None,
        fault: Fault::Json(without_position(&error)),
    })?;
    let mut reader = serde_json::Deserializer::from_slice(text);
    serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let place = named(error.path());
        let error = error.into_inner();
        let refused = Refused::of(&without_position(&error), place, position(&error));
        refused.at_field(&String::from_utf8_lossy(text), |place| {
            position::in_json(text, place)
        })
    })
}

fn toml<T: DeserializeOwned>(text: &[u8]) -> Result<T, Refused> {
    let position =
        |text: &str, error: &toml::de::Error| Some(line_and_column(text, error.span()?.start));
    let text = std::str::from_utf8(text).map_err(|error| Refused {
        position: None,
        place: None,
        fault: Fault::NotUtf8 {
            byte: error.valid_up_to(),
        },
    })?;
    let syntax = |error: toml::de::Error| Refused {
        position: position(text, &error),
        place: None,
        fault: Fault::Toml(one_line(error.message())),
    };
    let reader = toml::Deserializer::parse(text).map_err(syntax)?;
    serde_path_to_error::deserialize(reader).map_err(|error| {
        let place = named(error.path());
        let error = error.into_inner();
        let refused = Refused::of(&one_line(error.message()), place, position(text, &error));
        refused.at_field(text, |place| position::in_toml(text, place))
    })
}

/// The place in words.
fn named(path: &serde_path_to_error::Path) -> String {
    match path.to_string() {
        whole if whole == "." => "top level".into(),
        field => field,
    }
}

/// The message of an error of JSON, which ends with a position.
fn without_position(error: &serde_json::Error) -> String {
    let message = error.to_string();
    match message.rsplit_once(" at line ") {
        Some((message, _)) => message.into(),
        None => message,
    }
}

fn one_line(message: &str) -> String {
    message.lines().collect::<Vec<_>>().join(", ")
}

/// Line and column of a byte, counted from 1, the column in letters.
fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let column = before
        .chars()
        .rev()
        .take_while(|letter| *letter != '\n')
        .count()
        + 1;
    (line, column)
}
