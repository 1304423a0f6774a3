//! Figures of collisions: displacements above pounding forces, and the first collision in several models.

use std::collections::BTreeMap;

use pounding_solver::{Collision, State};

use super::histories::time_axis;
use super::{label, points};
use crate::Completed;
use crate::files::capital;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Note, Panel, Shade, minus, sparse_markers};
use pounding_scene::{RunResult, Scene};
use pounding_text::digits;

/// Share of a panel's height that one line of text needs.
const ROOM: f64 = 0.08;

/// Displacements with the gaps between the rest positions, and the net pounding force on every structure.
pub(super) fn pounding(completed: &Completed) -> Figure {
    let (scene, outcome) = (&completed.file.study.scenes[0], &completed.outcomes[0]);
    let markers = sparse_markers(collisions(scene, outcome).map(|one| one.start).collect());
    let above = Panel {
        title: completed.file.study.title.clone(),
        markers: markers.clone(),
        ..displacement_panel(scene, outcome)
    };
    let below = Panel {
        markers,
        ..force_panel(scene, outcome)
    };
    Figure::grid(4.6, 1, time_axis(scene), vec![above, below])
}

/// Displacements, each structure shifted by the gaps to its left, so that curves meet where structures touch.
///
/// The gap is written between the curves at rest if there is room.
fn displacement_panel(scene: &Scene, outcome: &RunResult) -> Panel {
    let mut shift = 0.0;
    let (mut curves, mut notes) = (Vec::new(), Vec::new());
    for (index, structure) in scene.structures.iter().enumerate() {
        if let (1.., Some(contacts)) = (index, &scene.contacts) {
            let gap = contacts[index - 1].gap_m;
            let at = (0.0, 1e3 * (shift + 0.5 * gap));
            notes.push(Note::new(at, format!("gap {:.0} mm", 1e3 * gap)));
            shift += gap;
        }
        let history = points(outcome, index, |state| 1e3 * (state.displacement + shift));
        let name = match index {
            0 => label(structure),
            _ => format!("{} + {:.0} mm", label(structure), 1e3 * shift),
        };
        curves.push(Curve::new(CurveKind::Line, Shade::nth(index), history).named(name));
    }
    let heights = curves.iter().flat_map(|curve: &Curve| &curve.points).map(|point| point.1);
    let (low, high) = heights.fold((0.0_f64, 0.0_f64), |(low, high), y| (low.min(y), high.max(y)));
    let is_narrow = |gap: f64| 1e3 * gap < ROOM * (high - low);
    let narrow = scene.contacts.iter().flatten().any(|contact| is_narrow(contact.gap_m));
    if narrow {
        notes.clear();
    }
    Panel {
        y: Axis::auto("Displacement (mm)"),
        curves,
        notes,
        weight: 1.7,
        ..Panel::default()
    }
}

/// Net pounding force on every structure. The force of an impact is its impulse over the time step, as in the paper.
fn force_panel(scene: &Scene, outcome: &RunResult) -> Panel {
    let forces = forces(scene, outcome);
    let peak = forces.iter().flatten().copied().fold((0.0, 0.0), largest);
    let (unit, factor) = unit(peak.1);
    let curve = |(index, points): (usize, &Vec<_>)| Curve::new(kind(scene), Shade::nth(index), in_unit(points, factor));
    let curves = forces.iter().enumerate().map(curve).collect();
    let decimals = if unit == "MN" { 2 } else { 0 };
    let at = (peak.0, factor * peak.1);
    let text = minus(&format!("{:.decimals$} {unit} at {:.2} s", at.1, at.0));
    Panel {
        y: Axis::auto(force_label(scene, unit)),
        levels: vec![0.0],
        notes: if peak.1 == 0.0 { Vec::new() } else { vec![Note::new(at, text)] },
        curves,
        legend: Legend::Hidden,
        ..Panel::default()
    }
}

/// Label of the force axis. For impacts, whose force has no limit, it names impulse over time step.
fn force_label(scene: &Scene, unit: &str) -> String {
    if scene.is_impulsive() {
        let step = digits(1e3 * scene.method.step());
        format!("Impulse / {step} ms ({unit})")
    } else {
        format!("Pounding force ({unit})")
    }
}

