//! A folder of records, each of which shakes the same row.

use std::path::{Path, PathBuf};

use pounding_motion::{ReadError, components};

use crate::{FileUse, Prepared, Scene, Source, StudyError};

/// One ground motion of a folder: a file, or one component of a file that holds several.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// The file.
    pub path: PathBuf,
    /// Its component, where it holds several.
    pub component: Option<String>,
}

impl Motion {
    /// Every ground motion of a folder, in the order of the files' names; files whose names begin with a dot, folders, and
    /// vertical components are left out.
    ///
    /// A file that cannot be read is one of them: it will say so when it shakes something.
    ///
    /// # Errors
    /// [`StudyError::Unreadable`] when the folder cannot be read.
    pub fn in_folder(folder: &Path) -> Result<Vec<Self>, StudyError> {
        Ok(files_in(folder)?.into_iter().flat_map(of_file).collect())
    }

    /// The scene under this motion, reversed or not; processed and scaled as the scene says.
    ///
    /// What the scene declares of its own file holds for a file that does not say it itself.
    ///
    /// # Errors
    /// Those of [`Prepared::new`].
    pub fn shake(&self, scene: &Scene, reversed: bool) -> Result<Prepared, StudyError> {
        let mut scene = scene.clone();
        scene.record.reversed = reversed;
        let own = FileUse {
            file: self.path.to_string_lossy().into_owned(),
            component: self.component.clone(),
            ..FileUse::default()
        };
        let declared = match &scene.record.source {
            Source::File(file) => FileUse {
                unit: file.unit,
                time_step_s: file.time_step_s,
                per_count: file.per_count,
                ..own.clone()
            },
            Source::Generated(_) => own.clone(),
        };
        scene.record.source = Source::File(own);
        match Prepared::new(&scene, Path::new("")) {
            Err(StudyError::Record {
                source:
                    ReadError::UnitNotStated | ReadError::TimeStepNotStated | ReadError::Counts { .. },
                ..
            }) => {
                scene.record.source = Source::File(declared);
                Prepared::new(&scene, Path::new(""))
            }
            prepared => prepared,
        }
    }

    /// Name for tables: that of the file, and the component.
    pub fn name(&self) -> String {
        let name = self.path.file_name().unwrap_or_default();
        let file = name.to_string_lossy();
        match &self.component {
            Some(component) => format!("{file} {component}"),
            None => file.into_owned(),
        }
    }
}

/// The files of a folder, in the order of their names, but for those whose names begin with a dot.
///
/// # Errors
/// [`StudyError::Unreadable`] when the folder cannot be read.
pub fn files_in(folder: &Path) -> Result<Vec<PathBuf>, StudyError> {
    let unreadable = |source| StudyError::Unreadable {
        path: folder.to_path_buf(),
        source,
    };
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let hidden = path
            .file_name()
            .is_none_or(|name| name.to_string_lossy().starts_with('.'));
        if path.is_file() && !hidden {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

/// The motions of a file: one, or one per horizontal component.
fn of_file(path: PathBuf) -> Vec<Motion> {
    let found = std::fs::read(&path)
        .ok()
        .and_then(|bytes| components(&bytes).ok());
    let several = found.filter(|names| names.len() > 1).unwrap_or_default();
    if several.is_empty() {
        return vec![Motion {
            path,
            component: None,
        }];
    }
    let horizontal = several.into_iter().filter(|name| !is_vertical(name));
    let motion = |component| Motion {
        path: path.clone(),
        component: Some(component),
    };
    horizontal.map(motion).collect()
}

/// Whether a component is vertical by its name.
fn is_vertical(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    name.starts_with("up")
        || name.contains("vert")
        || name.ends_with('z')
        || name == "u-d"
        || name == "ud"
}
