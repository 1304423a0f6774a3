//! Displacements of the row above, its collisions below.

mod pairs;

use super::shown::drawn;
use super::{Seen, around, brief, heights, named, unit};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Note, Panel, Shade, sparse_markers};
use pounding_scene::Simulation;
use pounding_solver::Collision;

/// Stems closer than this part of the run cannot be told from each other: the largest of them is drawn.
const APART: f64 = 1e-3;

/// The symbol of a collision.
#[derive(Debug, Clone, Copy)]
struct Measure {
    /// On the axis.
    label: &'static str,
    unit: &'static str,
    of: fn(&Collision) -> Option<f64>,
    /// Instant at which it is drawn \[s\].
    at: fn(&Collision) -> f64,
}

const FORCE: Measure = Measure {
    label: "Pounding force",
    unit: "N",
    of: |one| one.peak_force,
    at: |one| one.peak_force_time.unwrap_or(one.start),
};

const IMPULSE: Measure = Measure {
    label: "Impulse",
    unit: "N·s",
    of: |one| Some(one.impulse),
    at: |one| one.start,
};

pub(super) fn figure(seen: &Seen<'_>) -> (Figure, String) {
    let shown = seen.shown;
    let starts = seen.collisions(&shown.pairs).map(|one| one.start).collect();
    let markers = sparse_markers(starts);
    let is_compliant = |pair: &usize| seen.prepared.pairs()[*pair].law.is_compliant();
    let (compliant, impulsive): (Vec<usize>, Vec<usize>) = shown.pairs.iter().copied().partition(is_compliant);
    let below = [(compliant, FORCE), (impulsive, IMPULSE)];
    let below = below.iter().filter_map(|(pairs, measure)| stems(seen, pairs, *measure));
    let storeys = by_pairs(seen);
    let mut panels = if storeys { pairs::panels(seen) } else { vec![displacements(seen)] };
    if storeys {
        panels.extend(pairs::stems(seen));
    } else {
        panels.extend(below);
    }
    let height_in = 1.7 + 1.5 * panels.len() as f64;
    let caption = caption(seen, &panels, markers.is_empty()) + &seen.says_end();
    for (index, panel) in panels.iter_mut().enumerate() {
        panel.markers = if storeys {
            // A pair has its own marks; stems mark themselves.
            let pair = seen.shown.panels.get(index..=index).unwrap_or_default();
            sparse_markers(seen.collisions(pair).map(|one| one.start).collect())
        } else {
            markers.clone()
        };
    }
    let figure = Figure {
        height_in,
        x: Axis::over("Time (s)", 0.0, seen.until),
        panels,
        ..Figure::default()
    };
    (figure, caption)
}

/// Whether floors of buildings are shown: their curves lie so close that each pair has a separate panel.
fn by_pairs(seen: &Seen<'_>) -> bool {
    let floors = seen.prepared.floors().all();
    let mut shown = seen.shown.floors.iter();
    !seen.shown.panels.is_empty() && shown.any(|floor| floors[*floor].storey.is_some())
}

fn caption(seen: &Seen<'_>, panels: &[Panel], unmarked: bool) -> String {
    if by_pairs(seen) {
        return pairs::caption(seen, panels, unmarked);
    }
    let gaps = meaning(seen.prepared, !seen.shown.pairs.is_empty());
    let collisions = match panels.len() {
        1 => "",
        _ if unmarked => {
            " Below, the largest force of every collision, or the impulse of every impact, on either neighbour; they are too \
             many for lines that mark them."
        }
        _ => {
            " Grey lines mark collisions. Below, the largest force of every collision, or the impulse of every impact, on \
             either neighbour."
        }
    };
    format!(
        "Displacements relative to the ground{gaps}{collisions} {}Positive is to the right.",
        seen.shown.left_out
    )
}

/// The meaning of curves that meet: if bases move, structures whose curves meet need not touch.
fn meaning(prepared: &Simulation, face: bool) -> &'static str {
    if !face {
        "."
    } else if prepared.scene().arrivals_s.is_some() {
        ", each structure offset by the gaps to its left. The ground travels along the row: bases move towards each other and \
         apart as well, so that structures need not touch where their curves meet."
    } else {
        ", each structure offset by the gaps to its left, so that curves that meet are structures that touch."
    }
}

