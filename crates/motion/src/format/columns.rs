//! Numbers in fixed columns, as Fortran writes them.
//!
//! Such numbers may touch, so lines are cut by bytes and never split at blanks.

use crate::refusals;
use pounding_text::Spot;
use std::fmt;

use super::numbers::{Numbers, Values, is_mark};
use crate::Refused;
use crate::line::{Line, excerpt, number};

/// Largest number of fields in a line, and of bytes in a field, in a format.
const WIDEST: usize = 1000;

/// A Fortran format of equal fields, such as 8F10.5: eight to a line, each ten bytes wide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FixedColumns {
    pub(super) per_line: usize,
    /// Number of blanks before the first number.
    lead: usize,
    width: usize,
    /// Whether the numbers are whole, without a point.
    whole: bool,
}

impl fmt::Display for FixedColumns {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} to a line, {} bytes each", self.per_line, self.width)
    }
}

impl FixedColumns {
    pub(super) const fn new(per_line: usize, width: usize) -> Self {
        Self {
            per_line,
            lead: 0,
            width,
            whole: false,
        }
    }

    /// The format after the leading blanks of this line, whose last number ends at the end of the line.
    pub(super) fn led_in_by(self, line: Line<'_>) -> Self {
        let length = line.bytes.trim_ascii_end().len();
        let lead = length % self.width;
        let is_blank = line.bytes[..lead.min(length)].trim_ascii().is_empty();
        Self {
            lead: if is_blank { lead } else { 0 },
            ..self
        }
    }

    /// The last format in brackets in a line, such as `(8F10.5)` or `(1P6E13.6)`.
    pub(super) fn named_in(line: Line<'_>) -> Option<Self> {
        let text = line.text().to_ascii_uppercase();
        let mut brackets = text.rsplit('(').filter_map(|part| part.split_once(')'));
        brackets.find_map(|(inside, _)| Self::parse(inside))
    }

    /// Reads `8F10.5`, `10I8` or `1P,5E15.7`.
    fn parse(format: &str) -> Option<Self> {
        let compact: String = format.chars().filter(|letter| *letter != ' ').collect();
        let format = match compact.split_once('P') {
            Some((_, format)) => format.trim_start_matches(','),
            None => &compact,
        };
        let letter = format.find(['F', 'E', 'D', 'G', 'I'])?;
        let (per_line, field) = format.split_at(letter);
        let width: String = field[1..].chars().take_while(char::is_ascii_digit).collect();
        let per_line = if per_line.is_empty() { "1" } else { per_line };
        let columns = Self {
            lead: 0,
            per_line: per_line.parse().ok()?,
            width: width.parse().ok()?,
            whole: field.starts_with('I'),
        };
        let is_sane = |number: usize| (1..=WIDEST).contains(&number);
        (is_sane(columns.per_line) && is_sane(columns.width)).then_some(columns)
    }

    /// Number of lines that hold `count` numbers.
    pub(super) fn lines_of(self, count: usize) -> usize {
        count.div_ceil(self.per_line)
    }

    /// The fields of a line up to its last that is not blank.
    pub(super) fn fields(self, line: Line<'_>) -> impl Iterator<Item = &[u8]> {
        let numbers = line.bytes.trim_ascii_end().get(self.lead..);
        numbers.unwrap_or_default().chunks(self.width).take(self.per_line)
    }

    /// The numbers of these lines. Values in `missing` are marks of missing values and are refused.
    pub(super) fn numbers(self, header: Line<'_>, lines: &[Line<'_>], missing: &[f64]) -> Result<Numbers, Refused> {
        let mut values = Values::default();
        for line in lines {
            for (index, field) in self.fields(*line).enumerate() {
                let value = if self.whole {
                    line.finite(index + 1, field)?
                } else {
                    decimal(*line, index + 1, field)?
                };
                check_present(*line, index + 1, field, missing)?;
                values.push(*line, value, field)?;
            }
        }
        Ok(values.finish(header))
    }

    /// Numbers of a header, whole or with a point; a field without a number is `None`.
    pub(super) fn header(self, lines: &[Line<'_>]) -> Vec<Option<f64>> {
        let fields = lines.iter().flat_map(|line| self.fields(*line));
        fields.map(number).collect()
    }
}

/// A number with a point. Fortran would put a missing point somewhere, and a field that was cut at the wrong column often lacks one.
pub(super) fn decimal(line: Line<'_>, field: usize, bytes: &[u8]) -> Result<f64, Refused> {
    let value = line.finite(field, bytes)?;
    if bytes.contains(&b'.') {
        return Ok(value);
    }
    Err(refusals::not_a_number(line.number, field, excerpt(bytes)))
}

/// Refuses a mark of a missing value.
fn check_present(line: Line<'_>, field: usize, bytes: &[u8], missing: &[f64]) -> Result<(), Refused> {
    let value = number(bytes);
    if value.is_some_and(|value| missing.iter().any(|mark| is_mark(value, *mark))) {
        return Err(Refused::at(Spot::Field(line.number, field))
            .is("")
            .quoted(excerpt(bytes))
            .and(" marks a missing value")
            .help("cut the record before it or take another"));
    }
    Ok(())
}

/// The leading lines that contain only numbers.
pub(super) fn leading_data<'l, 't>(lines: &'l [Line<'t>]) -> &'l [Line<'t>] {
    let end = lines.iter().position(|line| !is_data(*line));
    &lines[..end.unwrap_or(lines.len())]
}

fn is_data(line: Line<'_>) -> bool {
    let of_numbers = |byte: &u8| {
        byte.is_ascii_digit() || matches!(byte, b' ' | b'\t' | b'+' | b'-' | b'.' | b'*' | b',')
            // NaN, Inf and decimal commas are refused as numbers and do not end the data.
            || b"EeDdNnAaIiFf".contains(byte)
    };
    !line.is_blank()
        && line.bytes.iter().any(|byte| matches!(byte, b'.' | b'*') || byte.is_ascii_digit())
        && line.bytes.iter().all(of_numbers)
}
