//! A folder of records: which of its motions shake a row, which are of one event, and what is left out.

mod copies;
mod entries;
mod events;
mod left_out;
pub mod lines;

use pounding_text::Refused;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use pounding_motion::{Channel, Contents, Direction, Identity, NamedFile, Site, contents};

use crate::ground_motion::shown_name;
use crate::{Error, FileUse, GroundMotion, Options, Origin, RecordUse, Scene, Simulation, Source, parallel};
use copies::Copies;
pub use entries::files_in;
use entries::{Entry, entries_of};
pub use left_out::{LeftOut, Reason, ReasonKind};

/// One ground motion of a folder: a file, or one component of a file that holds several. It was read and shakes rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Name for tables: that of the file, and the component if the file holds several.
    pub name: String,
    /// The file.
    pub path: PathBuf,
    /// How it lies; `None` if neither the file nor its name tells.
    pub direction: Option<Direction>,
    /// Number of its event among those of the folder, from 0. Components of one record are of one event.
    pub event: usize,
    /// What was declared of its file because the file does not say it, and its component.
    taken: FileUse,
    origin: Arc<Origin>,
    identity: Identity,
    named: NamedFile,
}

impl Motion {
    /// Prepares the scene under this motion, reversed or not; processed and scaled as the scene says.
    ///
    /// It runs to the end of the record and two periods beyond, whatever duration the scene has for its own record. Whoever sets
    /// `stop` ends its runs, and those that find its method.
    ///
    /// # Errors
    /// Those of [`Simulation::new`]; [`Error::is_stopped`] tells one that was ended.
    pub fn shake(&self, scene: &Scene, reversed: bool, stop: Option<&'static AtomicBool>) -> Result<Simulation, Error> {
        let mut scene = scene.clone();
        scene.duration_s = None;
        scene.record.reversed = reversed;
        let (record, motion) = self.used_as(&scene.record, &scene.name)?;
        scene.record = record;
        let options = Options {
            motion: Some(motion.into()),
            stop,
            ..Options::default()
        };
        Simulation::new(&scene, options)
    }

    /// Returns the use `record` with this motion as its source, and the motion used so.
    ///
    /// # Errors
    /// What cannot be done to it in `scene`.
    pub fn used_as(&self, record: &RecordUse, scene: &str) -> Result<(RecordUse, GroundMotion), Error> {
        let record = RecordUse {
            source: Source::File(self.taken.clone()),
            ..record.clone()
        };
        let motion = GroundMotion::of_file(&record, Arc::clone(&self.origin));
        let motion = motion.map_err(|refused| Error::in_scene(scene, refused))?;
        Ok((record, motion))
    }

    /// Returns the file as it was read.
    pub fn origin(&self) -> &Arc<Origin> {
        &self.origin
    }

    /// Returns by which words its component was chosen, if the file holds several or one was asked for.
    pub fn component(&self) -> Option<&str> {
        self.taken.component.as_deref()
    }
}

/// The ground motions of a folder.
#[derive(Debug, Clone, PartialEq)]
pub struct Suite {
    /// Those that shake a row, in the order of the files' names.
    pub motions: Vec<Motion>,
    /// What shakes nothing, with the reason.
    pub left_out: Vec<LeftOut>,
    /// Number of events that the motions are of.
    pub n_events: usize,
    /// The files that were looked at.
    pub files: Vec<PathBuf>,
    /// Number of entries of the folders, files included.
    pub n_entries: usize,
    /// Pairs of motions that are the same but for a factor, by their names, with the factor.
    pub alike: Vec<(String, String, f64)>,
}

impl Suite {
    /// Reads the records of a folder, or of one file. `declared` is what is said of files that do not say it themselves.
    ///
    /// A file whose name begins with a dot is passed over, and so is one that ends with `.provenance.json`.
    ///
    /// # Errors
    /// Refuses a folder that cannot be read, and one in which nothing shakes a row.
    pub fn in_folder(folder: &Path, declared: &FileUse) -> Result<Self, Error> {
        std::fs::metadata(folder).map_err(|error| Refused::unreadable(folder, &error))?;
        let suite = Self::of(&[folder.to_path_buf()], declared)?;
        if suite.motions.is_empty() {
            let found = format!("{} files and no record that shakes a row", suite.n_entries);
            let left_out = suite.said_of_left_out(false).into_iter();
            let one_or_more = std::iter::once("a folder with one or more".to_owned()).chain(left_out);
            let allowed: Vec<String> = one_or_more.collect();
            return Err(Refused::at(folder).found(found).allowed_is(allowed.join("; ")).into());
        }
        Ok(suite)
    }

    /// Reads the records of some folders and files.
    ///
    /// # Errors
    /// Refuses a folder that cannot be read, and those of reading a file that is named itself.
    pub fn of(paths: &[PathBuf], declared: &FileUse) -> Result<Self, Error> {
        let (mut suite, refused) = Self::listed(paths, declared)?;
        for one in &mut suite.left_out {
            one.motion = None;
        }
        refused.map_or(Ok(suite), Err)
    }

