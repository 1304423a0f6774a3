//! Words of messages whose knobs get their names at the end, and kinds of refusals.

use std::borrow::Cow;
use std::io;

use crate::{Knob, Naming};

/// The kind of a refusal, for callers that do more than repeat it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum RefusalKind {
    /// A fault that the user can remove.
    #[default]
    Wrong,
    /// A refusal by the operating system.
    System(io::ErrorKind),
    /// A text that is not a record.
    NoRecord,
    /// Values that are allowed each, but not together or not within the budget.
    Together,
    /// A time step at or above the limit of stability.
    Unstable,
    /// A file of the program that was changed after it was written.
    Damaged,
    /// Times that are not evenly spaced.
    Uneven,
    /// Fewer values than the file announces.
    CutShort,
    /// A record of another quantity than acceleration.
    OtherQuantity,
    /// A record of velocities, unless the user declares another quantity.
    Velocity,
    /// A record of displacements, judged by the name of its file.
    Displacement,
    /// A user stopped the work.
    Stopped,
}

/// Words of a message; knobs among them get their names at the end.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Words(pub(crate) Vec<Piece>);

#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Piece {
    Text(Cow<'static, str>),
    Quoted(String),
    Knob(Knob),
}

impl Words {
    /// The words with names for the knobs.
    pub fn by(&self, naming: Naming) -> String {
        let pieces = self.0.iter().map(|piece| match piece {
            Piece::Text(text) => Cow::Borrowed(text.as_ref()),
            Piece::Quoted(text) => format!("{text:?}").into(),
            Piece::Knob(knob) => knob.asked(naming).into(),
        });
        pieces.collect()
    }
}

impl From<&'static str> for Words {
    fn from(text: &'static str) -> Self {
        Self(vec![Piece::Text(text.into())])
    }
}

impl From<String> for Words {
    fn from(text: String) -> Self {
        Self(vec![Piece::Text(text.into())])
    }
}

impl From<Knob> for Words {
    fn from(knob: Knob) -> Self {
        Self(vec![Piece::Knob(knob)])
    }
}
