//! `pounding check`: what would run, and what its time step can follow.

use std::path::PathBuf;

use pounding::report::{RecordSummary, damping_facts, link_parameters, method_facts, other_direction_exact, record_facts};
use pounding::scene::{
    Columns, ContactLimit, Excess, ExcessKind, Extras, FreeLimit, Implausible, Link, MethodLimits, RunResult, Simulation, Structure,
};
use pounding::solver::Opening;
use pounding::text::{Answer, Cell, Form, Manner, NONE, Refused, Shown, Table, Unit, Where, short};
use serde_json::{Value, json};

use crate::progress::Waiting;

const EXAMPLES: &str = "\
Examples:
  pounding check studies/examples/two-structures.json
  pounding check scene.toml --json > plan.json

The collisions to expect are those of the exact run. What neither direction of
shaking needs is named.";

/// The arguments of `check`.
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

/// A scene, and the results of its exact run.
struct Plan<'a> {
    prepared: &'a Simulation,
    expected: Option<Expected>,
    /// Warnings before a run.
    warnings: Vec<String>,
}

/// The exact run and what follows from it.
struct Expected {
    outcome: RunResult,
    limits: MethodLimits,
    /// The exact run under the reversed shaking; `None` if it fails.
    reversed: Option<RunResult>,
    /// Parts of the scene that neither direction needs; if the reversed run fails, those that the own direction does not need.
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

    /// Floors that may touch in either direction and are not modelled, and dashpots that hold isolators.
    fn unmodelled(&self, prepared: &Simulation) -> Vec<String> {
        let runs = std::iter::once(&self.outcome).chain(&self.reversed);
        let all = Excess::gathered(runs.map(|run| prepared.all_excesses(run)), "run").into_iter();
        let all = all.filter(|one| one.kind.is_unwatched() || one.kind == ExcessKind::MassDamping);
        all.map(|one| one.to_string()).collect()
    }

    /// The work of the exact run, for programs.
    fn work(&self) -> Value {
        let work = &self.outcome.work;
        json!({"segments": work.segments, "events": work.events})
    }

    /// Every pair in the order of the scene, for programs.
    fn pairs(&self, prepared: &Simulation) -> Value {
        let all: Vec<usize> = (0..prepared.floors().facing().len()).collect();
        pairs(prepared, self, &all).json()
    }

    /// The expectation for a pair that does not touch in the direction of the scene.
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
    Ok(answer(&plan).text(Form::asked(false, false, args.json)))
}

