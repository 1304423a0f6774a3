//! Any bytes as a scene file.
#![no_main]

#[path = "../src/quick.rs"]
mod quick;
#[path = "../src/scene.rs"]
mod scene;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| scene::check(bytes));
