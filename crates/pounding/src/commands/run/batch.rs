//! `pounding run --records`: the scene under every record of a folder, a line each.

use std::path::Path;

use pounding::studies::{
    Errors, PairOutcome, PairSummary, Prepared, Quantity, Review, Scene, StructureSummary,
    StudyError, digits, read_file,
};
use serde_json::json;

use super::{Arguments, Printed};
use crate::commands::{csv_text, json_text, suite};
use crate::text::{NONE, paragraph, percent, short, table};

/// What became of the scene under one motion in one direction.
type Line = suite::Line<Found>;

/// What is printed of a run.
struct Found {
    /// Peak ground acceleration \[m/s²\], without sign.
    pga: f64,
    /// Largest error, where it was measured.
    error: Option<f64>,
    /// Why it was not, in a word.
    why: &'static str,
    warnings: Vec<String>,
    /// The collisions of all pairs.
    all: PairOutcome,
    structures: Vec<StructureSummary>,
    pairs: Vec<PairSummary>,
}

impl Found {
    fn new(prepared: &Prepared, review: &Review) -> Self {
        let (error, why) = match &review.errors {
            Errors::Measured(errors, _) => (Some(errors.largest(Quantity::All).0), ""),
            Errors::Exact => (None, "exact"),
            Errors::NotMeasured | Errors::Unknown(_) => (None, NONE),
        };
        Self {
            pga: prepared.record().peak().1.abs(),
            error,
            why,
            warnings: review.warnings.iter().map(ToString::to_string).collect(),
            all: PairOutcome::of(review.outcome.collisions.all()),
            structures: StructureSummary::of_run(prepared, review),
            pairs: PairSummary::of_run(prepared, review),
        }
    }

    /// The largest peak displacement of a structure \[m\], without sign.
    fn displacement(&self) -> f64 {
        let peaks = self.structures.iter();
        let peaks = peaks.filter_map(|one| one.peak_displacement_m);
        peaks.map(f64::abs).fold(0.0, f64::max)
    }
}

/// The scene under every record of a folder.
pub(super) fn answer(asked: &Arguments, folder: &Path) -> Result<String, String> {
    let path = &asked.scene;
    let scene: Scene =
        read_file(path).map_err(|error: StudyError| error.in_file(path).to_string())?;
    let directions: &[bool] = if asked.suite.both {
        &[false, true]
    } else {
        &[scene.record.reversed]
    };
    let lines = suite::lines(&scene, folder, directions, |prepared| {
        let review = prepared.review(!asked.model.no_error)?;
        Ok(Found::new(prepared, &review))
    })?;
    Ok(match asked.printed() {
        Printed::Text => text(&scene, &lines),
        Printed::Csv => csv_of(&lines),
        Printed::Json => json_of(&scene, &lines),
    })
}

fn text(scene: &Scene, lines: &[Line]) -> String {
    let mut parts = vec![
        paragraph("Scene", &scene.name),
        runs(scene, lines),
        paragraph("Result", &result(lines)),
    ];
    let refused = suite::left_out(lines);
    if !refused.is_empty() {
        parts.push(paragraph("Left out", &refused.join("\n")));
    }
    parts.push(paragraph("Notes", NOTES));
    parts.join("\n")
}

const NOTES: &str = "Impulse, force and displ.: the largest of all collisions and structures. Error: the largest distance of a \
                     printed number from the exact run; ! marks a run with warnings, which a run of that record alone prints. \
                     --csv has every structure and pair.";

