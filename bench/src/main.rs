//! Timings: methods, what lean models save, what a floor costs, scenes in lanes, other programs. `cargo xtask bench` runs it.
//!
//! ```text
//! cargo xtask bench            # every method, then all of the table but the other programs
//! cargo xtask bench --savings  # one kind alone
//! ```
//!
//! | Option | Times | Ratios in `results/` |
//! |---|---|---|
//! | none | every method on the scenes of two structures, with its accuracy | `wall-time.csv`, and all below except `--peers` |
//! | `--savings` | rows with one burden each against the leanest row | `savings.csv` |
//! | `--storeys` | a floor of a building against a structure of one storey | `storeys.csv` |
//! | `--lanes` | long rows, scenes in SIMD lanes, sweeps | `bench/`: `structures.csv`, `lanes.csv`, `buildings.csv`, `sweeps.csv` |
//! | `--peers` | the same scenes by other programs and compiled loops | `bench/`: `peers.csv`, `peers-levels.csv` |
//!
//! Only ratios are kept, each taken in one run on one machine. `--peers` needs Python 3 and packages from its index.
//!
//! Not in this crate: whether numbers are right, which tests check, and error against counted work, which `cargo xtask reproduce` measures.
//! `cargo xtask check` times nothing. `docs/performance.md` explains the results.
//!
//! Where to start: `measure.rs`, timing and tables; `scenes.rs`, the scenes of lanes, of the loop by hand and of other programs;
//! `lanes/by_hand.rs`, the loop that lanes are compared with; `peers/entrants.rs`, the list of other programs. `benches/` has the loops
//! that criterion times.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program speaks to its user")]

mod lanes;
mod measure;
mod peers;
mod rows;
mod savings;
mod scenes;
mod setting;
mod storeys;
mod structures;
mod sweeps;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::Parser;
use measure::{Outcome, RatioTable};
use pounding_studies::{Timed, Trade};
use serde_json::Value;

/// Where criterion puts what it measures, from the top folder.
const MEASURED: &str = "target/criterion";
const TABLE: RatioTable = RatioTable {
    path: "results/wall-time.csv",
    title: "Work and wall time over those of the central difference method",
    header: "scene,method,setting,error,accurate_enough,work_ratio,wall_time_ratio",
};

/// Kinds of timings; by default all except the peers.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask bench", bin_name = "cargo xtask bench")]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an option of the command line, and they exclude each other"
)]
struct Arguments {
    /// Only the savings of models without unneeded features.
    #[arg(long)]
    savings: bool,
    /// Only the cost of a floor of a building in a step.
    #[arg(long, conflicts_with = "savings")]
    storeys: bool,
    /// Only scenes in lanes, sweeps of them, and rows of many structures.
    #[arg(long, conflicts_with_all = ["savings", "storeys"])]
    lanes: bool,
    /// Only a comparison with other programs and compiled loops.
    #[arg(long, conflicts_with_all = ["savings", "storeys", "lanes"])]
    peers: bool,
}

fn main() -> ExitCode {
    let root: PathBuf = [env!("CARGO_MANIFEST_DIR"), ".."].iter().collect();
    let outcome = match Arguments::parse() {
        Arguments { savings: true, .. } => savings::run(&root),
        Arguments { storeys: true, .. } => storeys::run(&root),
        Arguments { lanes: true, .. } => lanes(&root),
        Arguments { peers: true, .. } => peers::run(&root),
        Arguments { .. } => run(&root),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// Times every method on the scenes of two structures and keeps ratios to the central difference method; then runs all other timings.
fn run(root: &Path) -> Outcome<()> {
    // The profile of the program, which is built already.
    let bench = ["bench", "--profile", "dev", "--package", "pounding-bench"];
    cargo(root, &[&bench[..], &["--bench", "methods"]].concat())?;
    let study = root.join("studies/trade.json");
    let (completed, trade) = Trade::of_two_structures(&study)?;
    let timed = trade.timed(&completed);
    let mut lines = Vec::new();
    for one in &timed {
        let base = timed.iter().find(|other| other.scene == one.scene && other.is_base);
        let base = base.ok_or_else(|| format!("{}: no central difference method", one.scene))?;
        let wall_time = seconds(one, root)? / seconds(base, root)?;
        let work = one.work as f64 / base.work as f64;
        let enough = if one.holds { "yes" } else { "no" };
        let Timed {
            scene,
            method,
            setting,
            error,
            ..
        } = one;
        lines.push(format!(
            "\"{scene}\",{method},{setting},{error:.1e},{enough},{work:.3},{wall_time:.3}"
        ));
    }
    TABLE.write(root, &lines)?;
    savings::run(root)?;
    storeys::run(root)?;
    lanes(root)
}

/// Times scenes in lanes, sweeps of them, and rows of many structures.
fn lanes(root: &Path) -> Outcome<()> {
    structures::run(root)?;
    lanes::run(root)?;
    sweeps::run(root)
}

/// Runs cargo in the top folder.
fn cargo(root: &Path, arguments: &[&str]) -> Outcome<()> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    let command = command.args(arguments).current_dir(root);
    let status = command.env("CRITERION_HOME", root.join(MEASURED)).status()?;
    if status.success() {
        return Ok(());
    }
    Err(format!("cargo {} failed", arguments.join(" ")).into())
}

/// Wall time of a run \[s\].
fn seconds(timed: &Timed<'_>, root: &Path) -> Outcome<f64> {
    let of_run = root.join(MEASURED).join(timed.scene).join(timed.method);
    let path = of_run.join("new/estimates.json");
    let fail = |error: &str| format!("{}: {error}", path.display());
    let text = fs::read_to_string(&path).map_err(|error| fail(&error.to_string()))?;
    let estimates: Value = serde_json::from_str(&text)?;
    let median = estimates["median"]["point_estimate"].as_f64();
    Ok(1e-9 * median.ok_or_else(|| fail("no median in it"))?)
}
