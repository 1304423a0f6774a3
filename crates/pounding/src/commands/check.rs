//! `pounding check`: what would run, and what its time step can follow.

mod json;

use pounding::text::Refused;
use std::path::PathBuf;

use pounding::report::other_direction_exact;
use pounding::scene::{Columns, ContactLimit, Excess, MethodLimits, RunResult, Simulation, Structure};
use pounding::solver::Opening;
use pounding::text::digits;

use crate::progress::Waiting;
use crate::record;
use crate::summary::method_lines;
use crate::text::{NONE, paragraph, short, table};

const EXAMPLES: &str = "\
Examples:
  pounding check studies/examples/two-structures.json
  pounding check scene.toml --json > plan.json

The collisions to expect are those of the exact run. What neither direction of
shaking needs is named.";

/// What is asked of `check`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Print JSON, SI units.
    #[arg(long)]
    json: bool,
}

/// A scene, and what its exact run says of it.
struct Plan<'a> {
    prepared: &'a Simulation,
    expected: Option<Expected>,
    /// What to know before believing a run.
    warnings: Vec<String>,
}

/// The exact run and what follows from it.
struct Expected {
    outcome: RunResult,
    limits: MethodLimits,
    /// The exact run under the reversed shaking; `None` if it fails.
    reversed: Option<RunResult>,
    /// What the scene gives and needs in neither direction, or in its own if the reversed run fails.
    unneeded: Vec<String>,
}

impl Expected {
    fn of(prepared: &Simulation, outcome: RunResult) -> Self {
        let reversed = other_direction_exact(prepared).ok();
        let runs: Vec<&RunResult> = std::iter::once(&outcome).chain(&reversed).collect();
        Self {
            limits: prepared.limits(&outcome),
            unneeded: prepared.unneeded(&runs),
            reversed,
            outcome,
        }
    }

    /// What may touch in either direction and is not modelled.
    fn unwatched(&self, prepared: &Simulation) -> Vec<String> {
        let runs = std::iter::once(&self.outcome).chain(&self.reversed);
        let all = Excess::gathered(runs.map(|run| prepared.excesses(run))).into_iter();
        let all = all.filter(|one| one.kind.is_unwatched());
        all.map(|one| one.to_string()).collect()
    }

    /// What is expected of a pair that does not touch in the direction of the scene.
    fn apart(&self, pair: usize) -> &'static str {
        match &self.reversed {
            Some(run) if run.collisions_of(pair).next().is_some() => "reversed",
            Some(_) | None => "stays open",
        }
    }
}

/// Checks a scene; returns what would run.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let path = &args.scene;
    let prepared = super::prepare(path, true).map_err(|error| error.in_file(path))?;
    let _waiting = Waiting::new("running the exact method");
    let plan = Plan::of(&prepared);
    Ok(if args.json { json::of(&plan) } else { text(&plan) })
}

impl<'a> Plan<'a> {
    fn of(prepared: &'a Simulation) -> Self {
        let mut warnings: Vec<String> = prepared.refusal().into_iter().collect();
        let expected = match prepared.exact().and_then(|exact| exact.run(None)) {
            Ok(outcome) => {
                let before = prepared.warnings_before(&outcome);
                warnings.extend(before.iter().map(ToString::to_string));
                let expected = Expected::of(prepared, outcome);
                warnings.extend(expected.unwatched(prepared));
                Some(expected)
            }
            Err(error) => {
                warnings.push(format!("the exact run fails, so that no collision can be expected: {error}"));
                None
            }
        };
        Self {
            prepared,
            expected,
            warnings,
        }
    }
}

/// The plan of a scene.
fn text(plan: &Plan<'_>) -> String {
    let prepared = plan.prepared;
    let unusual = crate::summary::unusual(prepared);
    let besides = if unusual.is_some() { " besides what is unusual" } else { "" };
    let mut parts: Vec<String> = unusual.into_iter().collect();
    parts.extend([
        paragraph("Scene", &prepared.scene().name),
        paragraph("Record", &record::lines(prepared).join("\n")),
        paragraph("Method", &method_lines(prepared)),
        paragraph("Model", &model_lines(plan)),
        structures(prepared),
    ]);
    if let Some(expected) = &plan.expected {
        parts.push(paragraph("Cost", &cost_lines(prepared, &expected.outcome)));
        parts.push(pairs(prepared, expected));
    }
    parts.push(paragraph("Notes", NOTES));
    parts.push(paragraph(
        "Warnings",
        &if plan.warnings.is_empty() {
            format!("none of stability and e{besides}; the errors of the numbers are those of a run")
        } else {
            plan.warnings.join("\n")
        },
    ));
    parts.join("\n")
}

