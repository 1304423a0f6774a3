//! `pounding completions`: what a shell needs to complete the program's commands.

use clap::CommandFactory;
use clap_complete::Shell;

const EXAMPLES: &str = "\
Examples:
  pounding completions bash >> ~/.bash_completion
  pounding completions fish > ~/.config/fish/completions/pounding.fish";

/// The arguments of `completions`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The shell.
    shell: Shell,
}

/// The script for a shell.
pub(crate) fn run(args: &Arguments) -> String {
    let mut script = Vec::new();
    let mut program = super::Program::command();
    clap_complete::generate(args.shell, &mut program, "pounding", &mut script);
    String::from_utf8_lossy(&script).into_owned()
}
