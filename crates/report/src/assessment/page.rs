//! `report.html` of an assessment: the answer on the first page, the rest behind it.

use super::AssessmentReport;
use crate::figures::Illustration;
use crate::page::markup::{escaped, facts, short};
use crate::page::{Numbered, answer, document};

pub(super) fn html(report: &AssessmentReport, figures: &[Illustration]) -> String {
    let title = escaped(&report.scene.name);
    let mut numbered = Numbered::of(figures);
    let figure = |name: &str| match (name, &report.animation) {
        ("animation", Some(animation)) => animation.figure(),
        ("animation", None) => numbered.figure("row"),
        (name, _) => numbered.figure(name),
    };
    let body = [
        format!("<h1>{title}: is the gap enough?</h1>\n<p>{}</p>\n", escaped(&lead(report))),
        answer::html(&report.answer(), figure),
        again(report),
    ];
    let signed = signed(report).unwrap_or_default();
    document(&report.scene.name, &signed, &body.concat())
}

/// Author and date, as far as they are given.
fn signed(report: &AssessmentReport) -> Option<String> {
    let signed = [&report.author, &report.date].into_iter().flatten();
    let signed: Vec<&str> = signed.map(String::as_str).collect();
    (!signed.is_empty()).then(|| signed.join(", "))
}

fn lead(report: &AssessmentReport) -> String {
    let signed = signed(report).map_or_else(String::new, |signed| format!(" {signed}."));
    format!(
        "{} structures in a row under {}, each in both directions, computed by pounding {} with the exact method.{signed}",
        report.scene.structures.len(),
        report.motions_of_events(),
        env!("CARGO_PKG_VERSION"),
    )
}

fn again(report: &AssessmentReport) -> String {
    let words = [&report.scaling.words, &report.bumper_words];
    let words: Vec<&str> = words.into_iter().flatten().map(String::as_str).collect();
    let words = words.iter().map(|words| [" ", words].concat());
    let scaling = words.collect::<Vec<_>>().concat();
    let scene = serde_json::to_string_pretty(&report.asked).unwrap_or_default();
    let said = facts(&[
        ("Records".into(), "those named under Motions; assess.json lists them".into()),
        ("Scaling of records".into(), report.scaling.to.to_string()),
        (
            "Stiffness of impacts".into(),
            format!(
                "{} to {} times that of the scene",
                short(report.stiffness[0]),
                short(report.stiffness[1])
            ),
        ),
    ]);
    format!(
        "<h2>How to repeat it</h2>\n<p>Save the scene below as <code>scene.json</code> and run, with pounding {},</p>\n\
         <pre>pounding assess scene.json --records FOLDER{} --stiffness {}..{} --out assessed</pre>\n{said}<pre class=\"scene\">{}</pre>\n",
        env!("CARGO_PKG_VERSION"),
        escaped(&scaling),
        short(report.stiffness[0]),
        short(report.stiffness[1]),
        escaped(&scene)
    )
}
