//! Rules against the ratio of periods, and what gaps do that are too narrow.

use super::gaps::{Gaps, Quantity, Swept};
use super::widths::Widths;
use crate::statistics::{quantile, sorted};
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Panel, Shade};
use pounding_scene::Rule;

/// Rules with panels of their own; that of ASCE 7 is SRSS here.
const RULES: [(Rule, &str, Shade); 4] = [
    (Rule::Abs, "ABS", Shade::Grey),
    (Rule::Srss, "SRSS, ASCE 7", Shade::Blue),
    (Rule::Ddc, "DDC", Shade::Vermilion),
    (Rule::Eurocode8, "EC 8, level floors", Shade::Ink),
];

/// What is drawn of required over asked for.
const SHOWN: [(f64, &str, Kind, Shade); 3] = [
    (1.0, "largest", Kind::Thin, Shade::Vermilion),
    (0.95, "95 % quantile", Kind::Dashed, Shade::Blue),
    (0.5, "median", Kind::Line, Shade::Ink),
];

/// A panel per rule: required over asked for.
pub(super) fn rules(widths: &Widths<'_>) -> Figure {
    let mut panels = Vec::new();
    for (index, (rule, title, _)) in RULES.into_iter().enumerate() {
        let curve = |(part, name, kind, shade): (f64, &str, Kind, Shade)| {
            let point = |ratio: &f64| (*ratio, widths.score(rule, Some(*ratio)).quantile(part));
            Curve::new(kind, shade, widths.ratios.iter().map(point).collect()).named(name)
        };
        panels.push(Panel {
            title: title.into(),
            y: Axis::over(if index % 2 == 0 { "Required / asked for (–)" } else { "" }, 0.0, 2.2),
            curves: SHOWN.map(curve).into(),
            levels: vec![1.0],
            legend: Legend::Shared,
            ..Panel::default()
        });
    }
    Figure {
        height_in: 5.6,
        columns: 2,
        x: ratio_of_periods(),
        panels,
    }
}

fn ratio_of_periods() -> Axis {
    Axis::over("Ratio of periods, shorter / longer (–)", 0.0, 1.0)
}

/// The share of cases in which each rule asks for less than is required.
pub(super) fn shares(widths: &Widths<'_>) -> Figure {
    let share = |(rule, name, shade): (Rule, &str, Shade)| {
        let point = |ratio: &f64| (*ratio, 100.0 * widths.score(rule, Some(*ratio)).share());
        let kind = if shade == Shade::Vermilion { Kind::Dashed } else { Kind::Line };
        Curve::new(kind, shade, widths.ratios.iter().map(point).collect()).named(name)
    };
    Figure {
        height_in: 3.4,
        columns: 1,
        x: ratio_of_periods(),
        panels: vec![Panel {
            y: Axis::over("Cases in which the rule is unsafe (%)", 0.0, 100.0),
            curves: RULES.map(share).into(),
            ..Panel::default()
        }],
    }
}

/// Panels of one ratio of periods side by side: what happens over the gap under every motion, with the median.
pub(super) fn gaps(gaps: &Gaps<'_>) -> Figure {
    let rows = [
        (Quantity::LeftDrift, Quantity::LeftBeyond, "Slower: drift / alone (–)"),
        (Quantity::RightDrift, Quantity::RightBeyond, "Faster: drift / alone (–)"),
    ];
    let mut panels = Vec::new();
    for (row, (quantity, beyond, label)) in rows.into_iter().enumerate() {
        for (column, ratio) in gaps.ratios.iter().enumerate() {
            let own: Vec<_> = gaps.swept.iter().filter(|one| one.asked.ratio.total_cmp(ratio).is_eq()).collect();
            let title = format!("Periods {ratio} : 1");
            panels.push(Panel {
                title: if row == 0 { title } else { String::new() },
                y: Axis {
                    label: if column == 0 { label.into() } else { String::new() },
                    range: Some((0.0, highest(gaps, quantity))),
                    ..Axis::default()
                },
                curves: curves(&own, quantity, beyond),
                levels: vec![1.0],
                legend: Legend::Shared,
                ..Panel::default()
            });
        }
    }
    Figure {
        height_in: 5.4,
        columns: gaps.ratios.len(),
        x: Axis::over("Gap / required (–)", 0.0, 1.0),
        panels,
    }
}

fn highest(gaps: &Gaps<'_>, quantity: Quantity) -> f64 {
    let points = gaps.swept.iter().flat_map(|one| one.curve(quantity));
    1.05 * points.fold(0.0, |high: f64, (_, value)| high.max(value))
}

/// Every case in grey, the median in ink, and the case with the largest rise beyond what the structure does alone.
fn curves(own: &[&Swept<'_>], quantity: Quantity, beyond: Quantity) -> Vec<Curve> {
    let curves: Vec<_> = own.iter().map(|one| one.curve(quantity)).collect();
    let mut drawn: Vec<Curve> = curves
        .iter()
        .map(|points| Curve::new(Kind::Thin, Shade::Silver, points.clone()))
        .collect();
    if let Some(first) = drawn.first_mut() {
        *first = first.clone().named("a motion and direction");
    }
    let n_gaps = curves.iter().map(Vec::len).min().unwrap_or(0);
    let median = |index: usize| {
        let values = sorted(curves.iter().map(|curve| curve[index].1));
        Some((curves.first()?[index].0, quantile(&values, 0.5)?))
    };
    let median: Vec<_> = (0..n_gaps).filter_map(median).collect();
    let steepest = own.iter().max_by(|one, other| {
        let rise = |one: &Swept<'_>| one.worst(beyond);
        rise(one).total_cmp(&rise(other))
    });
    if let Some(steepest) = steepest {
        let points = steepest.curve(quantity);
        let name = "the one that rises most beyond alone";
        drawn.push(Curve::new(Kind::Line, Shade::Vermilion, points).named(name));
    }
    drawn.push(Curve::new(Kind::Line, Shade::Ink, median).named("median"));
    drawn
}
