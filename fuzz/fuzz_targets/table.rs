//! Any bytes as a table beside records.
#![no_main]

#[path = "../src/table.rs"]
mod table;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let place = tempfile::tempdir().expect("a disk");
    table::check(bytes, place.path());
});
