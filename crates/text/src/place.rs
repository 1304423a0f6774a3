//! Places of faults.

use std::path::{Path, PathBuf};

use crate::{Knob, Naming};

/// The place of a fault: file, spot in the file, scene and field. Each may be absent.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FaultPlace {
    /// The file.
    pub file: Option<PathBuf>,
    /// The spot in the file.
    pub spot: Option<Spot>,
    /// Name of the scene.
    pub scene: Option<String>,
    /// The field, for example `structures[1].sdof.mass_kg`.
    pub field: Option<Knob>,
}

/// A spot in a file, counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spot {
    /// A letter of a line: line and column.
    Letter(usize, usize),
    /// A line.
    Line(usize),
    /// Lines: the first and the last.
    Lines(usize, usize),
    /// A field of a line of numbers: line and field.
    Field(usize, usize),
    /// A byte.
    Byte(usize),
}

impl FaultPlace {
    /// The place in words, one part after the other; empty if nothing is known.
    pub(crate) fn words(&self, naming: Naming) -> String {
        let file = self.file.as_ref().map(|file| file.display().to_string());
        let spot = self.spot.map(|spot| spot.to_string());
        let begin = match (file, spot) {
            (Some(file), Some(spot)) if matches!(self.spot, Some(Spot::Letter(..))) => [Some(format!("{file}, {spot}")), None],
            both => both.into(),
        };
        let scene = self.scene.as_ref().map(|scene| format!("scene \"{scene}\""));
        let field = self.field.as_ref().map(|field| field.named(naming).to_owned());
        let words: Vec<String> = begin.into_iter().chain([scene, field]).flatten().collect();
        words.join(": ")
    }
}

impl std::fmt::Display for Spot {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Letter(line, column) => write!(out, "line {line}, column {column}"),
            Self::Lines(first, last) if first != last => write!(out, "lines {first} to {last}"),
            Self::Line(line) | Self::Lines(line, _) => write!(out, "line {line}"),
            Self::Field(line, field) => write!(out, "line {line}, field {field}"),
            Self::Byte(byte) => write!(out, "byte {byte}"),
        }
    }
}

macro_rules! from {
    ($($part:ty, $name:ident, $place:expr;)+) => {$(
        impl From<$part> for FaultPlace {
            fn from($name: $part) -> Self {
                $place
            }
        }
    )+};
}

from! {
    Spot, spot, Self { spot: Some(spot), ..Self::default() };
    PathBuf, file, Self { file: Some(file), ..Self::default() };
    &Path, file, file.to_path_buf().into();
    Knob, field, Self { field: Some(field), ..Self::default() };
    String, field, Knob::field(field).into();
    &'static str, field, Knob::field(field).into();
}
