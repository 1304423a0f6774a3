//! The program `pounding`: runs one scene and prints what happened, or which method to run it with.

mod advice;
mod arguments;
mod certificate;
mod progress;
mod summary;
mod text;

use std::io::{ErrorKind, Write, stdout};
use std::path::Path;
use std::process::ExitCode;

use arguments::{Arguments, Task};
use clap::Parser;
use pounding::studies::{Goal, Method, Prepared, RunErrors, Scene, StudyError, advise, read_json};
use progress::Progress;
use summary::Errors;

fn main() -> ExitCode {
    let text = match Arguments::parse().task {
        Task::Run { scene, no_error } => run(&scene, no_error),
        Task::Advise {
            scene,
            error,
            quantity,
        } => {
            let quantity = quantity.into();
            ask(&scene, Goal { error, quantity })
        }
        Task::Laws => Ok(certificate::laws()),
        Task::Certify(asked) => certificate::certify(&asked),
    };
    match text.and_then(|text| print(&text)) {
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
fn run(path: &Path, no_error: bool) -> Result<String, String> {
    let message = |error: StudyError| error.in_file(path).to_string();
    let scene = read_json(path).map_err(message)?;
    let progress = Progress::new();
    let prepared =
        Prepared::watched(&scene, folder(path), &|of| progress.step(of)).map_err(message)?;
    let outcome = prepared.run(None).map_err(message)?;
    let errors = if matches!(prepared.scene().method, Method::Exact { .. }) {
        Errors::Exact
    } else if no_error {
        Errors::NotMeasured
    } else {
        match prepared.exact().and_then(|exact| exact.run(None)) {
            Ok(exact) => {
                let errors = RunErrors::between(&outcome, &exact, &prepared.walls());
                Errors::Measured(errors, exact.work)
            }
            Err(error) => Errors::Unknown(error.to_string()),
        }
    };
    Ok(summary::of(&prepared, &outcome, &errors))
}

/// Runs a scene with every method; returns the advice.
fn ask(path: &Path, goal: Goal) -> Result<String, String> {
    let message = |error: StudyError| error.in_file(path).to_string();
    let mut scene: Scene = read_json(path).map_err(message)?;
    // The method of the scene does not matter, not even whether it suits the scene.
    scene.method = Method::EXACT;
    let prepared = Prepared::new(&scene, folder(path)).map_err(message)?;
    let progress = Progress::new();
    let advice = advise(&prepared, goal, &|of| progress.step(of)).map_err(message)?;
    Ok(advice::of(&prepared, &advice))
}

/// Folder of a file.
fn folder(path: &Path) -> &Path {
    path.parent().unwrap_or_else(|| Path::new(""))
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
