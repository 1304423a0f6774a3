//! What the page of an assessment shows: the share of runs that need more than a gap, and amplifications.

use pounding_assess::{Distribution, GapAssessment};
use pounding_plot::{Axis, Curve, CurveKind, Drawing, Figure, Mark, Note, Panel, Shade, render_both, writable};
use pounding_text::millimetres;

use super::AssessmentReport;
use super::prior::OfNeighbour;
use super::{profiles, spectra};
use crate::figures::Illustration;
use crate::figures::effects::{as_alone, borders};
use crate::sketch::{self, Sketch};

/// The names that figures can have, without the ends of their files.
pub(super) const NAMES: [&str; 6] = ["row", "gap", "profiles", "neighbour", "amplification", "spectra"];

/// Most gaps of one figure.
const MOST_GAPS: usize = 6;
/// Most storeys of one figure.
const MOST: usize = 30;

pub(super) fn all(report: &AssessmentReport) -> Vec<Illustration> {
    let sketch: Drawing = sketch::drawing(&Sketch {
        scene: report.scene(),
        floors: report.floors(),
        touched: &touched(report),
    });
    let mut all = vec![Illustration {
        name: NAMES[0],
        caption: sketch::caption(report.scene()),
        drawn: render_both(&sketch),
    }];
    all.push(Illustration {
        name: NAMES[1],
        caption: format!(
            "Part of the events that need more than a gap while nothing touches. Dashed: the gaps of the scene.{}",
            beyond(report)
        ),
        drawn: render_both(&share(report)),
    });
    if let Some((figure, caption)) = spectra::figure(report) {
        all.push(Illustration {
            name: NAMES[5],
            caption,
            drawn: render_both(&figure),
        });
    }
    if let Some(figure) = profiles::figure(report) {
        all.push(Illustration {
            name: NAMES[2],
            caption: profiles::caption(report),
            drawn: render_both(&figure),
        });
    }
    if let Some(figure) = by_neighbour(report) {
        all.push(Illustration {
            name: NAMES[3],
            caption:
                "Gap that each of the neighbours needs that the unknown one may be, over its first period. Discs: median of the events; \
                      lines: to what 84 % of them do not exceed; crosses: the largest. Dashed: the gap of the scene."
                    .into(),
            drawn: render_both(&figure),
        });
    }
    if let Some(figure) = amplification(report) {
        all.push(Illustration {
            name: NAMES[4],
            caption: "Peak drift and shear force of the storeys, and peak acceleration of the floors above them, beside their neighbours, as \
                      multiples of those of the same building alone (dashed: 1), over the events in which the building touches. Discs: \
                      median, with the contact of the scene. Lines of drift and shear: to what 84 % do not exceed, or to the largest of fewer \
                      than seven events; of acceleration: from the median with the contact that gives least to this number with the one \
                      that gives most."
                .into(),
            drawn: render_both(&figure),
        });
    }
    all
}

/// The floors that touch in some run.
fn touched(report: &AssessmentReport) -> Vec<usize> {
    let hit = report.hit().into_iter();
    let both = hit.map(|(pair, _)| report.floors().facing()[pair]);
    both.flat_map(|pair| [pair.left, pair.right]).collect()
}

/// What the figure of gaps leaves out.
fn beyond(report: &AssessmentReport) -> String {
    match report.assessment.gaps.len() {
        n if n > MOST_GAPS => format!(" Of {n} gaps the first {MOST_GAPS} from the left."),
        _ => String::new(),
    }
}

/// The share of cases that need more than a gap: a panel for each gap, over one axis.
fn share(report: &AssessmentReport) -> Figure {
    let all = &report.assessment.gaps;
    let gaps = &all[..all.len().min(MOST_GAPS)];
    let widest = gaps.iter().map(|gap| gap.required.largest().max(gap.own.unwrap_or(0.0)));
    // Wider than every run needs, so that the curves visibly end on the axis.
    let end = 1e3 * 1.05 * widest.fold(GapAssessment::BUILT_IN_STEPS_OF, f64::max);
    let panel = |gap: &GapAssessment| {
        let [left, right] = report.gap_names(gap);
        let mut curves = vec![Curve::new(CurveKind::Line, Shade::Blue, needing(gap, end))];
        let mut notes = Vec::new();
        if let Some(own) = gap.own {
            let at = 1e3 * own;
            curves.push(Curve::new(CurveKind::Dashed, Shade::Ink, vec![(at, 0.0), (at, 100.0)]));
            notes.push(Note::new((at, 50.0), format!("{} mm", millimetres(own))));
        }
        Panel {
            title: writable(&format!("{left} – {right}")),
            y: Axis::over("Events that need more (%)", 0.0, 100.0),
            curves,
            notes,
            ..Panel::default()
        }
    };
    Figure {
        height_in: 0.7 + 1.1 * gaps.len() as f64,
        x: Axis::over("Gap (mm)", 0.0, end),
        panels: gaps.iter().map(panel).collect(),
        ..Figure::default()
    }
}

