//! Example scenes that have a page of explanation: every reproduction makes their figures and tables again.

use crate::StudyError;
use crate::drivers::each;
use crate::files::{Files, in_folder};
use std::path::{Path, PathBuf};

use pounding_assess::{Effects, Suite};
use pounding_report::Report;
use pounding_scene::{Scene, Simulation};

/// The scenes of a folder that have a page: `row.md` explains `row.toml` or `row.json`.
#[derive(Debug)]
pub struct Examples {
    scenes: Vec<(PathBuf, Scene)>,
}

impl Examples {
    /// Reads the scenes of a folder that have a page of the same name.
    ///
    /// # Errors
    /// [`StudyError`] with the file that cannot be read.
    pub fn read(folder: &Path) -> Result<Self, StudyError> {
        let ends = |path: &Path, end: &str| path.extension().is_some_and(|found| found == end);
        let is_scene = |path: &PathBuf| (ends(path, "toml") || ends(path, "json")) && path.with_extension("md").exists();
        let paths = Suite::files_in(folder)?.into_iter().filter(is_scene);
        let scenes = paths.map(|path| Ok::<_, StudyError>((path.clone(), Scene::read(&path)?)));
        Ok(Self {
            scenes: scenes.collect::<Result<_, _>>()?,
        })
    }

    /// Number of calls of `done` by [`Self::files`].
    pub fn n_units(&self) -> usize {
        self.scenes.len()
    }

    /// The files of a run with its effects, by path: `NAME/impacts.csv`, `NAME/effects.csv`, `NAME/animation.svg` and the figures.
    /// Histories, and files that contain versions, are left out. Calls `done` after each scene.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of names.
    pub fn files(&self, done: &(dyn Fn() + Sync)) -> Result<Files, StudyError> {
        let of = |(path, scene): &(PathBuf, Scene)| of_scene(path, scene).map_err(|error| error.in_file(path));
        let made = each(&self.scenes, done, of).into_iter().collect::<Result<Vec<_>, _>>()?;
        Ok(made.into_iter().flatten().collect())
    }
}

fn of_scene(path: &Path, scene: &Scene) -> Result<Files, StudyError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let prepared = Simulation::new(scene, folder)?;
    let effects = Effects::of(&prepared)?;
    let report = Report::of(&prepared, true)?.with_effects(Some(effects));
    let is_figure = |name: &str| Path::new(name).extension().is_some_and(|end| end == "png");
    let shown = |name: &str| is_figure(name) || ["impacts.csv", "effects.csv", "animation.svg"].contains(&name);
    let name = path.file_stem().unwrap_or_default();
    let files = report.files().into_iter().filter(|(file, _)| shown(file));
    Ok(in_folder(Path::new("examples").join(name), files))
}
