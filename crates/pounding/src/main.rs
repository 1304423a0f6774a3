//! The program `pounding`.

mod commands;
mod folder;
mod new_file;
mod progress;
mod record;
mod summary;
mod text;

use std::io::{ErrorKind, Write, stdout};
use std::process::ExitCode;

use clap::Parser;
use commands::Program;

fn main() -> ExitCode {
    let (printed, refused) = match Program::parse().run() {
        Ok(text) => (text, None),
        Err(failure) => (failure.printed, Some(failure.message)),
    };
    let refused = match (print(&printed), refused) {
        (Ok(()), None) => return ExitCode::SUCCESS,
        (_, Some(message)) | (Err(message), None) => message,
    };
    #[expect(clippy::print_stderr, reason = "a program speaks to its user")]
    {
        eprintln!("error: {refused}");
    }
    ExitCode::FAILURE
}

/// Writes to standard output; a reader that has seen enough (`| head`) is no failure.
pub(crate) fn print(text: &str) -> Result<(), String> {
    match stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(format!("standard output cannot be written: {error}"))
        }
        _ => Ok(()),
    }
}
