//! The values: split on blanks where that works, and cut at fixed columns where numbers touch.

use crate::ReadError;
use crate::line::{Line, number};

/// The values of the lines after the header, and the number of the line that holds the last of
/// them.
pub(super) fn read(header: Line<'_>, lines: &[Line<'_>]) -> Result<(Vec<f64>, usize), ReadError> {
    let filled = lines.iter().filter(|line| !line.is_blank());
    let lines: Vec<Line<'_>> = filled
        .copied()
        .take_while(|line| begins_with_number(*line))
        .collect();
    // Blanks lose data where numbers touch, but nothing is lost unseen: the pieces then have two
    // points.
    let touching = lines
        .iter()
        .flat_map(|line| pieces(line.bytes))
        .any(|piece| points(piece).count() > 1);
    let tail = if touching { common_tail(&lines) } else { None };

    let mut values = Vec::new();
    for line in &lines {
        let fields = tail.map_or_else(
            || pieces(line.bytes).collect(),
            |tail| columns(line.bytes, tail),
        );
        for (index, field) in fields.into_iter().enumerate() {
            values.push(line.finite(index + 1, field)?);
        }
    }
    let last_line = lines.last().map_or(header.number, |line| line.number);
    Ok((values, last_line))
}

/// Whether a line goes on with the values; `*** End Data ***` does not, `NaN` does and is refused
/// later.
fn begins_with_number(line: Line<'_>) -> bool {
    pieces(line.bytes).next().is_some_and(|piece| {
        let like_a_number = matches!(piece[0], b'0'..=b'9' | b'.' | b'+' | b'-');
        like_a_number && piece.iter().any(u8::is_ascii_digit) || number(piece).is_some()
    })
}

fn pieces(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace)
        .filter(|piece| !piece.is_empty())
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
