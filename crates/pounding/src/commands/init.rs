//! `pounding init`: a scene to begin with, whose comments name what else it may hold.

mod buildings;
mod record;

use std::path::PathBuf;

use pounding::contact::Slab;
use pounding::text::{Answer, Form, Part, Refused, Where, json_text};
use serde_json::Value;

use super::{laws, slabs};
use crate::new_file;
use crate::progress::Waiting;
use record::Named;

const EXAMPLES: &str = "\
Examples:
  pounding init                                   # writes scene.toml
  pounding init towers.toml --record quake.AT2    # shaken by a record of yours
  pounding init towers.toml --storeys 8,5 --gap 0.04
  pounding init towers.toml --storeys 8,5 --slab-area 3 --slab-length 20
  pounding init towers.json                       # JSON, which has no comments
  pounding run towers.toml

The record is named from the folder of the scene where it lies in it, below it
or beside it, so that both can be moved together. What its file does not say
itself, such as its unit, stands in the scene as a comment to fill in.";

/// The scene that is written; `RECORD` stands for its ground motion.
const TEMPLATE: &str = include_str!("init/scene.toml");

/// Two structures of one storey, and what lies between them.
const ONE_STOREY: &str = include_str!("init/one-storey.toml");

/// A ground motion without a file, so that the scene runs at once.
const GENERATED: &str = r#"# A motion from a formula; with a record of yours instead:
#   file = "quake.AT2"     # PEER, CSMIP, COSMOS, SMC, K-NET, ESM, GeoNet, SAC, miniSEED, columns
#   unit = "g"             # only for files that do not say it themselves
generated.stochastic = { ground = "medium", pga_m_per_s2 = 3.0, strong_from_s = 2.0, strong_until_s = 8.0, decay_per_s = 0.5, duration_s = 20.0, time_step_s = 0.01, seed = 1 }"#;

/// The arguments of `init`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The file to write: TOML, or JSON where its name ends so.
    #[arg(value_name = "SCENE.toml", default_value = "scene.toml")]
    scene: PathBuf,
    /// The record that shakes it, seen from here; by default a motion from a formula.
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Buildings of this many storeys, from the left, such as 8,5; by default two
    /// structures of one storey.
    #[arg(long, value_name = "N,N…", value_delimiter = ',', value_parser = buildings::storeys)]
    storeys: Vec<usize>,
    /// The gap between neighbours in metres.
    #[arg(long, value_name = "M", default_value_t = 0.02, value_parser = buildings::gap)]
    gap: f64,
    #[command(flatten)]
    slabs: slabs::Arguments,
    /// Replace a file that exists.
    #[arg(long)]
    overwrite: bool,
}

/// Writes the scene; returns what to do next.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    buildings::check(args.storeys.len())?;
    let waiting = Waiting::new("reading the record");
    let named = args.record.as_ref().map(|record| Named::of(record, &args.scene)).transpose()?;
    drop(waiting);
    let motion = named.as_ref().map_or_else(|| GENERATED.into(), Named::lines);
    let structures = if args.storeys.is_empty() {
        ONE_STOREY.into()
    } else {
        buildings::structures(&args.storeys)
    };
    let law = args.slabs.slabs()?.map_or_else(|| PAPER.into(), |slabs| of_slabs(&slabs));
    let n_gaps = args.storeys.len().max(2) - 1;
    let text = TEMPLATE
        .replace("RECORD", &motion)
        .replace("STRUCTURES\n", &structures)
        .replace("CONTACTS\n", &buildings::contacts(n_gaps, args.gap, &law));
    let is_json = args.scene.extension().is_some_and(|end| end == "json");
    let text = if is_json { json_of(&text)? } else { text };
    let path = args.scene.display().to_string();
    let record: Vec<PathBuf> = args.record.iter().cloned().collect();
    new_file::check(&args.scene, &record, args.overwrite)?;
    new_file::write(&args.scene, text.as_bytes(), args.overwrite)?;
    let said = named.map(|named| named.said(&path, is_json)).into_iter().collect();
    let next = format!("next:\n  pounding check {path}\n  pounding run {path} --out results\n");
    let answer = Answer::new()
        .say(Where::Terminal, "Wrote", vec![path])
        .say(Where::Terminal, "Record", said)
        .part(Where::Terminal, Part::Markup(next));
    Ok(answer.text(Form::Brief))
}

/// The law of the paper, with its impact stiffness.
const PAPER: &str = "law.nonlinear_viscoelastic = { impact_stiffness_n_per_m1_5 = 2.75e9, restitution = 0.65 }";

/// A linear law with the impact stiffness of the slabs that meet.
fn of_slabs(slabs: &[Slab; 2]) -> String {
    format!("law.kelvin_voigt = {}", laws::linear(Slab::impact_stiffness(slabs)))
}

/// A scene in TOML as JSON, without the comments.
fn json_of(toml: &str) -> Result<String, Refused> {
    let scene: Value = toml::from_str(toml).map_err(|error| error.to_string())?;
    Ok(json_text(&scene))
}