impl<'a> Plan<'a> {
    fn of(prepared: &'a Simulation) -> Self {
        let mut warnings: Vec<String> = prepared.refusal().into_iter().collect();
        // What a warning is about must be recorded.
        let judged = Extras {
            closings: true,
            drift_rates: true,
            ..Extras::default()
        };
        let expected = match prepared.exact().and_then(|exact| exact.run_with(judged)) {
            Ok(outcome) => {
                let before = prepared.warnings_before(&outcome);
                warnings.extend(before.iter().map(ToString::to_string));
                let expected = Expected::of(prepared, outcome);
                warnings.extend(expected.unmodelled(prepared));
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

/// The plan of a scene. Facts that are not known or do not apply are null; all that follow from the exact run are null if it fails.
fn answer(plan: &Plan<'_>) -> Answer<'static> {
    let prepared = plan.prepared;
    let doubts = prepared.doubts();
    let unusual = Implausible::lines(doubts.iter().map(|one| ("", one)));
    let besides = if unusual.is_empty() { "" } else { " besides what is unusual" };
    let warnings = if plan.warnings.is_empty() {
        vec![format!(
            "none of stability and e{besides}; the errors of the numbers are those of a run"
        )]
    } else {
        plan.warnings.clone()
    };
    let mut answer = Answer::new()
        .say(Where::Terminal, "Unusual", unusual)
        .say(Where::Terminal, "Scene", vec![prepared.scene().name.clone()])
        .say_as(Where::Terminal, Manner::Facts, "Record", record_facts(prepared))
        .say_as(Where::Terminal, Manner::Facts, "Method", method_facts(prepared, None))
        .say(Where::Terminal, "Model", model_lines(plan))
        .table(Where::Terminal, structures(prepared).grid());
    if let Some(expected) = &plan.expected {
        answer = answer
            .say(Where::Terminal, "Damping", damping_facts(prepared, &expected.outcome))
            .say(Where::Terminal, "Cost", vec![cost_lines(prepared, &expected.outcome)])
            .say(Where::Terminal, "Pairs", no_pairs(prepared))
            .table(
                Where::Terminal,
                pairs(prepared, expected, &prepared.floors().pairs_by_contact()).grid(),
            );
    }
    answer
        .say(Where::Terminal, "Notes", NOTES.map(String::from).to_vec())
        .say(Where::Terminal, "Warnings", warnings)
        .fact("unusual", json!(doubts))
        .fact("scene", json!(prepared.scene()))
        .fact("record", json!(RecordSummary::of(prepared)))
        .fact("method", method(prepared))
        .fact("structures", structures(prepared).json())
        .fact("base_approaches", approaches(prepared))
        .fact("exact_run", plan.expected.as_ref().map(Expected::work))
        .fact("pairs", plan.expected.as_ref().map(|expected| expected.pairs(prepared)))
        .fact("not_needed", plan.expected.as_ref().map(|expected| expected.unneeded.clone()))
        .fact("warnings", plan.warnings.clone())
}

/// The method for programs.
fn method(prepared: &Simulation) -> Value {
    let method = prepared.scene().method;
    json!({
        "name": method.name(),
        "time_step_s": method.time_step(),
        "duration_s": prepared.duration(),
        "chosen_for_error": prepared.advice().map(|advice| advice.goal.error),
    })
}

/// For programs, how far the bases of every structure and its right neighbour approach, at most; negative if they move apart. Null if all
/// are shaken at once.
fn approaches(prepared: &Simulation) -> Option<Value> {
    let openings = prepared.openings();
    let all = Table::of(&openings)
        .column("largest_approach_m", |one| Cell::exact(one.distance))
        .column("time_s", |one| Cell::exact(one.time));
    (!openings.is_empty()).then(|| all.json())
}

/// The sentence in place of an empty table of pairs.
fn no_pairs(prepared: &Simulation) -> Vec<String> {
    let none = prepared.floors().facing().is_empty();
    none.then(|| "none: no contact is modelled".into()).into_iter().collect()
}

const NOTES: [&str; 2] = [
    "Limit: from this time step on the motion grows without bound; of a pair, may do so while it touches (a structure that is pressed from \
     both sides: from 0.7 times that).",
    "Speed: the largest at which the pair meets in the exact run, \"reversed\" of a pair that only the reversed shaking closes; lasts, steps and \
     e are those of a free collision at that speed, e that of the law and what the method makes of it.",
];

/// The parts of the scene that are modelled, and those that are left out because the scene does not require them.
fn model_lines(plan: &Plan<'_>) -> Vec<String> {
    let prepared = plan.prepared;
    let floors = prepared.floors();
    let columns = floors.all().iter().filter_map(|floor| floor.made_of);
    let columns: Vec<_> = columns.map(|made| made.columns).collect();
    let yields = |one: &&Columns| one.yield_force_n.is_some();
    let slide = columns.iter().any(|one| one.friction_n.is_some());
    let kind = if columns.iter().any(|one| one.bouc_wen.is_some()) {
        "smooth loops (Bouc–Wen)"
    } else if columns.iter().any(|one| one.hardening_ratio.is_some()) {
        "bilinear"
    } else {
        "elastic-perfectly plastic"
    };
    let columns = match columns.iter().filter(yields).count() {
        0 if slide => "elastic, on isolators that stick and slide under friction".to_string(),
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
    // Parts that the scene gives are modelled even if the exact run does not need them, which is said here.
    let unneeded = plan.expected.iter().flat_map(|expected| &expected.unneeded);
    let both = plan.expected.iter().any(|one| one.reversed.is_some());
    let directions = if both { "in neither direction" } else { "in this direction" };
    lines.extend(unneeded.map(|what| format!("needed {directions}: {what}")));
    lines.extend(floors.says_gravity().map(|gravity| format!("gravity: {gravity};")));
    lines.extend(link_lines(prepared));
    lines.extend(travel_line(prepared));
    lines
}

/// A line for each link: where it is, and its law.
fn link_lines(prepared: &Simulation) -> Vec<String> {
    let scene = prepared.scene();
    let line = |link: &Link| {
        let (ends, law) = (link.names(scene).join(" – "), link.law.name());
        format!("link {ends}: {law}, {}", link_parameters(link))
    };
    scene.links.iter().map(line).collect()
}

/// How far bases of neighbours move apart or closer, if the ground motion travels along the row.
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

/// The cost of the run and of the exact run.
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

/// Every structure. The list of yield forces has one for each storey, from the ground up.
fn structures(prepared: &Simulation) -> Table<'_, (&Structure, Option<f64>)> {
    let limits = prepared.critical_time_steps();
    Table::of(prepared.scene().structures.iter().zip(limits))
        .both(
            "name",
            "Structure",
            |(one, _)| one.name().to_owned(),
            |(one, _)| one.name().to_owned(),
        )
        .number("period_s", "Period", &Unit::PERIOD, |(one, _)| one.period())
        .number("damping_ratio", "Damping ratio", &Unit::ONE, |(one, _)| one.damping_ratio())
        .column("yield_force_n", |(one, _)| {
            Cell::exact(one.yield_forces().first().copied().flatten())
        })
        .both(
            "yield_forces_n",
            ("Yields at", "kN"),
            |(one, _)| json!(one.yield_forces()),
            |(one, _)| yields_at(one),
        )
        .number("critical_time_step_s", "Limit", &Unit::PERIOD, |(_, limit)| *limit)
}

/// Yield force of a structure \[kN\]: the least and the largest if storeys differ, and how many yield if some stay elastic.
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

/// The largest collision of a pair, or the expectation for a pair that does not touch in the direction of the scene.
struct ExpectedPair<'a> {
    index: usize,
    touch: Result<&'a ContactLimit, &'static str>,
}

impl ExpectedPair<'_> {
    /// A number of the free collision at the largest speed.
    fn number(&self, number: impl Fn(&FreeLimit) -> Option<f64>) -> Cell {
        Cell::exact(self.touch.ok().and_then(|limit| number(limit.free.as_ref()?)))
    }

    /// A text about the free collision; empty for a pair that does not touch.
    fn free(&self, text: impl Fn(&FreeLimit) -> Option<String>) -> Shown {
        match self.touch {
            Ok(limit) => limit.free.as_ref().and_then(text).into(),
            Err(_) => "".into(),
        }
    }

    fn speed(&self) -> Shown {
        match self.touch {
            Ok(limit) => limit.free.map_or("pressed".into(), |free| short(free.approach_speed).into()),
            Err(why) => why.into(),
        }
    }

    fn limit(&self) -> Shown {
        match self.touch {
            Ok(limit) => limit.critical_time_step.map(|step| short(1e3 * step)).into(),
            Err(_) => "".into(),
        }
    }
}

/// These pairs, each with the free collision at its largest speed.
fn pairs<'a>(prepared: &'a Simulation, expected: &'a Expected, order: &[usize]) -> Table<'a, ExpectedPair<'a>> {
    let contacts = prepared.scene().contacts.as_deref().unwrap_or_default();
    let floors = prepared.floors();
    let contact = move |one: &ExpectedPair<'_>| &contacts[floors.facing()[one.index].contact];
    let name = move |one: &ExpectedPair<'_>, side: usize| floors.names(one.index)[side].clone();
    let touches = |run: &RunResult, pair: usize| run.collisions_of(pair).next().is_some();
    let rows = order.iter().map(|&index| {
        let mut limits = expected.limits.contacts.iter();
        let limit = limits.find(|limit| limit.pair == index);
        ExpectedPair {
            index,
            touch: limit.ok_or_else(|| expected.apart(index)),
        }
    });
    Table::of(rows)
        .shown("Pair", |one| floors.names(one.index).join(" – "))
        .column("left", move |one| name(one, 0))
        .column("right", move |one| name(one, 1))
        .number("gap_m", "Gap", &Unit::GAP, move |one| contact(one).gap_m)
        .column("law", move |one| contact(one).law.name())
        .column("touches", |one| one.touch.is_ok())
        .column("touches_reversed", move |one| Some(touches(expected.reversed.as_ref()?, one.index)))
        .both(
            "approach_speed_m_per_s",
            ("Speed", "m/s"),
            |one| one.number(|free| Some(free.approach_speed)),
            ExpectedPair::speed,
        )
        .both(
            "contact_duration_s",
            ("Lasts", "ms"),
            |one| one.number(|free| free.duration),
            |one| one.free(|free| free.duration.map(|lasts| short(1e3 * lasts))),
        )
        .both(
            "steps_per_contact",
            "Steps",
            |one| one.number(|free| free.steps),
            |one| one.free(|free| free.steps.map(steps)),
        )
        .both(
            "critical_time_step_s",
            ("Limit", "ms"),
            |one| Cell::exact(one.touch.ok().and_then(|limit| limit.critical_time_step)),
            ExpectedPair::limit,
        )
        .both(
            "restitution",
            "e",
            |one| one.number(|free| free.restitution),
            |one| one.free(|free| free.restitution.map(|e| format!("{e:.3}"))),
        )
        .column("least_restitution", |one| one.number(|free| Some(free.delivered?.range[0])))
        .column("largest_restitution", |one| one.number(|free| Some(free.delivered?.range[1])))
        .shown("Method's e", |one| {
            one.free(|free| free.delivered.map(|delivered| between(delivered.range)))
        })
}

/// How many steps a contact has: few with decimals.
fn steps(steps: f64) -> String {
    let decimals = if steps < MethodLimits::STEPS_PER_CONTACT { 2 } else { 0 };
    format!("{steps:.decimals$}")
}

/// A restitution, or the range of it.
fn between([least, most]: [f64; 2]) -> String {
    if most - least < 5e-4 {
        format!("{least:.3}")
    } else {
        format!("{least:.3} to {most:.3}")
    }
}
