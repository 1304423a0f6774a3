//! Words of messages, with knobs that are named last, and kinds of refusals.

use std::borrow::Cow;
use std::io;

use crate::{Knob, Naming};

/// The kind of a refusal, for callers that do not only repeat it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// Something that its user can put right.
    #[default]
    Wrong,
    /// Something that the system refuses.
    System(io::ErrorKind),
    /// A text that is no record at all.
    NoRecord,
    /// Values that do not suit each other or the budget, though each is allowed.
    Together,
    /// A time step at the limit of stability or above it.
    Unstable,
    /// A file of the program's own that is not as it was written.
    Damaged,
    /// Times in uneven steps.
    Uneven,
    /// Fewer values than were announced.
    CutShort,
    /// A record of another quantity than accelerations.
    OtherQuantity,
    /// A record of velocities, unless its user says otherwise.
    Velocity,
    /// A record of displacements, by the name of its file.
    Displacement,
    /// Somebody ended it.
    Stopped,
}

/// Words of a message, with knobs among them that are named last.
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
