//! Stub until names tell more.

use crate::Direction;

/// What the name of a file tells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedFile {
    /// The name without its direction.
    pub stem: String,
    /// The direction.
    pub direction: Option<Direction>,
    /// Its azimuth.
    pub azimuth: Option<u16>,
    /// What the values are.
    pub quantity: Option<Quantity>,
    /// Record sequence number of PEER.
    pub rsn: Option<u32>,
}

/// What the values of a file are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Accelerations.
    Acceleration,
    /// Velocities.
    Velocity,
    /// Displacements.
    Displacement,
}

impl NamedFile {
    /// Of a name.
    pub fn of(name: &str) -> Self {
        let found = Direction::of_file_name(name);
        let stem = found.and_then(|(_, end)| Some((name.rfind(end)?, end.len())));
        Self {
            stem: stem.map_or_else(
                || name.into(),
                |(at, len)| format!("{}*{}", &name[..at], &name[at + len..]),
            ),
            direction: found.map(|(direction, _)| direction),
            azimuth: None,
            quantity: None,
            rsn: None,
        }
    }
}

/// Whether two names are of one record.
pub fn same_record(one: &NamedFile, other: &NamedFile) -> bool {
    one.direction.is_some() && one.stem == other.stem
}
