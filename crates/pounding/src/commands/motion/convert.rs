//! `pounding motion convert`: a record as the project's CSV, processed as a scene would.

mod processing;
mod provenance;

use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

use clap::ValueEnum;
use pounding::motion::{Record, read};
use pounding::scene::{GroundMotion, Origin, RecordUse, Scene};
use pounding::text::{Answer, Form, Refused, Where, digits};

use super::source::{Declared, processed};
use crate::new_file;
use crate::progress::Waiting;
use processing::Processing;

const EXAMPLES: &str = "\
Examples:
  pounding motion convert quake.AT2 quake.csv
  pounding motion convert quake.v1 quake.csv --detrend linear \\
    --band-pass 0.1 25
  pounding motion convert quake.AT2 strong.csv --scale-to-pga 0.4
  pounding motion convert quake.AT2 strong.csv --scale-to-sa 1.0 5% 0.35
  pounding motion convert scene.toml shaking.csv     # the motion of a scene

The order is that of a scene: detrend, band-pass, resample, scale to a target,
scale, reverse. The CSV is a header that names the unit, and numbers with every
digit: read again, in m/s² always and in g where such numbers exist, they give
the same samples to the last bit. Where they come from and what was done to them
stands beside it, in OUT.provenance.json.";

/// The arguments of `motion convert`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A record, or a scene (TOML, JSON): its motion as it is used.
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// The CSV to write.
    #[arg(value_name = "OUT.csv")]
    out: PathBuf,
    /// Unit of the CSV.
    #[arg(long, help = "Unit of the CSV: m_per_s2 or g", value_enum, value_name = "UNIT", default_value_t = To::MPerS2, hide_possible_values = true)]
    to: To,
    /// Replace files that exist, but never FILE.
    #[arg(long)]
    overwrite: bool,
    #[command(flatten)]
    processing: Processing,
    #[command(flatten)]
    declared: Declared,
}

/// Unit of a CSV.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum To {
    /// m/s².
    #[value(name = "m_per_s2")]
    MPerS2,
    /// Multiples of g.
    #[value(name = "g")]
    G,
}

/// A motion, and where it comes from.
struct Motion {
    record: Record,
    gravity: f64,
    origin: Option<Arc<Origin>>,
    /// What was done to it, in words.
    processing: Vec<String>,
    /// The scene that it is the motion of.
    scene: Option<String>,
}

/// Writes the CSV, and beside it where it comes from; returns what was written.
pub(super) fn run(args: &Arguments) -> Result<String, Refused> {
    let _waiting = Waiting::new("processing");
    let ending = args.file.extension().unwrap_or_default();
    let motion = if ending == "toml" || ending == "json" {
        of_scene(args)?
    } else {
        of_file(args)?
    };
    let beside = args.out.with_extension("provenance.json");
    let origin = motion.origin.as_ref().map(|origin| origin.path.clone());
    let inputs: Vec<PathBuf> = origin.into_iter().chain([args.file.clone()]).collect();
    for written in [&args.out, &beside] {
        new_file::check(written, &inputs, args.overwrite)?;
    }
    let text = csv_of(&motion, args.to);
    let out = args.out.display();
    // What cannot be read again is not written.
    read(text.as_bytes()).map_err(|error| format!("{out}: not written: {error}"))?;
    new_file::write(&args.out, text.as_bytes(), args.overwrite)?;
    let said = provenance::json_of(args, &motion);
    new_file::write(&beside, said.as_bytes(), args.overwrite)?;
    let record = &motion.record;
    let (time, peak) = record.peak();
    let wrote = format!(
        "{out}: {} samples, {} s apart, peak {} m/s² at {} s",
        record.samples().len(),
        record.time_step(),
        digits(peak),
        digits(time)
    );
    let beside = format!("{}: where they come from", beside.display());
    Ok(Answer::new().say(Where::Terminal, "Wrote", vec![wrote, beside]).text(Form::Brief))
}

fn of_file(args: &Arguments) -> Result<Motion, Refused> {
    let record = RecordUse {
        detrend: args.processing.detrend(),
        band_pass: args.processing.band_pass(),
        interpolation: args.processing.interpolation(),
        resample_s: args.processing.resample,
        scale_to: args.processing.scale_to()?,
        scale: args.processing.scale,
        reversed: args.processing.reverse,
        ..args.declared.use_of(&args.file)
    };
    let opened = processed(&args.file, &record)?;
    Ok(Motion {
        record: opened.record,
        gravity: args.declared.gravity,
        origin: Some(opened.origin),
        processing: record.processing(),
        scene: None,
    })
}

fn of_scene(args: &Arguments) -> Result<Motion, Refused> {
    let path = &args.file;
    if !args.processing.is_empty() || !args.declared.is_empty() {
        let found = Refused::at(path.as_path()).found("options for its record");
        let found = found.allowed_are("--to and --overwrite: a scene says itself how its record is used");
        return Err(found.help("change its `record`"));
    }
    let scene: Scene = Scene::read(path).map_err(|error| error.in_file(path))?;
    let motion = GroundMotion::of(&scene.record, crate::commands::folder(path), &scene.name).map_err(|error| error.in_file(path))?;
    Ok(Motion {
        record: motion.record,
        gravity: scene.record.gravity_m_per_s2,
        origin: motion.origin,
        processing: scene.record.processing(),
        scene: Some(scene.name),
    })
}

fn csv_of(motion: &Motion, to: To) -> String {
    let mut text = String::new();
    let mut line = |line: &str| writeln!(text, "{line}").expect("memory takes all");
    let value = |sample: f64| match to {
        To::MPerS2 => sample,
        To::G => in_g(sample, motion.gravity),
    };
    line(match to {
        To::MPerS2 => "time_s,acceleration_m_per_s2",
        To::G => "time_s,acceleration_g",
    });
    let record = &motion.record;
    for (index, sample) in record.samples().iter().enumerate() {
        let time = index as f64 * record.time_step();
        line(&format!("{time},{}", value(*sample)));
    }
    text
}

/// The number of g that gives back an acceleration \[m/s²\] to the last bit, or the nearest where there is none.
fn in_g(acceleration: f64, gravity: f64) -> f64 {
    let nearest = acceleration / gravity;
    let near = [nearest, nearest.next_up(), nearest.next_down()];
    let exact = |number: &f64| (number * gravity).to_bits() == acceleration.to_bits();
    near.into_iter().find(exact).unwrap_or(nearest)
}
