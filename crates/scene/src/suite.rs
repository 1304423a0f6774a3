//! A folder of records, each of which shakes the same row.

pub(crate) mod events;
pub mod lines;

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use pounding_motion::{Direction, Record, components};

use crate::{
    Error, FileUse, GroundMotion, Options, RecordUse, Scene, Simulation, Source, Vertical,
    record_bytes,
};

/// One ground motion of a folder: a file, or one component of a file that holds several.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// The file.
    pub path: PathBuf,
    /// Its component, where it holds several.
    pub component: Option<String>,
    /// How it lies, as far as that is told.
    pub orientation: Orientation,
}

/// How a motion lies, as far as the name of its component or that of its file tells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Orientation {
    /// Along the ground.
    Horizontal,
    /// Up and down: it shakes no row.
    Vertical(Vertical),
    /// Nothing tells: it shakes rows, and that is said.
    Untold,
}

impl Motion {
    /// Every ground motion of a folder, in the order of the files' names; files whose names begin with a dot, and folders, are
    /// left out.
    ///
    /// A file that cannot be read is one of them, and so is a vertical component: they say so when they are to shake something.
    /// A component is vertical by a word of its [name](Direction::of_component); one whose name does not tell, of a file
    /// of one component, by the [end of the file's name](Direction::of_file_name).
    ///
    /// # Errors
    /// [`Error::Unreadable`] when the folder cannot be read.
    pub fn in_folder(folder: &Path) -> Result<Vec<Self>, Error> {
        Ok(files_in(folder)?
            .into_iter()
            .flat_map(|path| of_file(&path))
            .collect())
    }

    /// Every ground motion of a file: one, or one of each component.
    pub fn in_file(path: &Path) -> Vec<Self> {
        of_file(path)
    }

    /// The scene under this motion, reversed or not; processed and scaled as the scene says.
    ///
    /// It runs to the end of the record and two periods beyond, whatever duration the scene has for its own record. What the scene
    /// declares of its own file holds for a file that does not say it itself.
    ///
    /// # Errors
    /// Those of [`Simulation::new`]; [`Error::Vertical`]; [`Error::AtRest`].
    pub fn shake(&self, scene: &Scene, reversed: bool) -> Result<Simulation, Error> {
        self.shake_until(scene, reversed, None)
    }

    /// The same; whoever sets `stop` ends its runs, and those that find its method.
    ///
    /// # Errors
    /// Those of [`Self::shake`]; [`Error::is_stopped`] tells one that was ended.
    pub fn shake_until(
        &self,
        scene: &Scene,
        reversed: bool,
        stop: Option<&'static AtomicBool>,
    ) -> Result<Simulation, Error> {
        if let Orientation::Vertical(vertical) = &self.orientation {
            return Err(Error::Vertical(vertical.clone()));
        }
        let mut scene = scene.clone();
        scene.duration_s = None;
        scene.record.reversed = reversed;
        self.where_unsaid(&scene.record.clone(), |source| {
            scene.record.source = source;
            let options = Options {
                stop,
                ..Options::default()
            };
            let prepared = Simulation::new(&scene, options)?;
            moves(prepared.record())?;
            Ok(prepared)
        })
    }

    /// The motion used as `record` says, but for its source; and that use with this motion as its source.
    ///
    /// # Errors
    /// Those of [`GroundMotion::of`]; [`Error::AtRest`].
    pub fn used_as(
        &self,
        record: &RecordUse,
        scene: &str,
    ) -> Result<(RecordUse, GroundMotion), Error> {
        let mut record = record.clone();
        let motion = self.where_unsaid(&record.clone(), |source| {
            record.source = source;
            let motion = GroundMotion::of(&record, Path::new(""), scene)?;
            moves(&motion.record)?;
            Ok(motion)
        })?;
        Ok((record, motion))
    }

    /// Tries this motion as a source, with as much of what `record` declares of its own file as this one does not say.
    fn where_unsaid<T>(
        &self,
        record: &RecordUse,
        mut attempt: impl FnMut(Source) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let of_scene = match &record.source {
            Source::File(file) => file.clone(),
            Source::Generated(_) => FileUse::default(),
        };
        let file = FileUse {
            file: self.path.to_string_lossy().into_owned(),
            component: self.component.clone(),
            ..of_scene
        };
        file.where_unsaid(|file| attempt(Source::File(file.clone())))
    }

    /// Name for tables: that of the file, and the component.
    pub fn name(&self) -> String {
        let file = self.file_name();
        match &self.component {
            Some(component) => format!("{file} {component}"),
            None => file,
        }
    }

    fn file_name(&self) -> String {
        let name = self.path.file_name().unwrap_or_default();
        name.to_string_lossy().into_owned()
    }
}

/// Refuses a motion that is none: a file of zeros would count as an event.
fn moves(record: &Record) -> Result<(), Error> {
    if record.peak().1.abs() > 0.0 {
        Ok(())
    } else {
        Err(Error::AtRest)
    }
}

/// The files of a folder, in the order of their names, but for those whose names begin with a dot or end with
/// `.provenance.json`: such a file tells where the record beside it comes from.
///
/// # Errors
/// [`Error::Unreadable`] when the folder cannot be read.
pub fn files_in(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let unreadable = |source| Error::Unreadable {
        path: folder.to_path_buf(),
        source,
    };
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let hidden = path.file_name().is_none_or(|name| {
            let name = name.to_string_lossy();
            name.starts_with('.') || name.ends_with(".provenance.json")
        });
        if path.is_file() && !hidden {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

/// The motions of a file: one, or one per component.
fn of_file(path: &Path) -> Vec<Motion> {
    let names = record_bytes(path)
        .ok()
        .and_then(|bytes| components(&bytes).ok())
        .unwrap_or_default();
    let motion = |component: Option<String>, orientation| Motion {
        path: path.to_path_buf(),
        component,
        orientation,
    };
    match &names[..] {
        [] => vec![motion(None, Orientation::of(None, Some(path)))],
        [name] => vec![motion(None, Orientation::of(Some(name), Some(path)))],
        several => several
            .iter()
            .map(|name| motion(Some(name.clone()), Orientation::of(Some(name), None)))
            .collect(),
    }
}

impl Orientation {
    /// Tells how a component lies by its name, and where that does not tell by the file, if it is the only one there.
    pub fn of(component: Option<&str>, only_of: Option<&Path>) -> Self {
        let direction = component.and_then(|name| Some((Direction::of_component(name)?, name)));
        match direction {
            Some((Direction::Horizontal, _)) => return Self::Horizontal,
            Some((Direction::Vertical, name)) => {
                return Self::Vertical(Vertical::Component(name.into()));
            }
            None => {}
        }
        let name = only_of.and_then(Path::file_name).unwrap_or_default();
        match Direction::of_file_name(&name.to_string_lossy()) {
            Some((Direction::Horizontal, _)) => Self::Horizontal,
            Some((Direction::Vertical, end)) => Self::Vertical(Vertical::FileName(end.into())),
            None => Self::Untold,
        }
    }

    /// Returns the word for tables: `horizontal` or `vertical`; `None` if nothing tells.
    pub fn word(&self) -> Option<&'static str> {
        match self {
            Self::Horizontal => Some("horizontal"),
            Self::Vertical(_) => Some("vertical"),
            Self::Untold => None,
        }
    }
}
