//! Contents of a file: components, places of sensors, and the record to which they belong.

use crate::{Direction, Format, Site};

/// `Contents` lists the components of a file and tells which record they belong to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contents {
    /// The format of the file.
    pub format: Format,
    /// The components in their order, at least one.
    pub channels: Vec<Channel>,
    /// Place and time of the recording.
    pub identity: Identity,
}

/// A `Channel` is one component of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Name by which a caller may choose the component; `None` for the only component of a file without names.
    pub name: Option<String>,
    /// Direction; `None` if the name does not show it.
    pub direction: Option<Direction>,
    /// Place of the sensor.
    pub site: Site,
}

/// An `Identity` is the place and time of a recording; a field is `None` if the file does not state it.
///
/// Components of a record have equal identities. Texts are in capitals with a single blank between words. A time is written as
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
