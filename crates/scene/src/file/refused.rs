//! Why the words of a file make no value of a type: in the words of a file, where deserialisers name types of Rust.

use std::fmt::Display;

use serde::de::{Error, Expected, Unexpected};

use super::fault::Fault;

/// What a choice expects, for those that read one.
pub(super) const CHOICE: &str = "string or map";
/// A choice in the words of a file.
const ONE_CHOICE: &str = "the name of one, or a table with one of them and its settings";
/// The choice that is met most often.
const ONE_DAMPING: &str = "such as {\"ratio\": 0.05} in JSON, { ratio = 0.05 } in TOML";
/// What the exponent of a knee may be, where it is no whole number; the check of a scene holds the others to it.
const EXPONENT: &str = "a whole number from 1 to 20";

/// What is wrong with words, and at which place of them.
#[derive(Debug, thiserror::Error)]
#[error("{}: {fault}", self.place())]
pub struct Refused {
    /// Empty for the whole.
    place: String,
    /// What of the place is to blame.
    pub(super) blames: Blames,
    fault: Fault,
}

/// What of a place is to blame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Blames {
    /// The value that stands there.
    Value,
    /// The name of the field itself.
    Name,
    /// A field that a whole table names, and may not have.
    Field,
}

impl Refused {
    pub(super) fn new(place: String, fault: Fault) -> Self {
        let blames = Blames::Value;
        Self { place, blames, fault }
    }

    /// The same, seen from the table or list in which the value stands.
    pub(super) fn within(mut self, outer: &str) -> Self {
        if !self.place.is_empty() && !self.place.starts_with('[') {
            self.place.insert(0, '.');
        }
        self.place.insert_str(0, outer);
        self
    }

    /// Blames the name of a field.
    pub(super) fn at_name(mut self, name: &str) -> Self {
        self.blames = Blames::Name;
        self.within(name)
    }

    /// The way to what is to blame.
    pub(super) fn way(&self) -> &str {
        &self.place
    }

    /// The field, for example `structures[1].sdof.mass_kg`.
    pub fn place(&self) -> &str {
        // Of a choice that is not known the place is what makes it, and no field of that name.
        let makes = match (&self.fault, self.blames) {
            (Fault::UnknownChoice { found, .. }, Blames::Name) => self.place.strip_suffix(found.as_str()),
            _ => None,
        };
        let place = makes.map_or(self.place.as_str(), |makes| makes.trim_end_matches('.'));
        if place.is_empty() { "top level" } else { place }
    }

    /// What is wrong there.
    pub fn into_fault(mut self) -> Fault {
        if let Fault::Choice(one) = &mut self.fault
            && self.place.ends_with("damping")
        {
            *one = ONE_DAMPING;
        }
        if let Fault::Type { allowed, .. } = &mut self.fault
            && allowed == WHOLE
            && self.place.ends_with("bouc_wen.exponent")
        {
            *allowed = EXPONENT.into();
        }
        self.fault
    }
}

impl Error for Refused {
    /// Of a message that begins with a field of the table, the field is to blame.
    fn custom<T: Display>(message: T) -> Self {
        let message = message.to_string();
        let in_field = |letter: char| letter.is_ascii_alphanumeric() || "_.[]".contains(letter);
        if let Some((field, rest)) = message.split_once(": ")
            && rest.starts_with("found ")
            && field.chars().all(in_field)
        {
            let refused = Self::new(field.into(), Fault::Own(rest.into()));
            let blames = Blames::Field;
            return Self { blames, ..refused };
        }
        Self::new(String::new(), Fault::Own(message))
    }

    fn invalid_type(found: Unexpected<'_>, allowed: &dyn Expected) -> Self {
        let (found, allowed) = (in_words(found), allowed.to_string());
        // A table without a choice comes with the word of serde.
        let fault = if allowed == CHOICE || allowed == "enum" {
            Fault::Choice(ONE_CHOICE)
        } else {
            let allowed = allowed_in_words(&allowed);
            Fault::Type { found, allowed }
        };
        Self::new(String::new(), fault)
    }

    fn invalid_value(found: Unexpected<'_>, allowed: &dyn Expected) -> Self {
        Self::invalid_type(found, allowed)
    }

    fn invalid_length(length: usize, allowed: &dyn Expected) -> Self {
        let fault = Fault::Type {
            found: format!("a list of {length}"),
            allowed: allowed_in_words(&allowed.to_string()),
        };
        Self::new(String::new(), fault)
    }

    fn unknown_variant(found: &str, allowed: &'static [&'static str]) -> Self {
        let (found, allowed) = (found.into(), owned(allowed));
        Self::new(String::new(), Fault::UnknownChoice { found, allowed })
    }

    fn unknown_field(found: &str, allowed: &'static [&'static str]) -> Self {
        let fault = Fault::unknown_field(found.into(), owned(allowed));
        Self::new(String::new(), fault)
    }

    fn missing_field(field: &'static str) -> Self {
        Self::new(String::new(), Fault::Missing(field.into()))
    }

    fn duplicate_field(field: &'static str) -> Self {
        Self::new(String::new(), Fault::Twice(field.into()))
    }
}

fn owned(words: &[&str]) -> Vec<String> {
    words.iter().copied().map(String::from).collect()
}

/// What was found, in the words of a file.
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

/// What a type allows, in the words of a file.
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
