//! Stub until the readers tell it.

use crate::{Direction, Format, ReadError, components, recognised};

/// What a file holds, before a component is chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct Contents {
    /// Its format.
    pub format: Format,
    /// Its components, at least one.
    pub channels: Vec<Channel>,
    /// Where and when it was recorded.
    pub identity: Identity,
}

/// One component of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Its name; `None` if the file gives none.
    pub name: Option<String>,
    /// How it lies.
    pub direction: Option<Direction>,
    /// Where the instrument stands.
    pub site: Site,
}

/// Where an instrument stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Site {
    /// On the ground, or not told.
    Ground,
    /// In a borehole, in the words of the file.
    Borehole(String),
    /// On a structure, in the words of the file.
    Structure(String),
}

/// What a file says of where and when its motion was recorded.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// Record sequence number of PEER.
    pub rsn: Option<u32>,
    /// Station.
    pub station: Option<String>,
    /// Event.
    pub event: Option<String>,
    /// Time.
    pub time: Option<String>,
    /// Title without its direction.
    pub title: Option<String>,
}

/// What a file holds.
///
/// # Errors
/// Those of a file of no known format.
pub fn contents(bytes: &[u8]) -> Result<Contents, ReadError> {
    let names = components(bytes)?;
    let format = recognised(bytes).expect("its components were found");
    let channel = |name: Option<String>| Channel {
        direction: name.as_deref().and_then(Direction::of_component),
        name,
        site: Site::Ground,
    };
    let mut channels: Vec<Channel> = names.into_iter().map(|name| channel(Some(name))).collect();
    if channels.is_empty() {
        channels.push(channel(None));
    }
    Ok(Contents {
        format,
        channels,
        identity: Identity::default(),
    })
}
