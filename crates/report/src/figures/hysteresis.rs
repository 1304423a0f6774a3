//! Shear force against displacement, for structures that can yield.

use super::thin::thinned;
use super::{Seen, name, unit};
use pounding_plot::{Axis, Curve, Figure, Kind, Panel, Shade};

/// More panels than this do not fit on a page.
const MOST: usize = 6;

/// Nothing where no structure can yield.
pub(super) fn figure(seen: &Seen<'_>) -> Option<(Figure, String)> {
    let floors = seen.prepared.floors().all().iter().enumerate();
    let mut found: Vec<(usize, f64)> = floors
        .filter_map(|(index, floor)| {
            let drift = seen.outcome.peaks.of(index).drift().value;
            Some((index, floor.ductility(drift)?))
        })
        .collect();
    let n = found.len();
    found.sort_by(|one, other| other.1.total_cmp(&one.1));
    found.truncate(MOST);
    found.sort_by_key(|one| one.0);
    if found.is_empty() {
        return None;
    }
    let columns = found.len().min(2);
    let rows = found.len().div_ceil(2);
    let figure = Figure {
        height_in: 0.6 + 2.4 * rows as f64,
        columns,
        panels: found.iter().map(|one| panel(seen, one.0)).collect(),
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
        "Shear force against {of} that can yield; the area of the loops is the energy that yielding \
         takes.{left_out}"
    );
    Some((figure, caption))
}

fn panel(seen: &Seen<'_>, index: usize) -> Panel {
    let floor = &seen.prepared.floors().all()[index];
    let peaks = seen.outcome.peaks.of(index);
    let (unit, factor) = unit(peaks.restoring_force.value, "N");
    let (states, drifts) = (seen.motion.states(index), seen.motion.drifts(index));
    let points = drifts.zip(states);
    let points = points.map(|(drift, state)| (1e3 * drift, factor * state.restoring_force));
    let points = thinned(points.collect());
    Panel {
        title: name(floor),
        x: Some(Axis::auto(if floor.storey.is_some() {
            "Storey drift (mm)"
        } else {
            "Displacement (mm)"
        })),
        y: Axis::auto(format!("Shear force ({unit})")),
        levels: vec![0.0],
        curves: vec![Curve::new(Kind::Thin, Shade::Blue, points)],
        ..Panel::default()
    }
}
