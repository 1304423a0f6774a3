//! `pounding gap`: how wide the gaps of a row must be under a folder of records.

use pounding::text::Refused;
use std::path::PathBuf;

use pounding::assess::{MotionLine, RequiredGap, Rule, RuleAssessment, Separation, Suite};
use pounding::scene::{Error, Excess, Floors, Implausible, Scene, Structure};
use pounding::text::{Cell, csv_text, digits, json_text, rounded_up};
use serde_json::json;

use super::declared::Declared;
use super::suite;
use crate::text::{paragraph, short, table};

const EXAMPLES: &str = "\
Examples:
  pounding gap scene.toml --records records
  pounding gap scene.toml --records records --csv > gaps.csv

The gaps and contact laws of the scene do not matter: the width is the largest
closing of the gap while every structure stands alone, by the exact method, at
the level that needs most of all at which floors face each other. Levels that
`levels` of a contact leaves out count, except beside walls. Floors beside
columns get a line in Result: the sum of both peaks.

Components of one record are one event, and count with the larger width.
Verticals, velocities, copies, and records in boreholes or on structures are
left out. Records lists them with the reason, and those whose direction nothing
tells: they count as horizontal.";

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
    /// Name every record that is left out.
    #[arg(long)]
    details: bool,
    /// Print a table for a program, SI units.
    #[arg(long, conflicts_with = "details")]
    csv: bool,
    /// Print JSON, SI units.
    #[arg(long, conflicts_with_all = ["csv", "details"])]
    json: bool,
    #[command(flatten)]
    declared: Declared,
}

/// The widths under one motion in one direction, what the motion is beyond its model, and what looks wrong.
type Line = MotionLine<(Vec<Separation>, Vec<Excess>, Vec<Implausible>)>;

/// The widths under every record.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let path = &args.scene;
    let message = |error: Error| Refused::from(error.in_file(path));
    let scene: Scene = super::read(path).map_err(message)?;
    if scene.structures.len() < 2 {
        let found = Refused::at("structures").found(scene.structures.len().to_string());
        let found = found.allowed("two or more").so(": ", "a gap lies between two");
        return Err(found.in_file(path));
    }
    let apart = scene.apart();
    let records = suite::read(&args.records, &args.declared, &scene)?;
    let ran = suite::lines(&apart, &records, &[false, true], |prepared| {
        let (widths, excesses) = Separation::judged(prepared)?;
        Ok((widths, excesses, prepared.doubts()))
    })?;
    let lines = &ran.lines;
    ran.answer(if args.json {
        json_of(&scene, &records, lines)
    } else if args.csv {
        csv_of(&scene, &records, lines)
    } else {
        text(&scene, &records, lines, args.details)
    })
}

/// The widths of a line, if it was not refused.
fn widths_of(line: &Line) -> Option<&Vec<Separation>> {
    line.found.as_ref().ok().map(|(widths, ..)| widths)
}

/// What looks wrong in the scene and in its records, a line for each kind.
fn unusual(lines: &[Line]) -> Vec<Implausible> {
    let found = lines.iter().filter_map(|line| Some((line, line.found.as_ref().ok()?)));
    let all = found.flat_map(|(line, (.., doubts))| {
        let doubts = doubts.iter();
        doubts.map(|doubt| (line.motion.as_str(), doubt))
    });
    Implausible::gathered(all)
}

/// What the widths rest on and should not: motion beyond its model, and floors that face no floor.
fn warnings(scene: &Scene, records: &Suite, lines: &[Line]) -> Vec<String> {
    let found = lines.iter().filter_map(|line| line.found.as_ref().ok());
    let beyond = Excess::gathered(found.map(|(_, excesses, _)| excesses)).into_iter();
    let beyond = beyond.filter(|one| one.kind.is_caution());
    let no_level = Floors::of(scene).map_or_else(|_| Vec::new(), |floors| floors.says_no_level());
    let missing = records.says_missing(MotionLine::failed(lines).len()).into_iter();
    let beyond = beyond.map(|one| one.to_string());
    missing.chain(beyond).chain(no_level).collect()
}

/// Names of the neighbours of a gap.
fn names(scene: &Scene, left: usize) -> [&str; 2] {
    [left, left + 1].map(|index| scene.structures[index].name())
}

