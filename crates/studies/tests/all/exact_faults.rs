//! Scenes in which an independent check found a wrong, endless or failed run of the exact method. Both routes agree on them now.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use pounding_scene::{Scene, Simulation};
use pounding_studies::verify::{Campaign, Checked, Verdict};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/exact_faults")
}

#[test]
fn issue_scenes_that_the_exact_method_got_wrong_agree_by_both_routes() {
    let campaign = Campaign {
        studies: folder(),
        seed: 0,
        patience: Duration::from_secs(300),
    };
    let mut scenes: Vec<_> = fs::read_dir(folder())
        .expect("the folder of scenes")
        .map(|entry| entry.expect("a file").path())
        .filter(|path| path.extension().is_some_and(|end| end == "json"))
        .collect();
    scenes.sort();
    assert_eq!(scenes.len(), 13, "{scenes:?}");
    for (index, path) in scenes.iter().enumerate() {
        let scene = Scene::read(path).expect("a scene");
        let checked: Checked = campaign.check(index, &scene, &folder());
        let agrees = matches!(checked.verdict, Verdict::Agrees);
        assert!(agrees, "{}: {:#?}", path.display(), checked.lines());
        let residual = checked.residual.expect("the run ended");
        assert!(residual < 1e-12, "{}: {residual:e}", path.display());
    }
}

#[test]
fn issue_the_peak_of_a_force_that_jumps_at_an_impact() {
    // The method printed 8.950 MN; the check's own integrator has 11.494 MN.
    let scene = Scene::read(&folder().join("peak_force_missed_at_jump.json")).expect("a scene");
    let run = Simulation::new(&scene, &*folder())
        .and_then(|scene| scene.run(None))
        .expect("it runs");
    let peak = run.collisions.all().iter().filter_map(|one| one.peak_force).fold(0.0, f64::max);
    assert!((peak - 11.494e6).abs() < 500.0, "{peak}");
}
