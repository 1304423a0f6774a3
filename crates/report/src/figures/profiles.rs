//! Peak drift and shear force over the height of every building, in both directions of shaking, and of the building alone if that is known.

use super::{Known, fitting, unit};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Legend, Mark, Panel, Shade};
use pounding_scene::{Floors, RecordUse, RunResult, Scene, Simulation};

/// More buildings than this do not fit side by side.
pub(crate) const MOST: usize = 4;
/// Most storeys whose names stand on an axis.
const NAMED: usize = 12;

/// `None` if no building has several storeys.
pub(super) fn figure(prepared: &Simulation, outcome: &RunResult, known: Known<'_>) -> Option<(Figure, String)> {
    let buildings = of_storeys(prepared.scene(), prepared.floors());
    let shown = &buildings[..buildings.len().min(MOST)];
    if shown.is_empty() {
        return None;
    }
    let responses = responses(prepared, outcome);
    let panels = responses.iter().flat_map(|response| {
        let curves = shown
            .iter()
            .map(|building| (*building, response.curves(prepared, *building, outcome, known)));
        let row = (prepared.scene(), prepared.floors());
        panels(row, &response.label, curves.collect())
    });
    let figure = Figure {
        height_in: 5.6,
        columns: shown.len(),
        panels: panels.collect(),
        ..Figure::default()
    };
    Some((figure, caption(known, (shown.len(), buildings.len()))))
}

/// The buildings that have several storeys.
pub(crate) fn of_storeys(scene: &Scene, floors: &Floors) -> Vec<usize> {
    let structures = 0..scene.structures.len();
    let several = structures.filter(|index| {
        let own = floors.of_structure(*index);
        own.len() > 1 && !floors.all()[own[0]].is_wall()
    });
    several.collect()
}

/// A panel for each building with its curves, over one axis that begins at zero.
pub(crate) fn panels((scene, floors): (&Scene, &Floors), label: &str, buildings: Vec<(usize, Vec<Curve>)>) -> Vec<Panel> {
    let curves = buildings.iter().flat_map(|(_, curves)| curves);
    let points = curves.flat_map(|curve| &curve.points);
    let end = 1.05 * points.map(|point| point.0).fold(0.0, f64::max);
    let panel = |(building, curves): (usize, Vec<Curve>)| Panel {
        title: fitting(scene.structures[building].name()),
        x: Some(if end > 0.0 {
            Axis::over(label, 0.0, end)
        } else {
            Axis::auto(label)
        }),
        y: storeys(floors.of_structure(building).len()),
        curves,
        legend: Legend::Shared,
        ..Panel::default()
    };
    buildings.into_iter().map(panel).collect()
}

fn caption(known: Known<'_>, (shown, all): (usize, usize)) -> String {
    let both = match known.other {
        Some(_) => ", in the direction of the scene and in the other one",
        None => "",
    };
    let alone = match known.effects {
        Some(_) => " Dashed: the same building alone, the larger of both directions.",
        None => "",
    };
    let left_out = if shown < all {
        format!(" Of {all} buildings the first {MOST} from the left.")
    } else {
        String::new()
    };
    format!("Peak storey drift and shear force over the height of the buildings{both}.{alone}{left_out}")
}

/// The profiles that are shown, with the unit of shear forces that fits a run.
fn responses(prepared: &Simulation, outcome: &RunResult) -> [Response; 2] {
    let floors = prepared.floors();
    let all = 0..floors.all().len();
    let largest = all.map(|floor| outcome.peaks.of(floor).column_force().value.abs());
    let (unit, factor) = unit(largest.fold(0.0, f64::max), "N");
    [
        Response {
            label: "Drift (mm)".into(),
            of: |result, floor| 1e3 * result.peaks.of(floor).drift().value.abs(),
            alone: 0,
            factor: 1.0,
        },
        Response {
            label: format!("Shear ({unit})"),
            of: |result, floor| result.peaks.of(floor).column_force().value.abs(),
            alone: 1,
            factor,
        },
    ]
}

/// Storeys from the ground up; each has its name if there is room.
fn storeys(n: usize) -> Axis {
    let names = (1..=n).rev().map(|storey| storey.to_string());
    Axis {
        label: "Storey".into(),
        ..if n <= NAMED {
            Axis::names(names.collect())
        } else {
            Axis::default()
        }
    }
}

/// What a row of panels shows.
struct Response {
    label: String,
    /// The number of a run and a floor, in the unit of the axis divided by the factor.
    of: fn(&RunResult, usize) -> f64,
    /// Its place among the responses of effects.
    alone: usize,
    factor: f64,
}

impl Response {
    fn curves(&self, prepared: &Simulation, building: usize, outcome: &RunResult, known: Known<'_>) -> Vec<Curve> {
        let floors = prepared.floors().of_structure(building);
        let of = |result: &RunResult| over(floors, |floor| self.factor * (self.of)(result, floor));
        let mut curves = Vec::new();
        if let Some(effects) = known.effects {
            let scale = if self.alone == 0 { 1e3 } else { self.factor };
            let alone = |floor: usize| {
                let both = [&effects.as_given[floor], &effects.reversed[floor]];
                let all = both.iter().filter_map(|one| Some(one.responses()[self.alone]?.alone));
                scale * all.fold(0.0, f64::max)
            };
            curves.push(Curve::new(CurveKind::Dashed, Shade::Ink, over(floors, alone)).named("alone"));
        }
        curves.push(
            Curve::new(CurveKind::Line, Shade::Blue, of(outcome))
                .marked(Mark::Disc)
                .named(prepared.scene().record.direction()),
        );
        if let Some(other) = known.other {
            curves.push(
                Curve::new(CurveKind::Line, Shade::Vermilion, of(other))
                    .marked(Mark::Square)
                    .named(RecordUse::direction_of(!prepared.scene().record.reversed)),
            );
        }
        curves
    }
}

/// A value of every floor of a building over the number of its storey; names of an axis count from the top.
pub(crate) fn over(floors: &[usize], value: impl Fn(usize) -> f64) -> Vec<(f64, f64)> {
    let storeys = floors.iter().enumerate();
    let n = floors.len();
    let place = |storey: usize| {
        if n <= NAMED { n - 1 - storey } else { storey + 1 }
    };
    let point = |(storey, floor): (usize, &usize)| (value(*floor), place(storey) as f64);
    storeys.map(point).collect()
}
