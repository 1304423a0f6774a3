//! The e that laws deliver to the free pair, against the requested e and against the approach speed.

use pounding_contact::{FreeImpact, FreePair, LawName};

use super::entry::{Entry, by_name, label, mark, shade};
use crate::drivers::pairs;
use crate::study::laws::{AtlasSettings, is_linear};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Panel, Shade};
use pounding_scene::{Certificate, parallel};
use pounding_text::{Cell, Table};

/// A law with a requested e.
#[derive(Debug)]
pub(super) struct CalibratedLaw {
    law: LawName,
    restitution: f64,
    /// The certificate of the exact calibration, or the reason why there is none.
    outcome: Result<Certificate, String>,
}

/// Calibrates every law to every e.
pub(super) fn ask(settings: &AtlasSettings) -> Vec<CalibratedLaw> {
    let answer = |&(law, restitution): &(&LawName, &f64)| {
        let certificate = settings.certificate(*law, *restitution);
        CalibratedLaw {
            law: *law,
            restitution: *restitution,
            outcome: certificate.map_err(|error| error.to_string()),
        }
    };
    parallel::each(&pairs(&LawName::ALL, &settings.restitutions), answer)
}

/// Table of the requested e, and of the e delivered after either calibration.
pub(super) fn table(asked: &[CalibratedLaw]) -> String {
    let found = |asked: &CalibratedLaw| asked.outcome.as_ref().ok().map(|found| (found.by_formula, found.by_exact));
    Table::of(asked)
        .column("law", |asked| asked.law.name())
        .column("restitution_asked", |asked| asked.restitution)
        .column("delivered_by_literature_calibration", |asked| {
            found(asked).and_then(|found| found.0)
        })
        .column("delivered_by_exact_calibration", |asked| {
            Cell::number(found(asked).map(|found| found.1), |e| format!("{e:.12}"))
        })
        .column("failed", |asked| asked.outcome.as_ref().err().cloned())
        .csv()
}

/// Table of the e delivered at other approach speeds, with the damping that is exact at one of them.
pub(super) fn speeds(entries: &[Entry], settings: &AtlasSettings) -> String {
    let of_entry = |entry| {
        let law = &Entry::law(entry);
        let delivered = |approach_speed: &f64| {
            let pair = FreePair {
                approach_speed: *approach_speed,
                ..settings.collision().free_pair()
            };
            let integrated = FreeImpact::of(law, &pair).map(|impact| impact.restitution);
            (*approach_speed, integrated.or_else(|| law.restitution()))
        };
        by_name(entry, settings.approach_speeds_m_per_s.iter().map(delivered))
    };
    Table::of(entries.iter().flat_map(of_entry))
        .column("law", |(name, ..)| name.name())
        .column("approach_speed_m_per_s", |(.., (speed, _))| *speed)
        .column("delivered", |(.., (_, delivered))| *delivered)
        .csv()
}

/// Range of deviations in the lower panel \[–\]; larger ones show in the upper panel.
const OFF: (f64, f64) = (-0.06, 0.18);

/// Figure of the e delivered by the literature's formulas over the requested e, with the deviation in a lower panel.
pub(super) fn figure(asked: &[CalibratedLaw]) -> Figure {
    let families: [(&str, &dyn Fn(LawName) -> bool); 2] = [("Linear springs", &is_linear), ("Hertz springs", &|law| !is_linear(law))];
    let delivered = families.map(|(title, wanted)| {
        let diagonal = Curve::new(CurveKind::Dashed, Shade::Ink, vec![(0.0, 0.0), (1.0, 1.0)]).named("As asked");
        let curves = [diagonal].into_iter().chain(curves(asked, wanted, |_, found| found));
        Panel {
            weight: 1.6,
            ..Panel::shared(title, Axis::over("Restitution delivered", 0.0, 1.0), curves.collect())
        }
    });
    let off = families.map(|(_, wanted)| {
        let y = Axis::over("Delivered − asked for", OFF.0, OFF.1);
        Panel::shared("", y, curves(asked, wanted, |e, found| found - e)).with_level(0.0)
    });
    let panels = delivered.into_iter().chain(off).collect();
    Figure::grid(6.6, 2, Axis::over("Restitution asked for", 0.0, 1.0), panels).labelled_at_left()
}

/// A curve for each law with a formula; `value` computes its y from the requested and the delivered e.
fn curves(asked: &[CalibratedLaw], wanted: &dyn Fn(LawName) -> bool, value: impl Fn(f64, f64) -> f64) -> Vec<Curve> {
    let curve = |law: LawName| {
        let point = |asked: &CalibratedLaw| {
            let found = asked.outcome.as_ref().ok()?.by_formula?;
            let e = asked.restitution;
            (asked.law == law).then_some((e, value(e, found)))
        };
        let points: Vec<_> = asked.iter().filter_map(point).collect();
        let curve = Curve::new(CurveKind::Line, shade(law), points).marked(mark(law));
        curve.named(label(law))
    };
    let laws = LawName::ALL.into_iter().filter(|law| wanted(*law));
    let curves = laws.map(curve);
    curves.filter(|curve| !curve.points.is_empty()).collect()
}