fn kind(scene: &Scene) -> CurveKind {
    if scene.is_impulsive() { CurveKind::Stems } else { CurveKind::Area }
}

/// The point farther from zero. The positive one wins a tie, so that its label is above the curve.
fn largest(peak: (f64, f64), point: (f64, f64)) -> (f64, f64) {
    let reached = peak.1.abs();
    if point.1.abs() > reached || (point.1 > 0.0 && point.1 >= reached) {
        point
    } else {
        peak
    }
}

/// Unit of force for an axis that reaches `peak` \[N\], and its factor.
fn unit(peak: f64) -> (&'static str, f64) {
    if peak.abs() >= 2e6 { ("MN", 1e-6) } else { ("kN", 1e-3) }
}

fn in_unit(points: &[(f64, f64)], factor: f64) -> Vec<(f64, f64)> {
    points.iter().map(|(time, force)| (*time, factor * force)).collect()
}

/// Collisions within the drawn time; the paper's program runs on after it.
fn collisions<'a>(scene: &Scene, outcome: &'a RunResult) -> impl Iterator<Item = &'a Collision> {
    let end = scene.duration();
    let all = outcome.collisions.all().iter();
    all.filter(move |one| one.start <= end)
}

/// Net pounding force on every structure over time \[N\].
fn forces(scene: &Scene, outcome: &RunResult) -> Vec<Vec<(f64, f64)>> {
    let n = scene.structures.len();
    if !scene.is_impulsive() {
        return (0..n).map(|index| points(outcome, index, State::pounding_force)).collect();
    }
    let dt = scene.method.step();
    // Impacts at one instant are summed; the key is the number of the step.
    let mut net = vec![BTreeMap::new(); n];
    for collision in collisions(scene, outcome) {
        #[expect(clippy::cast_possible_truncation, reason = "a step number is small")]
        let step = (collision.start / dt).round() as i64;
        for (index, sign) in [(collision.pair, -1.0), (collision.pair + 1, 1.0)] {
            *net[index].entry(step).or_insert(0.0) += sign * collision.impulse / dt;
        }
    }
    let points = |steps: BTreeMap<i64, f64>| steps.into_iter().map(|(step, force)| (step as f64 * dt, force)).collect();
    net.into_iter().map(points).collect()
}

/// Pounding force of the first collision of every scene, in panels with equal scales.
pub(super) fn first_collisions(completed: &Completed) -> Figure {
    let (mut from, mut to, mut peak) = (f64::INFINITY, 0.0_f64, 0.0_f64);
    for (scene, outcome) in completed.runs() {
        let Some(first) = outcome.collisions.all().first() else {
            continue;
        };
        from = from.min(first.start);
        to = to.max(first.end);
        peak = peak.max(first.peak_force.unwrap_or(first.impulse / scene.method.step()));
    }
    let (unit, factor) = unit(peak);
    let range = (from - 0.02, to + 0.03);
    let panel = |((scene, outcome), index): ((&Scene, &RunResult), usize)| {
        let first = outcome.collisions.all().first();
        let impulse = first.map_or(0.0, |first| first.impulse / 1e3);
        let shown = |points: Vec<(f64, f64)>| {
            let inside = |point: &(f64, f64)| (range.0..=range.1).contains(&point.0);
            in_unit(&points.into_iter().filter(inside).collect::<Vec<_>>(), factor)
        };
        let curve = |(points, index): (Vec<(f64, f64)>, usize)| {
            Curve::new(kind(scene), Shade::nth(index), shown(points)).named(capital(scene.structures[index].name()))
        };
        Panel {
            title: format!("{}: {impulse:.2} kN·s", capital(&scene.name)),
            y: Axis::over(force_label(scene, unit), -1.15 * factor * peak, 1.15 * factor * peak),
            levels: vec![0.0],
            curves: forces(scene, outcome).into_iter().zip(0..).map(curve).collect(),
            legend: if index == 0 { Legend::Inside } else { Legend::Hidden },
            ..Panel::default()
        }
    };
    let x = Axis::over("Time (s)", range.0, range.1);
    Figure::grid(4.8, 2, x, completed.runs().zip(0..).map(panel).collect())
}
