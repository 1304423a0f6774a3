//! `pounding laws` and `pounding certify`.

mod printed;

use pounding::contact::{Clamp, LawName};
use pounding::studies::{Certificate, CertificateError, FreeCollision, StepMethod, Wanted};

use crate::arguments::{Certify, Format};
use crate::text::paragraph;
use printed::{Cell, Fact, Line};

/// Impact stiffness of the pounding literature for Hertz springs \[N/m^1.5\].
const HERTZ: f64 = 2.75e9;
/// The same for linear springs \[N/m\].
const LINEAR: f64 = 9.35e7;

/// Every law: its force, formulas, parameters and source.
pub(crate) fn laws() -> String {
    let law = |name: &LawName| {
        let about = name.description();
        let lines = [
            ("Law", Some(about.name)),
            ("Force", Some(about.force)),
            ("Formula", about.formula),
            ("Delivers", about.relation.or(Some("found numerically"))),
            ("Fields", Some(&about.parameters.join(", "))),
            ("Source", Some(about.citation)),
        ];
        let lines = lines
            .into_iter()
            .filter_map(|(label, text)| Some(paragraph(label, text?)));
        lines.collect::<String>()
    };
    let laws: Vec<_> = LawName::ALL.iter().map(law).collect();
    format!("{}\n{}", laws.join("\n"), paragraph("Notes", NOTES))
}

const NOTES: &str = "δ deformation, δ̇ its rate, v₀ approach speed, m reduced mass, e restitution.\nFormula: \
                     the authors' damping for an e asked. Delivers: the e of a free impact, exactly. Fields: as in a \
                     scene, where corrected_hertz_damp, hunt_crossley and gonthier are hertz_damp; instead of its damping a law \
                     may be given a `restitution` and a `calibration`.\n`pounding certify` \
                     prints what a law and a method really deliver.";

/// The certificate that was asked for.
pub(crate) fn certify(asked: &Certify) -> Result<String, String> {
    let law = asked.law;
    let usual = match law.stiffness_unit() {
        Some("N/m") => LINEAR,
        _ => HERTZ,
    };
    let wanted = Wanted {
        law,
        stiffness: asked.stiffness.unwrap_or(usual),
        restitution: asked.restitution,
        calibration: asked.calibration.into(),
    };
    let collision = FreeCollision {
        masses: [asked.masses[0], asked.masses[1]],
        speed: asked.speed,
    };
    let message = |error: CertificateError| error.to_string();
    let certificate = Certificate::new(&wanted, &collision).map_err(message)?;
    let methods = match (asked.time_step, asked.method) {
        (None, _) => Vec::new(),
        (Some(step), Some(method)) => vec![line(&certificate, &collision, (method, step))],
        (Some(step), None) => StepMethod::differing(certificate.law.impulsive().is_some())
            .map(|method| line(&certificate, &collision, (method, step)))
            .collect(),
    };
    let facts = facts(&wanted, &collision, &certificate);
    Ok(match asked.format {
        Format::Text => printed::text(wanted.calibration, &facts, &methods),
        Format::Csv => printed::csv(&facts, &methods),
        Format::Json => printed::json(&facts, &methods),
    })
}

/// The lines of the certificate.
fn facts(wanted: &Wanted, collision: &FreeCollision, certificate: &Certificate) -> Vec<Fact> {
    let named = |key, words, text: &str| Fact {
        key,
        words,
        unit: "",
        cell: Cell::Words(text.into()),
    };
    let number = |(key, words, unit, number)| Fact {
        key,
        words,
        unit,
        cell: Cell::Number(number),
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
