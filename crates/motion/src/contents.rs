//! What a file holds, before a component is chosen.

use crate::{Direction, Format, Site};

/// What a file holds, before a component is chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contents {
    /// The format that the file was found to be in.
    pub format: Format,
    /// The components in their order, at least one.
    pub channels: Vec<Channel>,
    /// Where and when the motion was recorded.
    pub identity: Identity,
}

/// One component of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Its name, by which a caller may choose it; `None` in a file of one that has no name.
    pub name: Option<String>,
    /// How it lies; `None` if its name does not tell.
    pub direction: Option<Direction>,
    /// Where its sensor is.
    pub site: Site,
}

/// What a file says of where and when its motion was recorded, each `None` if it does not say.
///
/// Files of one event agree in what they say. Texts are in capitals with one blank between words, times as
/// `1999-09-20T17:47:15` wherever a date and a time of day are known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// Number of the record in PEER's data bases.
    pub rsn: Option<u32>,
    /// Station, by its code or name.
    pub station: Option<String>,
    /// Event, by its code or name.
    pub event: Option<String>,
    /// Time of the event or of the first sample.
    pub time: Option<String>,
    /// Title, without the direction of the component.
    pub title: Option<String>,
}