    /// Does the same, leaves out files that are named as it does others, and returns the first error of those. What is left
    /// out has its motion. Of every file only the component that `declared` names is read, if it names one.
    ///
    /// # Errors
    /// Refuses a folder that cannot be read.
    pub fn listed(paths: &[PathBuf], declared: &FileUse) -> Result<(Self, Option<Error>), Error> {
        let mut left_out = Vec::new();
        let mut files = Vec::new();
        for entry in entries_of(paths)? {
            match entry {
                Entry::File(file) => files.push(file),
                Entry::Other(other) => left_out.push(other),
            }
        }
        // Names are compared with others of their folder, whose files stand together.
        let folders = files.chunk_by(|one, other| one.path.parent() == other.path.parent());
        let named = folders.flat_map(|files| {
            let names: Vec<String> = files.iter().map(|file| shown_name(&file.path)).collect();
            NamedFile::of_all(&names)
        });
        let named: Vec<_> = files.iter().zip(named).collect();
        let read = parallel::each(&named, |(file, named)| of_file(file, named.clone(), declared));
        let n_entries = files.len() + left_out.len();
        let (mut all, mut first) = (Vec::new(), None);
        for (file, read) in files.iter().zip(read) {
            for found in read {
                match found {
                    Ok(one) => all.push(one),
                    Err(refused) => {
                        left_out.push(refused.left_out(&file.path));
                        if let (Unread::Error(error), true) = (refused, file.named) {
                            first.get_or_insert(error);
                        }
                    }
                }
            }
        }
        let copies = Copies::among(&mut all);
        let (n_events, alike) = events::number(&mut all, &copies);
        copies.leave_out(&mut all);
        let (motions, others): (Vec<_>, Vec<_>) = all.into_iter().partition(|one| one.reason.is_none());
        left_out.extend(others.into_iter().filter_map(Read::left_out));
        let suite = Self {
            n_events,
            motions: motions.into_iter().map(|one| one.motion).collect(),
            left_out,
            files: files.into_iter().map(|file| file.path).collect(),
            n_entries,
            alike,
        };
        Ok((suite, first))
    }
}

/// A component that was read.
struct Read {
    motion: Motion,
    /// Why it shakes nothing, if so.
    reason: Option<Reason>,
}

impl Read {
    fn left_out(self) -> Option<LeftOut> {
        Some(LeftOut {
            name: self.motion.name.clone(),
            path: self.motion.path.clone(),
            reason: self.reason?,
            motion: Some(Box::new(self.motion)),
        })
    }
}

/// A file that is to be read.
struct File {
    path: PathBuf,
    /// Whether its user named it, and not only its folder.
    named: bool,
}

/// Why a component of a file is not read.
enum Unread {
    /// What it is, by its name.
    Component(String, Reason),
    /// What reading it says.
    Error(Error),
}

impl Unread {
    fn left_out(&self, path: &Path) -> LeftOut {
        let (name, reason) = match self {
            Self::Component(name, reason) => (name.clone(), reason.clone()),
            Self::Error(error) => (shown_name(path), Reason::of(error)),
        };
        LeftOut {
            name,
            path: path.to_path_buf(),
            reason,
            motion: None,
        }
    }
}

/// How a component lies, `None` if neither its file nor the file's name tells; the name counts only if the file holds
/// nothing else.
///
/// # Errors
/// Says why it shakes no row: it is vertical, of a borehole or of a structure.
fn whether_it_shakes(channel: &Channel, named: &NamedFile, several: bool) -> Result<Option<Direction>, Reason> {
    match &channel.site {
        Site::Ground if named.in_borehole && !several => {
            return Err(ReasonKind::Borehole.saying("by its name"));
        }
        Site::Ground => {}
        Site::Borehole(place) => return Err(ReasonKind::Borehole.saying(place)),
        Site::Structure(place) => return Err(ReasonKind::Structure.saying(place)),
    }
    match (channel.direction, named.direction.filter(|_| !several)) {
        (Some(Direction::Vertical), _) => {
            let word = channel.name.clone().unwrap_or_default();
            Err(ReasonKind::Vertical.saying(word))
        }
        (None, Some(Direction::Vertical)) => Err(ReasonKind::VerticalByName.saying("")),
        (told, by_name) => Ok(told.or(by_name)),
    }
}

/// The motions of a file: one, or one for each component, or the one that is declared.
fn of_file(file: &File, named: NamedFile, declared: &FileUse) -> Vec<Result<Read, Unread>> {
    let path = &file.path;
    let bytes = match crate::record_bytes(path) {
        Ok(bytes) => bytes,
        Err(error) => return vec![Err(Unread::Error(Refused::unreadable(path, &error).into()))],
    };
    let found = match contents(&bytes) {
        Ok(found) => found,
        Err(refused) => {
            let refused = refused.by(declared.naming).in_file(path);
            return vec![Err(Unread::Error(refused.into()))];
        }
    };
    let of = OfFile {
        path,
        bytes: &bytes,
        named,
        found: &found,
        declared,
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
}

impl OfFile<'_> {
    /// The component that is chosen so; without an index, the one that is read by these words.
    fn channel(&self, index: Option<usize>, component: Option<String>) -> Result<Read, Unread> {
        let channels = &self.found.channels;
        let several = channels.len() > 1;
        let declared = FileUse {
            file: self.path.to_string_lossy().into_owned(),
            component,
            ..self.declared.clone()
        };
        let read = Origin::of_silent(self.path, self.bytes, &declared);
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
            // What is vertical shakes nothing, read or not.
            (Err(_), Err(reason)) => return Err(Unread::Component(name, reason.clone())),
            (Err(error), Ok(_)) if several => {
                return Err(Unread::Component(name, Reason::of(&error)));
            }
            (Err(error), Ok(_)) => return Err(Unread::Error(error)),
        };
        let is_still = origin.file.values().iter().all(|value| *value == 0.0);
        let zeros = is_still.then(|| ReasonKind::Zeros.saying(""));
        let (direction, reason) = match placed {
            Ok(direction) => (direction, zeros),
            Err(reason) => (None, Some(reason)),
        };
        let motion = Motion {
            name,
            path: self.path.to_path_buf(),
            direction,
            event: 0,
            taken,
            origin: Arc::new(origin),
            identity: self.found.identity.clone(),
            named: self.named.clone(),
        };
        Ok(Read { motion, reason })
    }

    /// By which word its component is chosen: its name, or its number if another has that name.
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
