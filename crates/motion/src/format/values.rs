//! Values in lines of any length: split at blanks, or cut at fixed columns if numbers touch.

use super::numbers::{Numbers, Values};
use crate::Refused;
use crate::line::{Line, number};

/// The values of the lines after a header, up to a line that does not begin with a number.
pub(super) fn read(header: Line<'_>, lines: &[Line<'_>]) -> Result<Numbers, Refused> {
    let is_value = |line: &Line<'_>| line.is_blank() || begins_with_number(*line);
    let n_lines = lines.iter().position(|line| !is_value(line));
    let lines = &lines[..n_lines.unwrap_or(lines.len())];
    of_lines(header, || lines.iter().copied().filter(|line| !line.is_blank()))
}

/// The values of these lines.
pub(super) fn of_lines<'t, I>(header: Line<'_>, filled: impl Fn() -> I) -> Result<Numbers, Refused>
where
    I: Iterator<Item = Line<'t>>,
{
    // Splitting at blanks fails if numbers touch, but the failure is visible: the pieces then have two points.
    let touching = filled().flat_map(Line::pieces).any(touches);
    let tail = if touching { common_tail(filled().map(tail)) } else { None };
    let mut values = Values::default();
    for line in filled() {
        let mut push = |(index, field)| values.push(line, line.finite(index + 1, field)?, field);
        match tail {
            Some(tail) => columns(line.bytes, tail).enumerate().try_for_each(&mut push)?,
            None => line.pieces().enumerate().try_for_each(&mut push)?,
        }
    }
    Ok(values.finish(header))
}

/// Whether a piece between blanks is several numbers.
pub(super) fn touches(piece: &[u8]) -> bool {
    points(piece).count() > 1
}

/// Whether a line continues the values: `*** End Data ***` does not; `NaN` does and is refused later.
fn begins_with_number(line: Line<'_>) -> bool {
    line.pieces().next().is_some_and(|piece| {
        let like_a_number = matches!(piece[0], b'0'..=b'9' | b'.' | b'+' | b'-');
        like_a_number && piece.iter().any(u8::is_ascii_digit) || number(piece).is_some()
    })
}

fn points(bytes: &[u8]) -> impl Iterator<Item = usize> {
    bytes.iter().enumerate().filter(|(_, byte)| **byte == b'.').map(|(index, _)| index)
}

/// Number of bytes from the decimal point to the end of a field, if it is equal for all lines.
///
/// Numbers touch only in fixed columns, where the point has one position in all fields: 12 bytes before the end in 5E15.7, 6 in 8F10.5.
/// Counting from the point instead of the start of the line also reads lines that lost their leading blanks.
fn common_tail(mut tails: impl Iterator<Item = Option<usize>>) -> Option<usize> {
    let first = tails.next()??;
    tails.all(|tail| tail == Some(first)).then_some(first)
}

/// Number of bytes from the last decimal point of a line to its end.
fn tail(line: Line<'_>) -> Option<usize> {
    let line = line.bytes.trim_ascii_end();
    points(line).last().map(|point| line.len() - point)
}

/// The fields of a line that each end `tail` bytes after the start of their decimal point.
fn columns(line: &[u8], tail: usize) -> impl Iterator<Item = &[u8]> {
    let line = line.trim_ascii_end();
    let mut start = 0;
    points(line).map(move |point| {
        // Two points closer than a field do not form a number; the field is then refused.
        let end = (point + tail).min(line.len()).max(start);
        let field = &line[start..end];
        start = end;
        field
    })
}
