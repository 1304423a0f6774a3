//! Values read from a file, with their places.

use std::fmt;

/// A `Reading` is one value read from a file, so that every value can be traced.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Name of the reading, such as `unit` or `time step`.
    pub what: &'static str,
    /// Line of the file, from 1; `None` in binary files, and for declared or derived values.
    pub line: Option<usize>,
    /// The value with its unit.
    pub found: String,
}

/// A `FilePlace` is a position in a file, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilePlace {
    /// A line of a text.
    Line(usize),
    /// A byte of a binary file.
    Byte(usize),
}

impl FilePlace {
    /// Returns the line; `None` in a binary file.
    pub fn line(self) -> Option<usize> {
        match self {
            Self::Line(line) => Some(line),
            Self::Byte(_) => None,
        }
    }
}

impl fmt::Display for FilePlace {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(out, "line {line}"),
            Self::Byte(byte) => write!(out, "byte {byte}"),
        }
    }
}
