//! The program `pounding`.

mod commands;
mod folder;
mod new_file;
mod progress;
mod record;
mod summary;
mod text;

use std::io::{ErrorKind, Write, stderr, stdout};
use std::process::ExitCode;

use clap::Parser;
use commands::Program;
use pounding::text::visible;

fn main() -> ExitCode {
    let (printed, refused) = match Program::parse().run() {
        Ok(text) => (text, None),
        Err(failure) => (failure.printed, Some(failure.message)),
    };
    let refused = match (print(&printed), refused) {
        (Ok(()), None) => return ExitCode::SUCCESS,
        (_, Some(message)) | (Err(message), None) => message,
    };
    // Of the whole line, as every command that has the option means the same by it.
    let is_json = std::env::args_os().any(|word| word == "--json");
    say(&if is_json {
        pounding::text::refusal_json(&refused)
    } else {
        format!("error: {refused}")
    });
    ExitCode::FAILURE
}

/// Says something on standard error. Nobody can be told if that is full or closed, and the work goes on.
pub(crate) fn say(line: &str) {
    let _ = writeln!(stderr(), "{}", visible(line));
}

/// Writes to standard output; a reader that has seen enough (`| head`) is no failure.
pub(crate) fn print(text: &str) -> Result<(), String> {
    match stdout().write_all(visible(text).as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(format!("standard output cannot be written: {error}"))
        }
        _ => Ok(()),
    }
}