/// A table per gap, and what of the rules is too narrow.
fn text(scene: &Scene, records: &Suite, lines: &[Line], details: bool) -> String {
    let n_gaps = lines.iter().find_map(|line| Some(widths_of(line)?.len()));
    let n_gaps = n_gaps.unwrap_or(0);
    let mut parts: Vec<String> = crate::text::unusual(&unusual(lines)).into_iter().collect();
    let warnings = warnings(scene, records, lines);
    if !warnings.is_empty() {
        parts.push(paragraph("Warnings", &warnings.join("\n")));
    }
    parts.push(paragraph("Scene", &scene.name));
    parts.extend((0..n_gaps).map(|gap| of_gap(scene, lines, gap)));
    parts.push(suite::records(records, lines, details));
    let levels = has_storeys(scene).then_some(LEVELS);
    let travels = scene.arrivals_s.is_some().then_some(TRAVELS);
    let notes = [Some(NOTES), levels, travels];
    let notes: Vec<&str> = notes.into_iter().flatten().collect();
    parts.push(paragraph("Notes", &notes.join("\n")));
    parts.join("\n")
}

const LEVELS: &str = "Level: that of the floors that need most and whose displacements the rules take, counted from 1 for the lowest; \
                      all count at which floors face each other, also those that `levels` of a contact leaves out.";

const TRAVELS: &str = "The ground travels along the row (`arrivals_s`): it is in what a gap needs, while the rules know \
                       displacements relative to each structure's own ground alone.";

const NOTES: &str = "Needs: the largest closing of the gap while every structure stands alone, by the exact method. Rules: from the \
                     peak displacements of both structures under the same record; EC 8 is SRSS, 0.7 times that where \
                     all floors of both are level by the heights given; ASCE 7 is SRSS of the displacements of the time history; DDC takes elastic \
                     periods and damping. * marks what is too narrow.";

/// The table of one gap.
fn of_gap(scene: &Scene, lines: &[Line], gap: usize) -> String {
    let mut all = Vec::new();
    let mut rows = Vec::new();
    let mut left = gap;
    for line in lines {
        let Some(separation) = widths_of(line).and_then(|found| found.get(gap)) else {
            continue;
        };
        left = separation.left;
        all.push(([line.event, 0], separation));
        rows.push((line.name(), *separation));
    }
    let [one, other] = names(scene, left);
    let found = RequiredGap::of(&all);
    let own = scene.contacts.as_ref().and_then(|contacts| contacts.get(left));
    format!(
        "{}{}\n{}",
        paragraph(
            "Gap",
            &format!(
                "{one} – {other}{}",
                own.map_or(String::new(), |own| format!(", {} mm in the scene", digits(own.gap_m * 1e3)))
            )
        ),
        widths(&rows, has_storeys(scene)),
        found.map_or(String::new(), |found| paragraph(
            "Result",
            &result(&found, own.map(|own| own.gap_m))
        ))
    )
}

/// Whether floors stand at several levels.
fn has_storeys(scene: &Scene) -> bool {
    let is_building = |one: &Structure| matches!(one, Structure::Building(_));
    scene.structures.iter().any(is_building)
}

/// What a gap needs under every record, of buildings with the level that decides.
fn widths(rows: &[(String, Separation)], levels: bool) -> String {
    let mut header = vec![
        ["Record", ""],
        ["Needs", "[mm]"],
        ["at", "[s]"],
        ["ABS", "[mm]"],
        ["SRSS", "[mm]"],
        ["DDC", "[mm]"],
        ["EC 8", "[mm]"],
        ["ASCE 7", "[mm]"],
    ];
    if levels {
        header.insert(1, ["Level", ""]);
    }
    let row = |(name, one): &(String, Separation)| {
        let mut row = vec![name.clone()];
        row.extend(levels.then(|| one.at_level.to_string()));
        row.push(format!("{} ", enough(one.required)));
        row.push(digits((one.time * 1e3).round() * 1e-3));
        row.extend(Rule::COMMON.map(|rule| marked(width(rule, one), one)));
        row
    };
    table(&header, &rows.iter().map(row).collect::<Vec<_>>())
}

