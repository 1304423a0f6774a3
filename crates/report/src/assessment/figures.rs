//! What the page of an assessment shows: the share of runs that need more than a gap, and amplifications.

use pounding_plot::{
    Axis, Curve, Drawing, Figure, Kind, Legend, Mark, Panel, Shade, render_both, writable,
};

use super::AssessmentReport;
use super::sketch;
use crate::figures::Illustration;

/// The names that figures can have, without the ends of their files.
pub(super) const NAMES: [&str; 3] = ["row", "gap", "amplification"];

/// Most storeys of one figure.
const MOST: usize = 30;

pub(super) fn all(report: &AssessmentReport) -> Vec<Illustration> {
    let sketch: Drawing = sketch::drawing(report);
    let mut all = vec![Illustration {
        name: NAMES[0],
        caption: sketch::CAPTION.into(),
        drawn: render_both(&sketch),
    }];
    all.push(Illustration {
        name: NAMES[1],
        caption: "Part of the runs that need more than a gap, while every building stands alone. Grey lines: the gaps of the scene.".into(),
        drawn: render_both(&share(report)),
    });
    if let Some(figure) = amplification(report) {
        all.push(Illustration {
            name: NAMES[2],
            caption: "Peak drift, shear force and acceleration of the storeys beside their neighbours, as multiples of those of the same \
                      building alone: median of the runs, and lines to what 84 % of them do not exceed."
                .into(),
            drawn: render_both(&figure),
        });
    }
    all
}

/// The share of runs that need more than a gap.
fn share(report: &AssessmentReport) -> Figure {
    let gaps = &report.assessment.gaps;
    let mut curves = Vec::new();
    let mut markers = Vec::new();
    for (index, gap) in gaps.iter().enumerate() {
        let n = gap.required.sorted().len() as f64;
        let mut points = vec![(0.0, 100.0 * gap.required.count_above(0.0) as f64 / n)];
        for width in gap.required.sorted() {
            let before = points[points.len() - 1].1;
            points.push((1e3 * width, before));
            points.push((
                1e3 * width,
                100.0 * gap.required.count_above(*width) as f64 / n,
            ));
        }
        let [left, right] = report.gap_names(gap);
        curves.push(
            Curve::new(Kind::Line, Shade::nth(index), points)
                .named(writable(&format!("{left} – {right}"))),
        );
        markers.extend(gap.own.map(|own| 1e3 * own));
    }
    Figure {
        height_in: 2.8,
        panels: vec![Panel {
            x: Some(Axis::auto("Gap (mm)")),
            y: Axis::over("Runs that need more (%)", 0.0, 100.0),
            curves,
            markers,
            legend: Legend::Shared,
            ..Panel::default()
        }],
        ..Figure::default()
    }
}

/// Amplification of every storey that moves; `None` if nothing touches.
fn amplification(report: &AssessmentReport) -> Option<Figure> {
    if report.hit().is_empty() {
        return None;
    }
    let floors = report.floors();
    let structures = 0..report.scene.structures.len();
    let downwards = structures.flat_map(|one| floors.of_structure(one).iter().rev().copied());
    let mut shown: Vec<usize> = downwards
        .filter(|floor| report.assessment.floors[*floor].is_some())
        .collect();
    if shown.len() > MOST {
        let worst: Vec<usize> = report
            .worse()
            .into_iter()
            .map(|(floor, _)| floor)
            .take(MOST)
            .collect();
        shown.retain(|floor| worst.contains(floor));
    }
    let names: Vec<String> = shown
        .iter()
        .map(|floor| writable(&report.floor_name(*floor)))
        .collect();
    let panel = |title: &str, response: usize| {
        let mut curves = Vec::new();
        let mut medians = Vec::new();
        for (place, floor) in shown.iter().enumerate() {
            let Some(one) = &report.assessment.floors[*floor] else {
                continue;
            };
            let of = [&one.drift, &one.shear, &one.acceleration][response];
            let y = place as f64;
            curves.push(Curve::new(
                Kind::Line,
                Shade::Vermilion,
                vec![(of.median(), y), (of.p84(), y)],
            ));
            medians.push((of.median(), y));
        }
        curves.push(Curve::new(Kind::Points, Shade::Vermilion, medians).marked(Mark::Disc));
        Panel {
            title: title.into(),
            x: Some(Axis::auto("Beside / alone (–)")),
            y: Axis::names(names.clone()),
            curves,
            markers: vec![1.0],
            ..Panel::default()
        }
    };
    Some(Figure {
        height_in: 1.3 + 0.2 * shown.len() as f64,
        columns: 3,
        panels: vec![
            panel("Drift", 0),
            panel("Shear", 1),
            panel("Acceleration", 2),
        ],
        ..Figure::default()
    })
}
