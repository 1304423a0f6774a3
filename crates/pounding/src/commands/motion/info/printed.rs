//! What record files hold, as text, CSV and JSON.

use pounding::assess::{LeftOutReason, Suite};
use pounding::motion::{Interval, Reading};
use pounding::text::{Cell, csv_text, digits, json_text};
use serde_json::{Value, json};

use super::{Found, Line};
use crate::text::{NONE, cut, paragraph, percent, short, table};

/// Paragraphs of one motion, a table of several.
pub(super) fn text(lines: &[Line], suite: &Suite, gravity: f64) -> String {
    match lines {
        [line] => match &line.found {
            Ok(found) => paragraphs(line, found, gravity),
            Err(refused) => paragraph("Left out", &refused.to_string()),
        },
        lines => several(lines, suite, gravity),
    }
}

fn paragraphs(line: &Line, found: &Found, gravity: f64) -> String {
    let opened = &found.opened;
    let readings: Vec<String> = opened.file().readings().iter().map(reading).collect();
    let mut parts = vec![
        paragraph("File", &line.path.display().to_string()),
        paragraph("Read", &readings.join("\n")),
    ];
    let provenance = opened.file().provenance();
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
    parts.push(paragraph("Direction", &direction(found)));
    let unusual: Vec<String> = opened.file().unusual().iter().map(ToString::to_string).collect();
    if !unusual.is_empty() {
        parts.push(paragraph("Unusual", &unusual.join("\n")));
    }
    parts.push(measures(found, gravity));
    if let Some(drift) = found.drift {
        let left = format!(
            "{} m/s on average over the last tenth, {} of PGV; {DRIFT}",
            short(drift.velocity),
            percent(drift.share)
        );
        parts.push(paragraph("Drift", &left));
    }
    parts.push(paragraph("Notes", NOTES));
    parts.join("\n")
}

const NOTES: &str = "PGV and PGD without correction of the baseline; Arias intensity with g = 9.80665 m/s²; CAV without \
                     threshold; D: while the Arias intensity grows from 5 % to 75 % and to 95 %.";

/// How a motion lies, or why it shakes no row.
fn direction(found: &Found) -> String {
    match &found.placed {
        Ok((Some(_), _)) => "horizontal".into(),
        Ok((None, _)) => "not told, by the file or by its name: it counts as horizontal".into(),
        Err(reason) => format!("shakes no row of a folder: {}", reason.sentence()),
    }
}

/// One thing that was read, and where it stood.
fn reading(one: &Reading) -> String {
    let line = one.line.map_or(String::new(), |line| format!(" (line {line})"));
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
            format!("{} g = {} m/s² at {} s", short(measures.pga / gravity), short(peak), digits(time)),
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

/// A line per motion, and what became of the files.
fn several(lines: &[Line], suite: &Suite, gravity: f64) -> String {
    let file = &lines[0].path;
    let of_one_file = lines.iter().all(|line| line.path == *file);
    let mut parts = Vec::new();
    if of_one_file {
        let formats = lines.iter().filter_map(|line| line.found.as_ref().ok());
        let format = formats.map(|found| found.opened.file().format().name()).next();
        parts.push(format!(
            "{}{}",
            paragraph("File", &file.display().to_string()),
            paragraph("Format", format.unwrap_or(NONE))
        ));
    }
    parts.push(table_of(lines, gravity, of_one_file));
    let said = suite.said(true).join("\n");
    parts.push(paragraph("Records", &said));
    let unusual: Vec<String> = lines.iter().flat_map(|line| unusual(line, of_one_file)).collect();
    if !unusual.is_empty() {
        parts.push(paragraph("Unusual", &unusual.join("\n")));
    }
    let drifting = |line: &&Line| line.found.as_ref().is_ok_and(|found| found.drift.is_some());
    let drifting: Vec<String> = lines.iter().filter(drifting).map(|line| name(line, of_one_file)).collect();
    if !drifting.is_empty() {
        parts.push(paragraph("Drift", &format!("{}: {DRIFT}", drifting.join("; "))));
    }
    if of_one_file {
        parts.push(paragraph(
            "Notes",
            "--component takes one, by its name, a part of it, or its number",
        ));
    } else if lines.iter().any(|line| line.component.is_some()) {
        parts.push(paragraph(
            "Notes",
            "a file with several components has a line for each; --component takes one, by its name, a part of it, or its \
             number",
        ));
    }
    parts.join("\n")
}

/// How a motion lies, for a program; `None` if nothing tells.
fn word(found: &Found) -> Option<&'static str> {
    match &found.placed {
        Ok((direction, _)) => direction.map(|_| "horizontal"),
        Err(reason) => reason.kind.is_vertical().then_some("vertical"),
    }
}

/// What looks wrong in a motion, behind its name.
fn unusual(line: &Line, of_one_file: bool) -> Vec<String> {
    let found = line.found.iter();
    let unusual = found.flat_map(|found| found.opened.file().unusual());
    unusual.map(|one| format!("{}: {one}", name(line, of_one_file))).collect()
}

