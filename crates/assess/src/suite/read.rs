//! The motions of a file: its only one, or its components.

use std::path::Path;
use std::sync::Arc;

use pounding_files::shown_name;
use pounding_motion::{Channel, Contents, Direction, NamedFile, Site, contents};
use pounding_scene::{Error, FileUse, Origin};

use super::SuiteMotion;
use super::entries::RecordFile;
use super::left_out::{LeftOut, LeftOutKind, LeftOutReason};
use super::table::TableRow;

/// A component that was read.
pub(super) struct ReadMotion {
    pub(super) motion: SuiteMotion,
    /// Why it is left out; `None` if it shakes rows.
    pub(super) reason: Option<LeftOutReason>,
}

impl ReadMotion {
    pub(super) fn left_out(self) -> Option<LeftOut> {
        Some(LeftOut {
            name: self.motion.name.clone(),
            path: self.motion.path.clone(),
            reason: self.reason?,
            motion: Some(Box::new(self.motion)),
        })
    }
}

/// Why a component of a file is not read.
pub(super) enum Unread {
    /// The name shows that it shakes no row.
    Component(String, LeftOutReason),
    /// Reading it fails.
    Error(Error),
}

impl Unread {
    pub(super) fn left_out(&self, path: &Path) -> LeftOut {
        let (name, reason) = match self {
            Self::Component(name, reason) => (name.clone(), reason.clone()),
            Self::Error(error) => (shown_name(path), LeftOutReason::of(error)),
        };
        LeftOut {
            name,
            path: path.to_path_buf(),
            reason,
            motion: None,
        }
    }
}

/// Finds the direction of a component; `None` if neither its file nor the file's name gives it. The name counts only if the file holds one
/// component.
///
/// # Errors
/// Gives the reason if it shakes no row: it is vertical, or recorded in a borehole or on a structure.
fn whether_it_shakes(channel: &Channel, named: &NamedFile, several: bool) -> Result<Option<Direction>, LeftOutReason> {
    match &channel.site {
        Site::Ground if named.in_borehole && !several => {
            return Err(LeftOutKind::Borehole.saying("by its name"));
        }
        Site::Ground => {}
        Site::Borehole(place) => return Err(LeftOutKind::Borehole.saying(place)),
        Site::Structure(place) => return Err(LeftOutKind::Structure.saying(place)),
    }
    match (channel.direction, named.direction.filter(|_| !several)) {
        (Some(Direction::Vertical), _) => {
            let word = channel.name.clone().unwrap_or_default();
            Err(LeftOutKind::Vertical.saying(word))
        }
        (None, Some(Direction::Vertical)) => Err(LeftOutKind::VerticalByName.saying("")),
        (told, by_name) => Ok(told.or(by_name)),
    }
}

/// Reads the motions of a file: its only one, the declared component, or every component; with a row of a table what the row tells.
pub(super) fn of_file(file: &RecordFile, named: &NamedFile, declared: &FileUse, rows: &[TableRow]) -> Vec<Result<ReadMotion, Unread>> {
    let read = file.with_bytes(|bytes| {
        rows.iter()
            .flat_map(|row| of_bytes(&file.path, bytes, named, declared, row))
            .collect()
    });
    read.unwrap_or_else(|refused| vec![Err(Unread::Error(refused.into()))])
}

fn of_bytes(path: &Path, bytes: &[u8], named: &NamedFile, declared: &FileUse, told: &TableRow) -> Vec<Result<ReadMotion, Unread>> {
    let mut found = match contents(bytes) {
        Ok(found) => found,
        Err(refused) => {
            let refused = refused.by(declared.naming).in_file(path);
            return vec![Err(Unread::Error(refused.into()))];
        }
    };
    let mut declared = told.over(declared);
    match (&told.component, &mut found.channels[..]) {
        // A word for the direction, if the file has none.
        (Some(word), [only]) => only.direction = only.direction.or_else(|| Direction::of_component(word)),
        (Some(word), _) => declared.component = Some(word.clone()),
        (None, _) => {}
    }
    let of = OfFile {
        path,
        bytes,
        named: named.clone(),
        found: &found,
        declared: &declared,
        told,
    };
    match &declared.component {
        Some(asked) => vec![of.channel(None, Some(asked.clone()))],
        None if found.channels.len() == 1 => vec![of.channel(Some(0), None)],
        None => (0..found.channels.len())
            .map(|index| of.channel(Some(index), Some(of.chosen(index))))
            .collect(),
    }
}

/// A file that was opened.
struct OfFile<'a> {
    path: &'a Path,
    bytes: &'a [u8],
    named: NamedFile,
    found: &'a Contents,
    declared: &'a FileUse,
    told: &'a TableRow,
}

impl OfFile<'_> {
    /// Reads a component by its index, or by these words if the index is `None`.
    fn channel(&self, index: Option<usize>, component: Option<String>) -> Result<ReadMotion, Unread> {
        let channels = &self.found.channels;
        let several = channels.len() > 1;
        let declared = FileUse {
            file: self.path.to_string_lossy().into_owned(),
            component,
            ..self.declared.clone()
        };
        let read = Origin::of_silent(self.path, self.bytes, &declared).and_then(|(origin, taken)| Ok((self.times(origin)?, taken)));
        let of_name = || {
            let (origin, _) = read.as_ref().ok()?;
            let name = origin.file.component();
            channels.iter().position(|one| one.name.as_deref() == name)
        };
        let channel = &channels[index.or_else(of_name).unwrap_or(0)];
        let file = shown_name(self.path);
        let name = match &channel.name {
            Some(component) if several => format!("{file} {component}"),
            _ => file,
        };
        let placed = whether_it_shakes(channel, &self.named, several);
        let (origin, taken) = match (read, &placed) {
            (Ok(read), _) => read,
            (Err(error), _) if index.is_none() => return Err(Unread::Error(error)),
            // A vertical component shakes nothing, even if it cannot be read.
            (Err(_), Err(reason)) => return Err(Unread::Component(name, reason.clone())),
            (Err(error), Ok(_)) if several => {
                return Err(Unread::Component(name, LeftOutReason::of(&error)));
            }
            (Err(error), Ok(_)) => return Err(Unread::Error(error)),
        };
        let is_still = origin.file.values().iter().all(|value| *value == 0.0);
        let zeros = is_still.then(|| LeftOutKind::Zeros.saying(""));
        let (direction, reason) = match placed {
            Ok(direction) => (direction, zeros),
            Err(reason) => (None, Some(reason)),
        };
        let motion = SuiteMotion {
            name,
            path: self.path.to_path_buf(),
            direction,
            event: 0,
            taken,
            origin: Arc::new(origin),
            identity: self.found.identity.clone(),
            named: self.named.clone(),
            told: self.told.clone(),
            pair: None,
        };
        Ok(ReadMotion { motion, reason })
    }

    /// The component times the factor of the table.
    fn times(&self, origin: Origin) -> Result<Origin, Error> {
        let Some(factor) = self.told.factor else {
            return Ok(origin);
        };
        let file = origin.file.times(factor).map_err(|refused| refused.in_file(self.path))?;
        Ok(Origin { file, ..origin })
    }

    /// Returns the word that chooses a component: its name, or its number if another component has the same name.
    fn chosen(&self, index: usize) -> String {
        let channels = &self.found.channels;
        let own = &channels[index].name;
        let same = channels.iter().filter(|one| one.name == *own).count();
        match own {
            Some(name) if same == 1 => name.clone(),
            _ => (index + 1).to_string(),
        }
    }
}
