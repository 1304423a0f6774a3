//! The effects of pounding on every storey: amplifications in both directions, with their ranges.

use pounding_assess::Effects;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Mark, Panel, Shade, writable};
use pounding_scene::{RecordUse, Simulation};

/// Most storeys of one figure; of more those are shown that pounding changes most.
const MOST: usize = 30;
/// What the panels show, in the order of [`responses`](pounding_assess::FloorEffects::responses).
const PANELS: [&str; 3] = ["Drift", "Shear", "Acceleration"];
/// How far the two directions of a storey stand apart, in storeys.
const APART: f64 = 0.16;

/// The figure with its caption; `None` if nothing touches.
pub(super) fn figure(effects: &Effects, prepared: &Simulation) -> Option<(Figure, String)> {
    let floors = shown(effects, prepared);
    if floors.is_empty() || !effects.touch() {
        return None;
    }
    let all = prepared.floors().all().iter();
    let n = all.filter(|floor| !floor.is_wall()).count();
    let left_out = if floors.len() < n {
        format!(" Of {n} storeys those {MOST} are shown that pounding changes most.")
    } else {
        String::new()
    };
    let caption = format!(
        "Peak drift and shear force of every storey, and peak absolute acceleration of the floor above it, beside the neighbours, as \
         multiples of those of the same building alone, by the exact method. Lines reach from the least to the largest value when the record is made \
         one per cent weaker, stronger, faster or slower.{left_out}"
    );
    Some((picture(effects, prepared, &floors), caption))
}

/// The storeys that are shown: building by building, from the roof down.
fn shown(effects: &Effects, prepared: &Simulation) -> Vec<usize> {
    let floors = prepared.floors();
    let moves = |floor: &usize| !floors.all()[*floor].is_wall();
    let structures = 0..prepared.scene().structures.len();
    let downwards = structures.flat_map(|one| floors.of_structure(one).iter().rev().copied());
    let mut shown: Vec<_> = downwards.filter(moves).collect();
    if shown.len() > MOST {
        let mut order = shown.clone();
        order.sort_by(|one, other| most(effects, *other).total_cmp(&most(effects, *one)));
        order.truncate(MOST);
        shown.retain(|floor| order.contains(floor));
    }
    shown
}

/// Largest change of a response of a floor by pounding, up or down.
fn most(effects: &Effects, floor: usize) -> f64 {
    let both = [&effects.as_given[floor], &effects.reversed[floor]];
    let effects = both.iter().flat_map(|one| one.responses());
    let ratios = effects.filter_map(|effect| effect?.amplification);
    let changes = ratios.map(|ratio| (ratio.value - 1.0).abs());
    changes.fold(0.0, f64::max)
}

fn picture(effects: &Effects, prepared: &Simulation, floors: &[usize]) -> Figure {
    let name = |floor: &usize| writable(&prepared.floors().storey_name(*floor));
    let names: Vec<String> = floors.iter().map(name).collect();
    let all = prepared.floors().all();
    let panels = PANELS.iter().enumerate().map(|(response, title)| Panel {
        title: (*title).into(),
        x: Some(Axis::auto("Beside / alone (–)")),
        y: Axis::names(names.clone()),
        curves: curves(effects, floors, response),
        levels: borders(floors.iter().map(|floor| all[*floor].structure)),
        legend: Legend::Shared,
        ..Panel::default()
    });
    Figure {
        height_in: 1.3 + 0.2 * floors.len() as f64,
        columns: PANELS.len(),
        panels: panels.collect(),
        ..Figure::default()
    }
}

/// Between the names of a list of storeys, where a building ends and the next begins.
pub(crate) fn borders(structures: impl Iterator<Item = usize>) -> Vec<f64> {
    let all: Vec<usize> = structures.collect();
    let ends = all.windows(2).enumerate();
    let ends = ends.filter(|(_, two)| two[0] != two[1]);
    ends.map(|(index, _)| index as f64 + 0.5).collect()
}

/// The line at 1 through all storeys, at which pounding changes nothing.
pub(crate) fn as_alone(storeys: usize) -> Curve {
    let ends = vec![(1.0, -0.5), (1.0, storeys as f64 - 0.5)];
    Curve::new(CurveKind::Dashed, Shade::Ink, ends)
}

fn curves(effects: &Effects, floors: &[usize], response: usize) -> Vec<Curve> {
    let [as_given, reversed] = [false, true].map(RecordUse::direction_of);
    let directions = [
        (&effects.as_given, as_given, Shade::Blue, Mark::Disc, -APART),
        (&effects.reversed, reversed, Shade::Vermilion, Mark::Square, APART),
    ];
    let mut curves = vec![as_alone(floors.len())];
    for (all, label, shade, mark, aside) in directions {
        let found = floors.iter().enumerate().filter_map(|(place, floor)| {
            let known = all[*floor].responses()[response]?.amplification?;
            Some((known, place as f64 + aside))
        });
        let found: Vec<_> = found.collect();
        for (known, y) in &found {
            let range = vec![(known.low, *y), (known.high, *y)];
            curves.push(Curve::new(CurveKind::Line, shade, range));
        }
        let points = found.iter().map(|(known, y)| (known.value, *y)).collect();
        curves.push(Curve::new(CurveKind::Points, shade, points).marked(mark).named(label));
    }
    curves
}
