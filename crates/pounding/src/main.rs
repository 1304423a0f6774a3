//! The program `pounding`: runs one scene and prints what happened.

mod summary;

use std::io::{ErrorKind, Write, stdout};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use pounding::studies::{Prepared, Scene, StudyError, read_json};

const EXAMPLE: &str = "\
Example:
  pounding run studies/examples/two-structures.json

A scene is one entry of `scenes` in a file of studies/; the path of its record
is relative to the folder of the file that holds the scene.";

/// Earthquake-induced structural pounding.
#[derive(Debug, Parser)]
#[command(name = "pounding", bin_name = "pounding", version, after_help = EXAMPLE)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Run a scene and print peaks, collisions and what the run cost.
    #[command(after_help = EXAMPLE)]
    Run {
        /// The scene, a JSON file.
        #[arg(value_name = "SCENE.json")]
        scene: PathBuf,
    },
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().task {
        Task::Run { scene } => run(&scene).and_then(|text| print(&text)),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            #[expect(clippy::print_stderr, reason = "a program speaks to its user")]
            {
                eprintln!("error: {message}");
            }
            ExitCode::FAILURE
        }
    }
}

/// Runs a scene; returns the summary.
fn run(path: &Path) -> Result<String, String> {
    let message = |error: StudyError| error.in_file(path).to_string();
    let scene: Scene = read_json(path).map_err(message)?;
    let base = path.parent().unwrap_or_else(|| Path::new(""));
    let prepared = Prepared::new(&scene, base).map_err(message)?;
    let outcome = prepared.run(None).map_err(message)?;
    Ok(summary::of(&scene, prepared.record(), &outcome))
}

/// Writes to standard output; a reader that has seen enough (`| head`) is no failure.
fn print(text: &str) -> Result<(), String> {
    match stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(format!("standard output cannot be written: {error}"))
        }
        _ => Ok(()),
    }
}
