//! Two horizontal components of one recording, and the motion along an axis between them.

use std::path::Path;

use pounding_files::shown_name;
use pounding_motion::{Bearing, Direction, NamedFile, contents};
use pounding_text::Refused;

use super::sha256;
use crate::{Error, FileUse, Origin};

/// Angles of two horizontal components.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairAngles {
    /// Direction of positive values of each component, clockwise \[°\].
    pub degrees: [f64; 2],
    /// Whether they count from north; else from the first component.
    pub from_north: bool,
}

impl PairAngles {
    /// Returns the angles of two components; `None` if their words contradict a right angle. Components without words count from the first.
    pub fn of(bearings: [Option<Bearing>; 2]) -> Option<Self> {
        match bearings {
            [None, None] => Some(Self {
                degrees: [0.0, 90.0],
                from_north: false,
            }),
            [Some(one), Some(other)] if one.is_right_angle(other) => Some(Self {
                degrees: [one, other].map(Bearing::degrees),
                from_north: one.is_from_north(),
            }),
            _ => None,
        }
    }
}

impl Origin {
    /// Returns the motion along an axis \[°\] between this component and the other of its recording.
    ///
    /// # Errors
    /// Refuses components that do not fit each other.
    pub fn rotated(&self, other: &Self, angles: PairAngles, axis: f64) -> Result<Self, Refused> {
        let file = self.file.rotated(&other.file, angles.degrees, axis)?;
        let both = [self.sha256.as_str(), other.sha256.as_str()];
        Ok(Self {
            path: self.path.clone(),
            sha256: if both[0] == both[1] {
                both[0].to_owned()
            } else {
                sha256(both.concat().as_bytes())
            },
            file,
        })
    }

    /// Returns the bearing of the component by the file, else by the name of the file.
    pub fn bearing(&self, named: &NamedFile) -> Option<Bearing> {
        let in_file = self.file.component().and_then(Bearing::of_component);
        in_file.or_else(|| named.bearing())
    }
}

/// The motion along an axis \[°\] between the two horizontal components of a file, or of two files.
pub(crate) fn along(axis: f64, path: &Path, bytes: &[u8], declared: &FileUse) -> Result<Origin, Error> {
    let second = declared.second_file.as_ref().map(|name| path.with_file_name(name));
    let names: Vec<String> = std::iter::once(path).chain(second.as_deref()).map(shown_name).collect();
    let named = NamedFile::of_all(&names);
    let mut components = horizontals(path, bytes, declared, &named[0])?;
    if let Some(second) = second {
        components.extend(horizontals(&second, &Origin::bytes(&second)?, declared, &named[1])?);
    }
    let names = names.join(" and ");
    let [(one, of_one), (other, of_other)] = &components[..] else {
        let found = Refused::at("record.axis_deg").found(format!("{} horizontal components in {names}", components.len()));
        let found = found.allowed_is("two");
        return Err(found.help("name the file of the other one as `second_file`").in_file(path).into());
    };
    let Some(angles) = PairAngles::of([*of_one, *of_other]) else {
        let found = Refused::at("record.axis_deg").found(format!("components in {names} that are not at right angles by their names"));
        return Err(found.allowed_is("two components of one record").in_file(path).into());
    };
    let rotated = one.rotated(other, angles, axis);
    Ok(rotated.map_err(|refused| refused.in_field("record.axis_deg").in_file(path))?)
}

/// The horizontal components of a file, each with its bearing.
fn horizontals(path: &Path, bytes: &[u8], declared: &FileUse, named: &NamedFile) -> Result<Vec<(Origin, Option<Bearing>)>, Error> {
    let found = contents(bytes).map_err(|refused| refused.by(declared.naming).in_file(path))?;
    let several = found.channels.len() > 1;
    let level = (0..found.channels.len()).filter(|index| found.channels[*index].direction != Some(Direction::Vertical));
    let read = |index: usize| {
        let declared = FileUse {
            component: several.then(|| (index + 1).to_string()),
            axis_deg: None,
            second_file: None,
            ..declared.clone()
        };
        let (origin, _) = Origin::of_silent(path, bytes, &declared)?;
        let bearing = if several {
            origin.file.component().and_then(Bearing::of_component)
        } else {
            origin.bearing(named)
        };
        Ok((origin, bearing))
    };
    level.map(read).collect()
}
