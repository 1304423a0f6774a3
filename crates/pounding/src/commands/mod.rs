//! The commands, a file each: their options and their answers.

mod advise;
mod assess;
mod certify;
mod check;
mod compare;
mod completions;
mod declared;
mod demo;
mod explain;
mod export;
mod gap;
mod ida;
mod init;
mod laws;
mod merge;
mod motion;
mod printed;
mod run;
mod schema;
mod slabs;
mod suite;
mod sweep;
mod view;

use std::path::{Path, PathBuf};

use clap::{Parser, Subcommand};
use pounding::scene::file::bytes_of;
use pounding::scene::{Error, Scene, Simulation, SimulationOptions};
use pounding::text::Refused;

use crate::progress::Progress;

const EXAMPLES: &str = "\
Examples:
  pounding demo
  pounding init scene.toml --record quake.AT2
  pounding check scene.toml
  pounding run scene.toml --out results
  pounding COMMAND --help

Exit codes: 0 done, and what was written is on disk; 1 an input was refused or
a run failed, with the reason on standard error, as JSON with --json; 2 the
command line was not understood.";

/// Earthquake-induced structural pounding.
#[derive(Debug, Parser)]
#[command(name = "pounding", bin_name = "pounding", version, after_help = EXAMPLES, max_term_width = 80)]
pub(crate) struct Program {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Write a scene with its record, run it, and write its results: nothing needed.
    Demo(demo::Arguments),
    /// Write a scene to begin with, with comments.
    Init(init::Arguments),
    /// Print what would run, and what its time step can follow.
    Check(check::Arguments),
    /// Run a scene and print peaks, collisions, errors and work.
    Run(run::Arguments),
    /// See a scene move in a browser, and turn its numbers.
    View(view::Arguments),
    /// Say under a folder of records whether the gaps are enough, and what
    /// touching does.
    Assess(assess::Arguments),
    /// Run several scenes and print them side by side.
    Compare(compare::Arguments),
    /// Run a scene with many values of its fields, into a table.
    Sweep(sweep::Arguments),
    /// Join the shards of a sweep.
    Merge(merge::Arguments),
    /// Find how wide gaps must be under a folder of records.
    Gap(gap::Arguments),
    /// Find how often a row touches, from records and a hazard curve.
    Ida(ida::Arguments),
    /// Write a scene as a script for OpenSees, to check this program.
    Export(export::Arguments),
    /// Find the cheapest method and time step for an accuracy.
    Advise(advise::Arguments),
    /// Look at record files: what they hold, as CSV, response spectra.
    Motion(motion::Arguments),
    /// List the contact laws: forces, formulas, parameters, sources.
    Laws(laws::Arguments),
    /// Print what a contact law and a method deliver to a free impact.
    Certify(certify::Arguments),
    /// Say what a word of the program means.
    Explain(explain::Arguments),
    /// Print the JSON Schema of a scene or sweep file, for editors.
    Schema(schema::Arguments),
    /// Print a script that lets a shell complete commands.
    Completions(completions::Arguments),
}

/// An answer that is missing or incomplete.
pub(crate) struct Failure {
    /// The text that is printed nevertheless.
    pub(crate) printed: String,
    /// The reason, for standard error.
    pub(crate) refused: Refused,
}

impl<R: Into<Refused>> From<R> for Failure {
    fn from(refused: R) -> Self {
        Self {
            printed: String::new(),
            refused: refused.into(),
        }
    }
}

impl Program {
    /// Returns the text to print.
    ///
    /// # Errors
    /// Gives the reason for standard error, and the text that is printed nevertheless.
    pub(crate) fn run(&self) -> Result<String, Failure> {
        let text = match &self.command {
            Command::Motion(args) => return motion::run(args),
            Command::Demo(args) => demo::run(args),
            Command::Init(args) => init::run(args),
            Command::Check(args) => check::run(args),
            Command::Run(args) => run::run(args),
            Command::View(args) => view::run(args),
            Command::Assess(args) => assess::run(args),
            Command::Compare(args) => compare::run(args),
            Command::Sweep(args) => return sweep::run(args),
            Command::Merge(args) => return merge::run(args),
            Command::Ida(args) => return ida::run(args),
            Command::Gap(args) => gap::run(args),
            Command::Export(args) => export::run(args),
            Command::Advise(args) => advise::run(args),
            Command::Laws(args) => laws::run(args),
            Command::Certify(args) => certify::run(args),
            Command::Explain(args) => explain::run(args),
            Command::Schema(args) => Ok(schema::run(args)),
            Command::Completions(args) => Ok(completions::run(args)),
        };
        Ok(text?)
    }
}

/// Reads and prepares a scene, with a bar if its method has to be found; `force` as in [`SimulationOptions`].
fn prepare(path: &Path, force: bool) -> Result<Simulation, Error> {
    let scene = read(path)?;
    let progress = Progress::new();
    let step = |of| progress.step(of);
    let options = SimulationOptions {
        force,
        progress: Some(&step),
        ..folder(path).into()
    };
    Simulation::new(&scene, options)
}

/// Reads a scene from a file as TOML or JSON; `-` is standard input, whose records are named from the current folder.
fn read(path: &Path) -> Result<Scene, Error> {
    if path != Path::new("-") {
        return Scene::read(path);
    }
    let text = bytes_of(std::io::stdin()).map_err(|error| Refused::unreadable(path, &error))?;
    Scene::parse(&text, path)
}

/// The files that a scene was read from: the scene and its record.
fn inputs(path: &Path, prepared: &Simulation) -> Vec<PathBuf> {
    let record = prepared.origin().map(|origin| origin.path.clone());
    record.into_iter().chain([path.to_path_buf()]).collect()
}

/// The files of a folder of records, or an archive of them.
fn inputs_in(folder: &Path) -> Vec<PathBuf> {
    if !folder.is_dir() {
        return vec![folder.to_path_buf()];
    }
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| entry.path()).collect()
}

/// Folder of a file.
fn folder(path: &Path) -> &Path {
    path.parent().unwrap_or_else(|| Path::new(""))
}

/// A finite number ≥ 0, also in per cent.
fn part_of_one(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let (number, divisor) = match text.strip_suffix('%') {
        Some(number) => (number.trim_end(), 100.0),
        None => (text, 1.0),
    };
    match number.parse::<f64>() {
        // Divided, 5 % is the number that is written 0.05.
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value / divisor),
        _ => Err("allowed is a finite number >= 0, such as 0.05 or 5%".into()),
    }
}

/// A finite number > 0.
fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err("allowed is a finite number > 0".into()),
    }
}
