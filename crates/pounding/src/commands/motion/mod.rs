//! `pounding motion`: what a record holds, the project's CSV of it, its response spectra.

mod convert;
mod info;
mod source;
mod spectrum;

use clap::Subcommand;

use super::Failure;

const EXAMPLES: &str = "\
Examples:
  pounding motion info quake.AT2
  pounding motion convert quake.AT2 quake.csv --band-pass 0.1 25
  pounding motion spectrum quake.AT2 --damping 2%,5% --figure spectrum.png
  pounding motion COMMAND --help";

/// The arguments of `motion`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Print what record files hold and how strong the motion is.
    Info(info::Arguments),
    /// Write a record as CSV, processed as asked for.
    Convert(convert::Arguments),
    /// Print spectra of a record: response, constant ductility, Fourier.
    Spectrum(spectrum::Arguments),
}

/// Runs the subcommand; returns what is printed.
pub(crate) fn run(args: &Arguments) -> Result<String, Failure> {
    match &args.command {
        Command::Info(args) => info::run(args),
        Command::Convert(args) => Ok(convert::run(args)?),
        Command::Spectrum(args) => Ok(spectrum::run(args)?),
    }
}
