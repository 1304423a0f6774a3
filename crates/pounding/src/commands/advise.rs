//! `pounding advise`: the cheapest method and time step for an accuracy.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use pounding::report::advice_answer;
use pounding::scene::file::is_json;
use pounding::scene::{Advice, Error, Goal, Method, QuantityGroup, Scene, Simulation};
use pounding::text::{Form, Refused};

use super::part_of_one;
use crate::progress::Progress;

const EXAMPLES: &str = "\
Examples:
  pounding advise studies/examples/two-structures.json --accuracy 1%
  pounding advise studies/examples/two-structures.json --accuracy 0.1% \\
    --quantity momentum

A scene with \"method\": {\"accuracy\": 0.01} asks for the same when it is run.";

/// The arguments of `advise`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file; its own method does not matter.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Largest error, as 1% or 0.01: of each number relative to its own size; the notes of the answer say how small ones are
    /// measured, and what is left out.
    #[arg(long, alias = "error", allow_negative_numbers = true, value_parser = accuracy)]
    accuracy: f64,
    /// The quantity whose error counts.
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

/// An accuracy as a part of 1 or in per cent.
fn accuracy(text: &str) -> Result<f64, String> {
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
        error: args.accuracy,
        quantity: args.quantity,
    };
    let advice = Advice::of(&prepared, goal, &|of| progress.step(of)).map_err(message)?;
    let is_json = pounding::scene::file::bytes(path).is_ok_and(|text| is_json(&text, path));
    let snippet = snippet(&advice.best().method, is_json);
    Ok(advice_answer(&prepared, &advice, snippet).text(Form::asked(false, false, args.json)))
}

/// The method as text to be pasted into the scene's file.
fn snippet(method: &Method, json: bool) -> String {
    let lines = if json {
        let table = serde_json::to_string_pretty(method).expect("a method is plain data");
        format!("\"method\": {table}")
    } else {
        // A table may stand at the end of a file.
        let table = toml::to_string(&BTreeMap::from([("method", method)]));
        table.expect("a method is plain data")
    };
    let lines: Vec<String> = lines.lines().map(|line| format!("  {line}\n")).collect();
    lines.concat()
}
