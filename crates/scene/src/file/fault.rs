//! What is wrong with a field of a file, in words: the deserialisers' messages name types of Rust.

use std::path::PathBuf;

/// What is wrong with a file or one of its fields.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// Text that is not JSON, with what its parser says.
    #[error("not JSON: {0}")]
    Json(String),
    /// Text that is not TOML, with what its parser says.
    #[error("not TOML: {0}")]
    Toml(String),
    /// A number with a decimal comma.
    #[error("found `{found}` with a decimal comma, allowed is a decimal point: `{}`", found.replace('.', "").replace(',', "."))]
    DecimalComma {
        /// The number.
        found: String,
    },
    /// A backslash that stands for itself, in double quotes.
    #[error(
        "found a backslash in double quotes, where it begins an escape such as \\n, allowed is {0}"
    )]
    Backslash(&'static str),
    /// Bytes that are not UTF-8.
    #[error("the text is not UTF-8 from byte {byte} on; save it as UTF-8")]
    NotUtf8 {
        /// Bytes before the fault.
        byte: usize,
    },
    /// A record where a scene is asked for.
    #[error(
        "found a record ({format}), allowed is a scene, a TOML or JSON file; `pounding init --record {}` writes one that it shakes",
        path.display()
    )]
    Record {
        /// Name of its format.
        format: &'static str,
        /// The file.
        path: PathBuf,
    },
    /// A file of a study where a scene is asked for.
    #[error(
        "found `{0}`, which a study has: a scene is one entry of its `scenes`, in a file of its own"
    )]
    Study(String),
    /// A sweep where a scene is asked for.
    #[error("found `{0}`, which a sweep has, allowed is a scene; `pounding sweep` runs a sweep")]
    Sweep(String),
    /// A scene where a sweep is asked for.
    #[error(
        "found `{0}`, which a scene has, allowed is a sweep, which names a scene in `scene` and what varies in `vary`; `pounding run` runs a scene alone"
    )]
    Scene(String),
    /// A field that is not known.
    #[error(
        "found the field `{found}`, allowed are {}{}",
        if allowed.is_empty() { "none; delete it".into() } else { listed(allowed) },
        meant(found, allowed)
    )]
    UnknownField {
        /// The field.
        found: String,
        /// Fields known there.
        allowed: Vec<String>,
    },
    /// A choice that is not known.
    #[error(
        "found `{found}`, allowed are {}{}",
        listed(allowed),
        meant(found, allowed)
    )]
    UnknownChoice {
        /// What was chosen.
        found: String,
        /// Choices known there.
        allowed: Vec<String>,
    },
    /// A field that must be there.
    #[error("found no `{0}`, which must be there; add it")]
    Missing(String),
    /// A field that is there twice.
    #[error("found `{0}` twice, allowed is once; delete one")]
    Twice(String),
    /// A value of another type.
    #[error("found {found}, allowed is {allowed}")]
    Type {
        /// What was found, in words.
        found: String,
        /// What is allowed, in words.
        allowed: String,
    },
    /// A number beyond all numbers of 64 bits.
    #[error("found a number beyond 1.8e308, allowed are smaller ones")]
    Beyond,
    /// No choice where one must be made, or what is none.
    #[error("found no choice, allowed is one, {0}")]
    Choice(&'static str),
    /// Two choices where one must be made, such as two contact laws for one contact.
    #[error("found both `{}` and `{}`, allowed is one of them; delete the other", .0[0], .0[1])]
    TwoChoices([String; 2]),
    /// What a type says of itself.
    #[error("{0}")]
    Own(String),
}

/// Begins what is said of two choices, which stand between backticks behind it.
pub(crate) const TWO_CHOICES: &str = "two choices ";
/// A choice in the words of a file.
const ONE_CHOICE: &str = "the name of one, or a table with one of them and its settings";
/// What the exponent of a knee may be, where it is no whole number; the check of a scene holds the others to it.
const EXPONENT: &str = "a whole number from 1 to 20";
/// The choice that is met most often.
const ONE_DAMPING: &str = "such as {\"ratio\": 0.05} in JSON, { ratio = 0.05 } in TOML";

impl Fault {
    /// A field that is not known there, which may tell what the file is instead.
    fn unknown_field(found: String, allowed: Vec<String>) -> Self {
        let allows = |field: &str| allowed.iter().any(|known| known == field);
        let (of_scene, of_sweep) = (allows("structures") && allows("contacts"), allows("vary"));
        match found.as_str() {
            "title" | "scenes" | "output" | "notes" if of_scene => Self::Study(found),
            "scene" | "vary" | "samples" | "directions" | "outputs" | "verdict" if of_scene => {
                Self::Sweep(found)
            }
            "name" | "duration_s" | "structures" | "contacts" | "arrivals_s" | "method"
                if of_sweep =>
            {
                Self::Scene(found)
            }
            _ => Self::UnknownField { found, allowed },
        }
    }

