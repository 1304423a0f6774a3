//! `pounding laws`: every law with its force, formulas, parameters and source.

use pounding::contact::LawName;
use serde_json::json;

use crate::text::paragraph;
use pounding::text::json_text;

const EXAMPLES: &str = "\
Examples:
  pounding laws
  pounding laws --json > laws.json
  pounding certify hertz_damp --restitution 0.65 --masses 75e3 3e6 --speed 0.3";

/// What is asked of `laws`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

/// Every law.
pub(crate) fn run(args: &Arguments) -> String {
    if args.json { json_of_all() } else { text() }
}

fn text() -> String {
    let law = |name: &LawName| {
        let (about, named) = (name.about(), name.named());
        let lines = [
            ("Law", Some(named.name)),
            ("Force", Some(about.force)),
            ("Formula", named.formula.map(|(text, _)| text)),
            ("Delivers", about.relation.or(Some("found numerically"))),
            ("Fields", Some(&fields(*name).join(", "))),
            ("Source", Some(named.citation)),
        ];
        let lines = lines.into_iter().filter_map(|(label, text)| Some(paragraph(label, text?)));
        lines.collect::<String>()
    };
    let laws: Vec<_> = LawName::ALL.iter().map(law).collect();
    format!("{}\n{}", laws.join("\n"), paragraph("Notes", NOTES))
}

fn fields(law: LawName) -> Vec<&'static str> {
    law.parameters().iter().map(|row| row.name).collect()
}

/// What is not known of a law is null: the formula of one without, the relation of one whose e is found numerically.
fn json_of_all() -> String {
    let law = |name: &LawName| {
        let (about, named) = (name.about(), name.named());
        json!({
            "name": named.name,
            "force": about.force,
            "formula": named.formula.map(|(text, _)| text),
            "delivers": about.relation,
            "fields": fields(*name),
            "source": named.citation,
        })
    };
    let laws: Vec<_> = LawName::ALL.iter().map(law).collect();
    json_text(&json!({ "laws": laws }))
}

const NOTES: &str = "δ deformation, δ̇ its rate, v₀ approach speed, m reduced mass, e restitution.\nFormula: \
                     the authors' damping for an e asked. Delivers: the e of a free impact, exactly. Fields: as in a \
                     scene, where corrected_hertz_damp, hunt_crossley and gonthier are hertz_damp; instead of its damping a law \
                     may be given a `restitution` and a `calibration`.\n`pounding certify` \
                     prints what a law and a method really deliver.";
