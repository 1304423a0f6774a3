//! `pounding certify`: what a contact law and a method deliver to a free impact.

use clap::ValueEnum;
use pounding::contact::{Calibration, LawName};
use pounding::report::certificate;
use pounding::scene::{Certificate, CertificateRequest, FreeCollision, StepMethod};
use pounding::text::{Form, Refused};

use super::positive;

const USAGE: &str = "pounding certify <LAW> --restitution <E> --masses <LEFT> <RIGHT>
                        --speed <V0> [OPTIONS]";

const EXAMPLES: &str = "\
Examples:
  pounding certify hertz_damp --restitution 0.65 --masses 75e3 3e6 --speed 0.3
  pounding certify kelvin_voigt --restitution 0.65 --masses 75e3 3e6 \\
    --speed 0.3 --calibration literature --time-step 0.001";

/// A free impact to be certified.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES, override_usage = USAGE)]
pub(crate) struct Arguments {
    /// The law; `pounding laws` lists them.
    #[arg(value_name = "LAW", value_parser = law)]
    law: LawName,
    /// Coefficient of restitution asked for.
    #[arg(long, value_name = "E", allow_negative_numbers = true)]
    restitution: f64,
    /// Masses of the neighbours [kg].
    #[arg(long, required = true, num_args = 2, value_names = ["LEFT", "RIGHT"], allow_negative_numbers = true, value_parser = positive)]
    masses: Vec<f64>,
    /// Approach speed [m/s].
    #[arg(long, value_name = "V0", allow_negative_numbers = true, value_parser = positive)]
    speed: f64,
    /// Impact stiffness [N/m or N/m^1.5]; by default 9.35e7 or 2.75e9.
    #[arg(long, value_name = "K", allow_negative_numbers = true, value_parser = positive)]
    stiffness: Option<f64>,
    /// How the damping is chosen.
    #[arg(long, value_enum, default_value_t = By::Exact)]
    calibration: By,
    /// Time step of the methods [s]; by default none is tried.
    #[arg(long, value_name = "DT", allow_negative_numbers = true, value_parser = positive)]
    time_step: Option<f64>,
    /// The method; by default all are tried.
    #[arg(long, value_name = "METHOD", value_parser = method, requires = "time_step")]
    method: Option<StepMethod>,
    /// Print a table for a program, SI units.
    #[arg(long)]
    csv: bool,
    /// Print JSON, SI units.
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// How the certificate is printed.
    #[arg(long, value_enum, conflicts_with_all = ["csv", "json"])]
    format: Option<Format>,
}

impl Arguments {
    fn form(&self) -> Form {
        match self.format {
            Some(Format::Text) => Form::Brief,
            Some(Format::Csv) => Form::Csv,
            Some(Format::Json) => Form::Json,
            None => Form::asked(false, self.csv, self.json),
        }
    }
}

/// How the damping of a law is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum By {
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

/// How a certificate is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For a reader.
    Text,
    /// For a table.
    Csv,
    /// For a program.
    Json,
}

/// A law by its name.
fn law(name: &str) -> Result<LawName, String> {
    let names = LawName::ALL.map(LawName::name);
    LawName::from_name(name).ok_or_else(|| format!("allowed are {}", names.join(", ")))
}

/// A method with time steps by its name.
fn method(name: &str) -> Result<StepMethod, String> {
    let names: Vec<_> = StepMethod::all().map(StepMethod::name).collect();
    let named = StepMethod::all().find(|method| method.name() == name);
    named.ok_or_else(|| format!("allowed are {}", names.join(", ")))
}

/// The certificate that was asked for.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let law = args.law;
    let wanted = CertificateRequest {
        law,
        stiffness: args.stiffness.unwrap_or_else(|| Certificate::usual_stiffness(law)),
        restitution: args.restitution,
        calibration: args.calibration.into(),
    };
    let collision = FreeCollision {
        masses: [args.masses[0], args.masses[1]],
        speed: args.speed,
    };
    Ok(certificate(&wanted, &collision, args.time_step, args.method)?.text(args.form()))
}
