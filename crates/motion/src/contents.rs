//! Contents of a file: components, places of sensors, and the record they belong to.

use crate::{Direction, Format, Site};

/// `Contents` lists the components of a file and tells which record they belong to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contents {
    /// The format that the file was found to be in.
    pub format: Format,
    /// The components in their order, at least one.
    pub channels: Vec<Channel>,
    /// Where and when the motion was recorded.
    pub identity: Identity,
}

/// A `Channel` is one component of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Its name, by which a caller may choose it; `None` in a file of one that has no name.
    pub name: Option<String>,
    /// How it lies; `None` if its name does not tell.
    pub direction: Option<Direction>,
    /// Where its sensor is.
    pub site: Site,
}

/// An `Identity` tells where and when a motion was recorded; a field is `None` if the file does not say.
///
/// Components of one record have equal identities. Texts are in capitals with one blank between words. A time is written as
/// `1999-09-20T17:47:15` if the file has a date and a time of day, else as in the file.
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
