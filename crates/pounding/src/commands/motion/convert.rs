//! `pounding motion convert`: a record as the project's CSV, processed as a scene would.

mod processing;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use pounding::motion::{Record, read};
use pounding::studies::{GroundMotion, RecordUse, Scene, Source, digits, read_file};

use super::source::{Declared, processed};
use crate::new_file;
use crate::progress::Waiting;
use processing::Processing;

const EXAMPLES: &str = "\
Examples:
  pounding motion convert quake.AT2 quake.csv
  pounding motion convert quake.v1 quake.csv --detrend linear --band-pass 0.1 25
  pounding motion convert quake.AT2 strong.csv --scale-to-pga 0.4
  pounding motion convert quake.AT2 strong.csv --scale-to-sa 1.0 5% 0.35
  pounding motion convert scene.toml shaking.csv     # the motion of a scene

The order is that of a scene: detrend, band-pass, resample, scale to a target,
scale, reverse. The CSV holds every digit: read again, in m/s² always and in g
where such numbers exist, it gives the same samples to the last bit.";

/// What is asked of `motion convert`.
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
    /// Write over a file that is there already.
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

/// A motion, and what is said of it above the numbers.
struct Motion {
    record: Record,
    gravity: f64,
    comments: Vec<String>,
}

/// Writes the CSV; returns what was written.
pub(super) fn answer(asked: &Arguments) -> Result<String, String> {
    let _waiting = Waiting::new("processing");
    let ending = asked.file.extension().unwrap_or_default();
    let motion = if ending == "toml" || ending == "json" {
        of_scene(asked)?
    } else {
        of_file(asked)?
    };
    let text = csv_of(&motion, asked.to);
    let out = asked.out.display();
    // What cannot be read again is not written.
    read(text.as_bytes()).map_err(|error| format!("{out}: not written: {error}"))?;
    new_file::write(&asked.out, text.as_bytes(), asked.overwrite)?;
    let record = &motion.record;
    let (time, peak) = record.peak();
    Ok(format!(
        "wrote {out}: {} samples, {} s apart, peak {} m/s² at {} s\n",
        record.samples().len(),
        record.time_step(),
        digits(peak),
        digits(time)
    ))
}

fn of_file(asked: &Arguments) -> Result<Motion, String> {
    let record = RecordUse {
        detrend: asked.processing.detrend(),
        band_pass: asked.processing.band_pass(),
        resample_s: asked.processing.resample,
        scale_to: asked.processing.scale_to()?,
        scale: asked.processing.scale,
        reversed: asked.processing.reverse,
        ..asked.declared.use_of(&asked.file)
    };
    let opened = processed(&asked.file, &record)?;
    let file = &opened.file;
    let mut comments: Vec<String> = file.provenance().lines().map(String::from).collect();
    comments.push(format!(
        "from {}, {}, SHA-256 {}",
        name(&asked.file),
        file.format().name(),
        opened.sha256
    ));
    let component = file.readings().iter().find(|one| one.what == "component");
    comments.extend(component.map(|one| format!("component {}", one.found)));
    comments.extend(record.processing());
    Ok(Motion {
        record: opened.record,
        gravity: asked.declared.gravity,
        comments,
    })
}

fn of_scene(asked: &Arguments) -> Result<Motion, String> {
    let path = &asked.file;
    if !asked.processing.is_empty() || !asked.declared.is_empty() {
        return Err(format!(
            "{}: found options for its record, allowed are --to and --overwrite: a scene says itself how its record is \
             used; change its `record`",
            path.display()
        ));
    }
    let scene: Scene = read_file(path).map_err(|error| error.in_file(path).to_string())?;
    let motion = GroundMotion::of(&scene.record, crate::commands::folder(path), &scene.name)
        .map_err(|error| error.in_file(path).to_string())?;
    let mut comments: Vec<String> = motion.record.source().lines().map(String::from).collect();
    let from = match &scene.record.source {
        Source::File(file) => format!(", {}", name(Path::new(&file.file))),
        Source::Generated(_) => String::new(),
    };
    comments.push(format!("from {}, scene {:?}{from}", name(path), scene.name));
    comments.extend(scene.record.processing());
    Ok(Motion {
        record: motion.record,
        gravity: scene.record.gravity_m_per_s2,
        comments,
    })
}

/// Name of a file without its folder, which other machines do not have.
fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

fn csv_of(motion: &Motion, to: To) -> String {
    let mut text = String::new();
    let mut line = |line: &str| writeln!(text, "{line}").expect("memory takes all");
    for comment in &motion.comments {
        line(format!("# {comment}").trim_end());
    }
    let value = |sample: f64| match to {
        To::MPerS2 => sample,
        To::G => in_g(sample, motion.gravity),
    };
    match to {
        To::MPerS2 => line("time_s,acceleration_m_per_s2"),
        To::G => {
            line(&format!("# one g is {} m/s²", motion.gravity));
            line("time_s,acceleration_g");
        }
    }
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