/// The numbers of each motion that is read; the peak with the time at which it is.
fn table_of(lines: &[Line], gravity: f64, of_one_file: bool) -> String {
    let header = [
        [if of_one_file { "Component" } else { "Record" }, ""],
        ["Samples", ""],
        ["Step", "[s]"],
        ["Unit", ""],
        ["PGA", "[g]"],
        ["at", "[s]"],
        ["PGV", "[m/s]"],
        ["D5–95", "[s]"],
    ];
    let row = |line: &Line| {
        let Found { opened, measures, .. } = line.found.as_ref().ok()?;
        let d5_95 = measures.d5_95.map(|interval| interval.duration());
        let (time, _) = opened.record.peak();
        Some(vec![
            name(line, of_one_file),
            opened.record.samples().len().to_string(),
            digits(opened.record.time_step()),
            opened.file().unit().symbol().into(),
            short(measures.pga / gravity),
            digits(time),
            short(measures.pgv),
            d5_95.map_or(NONE.into(), short),
        ])
    };
    let rows: Vec<_> = lines.iter().filter_map(row).collect();
    table(&header, &rows)
}

/// What a velocity at the end tells, and what to do.
const DRIFT: &str = "the ground does not come to rest: an offset of the baseline, or a record cut short; PGV and PGD are \
                     those of the drift. A straight line (--detrend linear) or a high-pass (--band-pass) in `motion convert` \
                     takes an offset away, in a scene `detrend` or `band_pass`";

/// Letters of a name in the table, which is then no wider than 80 columns.
const NAME: usize = 21;

/// That of the component where there is one file, else of the file, cut before the component.
fn name(line: &Line, of_one_file: bool) -> String {
    let path = &line.path;
    let name = path.file_name().unwrap_or(path.as_os_str());
    let file = name.to_string_lossy().into_owned();
    match &line.component {
        None => file,
        Some(component) if of_one_file => component.clone(),
        Some(component) => {
            let room = NAME.saturating_sub(component.chars().count() + 1).max(6);
            format!("{} {component}", cut(&file, room))
        }
    }
}

/// The numbers of a motion with their names, SI units; nothing where there is none.
fn numbers(found: &Found) -> [(&'static str, Option<f64>); 15] {
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
        ("drift_m_per_s", found.drift.map(|drift| drift.velocity)),
    ]
}

/// One row per motion.
pub(super) fn csv_of(lines: &[Line], gravity: f64) -> String {
    let words = ["file", "component", "direction", "event", "format", "unit", "gravity_m_per_s2"];
    let found = lines.iter().find_map(|line| line.found.as_ref().ok());
    let names = found.map(numbers).into_iter().flatten();
    let names: Vec<&str> = names.map(|(name, _)| name).collect();
    let header = words.iter().chain(&names).chain(&["left_out", "refused"]);
    let header: Vec<&str> = header.copied().collect();
    let row = |line: &Line| {
        let mut row: Vec<Cell> = vec![
            line.path.display().to_string().into(),
            line.component.clone().unwrap_or_default().into(),
        ];
        match &line.found {
            Ok(found) => {
                let event = found.placed.as_ref().ok();
                row.push(word(found).unwrap_or_default().into());
                row.push(event.map_or_else(Cell::default, |(_, event)| (event + 1).into()));
                row.push(found.opened.file().format().name().into());
                row.push(found.opened.file().unit().name().into());
                row.push(Cell::exact(gravity));
                row.extend(numbers(found).map(|(_, one)| Cell::exact(one)));
                let left_out = found.placed.as_ref().err().map(LeftOutReason::sentence);
                row.extend([left_out.unwrap_or_default().into(), Cell::default()]);
            }
            Err(reason) => {
                row.resize(words.len() + names.len() + 1, Cell::default());
                row.push(reason.to_string().as_str().into());
            }
        }
        row
    };
    csv_text(&header, lines.iter().map(row))
}

/// Every motion with what was read from which line.
pub(super) fn json_of(lines: &[Line], suite: &Suite, gravity: f64) -> String {
    let reading = |one: &Reading| json!({"what": one.what, "line": one.line, "found": one.found});
    let line = |line: &Line| {
        let mut all = json!({"file": line.path.display().to_string(), "component": line.component});
        match &line.found {
            Err(reason) => all["refused"] = json!(reason.to_string()),
            Ok(found) => {
                let file = found.opened.file();
                let readings = file.readings().iter().map(reading);
                let unusual = file.unusual().iter().map(|one| json!(one.to_string()));
                all["direction"] = json!(word(found));
                match &found.placed {
                    Ok((_, event)) => all["event"] = json!(event + 1),
                    Err(reason) => all["left_out"] = json!(reason.sentence()),
                }
                all["unusual"] = unusual.collect::<Value>();
                all["format"] = json!(file.format().name());
                all["unit"] = json!(file.unit().name());
                all["readings"] = readings.collect::<Value>();
                all["says"] = json!(file.provenance());
                all["sha256"] = json!(found.opened.origin.sha256);
                for (name, value) in numbers(found) {
                    all[name] = json!(value);
                }
                all["n_samples"] = json!(found.opened.record.samples().len());
            }
        }
        all
    };
    let motions: Vec<Value> = lines.iter().map(line).collect();
    let all = json!({"gravity_m_per_s2": gravity, "records": suite.json(), "motions": motions});
    json_text(&all)
}
