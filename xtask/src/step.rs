//! A command of a task, printed before it runs.

use std::path::Path;
use std::process::Command;

/// Runs a command in a folder.
///
/// # Errors
/// The command does not start, or fails.
pub(crate) fn step(command: &mut Command, folder: &Path) -> Result<(), String> {
    println!("── {command:?}");
    let status = command.current_dir(folder).status();
    let status = status.map_err(|error| format!("{command:?}: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{command:?}: {status}"))
    }
}
