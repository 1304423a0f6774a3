//! What is wrong with a field of a file, in words.

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
    #[error("found a backslash in double quotes, where it begins an escape such as \\n, allowed is {0}")]
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
    #[error("found `{0}`, which a study has: a scene is one entry of its `scenes`, in a file of its own")]
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
    #[error("found `{found}`, allowed are {}{}", listed(allowed), meant(found, allowed))]
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
    /// What a type says of itself.
    #[error("{0}")]
    Own(String),
}

impl Fault {
    /// A field that is not known there, which may tell what the file is instead.
    pub(super) fn unknown_field(found: String, allowed: Vec<String>) -> Self {
        let allows = |field: &str| allowed.iter().any(|known| known == field);
        let (of_scene, of_sweep) = (allows("structures") && allows("contacts"), allows("vary"));
        match found.as_str() {
            "title" | "scenes" | "output" | "notes" if of_scene => Self::Study(found),
            "scene" | "vary" | "samples" | "directions" | "outputs" | "verdict" if of_scene => Self::Sweep(found),
            "name" | "duration_s" | "structures" | "contacts" | "arrivals_s" | "method" if of_sweep => Self::Scene(found),
            _ => Self::UnknownField { found, allowed },
        }
    }
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
        let is_digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        // Points may part thousands: `500.000,0`.
        parts.next().is_some_and(is_digits) && parts.all(|part| part.len() == 3 && is_digits(part))
    };
    let end = rest.find(|letter: char| !letter.is_ascii_digit());
    let part = &rest[..end.unwrap_or(rest.len())];
    (is_number(whole) && !part.is_empty()).then(|| format!("{whole},{part}"))
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
    let nearest = allowed.iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
    match nearest.filter(|word| likeness(word) > ALIKE) {
        Some(word) => format!("; perhaps `{word}` is meant"),
        None => String::new(),
    }
}
