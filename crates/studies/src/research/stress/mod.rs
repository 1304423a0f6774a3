//! Scenes pushed to the edge, each number of each run classified: what is exact, what is refused, what is wrong, and
//! whether the program says so.
//!
//! Stepping methods are measured by the exact one, and the exact one by the second route. "Silently wrong" is a number
//! that is more than 10 % off in a run that ends, is not refused, and warns of nothing that concerns it.

mod class;
mod map;
mod measure;
mod table;

use crate::study::stress::{Cell, Edges, Extent};
use crate::{Completed, StudyError};
use pounding_scene::parallel;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use measure::{Measured, measure};

/// What becomes of every scene at the edge.
#[derive(Debug)]
pub struct Extremes {
    edges: Edges,
    extent: Extent,
    cells: Vec<Cell>,
    measured: Vec<Measured>,
    path: PathBuf,
}

impl Extremes {
    /// Runs every method on every scene at the edge; `done` is called after each scene.
    ///
    /// # Errors
    /// [`StudyError::Study`] for a scene or change that does not exist.
    pub fn measure(completed: &Completed, edges: &Edges, extent: Extent, done: &(dyn Fn() + Sync)) -> Result<Self, StudyError> {
        let cells = edges.cells(&completed.file, extent)?;
        let measured = parallel::try_each(&cells, |cell| {
            let (index, _) = cell.scene;
            let base = &completed.prepared[index];
            let scene = &completed.file.study.scenes[index];
            let pushed = cell.pushed(base, scene, edges.time_step_s);
            let measured = pushed.map(|pushed| measure(base, &pushed));
            done();
            measured
        });
        let measured = measured.map_err(|found| completed.refuse("output.extremes", found, "changes that the scenes take"))?;
        Ok(Self {
            edges: edges.clone(),
            extent,
            cells,
            measured,
            path: completed.file.path.clone(),
        })
    }

    /// Number of times that [`Self::measure`] calls `done`.
    pub(crate) fn n_runs(edges: &Edges, extent: Extent) -> usize {
        edges.n_cells(extent)
    }

    /// Tables and figures by their path in the results folder; of a part of the grid its cells alone.
    ///
    /// # Errors
    /// [`StudyError::Plot`] for a figure that cannot be drawn.
    pub fn files(&self) -> Result<BTreeMap<PathBuf, Vec<u8>>, StudyError> {
        let folder = Path::new("extremes");
        let part = table::cells(&self.cells, &self.measured, |cell| cell.in_part);
        let mut files = BTreeMap::from([(folder.join(PART), part.into_bytes())]);
        if self.extent == Extent::Part {
            return Ok(files);
        }
        let cells = table::cells(&self.cells, &self.measured, |_| true);
        let summary = table::summary(&self.measured);
        files.insert(folder.join("made-by.txt"), made_by(&cells, &summary).into_bytes());
        files.insert(folder.join("cells.csv"), cells.into_bytes());
        files.insert(folder.join("summary.csv"), summary.into_bytes());
        for map in &self.edges.maps {
            let png = map::png(map, &self.cells, &self.measured);
            let png = png.map_err(|source| StudyError::Plot {
                path: self.path.clone(),
                source,
            })?;
            files.insert(folder.join(&map.name).with_extension("png"), png);
        }
        Ok(files)
    }
}

/// The table of the part of the grid that is usually run.
const PART: &str = "part/cells.csv";

/// The command that makes the whole, and the hashes by which the committed tables are known to be its.
fn made_by(cells: &str, summary: &str) -> String {
    let hash = |text: &str| Sha256::digest(text.as_bytes());
    format!(
        "cargo xtask reproduce --all\nSHA-256 of cells.csv: {:x}\nSHA-256 of summary.csv: {:x}\n",
        hash(cells),
        hash(summary)
    )
}