const NOTES: &str = "Limit: from this time step on the motion grows without bound; of a pair, may do so while it touches \
                     (a structure that is pressed from both sides: from 0.7 times that).\nSpeed: the \
                     largest at which the pair meets in the exact run, \
                     \"reversed\" of a pair that only the reversed shaking closes; lasts, steps and e are those of a free collision \
                     at that speed, e that of the law and what the method makes of it.";

/// What of the scene is modelled, and what is left out because the scene does not require it.
fn model_lines(plan: &Plan<'_>) -> String {
    let prepared = plan.prepared;
    let floors = prepared.floors();
    let columns = floors.all().iter().filter_map(|floor| floor.made_of);
    let columns: Vec<_> = columns.map(|made| made.columns).collect();
    let yields = |one: &&Columns| one.yield_force_n.is_some();
    let kind = if columns.iter().any(|one| one.bouc_wen.is_some()) {
        "smooth loops (Bouc–Wen)"
    } else if columns.iter().any(|one| one.hardening_ratio.is_some()) {
        "bilinear"
    } else {
        "elastic-perfectly plastic"
    };
    let columns = match columns.iter().filter(yields).count() {
        0 => "elastic: none yields, none remembers".to_string(),
        n => format!("{kind}, of which {n} can yield"),
    };
    let contact = match floors.facing().len() {
        0 => "none: every structure moves alone".to_string(),
        n => format!("{n} pair{}, each a law only while it touches", if n == 1 { "" } else { "s" }),
    };
    let walls = prepared.walls().iter().filter(|wall| **wall).count();
    let structures = floors.all().len() - walls;
    let moving = if floors.all().iter().any(|floor| floor.storey.is_some()) {
        "floors moving"
    } else {
        "moving"
    };
    let walls = if walls == 0 { String::new() } else { format!(" and {walls} fixed") };
    let mut lines = vec![
        format!("{structures} {moving}{walls}; columns: {columns};"),
        format!("contact: {contact};"),
        "no histories unless `run --out` asks for them".into(),
    ];
    // What is asked for is modelled, so that a run can tell; what the exact run needs of it is said.
    let unneeded = plan.expected.iter().flat_map(|expected| &expected.unneeded);
    let both = plan.expected.iter().any(|one| one.reversed.is_some());
    let directions = if both { "in neither direction" } else { "in this direction" };
    lines.extend(unneeded.map(|what| format!("needed {directions}: {what}")));
    lines.extend(travel_line(prepared));
    lines.join("\n")
}

/// How far bases of neighbours move apart, or closer, where the ground motion travels along the row.
fn travel_line(prepared: &Simulation) -> Option<String> {
    let openings = prepared.openings();
    let by_size = |one: &(usize, &Opening), other: &(usize, &Opening)| one.1.distance.abs().total_cmp(&other.1.distance.abs());
    let (left, largest) = openings.iter().enumerate().max_by(by_size)?;
    let structures = &prepared.scene().structures;
    let way = if largest.distance < 0.0 { "apart" } else { "towards each other" };
    let reversed = if prepared.scene().record.reversed {
        "; record.reversed turns its shaking, not the way it travels"
    } else {
        ""
    };
    Some(format!(
        "ground: the motion travels along the row{reversed}; of neighbours, the bases of {} and {} move farthest: {} mm {way}, at {} s",
        structures[left].name(),
        structures[left + 1].name(),
        short(largest.distance.abs() * 1e3),
        short(largest.time)
    ))
}

