//! `pounding laws`: every law with its force, formulas, parameters and source.

use pounding::contact::{Exact, LawName};
use pounding::text::{Answer, Form, Manner, Table, Where};
use serde_json::json;

const EXAMPLES: &str = "\
Examples:
  pounding laws
  pounding laws --json > laws.json
  pounding certify hertz_damp --restitution 0.65 --masses 75e3 3e6 --speed 0.3";

/// The arguments of `laws`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

/// Every law. The formula and the relation of a law that has none are null for programs.
pub(crate) fn run(args: &Arguments) -> String {
    let laws = Table::of(LawName::ALL)
        .column("name", |law| law.name())
        .column("force", |law| law.about().force)
        .column("formula", |law| formula(*law))
        .column("delivers", |law| law.about().relation)
        .column("fields", |law| json!(fields(*law)))
        .column("source", |law| law.named().citation);
    let answer = LawName::ALL.into_iter().fold(Answer::new(), |answer, law| {
        let formula = formula(law).map(|formula| format!("Formula: {formula}"));
        let lines = [
            Some(format!("Law: {}", law.name())),
            Some(format!("Force: {}", law.about().force)),
            formula,
            Some(format!("Delivers: {}", law.about().relation.unwrap_or("found numerically"))),
            Some(format!("Fields: {}", words(law))),
            Some(format!("Source: {}", law.named().citation)),
        ];
        answer.say_as(Where::Terminal, Manner::Facts, "", lines.into_iter().flatten().collect())
    });
    answer
        .say(Where::Terminal, "Notes", NOTES.map(String::from).into())
        .fact("laws", laws.json())
        .text(Form::asked(false, false, args.json))
}

fn formula(law: LawName) -> Option<&'static str> {
    law.named().formula.map(|(text, _)| text)
}

fn fields(law: LawName) -> Vec<&'static str> {
    law.parameters().iter().map(|row| row.name).collect()
}

/// The words of a scene for a law: its force, if that has another name, and its fields.
fn words(law: LawName) -> String {
    let force = law.about().names[0].name;
    let force = if force == law.name() {
        String::new()
    } else {
        format!("{force} with ")
    };
    let restitution = match law.about().exact {
        Exact::Any(_) => "; in place of the damping `restitution` and `calibration`",
        Exact::Parameter | Exact::Elastic | Exact::Pair(..) => "",
    };
    format!("{force}{}{restitution}", fields(law).join(", "))
}

const NOTES: [&str; 3] = [
    "δ deformation, δ̇ its rate, v₀ approach speed, m reduced mass, e restitution.",
    "Formula: the authors' damping for an e asked. Delivers: the e of a free impact, exactly. Fields: the words of a scene.",
    "`pounding certify` prints what a law and a method really deliver.",
];
