//! A folder of records: the motions that shake a row, their events, and what is left out.

mod copies;
mod entries;
mod events;
mod left_out;
mod lines;
mod pairs;
mod table;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use pounding_files::shown_name;
use pounding_motion::{Channel, Contents, Direction, Identity, NamedFile, Record, Site, contents};
use pounding_scene::{Error, FileUse, GroundMotion, Origin, PairAngles, RecordUse, Scene, Simulation, SimulationOptions, Source, parallel};
use pounding_text::{Refused, digits, short};

use copies::Copies;
use entries::{FolderEntry, RecordFile, entries_of};
pub use left_out::{LeftOut, LeftOutKind, LeftOutReason};
pub use lines::{MotionLine, MotionLines, Watched, nothing_found};
pub use pairs::HorizontalPair;
use table::{TableRow, Tables};

/// How the records of a folder are read.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FolderUse {
    /// Declarations for files that do not give these values themselves.
    pub declared: FileUse,
    /// Whether files of folders within the folder are read, too. Folders within archives are always read.
    pub sub_folders: bool,
    /// Whether the scale factors of PEER's `_SearchResults.csv` multiply the records.
    pub selection_factors: bool,
}

impl From<&FileUse> for FolderUse {
    fn from(declared: &FileUse) -> Self {
        Self {
            declared: declared.clone(),
            ..Self::default()
        }
    }
}

/// A ground motion of a folder that was read and can shake rows: a file, or one component of a file with several.
#[derive(Debug, Clone, PartialEq)]
pub struct SuiteMotion {
    /// Name for tables: the name of the file, and the component if the file holds several.
    pub name: String,
    /// The file.
    pub path: PathBuf,
    /// Direction of the motion; `None` if neither the file nor its name gives it.
    pub direction: Option<Direction>,
    /// Number of its event in the folder, from 0. All components of a record belong to one event.
    pub event: usize,
    /// Component of the file, and declarations for what the file does not say itself.
    taken: FileUse,
    origin: Arc<Origin>,
    identity: Identity,
    named: NamedFile,
    /// What the table beside the file tells.
    told: TableRow,
    /// Both horizontal components of its recording, and their angles; `None` without a second one.
    pair: Option<(Arc<Origin>, Arc<Origin>, PairAngles)>,
}

impl SuiteMotion {
    /// Prepares a scene under this motion, as given or reversed, with the processing and the scaling of the scene.
    ///
    /// The run lasts to the end of the record and two periods longer; the scene's duration is for its own record. Setting `stop` ends its
    /// runs, and the runs that find its method.
    ///
    /// # Errors
    /// Errors of [`Simulation::new`]; [`Error::is_stopped`] if `stop` ended it.
    pub fn shake(&self, scene: &Scene, reversed: bool, stop: Option<&'static AtomicBool>) -> Result<Simulation, Error> {
        let mut scene = scene.clone();
        scene.duration_s = None;
        scene.record.reversed = reversed;
        let (record, motion) = self.used_as(&scene.record, &scene.name)?;
        scene.record = record;
        let options = SimulationOptions {
            motion: Some(motion.into()),
            stop,
            ..SimulationOptions::default()
        };
        Simulation::new(&scene, options)
    }

    /// Returns `record` with this motion as its source, and the ground motion that follows.
    ///
    /// # Errors
    /// Refuses processing that the motion does not allow; the message names `scene`.
    pub fn used_as(&self, record: &RecordUse, scene: &str) -> Result<(RecordUse, GroundMotion), Error> {
        let record = RecordUse {
            source: Source::File(self.taken.clone()),
            ..record.clone()
        };
        let motion = GroundMotion::of_file(&record, Arc::clone(&self.origin));
        let motion = motion.map_err(|refused| Error::in_scene(scene, refused))?;
        Ok((record, motion))
    }

