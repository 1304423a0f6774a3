//! `pounding advise`: the cheapest method and time step for an accuracy.

use pounding::text::Refused;
use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use pounding::scene::file::is_json;
use pounding::scene::{Advice, Error, Goal, Method, MethodTrial, QuantityGroup, RunErrors, Scene, Simulation};
use pounding::text::{digits, json_text};

use super::part_of_one;
use crate::progress::Progress;
use crate::text::{NONE, paragraph, percent, short, table};

const EXAMPLES: &str = "\
Examples:
  pounding advise studies/examples/two-structures.json --error 1%
  pounding advise studies/examples/two-structures.json --error 0.1% \\
    --quantity momentum

A scene with \"method\": {\"accuracy\": 0.01} asks for the same when it is run.";

/// What is asked of `advise`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file; its own method does not matter.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Largest error, as 1% or 0.01: of each number relative to its own size; the notes of the answer say how small ones are
    /// measured, and what is left out.
    #[arg(long, allow_negative_numbers = true, value_parser = error)]
    error: f64,
    /// Of what.
    #[arg(long, default_value = "all", value_parser = quantity())]
    quantity: QuantityGroup,
    /// Print JSON, SI units.
    #[arg(long)]
    json: bool,
}

/// Reads the quantity whose error counts.
fn quantity() -> impl TypedValueParser<Value = QuantityGroup> {
    let known = QuantityGroup::EVERY.map(|group| PossibleValue::new(group.name()).help(group.meaning()));
    PossibleValuesParser::new(known).map(|name| {
        let named = QuantityGroup::EVERY.into_iter().find(|group| group.name() == name);
        named.expect("clap takes the known names alone")
    })
}

/// An error as a part of 1 or in per cent.
fn error(text: &str) -> Result<f64, String> {
    let allowed = "allowed is more than 0 and less than 1, such as 0.01 or 1%";
    let value = part_of_one(text).ok();
    let value = value.filter(|value| *value > 0.0 && *value < 1.0);
    value.ok_or_else(|| allowed.into())
}

/// Runs a scene with every method; returns the advice.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let path = &args.scene;
    let message = |error: Error| Refused::from(error.in_file(path));
    let mut scene: Scene = super::read(path).map_err(message)?;
    // The method of the scene does not matter, not even whether it suits the scene.
    scene.method = Method::EXACT;
    let prepared = Simulation::new(&scene, super::folder(path)).map_err(message)?;
    let progress = Progress::new();
    let goal = Goal {
        error: args.error,
        quantity: args.quantity,
    };
    let advice = Advice::of(&prepared, goal, &|of| progress.step(of)).map_err(message)?;
    Ok(if args.json {
        json_text(&advice.to_json(prepared.scene()))
    } else {
        let text = pounding::scene::file::bytes(path);
        let json = text.is_ok_and(|text| is_json(&text, path));
        of(&prepared, &advice, json)
    })
}

/// The recommended method, the line for the scene, and what every method would cost.
fn of(prepared: &Simulation, advice: &Advice, json: bool) -> String {
    let best = advice.best();
    let goal = percent(advice.goal.error);
    let step = best
        .method
        .time_step()
        .map_or(String::new(), |step| format!(", time step {} s", digits(step)));
    let quantity = words(advice.goal.quantity);
    let why = if best.method == advice.exact.method {
        format!("nothing cheaper keeps {quantity} within {goal};\ncost {}", best.cost)
    } else {
        let (error, ratio) = (of_trial(best), best.cost as f64 / advice.exact.cost as f64);
        format!(
            "the cheapest that keeps {quantity} within {goal}:\nlargest error {error}, cost {}, {ratio:.2} times that of \
             exact",
            best.cost
        )
    };
    [
        paragraph("Use", &format!("{}{step}\n{why}", best.name)),
        snippet(&best.method, json),
        paragraph("Scene", &prepared.scene().name),
        methods(advice),
        paragraph("Notes", &notes(prepared)),
    ]
    .join("\n")
}

/// The method in the words of the scene's file, to be pasted in place of its own.
fn snippet(method: &Method, json: bool) -> String {
    let lines = if json {
        let table = serde_json::to_string_pretty(method).expect("a method is plain data");
        format!("\"method\": {table}")
    } else {
        // A table, which may stand at the end of a file.
        let table = toml::to_string(&BTreeMap::from([("method", method)]));
        table.expect("a method is plain data")
    };
    let lines: Vec<String> = lines.lines().map(|line| format!("  {line}\n")).collect();
    lines.concat()
}

fn notes(prepared: &Simulation) -> String {
    format!(
        "Errors: the largest distance from the exact run, and in what; {}.\nGoal met: at this step and at every shorter one \
         tried, of which there is at least one; the shortest step alone proves nothing, and stands here where the goal is \
         not met. Steps are halved from {} s while a run has at most {} steps of \
         structures.\nCost: force evaluations; a piece of motion of the exact method counts as {} here, which \
         is about the time it takes.",
        RunErrors::MEASURE,
        Advice::LONGEST_STEP,
        Advice::MOST_STEPS,
        prepared.evaluations_per_piece()
    )
}

/// A line per method: those that meet the goal by their cost, then the others.
fn methods(advice: &Advice) -> String {
    let header = [
        ["Method", ""],
        ["Goal", "met"],
        ["Step", "[ms]"],
        ["Error", ""],
        ["in", ""],
        ["Cost", ""],
    ];
    let mut trials = vec![(&advice.exact, true)];
    trials.extend(advice.methods.iter().filter_map(|rungs| {
        let chosen = rungs.chosen();
        Some((chosen.or(rungs.trials.last())?, chosen.is_some()))
    }));
    trials.sort_by_key(|(trial, meets)| (!meets, trial.cost));
    let row = |(trial, meets): &(&MethodTrial, bool)| {
        let step = trial.method.time_step();
        vec![
            trial.name.into(),
            if *meets { "yes" } else { "no" }.into(),
            step.map_or(NONE.into(), |step| short(1e3 * step)),
            if trial.method == advice.exact.method {
                "rounding".into()
            } else {
                percent(trial.error)
            },
            trial.worst.into(),
            trial.cost.to_string(),
        ]
    };
    table(&header, &trials.iter().map(row).collect::<Vec<_>>())
}

/// Error of a run and in what it is largest.
fn of_trial(trial: &MethodTrial) -> String {
    let error = percent(trial.error);
    if trial.worst.is_empty() {
        error
    } else {
        format!("{error} ({})", trial.worst)
    }
}

fn words(quantity: QuantityGroup) -> &'static str {
    match quantity {
        QuantityGroup::Momentum => "transferred momenta",
        QuantityGroup::Displacement => "displacements and drifts",
        QuantityGroup::Acceleration => "peak accelerations",
        QuantityGroup::Force => "peak forces",
        QuantityGroup::Impulse => "impulses",
        QuantityGroup::Time => "times of collisions",
        QuantityGroup::All => "all numbers (see Notes)",
    }
}