/// What the run will cost, and the exact one.
fn cost_lines(prepared: &Simulation, expected: &RunResult) -> String {
    let exact = expected.work.segments;
    let exact_lines = format!("the exact run: {exact} pieces of motion, {} events", expected.work.events);
    match prepared.scene().method.time_step() {
        None => exact_lines,
        Some(step) => {
            let n = prepared.floors().all().len();
            let steps = (prepared.duration() / step).round() * n as f64;
            format!("{steps} steps of structures, and for the errors {exact_lines}")
        }
    }
}

fn structures(prepared: &Simulation) -> String {
    let limits = prepared.critical_time_steps();
    let header = [
        ["Structure", ""],
        ["Period", "[s]"],
        ["Damping", "ratio"],
        ["Yields at", "[kN]"],
        ["Limit", "[s]"],
    ];
    let row = |(index, structure): (usize, &Structure)| {
        let limit = limits[index].map_or(NONE.into(), short);
        let number = |value: Option<f64>| value.map_or(NONE.into(), short);
        vec![
            structure.name().into(),
            number(structure.period()),
            number(structure.damping_ratio()),
            yields_at(structure),
            limit,
        ]
    };
    let structures = prepared.scene().structures.iter().enumerate();
    table(&header, &structures.map(row).collect::<Vec<_>>())
}

/// Yield force of a structure \[kN\]; of storeys that differ the least and the largest, and that some stay elastic.
fn yields_at(structure: &Structure) -> String {
    let forces = structure.yield_forces();
    let known: Vec<f64> = forces.iter().flatten().copied().collect();
    if known.is_empty() {
        return NONE.into();
    }
    let least = known.iter().copied().fold(f64::INFINITY, f64::min);
    let most = known.iter().copied().fold(0.0, f64::max);
    let kilonewtons = |force: f64| short(force / 1e3);
    let (least, most) = (kilonewtons(least), kilonewtons(most));
    let text = if least == most { least } else { format!("{least} to {most}") };
    if known.len() < forces.len() {
        format!("{text}, {} of {}", known.len(), forces.len())
    } else {
        text
    }
}

fn pairs(prepared: &Simulation, expected: &Expected) -> String {
    let scene = prepared.scene();
    let contacts = scene.contacts.as_deref().unwrap_or_default();
    if contacts.is_empty() {
        return paragraph("Pairs", "none: no contact is modelled");
    }
    let header = [
        ["Pair", ""],
        ["Gap", "[mm]"],
        ["Speed", "[m/s]"],
        ["Lasts", "[ms]"],
        ["Steps", ""],
        ["Limit", "[ms]"],
        ["e", ""],
        ["Method's", "e"],
    ];
    let floors = prepared.floors();
    let rows = floors.pairs_by_contact().into_iter().map(|index| {
        let [left, right] = floors.names(index);
        let gap = contacts[floors.facing()[index].contact].gap_m;
        let mut row = vec![format!("{left} – {right}"), digits(gap * 1e3)];
        let mut limits = expected.limits.contacts.iter();
        match limits.find(|limit| limit.pair == index) {
            Some(limit) => row.extend(contact_numbers(limit)),
            None => row.extend([expected.apart(index), "", "", "", "", ""].map(String::from)),
        }
        row
    });
    table(&header, &rows.collect::<Vec<_>>())
}

fn contact_numbers(limit: &ContactLimit) -> [String; 6] {
    let number = |value: Option<f64>, scale: f64| value.map_or(NONE.into(), |value| short(scale * value));
    let critical = number(limit.critical_time_step, 1e3);
    let Some(free) = limit.free else {
        return ["pressed".into(), NONE.into(), NONE.into(), critical, NONE.into(), NONE.into()];
    };
    let steps = free.steps.map_or(NONE.into(), |steps| {
        if steps < MethodLimits::STEPS_PER_CONTACT {
            format!("{steps:.2}")
        } else {
            format!("{steps:.0}")
        }
    });
    let delivered = free.delivered.map_or(NONE.into(), |delivered| {
        let [least, most] = delivered.range;
        if most - least < 5e-4 {
            format!("{least:.3}")
        } else {
            format!("{least:.3} to {most:.3}")
        }
    });
    [
        short(free.approach_speed),
        number(free.duration, 1e3),
        steps,
        critical,
        free.restitution.map_or(NONE.into(), |e| format!("{e:.3}")),
        delivered,
    ]
}