    /// What a deserialiser says of a field.
    pub(crate) fn of(message: &str, place: &str) -> Self {
        let known = |allowed: &str| quoted(allowed);
        if let Some((found, allowed)) = message
            .strip_prefix("unknown field ")
            .and_then(|rest| rest.split_once(", "))
        {
            let found = quoted(found).concat();
            return Self::unknown_field(found, known(allowed));
        }
        if let Some((found, allowed)) = message
            .strip_prefix("unknown variant ")
            .and_then(|rest| rest.split_once(", "))
        {
            let (found, allowed) = (quoted(found).concat(), known(allowed));
            return Self::UnknownChoice { found, allowed };
        }
        if let Some(field) = message.strip_prefix("missing field ") {
            return Self::Missing(quoted(field).concat());
        }
        if let Some(field) = message.strip_prefix("duplicate field ") {
            return Self::Twice(quoted(field).concat());
        }
        if message == "number out of range" {
            return Self::Beyond;
        }
        if let Some(both) = message.strip_prefix(TWO_CHOICES)
            && let Ok(both) = quoted(both).try_into()
        {
            return Self::TwoChoices(both);
        }
        if is_choice(message) {
            return Self::Choice(if place.ends_with("damping") {
                ONE_DAMPING
            } else {
                ONE_CHOICE
            });
        }
        for begin in ["invalid type: ", "invalid value: ", "invalid length "] {
            let rest = message.strip_prefix(begin);
            if let Some((found, allowed)) = rest.and_then(|rest| rest.split_once(", expected ")) {
                let allowed = match allowed {
                    "u32" if place.ends_with("bouc_wen.exponent") => EXPONENT.into(),
                    allowed => in_words(allowed),
                };
                return Self::Type {
                    found: in_words(found),
                    allowed,
                };
            }
        }
        Self::Own(message.into())
    }
}

/// Whether a message says of an enum that it is neither a word nor a table with one key.
fn is_choice(message: &str) -> bool {
    message.starts_with("expected value")
        || message.starts_with("wanted string or table")
        || message.starts_with("wanted string or inline table")
        || message == "invalid type: map, expected enum"
        || (message.starts_with("invalid type: ") && message.ends_with("expected string or map"))
}

/// What may be written in place of a backslash.
pub(crate) const FOR_A_BACKSLASH: [&str; 2] = [
    "/ in its place, or single quotes: 'records\\quake.csv'",
    "/ in its place, or two of them",
];

impl Fault {
    /// What is wrong with a line that is no TOML or no JSON, if it is a mistake that many make.
    pub(crate) fn of_line(line: &str, is_json: bool) -> Option<Self> {
        let assigns = if is_json { ':' } else { '=' };
        let mut values = line.split(assigns).skip(1).map(str::trim_start);
        if let Some(number) = values.find_map(decimal_comma) {
            return Some(Self::DecimalComma { found: number });
        }
        let is_quoted = line.find('\\') > line.find('"') && line.contains('"');
        is_quoted.then_some(Self::Backslash(FOR_A_BACKSLASH[usize::from(is_json)]))
    }
}

/// The number with a decimal comma that a text begins with.
fn decimal_comma(text: &str) -> Option<String> {
    let (whole, rest) = text.split_once(',')?;
    let is_number = |text: &str| {
        let digits = text.trim_start_matches(['+', '-']);
        let mut parts = digits.split('.');
        let is_digits =
            |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        // Points may part thousands: `500.000,0`.
        parts.next().is_some_and(is_digits) && parts.all(|part| part.len() == 3 && is_digits(part))
    };
    let end = rest.find(|letter: char| !letter.is_ascii_digit());
    let part = &rest[..end.unwrap_or(rest.len())];
    (is_number(whole) && !part.is_empty()).then(|| format!("{whole},{part}"))
}

/// What stands between backticks.
fn quoted(text: &str) -> Vec<String> {
    text.split('`')
        .skip(1)
        .step_by(2)
        .map(String::from)
        .collect()
}

/// Digits of a number that is repeated as it stands.
const MOST_DIGITS: usize = 20;

/// Types of Rust in the words of a file.
fn in_words(text: &str) -> String {
    for (rust, words) in [
        ("floating point ", "the number "),
        ("integer ", "the number "),
        ("boolean ", ""),
        ("string ", "the text "),
    ] {
        if let Some(value) = text.strip_prefix(rust) {
            // Wide integers have their type behind them.
            let value = value.split('`').nth(1).unwrap_or(value);
            return match value.parse() {
                // Some hundred digits tell no more than a few.
                Ok(number) if value.len() > MOST_DIGITS => {
                    format!("{words}{}", pounding_text::plain(number))
                }
                _ => format!("{words}{value}"),
            };
        }
    }
    match text {
        "f64" => "a number".into(),
        "u32" | "usize" | "u64" => "a whole number >= 0".into(),
        "a boolean" => "true or false".into(),
        "a string" => "a text".into(),
        "a sequence" | "sequence" => "a list".into(),
        "map" | "a map" => "a table".into(),
        "unit" => "the word alone".into(),
        "null" | "unit value" => "nothing (null)".into(),
        "an array of length 2" => "a list of two".into(),
        "0" | "1" | "3" => format!("a list of {text}"),
        other => match other.strip_prefix("struct ") {
            Some(_) => "a table of fields".into(),
            None => other.into(),
        },
    }
}

fn listed(words: &[String]) -> String {
    let words: Vec<_> = words.iter().map(|word| format!("`{word}`")).collect();
    words.join(", ")
}

/// Likeness from which on a word is taken for another one misspelt.
const ALIKE: f64 = 0.8;

/// The word that was meant, where one is near.
fn meant(found: &str, allowed: &[String]) -> String {
    let likeness = |word: &String| strsim::jaro_winkler(found, word);
    let nearest = allowed
        .iter()
        .max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
    match nearest.filter(|word| likeness(word) > ALIKE) {
        Some(word) => format!("; perhaps `{word}` is meant"),
        None => String::new(),
    }
}
