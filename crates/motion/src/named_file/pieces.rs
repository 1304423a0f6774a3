//! The pieces of a name and their ends.

use std::borrow::Cow;

/// The pieces of a name between its separators, each with its place.
pub(super) fn pieces(name: &str) -> impl Iterator<Item = (usize, &str)> {
    let separates = |letter: char| letter.is_ascii_punctuation() || letter == ' ';
    name.split(separates).scan(0, |next, piece| {
        let at = *next;
        *next += piece.len() + 1;
        Some((at, piece))
    })
}

/// A name without the marks of copies: ` (1)` and ` - Copy`.
pub(super) fn without_marks(name: &str) -> Cow<'_, str> {
    let (base, ending) = name.split_at(name.rfind('.').unwrap_or(name.len()));
    let kept = [unmarked(base), unmarked(ending)].concat();
    if kept == name { Cow::Borrowed(name) } else { Cow::Owned(kept) }
}

fn unmarked(part: &str) -> &str {
    let number = part.strip_suffix(')').map(uncounted);
    let kept = number.and_then(|part| part.strip_suffix('(')).or_else(|| {
        let part = uncounted(part).trim_end();
        let (at, last) = pieces(part).last()?;
        let copy = ["copy", "copie", "kopie", "copia"];
        let is_copy = copy.iter().any(|word| last.eq_ignore_ascii_case(word));
        is_copy.then(|| &part[..at])
    });
    match kept.map(|kept| kept.trim_end_matches([' ', '-', '_'])) {
        Some(kept) if !kept.is_empty() => unmarked(kept),
        _ => part,
    }
}

/// Whether another word begins at a position of a piece: after a digit, or between a small letter and a capital.
pub(super) fn is_parted(piece: &str, at: usize) -> bool {
    let ends = (piece[..at].chars().next_back(), piece[at..].chars().next());
    let (Some(before), Some(first)) = ends else {
        return false;
    };
    let is_case = before.is_alphabetic() && before.is_lowercase() != first.is_lowercase();
    first.is_alphabetic() && (before.is_ascii_digit() || is_case)
}

/// Whether a word is a number.
pub(super) fn is_number(word: &str) -> bool {
    !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_digit())
}

/// A text without digits at its end.
pub(super) fn uncounted(text: &str) -> &str {
    text.trim_end_matches(|letter: char| letter.is_ascii_digit())
}
