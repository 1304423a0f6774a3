//! What record files hold, as text, CSV and JSON.

use pounding::motion::{Interval, Reading};
use pounding::studies::digits;
use serde_json::{Value, json};

use super::{Found, Line};
use crate::commands::{csv_text, json_text};
use crate::text::{NONE, cut, paragraph, short, table};

/// Paragraphs of one motion, a table of several.
pub(super) fn text(lines: &[Line], gravity: f64) -> String {
    match lines {
        [line] => match &line.found {
            Ok(found) => paragraphs(line, found, gravity),
            Err(reason) => paragraph("Left out", reason),
        },
        lines => several(lines, gravity),
    }
}

fn paragraphs(line: &Line, found: &Found, gravity: f64) -> String {
    let opened = &found.opened;
    let readings: Vec<String> = opened.file.readings().iter().map(reading).collect();
    let mut parts = vec![
        paragraph("File", &line.file.display().to_string()),
        paragraph("Read", &readings.join("\n")),
    ];
    let provenance = opened.file.provenance();
    if !provenance.trim().is_empty() {
        parts.push(paragraph("It says", provenance));
    }
    let record = &opened.record;
    parts.push(paragraph(
        "Record",
        &format!(
            "{} samples, {} s apart, {} s long",
            record.samples().len(),
            record.time_step(),
            digits(record.duration())
        ),
    ));
    parts.push(measures(found, gravity));
    parts.push(paragraph("Notes", NOTES));
    parts.join("\n")
}

const NOTES: &str = "PGV and PGD without correction of the baseline; Arias intensity with g = 9.80665 m/s²; CAV without \
                     threshold; D: while the Arias intensity grows from 5 % to 75 % and to 95 %.";

/// One thing that was read, and where it stood.
fn reading(one: &Reading) -> String {
    let line = one
        .line
        .map_or(String::new(), |line| format!(" (line {line})"));
    format!("{}: {}{line}", one.what, one.found)
}

fn measures(found: &Found, gravity: f64) -> String {
    let measures = &found.measures;
    let (time, peak) = found.opened.record.peak();
    let duration = |interval: Option<Interval>| {
        interval.map_or(NONE.into(), |interval| {
            format!(
                "{} s, from {} s to {} s",
                short(interval.duration()),
                short(interval.start),
                short(interval.end)
            )
        })
    };
    let rows = [
        (
            "PGA",
            format!(
                "{} g = {} m/s² at {} s",
                short(measures.pga / gravity),
                short(peak),
                digits(time)
            ),
        ),
        ("PGV", format!("{} m/s", short(measures.pgv))),
        ("PGD", format!("{} m", short(measures.pgd))),
        ("Arias", format!("{} m/s", short(measures.arias))),
        ("CAV", format!("{} m/s", short(measures.cav))),
        ("D5–75", duration(measures.d5_75)),
        ("D5–95", duration(measures.d5_95)),
    ];
    rows.map(|(name, value)| paragraph(name, &value)).concat()
}

/// A line per motion, and why others are left out.
fn several(lines: &[Line], gravity: f64) -> String {
    let header = [
        ["Record", ""],
        ["Format", ""],
        ["Samples", ""],
        ["Step", "[s]"],
        ["PGA", "[g]"],
        ["PGV", "[m/s]"],
        ["D5–95", "[s]"],
    ];
    let row = |line: &Line| {
        let Found { opened, measures } = line.found.as_ref().ok()?;
        let d5_95 = measures.d5_95.map(|interval| interval.duration());
        Some(vec![
            name(line),
            opened.file.format().name().into(),
            opened.record.samples().len().to_string(),
            digits(opened.record.time_step()),
            short(measures.pga / gravity),
            short(measures.pgv),
            d5_95.map_or(NONE.into(), short),
        ])
    };
    let rows: Vec<_> = lines.iter().filter_map(row).collect();
    let mut parts = vec![table(&header, &rows)];
    let refused: Vec<String> = lines
        .iter()
        .filter_map(|line| line.found.as_ref().err().cloned())
        .collect();
    if !refused.is_empty() {
        parts.push(paragraph("Left out", &refused.join("\n")));
    }
    if lines.iter().any(|line| line.component.is_some()) {
        parts.push(paragraph(
            "Notes",
            "a file with several components has a line for each; --component takes one, by its name",
        ));
    }
    parts.join("\n")
}

