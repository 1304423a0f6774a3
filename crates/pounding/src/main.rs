//! The program `pounding`: runs one scene and prints what happened, or which method to run it with.

mod advice;
mod arguments;
mod summary;
mod text;

use std::io::{ErrorKind, Write, stdout};
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use arguments::{Arguments, Task};
use clap::Parser;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use pounding::studies::{
    Goal, Method, Prepared, RunErrors, Scene, StudyError, advise, n_methods, read_json,
};
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
    let prepared =
        Prepared::new(&read_json(path).map_err(message)?, folder(path)).map_err(message)?;
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
    let started = Instant::now();
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} methods, {elapsed}")
        .expect("the template is well formed");
    let bar = ProgressBar::with_draw_target(
        Some(n_methods(&prepared) as u64),
        ProgressDrawTarget::hidden(),
    )
    .with_style(style);
    let advice = advise(&prepared, goal, &|| {
        if started.elapsed() > Duration::from_secs(1) && bar.is_hidden() {
            bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        bar.inc(1);
    })
    .map_err(message)?;
    bar.finish_and_clear();
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
