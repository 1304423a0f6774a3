//! The program `pounding`: runs one scene and prints what happened, or which method to run it with.

mod advice;
mod arguments;
mod certificate;
mod plan;
mod progress;
mod summary;
mod text;

use std::io::{ErrorKind, Write, stdout};
use std::path::Path;
use std::process::ExitCode;

use arguments::{Arguments, Task};
use clap::Parser;
use pounding::studies::{Goal, Method, Prepared, Scene, SceneError, StudyError, advise, read_file};
use progress::Progress;

fn main() -> ExitCode {
    let text = match Arguments::parse().task {
        Task::Run {
            scene,
            no_error,
            force,
        } => run(&scene, no_error, force),
        Task::Check { scene } => check(&scene),
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
fn run(path: &Path, no_error: bool, force: bool) -> Result<String, String> {
    let message = |error: StudyError| error.in_file(path).to_string();
    let scene = read_file(path).map_err(message)?;
    let progress = Progress::new();
    let step = |of| progress.step(of);
    let prepared = if force {
        Prepared::forcing(&scene, folder(path), &step)
    } else {
        Prepared::watched(&scene, folder(path), &step)
    };
    let prepared = prepared.map_err(|error| hint(error, path))?;
    let review = prepared
        .review(!no_error)
        .map_err(|error| hint(error, path))?;
    Ok(summary::of(&prepared, &review))
}

/// The message of a scene that is refused; of what `--force` prints all the same, with a hint at it.
fn hint(error: StudyError, path: &Path) -> String {
    let refused = matches!(
        &error,
        StudyError::Broken { .. }
            | StudyError::Scene {
                source: SceneError::Unstable { .. },
                ..
            }
    );
    let message = error.in_file(path).to_string();
    if refused {
        format!(
            "{message}; `pounding check` says what its time step can follow, --force runs it while its numbers are finite"
        )
    } else {
        message
    }
}

/// Checks a scene; returns what would run.
fn check(path: &Path) -> Result<String, String> {
    let message = |error: StudyError| error.in_file(path).to_string();
    let scene = read_file(path).map_err(message)?;
    let progress = Progress::new();
    let step = |of| progress.step(of);
    let prepared = Prepared::forcing(&scene, folder(path), &step).map_err(message)?;
    Ok(plan::of(&prepared))
}

/// Runs a scene with every method; returns the advice.
fn ask(path: &Path, goal: Goal) -> Result<String, String> {
    let message = |error: StudyError| error.in_file(path).to_string();
    let mut scene: Scene = read_file(path).map_err(message)?;
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
