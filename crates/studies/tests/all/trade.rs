//! The trade of error against work on a short ladder: counts and errors as a snapshot, whatever the threads.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use pounding_scene::Ladder;
use pounding_studies::{Completed, Output, StudyFile, Trade};

/// Runs the trade study on another ladder.
fn trade(time_steps_s: &[f64], tolerances: &[f64]) -> Trade {
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let mut file = StudyFile::read(&studies.join("trade.json")).expect("a readable study");
    let ladder = Ladder {
        time_steps_s: time_steps_s.to_vec(),
        tolerances: tolerances.to_vec(),
    };
    file.study.output = Output::Trade(ladder.clone());
    let completed = Completed::run(file, &|| ()).expect("a study that runs");
    Trade::measure(&completed, &ladder, &|| ()).expect("a ladder that fits")
}

/// Files on one thread; `cargo xtask reproduce --check` compares those of all threads.
fn files() -> BTreeMap<PathBuf, Vec<u8>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("threads");
    pool.install(|| trade(&[0.01, 0.001], &[1e-8, 1e-16]).files().expect("figures that can be drawn"))
}

#[test]
fn reference_work_and_errors_on_a_short_ladder() {
    let files = files();
    for name in [
        "trade.csv",
        "pareto.csv",
        "exact-or-stepping.csv",
        "reference.csv",
        "collisions.csv",
    ] {
        let text = std::str::from_utf8(&files[&Path::new("trade").join(name)]).expect("CSV is text");
        assert_snapshot!(name, text);
    }
    for name in ["reference.csv", "collisions.csv"] {
        let text = String::from_utf8_lossy(&files[&Path::new("trade").join(name)]).into_owned();
        let doubtful: Vec<_> = text.lines().filter(|row| row.ends_with(",no")).collect();
        assert!(
            doubtful.is_empty(),
            "two routes further apart than the condition of the result allows: {doubtful:#?}"
        );
    }
}
