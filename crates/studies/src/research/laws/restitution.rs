//! The e that laws deliver to the free pair against the e asked of them, and against the approach speed.

use pounding_contact::{FreeImpact, FreePair, LawName};

use super::entry::{Entry, key, label, mark, shade};
use crate::study::laws::{AtlasSettings, is_linear};
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Panel, Shade};
use pounding_scene::{Certificate, parallel};
use pounding_text::digits;
use pounding_text::to_csv;

/// What a law delivers when it is asked for an e.
#[derive(Debug)]
pub(super) struct Asked {
    law: LawName,
    restitution: f64,
    /// The certificate of the exact calibration, or why there is none.
    outcome: Result<Certificate, String>,
}

/// Asks every law for every e.
pub(super) fn ask(settings: &AtlasSettings) -> Vec<Asked> {
    let questions: Vec<_> = LawName::ALL
        .into_iter()
        .flat_map(|law| settings.restitutions.iter().map(move |e| (law, *e)))
        .collect();
    let answer = |&(law, restitution): &(LawName, f64)| {
        let certificate = settings.certificate(law, restitution);
        Asked {
            law,
            restitution,
            outcome: certificate.map_err(|error| error.to_string()),
        }
    };
    parallel::each(&questions, answer)
}

/// e asked for, and delivered by either calibration.
pub(super) fn table(asked: &[Asked]) -> String {
    let header = [
        "law",
        "restitution_asked",
        "delivered_by_literature_calibration",
        "delivered_by_exact_calibration",
        "failed",
    ];
    let row = |asked: &Asked| {
        let (formula, exact, failed) = match &asked.outcome {
            Ok(found) => (
                found.by_formula.map_or_else(String::new, digits),
                format!("{:.12}", found.by_exact),
                String::new(),
            ),
            Err(reason) => (String::new(), String::new(), reason.clone()),
        };
        let e = digits(asked.restitution);
        vec![key(asked.law), e, formula, exact, failed]
    };
    to_csv(&header.map(String::from), &asked.iter().map(row).collect::<Vec<_>>())
}

/// e delivered at other approach speeds, with the damping that is exact at one of them.
pub(super) fn speeds(entries: &[Entry], settings: &AtlasSettings) -> String {
    let header = ["law", "approach_speed_m_per_s", "delivered"];
    let mut rows = Vec::new();
    for entry in entries {
        let law = &entry.certificate.law;
        let delivered = |speed: f64| {
            let pair = FreePair {
                approach_speed: speed,
                ..settings.collision().free_pair()
            };
            let integrated = FreeImpact::of(law, &pair).map(|impact| impact.restitution);
            integrated.or_else(|| law.restitution())
        };
        let found: Vec<_> = settings
            .approach_speeds_m_per_s
            .iter()
            .map(|speed| (*speed, delivered(*speed).map_or_else(String::new, digits)))
            .collect();
        rows.extend(entry.rows(|name| {
            let row = |(speed, found): &(f64, String)| vec![name.clone(), digits(*speed), found.clone()];
            found.iter().map(row).collect()
        }));
    }
    to_csv(&header.map(String::from), &rows)
}

/// How far off is shown: what is further off is told apart above.
const OFF: (f64, f64) = (-0.06, 0.18);

/// e delivered by the literature's formulas against e asked for; below, how far that is off.
pub(super) fn figure(asked: &[Asked]) -> Figure {
    let labels = |text: &'static str| [text, ""].into_iter();
    let families: [(&str, &dyn Fn(LawName) -> bool); 2] = [("Linear springs", &is_linear), ("Hertz springs", &|law| !is_linear(law))];
    let delivered = families.iter().zip(labels("Restitution delivered"));
    let delivered = delivered.map(|((title, wanted), label)| {
        let diagonal = Curve::new(Kind::Dashed, Shade::Ink, vec![(0.0, 0.0), (1.0, 1.0)]);
        let mut curves = vec![diagonal.named("As asked")];
        curves.extend(self::curves(asked, wanted, |_, found| found));
        Panel {
            title: (*title).into(),
            y: Axis::over(label, 0.0, 1.0),
            curves,
            legend: Legend::Shared,
            weight: 1.6,
            ..Panel::default()
        }
    });
    let off = families.iter().zip(labels("Delivered − asked for"));
    let off = off.map(|((_, wanted), label)| Panel {
        y: Axis::over(label, OFF.0, OFF.1),
        curves: curves(asked, wanted, |e, found| found - e),
        levels: vec![0.0],
        legend: Legend::Shared,
        ..Panel::default()
    });
    Figure {
        height_in: 6.6,
        columns: 2,
        x: Axis::over("Restitution asked for", 0.0, 1.0),
        panels: delivered.chain(off).collect(),
    }
}

/// A curve for each law that has a formula, of e asked for and delivered.
fn curves(asked: &[Asked], wanted: &dyn Fn(LawName) -> bool, value: impl Fn(f64, f64) -> f64) -> Vec<Curve> {
    let curve = |law: LawName| {
        let point = |asked: &Asked| {
            let found = asked.outcome.as_ref().ok()?.by_formula?;
            let e = asked.restitution;
            (asked.law == law).then_some((e, value(e, found)))
        };
        let points: Vec<_> = asked.iter().filter_map(point).collect();
        let curve = Curve::new(Kind::Line, shade(law), points).marked(mark(law));
        curve.named(label(law))
    };
    let laws = LawName::ALL.into_iter().filter(|law| wanted(*law));
    let curves = laws.map(curve);
    curves.filter(|curve| !curve.points.is_empty()).collect()
}
