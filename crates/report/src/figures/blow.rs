//! The hardest blow: its force over time, and over the overlap of the floors.

use super::{Seen, brief, unit};
use crate::Blow;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Panel, Shade};
use pounding_solver::Collision;

/// The figure with its caption; `None` if no contact has a force.
pub(super) fn figure(seen: &Seen<'_>) -> Option<(Figure, String)> {
    let hardest = Blow::all(seen.outcome)
        .into_iter()
        .find(|blow| seen.motion.tells_force(blow.pair))?;
    let force = |one: &&Collision| one.peak_force.unwrap_or(0.0);
    let collision = *seen
        .outcome
        .collisions_of(hardest.pair)
        .max_by(|one, other| force(one).total_cmp(&force(other)))?;
    let points = points(seen, &collision);
    let largest = points.iter().map(|point| point.force).fold(0.0, f64::max);
    if points.len() < LEAST || largest <= 0.0 {
        return None;
    }
    let (unit, factor) = unit(largest, "N");
    let panel = |label: &str, place: fn(&Point) -> f64| Panel {
        x: Some(Axis::auto(label)),
        y: Axis::auto(format!("Force ({unit})")),
        levels: vec![0.0],
        curves: vec![Curve::new(
            CurveKind::Line,
            Shade::Blue,
            points.iter().map(|one| (place(one), factor * one.force)).collect(),
        )],
        ..Panel::default()
    };
    let figure = Figure {
        height_in: 2.6,
        columns: 2,
        panels: vec![
            panel("Time after the first touch (ms)", |one| 1e3 * one.after),
            panel("Overlap of the floors (mm)", |one| 1e3 * one.overlap),
        ],
        ..Figure::default()
    };
    let [left, right] = seen.prepared.floors().names(hardest.pair);
    let caption = format!(
        "Force of the hardest blow, {left} – {right} from {} to {} s, over time and over the overlap of the floors, which stands for the \
         deformation of both; the area of the loop is the energy that the contact takes. Straight lines join states that are {} ms apart.",
        brief(collision.start, 5),
        brief(collision.end, 5),
        brief(1e3 * seen.motion.interval(), 3)
    );
    Some((figure, caption))
}

/// Fewer states do not show a blow.
const LEAST: usize = 5;

/// An instant of a collision.
#[derive(Debug, Clone, Copy)]
struct Point {
    /// Time after its start \[s\].
    after: f64,
    overlap: f64,
    force: f64,
}

/// The kept states of a collision, with its start, its peak and its end.
fn points(seen: &Seen<'_>, collision: &Collision) -> Vec<Point> {
    let rows = (0..seen.motion.len()).filter(|row| {
        let time = seen.motion.time(*row);
        time > collision.start && time < collision.end
    });
    let of_row = |row: usize| Point {
        after: seen.motion.time(row) - collision.start,
        overlap: -seen.motion.opening(collision.pair, row),
        force: seen.motion.force(collision.pair, row),
    };
    let at = |time: f64, force: f64| Point {
        after: time - collision.start,
        overlap: overlap(seen, collision.pair, time),
        force,
    };
    let mut all: Vec<Point> = rows.map(of_row).collect();
    all.extend(
        collision
            .peak_force_time
            .zip(collision.peak_force)
            .map(|(time, force)| at(time, force)),
    );
    all.push(at(collision.end, 0.0));
    // A damper may push at once.
    let first = Point {
        after: 0.0,
        overlap: 0.0,
        force: 0.0,
    };
    all.push(first);
    all.sort_by(|one, other| one.after.total_cmp(&other.after));
    all.dedup_by(|one, other| one.after - other.after <= 0.0);
    all
}

/// Overlap of a pair at an instant \[m\]: a parabola through the three nearest states.
fn overlap(seen: &Seen<'_>, pair: usize, time: f64) -> f64 {
    let interval = seen.motion.interval();
    let last = seen.motion.len().saturating_sub(2);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place among the states")]
    let middle = ((time / interval).round() as usize).clamp(1, last.max(1));
    if last < 1 {
        return 0.0;
    }
    let [before, at, after] = [middle - 1, middle, middle + 1].map(|row| -seen.motion.opening(pair, row));
    let part = time / interval - middle as f64;
    at + 0.5 * part * (after - before) + 0.5 * part * part * (after - 2.0 * at + before)
}
