//! The figures of stripes: fragilities, responses over the intensity, parts of the frequency.

use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Panel, Shade, render_both};
use pounding_risk::{Fragility, Risk, State, StripeRun};

use super::answer::RANGES;
use super::{Demand, RiskReport};
use crate::figures::Illustration;

/// The names that pictures can have, without the ends of their files.
pub(super) const NAMES: [&str; 3] = ["fragility", "ida-curves", "contributions"];

/// Points of a curve.
const POINTS: u32 = 120;

/// Height of a picture on paper \[inch\].
const HEIGHT: f64 = 3.4;

/// The pictures; those that would show nothing are left out.
pub(super) fn all(report: &RiskReport<'_>) -> Vec<Illustration> {
    let figures = [fragilities(report), responses(report), contributions(report)];
    let all = NAMES.into_iter().zip(figures);
    all.filter_map(|(name, figure)| {
        Some(Illustration {
            name,
            caption: String::new(),
            drawn: render_both(&figure?),
        })
    })
    .collect()
}

/// The axis of intensities.
fn intensities(report: &RiskReport<'_>) -> Axis {
    let all = &report.runs.intensities;
    let axis = Axis {
        range: all.first().zip(all.last()).map(|(from, to)| (from / 1.2, to * 1.2)),
        ..Axis::auto(format!("{} (g)", report.measured()))
    };
    axis.log()
}

/// Intensities at which curves are drawn.
fn along(report: &RiskReport<'_>) -> Vec<f64> {
    let all = &report.runs.intensities;
    let (Some(from), Some(to)) = (all.first(), all.last()) else {
        return Vec::new();
    };
    let (from, ratio) = (from / 1.2, 1.44 * to / from);
    let at = |index: u32| from * libm::pow(ratio, f64::from(index) / f64::from(POINTS));
    (0..=POINTS).map(at).collect()
}

/// Shares of events at each intensity and the fragilities; `None` if no state has one.
fn fragilities(report: &RiskReport<'_>) -> Option<Figure> {
    let known = report.states.iter().enumerate().filter(|(_, (_, risk))| risk.fragility().is_some());
    let along = along(report);
    let mut curves = Vec::new();
    for (index, (state, risk)) in known {
        let shade = Shade::nth(index);
        let fragility = risk.fragility()?;
        let curve = |of: &dyn Fn(f64) -> Option<f64>| along.iter().filter_map(|im| Some((*im, 100.0 * of(*im)?))).collect::<Vec<_>>();
        if index == 0 {
            for end in [0, 1] {
                let points = curve(&|im| Some(risk.bounds(|one: &Fragility| one.probability(im))?[end]));
                let bound = Curve::new(CurveKind::Dashed, shade, points);
                curves.push(if end == 0 { bound.named("95 % bounds") } else { bound });
            }
        }
        curves.push(Curve::new(CurveKind::Line, shade, curve(&|im| Some(fragility.probability(im)))).named(state.shown()));
        curves.push(Curve::new(CurveKind::Points, shade, shares(risk)));
    }
    curves.retain(|curve| !curve.points.is_empty());
    let panel = Panel::shared("", Axis::over("Share of events (%)", 0.0, 100.0), curves);
    let is_empty = panel.curves.is_empty();
    (!is_empty).then(|| Figure::grid(HEIGHT, 1, intensities(report), vec![panel]))
}

/// Share of events at each intensity \[%\].
fn shares(risk: &Risk) -> Vec<(f64, f64)> {
    let stripes = risk.stripes.all.iter().filter(|stripe| stripe.n() > 0);
    stripes.map(|stripe| (stripe.intensity, 100.0 * stripe.share())).collect()
}

/// The number that the first state limits under every motion over the intensity, and its quantiles; `None` of a collapse.
fn responses(report: &RiskReport<'_>) -> Option<Figure> {
    let mut states = report.states.iter().map(|(state, _)| *state);
    let state = states.find(|state| Demand::of(*state).is_some())?;
    let words = Demand::of(state)?;
    let demand = |run: &StripeRun| Some(words.factor * state.demand(run.found.as_ref().ok()?)?);
    let mut curves: Vec<Curve> = Vec::new();
    if report.runs.same_events {
        let of_motions = report.runs.runs.chunk_by(|one, other| one.motion == other.motion);
        curves.extend(of_motions.map(|runs| {
            let points = runs
                .iter()
                .filter_map(|run| Some((report.runs.intensities[run.stripe], demand(run)?)));
            Curve::new(CurveKind::Thin, Shade::Grey, points.collect())
        }));
    } else {
        let runs = report.runs.runs.iter();
        let points = runs.filter_map(|run| Some((report.runs.intensities[run.stripe], demand(run)?)));
        curves.push(Curve::new(CurveKind::Points, Shade::Grey, points.collect()));
    }
    for (part, kind, name) in [
        (0.16, CurveKind::Dashed, Some("16 and 84 %")),
        (0.84, CurveKind::Dashed, None),
        (0.5, CurveKind::Line, Some("median")),
    ] {
        let curve = Curve::new(kind, Shade::Blue, quantiles(report, state, &words, part));
        curves.push(Curve {
            label: name.map(String::from),
            ..curve
        });
    }
    if let Some(limit) = state.limit(&report.runs.gaps) {
        let limit = words.factor * limit;
        let ends = along(report).into_iter().map(|im| (im, limit)).collect();
        let name = if matches!(state, State::Touch(_)) { "gap" } else { "limit" };
        curves.push(Curve::new(CurveKind::Dashed, Shade::Vermilion, ends).named(name));
    }
    curves.retain(|curve| !curve.points.is_empty());
    let largest = curves
        .iter()
        .flat_map(|curve| &curve.points)
        .map(|point| point.1)
        .fold(0.0, f64::max);
    let panel = Panel {
        legend: Legend::Above,
        ..Panel::shared("", Axis::over(words.label, 0.0, 1.05 * largest), curves)
    };
    Some(Figure::grid(HEIGHT, 1, intensities(report), vec![panel]))
}

/// A quantile of a number over the motions at each intensity.
fn quantiles(report: &RiskReport<'_>, state: State, words: &Demand, part: f64) -> Vec<(f64, f64)> {
    let of = |(stripe, intensity): (usize, &f64)| {
        let runs = report.runs.runs.iter().filter(|run| run.stripe == stripe);
        let numbers = runs.filter_map(|run| Some(words.factor * state.demand(run.found.as_ref().ok()?)?));
        let all = pounding_assess::Distribution::of(numbers)?;
        Some((*intensity, all.quantile(part)))
    };
    report.runs.intensities.iter().enumerate().filter_map(of).collect()
}

/// Parts of the annual frequency of the first state by intensity; `None` without a frequency.
fn contributions(report: &RiskReport<'_>) -> Option<Figure> {
    let (_, risk) = report.states.first()?;
    let all = report.hazard?.contributions(risk.fragility()?, RANGES);
    let whole: f64 = all.iter().map(|one| one.rate).sum();
    // Steps: each range from its least to its largest intensity.
    let steps = all.iter().flat_map(|one| {
        let part = 100.0 * one.rate / whole;
        one.intensities.map(|im| (im, part))
    });
    let curve = Curve::new(CurveKind::Area, Shade::Blue, steps.collect());
    let panel = Panel {
        legend: Legend::Hidden,
        ..Panel::shared("", Axis::auto("Part of λ (%)"), vec![curve])
    };
    (whole > 0.0).then(|| {
        let x = Axis::auto(format!("{} (g)", report.measured())).log();
        Figure::grid(2.6, 1, x, vec![panel])
    })
}