/// A width, marked where it is too narrow.
fn marked(width: f64, separation: &Separation) -> String {
    // A blank where there is no mark, so that the digits stand in line.
    let mark = if separation.asks_for_more(width) { "*" } else { " " };
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

/// The same, not below the width.
fn enough(width: f64) -> String {
    let decimals = if width < 1e-3 { 4 } else { 1 };
    rounded_up(width * 1e3, decimals)
}

/// The width that is enough for all events, and how the rules and the scene's own gap do.
fn result(all: &RequiredGap, own: Option<f64>) -> String {
    let widths = &all.required;
    let n = match widths.sorted().len() {
        1 => "the only event".into(),
        n => format!("all {n} events"),
    };
    let of = match all.beside_columns {
        Some(_) => "floors that face floors in ",
        None => "",
    };
    let mut lines = vec![format!(
        "{} mm are enough for {of}{n}; {} mm for half of them, {} mm for 84 %",
        enough(widths.largest()),
        enough(widths.median()),
        enough(widths.p84())
    )];
    let beside = all.beside_columns;
    lines.extend(beside.map(|width| format!("floors beside columns may need {} mm, the sum of both peaks", enough(width))));
    lines.extend(own.map(|own| {
        format!(
            "with the {} mm of the scene the structures touch under {} of them",
            digits(own * 1e3),
            widths.count_above(own)
        )
    }));
    let common = all.rules.iter().filter(|one| Rule::COMMON.contains(&one.rule));
    let rule = |one: &RuleAssessment| {
        let by = if one.too_narrow == 0 {
            String::new()
        } else {
            let share = digits((100.0 * one.least_share).round());
            format!(", at worst {share} % of what is needed")
        };
        let name = one.rule.name();
        format!("{name}: too narrow under {}{by}", one.too_narrow)
    };
    lines.extend(common.map(rule));
    lines.join("\n")
}

/// Width of a rule that asks for no heights \[m\].
fn width(rule: Rule, one: &Separation) -> f64 {
    rule.width(one).unwrap_or(f64::NAN)
}

/// One row per motion, direction and gap, in SI units.
fn csv_of(scene: &Scene, records: &Suite, lines: &[Line]) -> String {
    let found = lines.iter().find_map(|line| widths_of(line)?.first());
    let names_of_numbers = found.into_iter().flat_map(Separation::numbers).map(|(name, _)| name);
    let header = ["record", "event", "reversed", "left", "right", "level"].into_iter();
    let header = header.chain(names_of_numbers).chain(["refused"]);
    let header: Vec<&str> = header.collect();
    let row = |line: &Line, one: &Separation| {
        let [left, right] = names(scene, one.left);
        let mut row: Vec<Cell> = vec![
            line.motion.as_str().into(),
            (line.event + 1).into(),
            line.reversed.into(),
            left.into(),
            right.into(),
            one.at_level.into(),
        ];
        row.extend(one.numbers().map(|(_, number)| Cell::exact(number)));
        row.push(Cell::default());
        row
    };
    let refused = |name: &str, [event, reversed]: [Cell; 2], reason: &str| {
        let mut row = vec![name.into(), event, reversed];
        row.resize(header.len() - 1, Cell::default());
        row.push(reason.into());
        row
    };
    let rows = lines.iter().flat_map(|line| match &line.found {
        Ok((found, ..)) => found.iter().map(|one| row(line, one)).collect(),
        Err(reason) => {
            let run = [(line.event + 1).into(), line.reversed.into()];
            vec![refused(&line.motion, run, reason)]
        }
    });
    let none = || [Cell::default(), Cell::default()];
    let left_out = records.left_out.iter();
    let left_out = left_out.map(|one| refused(&one.name, none(), &one.reason.sentence()));
    csv_text(&header, rows.chain(left_out))
}

fn json_of(scene: &Scene, records: &Suite, lines: &[Line]) -> String {
    let separation = |one: &Separation| {
        let [left, right] = names(scene, one.left);
        let mut gap = json!({"left": left, "right": right, "level": one.at_level});
        for (name, number) in one.numbers() {
            gap[name] = json!(number);
        }
        gap
    };
    let line = |line: &Line| {
        let mut motion = json!({"record": line.motion, "event": line.event + 1, "reversed": line.reversed});
        match &line.found {
            Ok((found, ..)) => motion["gaps"] = found.iter().map(separation).collect(),
            Err(reason) => motion["refused"] = json!(reason),
        }
        motion
    };
    json_text(&json!({
        "scene": scene,
        "unusual": unusual(lines),
        "records": records.json(),
        "warnings": warnings(scene, records, lines),
        "motions": lines.iter().map(line).collect::<Vec<_>>(),
        "left_out": records.left_out_json(),
    }))
}
