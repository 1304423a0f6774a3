//! `pounding laws`: every law with its force, formulas, parameters and source.

use pounding::contact::{Exact, LawName, Slab};
use pounding::text::{Answer, Form, Manner, Refused, Table, Where, short};
use serde_json::json;

use super::slabs;

const EXAMPLES: &str = "\
Examples:
  pounding laws
  pounding laws --json > laws.json
  pounding laws --slab-area 3 --slab-length 20   # stiffness of slabs
  pounding certify hertz_damp --restitution 0.65 --masses 75e3 3e6 --speed 0.3";

/// The arguments of `laws`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    slabs: slabs::Arguments,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

/// Every law, or the impact stiffness of the slabs that are told. The formula and the relation of a law that has none are null for programs.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let answer = args.slabs.slabs()?.map_or_else(all, |slabs| of_slabs(&slabs));
    Ok(answer.text(Form::asked(false, false, args.json)))
}

/// The impact stiffness of slabs.
fn of_slabs(slabs: &[Slab; 2]) -> Answer<'static> {
    let stiffness = Slab::impact_stiffness(slabs);
    let (each, times) = (slabs.map(|slab| slab.stiffness()), slabs.map(|slab| slab.wave_time()));
    let [left, right] = each.map(rounded);
    let ms = short(1e3 * times[0].max(times[1]));
    let facts = vec![
        format!(
            "Impact stiffness: {} N/m, from {left} N/m on the left and {right} N/m on the right",
            rounded(stiffness)
        ),
        format!("In a scene: law.kelvin_voigt = {}", linear(stiffness)),
        format!("Wave: {ms} ms through the longer slab of concrete and back"),
    ];
    let notes = [
        "It is an upper estimate, since rough surfaces and uneven edges give way first. Forces grow as the root of the stiffness.",
        "In a collision that is not much longer than the wave's time a floor is no rigid mass (Cole et al., EESD 40 (2011) 641).",
        "`pounding assess` tells what a range around the stiffness of a scene changes.",
    ];
    Answer::new()
        .say_as(Where::Terminal, Manner::Facts, "", facts)
        .say(Where::Terminal, "Notes", notes.map(String::from).into())
        .fact("impact_stiffness_n_per_m", json!(stiffness))
        .fact("slab_stiffness_n_per_m", json!(each))
        .fact("wave_time_s", json!(times))
}

/// The parameters of a linear law with a stiffness \[N/m\], as a scene writes them.
pub(super) fn linear(stiffness: f64) -> String {
    format!("{{ impact_stiffness_n_per_m = {}, restitution = 0.65 }}", rounded(stiffness))
}

/// A number with four digits: nobody knows a section and a length better.
fn rounded(value: f64) -> String {
    let text = format!("{value:.3e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{}e{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
}

fn all() -> Answer<'static> {
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
