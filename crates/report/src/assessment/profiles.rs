//! Peak drift and shear force over the height of the buildings, alone and beside their neighbours, over all runs.

use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Mark, Panel, Shade};
use pounding_scene::{AssessedFloor, Distribution, FloorPeaks};

use super::AssessmentReport;
use crate::figures::profiles::{MOST, over, storeys};
use crate::figures::{fitting, unit};

pub(super) const CAPTION: &str = "Peak storey drift and shear force over the height of the buildings, over all runs in both directions. \
                                  Dashed: alone. Lines with marks: beside the neighbours, with the contact of the scene. Blue: the \
                                  median; orange: what 84 % of the runs do not exceed.";

/// `None` if no building has several storeys.
pub(super) fn figure(report: &AssessmentReport) -> Option<Figure> {
    let floors = report.floors();
    let structures = 0..report.scene.structures.len();
    let buildings = structures.filter(|index| {
        let own = floors.of_structure(*index);
        own.len() > 1 && !floors.all()[own[0]].is_wall()
    });
    let shown: Vec<usize> = buildings.take(MOST).collect();
    if shown.is_empty() {
        return None;
    }
    let forces = report.motions.iter().flat_map(|one| &one.run.floors);
    let largest = forces.map(|floor| floor.beside.shear).fold(0.0, f64::max);
    let (force, factor) = unit(largest, "N");
    let responses = [
        Response {
            label: "Drift (mm)".into(),
            of: |peaks| peaks.drift,
            factor: 1e3,
        },
        Response {
            label: format!("Shear ({force})"),
            of: |peaks| peaks.shear,
            factor,
        },
    ];
    let panels = responses.iter().flat_map(|response| {
        let curves: Vec<Vec<Curve>> = shown
            .iter()
            .map(|building| response.curves(report, *building))
            .collect();
        let points = curves.iter().flatten().flat_map(|curve| &curve.points);
        // From zero, and the same for all buildings.
        let end = 1.05 * points.map(|point| point.0).fold(0.0, f64::max);
        let label = &response.label;
        let panel = move |(building, curves): (&usize, Vec<Curve>)| Panel {
            title: fitting(report.scene.structures[*building].name()),
            x: Some(if end > 0.0 {
                Axis::over(label.clone(), 0.0, end)
            } else {
                Axis::auto(label.clone())
            }),
            y: storeys(floors.of_structure(*building).len()),
            curves,
            legend: Legend::Shared,
            ..Panel::default()
        };
        shown.iter().zip(curves).map(panel)
    });
    Some(Figure {
        height_in: 4.4,
        columns: shown.len(),
        panels: panels.collect(),
        ..Figure::default()
    })
}

/// What a row of panels shows, and what brings it to the unit of its axis.
struct Response {
    label: String,
    of: fn(&FloorPeaks) -> f64,
    factor: f64,
}

impl Response {
    fn curves(&self, report: &AssessmentReport, building: usize) -> Vec<Curve> {
        let floors = report.floors.of_structure(building);
        let line = |side: fn(&AssessedFloor) -> &FloorPeaks, quantile: f64| {
            over(floors, |floor| {
                let runs = report.motions.iter().map(|one| &one.run.floors[floor]);
                let all = Distribution::of(runs.map(|one| self.factor * (self.of)(side(one))));
                all.map_or(0.0, |all| all.quantile(quantile))
            })
        };
        let alone: fn(&AssessedFloor) -> &FloorPeaks = |floor| &floor.alone;
        let beside: fn(&AssessedFloor) -> &FloorPeaks = |floor| &floor.beside;
        let curve = |kind, shade, points, name: &str| Curve::new(kind, shade, points).named(name);
        vec![
            curve(Kind::Dashed, Shade::Blue, line(alone, 0.5), "alone, median"),
            curve(Kind::Line, Shade::Blue, line(beside, 0.5), "beside, median").marked(Mark::Disc),
            curve(
                Kind::Dashed,
                Shade::Vermilion,
                line(alone, 0.84),
                "alone, 84 %",
            ),
            curve(
                Kind::Line,
                Shade::Vermilion,
                line(beside, 0.84),
                "beside, 84 %",
            )
            .marked(Mark::Square),
        ]
    }
}
