//! Checks that a change must pass.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Steps that are commands of cargo: purpose, arguments, and an environment variable.
const STEPS: [(&str, &[&str], (&str, &str)); 4] = [
    ("format", &["fmt", "--all", "--", "--check"], ("CARGO_TERM_QUIET", "false")),
    (
        "lints",
        &["clippy", "--workspace", "--all-targets", "--", "--deny", "warnings"],
        ("CARGO_TERM_QUIET", "false"),
    ),
    // A missing snapshot fails here and is not written.
    ("tests", &["test", "--workspace"], ("INSTA_UPDATE", "no")),
    (
        "documentation",
        &["doc", "--workspace", "--no-deps"],
        ("RUSTDOCFLAGS", "--deny warnings"),
    ),
];

/// Checks the dependencies against deny.toml if cargo-deny is installed. Advisories need the network and are not checked.
fn denied(root: &Path, cargo: &OsStr) -> Result<(), String> {
    let deny = |arguments: &[&str]| {
        let mut command = Command::new(cargo);
        command.arg("deny").args(arguments).current_dir(root);
        command
    };
    println!("── dependencies: cargo deny check bans licenses sources");
    let asked = deny(&["--version"]).output();
    if !asked.is_ok_and(|ended| ended.status.success()) {
        println!("   left out: cargo-deny is not installed (cargo install cargo-deny)");
        return Ok(());
    }
    let ended = deny(&["check", "bans", "licenses", "sources"]).status();
    match ended {
        Ok(status) if status.success() => Ok(()),
        _ => Err("dependencies break deny.toml".into()),
    }
}

/// Checks the code with the Rust version of Cargo.toml, if rustup has it.
fn oldest(root: &Path) -> Result<(), String> {
    let version = env!("CARGO_PKG_RUST_VERSION");
    let cargo = |arguments: &[&str]| {
        let mut command = Command::new("rustup");
        command.args(["run", version, "cargo"]).args(arguments);
        command.current_dir(root);
        // A common target folder would rebuild everything for each version.
        command.env("CARGO_TARGET_DIR", root.join("target/oldest"));
        command
    };
    println!("── declared Rust: rustup run {version} cargo check --workspace");
    let asked = cargo(&["--version"]).output();
    if !asked.is_ok_and(|ended| ended.status.success()) {
        println!("   left out: rustup has no Rust {version} (rustup toolchain install {version})");
        return Ok(());
    }
    match cargo(&["check", "--workspace"]).status() {
        Ok(status) if status.success() => Ok(()),
        _ => Err(format!("the code is no Rust {version}, which Cargo.toml declares")),
    }
}

/// Checks that packages below `cargo xtask` have the same features as below the tests. Otherwise they, and all packages above, are built
/// twice.
fn built_once(root: &Path, cargo: &OsStr) -> Result<(), String> {
    let packages = |of: &[&str]| {
        let mut command = Command::new(cargo);
        command.args(["tree", "--prefix", "none", "--format", "{p} {f}"]);
        let output = command.args(of).current_dir(root).output();
        let output = output.map_err(|error| format!("cannot start cargo: {error}"))?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let lines = text.lines().map(|line| line.trim_end_matches(" (*)").to_owned());
        Ok(lines.collect::<BTreeSet<String>>())
    };
    println!("── features: cargo tree --package xtask, and of the workspace");
    if !cfg!(unix) {
        println!("   left out: xtask/Cargo.toml names features of Unix alone");
        return Ok(());
    }
    let tests = packages(&["--workspace", "--edges", "normal,build,dev"])?;
    let own = packages(&["--package", "xtask", "--edges", "normal,build"])?;
    let others: Vec<&str> = own.difference(&tests).map(String::as_str).collect();
    if others.is_empty() {
        return Ok(());
    }
    Err(format!(
        "packages that cargo xtask builds with other features than the tests (give them the same in xtask/Cargo.toml):\n{}",
        others.join("\n")
    ))
}

/// Runs every step and stops at the first that fails.
pub(crate) fn run(root: &Path) -> Result<(), String> {
    println!("── crates, their sizes and arrows: cargo xtask rooms");
    crate::rooms::check(root)?;
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    built_once(root, &cargo)?;
    denied(root, &cargo)?;
    oldest(root)?;
    for (name, arguments, (variable, value)) in STEPS {
        println!("── {name}: cargo {}", arguments.join(" "));
        let started = Instant::now();
        let status = Command::new(&cargo)
            .args(arguments)
            .env(variable, value)
            .current_dir(root)
            .status()
            .map_err(|error| format!("cannot start cargo: {error}"))?;
        if !status.success() {
            return Err(format!("{name} failed; to see it alone: cargo {}", arguments.join(" ")));
        }
        println!("   {name} passed in {:.0} s", started.elapsed().as_secs_f64());
    }
    println!("── promises, in part: cargo xtask torture with few rounds");
    crate::torture::run(root, &crate::torture::Rounds::FEW)?;
    println!("── results: cargo xtask reproduce --check");
    crate::reproduce::run(root, true, pounding_studies::Extent::Part)
}
