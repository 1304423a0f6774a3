//! The reason why the values of a file end early: a damaged number, or another cause.

use super::File;
use crate::line::{excerpt, number};
use crate::refusals;
use crate::{FilePlace, Refused};
use pounding_text::{RefusalKind, Spot};

/// The error, or an error about the field at which the values stopped.
pub(super) fn located(error: Refused, file: &File<'_>) -> Refused {
    let Some(Spot::Line(last)) = error.place().spot.filter(|_| error.is_kind(RefusalKind::CutShort)) else {
        return error;
    };
    let mut behind = file.lines.iter().filter(|line| line.number > last && !line.is_blank());
    let Some(line) = behind.next() else {
        return error;
    };
    let is_bad = |piece: &&[u8]| number(piece).is_none_or(|value| !value.is_finite());
    let of_numbers = line.pieces().all(is_like_a_number);
    let bad = line.pieces().enumerate().find(|(_, piece)| is_bad(piece));
    match bad {
        Some((index, piece)) if of_numbers => refusals::not_a_number(line.number, index + 1, excerpt(piece)),
        _ => error.found_also(format!(" (line {} reads {:?})", line.number, line.excerpt())),
    }
}

/// Whether a line of numbers, sound or damaged, follows the last value.
pub(super) fn goes_on(file: &File<'_>, end: FilePlace) -> bool {
    let last = end.line().unwrap_or(usize::MAX);
    let mut behind = file.lines.iter().filter(|line| line.number > last && !line.is_blank());
    let next = behind.next();
    next.is_some_and(|line| line.pieces().all(is_like_a_number))
}

/// Whether a piece is a number or remains of one: digits with commas, the asterisks of Fortran, the words of programs for NaN.
fn is_like_a_number(piece: &[u8]) -> bool {
    let of_digits = |byte: &u8| byte.is_ascii_digit() || b".,+-*?#eEdD".contains(byte);
    let has_digit = piece.iter().any(|byte| byte.is_ascii_digit() || matches!(byte, b'*' | b'?' | b'#'));
    let words = [
        &b"NA"[..],
        b"N/A",
        b"NULL",
        b"NONE",
        b"#N/A",
        b"#NUM!",
        b"#VALUE!",
        b"#REF!",
        b"#DIV/0!",
    ];
    number(piece).is_some() || (has_digit && piece.iter().all(of_digits)) || words.iter().any(|word| word.eq_ignore_ascii_case(piece))
}
