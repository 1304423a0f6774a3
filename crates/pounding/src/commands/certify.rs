//! `pounding certify`: what a contact law and a method deliver to a free impact.

mod printed;

use clap::ValueEnum;
use pounding::contact::{Calibration, Clamp, LawName};
use pounding::scene::{
    Certificate, CertificateError, CertificateRequest, FreeCollision, StepMethod,
};

use super::positive;
use printed::{Fact, Line, Said};

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
    /// Impact stiffness [N/m or N/m^1.5]; 9.35e7 or 2.75e9 where not given.
    #[arg(long, value_name = "K", allow_negative_numbers = true, value_parser = positive)]
    stiffness: Option<f64>,
    /// How the damping is chosen.
    #[arg(long, value_enum, default_value_t = By::Exact)]
    calibration: By,
    /// Time step of the methods [s]; without it none is tried.
    #[arg(long, value_name = "DT", allow_negative_numbers = true, value_parser = positive)]
    time_step: Option<f64>,
    /// The method; without it all are tried.
    #[arg(long, value_name = "METHOD", value_parser = method, requires = "time_step")]
    method: Option<StepMethod>,
    /// Print a table for a program, SI units.
    #[arg(long)]
    csv: bool,
    /// Print JSON, SI units.
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// The same in one option.
    #[arg(long, value_enum, conflicts_with_all = ["csv", "json"])]
    format: Option<Format>,
}

impl Arguments {
    fn format(&self) -> Format {
        match (self.format, self.csv, self.json) {
            (Some(format), ..) => format,
            (None, true, _) => Format::Csv,
            (None, _, true) => Format::Json,
            (None, false, false) => Format::Text,
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

/// What is printed.
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
    let names = LawName::ALL.map(|law| law.description().name);
    LawName::from_name(name).ok_or_else(|| format!("allowed are {}", names.join(", ")))
}

/// A method with time steps by its name.
fn method(name: &str) -> Result<StepMethod, String> {
    let names: Vec<_> = StepMethod::all().map(StepMethod::name).collect();
    let named = StepMethod::all().find(|method| method.name() == name);
    named.ok_or_else(|| format!("allowed are {}", names.join(", ")))
}

/// Impact stiffness of the pounding literature for Hertz springs \[N/m^1.5\].
const HERTZ: f64 = 2.75e9;
/// The same for linear springs \[N/m\].
const LINEAR: f64 = 9.35e7;

/// The certificate that was asked for.
pub(crate) fn run(args: &Arguments) -> Result<String, String> {
    let law = args.law;
    let usual = match law.stiffness_unit() {
        Some("N/m") => LINEAR,
        _ => HERTZ,
    };
    let wanted = CertificateRequest {
        law,
        stiffness: args.stiffness.unwrap_or(usual),
        restitution: args.restitution,
        calibration: args.calibration.into(),
    };
    let collision = FreeCollision {
        masses: [args.masses[0], args.masses[1]],
        speed: args.speed,
    };
    let message = |error: CertificateError| error.to_string();
    let certificate = Certificate::new(&wanted, &collision).map_err(message)?;
    let methods = match (args.time_step, args.method) {
        (None, _) => Vec::new(),
        (Some(step), Some(method)) => vec![line(&certificate, &collision, (method, step))],
        (Some(step), None) => StepMethod::differing(certificate.law.impulsive().is_some())
            .map(|method| line(&certificate, &collision, (method, step)))
            .collect(),
    };
    let facts = facts(&wanted, &collision, &certificate);
    Ok(match args.format() {
        Format::Text => printed::text(wanted.calibration, &facts, &methods),
        Format::Csv => printed::csv(&facts, &methods),
        Format::Json => printed::json(&facts, &methods),
    })
}

/// The lines of the certificate.
fn facts(
    wanted: &CertificateRequest,
    collision: &FreeCollision,
    certificate: &Certificate,
) -> Vec<Fact> {
    let named = |key, words, text: &str| Fact {
        key,
        words,
        unit: "",
        said: Said::Words(text.into()),
    };
    let number = |(key, words, unit, number)| Fact {
        key,
        words,
        unit,
        said: Said::Number(number),
    };
    let mut facts = vec![named("law", "law", wanted.law.description().name)];
    let [left, right] = collision.masses.map(Some);
    let (e, delivered) = (Some(wanted.restitution), certificate.by_relation);
    let (v, impulse) = (Some(collision.speed), Some(certificate.impulse));
    let by_exact = Some(certificate.by_exact);
    let [peak, deepest, duration] = match certificate.impact {
        Some(impact) => [impact.peak_force, impact.max_deformation, impact.duration].map(Some),
        None => [None; 3],
    };
    let numbers = [
        ("mass_left_kg", "left mass", "kg", left),
        ("mass_right_kg", "right mass", "kg", right),
        ("approach_speed_m_per_s", "approach speed", "m/s", v),
        ("restitution_asked", "e asked", "", e),
        (
            "restitution_by_formula",
            "e by the literature's formula",
            "",
            certificate.by_formula,
        ),
        ("restitution_delivered", "e delivered", "", delivered),
        (
            "restitution_by_exact_method",
            "e by the exact method",
            "",
            by_exact,
        ),
        ("impulse_n_s", "impulse", "N·s", impulse),
        ("peak_force_n", "peak force", "N", peak),
        ("max_deformation_m", "largest deformation", "m", deepest),
        ("contact_duration_s", "duration of contact", "s", duration),
    ];
    facts.extend(numbers.map(number));
    let parameters = serde_json::to_string(&certificate.law).expect("a law is plain data");
    let clamp = match certificate.law.clamp() {
        Clamp::Never => "never",
        Clamp::DrivenApart => "only where something else drives the pair apart; clamped",
        Clamp::EveryCollision => "at the end of every collision; clamped",
    };
    facts.push(named("would_pull", "would pull", clamp));
    facts.push(named("parameters", "parameters", &parameters));
    facts
}

fn line(
    certificate: &Certificate,
    collision: &FreeCollision,
    (method, step): (StepMethod, f64),
) -> Line {
    let delivered = certificate.by(collision, &method.at(step));
    Line {
        method,
        step,
        delivered: delivered.map_err(|error| error.to_string()),
    }
}
