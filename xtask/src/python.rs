//! The Python package: build, tests and packing.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::step::step;

/// The package, from the top folder.
const PACKAGE: &str = "crates/python";
/// Packages that its tests need.
const TESTS: [&str; 12] = [
    "maturin>=1.9.4,<2",
    "numpy",
    "pandas",
    "pandas-stubs",
    "polars",
    "pyarrow",
    "matplotlib",
    "pytest",
    "mypy",
    "nbclient",
    "nbformat",
    "ipykernel",
];
/// Second routes without wheels for every machine, and the tests that are skipped without them.
const SECOND_ROUTES: [(&str, &str); 2] = [
    ("openseespy", "the notebook beside OpenSees"),
    ("obspy", "miniSEED and SAC as ObsPy writes them"),
];
/// Type stubs of the package, compared with generated ones.
const STUBS: &str = "python/pounding/_pounding.pyi";

/// How a wheel is built.
#[derive(Clone, Copy)]
enum Built {
    /// Built like the workspace, next to it, so that common dependencies are shared.
    ToCheck,
    ToPublish,
}

impl Built {
    fn profile(self) -> &'static str {
        match self {
            Self::ToCheck => "dev",
            Self::ToPublish => "release",
        }
    }

    /// Folder of the build, from the top folder.
    fn target(self) -> &'static str {
        match self {
            Self::ToCheck => "target",
            Self::ToPublish => "target/python",
        }
    }
}

/// Builds the wheel in a separate environment, and runs tests, types and notebooks.
pub(crate) fn check(root: &Path) -> Result<(), String> {
    let python = environment(root, "python")?;
    let mut install = pip(&python, &["install", "--quiet"]);
    step(install.args(TESTS), root)?;
    for (package, test) in SECOND_ROUTES {
        let install = &mut pip(&python, &["install", "--quiet", package]);
        if step(install.arg("--only-binary=:all:"), root).is_err() {
            println!("   left out: {test}, for {package} has no wheel for this machine");
        }
    }
    let program = program(root)?;
    let wheel = wheel(root, &python, Built::ToCheck)?;
    let reinstall = ["install", "--quiet", "--force-reinstall", "--no-deps"];
    step(pip(&python, &reinstall).arg(&wheel), root)?;
    stubs(root, &python)?;
    let package = root.join(PACKAGE);
    let mut tests = Command::new(&python);
    tests.args(["-m", "pytest", "--quiet"]);
    step(tests.env("POUNDING_PROGRAM", program), &package)
}

/// Builds the program together with its tests, which use the same features, and returns its path.
pub(crate) fn program(root: &Path) -> Result<PathBuf, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let build = ["test", "--workspace", "--no-run", "--test", "program"];
    step(Command::new(cargo).args(build), root)?;
    Ok(root.join("target/debug/pounding"))
}

/// Packs wheel, source distribution and a stripped program into `target/dist`, and tries them in an empty environment.
pub(crate) fn dist(root: &Path) -> Result<(), String> {
    let python = environment(root, "dist")?;
    step(pip(&python, &["install", "--quiet"]).arg(TESTS[0]), root)?;
    let out = root.join("target/dist");
    fresh(&out)?;
    let wheel = wheel(root, &python, Built::ToPublish)?;
    copy(&wheel, &out)?;
    let mut pack = maturin(root, &python, Built::ToPublish);
    pack.args(["sdist", "--out"]).arg(&out);
    step(&mut pack, &root.join(PACKAGE))?;
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut build = Command::new(&cargo);
    build.args(["build", "--release", "--package", "pounding", "--config"]);
    build.arg("profile.release.strip=true");
    step(&mut build, root)?;
    copy(&root.join("target/release/pounding"), &out)?;
    let clean = environment(root, "clean")?;
    let name = wheel.file_name().unwrap_or_default();
    step(pip(&clean, &["install", "--quiet"]).arg(out.join(name)), root)?;
    let mut tried = Command::new(clean);
    step(tried.args(["-c", TRIED]), &out)?;
    step(Command::new(out.join("pounding")).arg("--version"), &out)?;
    // As a registry would build them; cargo refuses files that are not committed.
    step(Command::new(&cargo).args(["package", "--workspace", "--locked"]), root)?;
    println!("packed into {}", out.display());
    Ok(())
}

