//! Place and time of a recording, from the header of each format.

use super::stamp::{Stamp, normal};
use super::title::{self, words};
use crate::line::Line;

/// The text in capitals with single blanks between words; `None` if it is empty.
pub(super) fn text(said: &str) -> Option<String> {
    let said = words(said).to_ascii_uppercase();
    (!said.is_empty()).then_some(said)
}

/// The time in one spelling; `None` if it is empty.
pub(super) fn time(said: &str) -> Option<String> {
    Some(normal(said)).filter(|time| !time.is_empty())
}

/// Text after a key at the start of a line, and after its colon if there is one.
pub(super) fn behind(lines: &[Line<'_>], key: &str) -> Option<String> {
    let (_, value) = title::value_of(lines, key)?;
    let value = value.trim_start_matches([' ', ':', '=', '\t']);
    (!value.is_empty()).then(|| value.to_owned())
}

/// The first word with a digit after a key anywhere in a line, such as the number of a station.
pub(super) fn numbered(lines: &[Line<'_>], key: &str) -> Option<String> {
    let line = title::line_with(lines, key)?;
    let text = line.text();
    let behind = title::after(&text, key)?;
    let has_digit = |word: &&str| word.bytes().any(|byte| byte.is_ascii_digit());
    let word = behind.split_whitespace().find(has_digit)?;
    Some(word.trim_matches([',', ';', ':']).to_ascii_uppercase())
}

/// The first date with a time of day in a text, in one spelling.
pub(super) fn first_time(said: &str) -> Option<String> {
    let words: Vec<&str> = said.split_whitespace().collect();
    let pairs = words.windows(2).map(|pair| pair.join(" "));
    let all = words.iter().map(|word| (*word).to_owned()).chain(pairs);
    all.map(|text| text.trim_matches([',', ';']).replace(',', ""))
        .find_map(|text| Some(Stamp::new(&text)?.to_string()))
}
