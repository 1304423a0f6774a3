//! Results have the same bytes after every run and on any number of threads. Studies with a separate folder are tested in `trade.rs`,
//! `laws.rs` and `beyond.rs`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use pounding_studies::Studies;

/// Every file of a reproduction on `n_threads` threads.
fn files(n_threads: usize) -> BTreeMap<PathBuf, Vec<u8>> {
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().expect("threads");
    let made = pool.install(|| {
        assert_eq!(rayon::current_num_threads(), n_threads, "the pool is the one in use");
        Studies::read(&studies)
            .expect("readable studies")
            .only(|file| !["trade", "laws", "extremes", "beyond"].contains(&file.id.as_str()))
            .with_noisy_runs(2)
            .reproduce(&|| ())
    });
    made.expect("studies that run").files
}

#[test]
fn limit_bytes_do_not_depend_on_threads_or_on_the_run() {
    let once = files(2);
    let of_kind = |kind: &str| {
        let is_kind = |path: &&PathBuf| path.extension().is_some_and(|found| found == kind);
        once.keys().filter(is_kind).count()
    };
    assert_eq!(
        (of_kind("csv"), of_kind("png")),
        (16, 24),
        "seven tables, five converged ones, agreement, claims, slips and combinations; figures"
    );
    let again = files(1);
    assert!(once.keys().eq(again.keys()), "one thread makes the same files");
    for (path, bytes) in &once {
        // No assert_eq: it would print the picture.
        assert!(*bytes == again[path], "{} with one thread", path.display());
    }
}
