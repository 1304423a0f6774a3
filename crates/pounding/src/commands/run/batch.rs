//! `pounding run --records`: the scene under every record of a folder, a line each.

use std::path::Path;

use pounding::solver::Collision;
use pounding::studies::{
    Errors, Motion, Outcome, Prepared, Quantity, Review, Scene, Structure, StudyError, digits,
    read_file,
};
use rayon::prelude::*;
use serde_json::{Value, json};

use super::{Arguments, Printed};
use crate::progress::Progress;
use crate::summary::peak_force;
use crate::text::{NONE, paragraph, percent, short, table};

/// What became of the scene under one motion in one direction.
struct Line {
    motion: String,
    reversed: bool,
    found: Result<Found, String>,
}

/// A run and what is printed of it.
struct Found {
    /// Peak ground acceleration \[m/s²\], without sign.
    pga: f64,
    outcome: Outcome,
    /// Largest error, where it was measured.
    error: Option<f64>,
    /// Why it was not, in a word.
    why: &'static str,
    warnings: Vec<String>,
}

impl Found {
    fn new(prepared: &Prepared, review: Review) -> Self {
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
            outcome: review.outcome,
        }
    }

    /// Number of collisions, the first one, and the largest impulse \[N·s\] and force \[N\].
    fn collisions(&self) -> (usize, Option<&Collision>, f64, Option<f64>) {
        let all = self.outcome.collisions.all();
        let first = all.iter().min_by(|a, b| a.start.total_cmp(&b.start));
        let impulse = all.iter().map(|one| one.impulse).fold(0.0, f64::max);
        (all.len(), first, impulse, peak_force(all))
    }
}

/// The scene under every record of a folder.
pub(super) fn answer(asked: &Arguments, folder: &Path) -> Result<String, String> {
    let path = &asked.scene;
    let scene: Scene =
        read_file(path).map_err(|error: StudyError| error.in_file(path).to_string())?;
    let lines = lines(&scene, &super::super::motions(folder)?, asked);
    if let Some(reason) = all_refused(&lines) {
        return Err(format!(
            "none of the records in {} shakes the row; the first: {reason}",
            folder.display()
        ));
    }
    Ok(match asked.printed() {
        Printed::Text => text(&scene, &lines),
        Printed::Csv => csv_of(&scene, &lines),
        Printed::Json => json_of(&scene, &lines),
    })
}

/// The first reason, where no run succeeded.
fn all_refused(lines: &[Line]) -> Option<&str> {
    let refused = lines.iter().filter_map(|line| line.found.as_ref().err());
    let first = refused.clone().next()?;
    (refused.count() == lines.len()).then_some(first)
}

fn lines(scene: &Scene, motions: &[Motion], asked: &Arguments) -> Vec<Line> {
    let progress = Progress::new();
    let directions: &[bool] = if asked.suite.both {
        &[false, true]
    } else {
        &[scene.record.reversed]
    };
    let cases: Vec<_> = motions
        .iter()
        .flat_map(|motion| directions.iter().map(move |reversed| (motion, *reversed)))
        .collect();
    let line = |&(motion, reversed): &(&Motion, bool)| {
        let found = motion.shake(scene, reversed).and_then(|prepared| {
            let review = prepared.review(!asked.model.no_error)?;
            Ok(Found::new(&prepared, review))
        });
        progress.step(cases.len());
        Line {
            motion: motion.name(),
            reversed,
            found: found.map_err(|error| error.reason()),
        }
    };
    cases.par_iter().map(line).collect()
}

/// The largest peak displacement of a structure \[m\], without sign.
fn displacement(scene: &Scene, outcome: &Outcome) -> f64 {
    let peaks = (0..scene.structures.len()).map(|index| outcome.peaks.of(index));
    peaks
        .map(|peaks| peaks.displacement.value.abs())
        .fold(0.0, f64::max)
}

fn text(scene: &Scene, lines: &[Line]) -> String {
    let mut parts = vec![
        paragraph("Scene", &scene.name),
        runs(scene, lines),
        paragraph("Result", &result(lines)),
    ];
    let mut refused: Vec<String> = lines
        .iter()
        .filter_map(|line| Some(format!("{}: {}", line.motion, line.found.as_ref().err()?)))
        .collect();
    // A file is refused in both directions for one reason.
    refused.dedup();
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
        let (count, first, impulse, force) = found.collisions();
        let mark = if found.warnings.is_empty() { "" } else { "!" };
        let reversed = if line.reversed { " rev." } else { "" };
        Some(vec![
            format!("{}{reversed}", line.motion),
            short(found.pga / scene.record.gravity_m_per_s2),
            count.to_string(),
            first.map_or(NONE.into(), |first| {
                digits((first.start * 1e4).round() * 1e-4)
            }),
            if count == 0 {
                NONE.into()
            } else {
                short(impulse / 1e3)
            },
            force.map_or(NONE.into(), |force| short(force / 1e3)),
            short(1e3 * displacement(scene, &found.outcome)),
            format!("{}{mark}", found.error.map_or(found.why.into(), percent)),
        ])
    };
    table(&header, &lines.iter().filter_map(row).collect::<Vec<_>>())
}

/// Under how many motions they touch, and where hardest.
fn result(lines: &[Line]) -> String {
    let found: Vec<_> = lines
        .iter()
        .filter_map(|line| Some((line, line.found.as_ref().ok()?.collisions())))
        .collect();
    let touch = found.iter().filter(|(_, (count, ..))| *count > 0);
    let touch = format!(
        "they touch under {} of {} motions",
        touch.count(),
        found.len()
    );
    let hardest = found.iter().max_by(|a, b| a.1.2.total_cmp(&b.1.2));
    match hardest.filter(|(_, (count, ..))| *count > 0) {
        None => touch,
        Some((line, (_, _, impulse, _))) => {
            let reversed = if line.reversed { ", reversed" } else { "" };
            let hardest = short(impulse / 1e3);
            format!(
                "{touch}\nthe hardest collision is that under {}{reversed}: {hardest} kN·s",
                line.motion
            )
        }
    }
}

