//! What fuzzing holds record files to, on the seeds that lie in `fuzz/corpus`: so the body of the target compiles, and what
//! was found once stays mended.

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
