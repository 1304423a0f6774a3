//! Extreme scenes: every number of every run is exact, refused or wrong, with or without a warning of the program.
//!
//! Stepping methods are measured by the exact one, and the exact one by the second route. A number is "silently wrong" if it is more than
//! 10 % off in a run that ends, is not refused, and has no warning about that number.

mod class;
mod map;
mod measure;
mod table;

use crate::drivers::each;
use crate::files::{Files, drawn, in_folder, made_by};
use crate::study::stress::{Edges, Extent, ExtremeScene};
use crate::{Completed, StudyError};
use std::path::{Path, PathBuf};

use measure::{JudgedScene, measure};

/// Results of all extreme scenes.
#[derive(Debug)]
pub struct Extremes {
    edges: Edges,
    extent: Extent,
    cells: Vec<ExtremeScene>,
    measured: Vec<JudgedScene>,
    path: PathBuf,
}

impl Extremes {
    /// Runs every method on every extreme scene. Calls `done` after each scene.
    ///
    /// # Errors
    /// [`StudyError::Study`] if a scene or change does not exist.
    pub fn measure(completed: &Completed, edges: &Edges, extent: Extent, done: &(dyn Fn() + Sync)) -> Result<Self, StudyError> {
        let cells = edges.cells(extent);
        let measured = each(&cells, done, |cell| {
            let mut scenes = completed.file.study.scenes.iter().zip(&completed.prepared);
            let found = scenes.find(|(scene, _)| scene.name == cell.scene);
            let (scene, base) = found.ok_or_else(|| (format!("\"{}\"", cell.scene), "names of scenes of the study"))?;
            let pushed = cell.pushed(base, scene, edges.time_step_s);
            let pushed = pushed.map_err(|found| (found, "changes that the scenes take"))?;
            Ok(measure(base, &pushed))
        });
        let measured = measured.into_iter().collect::<Result<_, _>>();
        let measured = measured.map_err(|(found, allowed)| completed.refuse("output.extremes", found, allowed))?;
        Ok(Self {
            edges: edges.clone(),
            extent,
            cells,
            measured,
            path: completed.file.path.clone(),
        })
    }

    /// Tables and figures by their paths in the results folder; for a part of the grid only its cells.
    ///
    /// # Errors
    /// [`StudyError::Plot`] if a figure cannot be drawn.
    pub fn files(&self) -> Result<Files, StudyError> {
        let (cells, measured) = (&self.cells, &self.measured);
        let part = table::cells(cells, measured, |cell| cell.in_part).into_bytes();
        let mut files = Files::new();
        if self.extent == Extent::Whole {
            files.insert("cells.csv".into(), table::cells(cells, measured, |_| true).into_bytes());
            files.insert("summary.csv".into(), table::summary(measured).into_bytes());
            files.insert("made-by.txt".into(), made_by("cargo xtask reproduce --all", &files));
            for map in &self.edges.maps {
                let png = drawn(&map::drawing(map, cells, measured), &self.path)?;
                files.insert(Path::new(&map.name).with_extension("png"), png);
            }
        }
        // The table of the part of the grid that usually runs.
        files.insert("part/cells.csv".into(), part);
        Ok(in_folder("extremes", files))
    }
}
