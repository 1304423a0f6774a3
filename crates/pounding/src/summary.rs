//! What happened in a scene, as plain text of at most 80 columns, but for a long path.

use pounding::motion::Record;
use pounding::solver::{Collision, ImpactRule, Peak, SimultaneousImpacts, Start, VerletImpacts};
use pounding::studies::{Method, Outcome, Scene, Sdof, Structure, digits};

/// Columns of a terminal.
const WIDTH: usize = 80;
/// Columns of the words that begin a paragraph.
const LABEL: usize = 10;
/// What stands where there is no number.
const NONE: &str = "–";

/// Summary of a run.
pub(crate) fn of(scene: &Scene, record: &Record, outcome: &Outcome) -> String {
    let method = scene.method;
    let duration = digits(scene.duration_s);
    let steps = method
        .time_step()
        .map_or(String::new(), |dt| format!(" in steps of {} s", digits(dt)));
    let work = outcome.work;
    [
        paragraph("Scene", &scene.name),
        paragraph("Record", &record_lines(scene, record).join("\n")),
        paragraph(
            "Method",
            &format!(
                "{}{};\n{duration} s{steps}",
                method.name().replace('_', " "),
                settings(&method)
            ),
        ),
        structures(scene, outcome),
        pairs(scene, outcome),
        paragraph(
            "Work",
            &match method {
                Method::Exact { .. } => {
                    format!("{} pieces of motion, {} events", work.segments, work.events)
                }
                Method::CentralDifference { .. }
                | Method::Newmark { .. }
                | Method::Hht { .. }
                | Method::VelocityVerlet { .. }
                | Method::Rk4 { .. }
                | Method::MoreauJean { .. } => format!(
                    "{} steps, {} force evaluations,\n{} Newton iterations, {} steps in contact",
                    work.steps, work.force_evaluations, work.newton_iterations, work.touching_steps
                ),
            },
        ),
    ]
    .join("\n")
}

/// Settings of a method in words, each after a comma.
fn settings(method: &Method) -> String {
    match *method {
        Method::CentralDifference {
            start,
            impacts,
            contact_substeps,
            ..
        } => {
            let impacts = match impacts {
                ImpactRule::AsPublished => "",
                ImpactRule::VelocityJump => ", impacts: velocity jump",
            };
            let substeps = match contact_substeps {
                1 => String::new(),
                n => format!(",\n{n} sub-steps while touching"),
            };
            format!(", start: {}{impacts}{substeps}", words(start))
        }
        Method::Newmark { beta, gamma, .. } => {
            format!(", β = {}, γ = {}", short(beta), short(gamma))
        }
        Method::Hht { alpha, .. } => format!(", α = {}", short(alpha)),
        Method::VelocityVerlet { impacts, .. } => match impacts {
            VerletImpacts::VelocityJump => ", impacts: velocity jump".into(),
            VerletImpacts::Located => ", impacts: located".into(),
        },
        Method::Rk4 { .. } => String::new(),
        Method::MoreauJean { theta, .. } => format!(", θ = {}", short(theta)),
        Method::Exact {
            tolerance,
            simultaneous_impacts,
        } => {
            let together = match simultaneous_impacts {
                SimultaneousImpacts::Together => "",
                SimultaneousImpacts::Sequential => ", simultaneous impacts: sequential",
            };
            format!(", tolerance {tolerance:e}{together}")
        }
    }
}

/// How a run of the central difference method begins, in words.
fn words(start: Start) -> &'static str {
    match start {
        Start::Consistent => "consistent",
        Start::FirstLoadUsed => "first load used",
        Start::FirstLoadSkipped => "first load skipped",
    }
}

/// File, use and peak of the record, and what its file says of itself.
fn record_lines(scene: &Scene, record: &Record) -> Vec<String> {
    let used = &scene.record;
    let (time, peak) = record.peak();
    let mut lines = vec![
        used.file.clone(),
        format!(
            "peak {} g = {} m/s² at {} s, {} s long in steps of {} s, scale {}{}",
            short(peak / used.gravity_m_per_s2),
            short(peak),
            digits(time),
            digits(record.duration()),
            digits(record.time_step()),
            digits(used.scale),
            if used.reversed { ", reversed" } else { "" },
        ),
    ];
    lines.extend(record.source().lines().map(String::from));
    lines
}

fn structures(scene: &Scene, outcome: &Outcome) -> String {
    let header = [
        ["Structure", "", ""],
        ["Period", "[s]", ""],
        ["Damping", "ratio", ""],
        ["Peak", "displ.", "[mm]"],
        ["at", "[s]", ""],
        ["Peak", "restoring", "force [kN]"],
        ["Ductility", "", ""],
        ["Transferred", "momentum", "[kN·s]"],
    ];
    let rows = scene
        .structures
        .iter()
        .enumerate()
        .map(|(index, structure)| {
            let momentum = short(outcome.momentum.of(index) / 1e3);
            let Structure::Sdof(sdof) = structure else {
                let mut row = vec![structure.name().to_string()];
                row.resize(header.len() - 1, NONE.into());
                row.push(momentum);
                return row;
            };
            let peaks = outcome.peaks.of(index);
            vec![
                sdof.name.clone(),
                short(sdof.period()),
                short(sdof.damping_ratio()),
                short(peaks.displacement.value * 1e3),
                digits(peaks.displacement.time),
                short(peaks.restoring_force.value / 1e3),
                ductility(sdof, &peaks.displacement),
                momentum,
            ]
        });
    table(&header, &rows.collect::<Vec<_>>())
}

