//! Tasks of the project: `cargo xtask reproduce`, `beyond`, `studies`, `verify`, `check`, `bench` and `fuzz`.
#![expect(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program speaks to its user"
)]

mod bench;
mod beyond;
mod check;
mod fuzz;
mod reproduce;
mod results;
mod schedulers;
mod studies;
mod verify;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

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
    /// Format, lints, tests, documentation and `reproduce --check`: what must pass before a change lands.
    Check,
    /// Time every method on the scenes of two structures, with the accuracy of each, and what it saves to model only what
    /// a scene requires, what a floor costs, and scenes side by side; writes ratios into results/wall-time.csv, savings.csv,
    /// storeys.csv, bench/lanes.csv, bench/sweeps.csv and bench/structures.csv; no part of `check`.
    Bench {
        /// Only the savings.
        #[arg(long)]
        savings: bool,
        /// Only what a floor of a building costs in a step, beside one of a row of structures of one storey: two to three minutes.
        #[arg(long, conflicts_with = "savings")]
        storeys: bool,
        /// Only scenes side by side in lanes, and sweeps of them, beside a loop written by hand for AVX-512 and AVX2, and rows of 2 to
        /// 1000 structures: three minutes.
        #[arg(long, conflicts_with_all = ["savings", "storeys"])]
        lanes: bool,
        /// Only the same scenes by other programs (`OpenSees`, `SciPy`, `SUNDIALS`) and compiled loops, which go into a Python environment
        /// beside this program; needs Python 3 and, the first time, the network: some six minutes, no part of the others.
        #[arg(long, conflicts_with_all = ["savings", "storeys", "lanes"])]
        peers: bool,
    },
    /// Run a sweep by `HyperQueue` from the Python package index and compare it with one without; needs Python, no part of `check`.
    Hyperqueue,
    /// Run the same sweep by SLURM on this machine and compare it with one without; needs root and Debian's packages slurm-wlm and munge,
    /// no part of `check`.
    Slurm,
    /// Feed random bytes to every reader, to scene and to sweep files; needs cargo-fuzz, no part of `check`.
    Fuzz {
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
        Task::Beyond {
            records,
            out,
            as_recorded,
        } => beyond::run(&root(), records.as_deref(), out, !as_recorded),
        Task::Studies { names } => studies::run(&root(), &names),
        Task::Verify(asked) => verify::run(&root(), &asked),
        Task::Check => check::run(&root()),
        Task::Bench { savings: true, .. } => bench::savings(&root()),
        Task::Bench { storeys: true, .. } => bench::storeys(&root()),
        Task::Bench { lanes: true, .. } => bench::lanes(&root()),
        Task::Bench { peers: true, .. } => bench::peers(&root()),
        Task::Bench { .. } => bench::run(&root()),
        Task::Hyperqueue => schedulers::hyperqueue(&root()),
        Task::Slurm => schedulers::slurm(&root()),
        Task::Fuzz { seconds } => fuzz::run(&root(), seconds),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The top folder of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("xtask lies in the workspace")
        .to_path_buf()
}
