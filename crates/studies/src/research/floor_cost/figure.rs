//! Wall time of rows over their size.

use super::{Condition, RowSize};
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Mark, Panel, PlotError, Shade, render_png};
use pounding_scene::{REFERENCE, RIVAL, label_of};

/// What a row cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloorCost {
    /// Name of the method in tables.
    pub method: &'static str,
    /// What the floors do.
    pub condition: Condition,
    /// How many there are.
    pub size: RowSize,
    /// Wall time over that of the smallest row of the same method and condition \[–\].
    pub over_smallest: f64,
}

/// Methods that are timed, by their names in tables, and their looks.
pub(super) const METHODS: [(&str, Shade, Mark); 7] = [
    (RIVAL, Shade::Blue, Mark::Disc),
    ("velocity_verlet", Shade::Green, Mark::Diamond),
    ("newmark_average_acceleration", Shade::Vermilion, Mark::Square),
    ("hht", Shade::Amber, Mark::HollowSquare),
    ("moreau_jean", Shade::Grey, Mark::Cross),
    ("rk4", Shade::Rose, Mark::Inverted),
    (REFERENCE, Shade::Ink, Mark::HollowTriangle),
];

/// Elastic rows over their storeys and over their buildings, apart and touching, as a PNG; `fixed` is the row that both have
/// in common, `smallest` the one whose time is the unit. The dashed line has the slope one: time grows with floors.
///
/// # Errors
/// [`PlotError`] for times that cannot be drawn.
pub fn floor_cost_figure(costs: &[FloorCost], fixed: RowSize, smallest: RowSize) -> Result<Vec<u8>, PlotError> {
    let mut panels = Vec::new();
    for touching in [false, true] {
        for over_storeys in [true, false] {
            let of_panel = |cost: &&FloorCost| {
                let own = Condition { yielding: false, touching };
                let on_axis = if over_storeys {
                    cost.size.buildings == fixed.buildings
                } else {
                    cost.size.storeys == fixed.storeys
                };
                cost.condition == own && on_axis
            };
            let count = |size: RowSize| {
                let count = if over_storeys { size.storeys } else { size.buildings };
                count as f64
            };
            let costs: Vec<&FloorCost> = costs.iter().filter(of_panel).collect();
            let (title, axis) = if over_storeys {
                let n = fixed.buildings;
                (format!("{n} buildings"), "Storeys")
            } else {
                let n = fixed.storeys;
                (format!("Buildings of {n} storeys"), "Buildings")
            };
            let word = if touching { "touching" } else { "apart" };
            panels.push(Panel {
                title: format!("{title}, {word}"),
                x: Some(Axis::auto(axis).log()),
                y: Axis::auto(if over_storeys { "Wall time (smallest = 1)" } else { "" }).log(),
                curves: curves(&costs, count, smallest),
                legend: Legend::Shared,
                ..Panel::default()
            });
        }
    }
    render_png(&Figure {
        height_in: 6.2,
        columns: 2,
        panels,
        ..Figure::default()
    })
}

fn curves(costs: &[&FloorCost], count: impl Fn(RowSize) -> f64, smallest: RowSize) -> Vec<Curve> {
    let mut guide: Vec<(f64, f64)> = costs
        .iter()
        .map(|cost| {
            let floors = cost.size.floors() as f64;
            (count(cost.size), floors / smallest.floors() as f64)
        })
        .collect();
    guide.sort_by(|one, other| one.0.total_cmp(&other.0));
    guide.dedup();
    let mut curves = vec![Curve::new(Kind::Dashed, Shade::Silver, guide).named("Slope one")];
    for (method, shade, mark) in METHODS {
        let own = costs.iter().filter(|cost| cost.method == method);
        let mut points: Vec<_> = own.map(|cost| (count(cost.size), cost.over_smallest)).collect();
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        if !points.is_empty() {
            let curve = Curve::new(Kind::Line, shade, points).marked(mark);
            curves.push(curve.named(label_of(method)));
        }
    }
    curves
}
