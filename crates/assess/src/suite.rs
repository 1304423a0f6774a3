//! A folder of records: the motions that shake a row, their events, and what is left out.

mod copies;
mod entries;
mod events;
mod left_out;
mod lines;
mod pairs;
mod read;
mod table;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use pounding_files::shown_name;
use pounding_motion::{Direction, Identity, NamedFile, Record};
use pounding_scene::{Error, FileUse, GroundMotion, Origin, PairAngles, RecordUse, Scene, Simulation, SimulationOptions, Source, parallel};
use pounding_text::{Refused, digits, short};

use copies::Copies;
use entries::{FolderEntry, RecordFile, entries_of};
pub use left_out::{LeftOut, LeftOutKind, LeftOutReason};
pub use lines::{MotionLine, MotionLines, Watched, nothing_found};
pub use pairs::HorizontalPair;
use read::{ReadMotion, Unread, of_file};
use table::{TableRow, Tables};

/// How the records of a folder are read.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FolderUse {
    /// Declarations for files that do not give these values themselves.
    pub declared: FileUse,
    /// Whether files of folders within the folder are read, too. Folders within archives are always read.
    pub sub_folders: bool,
    /// The use of the scale factors of PEER's `_SearchResults.csv`.
    pub selection_factors: SelectionFactors,
}

/// The use of the scale factors that PEER writes beside a selection.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum SelectionFactors {
    /// They are left out, which is said.
    #[default]
    LeftOut,
    /// They multiply the records.
    Used,
    /// They would change nothing, since every record is scaled to an intensity of its own measure. Nothing is said.
    WithoutEffect,
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
