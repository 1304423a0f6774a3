//! Timings: methods, what lean models save, what a floor costs, scenes in lanes, other programs. `cargo xtask bench` runs it.
//!
//! ```text
//! cargo xtask bench            # every method, then all of the table but the other programs
//! cargo xtask bench --savings  # one kind alone
//! ```
//!
//! | Option | Times | Ratios in `results/` |
//! |---|---|---|
//! | none | every method on the scenes of two structures, with its accuracy | `wall-time.csv`, and those below but `--peers` |
//! | `--savings` | rows with one burden each against the leanest row | `savings.csv` |
//! | `--storeys` | a floor of a building against a structure of one storey | `storeys.csv` |
//! | `--lanes` | long rows, scenes in SIMD lanes, sweeps | `bench/`: `structures.csv`, `lanes.csv`, `buildings.csv`, `sweeps.csv` |
//! | `--peers` | the same scenes by other programs and compiled loops | `bench/`: `peers.csv`, `peers-levels.csv` |
//!
//! Only ratios are kept, each taken in one run on one machine. `--peers` needs Python 3 and packages from its index.
//!
//! Left out: whether numbers are right, which tests ask, and error against counted work, which `cargo xtask reproduce` measures.
//! `cargo xtask check` times nothing. `docs/performance.md` explains the results.
//!
//! Where to start: `setting.rs`, the scenes of lanes and sweeps; `lanes/by_hand`, the loops that lanes are measured by;
//! `peers/entrants.rs`, the list of other programs. `benches/` holds the loops that criterion times.
#![expect(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program speaks to its user"
)]

mod lanes;
mod peers;
mod savings;
mod setting;
mod storeys;
mod structures;
mod sweeps;

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::Parser;
use pounding_studies::{Timed, Trade};
use serde_json::Value;

/// Where criterion puts what it measures, from the top folder.
const MEASURED: &str = "target/criterion";
/// Where the ratios are kept, from the top folder.
const KEPT: &str = "results/wall-time.csv";

/// What is timed; all but the peers without an option.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask bench", bin_name = "cargo xtask bench")]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an option of the command line, and they exclude each other"
)]
struct Arguments {
    /// Only what it saves to model only what a scene requires.
    #[arg(long)]
    savings: bool,
    /// Only what a floor of a building costs in a step.
    #[arg(long, conflicts_with = "savings")]
    storeys: bool,
    /// Only scenes side by side in lanes, sweeps of them, and rows of many structures.
    #[arg(long, conflicts_with_all = ["savings", "storeys"])]
    lanes: bool,
    /// Only the same scenes by other programs and compiled loops.
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

/// Times every method on the scenes of two structures and prints ratios to the central difference method.
fn run(root: &Path) -> Result<(), String> {
    let home = root.join(MEASURED);
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    // The profile of the program: it is built already.
    let arguments = [
        "bench",
        "--profile",
        "dev",
        "--package",
        "pounding-bench",
        "--bench",
        "methods",
    ];
    let status = Command::new(cargo)
        .args(arguments)
        .env("CRITERION_HOME", &home)
        .current_dir(root)
        .status()
        .map_err(|error| format!("cannot start cargo: {error}"))?;
    if !status.success() {
        return Err("the benchmark failed".into());
    }
    let study = root.join("studies/trade.json");
    let (completed, trade) = Trade::of_two_structures(&study).map_err(|error| error.to_string())?;
    let timed = trade.timed(&completed);
    let csv = ratios(&timed, &home)?;
    fs::write(root.join(KEPT), &csv).map_err(|error| format!("{KEPT}: {error}"))?;
    println!("\n{csv}\nkept in {KEPT}\n\n{}", comparison(&timed, &home)?);
    savings::run(root)?;
    storeys::run(root)?;
    lanes(root)
}

/// Times scenes side by side, sweeps of them, and rows of many structures.
fn lanes(root: &Path) -> Result<(), String> {
    structures::run(root)?;
    lanes::run(root)?;
    sweeps::run(root)
}

/// The run of the same scene that others are compared with.
fn base<'a>(timed: &'a [Timed<'a>], scene: &str) -> Result<&'a Timed<'a>, String> {
    let mut of_scene = timed.iter().filter(|other| other.scene == scene);
    of_scene
        .find(|other| other.is_base)
        .ok_or_else(|| format!("{scene}: no central difference method"))
}

/// For each scene, what the exact method needs for 1e-6 of what the central difference method needs for 1 %.
fn comparison(timed: &[Timed<'_>], home: &Path) -> Result<String, String> {
    let mut text = String::from("Exact method for 1e-6 against central difference for 1 %:\n");
    for exact in timed.iter().filter(|one| one.is_exact) {
        let base = base(timed, exact.scene)?;
        let work = exact.work as f64 / base.work as f64;
        let wall_time = seconds(exact, home)? / seconds(base, home)?;
        let held = |one: &Timed<'_>| if one.holds { "" } else { ", not held" };
        writeln!(
            text,
            "  {}: {work:.3} of the work, {wall_time:.3} of the wall time (errors {:.1e}{} and {:.1e}{}); a piece takes as \
             long as {:.0} force evaluations",
            exact.scene,
            exact.error,
            held(exact),
            base.error,
            held(base),
            wall_time / work
        )
        .expect("a string takes all");
    }
    Ok(text)
}

/// Ratios of work and wall time to the central difference method of the same scene, as CSV.
fn ratios(timed: &[Timed<'_>], home: &Path) -> Result<String, String> {
    let mut csv =
        String::from("scene,method,setting,error,accurate_enough,work_ratio,wall_time_ratio\n");
    for one in timed {
        let base = base(timed, one.scene)?;
        let wall_time = seconds(one, home)? / seconds(base, home)?;
        let work = one.work as f64 / base.work as f64;
        let enough = if one.holds { "yes" } else { "no" };
        writeln!(
            csv,
            "\"{}\",{},{},{:.1e},{enough},{work:.3},{wall_time:.3}",
            one.scene, one.method, one.setting, one.error
        )
        .expect("a string takes all");
    }
    Ok(csv)
}

/// Wall time of a run \[s\].
fn seconds(timed: &Timed<'_>, home: &Path) -> Result<f64, String> {
    let path = home
        .join(timed.scene)
        .join(timed.method)
        .join("new/estimates.json");
    let fail = |error: String| format!("{}: {error}", path.display());
    let text = fs::read_to_string(&path).map_err(|error| fail(error.to_string()))?;
    let estimates: Value = serde_json::from_str(&text).map_err(|error| fail(error.to_string()))?;
    let median = estimates["median"]["point_estimate"].as_f64();
    median
        .map(|nanoseconds| 1e-9 * nanoseconds)
        .ok_or_else(|| fail("no median in it".into()))
}
