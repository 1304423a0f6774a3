//! The page of `view` in a real browser: Debian's `chromium`, driven by Selenium.

use std::path::Path;
use std::process::Command;

use crate::python::{environment, pip, program};
use crate::step::step;

/// The page, from the top folder.
const PAGE: &str = "crates/pounding/assets/view/main.js";
/// How its types are checked.
const TYPED: [&str; 14] = [
    "exec",
    "--yes",
    "--package=typescript@5",
    "--",
    "tsc",
    "--noEmit",
    "--allowJs",
    "--checkJs",
    "--target",
    "es2023",
    "--lib",
    "es2023,dom,dom.iterable",
    "--moduleResolution",
    "bundler",
];
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
    types(root)?;
    let python = environment(root, "browser")?;
    step(&mut pip(&python, &["install", "--quiet", "pytest", "selenium>=4,<5"]), root)?;
    let mut tests = Command::new(&python);
    tests.args(["-m", "pytest", "--quiet", "-p", "no:cacheprovider", TESTS]);
    step(tests.env("POUNDING_PROGRAM", program(root)?), root)
}

/// Checks the types of the page where npm and its registry are to be had.
fn types(root: &Path) -> Result<(), String> {
    let npm = |arguments: &[&str]| {
        let mut command = Command::new("npm");
        command.args(arguments).current_dir(root);
        command
    };
    let asked = npm(&["view", "typescript@5", "name"]).output();
    if !asked.is_ok_and(|ended| ended.status.success()) {
        println!("   left out: the types of the page, for npm or its registry is not to be had");
        return Ok(());
    }
    step(npm(&TYPED).args(["--module", "es2022", PAGE]), root)
}
