//! Some scenes of the campaign of `cargo xtask verify`.

use std::path::Path;
use std::time::Duration;

use pounding_studies::verify::{Campaign, Checked, Summary, Verdict};

fn campaign() -> Campaign {
    Campaign {
        studies: Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies"),
        seed: 7,
        patience: Duration::from_secs(300),
    }
}

/// So many scenes on so many threads.
fn checked(n_scenes: usize, n_threads: usize) -> Vec<Checked> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(n_threads)
        .build()
        .expect("threads");
    let scenes: Vec<usize> = (0..n_scenes).collect();
    pool.install(|| campaign().run(&scenes, &|_| ()))
}

#[test]
#[ignore = "a floor that rattles between two closing neighbours ends otherwise by the two routes; run with --ignored"]
fn reference_random_scenes_are_the_same_by_both_routes() {
    let checked = checked(30, 2);
    let summary = Summary(&checked);
    let bad = checked.iter().filter(|one| !one.is_good());
    let bad: Vec<String> = bad.flat_map(Checked::lines).collect();
    assert!(summary.is_good(), "{}\n{summary}", bad.join("\n"));
    let agree = checked
        .iter()
        .filter(|one| matches!(one.verdict, Verdict::Agrees));
    assert!(agree.count() > 24, "enough that are compared\n{summary}");
    let touches: usize = checked.iter().map(|one| one.touches).sum();
    assert!(touches > 1000, "enough that touches\n{summary}");
}

#[test]
fn limit_a_campaign_does_not_depend_on_threads() {
    let lines = |n_threads| {
        let checked = checked(4, n_threads);
        format!("{:?}\n{}", checked, Summary(&checked))
    };
    assert_eq!(lines(1), lines(2), "one thread and two");
}

#[test]
fn limit_a_scene_is_its_file() {
    for index in 0..200 {
        let scene = campaign().scene(index);
        let text = serde_json::to_string(&scene).expect("a scene is written");
        let read = serde_json::from_str(&text).expect("what is written is a scene");
        assert_eq!(scene, read, "scene {index}");
    }
}
