//! Any bytes as a record file.
#![no_main]

#[path = "../src/record.rs"]
mod record;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| record::check(bytes));
