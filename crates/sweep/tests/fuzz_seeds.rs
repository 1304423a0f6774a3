//! Fuzz checks of scene files on the seeds in `fuzz/corpus`: the body of the target compiles, and former findings stay fixed.

use std::fs;
use std::path::Path;

use pounding_scene::Scene;
use pounding_sweep::SweepFile;

#[path = "../../../fuzz/src/quick.rs"]
mod quick;
#[path = "../../../fuzz/src/scene.rs"]
mod scene;
#[path = "../../../fuzz/src/sweep.rs"]
mod sweep;

#[test]
fn issue_every_seed_of_a_sweep_runs_or_is_refused() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/sweep");
    let mut n_sweeps = 0;
    for seed in fs::read_dir(folder).expect("the corpus is there") {
        let path = seed.expect("a file").path();
        let bytes = fs::read(&path).expect("a seed");
        sweep::check(&bytes);
        // A file named after its format is a sweep.
        if path.extension().is_some() {
            SweepFile::parse(&bytes, &path).unwrap_or_else(|refused| panic!("{refused}"));
            n_sweeps += 1;
        }
    }
    assert!(n_sweeps > 3, "{n_sweeps} sweeps");
}

#[test]
fn issue_every_seed_runs_or_is_refused() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/scene");
    let mut n_toml = 0;
    for seed in fs::read_dir(folder).expect("the corpus is there") {
        let path = seed.expect("a file").path();
        let bytes = fs::read(&path).expect("a seed");
        scene::check(&bytes);
        // A file named after its format is a scene.
        let Some(ending) = path.extension() else {
            continue;
        };
        if let Err(refused) = Scene::parse(&bytes, &path) {
            panic!("{refused}");
        }
        n_toml += usize::from(ending == "toml");
    }
    assert!(n_toml > 5, "{n_toml} in TOML");
}
