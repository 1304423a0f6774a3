//! The assertions on every sweep file. It is read, checked and tried, and its first runs run within a budget, or it is refused. There is no
//! panic, and every number is finite unless it does not exist.
//!
//! No file is opened: the scene is part of the sweep, and its motion is a formula. Bytes are tried as JSON, then as TOML.

use std::path::Path;

use pounding_scene::file::RunBudget;
use pounding_scene::{Method, Scene, Source};
use pounding_sweep::{SceneOf, Spread, Sweep, SweepFile, Vary};
use serde_json::Value;

use crate::quick::is_quickly_shaken;

/// The budget of a run.
const BUDGET: RunBudget = RunBudget {
    steps: Some(1e4),
    pieces: Some(1e4),
    seconds: None,
};
/// Largest number of runs of a sweep, and of values of lists and grids that are tried first.
const MOST_RUNS: u64 = 4;
const MOST_VALUES: usize = 20;

/// Reads some bytes as a sweep and runs its beginning.
pub(crate) fn check(bytes: &[u8]) {
    let read = |name| SweepFile::parse(bytes, Path::new(name));
    let file = match read("sweep.json").or_else(|_| read("sweep.toml")) {
        Ok(file) => file,
        Err(refused) => {
            assert!(!refused.to_string().is_empty(), "{refused:?}");
            return;
        }
    };
    if !is_short(&file) {
        return;
    }
    let file = SweepFile {
        budget: Some(BUDGET),
        ..file
    };
    let sweep = match Sweep::of(&file, bytes, Path::new("sweep.json"), None) {
        Ok(sweep) => sweep,
        Err(refused) => {
            assert!(!refused.to_string().is_empty(), "{refused:?}");
            return;
        }
    };
    let batch = sweep.batch(0..sweep.n_runs().min(MOST_RUNS));
    for column in &batch.columns {
        let infinite = column.iter().find(|number| number.is_infinite());
        assert!(infinite.is_none(), "{infinite:?}");
    }
    for reason in batch.failed.iter().flatten() {
        assert!(!reason.is_empty() && !reason.contains("panicked"), "{reason}");
    }
    let rows = String::from_utf8(sweep.rows(&batch)).expect("text");
    assert_eq!(rows.is_empty(), batch.failed.is_empty(), "{rows}");
}

/// Whether the sweep opens no file, has a motion that is quick to make, and does not search for a method.
fn is_short(file: &SweepFile) -> bool {
    let SceneOf::Inline(scene) = &file.scene else {
        return false;
    };
    let text = scene.to_string();
    let Ok(read) = Scene::parse(text.as_bytes(), Path::new("scene.json")) else {
        return false;
    };
    let is_quick = |vary: &Vary| {
        let few = match &vary.spread {
            Spread::Values(values) => {
                let searches = |value: &Value| value.to_string().contains("accuracy");
                values.len() <= MOST_VALUES && !values.iter().any(searches)
            }
            Spread::Grid(grid) => grid.count <= MOST_VALUES as u64,
            Spread::Uniform(_) | Spread::LogUniform(_) | Spread::Normal(_) | Spread::LogNormal(_) => true,
        };
        let given = |field: &String| field.contains("record") || field.contains("budget");
        few && !vary.fields.iter().any(given)
    };
    file.records.is_none()
        && matches!(read.record.source, Source::Generated(_))
        && !matches!(read.method, Method::Accuracy(_))
        && is_quickly_shaken(&read)
        && file.vary.iter().all(is_quick)
}
