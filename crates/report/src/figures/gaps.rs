//! How far every pair closes its gap.

use super::{Seen, around, brief, fitting, heights};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Panel, Shade, sparse_markers};

/// The gaps over time; `None` if no pair is shown.
pub(super) fn figure(seen: &Seen<'_>) -> Option<(Figure, String)> {
    let pairs = &seen.shown.panels;
    if pairs.is_empty() {
        return None;
    }
    let figure = Figure {
        // The table of pairs and all panels fit on one page.
        height_in: 1.0 + if pairs.len() > 2 { 1.25 } else { 1.5 } * pairs.len() as f64,
        x: Axis::over("Time (s)", 0.0, seen.until),
        panels: pairs.iter().map(|&pair| panel(seen, pair)).collect(),
        ..Figure::default()
    };
    let n = seen.prepared.pairs().len();
    let left_out = if pairs.len() < n {
        format!(
            " Of {n} pairs the {} are shown that are hit hardest, or come closest to it.",
            pairs.len()
        )
    } else {
        String::new()
    };
    let caption = format!(
        "Displacement of the left neighbour relative to the right one. Where it reaches the gap the two touch; what is beyond \
         is overlap.{left_out}"
    );
    Some((figure, caption))
}

fn panel(seen: &Seen<'_>, pair: usize) -> Panel {
    let gap = 1e3 * seen.prepared.pairs()[pair].gap();
    let closing = seen.curve(|row| gap - 1e3 * seen.motion.opening(pair, row));
    let level = vec![(0.0, gap), (seen.until, gap)];
    let starts = seen.collisions(&[pair]).map(|one| one.start).collect();
    let touches = sparse_markers(starts);
    let mut curves = vec![
        Curve::new(CurveKind::Dashed, Shade::Vermilion, level).named("gap at rest"),
        Curve::new(CurveKind::Line, Shade::Blue, closing).named("left relative to right"),
    ];
    if !touches.is_empty() {
        let points = touches.into_iter().map(|time| (time, gap)).collect();
        curves.push(Curve::new(CurveKind::Points, Shade::Ink, points).named("collision"));
    }
    let [left, right] = seen.prepared.floors().names(pair).map(|name| fitting(&name));
    Panel {
        title: format!("{left} – {right}, gap {} mm", brief(gap, 4)),
        y: Axis {
            range: around(heights(&curves), 0.05, 0.08),
            ..Axis::auto("Displacement (mm)")
        },
        levels: vec![0.0],
        curves,
        legend: Legend::Shared,
        ..Panel::default()
    }
}