/// Letters of a name in the table, which is then no wider than 80 columns.
const NAME: usize = 23;

/// That of the file, cut before the component.
fn name(line: &Line) -> String {
    let name = line.file.file_name().unwrap_or(line.file.as_os_str());
    let file = name.to_string_lossy().into_owned();
    let Some(component) = &line.component else {
        return file;
    };
    let room = NAME.saturating_sub(component.chars().count() + 1).max(6);
    format!("{} {component}", cut(&file, room))
}

/// The numbers of a motion with their names, SI units; nothing where there is none.
fn numbers(found: &Found) -> [(&'static str, Option<f64>); 14] {
    let (record, measures) = (&found.opened.record, &found.measures);
    let start = |interval: Option<Interval>| interval.map(|interval| interval.start);
    let duration = |interval: Option<Interval>| interval.map(|interval| interval.duration());
    [
        ("n_samples", Some(record.samples().len() as f64)),
        ("time_step_s", Some(record.time_step())),
        ("duration_s", Some(record.duration())),
        ("pga_m_per_s2", Some(measures.pga)),
        ("peak_m_per_s2", Some(record.peak().1)),
        ("pga_time_s", Some(record.peak().0)),
        ("pgv_m_per_s", Some(measures.pgv)),
        ("pgd_m", Some(measures.pgd)),
        ("arias_m_per_s", Some(measures.arias)),
        ("cav_m_per_s", Some(measures.cav)),
        ("d5_75_start_s", start(measures.d5_75)),
        ("d5_75_s", duration(measures.d5_75)),
        ("d5_95_start_s", start(measures.d5_95)),
        ("d5_95_s", duration(measures.d5_95)),
    ]
}

/// One row per motion.
pub(super) fn csv_of(lines: &[Line], gravity: f64) -> String {
    let words = ["file", "component", "format", "unit", "gravity_m_per_s2"];
    let found = lines.iter().find_map(|line| line.found.as_ref().ok());
    let names = found.map(numbers).into_iter().flatten();
    let names: Vec<&str> = names.map(|(name, _)| name).collect();
    let header = words.iter().chain(&names).chain(&["refused"]);
    let header: Vec<String> = header.map(ToString::to_string).collect();
    let row = |line: &Line| {
        let mut row = vec![
            line.file.display().to_string(),
            line.component.clone().unwrap_or_default(),
        ];
        match &line.found {
            Ok(found) => {
                row.push(found.opened.file.format().name().into());
                row.push(found.opened.file.unit().name().into());
                row.push(gravity.to_string());
                let value = |value: Option<f64>| value.map_or(String::new(), |one| one.to_string());
                row.extend(numbers(found).map(|(_, one)| value(one)));
                row.push(String::new());
            }
            Err(reason) => {
                row.resize(words.len() + names.len(), String::new());
                row.push(reason.clone());
            }
        }
        row
    };
    csv_text(std::iter::once(header).chain(lines.iter().map(row)))
}

/// Every motion with what was read from which line.
pub(super) fn json_of(lines: &[Line], gravity: f64) -> String {
    let reading = |one: &Reading| json!({"what": one.what, "line": one.line, "found": one.found});
    let line = |line: &Line| {
        let mut all = json!({"file": line.file.display().to_string(), "component": line.component});
        match &line.found {
            Err(reason) => all["refused"] = json!(reason),
            Ok(found) => {
                let file = &found.opened.file;
                let readings = file.readings().iter().map(reading);
                all["format"] = json!(file.format().name());
                all["unit"] = json!(file.unit().name());
                all["readings"] = readings.collect::<Value>();
                all["says"] = json!(file.provenance());
                all["sha256"] = json!(found.opened.sha256);
                for (name, value) in numbers(found) {
                    all[name] = json!(value);
                }
                all["n_samples"] = json!(found.opened.record.samples().len());
            }
        }
        all
    };
    let motions: Vec<Value> = lines.iter().map(line).collect();
    let all = json!({"gravity_m_per_s2": gravity, "motions": motions});
    json_text(&all)
}
