//! `pounding gap`: how wide the gaps of a row must be under a folder of records.

use std::path::PathBuf;

use pounding::studies::{Method, Motion, Rule, Scene, Separation, StudyError, digits, read_file};
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::progress::Progress;
use crate::text::{paragraph, short, table};

const EXAMPLES: &str = "\
Examples:
  pounding gap scene.toml --records records
  pounding gap scene.toml --records records --csv > gaps.csv

The gaps and contact laws of the scene do not matter: the width is the largest
closing of the gap while every structure stands alone, by the exact method.

Vertical components are left out: by the name that a file gives its component,
such as UP, UD, V, Z or DWN (of an AT2 file the direction in its title), and
where it gives none by the end of the file's name, such as -UP, _V or .UD.";

/// What is asked of `gap`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file; its record is replaced.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// A folder of records.
    #[arg(long, value_name = "FOLDER")]
    records: PathBuf,
    /// Print a table for a program, SI units.
    #[arg(long)]
    csv: bool,
    /// Print JSON, SI units.
    #[arg(long, conflicts_with = "csv")]
    json: bool,
}

/// The widths under one motion in one direction.
struct Line {
    motion: String,
    reversed: bool,
    found: Result<Vec<Separation>, String>,
}

/// The widths under every record.
pub(crate) fn answer(asked: &Arguments) -> Result<String, String> {
    let path = &asked.scene;
    let message = |error: StudyError| error.in_file(path).to_string();
    let scene: Scene = read_file(path).map_err(message)?;
    if scene.structures.len() < 2 {
        return Err(format!(
            "{}: structures: found {}, allowed two or more: a gap lies between two",
            path.display(),
            scene.structures.len()
        ));
    }
    // What does not matter must not be refused, nor searched for.
    let apart = Scene {
        contacts: None,
        method: Method::EXACT,
        ..scene.clone()
    };
    let lines = lines(&apart, &super::motions(&asked.records)?);
    if lines.iter().all(|line| line.found.is_err()) {
        let reasons = lines.iter().filter_map(|line| line.found.as_ref().err());
        let first = reasons.clone().next().map_or("", String::as_str);
        return Err(format!(
            "none of the records in {} shakes the row; the first: {first}",
            asked.records.display()
        ));
    }
    Ok(if asked.json {
        json_of(&scene, &lines)
    } else if asked.csv {
        csv_of(&scene, &lines)
    } else {
        text(&scene, &lines)
    })
}

fn lines(scene: &Scene, motions: &[Motion]) -> Vec<Line> {
    let progress = Progress::new();
    let cases: Vec<_> = motions
        .iter()
        .flat_map(|motion| [false, true].map(|reversed| (motion, reversed)))
        .collect();
    let line = |&(motion, reversed): &(&Motion, bool)| {
        let prepared = motion.shake(scene, reversed);
        let found = prepared.and_then(|prepared| prepared.separations());
        progress.step(cases.len());
        Line {
            motion: motion.name(),
            reversed,
            found: found.map_err(|error| error.reason()),
        }
    };
    cases.par_iter().map(line).collect()
}

/// Names of the neighbours of a gap.
fn names(scene: &Scene, left: usize) -> [&str; 2] {
    [left, left + 1].map(|index| scene.structures[index].name())
}

/// A table per gap, and what of the rules is too narrow.
fn text(scene: &Scene, lines: &[Line]) -> String {
    let found = |line: &Line| line.found.as_ref().ok().map(Vec::len);
    let n_gaps = lines.iter().find_map(found).unwrap_or(0);
    let mut parts = vec![paragraph("Scene", &scene.name)];
    parts.extend((0..n_gaps).map(|gap| of_gap(scene, lines, gap)));
    let refused = lines.iter().filter(|line| !line.reversed);
    let refused: Vec<String> = refused
        .filter_map(|line| Some(format!("{}: {}", line.motion, line.found.as_ref().err()?)))
        .collect();
    if !refused.is_empty() {
        parts.push(paragraph("Left out", &refused.join("\n")));
    }
    parts.push(paragraph("Notes", NOTES));
    parts.join("\n")
}

const NOTES: &str = "Needs: the largest closing of the gap while every structure stands alone, by the exact method. Rules: from the \
                     peak displacements of both structures under the same record; EC 8 is SRSS, 0.7 times that where \
                     both heights are given and the same; ASCE 7 is SRSS of the displacements of the time history; DDC takes elastic \
                     periods and damping. * marks what is too narrow.";

