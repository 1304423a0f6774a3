//! What was read of a file, and where it stood.

use std::fmt;

/// A `Reading` is one thing that was read of a file, so that nothing is taken silently.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Name of the reading, such as `unit` or `time step`.
    pub what: &'static str,
    /// Line of the file, from 1; none in binary files and for what was declared or concluded.
    pub line: Option<usize>,
    /// What was found, with its unit.
    pub found: String,
}

/// A `Place` is where something stands in a file, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A line of a text.
    Line(usize),
    /// A byte of a binary file.
    Byte(usize),
}

impl Place {
    /// Returns the line; none in a binary file.
    pub fn line(self) -> Option<usize> {
        match self {
            Self::Line(line) => Some(line),
            Self::Byte(_) => None,
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(out, "line {line}"),
            Self::Byte(byte) => write!(out, "byte {byte}"),
        }
    }
}
