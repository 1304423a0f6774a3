//! The assertions of the fuzz target for record files on the seeds in `fuzz/corpus`: the body of the target compiles, and found faults stay
//! fixed.

use std::fs;
use std::path::Path;

#[path = "../../../../fuzz/src/record.rs"]
mod record;

#[test]
fn issue_every_seed_is_read_or_refused() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/record");
    let seeds = fs::read_dir(folder).expect("the corpus is there");
    let seeds: Vec<_> = seeds.map(|seed| seed.expect("a file").path()).collect();
    assert!(seeds.len() > 100, "{} seeds", seeds.len());
    for seed in seeds {
        record::check(&fs::read(&seed).expect("a seed"));
    }
}
