//! The trade of error against work on a short ladder: same bytes however it runs, counts and errors as a snapshot.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use insta::assert_snapshot;
use pounding_studies::{Completed, Ladder, Output, StudyFile, Trade};

/// The trade study on a ladder of its own.
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

fn files(n_threads: usize) -> BTreeMap<PathBuf, Vec<u8>> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(n_threads)
        .build()
        .expect("threads");
    pool.install(|| {
        trade(&[0.01, 0.001], &[1e-8, 1e-16])
            .files()
            .expect("figures that can be drawn")
    })
}

/// The scene of the rows on which the routes are further apart than the condition of the result allows. Since the second route has
/// deformations as unknowns, 5e-14 to 5e-13 have become 1e-12 to 8e-12 from the 16th impact on.
const DOUBTFUL: &str = "\"layout C, elastic, stereomechanical\",";

#[test]
fn reference_work_and_errors_on_a_short_ladder() {
    let files = files(2);
    for name in [
        "trade.csv",
        "pareto.csv",
        "exact-or-stepping.csv",
        "reference.csv",
        "collisions.csv",
    ] {
        let text =
            std::str::from_utf8(&files[&Path::new("trade").join(name)]).expect("CSV is text");
        assert_snapshot!(name, text);
    }
    let text =
        |name: &str| String::from_utf8_lossy(&files[&Path::new("trade").join(name)]).into_owned();
    let tables = ["reference.csv", "collisions.csv"].map(text).concat();
    let doubtful = tables.lines().filter(|row| row.ends_with(",no"));
    let of_scene = |row: &&str| row.starts_with(DOUBTFUL);
    let (known, new): (Vec<_>, Vec<_>) = doubtful.partition(of_scene);
    assert!(
        new.is_empty(),
        "two routes further apart than the condition of the result allows: {new:#?}"
    );
    assert_eq!(known.len(), 8, "no longer as doubtful: {known:#?}");
    assert!(files == self::files(1), "one thread gives the same bytes");
}
