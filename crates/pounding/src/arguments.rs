//! What the program is asked on its command line.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};
use pounding::studies::Quantity;

const EXAMPLE: &str = "\
Example:
  pounding run studies/examples/two-structures.json

A scene is one entry of `scenes` in a file of studies/; the path of its record
is relative to the folder of the file that holds the scene.";

const ADVISE: &str = "\
Examples:
  pounding advise studies/examples/two-structures.json --error 1%
  pounding advise studies/examples/wall-and-neighbour.json --error 0.1% --quantity momentum

A scene with \"method\": {\"accuracy\": 0.01} asks for the same whenever it is run.";

/// Earthquake-induced structural pounding.
#[derive(Debug, Parser)]
#[command(name = "pounding", bin_name = "pounding", version, after_help = EXAMPLE)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) task: Task,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Task {
    /// Run a scene and print peaks, collisions, their errors and what the run cost.
    #[command(after_help = EXAMPLE)]
    Run {
        /// The scene, a JSON file.
        #[arg(value_name = "SCENE.json")]
        scene: PathBuf,
        /// Do not measure the errors; saves the exact run.
        #[arg(long)]
        no_error: bool,
    },
    /// Find the cheapest method and time step for an accuracy.
    #[command(after_help = ADVISE)]
    Advise {
        /// The scene, a JSON file; its own method does not matter.
        #[arg(value_name = "SCENE.json")]
        scene: PathBuf,
        /// Largest error, as 1% or 0.01.
        #[arg(long, value_parser = error)]
        error: f64,
        /// Of what.
        #[arg(long, value_enum, default_value_t = OfWhat::All)]
        quantity: OfWhat,
    },
}

/// The quantity whose error counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum OfWhat {
    /// Transferred momentum of every structure.
    Momentum,
    /// Peak displacement of every structure.
    Displacement,
    /// Peak shear forces and peak pounding forces.
    Force,
    /// First and largest impulse of every pair.
    Impulse,
    /// Time of the first collision of every pair.
    Time,
    /// All of these, and equal numbers of collisions.
    All,
}

impl From<OfWhat> for Quantity {
    fn from(of_what: OfWhat) -> Self {
        match of_what {
            OfWhat::Momentum => Self::Momentum,
            OfWhat::Displacement => Self::Displacement,
            OfWhat::Force => Self::Force,
            OfWhat::Impulse => Self::Impulse,
            OfWhat::Time => Self::Time,
            OfWhat::All => Self::All,
        }
    }
}

/// An error as a part of 1 or in per cent.
fn error(text: &str) -> Result<f64, String> {
    let (number, unit) = match text.strip_suffix('%') {
        Some(number) => (number.trim_end(), 0.01),
        None => (text, 1.0),
    };
    match number.parse::<f64>() {
        Ok(value) if value * unit > 0.0 && value * unit < 1.0 => Ok(value * unit),
        _ => Err("allowed is more than 0 and less than 1, such as 0.01 or 1%".into()),
    }
}
