//! Tasks of the project: reproduction of its results, and checks of changes.
//!
//! ```text
//! cargo xtask check              # before you hand over
//! cargo xtask reproduce          # if a number could move; then look at the figures
//! cargo xtask studies fragility  # one survey alone
//! ```
//!
//! | Task | Does | Writes |
//! |---|---|---|
//! | `check` | format, lints, rooms, tests, documentation, a part of torture, results | – |
//! | `check --python` | the Python package: wheel, tests, types, notebooks | – |
//! | `check --browser` | the page of `view` in Chromium | – |
//! | `dist` | wheel, sources and a stripped program, tried in a clean environment | `target/dist/` |
//! | `reproduce` | every table and figure of the paper, and the examples | `results/` |
//! | `beyond` | the paper's claims under other ground motions | `results/beyond/`; with `--records` `target/beyond/` |
//! | `studies` | surveys of thousands of exact runs | a folder of `results/` each |
//! | `verify` | random scenes by both routes | `target/verify/` |
//! | `rooms` | the crates, their sizes, and arrows that run up | – |
//! | `bench` | timings | `results/` |
//! | `fuzz` | random bytes for every reader | `fuzz/artifacts/` |
//! | `torture` | kills, races, damage, power failures, full disks: what exit code 0 promises | – |
//! | `hyperqueue`, `slurm` | a sweep by a scheduler, held to the bytes of one without | – |
//!
//! Not in this crate: the results themselves, which `pounding-studies` makes; timings, which `pounding-bench` runs; features for users of
//! the program, which are in `pounding`.
//!
//! Where to start: `check.rs`, the steps of a check; `reproduce.rs` and `results.rs`, the comparison of results by bytes; `rooms.rs`, the
//! rule that arrows between crates run down.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks to its user")]

mod beyond;
mod browser;
mod check;
mod fuzz;
mod python;
mod reproduce;
mod results;
mod rooms;
mod schedulers;
mod step;
mod studies;
mod torture;
mod verify;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::{Parser, Subcommand};
use pounding_studies::Extent;

/// Tasks of the project.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", version)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Run every study and write every table and figure of the paper into results/.
    Reproduce {
        /// Write nothing; fail if results/ differs from a fresh run.
        #[arg(long)]
        check: bool,
        /// Run all extremes instead of the usual part; takes some minutes more.
        #[arg(long)]
        all: bool,
    },
    /// Test the paper's claims under other ground motions in both directions, for its scenes and for buildings of several storeys, and
    /// under weaker shaking. With --records: under every record of a folder.
    Beyond {
        /// A folder of records instead of the motions of studies/beyond.json. Unreadable and vertical records are listed as left out.
        #[arg(long, value_name = "FOLDER")]
        records: Option<PathBuf>,
        /// Folder for the tables and figures [default: results/beyond, or target/beyond with --records].
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Keep the strength of the records instead of scaling them to the peak of the paper's record.
        #[arg(long, requires = "records")]
        as_recorded: bool,
    },
    /// Run the surveys of studies/, each with thousands of exact runs, and write their folders of results/. Takes a minute or two each; not
    /// part of `check`.
    Studies {
        /// Names of surveys, such as required-gap [default: all].
        names: Vec<String>,
    },
    /// Run random scenes by the exact method and by the second route, which share only the scene, and report scenes that disagree, fail or
    /// do not end. Not part of `check`, except for some scenes in the tests.
    Verify(verify::Asked),
    /// Print the crates with their lines, public names and dependencies. Fails if an arrow runs up or modules use each other in a circle.
    Rooms,
    /// Check a change before it lands: format, lints, rooms, tests, documentation and `reproduce --check`.
    Check {
        /// Instead build the Python package and run its tests, types and notebooks; needs Python 3.10 or newer and its package index.
        #[arg(long)]
        python: bool,
        /// Instead test the page of `view` in a browser; needs chromium, chromium-driver, Python 3.10 or newer and its package index.
        #[arg(long, conflicts_with = "python")]
        browser: bool,
    },
    /// Pack the wheel of Python, its sources and a stripped program into target/dist, and try them in a clean environment. Needs Python;
    /// not part of `check`.
    Dist,
    /// Time every method on the scenes of two structures, with its accuracy, and also lean models, floors of buildings and scenes in lanes.
    /// Writes ratios into results/wall-time.csv, savings.csv, storeys.csv, bench/lanes.csv, bench/buildings.csv, bench/sweeps.csv and
    /// bench/structures.csv. Not part of `check`.
    #[command(disable_help_flag = true)]
    Bench {
        /// A single kind of timing, such as --lanes; --help lists all.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Run a sweep by `HyperQueue` from the Python package index and compare it with a sweep without a scheduler. Needs Python; not part of
    /// `check`.
    Hyperqueue,
    /// Run this sweep by SLURM on this machine and compare it with a sweep without a scheduler. Needs root and Debian's packages slurm-wlm
    /// and munge; not part of `check`.
    Slurm,
    /// Kill, race, damage and cut off sweeps, and check docs/exit-code-0.md. Takes some minutes; `check` runs a part of it. Complete only
    /// as root on Linux with ext4, strace and Python.
    Torture(torture::Rounds),
    /// Feed random bytes to every reader, to folders of records, to scene files and to sweep files. Needs cargo-fuzz; not part of `check`.
    Fuzz {
        /// A single target, such as record [default: all].
        #[arg(long)]
        target: Option<String>,
        /// Duration of each target in seconds.
        #[arg(long, default_value_t = 60)]
        seconds: u32,
    },
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().task {
        Task::Reproduce { check, all } => {
            let extent = if all { Extent::Whole } else { Extent::Part };
            reproduce::run(&root(), check, extent)
        }
        Task::Beyond { records, out, as_recorded } => beyond::run(&root(), records.as_deref(), out, !as_recorded),
        Task::Studies { names } => studies::run(&root(), &names),
        Task::Verify(asked) => verify::run(&root(), &asked),
        Task::Rooms => rooms::check(&root()),
        Task::Check { python: true, .. } => python::check(&root()),
        Task::Check { browser: true, .. } => browser::check(&root()),
        Task::Check { .. } => check::run(&root()),
        Task::Dist => python::dist(&root()),
        Task::Bench { arguments } => bench(&root(), &arguments),
        Task::Hyperqueue => schedulers::hyperqueue(&root()),
        Task::Slurm => schedulers::slurm(&root()),
        Task::Torture(rounds) => torture::run(&root(), &rounds),
        Task::Fuzz { target, seconds } => fuzz::run(&root(), seconds, target.as_deref()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// Runs the timings, which are a separate crate that nothing else builds.
fn bench(root: &Path, arguments: &[String]) -> Result<(), String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["run", "--package", "pounding-bench", "--"])
        .args(arguments)
        .current_dir(root)
        .status()
        .map_err(|error| format!("cannot start cargo: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err("the timings failed".into())
    }
}

/// The top folder of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("xtask lies in the workspace")
        .to_path_buf()
}
