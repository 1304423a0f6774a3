//! Displacements of floors of buildings: a panel for every pair that is hit hardest, and the collisions of these below.

use super::super::{Seen, around, brief, fitting, heights, unit};
use super::{FORCE, IMPULSE, largest_apart};
use pounding_plot::{Axis, Curve, CurveKind, Legend, Note, Panel, Shade};
use pounding_solver::Collision;

/// A panel for every shown pair: both floors, the right one offset by the gap, over one range.
pub(super) fn panels(seen: &Seen<'_>) -> Vec<Panel> {
    let mut panels: Vec<Panel> = seen.shown.panels.iter().map(|pair| panel(seen, *pair)).collect();
    let all = panels.iter().flat_map(|panel| heights(&panel.curves));
    let range = around(all.collect::<Vec<_>>().into_iter(), 0.06, 0.06);
    for panel in &mut panels {
        panel.y.range = range;
    }
    panels
}

fn panel(seen: &Seen<'_>, pair: usize) -> Panel {
    let gap = seen.prepared.pairs()[pair].gap();
    let curve = |side: usize, shift: f64| seen.curve(|row| 1e3 * (seen.motion.points(pair, row)[side] + shift));
    Panel {
        title: title(seen, pair),
        y: Axis::auto("u (mm)"),
        curves: vec![
            Curve::new(CurveKind::Line, Shade::Blue, curve(0, 0.0)).named("left"),
            Curve::new(CurveKind::Line, Shade::Vermilion, curve(1, gap)).named("right, offset by the gap"),
        ],
        legend: Legend::Shared,
        ..Panel::default()
    }
}

fn title(seen: &Seen<'_>, pair: usize) -> String {
    let gap = brief(1e3 * seen.prepared.pairs()[pair].gap(), 4);
    format!("{}, {gap} mm", names(seen, pair))
}

fn names(seen: &Seen<'_>, pair: usize) -> String {
    seen.prepared.floors().names(pair).map(|name| fitting(&name)).join(" – ")
}

/// The collisions of the shown pairs, forces or impulses; `None` if there is none.
pub(super) fn stems(seen: &Seen<'_>) -> Option<Panel> {
    let pairs = &seen.shown.panels;
    let compliant = |pair: &usize| seen.prepared.pairs()[*pair].law.is_compliant();
    let measure = if pairs.iter().all(compliant) { FORCE } else { IMPULSE };
    let found: Vec<(&Collision, f64)> = seen.collisions(pairs).filter_map(|one| Some((one, (measure.of)(one)?))).collect();
    let harder = |most: (_, f64), next: (_, f64)| if next.1 > most.1 { next } else { most };
    let (hardest, largest) = found.iter().copied().reduce(harder)?;
    let (unit, factor) = unit(largest, measure.unit);
    let curve = |(position, pair): (usize, &usize)| {
        let own = found.iter().filter(|(one, _)| one.pair == *pair);
        let points = own.map(|(one, value)| ((measure.at)(one), factor * value));
        let points = largest_apart(points, seen.prepared.duration());
        (!points.is_empty()).then(|| Curve::new(CurveKind::Stems, Shade::nth(position), points).named(names(seen, *pair)))
    };
    let curves: Vec<Curve> = pairs.iter().enumerate().filter_map(curve).collect();
    let at = ((measure.at)(hardest), factor * largest);
    let text = format!("{} {unit} at {} s", brief(at.1, 4), brief(at.0, 4));
    Some(Panel {
        y: Axis {
            range: around(heights(&curves).chain([0.0]), 0.0, 0.2),
            ..Axis::auto(format!("{} ({unit})", measure.label))
        },
        notes: vec![Note::new(at, text)],
        curves,
        ..Panel::default()
    })
}

pub(super) fn caption(seen: &Seen<'_>, panels: &[Panel], unmarked: bool) -> String {
    let travels = if seen.prepared.scene().arrivals_s.is_some() {
        " The ground travels along the row: bases move towards each other and apart as well, so that floors need not touch where \
         their curves meet."
    } else {
        " Floors touch where their curves meet."
    };
    let collisions = match (panels.len() > seen.shown.panels.len(), unmarked) {
        (false, _) => "",
        (true, true) => " Below, the largest force of every collision, or its impulse.",
        (true, false) => " Grey lines mark collisions. Below, the largest force of every collision, or its impulse.",
    };
    let n = seen.prepared.floors().facing().len();
    let left_out = match seen.shown.panels.len() {
        shown if shown < n => {
            format!(" Of {n} pairs of floors the {shown} that are hit hardest, or come closest to it.")
        }
        _ => String::new(),
    };
    format!(
        "Displacements u relative to the ground of floors that face each other, the right one offset by the gap.{travels}{collisions}\
         {left_out} Positive is to the right."
    )
}