/// Largest displacement over yield displacement, for columns that can yield.
fn ductility(structure: &Sdof, displacement: &Peak) -> String {
    structure.yield_force_n.map_or_else(
        || NONE.into(),
        |force| short(displacement.value.abs() * structure.stiffness_n_per_m / force),
    )
}

fn pairs(scene: &Scene, outcome: &Outcome) -> String {
    let Some(contacts) = scene
        .contacts
        .as_ref()
        .filter(|contacts| !contacts.is_empty())
    else {
        return paragraph("Pairs", "none: no structure can touch another");
    };
    let header = [
        ["Pair", "", ""],
        ["Gap", "[mm]", ""],
        ["Collisions", "", ""],
        ["First", "[s]", ""],
        ["Largest", "impulse", "[kN·s]"],
        ["Peak", "force", "[kN]"],
    ];
    let rows = contacts.iter().enumerate().map(|(index, contact)| {
        let of_pair = |collision: &&Collision| collision.pair == index;
        let collisions: Vec<&Collision> = outcome.collisions.all().iter().filter(of_pair).collect();
        let largest = |value: fn(&Collision) -> Option<f64>| {
            let values = collisions.iter().filter_map(|collision| value(collision));
            values.max_by(f64::total_cmp)
        };
        let impulse = largest(|collision| Some(collision.impulse));
        let force = largest(|collision| collision.peak_force);
        let [left, right] = [index, index + 1].map(|index| scene.structures[index].name());
        vec![
            format!("{left} – {right}"),
            digits(contact.gap_m * 1e3),
            collisions.len().to_string(),
            collisions
                .first()
                .map_or(NONE.into(), |first| digits(first.start)),
            impulse.map_or(NONE.into(), |impulse| short(impulse / 1e3)),
            match force {
                Some(force) => short(force / 1e3),
                None if collisions.is_empty() => NONE.into(),
                None => "impulsive".into(),
            },
        ]
    });
    table(&header, &rows.collect::<Vec<_>>())
}

/// A number with four significant digits.
fn short(value: f64) -> String {
    // A negative zero loses its sign.
    let scientific = format!("{:.3e}", value + 0.0);
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse().ok());
    match exponent {
        _ if value == 0.0 => "0".into(),
        Some(exponent @ -4..=5_i32) => {
            let decimals = usize::try_from(3 - exponent).unwrap_or(0);
            format!("{value:.decimals$}")
        }
        _ => scientific,
    }
}

/// Lines with a word before the first; long lines are broken between words.
fn paragraph(label: &str, text: &str) -> String {
    let broken: Vec<String> = text.lines().flat_map(broken).collect();
    let indent = " ".repeat(LABEL);
    format!("{label:LABEL$}{}\n", broken.join(&format!("\n{indent}")))
}

/// A line in pieces that fit beside a label; a longer word stays whole.
fn broken(line: &str) -> Vec<String> {
    let length = |text: &str| text.chars().count();
    let mut pieces: Vec<String> = Vec::new();
    for word in line.split_whitespace() {
        match pieces.last_mut() {
            Some(piece) if LABEL + length(piece) + 1 + length(word) <= WIDTH => {
                piece.push(' ');
                piece.push_str(word);
            }
            _ => pieces.push(word.into()),
        }
    }
    pieces
}

/// Columns under a name of three lines: the first to the left and cut where the table would be too wide, others to
/// the right.
fn table<const N: usize>(header: &[[&str; 3]; N], rows: &[Vec<String>]) -> String {
    let header = [0, 1, 2].map(|line| header.map(|name| name[line].to_string()).to_vec());
    let lines: Vec<&Vec<String>> = header.iter().chain(rows).collect();
    let width = |column: usize| {
        let widths = lines.iter().map(|line| line[column].chars().count());
        widths.max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..N).map(width).collect();
    let others: usize = widths[1..].iter().map(|width| width + 2).sum();
    let first = widths[0].min(WIDTH.saturating_sub(others).max(LABEL));
    let print = |line: &Vec<String>| {
        let others = line.iter().zip(&widths).skip(1);
        let others: Vec<String> = others
            .map(|(cell, width)| format!("  {cell:>width$}"))
            .collect();
        let line = format!("{:first$}{}", cut(&line[0], first), others.concat());
        format!("{}\n", line.trim_end())
    };
    lines.into_iter().map(print).collect()
}

/// The text, or its beginning and an ellipsis.
fn cut(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        text.into()
    } else {
        text.chars().take(width - 1).chain(['…']).collect()
    }
}
