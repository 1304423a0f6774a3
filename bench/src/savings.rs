//! Savings of models without unneeded features, on rows of 2 to 1000 structures.

use std::path::Path;
use std::time::Duration;

use pounding_scene::Method;
use pounding_studies::{Burden, Burdened};
use serde_json::json;

use crate::measure::{Outcome, Table, in_turn, median};
use crate::setting::RECORD;

const TABLE: Table = Table {
    path: "results/savings.csv",
    title: "Wall time beside the lean row (no pairs, elastic, peaks and impulses alone)",
    header: "method,structures,burden,wall_time_ratio",
};
/// Lengths of the rows.
const LENGTHS: [usize; 4] = [2, 10, 100, 1000];
/// Least number and duration of runs of each row.
const ROUNDS: (usize, Duration) = (3, Duration::from_secs(2));

/// Times rows with a single additional feature against the lean row, in turn, and keeps the ratios of their medians.
pub(super) fn run(root: &Path) -> Outcome<()> {
    let methods = [
        ("exact", json!({"exact": {}})),
        ("central difference", json!({"central_difference": {"time_step_s": 0.005}})),
        ("Newmark", json!({"newmark": {"time_step_s": 0.005, "beta": 0.25, "gamma": 0.5}})),
    ];
    let burdens = Burden::ALL;
    let order: Vec<usize> = (0..burdens.len()).collect();
    let mut lines = Vec::new();
    for (name, method) in methods {
        let method: Method = serde_json::from_value(method)?;
        for n in LENGTHS {
            let row = |burden| Burdened::new(n, method, burden, &root.join(RECORD));
            let rows = burdens.map(row).into_iter().collect::<Result<Vec<_>, _>>()?;
            let times = in_turn(&order, ROUNDS, |one| Ok(rows[one].run().map(drop)?))?;
            let medians: Vec<f64> = times.into_iter().map(median).collect();
            for (burden, time) in burdens.iter().zip(&medians).skip(1) {
                let ratio = time / medians[0];
                lines.push(format!("{name},{n},{},{ratio:.2}", burden.name()));
            }
        }
    }
    TABLE.write(root, &lines)
}
