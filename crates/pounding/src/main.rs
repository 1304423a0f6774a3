//! The program `pounding`.

mod commands;
mod folder;
mod new_file;
mod progress;

use std::io::{ErrorKind, Write, stderr, stdout};
use std::process::ExitCode;

use clap::Parser;
use commands::Program;
use pounding::text::{Refused, message, visible};

fn main() -> ExitCode {
    let_files_be_too_long();
    let (printed, refused) = match Program::parse().run() {
        Ok(text) => (text, None),
        Err(failure) => (failure.printed, Some(failure.refused)),
    };
    let refused = match (print(&printed), refused) {
        (Ok(()), None) => return ExitCode::SUCCESS,
        (_, Some(refused)) | (Err(refused), None) => refused,
    };
    // The whole line is searched: the option means the same in every command that has it.
    let is_json = std::env::args_os().any(|word| word == "--json");
    if is_json {
        tell(&pounding::text::refusal_json(&refused));
    } else {
        say(&format!("error: {refused}"));
    }
    ExitCode::FAILURE
}

/// Lets the system refuse to write past a limit on the size of files (`ulimit -f`), which is an error like any other. By default the system
/// ends the program silently.
fn let_files_be_too_long() {
    #[cfg(unix)]
    {
        use signal_hook::{consts::SIGXFSZ, flag};
        // Nobody looks at the flag; without a handler the program ends as before.
        let _ = flag::register(SIGXFSZ, std::sync::Arc::default());
    }
}

/// Says something on standard error; a line that nobody reads to its end is shortened.
pub(crate) fn say(line: &str) {
    tell(&message(line));
}

/// Writes to standard error. Nobody can be told if that is full or closed, and the work goes on.
fn tell(line: &str) {
    let _ = writeln!(stderr(), "{}", visible(line));
}

/// Writes to standard output; a reader that has seen enough (`| head`) is no failure.
pub(crate) fn print(text: &str) -> Result<(), Refused> {
    match stdout().write_all(visible(text).as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Refused::that(format!("standard output cannot be written: {error}"))),
        _ => Ok(()),
    }
}
