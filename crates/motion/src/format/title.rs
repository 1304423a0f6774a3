//! Elements that titles of many formats share: units, numbers after a word, keys.

use super::numbers::last_digit;
use super::{Peak, Stated};
use crate::line::{Line, number};
use crate::refusals;
use crate::{AccelerationUnit, FilePlace, Refused};

/// Units of an acceleration without a length over a time, in capitals.
const UNITS: [(&str, AccelerationUnit); 8] = {
    use AccelerationUnit::{CentimetrePerSecondSquared as Cm, MilliG, StandardGravity as G, TenthG};
    [
        ("G", G),
        ("G'S", G),
        ("GS", G),
        ("G/10", TenthG),
        ("G/10.", TenthG),
        ("MG", MilliG),
        ("GAL", Cm),
        ("GALS", Cm),
    ]
};

/// Lengths that form units of acceleration, in capitals.
const LENGTHS: [(&str, AccelerationUnit); 4] = [
    ("CM", AccelerationUnit::CentimetrePerSecondSquared),
    ("CMS", AccelerationUnit::CentimetrePerSecondSquared),
    ("M", AccelerationUnit::MetrePerSecondSquared),
    ("MM", AccelerationUnit::MillimetrePerSecondSquared),
];

/// The unit of an acceleration that a word spells: `g`, `gal`, `cm/s/s`, `M/SEC**2`, `m/seg/seg`.
pub(super) fn unit_of(word: &str) -> Option<AccelerationUnit> {
    let word = word.to_ascii_uppercase();
    let of = |table: &[(&str, AccelerationUnit)], name: &str| {
        let known = table.iter().find(|(known, _)| *known == name);
        known.map(|(_, unit)| *unit)
    };
    of(&UNITS, &word).or_else(|| {
        let (length, time) = word.split_once('/')?;
        let time = time.replace("SECS", "S").replace("SEC", "S").replace("SEG", "S");
        let is_square = matches!(time.as_str(), "S/S" | "S2" | "S^2" | "S**2" | "S²");
        of(&LENGTHS, length).filter(|_| is_square)
    })
}

/// The first unit of acceleration that is a separate word of a text, and this word.
pub(super) fn unit_in(text: &str) -> Option<(AccelerationUnit, &str)> {
    let separates = |letter: char| !(letter.is_ascii_alphanumeric() || matches!(letter, '/' | '\'' | '^' | '*' | '²'));
    text.split(separates).find_map(|word| Some((unit_of(word)?, word)))
}

/// The unit that a line states in a part of it, or a refusal.
pub(super) fn stated_unit(line: Line<'_>, text: &str) -> Result<Stated<AccelerationUnit>, Refused> {
    let place = FilePlace::Line(line.number);
    let (unit, word) = unit_in(text).ok_or_else(|| refusals::unknown_unit(place, line.excerpt()))?;
    Ok(Stated {
        value: unit,
        place,
        text: word.to_owned(),
    })
}

/// The first separate number of a text, as printed.
pub(super) fn first_number(text: &str) -> Option<&str> {
    let separates = |letter: char| letter.is_whitespace() || matches!(letter, '=' | ',' | ':' | '/');
    text.split(separates)
        .map(|word| word.trim_end_matches(|letter: char| !letter.is_ascii_digit() && letter != '.'))
        .find(|word| word.bytes().any(|byte| byte.is_ascii_digit()) && number(word.as_bytes()).is_some())
}

/// The text after a word, whatever its case.
pub(super) fn after<'t>(text: &'t str, word: &str) -> Option<&'t str> {
    let at = text.to_ascii_uppercase().find(word)?;
    text.get(at + word.len()..)
}

/// The text before a word, whatever its case; the whole text without the word.
pub(super) fn before<'t>(text: &'t str, word: &str) -> &'t str {
    let at = text.to_ascii_uppercase().find(word);
    at.and_then(|at| text.get(..at)).unwrap_or(text)
}

/// The first of these lines that contains a word, whatever its case.
pub(super) fn line_with<'t>(lines: &[Line<'t>], word: &str) -> Option<Line<'t>> {
    lines.iter().copied().find(|line| holds(*line, word))
}

/// Whether a line contains a word, given in capitals.
pub(super) fn holds(line: Line<'_>, word: &str) -> bool {
    line.head()
        .windows(word.len())
        .any(|window| window.eq_ignore_ascii_case(word.as_bytes()))
}

/// The text after a key in a header, such as ` cm/s^2` after `UNITS:`.
pub(super) fn value_of<'t>(lines: &[Line<'t>], key: &str) -> Option<(Line<'t>, String)> {
    let line = lines.iter().copied().find(|line| {
        line.head()
            .get(..key.len())
            .is_some_and(|start| start.eq_ignore_ascii_case(key.as_bytes()))
    })?;
    let value = String::from_utf8_lossy(&line.head()[key.len()..]);
    Some((line, value.trim().to_owned()))
}

/// A required line, or a refusal with the values allowed.
pub(super) fn needed<T>(found: Option<T>, last: Option<Line<'_>>, allowed: &'static str) -> Result<T, Refused> {
    found.ok_or_else(|| refusals::truncated(FilePlace::Line(last.map_or(1, |line| line.number)), allowed))
}

/// A number of a line, as a count above zero.
pub(super) fn count(line: Line<'_>, text: &str) -> Result<Stated<usize>, Refused> {
    let place = FilePlace::Line(line.number);
    let value = text.trim().parse().ok().filter(|count| *count > 0);
    let value = value.ok_or_else(|| refusals::header(place, line.excerpt(), "a whole number of samples above 0"))?;
    Ok(Stated {
        value,
        place,
        text: line.excerpt(),
    })
}

/// A time step \[s\] of a line, above zero.
pub(super) fn time_step(line: Line<'_>, value: Option<f64>) -> Result<Stated<f64>, Refused> {
    let place = FilePlace::Line(line.number);
    let value = value.ok_or_else(|| refusals::header(place, line.excerpt(), "a time step"))?;
    if !(value.is_finite() && value > 0.0) {
        return Err(refusals::time_step(place, value));
    }
    Ok(Stated {
        value,
        place,
        text: line.excerpt(),
    })
}

/// The peak that a piece of a line states as its first number, before the time after `AT`.
pub(super) fn peak(line: Line<'_>, text: &str) -> Option<Peak> {
    let text = before(text, " AT ");
    let printed = first_number(text)?;
    Some(Peak {
        stated: Stated {
            value: number(printed.as_bytes()).filter(|value| value.is_finite())?,
            place: FilePlace::Line(line.number),
            text: line.excerpt(),
        },
        digit: last_digit(printed.as_bytes()),
        unit: unit_in(text).map(|(unit, _)| unit),
    })
}

/// Titles as one text, one per line, without blank lines and outer blanks.
pub(super) fn provenance(lines: &[Line<'_>]) -> String {
    let lines: Vec<String> = lines
        .iter()
        .filter(|line| !line.is_blank())
        .map(|line| line.text().trim().to_owned())
        .collect();
    lines.join("\n")
}

/// The words of a text with single blanks in between.
pub(super) fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
