//! Any bytes as a sweep file.
#![no_main]

#[path = "../src/quick.rs"]
mod quick;
#[path = "../src/sweep.rs"]
mod sweep;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| sweep::check(bytes));
