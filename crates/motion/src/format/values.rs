//! Values that stand in lines of any number: split on blanks where that works, and cut at fixed columns where numbers touch.

use super::columns::{Largest, Numbers};
use crate::line::{Line, number};
use crate::{Place, ReadError};

/// The values of the lines after a header, up to one that does not begin with a number.
pub(super) fn read(header: Line<'_>, lines: &[Line<'_>]) -> Result<Numbers, ReadError> {
    let filled = lines.iter().filter(|line| !line.is_blank());
    let lines: Vec<Line<'_>> = filled
        .copied()
        .take_while(|line| begins_with_number(*line))
        .collect();
    // Blanks lose data where numbers touch, but nothing is lost unseen: the pieces then have two
    // points.
    let touching = lines
        .iter()
        .flat_map(|line| line.pieces())
        .any(|piece| points(piece).count() > 1);
    let tail = if touching { common_tail(&lines) } else { None };

    let mut values = Vec::new();
    let mut largest = Largest::default();
    for line in &lines {
        let fields = tail.map_or_else(|| line.pieces().collect(), |tail| columns(line.bytes, tail));
        for (index, field) in fields.into_iter().enumerate() {
            let value = line.finite(index + 1, field)?;
            largest.see(value, field);
            values.push(value);
        }
    }
    let last_line = lines.last().map_or(header.number, |line| line.number);
    Ok(Numbers {
        values,
        end: Place::Line(last_line),
        digit: largest.digit(),
    })
}

/// Whether a line goes on with the values; `*** End Data ***` does not, `NaN` does and is refused
/// later.
fn begins_with_number(line: Line<'_>) -> bool {
    line.pieces().next().is_some_and(|piece| {
        let like_a_number = matches!(piece[0], b'0'..=b'9' | b'.' | b'+' | b'-');
        like_a_number && piece.iter().any(u8::is_ascii_digit) || number(piece).is_some()
    })
}

fn points(bytes: &[u8]) -> impl Iterator<Item = usize> {
    bytes
        .iter()
        .enumerate()
        .filter(|(_, byte)| **byte == b'.')
        .map(|(index, _)| index)
}

/// Bytes from the decimal point to the end of a field, if all lines end alike.
///
/// Numbers touch only in fixed columns, where the point has one place in all fields: 12 bytes
/// before the end in 5E15.7, 6 in 8F10.5. Counting from the point and not from the start of the
/// line, also lines whose leading blanks were lost are read.
fn common_tail(lines: &[Line<'_>]) -> Option<usize> {
    let mut tails = lines.iter().map(|line| {
        let line = line.bytes.trim_ascii_end();
        points(line).last().map(|point| line.len() - point)
    });
    let first = tails.next()??;
    tails.all(|tail| tail == Some(first)).then_some(first)
}

/// The fields of a line that each end `tail` bytes after the start of their decimal point.
fn columns(line: &[u8], tail: usize) -> Vec<&[u8]> {
    let line = line.trim_ascii_end();
    let mut fields = Vec::new();
    let mut start = 0;
    for point in points(line) {
        // Two points closer than a field are no number; the field then says so.
        let end = (point + tail).min(line.len()).max(start);
        fields.push(&line[start..end]);
        start = end;
    }
    fields
}
