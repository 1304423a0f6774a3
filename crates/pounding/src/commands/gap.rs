//! `pounding gap`: how wide the gaps of a row must be under a folder of records.

use std::path::PathBuf;

use pounding::assess::Rule;
use pounding::report::{GapsUnderMotion, OfFolder, gaps_answer};
use pounding::scene::{Error, Floors, Scene};
use pounding::text::Refused;

use super::declared::Declared;
use super::printed::Printed;
use super::suite;

const EXAMPLES: &str = "\
Examples:
  pounding gap scene.toml --records records
  pounding gap scene.toml --records records --csv > gaps.csv

The gaps and contact laws of the scene do not matter: the width is the largest
closing of the gap while nothing touches, by the exact method, at the level that
needs most of all at which floors face each other. Levels that `levels` of a
contact leaves out count, except beside walls. So do floors that face columns,
which are fixed to the floors at their ends.

Components of one record are one event, and count with the larger width.
Verticals, velocities, copies, and records in boreholes or on structures are
left out. Records lists them with the reason, and those whose direction nothing
tells: they count as horizontal.";

/// The arguments of `gap`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file; its record is replaced.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// A folder of records.
    #[arg(long, value_name = "FOLDER")]
    records: PathBuf,
    /// The code whose width is told in a sentence: en-1998-1, asce-7-16, ntc-2018,
    /// tbdy-2018, e-030 or gb-50011.
    #[arg(long, value_name = "CODE", value_parser = Rule::of_code)]
    code: Option<Rule>,
    #[command(flatten)]
    printed: Printed,
    #[command(flatten)]
    declared: Declared,
}

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
    Floors::check(&apart).map_err(message)?;
    let records = suite::read(&args.records, &args.declared, &scene)?;
    let ran = suite::lines(&apart, &records, &[false, true], GapsUnderMotion::of)?;
    let folder = OfFolder {
        scene: &scene,
        suite: &records,
        lines: &ran.lines,
    };
    ran.answer(gaps_answer(&folder, args.code).text(args.printed.form()))
}
