//! The lines of a folder of records for programs: CSV and JSON, SI units.

use pounding::report::{PairSummary, SCHEMA_VERSION, StructureSummary};
use pounding::scene::Scene;
use pounding::text::{Cell, csv_text, json_text};
use serde_json::json;

use super::Line;
use crate::commands::suite;

/// Numbers of a structure with their names, SI units: those of its summary, nothing where there is none.
fn of_structure(one: &StructureSummary) -> Vec<(&'static str, f64)> {
    let numbers = [
        ("peak_displacement_m", one.peak_displacement_m),
        ("peak_displacement_time_s", one.peak_displacement_time_s),
        ("peak_shear_force_n", one.peak_shear_force_n),
        ("peak_shear_force_time_s", one.peak_shear_force_time_s),
        ("peak_drift_m", one.peak_drift_m),
        ("peak_drift_time_s", one.peak_drift_time_s),
        (
            "residual_displacement_at_end_m",
            one.residual_displacement_at_end_m,
        ),
        ("residual_drift_at_end_m", one.residual_drift_at_end_m),
        ("peak_acceleration_m_per_s2", one.peak_acceleration_m_per_s2),
        ("peak_acceleration_time_s", one.peak_acceleration_time_s),
        ("ductility", one.ductility),
        ("drift_ratio", one.drift_ratio),
        (
            "transferred_momentum_n_s",
            Some(one.transferred_momentum_n_s),
        ),
    ];
    let numbers = numbers.into_iter();
    numbers
        .filter_map(|(name, value)| Some((name, value?)))
        .collect()
}

/// Numbers of a pair with their names, SI units: fields of its summary, those of a collision after its name.
fn of_pair(one: &PairSummary) -> [(&'static str, Option<f64>); 11] {
    let (first, largest) = (one.first, one.largest);
    [
        ("collisions", Some(one.collisions as f64)),
        ("first_start_s", first.map(|first| first.start_s)),
        ("first_impulse_n_s", first.map(|first| first.impulse_n_s)),
        ("largest_start_s", largest.map(|largest| largest.start_s)),
        (
            "largest_impulse_n_s",
            largest.map(|largest| largest.impulse_n_s),
        ),
        ("peak_force_n", one.peak_force_n),
        ("peak_force_time_s", one.peak_force_time_s),
        ("total_impulse_n_s", Some(one.total_impulse_n_s)),
        ("touching_s", Some(one.touching_s)),
        ("least_opening_m", Some(one.least_opening_m)),
        ("least_opening_time_s", Some(one.least_opening_time_s)),
    ]
}

/// A row per number of every structure and pair of every run: what, of which, and its value; SI units.
pub(super) fn csv(lines: &[Line]) -> String {
    let header = ["record", "reversed", "of", "quantity", "value", "refused"];
    let rows = lines.iter().flat_map(|line| {
        let row = |of: &str, quantity: &str, value: Option<f64>| {
            [
                line.motion.as_str().into(),
                line.reversed.into(),
                of.into(),
                quantity.into(),
                Cell::exact(value),
                Cell::default(),
            ]
        };
        let found = match &line.found {
            Ok(found) => found,
            Err(reason) => {
                let mut row = row("", "", None);
                row[5] = reason.as_str().into();
                return vec![row];
            }
        };
        let mut rows = vec![
            row("record", "pga_m_per_s2", Some(found.pga)),
            row("record", "scale_factor", Some(found.scale)),
            row("run", "largest_error", found.error),
            row("run", "warnings", Some(found.warnings.len() as f64)),
        ];
        for structure in &found.structures {
            let numbers = of_structure(structure).into_iter();
            rows.extend(
                numbers.map(|(quantity, value)| row(&structure.name, quantity, Some(value))),
            );
        }
        for pair in &found.pairs {
            let name = format!("{} – {}", pair.left, pair.right);
            rows.extend(of_pair(pair).map(|(quantity, value)| row(&name, quantity, value)));
        }
        rows
    });
    csv_text(&header, rows)
}

/// The same with everything that a summary has of structures and pairs.
pub(super) fn json(scene: &Scene, lines: &[Line]) -> String {
    let line = |line: &Line| match &line.found {
        Ok(found) => json!({
            "record": line.motion,
            "reversed": line.reversed,
            "direction": suite::direction(line),
            "pga_m_per_s2": found.pga,
            "scale_factor": found.scale,
            "largest_error": found.error,
            "unusual": found.unusual,
            "warnings": found.warnings,
            "structures": found.structures,
            "pairs": found.pairs,
        }),
        Err(reason) => {
            json!({"record": line.motion, "reversed": line.reversed, "refused": reason})
        }
    };
    json_text(&json!({
        "schema_version": SCHEMA_VERSION,
        "scene": scene,
        "motions": lines.iter().map(line).collect::<Vec<_>>(),
    }))
}