/// The part of the cases that need more than a width \[mm\], in steps.
fn needing(gap: &GapAssessment, end: f64) -> Vec<(f64, f64)> {
    let n = gap.required.sorted().len() as f64;
    let share = |width: f64| 100.0 * gap.required.count_above(width) as f64 / n;
    let mut points = vec![(0.0, share(0.0))];
    for width in gap.required.sorted() {
        let before = points[points.len() - 1].1;
        points.push((1e3 * width, before));
        points.push((1e3 * width, share(*width)));
    }
    points.push((end, 0.0));
    points
}

/// The width that each possible neighbour needs; `None` if all are known.
fn by_neighbour(report: &AssessmentReport) -> Option<Figure> {
    let neighbours = report.neighbours();
    let (first, last) = (neighbours.first()?, neighbours.last()?);
    let own = report.assessment.gaps.last()?.own;
    let mut curves = Vec::new();
    if let Some(own) = own {
        let ends = [first, last].map(|one| (one.drawn.period_s, 1e3 * own));
        curves.push(Curve::new(CurveKind::Dashed, Shade::Ink, ends.into()));
    }
    let of = |width: fn(&Distribution) -> f64| -> Vec<(f64, f64)> {
        let points = neighbours.iter();
        let point = |one: &OfNeighbour| (one.drawn.period_s, 1e3 * width(&one.required));
        points.map(point).collect()
    };
    let (median, most, all) = (of(Distribution::median), of(Distribution::upper), of(Distribution::largest));
    let widest = all.iter().map(|point| point.1).fold(0.0, f64::max);
    let end = 1.05 * widest.max(1e3 * own.unwrap_or(GapAssessment::BUILT_IN_STEPS_OF));
    for (from, to) in median.iter().zip(most) {
        curves.push(Curve::new(CurveKind::Line, Shade::Blue, vec![*from, to]));
    }
    curves.push(Curve::new(CurveKind::Points, Shade::Blue, median).marked(Mark::Disc));
    curves.push(Curve::new(CurveKind::Points, Shade::Vermilion, all).marked(Mark::Cross));
    Some(Figure {
        height_in: 3.0,
        x: Axis::auto("Period of the neighbour (s)"),
        panels: vec![Panel {
            y: Axis::over("Gap needed (mm)", 0.0, end),
            curves,
            ..Panel::default()
        }],
        ..Figure::default()
    })
}

/// The storeys that are shown: building by building, from the roof down.
fn shown(report: &AssessmentReport) -> Vec<usize> {
    let floors = report.floors();
    let structures = 0..report.scene.structures.len();
    let downwards = structures.flat_map(|one| floors.of_structure(one).iter().rev().copied());
    let mut shown: Vec<usize> = downwards.filter(|floor| report.assessment.floors[*floor].is_some()).collect();
    if shown.len() > MOST {
        let worst: Vec<usize> = report.worse().into_iter().map(|(floor, _)| floor).take(MOST).collect();
        shown.retain(|floor| worst.contains(floor));
    }
    shown
}

/// Amplification of every storey that moves; `None` if nothing touches.
fn amplification(report: &AssessmentReport) -> Option<Figure> {
    if report.hit().is_empty() {
        return None;
    }
    let floors = report.floors();
    let shown = shown(report);
    let names: Vec<String> = shown.iter().map(|floor| writable(&report.storey_name(*floor))).collect();
    let panel = |title: &str, response: usize| {
        let mut curves = vec![as_alone(shown.len())];
        let mut medians = Vec::new();
        for (place, floor) in shown.iter().enumerate() {
            let Some(one) = &report.assessment.floors[*floor] else {
                continue;
            };
            let of = [&one.drift, &one.shear, &one.acceleration][response];
            let y = place as f64;
            let (from, to) = match response {
                2 => (one.acceleration_range[0].median(), one.acceleration_range[1].upper()),
                _ => (of.median(), of.upper()),
            };
            curves.push(Curve::new(CurveKind::Line, Shade::Vermilion, vec![(from, y), (to, y)]));
            medians.push((of.median(), y));
        }
        curves.push(Curve::new(CurveKind::Points, Shade::Vermilion, medians).marked(Mark::Disc));
        Panel {
            title: title.into(),
            x: Some(Axis::auto("Beside / alone (–)")),
            y: Axis::names(names.clone()),
            curves,
            levels: borders(shown.iter().map(|floor| floors.all()[*floor].structure)),
            ..Panel::default()
        }
    };
    Some(Figure {
        height_in: 1.3 + 0.2 * shown.len() as f64,
        columns: 3,
        panels: vec![panel("Drift", 0), panel("Shear", 1), panel("Acceleration", 2)],
        ..Figure::default()
    })
}