/// Displacements, each structure shifted by the gaps between it and the first.
fn displacements(seen: &Seen<'_>) -> Panel {
    let floors = seen.prepared.floors();
    let contacts = seen.prepared.scene().contacts.iter().flatten();
    let gaps: Vec<f64> = contacts.map(|one| one.gap_m).collect();
    let structure = |index: usize| floors.all()[index].structure;
    let shown = seen.shown.floors.iter();
    let first = shown.map(|index| structure(*index)).min().unwrap_or(0);
    let curve = |(position, &index): (usize, &usize)| {
        // Structures that stand apart have no gaps.
        let between = gaps.get(first..structure(index));
        let shift: f64 = between.unwrap_or_default().iter().sum();
        let states = seen.motion.states(index);
        let points = seen.curve(|row| 1e3 * (states[row].displacement + shift));
        let before = &seen.shown.floors[..position];
        let first = before.iter().all(|one| structure(*one) != structure(index));
        let name = named(seen.prepared, index, first);
        let name = if shift > 0.0 {
            format!("{name} + {} mm", brief(1e3 * shift, 4))
        } else {
            name
        };
        let kind = if position < 3 { CurveKind::Line } else { CurveKind::Dashed };
        Curve::new(kind, Shade::nth(position), points).named(name)
    };
    let structures = seen.shown.floors.iter().enumerate();
    let curves: Vec<Curve> = structures.map(curve).collect();
    Panel {
        y: Axis {
            range: around(heights(&curves), 0.04, 0.04),
            ..Axis::auto("Displacement (mm)")
        },
        curves,
        weight: 2.0,
        ..Panel::default()
    }
}

/// A stem for every collision on either neighbour; `None` if there is none.
fn stems(seen: &Seen<'_>, pairs: &[usize], measure: Measure) -> Option<Panel> {
    let found: Vec<(&Collision, f64)> = seen.collisions(pairs).filter_map(|one| Some((one, (measure.of)(one)?))).collect();
    let (hardest, largest) = found
        .iter()
        .copied()
        .reduce(|most, next| if next.1 > most.1 { next } else { most })?;
    let (unit, factor) = unit(largest, measure.unit);
    let floors = seen.prepared.floors();
    let sides = |(position, &index): (usize, &usize)| {
        let on = |(one, value): &(&Collision, f64)| {
            let pair = &seen.prepared.pairs()[one.pair];
            let sign = if index == drawn(floors, pair.left()) {
                -1.0
            } else if index == drawn(floors, pair.right()) {
                1.0
            } else {
                return None;
            };
            Some(((measure.at)(one), sign * factor * value))
        };
        let points = largest_apart(found.iter().filter_map(on), seen.prepared.duration());
        (!points.is_empty()).then(|| Curve::new(CurveKind::Stems, Shade::nth(position), points))
    };
    let structures = seen.shown.floors.iter().enumerate();
    let curves: Vec<Curve> = structures.filter_map(sides).collect();
    let at = ((measure.at)(hardest), factor * largest);
    let is_compliant = |pair: usize| seen.prepared.pairs()[pair].law.is_compliant();
    let all = seen.outcome.collisions.all().iter();
    let mut alike = all.filter(|one| is_compliant(one.pair) == is_compliant(hardest.pair));
    let is_largest = alike.all(|one| (measure.of)(one).is_none_or(|value| value <= largest));
    let shown = if is_largest { "" } else { ", of those shown" };
    let text = format!("{} {unit} at {} s{shown}", brief(at.1, 4), brief(at.0, 4));
    Some(Panel {
        y: Axis {
            // Room for the note above.
            range: around(heights(&curves), 0.05, 0.16),
            ..Axis::auto(format!("{} ({unit})", measure.label))
        },
        levels: vec![0.0],
        notes: vec![Note::new(at, text)],
        curves,
        legend: Legend::Hidden,
        ..Panel::default()
    })
}

/// Of stems that are drawn over each other the largest.
fn largest_apart(points: impl Iterator<Item = (f64, f64)>, duration: f64) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    for point in points {
        match kept.last_mut() {
            Some(last) if (point.0 - last.0).abs() < APART * duration && point.1 * last.1 > 0.0 => {
                if point.1.abs() > last.1.abs() {
                    *last = point;
                }
            }
            _ => kept.push(point),
        }
    }
    kept
}
