//! What it saves to model only what a scene requires, on rows of 2 to 1000 structures.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use pounding_scene::Method;
use pounding_studies::{Burden, Burdened};
use serde_json::json;

/// Where the ratios are kept, from the top folder.
const KEPT: &str = "results/savings.csv";
/// The record that shakes the rows, from the top folder.
const RECORD: &str = "studies/records/el-centro-1940-ns-chopra.csv";
/// Lengths of the rows.
const LENGTHS: [usize; 4] = [2, 10, 100, 1000];
/// Runs of each row for as long as this, at least three.
const PATIENCE: Duration = Duration::from_secs(2);

/// Times rows with one burden each beside the lean one, run by run in turn, and prints the ratios of their medians.
pub(super) fn run(root: &Path) -> Result<(), String> {
    let mut csv = String::from("method,structures,burden,wall_time_ratio\n");
    for (name, method) in methods()? {
        for n in LENGTHS {
            let rows: Result<Vec<_>, _> = Burden::ALL
                .iter()
                .map(|burden| Burdened::new(n, method, *burden, &root.join(RECORD)))
                .collect();
            let medians = medians(&rows.map_err(|error| error.to_string())?)?;
            for (burden, median) in Burden::ALL.iter().zip(&medians).skip(1) {
                let ratio = median / medians[0];
                writeln!(csv, "{name},{n},{},{ratio:.2}", burden.name())
                    .expect("a string takes all");
            }
        }
    }
    fs::write(root.join(KEPT), &csv).map_err(|error| format!("{KEPT}: {error}"))?;
    println!(
        "\nWall time beside the lean row (no pairs, elastic, peaks and impulses alone):\n{csv}\nkept in {KEPT}"
    );
    Ok(())
}

fn methods() -> Result<Vec<(&'static str, Method)>, String> {
    let methods = [
        ("exact", json!({"exact": {}})),
        (
            "central difference",
            json!({"central_difference": {"time_step_s": 0.005}}),
        ),
        (
            "Newmark",
            json!({"newmark": {"time_step_s": 0.005, "beta": 0.25, "gamma": 0.5}}),
        ),
    ];
    let method = |(name, value)| {
        Ok((
            name,
            serde_json::from_value(value).map_err(|error| format!("{name}: {error}"))?,
        ))
    };
    methods.into_iter().map(method).collect()
}

/// Median wall time of each row \[s\]; rows take turns, so that what else the machine does meets all of them.
fn medians(rows: &[Burdened]) -> Result<Vec<f64>, String> {
    let mut times = vec![Vec::new(); rows.len()];
    let started = Instant::now();
    while times[0].len() < 3 || started.elapsed() < PATIENCE {
        for (row, times) in rows.iter().zip(&mut times) {
            let start = Instant::now();
            row.run().map_err(|error| error.to_string())?;
            times.push(start.elapsed().as_secs_f64());
        }
    }
    let median = |times: &mut Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    };
    Ok(times.iter_mut().map(median).collect())
}
