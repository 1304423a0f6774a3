//! The page of `view` in a real browser: Debian's `chromium`, driven by Selenium.

use std::path::Path;
use std::process::Command;

use crate::python::{environment, pip, program};
use crate::step::step;

/// The tests, from the top folder.
const TESTS: &str = "crates/pounding/browser";
/// Programs that the tests start.
const NEEDED: [&str; 2] = ["chromium", "chromedriver"];

/// Builds the program and looks at its page.
pub(crate) fn check(root: &Path) -> Result<(), String> {
    for needed in NEEDED {
        let asked = Command::new(needed).arg("--version").output();
        if !asked.is_ok_and(|ended| ended.status.success()) {
            return Err(format!(
                "{needed} is not to be had (Debian: apt-get install chromium chromium-driver)"
            ));
        }
    }
    let python = environment(root, "browser")?;
    step(&mut pip(&python, &["install", "--quiet", "pytest", "selenium>=4,<5"]), root)?;
    let mut tests = Command::new(&python);
    tests.args(["-m", "pytest", "--quiet", "-p", "no:cacheprovider", TESTS]);
    step(tests.env("POUNDING_PROGRAM", program(root)?), root)
}
