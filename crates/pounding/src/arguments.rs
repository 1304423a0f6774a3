//! What the program is asked on its command line.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};
use pounding::contact::{Calibration, LawName};
use pounding::studies::{Quantity, StepMethod};

const EXAMPLE: &str = "\
Example:
  pounding run studies/examples/two-structures.json

A scene is one entry of `scenes` in a file of studies/; the path of its record
is relative to the folder of the file that holds the scene.";

const CHECK: &str = "\
Example:
  pounding check studies/examples/two-structures.json

The collisions to expect are those of the exact run, which takes some
milliseconds.";

const ADVISE: &str = "\
Examples:
  pounding advise studies/examples/two-structures.json --error 1%
  pounding advise studies/examples/two-structures.json --error 0.1% \\
    --quantity momentum

A scene with \"method\": {\"accuracy\": 0.01} asks for the same when it is run.";

const USAGE: &str = "pounding certify <LAW> --restitution <E> --masses <LEFT> <RIGHT>
                        --speed <V0> [OPTIONS]";

const CERTIFY: &str = "\
Examples:
  pounding certify hertz_damp --restitution 0.65 --masses 75e3 3e6 --speed 0.3
  pounding certify kelvin_voigt --restitution 0.65 --masses 75e3 3e6 \\
    --speed 0.3 --calibration literature --time-step 0.001";

/// Earthquake-induced structural pounding.
#[derive(Debug, Parser)]
#[command(name = "pounding", bin_name = "pounding", version, after_help = EXAMPLE)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) task: Task,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Task {
    /// Run a scene and print peaks, collisions, errors and work.
    #[command(after_help = EXAMPLE)]
    Run {
        /// The scene, a JSON file.
        #[arg(value_name = "SCENE.json")]
        scene: PathBuf,
        /// Do not measure the errors; saves the exact run.
        #[arg(long)]
        no_error: bool,
        /// Print what is refused, too, with a warning.
        #[arg(long)]
        force: bool,
    },
    /// Print what would run, and what its time step can follow.
    #[command(after_help = CHECK)]
    Check {
        /// The scene, a JSON file.
        #[arg(value_name = "SCENE.json")]
        scene: PathBuf,
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
    /// List the contact laws: forces, formulas, parameters, sources.
    Laws,
    /// Print what a contact law and a method deliver to a free impact.
    #[command(after_help = CERTIFY, override_usage = USAGE)]
    Certify(Certify),
}

/// A free impact to be certified.
#[derive(Debug, clap::Args)]
pub(crate) struct Certify {
    /// The law; `pounding laws` lists them.
    #[arg(value_name = "LAW", value_parser = law)]
    pub(crate) law: LawName,
    /// Coefficient of restitution asked for.
    #[arg(long, value_name = "E")]
    pub(crate) restitution: f64,
    /// Masses of the neighbours [kg].
    #[arg(long, required = true, num_args = 2, value_names = ["LEFT", "RIGHT"], value_parser = positive)]
    pub(crate) masses: Vec<f64>,
    /// Approach speed [m/s].
    #[arg(long, value_name = "V0", value_parser = positive)]
    pub(crate) speed: f64,
    /// Impact stiffness [N/m or N/m^1.5]; 9.35e7 or 2.75e9 where not given.
    #[arg(long, value_name = "K", value_parser = positive)]
    pub(crate) stiffness: Option<f64>,
    /// How the damping is chosen.
    #[arg(long, value_enum, default_value_t = By::Exact)]
    pub(crate) calibration: By,
    /// Time step of the methods [s]; without it none is tried.
    #[arg(long, value_name = "DT", value_parser = positive)]
    pub(crate) time_step: Option<f64>,
    /// The method; without it all are tried.
    #[arg(long, value_name = "METHOD", value_parser = method, requires = "time_step")]
    pub(crate) method: Option<StepMethod>,
    /// What to print.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
}

/// How the damping of a law is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum By {
    /// By the relation that holds exactly.
    Exact,
    /// By the formula of the literature.
    Literature,
}

impl From<By> for Calibration {
    fn from(by: By) -> Self {
        match by {
            By::Exact => Self::Exact,
            By::Literature => Self::Literature,
        }
    }
}

/// What is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For a reader.
    Text,
    /// For a table.
    Csv,
    /// For a program.
    Json,
}

/// A finite number > 0.
fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err("allowed is a finite number > 0".into()),
    }
}

/// A law by its name.
fn law(name: &str) -> Result<LawName, String> {
    let names = LawName::ALL.map(|law| law.description().name);
    LawName::from_name(name).ok_or_else(|| format!("allowed are {}", names.join(", ")))
}

/// A method with time steps by its name.
fn method(name: &str) -> Result<StepMethod, String> {
    let names: Vec<_> = StepMethod::all().map(StepMethod::name).collect();
    let named = StepMethod::all().find(|method| method.name() == name);
    named.ok_or_else(|| format!("allowed are {}", names.join(", ")))
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
