//! What can go wrong with rows of numbers.

use super::words::{columns, of_number, reading, rows};
use crate::Place;

/// A `RowError` says why a row of numbers was not read.
///
/// Lines, fields and columns are counted from 1. `found` is the start of the offending text.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RowError {
    /// A line of a CSV does not have one time and one acceleration.
    #[error(
        "line {line} has {found} field(s), allowed are 2, the time and the acceleration; \
         write one sample to a line, with a comma between"
    )]
    FieldCount {
        /// Line of the sample.
        line: usize,
        /// Fields in that line.
        found: usize,
    },
    /// A field is not a number.
    #[error("line {line}, field {field}: {found:?} is not a number; {}", of_number(found))]
    NotANumber {
        /// Line of the field.
        line: usize,
        /// Which field of the line.
        field: usize,
        /// What the field holds.
        found: String,
    },
    /// A field is NaN or infinite, or a number too large for 64 bits.
    #[error(
        "line {line}, field {field}: {found:?} is not finite, and every number must be; \
         put a measured value there or cut the record before it"
    )]
    NotFinite {
        /// Line of the field.
        line: usize,
        /// Which field of the line.
        field: usize,
        /// What the field holds.
        found: String,
    },
    /// Numbers stand above the rows that are none of them.
    #[error(
        "{} {found:?}: {what}, unlike the values below; delete {}, or put # before each line",
        reading(*lines),
        if lines[0] == lines[1] { "it" } else { "them" }
    )]
    HeaderNumbers {
        /// First and last line.
        lines: [usize; 2],
        /// What they read.
        found: String,
        /// What they seem to be.
        what: &'static str,
    },
    /// Rows hold several numbers without names, or names and rows do not go together.
    #[error("line {line} has {found} numbers: {reason}; {}", rows(*found))]
    Rows {
        /// First line of numbers.
        line: usize,
        /// Numbers in it.
        found: usize,
        /// Why they are not read.
        reason: &'static str,
    },
    /// Values are declared to follow one another in rows, where the file has columns.
    #[error("{place} reads {found:?}: the numbers stand in columns, but `in_rows` is declared; leave the declaration away")]
    NotInRows {
        /// Where the file says so.
        place: Place,
        /// What it says.
        found: String,
    },
    /// A comma may be a decimal comma or part two numbers.
    #[error(
        "line {line} reads {found:?}: its comma may be a decimal comma, or separate two whole numbers; write decimal points, or \
         semicolons between numbers with decimal commas"
    )]
    DecimalComma {
        /// The line.
        line: usize,
        /// What it reads.
        found: String,
    },
    /// A line of plain text has more or fewer columns than can be read.
    #[error(
        "line {line} has {found} column(s), allowed are {}",
        columns(*allowed)
    )]
    PlainColumns {
        /// Line of the numbers.
        line: usize,
        /// Columns in that line.
        found: usize,
        /// Columns of the first line of numbers, where it can be read.
        allowed: Option<usize>,
    },
    /// A row of a table has more or fewer fields than the format has.
    #[error("line {line} has {found} field(s), allowed are {allowed}; fetch the file again")]
    RowFields {
        /// Line of the row.
        line: usize,
        /// Fields in that line.
        found: usize,
        /// Fields of the format.
        allowed: usize,
    },
    /// A number of values stands above them like one of them.
    #[error(
        "line {line} reads {found:?}, which is how many values follow; \
         put # before it, or it would be taken for the first"
    )]
    CountAsValue {
        /// Line of the number.
        line: usize,
        /// What it reads.
        found: String,
    },
    /// A value is the mark that the format keeps for one that is missing.
    #[error("line {line}, field {field}: {found:?} marks a missing value; cut the record before it or take another")]
    Missing {
        /// Line of the field.
        line: usize,
        /// Which field of the line.
        field: usize,
        /// What the field holds.
        found: String,
    },
}
