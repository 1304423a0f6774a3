//! Wall time of the methods: criterion measures, this compares.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use pounding_studies::{Timed, Trade};
use serde_json::Value;

/// Where criterion puts what it measures, from the top folder.
const MEASURED: &str = "target/criterion";
/// Where the ratios are kept, from the top folder.
const KEPT: &str = "results/wall-time.csv";

/// Times every method on the scenes of two structures and prints ratios to the central difference method.
pub(crate) fn run(root: &Path) -> Result<(), String> {
    let home = root.join(MEASURED);
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    // The profile of the program: it is built already.
    let arguments = [
        "bench",
        "--profile",
        "dev",
        "--package",
        "pounding-studies",
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
    let csv = ratios(&trade.timed(&completed), &home)?;
    fs::write(root.join(KEPT), &csv).map_err(|error| format!("{KEPT}: {error}"))?;
    println!("\n{csv}\nkept in {KEPT}");
    Ok(())
}

/// Ratios of work and wall time to the central difference method of the same scene, as CSV.
fn ratios(timed: &[Timed<'_>], home: &Path) -> Result<String, String> {
    let mut csv =
        String::from("scene,method,setting,error,accurate_enough,work_ratio,wall_time_ratio\n");
    for one in timed {
        let of_scene = |other: &&Timed<'_>| other.scene == one.scene && other.is_base;
        let base = timed
            .iter()
            .find(of_scene)
            .ok_or("a scene without the central difference method")?;
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
