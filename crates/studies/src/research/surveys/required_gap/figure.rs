//! Figures of gap rules over the ratio of periods, and of the effects of gaps that are too narrow.

use super::Widths;
use super::gaps::{Gaps, Quantity, Swept};
use crate::statistics::{quantile, sorted};
use pounding_assess::Rule;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Panel, Shade};

/// Rules with their own panels; the rule of ASCE 7 is SRSS here.
const RULES: [(Rule, &str, Shade); 4] = [
    (Rule::Abs, "ABS", Shade::Grey),
    (Rule::Srss, "SRSS, ASCE 7", Shade::Blue),
    (Rule::Ddc, "DDC", Shade::Vermilion),
    (Rule::Eurocode8, "EC 8, level floors", Shade::Ink),
];

/// Quantiles of the required gap over the gap of a rule, with their looks.
const SHOWN: [(f64, &str, CurveKind, Shade); 3] = [
    (1.0, "largest", CurveKind::Thin, Shade::Vermilion),
    (0.95, "95 % quantile", CurveKind::Dashed, Shade::Blue),
    (0.5, "median", CurveKind::Line, Shade::Ink),
];

/// Figure with one panel per rule: the required gap over the gap of the rule.
pub(super) fn rules(widths: &Widths<'_>) -> Figure {
    let panel = |(rule, title, _)| {
        let curve = |(part, name, kind, shade)| {
            let point = |ratio: &f64| (*ratio, widths.score(rule, Some(*ratio)).quantile(part));
            Curve::new(kind, shade, widths.ratios.iter().map(point).collect()).named(name)
        };
        let y = Axis::over("Required / asked for (–)", 0.0, 2.2);
        Panel::shared(title, y, SHOWN.map(curve).into()).with_level(1.0)
    };
    Figure::grid(5.6, 2, ratio_of_periods(), RULES.map(panel).into()).labelled_at_left()
}

fn ratio_of_periods() -> Axis {
    Axis::over("Ratio of periods, shorter / longer (–)", 0.0, 1.0)
}

/// Figure of the share of cases in which each rule gives a gap that is too narrow.
pub(super) fn shares(widths: &Widths<'_>) -> Figure {
    let share = |(rule, name, shade)| {
        let point = |ratio: &f64| (*ratio, 100.0 * widths.score(rule, Some(*ratio)).share());
        let kind = if shade == Shade::Vermilion {
            CurveKind::Dashed
        } else {
            CurveKind::Line
        };
        Curve::new(kind, shade, widths.ratios.iter().map(point).collect()).named(name)
    };
    let panel = Panel {
        y: Axis::over("Cases in which the rule is unsafe (%)", 0.0, 100.0),
        curves: RULES.map(share).into(),
        ..Panel::default()
    };
    Figure::grid(3.4, 1, ratio_of_periods(), vec![panel])
}

/// Figure for one ratio of periods: quantities over the gap under every motion, with the median.
pub(super) fn gaps(gaps: &Gaps<'_>) -> Figure {
    let rows = [
        (Quantity::LeftDrift, Quantity::LeftBeyond, "Slower: drift / alone (–)"),
        (Quantity::RightDrift, Quantity::RightBeyond, "Faster: drift / alone (–)"),
    ];
    let mut panels = Vec::new();
    for (quantity, beyond, label) in rows {
        for ratio in &gaps.ratios {
            let own: Vec<_> = gaps.swept.iter().filter(|one| one.asked.is_of(Some(*ratio))).collect();
            let title = if quantity == rows[0].0 {
                format!("Periods {ratio} : 1")
            } else {
                String::new()
            };
            let y = Axis::over(label, 0.0, highest(gaps, quantity));
            panels.push(Panel::shared(title, y, curves(&own, quantity, beyond)).with_level(1.0));
        }
    }
    let x = Axis::over("Gap / required (–)", 0.0, 1.0);
    Figure::grid(5.4, gaps.ratios.len(), x, panels).labelled_at_left()
}

fn highest(gaps: &Gaps<'_>, quantity: Quantity) -> f64 {
    let points = gaps.swept.iter().flat_map(|one| one.curve(quantity));
    1.05 * points.fold(0.0, |high: f64, (_, value)| high.max(value))
}

/// Every case in grey, the median in ink, and the case with the largest rise of the quantity `beyond`.
fn curves(own: &[&Swept<'_>], quantity: Quantity, beyond: Quantity) -> Vec<Curve> {
    let curves: Vec<_> = own.iter().map(|one| one.curve(quantity)).collect();
    let thin = |points: &Vec<_>| Curve::new(CurveKind::Thin, Shade::Silver, points.clone());
    let mut drawn: Vec<Curve> = curves.iter().map(thin).collect();
    if let Some(first) = drawn.first_mut() {
        *first = first.clone().named("a motion and direction");
    }
    let n_gaps = curves.iter().map(Vec::len).min().unwrap_or(0);
    let median = |index: usize| {
        let values = sorted(curves.iter().map(|curve| curve[index].1));
        Some((curves.first()?[index].0, quantile(&values, 0.5)?))
    };
    let median: Vec<_> = (0..n_gaps).filter_map(median).collect();
    let steepest = own.iter().max_by(|one, other| one.worst(beyond).total_cmp(&other.worst(beyond)));
    if let Some(steepest) = steepest {
        let points = steepest.curve(quantity);
        let name = "the one that rises most beyond alone";
        drawn.push(Curve::new(CurveKind::Line, Shade::Vermilion, points).named(name));
    }
    drawn.push(Curve::new(CurveKind::Line, Shade::Ink, median).named("median"));
    drawn
}
