//! Errors of content that fits no type, in the words of files instead of the names of Rust's types.

use std::fmt::Display;

use pounding_text::Refused;
use serde::de::{Error, Expected, Unexpected};

use super::fault;

/// Expectation of a choice.
pub(super) const CHOICE: &str = "string or map";
/// A choice, in the words of files.
const ONE_CHOICE: &str = "one, the name of one, or a table with one of them and its settings";
/// The most frequent choice.
const ONE_DAMPING: &str = "one, such as {\"ratio\": 0.05} in JSON, { ratio = 0.05 } in TOML";
/// Allowed exponents of a knee, for a value that is not a whole number; the check of a scene refuses others.
const EXPONENT: &str = "a whole number from 1 to 20";

/// An error, and its place in the file.
#[derive(Debug)]
pub(super) struct Unfit {
    /// Place of the error; empty for the whole file.
    way: String,
    /// The faulty part of the place.
    pub(super) blames: Blames,
    is: Is,
    refused: Refused,
}

/// Faulty part of a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Blames {
    /// The value.
    Value,
    /// The name of the field itself.
    Name,
    /// A field that the table must not have, named by the error of the table.
    Field,
}

/// Kind of the error, whose words may depend on the place.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Is {
    NoChoice,
    NotWhole,
    UnknownChoice,
    Other,
}

impl Unfit {
    fn new(is: Is, refused: Refused) -> Self {
        Self {
            way: String::new(),
            blames: Blames::Value,
            is,
            refused,
        }
    }

    /// Returns the error as seen from the table or list around the value.
    pub(super) fn within(mut self, outer: &str) -> Self {
        if !self.way.is_empty() && !self.way.starts_with('[') {
            self.way.insert(0, '.');
        }
        self.way.insert_str(0, outer);
        self
    }

    /// Blames the name of a field.
    pub(super) fn at_name(mut self, name: &str) -> Self {
        self.blames = Blames::Name;
        self.within(name)
    }

    /// Place of the faulty part.
    pub(super) fn way(&self) -> &str {
        &self.way
    }

    /// Converts the error to a refusal of the field, for example `structures[1].sdof.mass_kg`.
    pub(super) fn into_refused(self) -> Refused {
        let way = self.way;
        let refused = match self.is {
            Is::NoChoice if way.ends_with("damping") => self.refused.allowed_is(ONE_DAMPING),
            Is::NotWhole if way.ends_with("bouc_wen.exponent") => self.refused.allowed_is(EXPONENT),
            Is::NoChoice | Is::NotWhole | Is::UnknownChoice | Is::Other => self.refused,
        };
        // The place of an unknown choice is the field with the choice, not a field of that name.
        let makes = way.rfind('.').map_or("", |end| &way[..end]);
        let is_choice = self.is == Is::UnknownChoice && self.blames == Blames::Name;
        let field = if is_choice { makes.to_owned() } else { way };
        refused.in_field(if field.is_empty() { "top level".to_owned() } else { field })
    }
}

impl Display for Unfit {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{}: {}", self.way, self.refused)
    }
}

impl std::error::Error for Unfit {}

impl Error for Unfit {
    /// If a field of the table is refused, blame that field.
    fn custom<T: Display>(message: T) -> Self {
        let mut refused = Refused::handed(&message);
        let field = refused.place_mut().field.take();
        let new = Self::new(Is::Other, refused);
        match field {
            Some(field) => Self {
                way: field.path().to_owned(),
                blames: Blames::Field,
                ..new
            },
            None => new,
        }
    }

    fn invalid_type(found: Unexpected<'_>, allowed: &dyn Expected) -> Self {
        let (found, allowed) = (in_words(found), allowed.to_string());
        // serde has its own words for a table without a choice.
        if allowed == CHOICE || allowed == "enum" {
            return Self::new(Is::NoChoice, Refused::default().found("no choice").allowed_is(ONE_CHOICE));
        }
        let allowed = allowed_in_words(&allowed);
        let is = if allowed == WHOLE { Is::NotWhole } else { Is::Other };
        Self::new(is, Refused::default().found(found).allowed_is(allowed))
    }

    fn invalid_value(found: Unexpected<'_>, allowed: &dyn Expected) -> Self {
        Self::invalid_type(found, allowed)
    }

    fn invalid_length(length: usize, allowed: &dyn Expected) -> Self {
        let found = Refused::default().found(format!("a list of {length}"));
        Self::new(Is::Other, found.allowed_is(allowed_in_words(&allowed.to_string())))
    }

    fn unknown_variant(found: &str, allowed: &'static [&'static str]) -> Self {
        Self::new(Is::UnknownChoice, fault::unknown_choice(found, allowed))
    }

    fn unknown_field(found: &str, allowed: &'static [&'static str]) -> Self {
        Self::new(Is::Other, fault::unknown_field(found, allowed))
    }

    fn missing_field(field: &'static str) -> Self {
        let found = Refused::default().found(format!("no `{field}`, which must be there"));
        Self::new(Is::Other, found.help("add it"))
    }

    fn duplicate_field(field: &'static str) -> Self {
        let found = Refused::default().found(format!("`{field}` twice"));
        Self::new(Is::Other, found.allowed_is("once").help("delete one"))
    }
}

/// Describes a found value in the words of files.
fn in_words(found: Unexpected<'_>) -> String {
    let number = |digits: String| format!("the number {digits}");
    if let Unexpected::Float(found) = found {
        return number(format!("{found:?}"));
    }
    let rust = found.to_string();
    let value = rust.split('`').nth(1);
    match (rust.split(' ').next(), value) {
        (Some("integer"), Some(value)) => number(value.into()),
        (Some("boolean"), Some(value)) => value.into(),
        (Some("string"), _) => rust.replacen("string", "the text", 1),
        _ => allowed_in_words(&rust),
    }
}

const WHOLE: &str = "a whole number >= 0";

/// Describes what a type allows, in the words of files.
fn allowed_in_words(rust: &str) -> String {
    match rust {
        "f64" => "a number".into(),
        "u32" | "usize" | "u64" => WHOLE.into(),
        "a boolean" => "true or false".into(),
        "a string" => "a text".into(),
        "a sequence" | "sequence" => "a list".into(),
        "unit value" => "nothing (null)".into(),
        "a map" | "map" => "a table".into(),
        "unit" => "the word alone".into(),
        "an array of length 2" => "a list of two".into(),
        other if other.starts_with("struct ") => "a table of fields".into(),
        other => other.into(),
    }
}
