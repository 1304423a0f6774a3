//! Any bytes as an archive of records.
#![no_main]

#[path = "../src/archive.rs"]
mod archive;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| archive::check(bytes));
