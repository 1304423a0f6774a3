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
    /// Whether the component is vertical by its name.
    pub vertical: bool,
}

impl Motion {
    /// Every ground motion of a folder, in the order of the files' names; files whose names begin with a dot, and folders, are
    /// left out.
    ///
    /// A file that cannot be read is one of them, and so is a vertical component: they say so when they are to shake something.
    ///
    /// # Errors
    /// [`StudyError::Unreadable`] when the folder cannot be read.
    pub fn in_folder(folder: &Path) -> Result<Vec<Self>, StudyError> {
        Ok(files_in(folder)?
            .into_iter()
            .flat_map(|path| of_file(&path))
            .collect())
    }

    /// The scene under this motion, reversed or not; processed and scaled as the scene says.
    ///
    /// It runs to the end of the record and two periods beyond, whatever duration the scene has for its own record. What the scene
    /// declares of its own file holds for a file that does not say it itself.
    ///
    /// # Errors
    /// Those of [`Prepared::new`]; [`StudyError::Vertical`].
    pub fn shake(&self, scene: &Scene, reversed: bool) -> Result<Prepared, StudyError> {
        if self.vertical {
            let component = self.component.clone().unwrap_or_default();
            return Err(StudyError::Vertical { component });
        }
        let mut scene = scene.clone();
        scene.duration_s = None;
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

/// The motions of a file: one, or one per component.
fn of_file(path: &Path) -> Vec<Motion> {
    let names = std::fs::read(path)
        .ok()
        .and_then(|bytes| components(&bytes).ok())
        .unwrap_or_default();
    let motion = |name: &String| Motion {
        path: path.to_path_buf(),
        component: (names.len() > 1 || is_vertical(name)).then(|| name.clone()),
        vertical: is_vertical(name),
    };
    if names.is_empty() {
        return vec![motion(&String::new())];
    }
    names.iter().map(motion).collect()
}

/// Whether a component is vertical by the last word of its name, as formats write it.
fn is_vertical(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let last = name
        .rsplit([' ', ':', '.'])
        .find(|word| !word.is_empty())
        .unwrap_or_default();
    // Channel codes of digitisers end in the direction: HNZ.
    let code = last.len() == 3 && last.ends_with('z');
    code || matches!(
        last,
        "up" | "u" | "v" | "ud" | "u-d" | "z" | "vert" | "vertical" | "down" | "dn"
    )
}

#[cfg(test)]
mod tests {
    use super::is_vertical;

    #[test]
    fn reference_directions_as_formats_write_them() {
        for name in [
            "CHAN 2: UP",
            "Sta Cha: 2: up",
            "Up",
            "U-D",
            "HNZ",
            "U",
            "V",
            "vertical",
            "Vert.",
        ] {
            assert!(is_vertical(name), "{name}");
        }
        for name in [
            "",
            "S16W",
            "CHAN 1: 90 DEG",
            "N-S",
            "E-W",
            "HNE",
            "NS",
            "Kuz street 12",
        ] {
            assert!(!is_vertical(name), "{name}");
        }
    }
}