/// The table of one gap.
fn of_gap(scene: &Scene, lines: &[Line], gap: usize) -> String {
    let header = [
        ["Record", ""],
        ["Needs", "[mm]"],
        ["at", "[s]"],
        ["ABS", "[mm]"],
        ["SRSS", "[mm]"],
        ["DDC", "[mm]"],
        ["EC 8", "[mm]"],
        ["ASCE 7", "[mm]"],
    ];
    let mut all = Vec::new();
    let mut rows = Vec::new();
    let mut left = gap;
    for line in lines {
        let Some(separation) = line.found.as_ref().ok().and_then(|found| found.get(gap)) else {
            continue;
        };
        left = separation.left;
        all.push(*separation);
        let reversed = if line.reversed { " rev." } else { "" };
        let mut row = vec![
            format!("{}{reversed}", line.motion),
            format!("{} ", millimetres(separation.required)),
            digits((separation.time * 1e3).round() * 1e-3),
        ];
        row.extend(Rule::ALL.map(|rule| marked(rule.width(separation), separation.required)));
        rows.push(row);
    }
    let [one, other] = names(scene, left);
    let own = scene
        .contacts
        .as_ref()
        .and_then(|contacts| contacts.get(left));
    format!(
        "{}{}\n{}",
        paragraph(
            "Gap",
            &format!(
                "{one} – {other}{}",
                own.map_or(String::new(), |own| format!(
                    ", {} mm in the scene",
                    short(own.gap_m * 1e3)
                ))
            )
        ),
        table(&header, &rows),
        paragraph("Result", &result(&all, own.map(|own| own.gap_m)))
    )
}

/// A width, marked where it is too narrow.
fn marked(width: f64, required: f64) -> String {
    // A blank where there is no mark, so that the digits stand in line.
    let mark = if width < required { "*" } else { " " };
    format!("{}{mark}", millimetres(width))
}

/// To a tenth of a millimetre; small ones with the digits that they have.
fn millimetres(width: f64) -> String {
    if width < 1e-3 {
        short(width * 1e3)
    } else {
        format!("{:.1}", width * 1e3)
    }
}

/// The width that is enough for all, and how the rules and the scene's own gap do.
fn result(all: &[Separation], own: Option<f64>) -> String {
    let widest = all.iter().map(|one| one.required).fold(0.0, f64::max);
    let mut lines = vec![format!(
        "{} mm are enough for all {} motions",
        millimetres(widest),
        all.len()
    )];
    if let Some(own) = own {
        let touch = all.iter().filter(|one| one.required > own).count();
        lines.push(format!(
            "with the {} mm of the scene the structures touch under {touch} of them",
            millimetres(own)
        ));
    }
    let rule = |rule: Rule| {
        let narrow: Vec<f64> = all
            .iter()
            .map(|one| rule.width(one) / one.required)
            .filter(|share| *share < 1.0)
            .collect();
        let worst = narrow.iter().copied().fold(1.0, f64::min);
        let by = if narrow.is_empty() {
            String::new()
        } else {
            format!(
                ", at worst {} % of what is needed",
                digits((100.0 * worst).round())
            )
        };
        format!("{}: too narrow under {}{by}", rule.name(), narrow.len())
    };
    lines.extend(Rule::ALL.map(rule));
    lines.join("\n")
}

fn direction(line: &Line) -> &'static str {
    if line.reversed {
        "reversed"
    } else {
        "as recorded"
    }
}

/// One row per motion, direction and gap, in SI units.
fn csv_of(scene: &Scene, lines: &[Line]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let header = [
        "record",
        "direction",
        "left",
        "right",
        "required_m",
        "time_s",
        "peak_left_m",
        "peak_right_m",
        "abs_m",
        "srss_m",
        "ddc_m",
        "eurocode_8_m",
        "asce_7_m",
        "refused",
    ];
    let mut write = |row: &[String]| writer.write_record(row).expect("memory takes all");
    write(&header.map(String::from));
    for line in lines {
        match &line.found {
            Err(reason) => {
                let mut row = vec![line.motion.clone(), direction(line).into()];
                row.resize(header.len() - 1, String::new());
                row.push(reason.clone());
                write(&row);
            }
            Ok(found) => {
                for one in found {
                    let [left, right] = names(scene, one.left);
                    let mut row = vec![
                        line.motion.clone(),
                        direction(line).into(),
                        left.into(),
                        right.into(),
                    ];
                    let numbers = [one.required, one.time, one.peaks[0], one.peaks[1]];
                    row.extend(numbers.map(|number| number.to_string()));
                    row.extend(Rule::ALL.map(|rule| rule.width(one).to_string()));
                    row.push(String::new());
                    write(&row);
                }
            }
        }
    }
    let bytes = writer.into_inner().expect("memory takes all");
    String::from_utf8(bytes).expect("text goes in")
}

fn json_of(scene: &Scene, lines: &[Line]) -> String {
    let separation = |one: &Separation| {
        let [left, right] = names(scene, one.left);
        let rules: serde_json::Map<String, Value> = Rule::ALL
            .map(|rule| (rule.name().into(), json!(rule.width(one))))
            .into_iter()
            .collect();
        json!({
            "left": left, "right": right, "required_m": one.required, "time_s": one.time, "peaks_m": one.peaks, "rules_m": rules,
        })
    };
    let line = |line: &Line| match &line.found {
        Ok(found) => json!({
            "record": line.motion, "direction": direction(line), "gaps": found.iter().map(separation).collect::<Vec<_>>(),
        }),
        Err(reason) => {
            json!({"record": line.motion, "direction": direction(line), "refused": reason})
        }
    };
    let all = json!({"scene": scene.name, "motions": lines.iter().map(line).collect::<Vec<_>>()});
    let text = serde_json::to_string_pretty(&all).expect("plain data");
    format!("{text}\n")
}