    /// Returns both horizontal components of its recording, at right angles, processed as `record` says but not scaled to a target; `None`
    /// if there is no second one.
    ///
    /// # Errors
    /// Refuses processing that the motion does not allow; the message names `scene`.
    pub fn both_components(&self, record: &RecordUse, scene: &str) -> Result<Option<[Record; 2]>, Error> {
        let Some((one, other, angles)) = &self.pair else {
            return Ok(None);
        };
        let record = RecordUse {
            source: Source::File(self.taken.clone()),
            scale_to: None,
            ..record.clone()
        };
        let second = one.rotated(other, *angles, angles.degrees[0] + 90.0);
        let second = Arc::new(second.map_err(|refused| refused.in_file(&self.path))?);
        let used = |origin: Arc<Origin>| GroundMotion::of_file(&record, origin).map_err(|refused| Error::in_scene(scene, refused));
        Ok(Some([used(Arc::clone(one))?.record, used(second)?.record]))
    }

    /// Returns the file as it was read.
    pub fn origin(&self) -> &Arc<Origin> {
        &self.origin
    }

    /// Returns its files: two for a pair of them along an axis.
    fn files(&self) -> impl Iterator<Item = PathBuf> {
        let second = self.taken.second_file.as_ref().map(|name| self.path.with_file_name(name));
        std::iter::once(self.path.clone()).chain(second)
    }

    /// Returns the words that choose its component; `None` if the file holds one and none was asked for.
    pub fn component(&self) -> Option<&str> {
        self.taken.component.as_deref()
    }
}

/// The ground motions of a folder.
#[derive(Debug, Clone, PartialEq)]
pub struct Suite {
    /// Motions that shake a row, in the order of the files' names.
    pub motions: Vec<SuiteMotion>,
    /// Everything else in the folder, with the reason.
    pub left_out: Vec<LeftOut>,
    /// Number of events among the motions.
    pub n_events: usize,
    /// Files that were read, or tried.
    pub files: Vec<PathBuf>,
    /// Number of entries of the folders, files included.
    pub n_entries: usize,
    /// Pairs of motions that differ only by a factor: both names and the factor.
    pub alike: Vec<(String, String, f64)>,
    /// Names of pairs along an axis whose angles count from the first component, because no name gives them from north.
    pub from_first: Vec<String>,
    /// Sentences about the factors of tables beside the files.
    pub of_tables: Vec<String>,
}