fn runs(scene: &Scene, lines: &[Line]) -> String {
    let header = [
        ["Record", ""],
        ["PGA", "[g]"],
        ["Colli-", "sions"],
        ["First", "[s]"],
        ["Impulse", "[kN·s]"],
        ["Force", "[kN]"],
        ["Displ.", "[mm]"],
        ["Error", ""],
    ];
    let row = |line: &Line| {
        let found = line.found.as_ref().ok()?;
        let PairOutcome {
            collisions,
            first,
            largest,
            peak_force,
            ..
        } = found.all;
        let mark = if found.warnings.is_empty() { "" } else { "!" };
        Some(vec![
            line.name(),
            short(found.pga / scene.record.gravity_m_per_s2),
            collisions.to_string(),
            first.map_or(NONE.into(), |first| {
                digits((first.start * 1e4).round() * 1e-4)
            }),
            largest.map_or(NONE.into(), |largest| short(largest.impulse / 1e3)),
            peak_force.map_or(NONE.into(), |force| short(force / 1e3)),
            short(1e3 * found.displacement()),
            format!("{}{mark}", found.error.map_or(found.why.into(), percent)),
        ])
    };
    table(&header, &lines.iter().filter_map(row).collect::<Vec<_>>())
}

/// Under how many motions they touch, and where hardest.
fn result(lines: &[Line]) -> String {
    let found = lines.iter().filter(|line| line.found.is_ok()).count();
    let hits = lines.iter().filter_map(|line| {
        let largest = line.found.as_ref().ok()?.all.largest?;
        Some((line, largest.impulse))
    });
    let hits: Vec<_> = hits.collect();
    let touch = format!("they touch under {} of {found} motions", hits.len());
    match hits.iter().max_by(|a, b| a.1.total_cmp(&b.1)) {
        None => touch,
        Some((line, impulse)) => {
            let reversed = if line.reversed { ", reversed" } else { "" };
            format!(
                "{touch}\nthe hardest collision is that under {}{reversed}: {} kN·s",
                line.motion,
                short(impulse / 1e3)
            )
        }
    }
}

/// Numbers of a structure with their names, SI units: those of its summary, nothing where there is none.
fn of_structure(one: &StructureSummary) -> Vec<(&'static str, f64)> {
    let numbers = [
        ("peak_displacement_m", one.peak_displacement_m),
        ("peak_displacement_time_s", one.peak_displacement_time_s),
        ("peak_shear_force_n", one.peak_shear_force_n),
        ("peak_shear_force_time_s", one.peak_shear_force_time_s),
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
fn of_pair(one: &PairSummary) -> [(&'static str, Option<f64>); 9] {
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
        ("total_impulse_n_s", Some(one.total_impulse_n_s)),
        ("least_opening_m", Some(one.least_opening_m)),
        ("least_opening_time_s", Some(one.least_opening_time_s)),
    ]
}

/// A row per number of every structure and pair of every run: what, of which, and its value; SI units.
fn csv_of(lines: &[Line]) -> String {
    let header = ["record", "reversed", "of", "quantity", "value", "refused"];
    let rows = lines.iter().flat_map(|line| {
        let row = |of: &str, quantity: &str, value: Option<f64>| {
            let value = value.map_or(String::new(), |value| value.to_string());
            let row = [
                &line.motion,
                &line.reversed.to_string(),
                of,
                quantity,
                &value,
                "",
            ];
            row.map(String::from)
        };
        let found = match &line.found {
            Ok(found) => found,
            Err(reason) => {
                let mut row = row("", "", None);
                row[5].clone_from(reason);
                return vec![row];
            }
        };
        let mut rows = vec![
            row("record", "pga_m_per_s2", Some(found.pga)),
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
    csv_text(std::iter::once(header.map(String::from)).chain(rows))
}

fn json_of(scene: &Scene, lines: &[Line]) -> String {
    let line = |line: &Line| match &line.found {
        Ok(found) => json!({
            "record": line.motion,
            "reversed": line.reversed,
            "pga_m_per_s2": found.pga,
            "largest_error": found.error,
            "warnings": found.warnings,
            "structures": found.structures,
            "pairs": found.pairs,
        }),
        Err(reason) => {
            json!({"record": line.motion, "reversed": line.reversed, "refused": reason})
        }
    };
    json_text(&json!({"scene": scene, "motions": lines.iter().map(line).collect::<Vec<_>>()}))
}
