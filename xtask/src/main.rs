//! Tasks of the project: what makes its results anew, and what must pass before a change lands.
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
//! Left out: the results themselves, which `pounding-studies` makes; timings, which `pounding-bench` runs; and what users of the program
//! need, which is in `pounding`.
//!
//! Where to start: `check.rs`, the steps of a check; `reproduce.rs` and `results.rs`, how results are compared by bytes; `rooms.rs`,
//! the rule that arrows between crates run down.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks to its user")]

mod beyond;
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
        /// Write nothing; fail when results/ is not what a fresh run gives.
        #[arg(long)]
        check: bool,
        /// Run the whole of the extremes, too, and not the usual part of it alone: some minutes more.
        #[arg(long)]
        all: bool,
    },
    /// Ask the paper's claims under other ground motions in both directions, of its scenes, of buildings of several storeys, and
    /// under weaker shaking; with --records under every record of a folder of your own.
    Beyond {
        /// A folder of records instead of the motions of studies/beyond.json; those that cannot be read, and vertical ones, are listed as left out.
        #[arg(long, value_name = "FOLDER")]
        records: Option<PathBuf>,
        /// Folder for the tables and figures; without it results/beyond, and target/beyond with --records.
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Leave the records as strong as they are, instead of scaling them to the peak of the paper's.
        #[arg(long, requires = "records")]
        as_recorded: bool,
    },
    /// Run the surveys of studies/, one question asked of thousands of exact runs each, and write their folders of results/: a
    /// minute or two each; no part of `check`.
    Studies {
        /// Names of surveys, such as required-gap; all without one.
        names: Vec<String>,
    },
    /// Run random scenes by the exact method and by the second route, which share nothing but the scene, and say what disagrees, fails
    /// or does not end; no part of `check`, but for some scenes among the tests.
    Verify(verify::Asked),
    /// Print the crates with their lines, public names and what they use; fails where an arrow runs up or modules use each other in a
    /// circle.
    Rooms,
    /// Format, lints, rooms, tests, documentation and `reproduce --check`: what must pass before a change lands.
    Check {
        /// Instead build the Python package and run its tests, types and notebooks; needs Python 3.10 or newer and its package index.
        #[arg(long)]
        python: bool,
    },
    /// Pack the wheel of Python, its sources and a stripped program into target/dist, and try them in a clean environment; needs
    /// Python, no part of `check`.
    Dist,
    /// Time every method on the scenes of two structures, with the accuracy of each, and what it saves to model only what
    /// a scene requires, what a floor costs, and scenes side by side; writes ratios into results/wall-time.csv, savings.csv,
    /// storeys.csv, bench/lanes.csv, bench/buildings.csv, bench/sweeps.csv and bench/structures.csv; no part of `check`.
    #[command(disable_help_flag = true)]
    Bench {
        /// What is timed alone, such as --lanes; --help names all.
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Run a sweep by `HyperQueue` from the Python package index and compare it with one without; needs Python, no part of `check`.
    Hyperqueue,
    /// Run the same sweep by SLURM on this machine and compare it with one without; needs root and Debian's packages slurm-wlm and munge,
    /// no part of `check`.
    Slurm,
    /// Kill, race, damage and cut off sweeps, and hold them to docs/exit-code-0.md; some minutes, no part of `check`, whose tests hold a
    /// part of it. As root on Linux with ext4, strace and Python it leaves nothing out.
    Torture(torture::Rounds),
    /// Feed random bytes to every reader, to folders of records, to scene and to sweep files; needs cargo-fuzz, no part of `check`.
    Fuzz {
        /// The one target that runs, such as record; all without it.
        #[arg(long)]
        target: Option<String>,
        /// How long each target runs, in seconds.
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
        Task::Check { python: true } => python::check(&root()),
        Task::Check { python: false } => check::run(&root()),
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

/// Runs the timings, which are a crate of their own: nothing else builds it.
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