/// Numbers of a structure, with their names: SI units.
fn of_structure(scene: &Scene, index: usize, outcome: &Outcome) -> Vec<(&'static str, f64)> {
    let momentum = ("transferred_momentum_n_s", outcome.momentum.of(index));
    let Structure::Sdof(sdof) = &scene.structures[index] else {
        return vec![momentum];
    };
    let peaks = outcome.peaks.of(index);
    let mut numbers = vec![
        ("peak_displacement_m", peaks.displacement.value),
        ("peak_displacement_time_s", peaks.displacement.time),
        ("peak_shear_force_n", peaks.restoring_force.value),
    ];
    let yields = sdof
        .yield_force_n
        .map(|force| force / sdof.stiffness_n_per_m);
    numbers.extend(yields.map(|yields| ("ductility", peaks.displacement.value.abs() / yields)));
    let height = sdof.height_m;
    numbers.extend(height.map(|height| ("drift_ratio", peaks.displacement.value.abs() / height)));
    numbers.push(momentum);
    numbers
}

/// Numbers of a pair, with their names: SI units; nothing where there is none.
fn of_pair(pair: usize, outcome: &Outcome) -> [(&'static str, Option<f64>); 5] {
    let all = outcome.collisions.all().iter();
    let mine: Vec<_> = all.filter(|one| one.pair == pair).collect();
    let largest = |value: fn(&Collision) -> Option<f64>| {
        let values = mine.iter().filter_map(|one| value(one));
        values.max_by(f64::total_cmp)
    };
    let first = mine.first();
    [
        ("collisions", Some(mine.len() as f64)),
        ("first_s", first.map(|first| first.start)),
        ("first_impulse_n_s", first.map(|first| first.impulse)),
        ("largest_impulse_n_s", largest(|one| Some(one.impulse))),
        ("peak_force_n", peak_force(mine.iter().copied())),
    ]
}

/// A row per structure and pair of every run: what, of which, and its value; SI units.
fn csv_of(scene: &Scene, lines: &[Line]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut write = |row: [&str; 6]| writer.write_record(row).expect("memory takes all");
    write(["record", "direction", "of", "quantity", "value", "refused"]);
    for line in lines {
        let direction = if line.reversed {
            "reversed"
        } else {
            "as recorded"
        };
        let found = match &line.found {
            Ok(found) => found,
            Err(reason) => {
                write([&line.motion, direction, "", "", "", reason]);
                continue;
            }
        };
        let mut number = |of: &str, quantity: &str, value: Option<f64>| {
            let value = value.map_or(String::new(), |value| value.to_string());
            write([&line.motion, direction, of, quantity, &value, ""]);
        };
        number("record", "pga_m_per_s2", Some(found.pga));
        number("run", "largest_error", found.error);
        number("run", "warnings", Some(found.warnings.len() as f64));
        for (index, structure) in scene.structures.iter().enumerate() {
            for (quantity, value) in of_structure(scene, index, &found.outcome) {
                number(structure.name(), quantity, Some(value));
            }
        }
        for pair in 0..scene.contacts.as_ref().map_or(0, Vec::len) {
            for (quantity, value) in of_pair(pair, &found.outcome) {
                number(&names(scene, pair), quantity, value);
            }
        }
    }
    let bytes = writer.into_inner().expect("memory takes all");
    String::from_utf8(bytes).expect("text goes in")
}

fn names(scene: &Scene, pair: usize) -> String {
    let [left, right] = [pair, pair + 1].map(|index| scene.structures[index].name());
    format!("{left} – {right}")
}

fn json_of(scene: &Scene, lines: &[Line]) -> String {
    let of = |numbers: Vec<(&'static str, Option<f64>)>| -> Value {
        let numbers = numbers.into_iter();
        numbers
            .map(|(name, value)| (name.to_string(), json!(value)))
            .collect::<serde_json::Map<_, _>>()
            .into()
    };
    let line = |line: &Line| {
        let found = match &line.found {
            Ok(found) => found,
            Err(reason) => {
                return json!({"record": line.motion, "reversed": line.reversed, "refused": reason});
            }
        };
        let structure = |index: usize| {
            let numbers = of_structure(scene, index, &found.outcome);
            let mut value = of(numbers
                .into_iter()
                .map(|(name, value)| (name, Some(value)))
                .collect());
            value["name"] = json!(scene.structures[index].name());
            value
        };
        let pair = |pair: usize| {
            let mut value = of(of_pair(pair, &found.outcome).to_vec());
            value["name"] = json!(names(scene, pair));
            value
        };
        json!({
            "record": line.motion,
            "reversed": line.reversed,
            "pga_m_per_s2": found.pga,
            "largest_error": found.error,
            "warnings": found.warnings,
            "structures": (0..scene.structures.len()).map(structure).collect::<Vec<_>>(),
            "pairs": (0..scene.contacts.as_ref().map_or(0, Vec::len)).map(pair).collect::<Vec<_>>(),
        })
    };
    let all = json!({"scene": scene.name, "motions": lines.iter().map(line).collect::<Vec<_>>()});
    let text = serde_json::to_string_pretty(&all).expect("plain data");
    format!("{text}\n")
}
