//! Any bytes as a folder of records: names, copies, links.
#![no_main]

#[path = "../src/folder.rs"]
mod folder;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let place = tempfile::tempdir().expect("a disk");
    folder::check(bytes, place.path());
});
