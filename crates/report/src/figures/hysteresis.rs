//! Shear force against displacement, for structures that yield.

use super::thin::thinned;
use super::{Seen, around, fitting, unit};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Panel, Shade};

/// More panels than this do not fit on a page.
const MOST: usize = 6;

/// The loops of columns that yield; `None` if none does.
pub(super) fn figure(seen: &Seen<'_>) -> Option<(Figure, String)> {
    let floors = seen.prepared.floors().all().iter().enumerate();
    let mut found: Vec<(usize, f64)> = floors
        .filter_map(|(index, floor)| {
            let drift = seen.outcome.peaks.of(index).drift().value;
            Some((index, floor.ductility(drift)?))
        })
        .filter(|(index, ductility)| *ductility > 1.0 + ROUNDING || is_smooth(seen, *index))
        .collect();
    let n = found.len();
    found.sort_by(|one, other| other.1.total_cmp(&one.1));
    found.truncate(MOST);
    found.sort_by_key(|one| one.0);
    if found.is_empty() {
        return None;
    }
    let drifts = found.iter().flat_map(|one| seen.motion.drifts(one.0));
    let range = around(drifts.map(|drift| 1e3 * drift), 0.05, 0.05);
    let columns = found.len().min(2);
    let rows = found.len().div_ceil(2);
    let figure = Figure {
        height_in: 0.6 + 2.4 * rows as f64,
        columns,
        panels: found.iter().map(|one| panel(seen, one.0, range)).collect(),
        ..Figure::default()
    };
    let left_out = if found.len() < n {
        format!(" Of {n} those with the largest ductility are shown.")
    } else {
        String::new()
    };
    let floors = seen.prepared.floors().all();
    let of = if found.iter().any(|one| floors[one.0].storey.is_some()) {
        "storey drift of storeys"
    } else {
        "displacement of structures"
    };
    let caption = format!(
        "Shear force against {of} that yield; the area of the loops is the energy that yielding \
         takes.{left_out}"
    );
    Some((figure, caption))
}

/// What rounding leaves of a ductility of 1.
const ROUNDING: f64 = 1e-9;

/// Whether columns yield smoothly, from the first drift on.
fn is_smooth(seen: &Seen<'_>, index: usize) -> bool {
    let made_of = seen.prepared.floors().all()[index].made_of;
    made_of.is_some_and(|made| made.columns.bouc_wen.is_some())
}

/// A loop of columns of stiffness k that yield with a k, with the corners between two rows of the history. A corner is where a line of one
/// slope through the first row meets a line of the other slope through the second.
fn with_corners(points: &[(f64, f64)], [elastic, yielding]: [f64; 2]) -> Vec<(f64, f64)> {
    let mut cornered: Vec<(f64, f64)> = Vec::with_capacity(points.len());
    for point in points {
        if let Some(before) = cornered.last().copied() {
            let (run, rise) = (point.0 - before.0, point.1 - before.1);
            let scale = 1e-6 * (elastic * run).abs();
            let is_line = |slope: f64| (rise - slope * run).abs() <= scale;
            if !is_line(elastic) && !is_line(yielding) {
                // Behind the earlier row, first by one slope and then by the other.
                let along = |first: f64, then: f64| (rise - then * run) / (first - then);
                let loading = along(elastic, yielding);
                let is_between = loading * run > 0.0 && loading.abs() < run.abs();
                let (slope, along) = if is_between {
                    (elastic, loading)
                } else {
                    (yielding, along(yielding, elastic))
                };
                cornered.push((before.0 + along, before.1 + slope * along));
            }
        }
        cornered.push(*point);
    }
    cornered
}

fn panel(seen: &Seen<'_>, index: usize, range: Option<(f64, f64)>) -> Panel {
    let floor = &seen.prepared.floors().all()[index];
    let peaks = seen.outcome.peaks.of(index);
    let (unit, factor) = unit(peaks.column_force().value, "N");
    let points = seen.motion.drifts(index).zip(seen.motion.shear_forces(index));
    let points = points.map(|(drift, force)| (1e3 * drift, factor * force));
    let points: Vec<(f64, f64)> = points.collect();
    let columns = floor.made_of.map(|made| made.columns);
    let sharp = columns.filter(|one| one.bouc_wen.is_none() && one.friction_n.is_none());
    let points = thinned(sharp.map_or(points.clone(), |columns| {
        let elastic = 1e-3 * factor * columns.stiffness_n_per_m;
        let hardening = columns.hardening_ratio.unwrap_or(0.0);
        with_corners(&points, [elastic, hardening * elastic])
    }));
    let label = if floor.storey.is_some() {
        "Storey drift (mm)"
    } else {
        "Displacement (mm)"
    };
    Panel {
        title: fitting(&seen.prepared.floors().storey_name(index)),
        x: Some(Axis {
            range,
            ..Axis::auto(label)
        }),
        y: Axis::auto(format!("Shear force ({unit})")),
        levels: vec![0.0],
        curves: vec![Curve::new(CurveKind::Thin, Shade::Blue, points)],
        ..Panel::default()
    }
}

#[cfg(test)]
mod tests {
    use super::with_corners;

    /// Rows on both sides of a corner cut it off. Columns of 2 kN/mm that yield at 4 kN have one corner between 1.5 and 3 mm, and one at the
    /// turn at 5 mm, between 4.5 and 4 mm on the way back.
    #[test]
    fn issue_corners_of_loops_were_cut_off() {
        let rows = [(0.0, 0.0), (1.5, 3.0), (3.0, 4.0), (4.5, 4.0), (4.0, 2.0)];
        let found = with_corners(&rows, [2.0, 0.0]);
        let wanted = [(0.0, 0.0), (1.5, 3.0), (2.0, 4.0), (3.0, 4.0), (4.5, 4.0), (5.0, 4.0), (4.0, 2.0)];
        assert_eq!(found, wanted);
    }
}