impl Suite {
    /// Reads the records of a folder, of an archive, or of one file.
    ///
    /// Files whose names begin with a dot or end with `.provenance.json` are skipped. ZIP, tar and gzip archives are read in memory, and tables
    /// `records.csv` with a column `file` declare what their files leave out.
    ///
    /// # Errors
    /// Refuses a folder that cannot be read, and a folder without a motion that shakes a row.
    pub fn in_folder(folder: &Path, asked: impl Into<FolderUse>) -> Result<Self, Error> {
        std::fs::metadata(folder).map_err(|error| Refused::unreadable(folder, &error))?;
        let suite = Self::of(&[folder.to_path_buf()], asked)?;
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
    /// Refuses a folder that cannot be read, and a named file that cannot be read as a record.
    pub fn of(paths: &[PathBuf], asked: impl Into<FolderUse>) -> Result<Self, Error> {
        let (mut suite, refused) = Self::listed(paths, asked)?;
        for one in &mut suite.left_out {
            one.motion = None;
        }
        refused.map_or(Ok(suite), Err)
    }

    /// Reads the records of some folders and files. A named file that cannot be read is left out, too; the first error of named files is
    /// returned. Everything left out keeps its motion, if it was read. If `declared` names a component, only this component of every file
    /// is read. If it names an axis, each pair of horizontal components becomes one motion along the axis, and other motions are left out.
    ///
    /// # Errors
    /// Refuses a folder that cannot be read.
    pub fn listed(paths: &[PathBuf], asked: impl Into<FolderUse>) -> Result<(Self, Option<Error>), Error> {
        let asked = asked.into();
        let axis = asked.declared.axis_deg;
        let declared = FileUse {
            axis_deg: None,
            ..asked.declared.clone()
        };
        let paths = if asked.sub_folders {
            let folders = paths.iter().map(|path| Self::folders_in(path));
            folders.collect::<Result<Vec<_>, _>>()?.concat()
        } else {
            paths.to_vec()
        };
        let (mut left_out, mut files) = (Vec::new(), Vec::new());
        for entry in entries_of(&paths)? {
            match entry {
                FolderEntry::File(file) => files.push(file),
                FolderEntry::Other(other) => left_out.push(other),
            }
        }
        let tables = Tables::among(&files, &asked)?;
        left_out.extend(tables.paths.iter().map(|path| LeftOut::table(path)));
        files.retain(|file| !tables.paths.contains(&file.path));
        let named: Vec<_> = files.iter().zip(names_of(&files)).collect();
        let read = parallel::each(&named, |(file, named)| of_file(file, named, &declared, &tables.of(&file.path)));
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
        left_out.extend(others.into_iter().filter_map(ReadMotion::left_out));
        let mut suite = Self {
            n_events,
            motions: motions.into_iter().map(|one| one.motion).collect(),
            left_out,
            files: sources(&files),
            n_entries,
            of_tables: tables.said,
            alike,
            from_first: Vec::new(),
        };
        suite.join_pairs();
        if let Some(axis) = axis {
            suite.turn(axis)?;
        }
        Ok((suite, first))
    }
}

impl Suite {
    /// Leaves out motions, by their index, each with the factor that it would need.
    pub(crate) fn leave_out_scaled(&mut self, motions: &[(usize, f64)], most: f64) {
        let all = std::mem::take(&mut self.motions);
        for (index, motion) in all.into_iter().enumerate() {
            match motions.iter().find(|(left_out, _)| *left_out == index) {
                None => self.motions.push(motion),
                Some((_, factor)) => self.left_out.push(LeftOut {
                    name: motion.name.clone(),
                    path: motion.path.clone(),
                    reason: LeftOutKind::Scaled.saying(format!("by {}, above {}", short(*factor), digits(most))),
                    motion: None,
                }),
            }
        }
        self.number_events();
    }

    /// Numbers events without holes, since they are counted by their numbers.
    fn number_events(&mut self) {
        let mut events: Vec<usize> = self.motions.iter().map(|motion| motion.event).collect();
        events.sort_unstable();
        events.dedup();
        for motion in &mut self.motions {
            motion.event = events.binary_search(&motion.event).unwrap_or_default();
        }
        self.n_events = events.len();
    }
}

/// A component that was read.
struct ReadMotion {
    motion: SuiteMotion,
    /// Why it is left out; `None` if it shakes rows.
    reason: Option<LeftOutReason>,
}

impl ReadMotion {
    fn left_out(self) -> Option<LeftOut> {
        Some(LeftOut {
            name: self.motion.name.clone(),
            path: self.motion.path.clone(),
            reason: self.reason?,
            motion: Some(Box::new(self.motion)),
        })
    }
}

/// What the name of each file says.
fn names_of(files: &[RecordFile]) -> Vec<NamedFile> {
    // A name is compared with the other names of its folder; the files of a folder follow each other.
    let folders = files.chunk_by(|one, other| one.path.parent() == other.path.parent());
    let named = folders.flat_map(|files| {
        let names: Vec<String> = files.iter().map(|file| shown_name(&file.path)).collect();
        NamedFile::of_all(&names)
    });
    named.collect()
}

/// The files on the disk, each once.
fn sources(files: &[RecordFile]) -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = files.iter().map(|file| file.source().to_path_buf()).collect();
    all.dedup();
    all
}

/// Why a component of a file is not read.
enum Unread {
    /// The name shows that it shakes no row.
    Component(String, LeftOutReason),
    /// Reading it fails.
    Error(Error),
}

impl Unread {
    fn left_out(&self, path: &Path) -> LeftOut {
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
fn of_file(file: &RecordFile, named: &NamedFile, declared: &FileUse, rows: &[TableRow]) -> Vec<Result<ReadMotion, Unread>> {
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