/// A run that fails if the wheel does not work.
const TRIED: &str = "import pounding
pulse = pounding.formula('ricker', amplitude=3.0, frequency=1.0, time_step=0.01)
weak, stiff = (pounding.sdof(mass=mass, period=period) for mass, period in [(75e3, 1.2), (3e6, 0.3)])
run = pounding.row(weak, stiff, gap=0.03, restitution=0.65).run(pulse)
assert len(run.table('impacts')) > 0
print(run)";

/// Compares the types of the package with those of the library; writes them if they are missing.
fn stubs(root: &Path, python: &Path) -> Result<(), String> {
    let made = root.join("target/python-stubs");
    fresh(&made)?;
    let mut make = maturin(root, python, Built::ToCheck);
    make.args(["generate-stubs", "--quiet", "--profile", Built::ToCheck.profile(), "--out"]);
    step(make.arg(&made), &root.join(PACKAGE))?;
    let fail = |path: &Path, error: &std::io::Error| format!("{}: {error}", path.display());
    let new = found(&made, "pyi")?;
    let new = fs::read_to_string(&new).map_err(|error| fail(&new, &error))?;
    let known = root.join(PACKAGE).join(STUBS);
    match fs::read_to_string(&known) {
        Ok(text) if text == new => Ok(()),
        Ok(_) => Err(format!(
            "{}: found other types than those of the library; delete it, and this command writes it anew",
            known.display()
        )),
        Err(_) => {
            fs::write(&known, new).map_err(|error| fail(&known, &error))?;
            Err(format!("{}: was missing, and is written: look at it", known.display()))
        }
    }
}

/// The Python of an environment below `target`, created if it is missing.
pub(crate) fn environment(root: &Path, name: &str) -> Result<PathBuf, String> {
    let home = root.join("target").join(format!("venv-{name}"));
    let python = home.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !python.exists() {
        let base = if cfg!(windows) { "python" } else { "python3" };
        step(Command::new(base).args(["-m", "venv"]).arg(&home), root)?;
    }
    Ok(python)
}

/// Builds the wheel and returns its path.
fn wheel(root: &Path, python: &Path, built: Built) -> Result<PathBuf, String> {
    let out = root.join("target/wheels");
    fresh(&out)?;
    let mut build = maturin(root, python, built);
    build.args(["build", "--quiet", "--profile", built.profile(), "--out"]);
    step(build.arg(&out), &root.join(PACKAGE))?;
    found(&out, "whl")
}

fn maturin(root: &Path, python: &Path, built: Built) -> Command {
    let mut command = Command::new(python);
    command.args(["-m", "maturin"]);
    command.env("CARGO_TARGET_DIR", root.join(built.target()));
    command
}

pub(crate) fn pip(python: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(python);
    command.args(["-m", "pip"]).args(arguments);
    command.env("PIP_DISABLE_PIP_VERSION_CHECK", "1");
    command
}

/// The file with this ending below a folder.
fn found(folder: &Path, ending: &str) -> Result<PathBuf, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for path in entries.flatten().map(|entry| entry.path()) {
        if path.is_dir() {
            if let Ok(inside) = found(&path, ending) {
                return Ok(inside);
            }
        } else if path.extension().is_some_and(|found| found == ending) {
            return Ok(path);
        }
    }
    Err(format!("{}: holds no .{ending}", folder.display()))
}

/// An empty folder.
fn fresh(folder: &Path) -> Result<(), String> {
    let fail = |error: std::io::Error| format!("{}: {error}", folder.display());
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(fail)?;
    }
    fs::create_dir_all(folder).map_err(fail)
}

fn copy(file: &Path, folder: &Path) -> Result<(), String> {
    let to = folder.join(file.file_name().unwrap_or_default());
    fs::copy(file, &to).map_err(|error| format!("{}: {error}", to.display()))?;
    Ok(())
}
