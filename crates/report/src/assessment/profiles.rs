//! Peak drift and shear force over the height of the buildings, alone and beside their neighbours, over all runs.

use std::collections::BTreeSet;

use pounding_assess::{AssessedFloor, Distribution, FloorPeaks, RunOfCase};
use pounding_plot::{Curve, CurveKind, Figure, Mark, Shade};

use super::{AssessmentReport, runs_of_cases};
use crate::figures::profiles::{MOST, of_storeys, over, panels};
use crate::figures::unit;

const CAPTION: &str = "Peak storey drift and shear force over the height of the buildings. Dashed: alone. Lines with marks: beside \
                                  the neighbours, with the contact of the scene. Blue: the median of the events in which the building touches; orange: \
                                  what 84 % of them do not exceed, or the largest of fewer than seven.";

/// The caption, with the buildings that are left out.
pub(super) fn caption(report: &AssessmentReport) -> String {
    let all = of_storeys(&report.scene, report.floors()).len();
    if all > MOST {
        format!("{CAPTION} Of {all} buildings the first {MOST} from the left.")
    } else {
        CAPTION.into()
    }
}

/// `None` if no building has several storeys.
pub(super) fn figure(report: &AssessmentReport) -> Option<Figure> {
    let mut shown = of_storeys(&report.scene, report.floors());
    shown.truncate(MOST);
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
        let curves = shown.iter().map(|building| (*building, response.curves(report, *building)));
        let row = (&report.scene, report.floors());
        panels(row, &response.label, curves.collect())
    });
    Some(Figure {
        height_in: 4.4,
        columns: shown.len(),
        panels: panels.collect(),
        ..Figure::default()
    })
}

/// The quantity of a row of panels, and the factor to the unit of its axis.
struct Response {
    label: String,
    of: fn(&FloorPeaks) -> f64,
    factor: f64,
}

impl Response {
    fn curves(&self, report: &AssessmentReport, building: usize) -> Vec<Curve> {
        let floors = report.floors.of_structure(building);
        // The runs that the tables take: of those that are believed, the ones in which something touches the building, or all if nothing
        // ever does.
        let mut cases = RunOfCase::believed(&runs_of_cases(&report.motions));
        if cases.iter().any(|one| one.run.hits(&report.floors, building)) {
            cases.retain(|one| one.run.hits(&report.floors, building));
        }
        let line = |side: fn(&AssessedFloor) -> &FloorPeaks, of: fn(&Distribution) -> f64| {
            over(floors, |floor| {
                let runs = cases.iter().map(|one| (one.case(), &one.run.floors[floor]));
                let all = Distribution::of_cases(runs.map(|(case, one)| (case, self.factor * (self.of)(side(one)))));
                all.map_or(0.0, |all| of(&all))
            })
        };
        let touching: BTreeSet<_> = cases.iter().map(RunOfCase::case).collect();
        let upper = if touching.len() < Distribution::ENOUGH { "largest" } else { "84 %" };
        let [alone_upper, beside_upper] = ["alone", "beside"].map(|side| format!("{side}, {upper}"));
        let alone: fn(&AssessedFloor) -> &FloorPeaks = |floor| &floor.alone;
        let beside: fn(&AssessedFloor) -> &FloorPeaks = |floor| &floor.beside;
        let curve = |kind, shade, points, name: &str| Curve::new(kind, shade, points).named(name);
        vec![
            curve(CurveKind::Dashed, Shade::Blue, line(alone, Distribution::median), "alone, median"),
            curve(CurveKind::Line, Shade::Blue, line(beside, Distribution::median), "beside, median").marked(Mark::Disc),
            curve(CurveKind::Dashed, Shade::Vermilion, line(alone, Distribution::upper), &alone_upper),
            curve(CurveKind::Line, Shade::Vermilion, line(beside, Distribution::upper), &beside_upper).marked(Mark::Square),
        ]
    }
}
