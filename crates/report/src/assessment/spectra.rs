//! Spectra of the records, of their mean, and of their target: what a checking engineer looks at first.

use pounding_assess::MotionSpectrum;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Note, Panel, Shade};
use pounding_scene::Structure;

use super::AssessmentReport;
use crate::figures::fitting;

/// Most buildings whose periods are named.
const MOST: usize = 6;

/// The figure with its caption; `None` if no record has a spectrum.
pub(super) fn figure(report: &AssessmentReport) -> Option<(Figure, String)> {
    let spectra = report.spectra();
    let periods = &spectra.first()?.periods;
    let gravity = report.scene.record.gravity_m_per_s2;
    let curve = |kind, shade, values: &mut dyn FnMut(usize) -> f64| {
        let points = periods.iter().enumerate().map(|(index, period)| (*period, values(index)));
        Curve::new(kind, shade, points.collect())
    };
    let of_record = |(index, one): (usize, &&MotionSpectrum)| {
        let own = curve(CurveKind::Thin, Shade::Grey, &mut |place| one.accelerations[place] / gravity);
        if index == 0 { own.named("records") } else { own }
    };
    let mut curves: Vec<Curve> = spectra.iter().enumerate().map(of_record).collect();
    let n = spectra.len() as f64;
    let mut mean = |place: usize| spectra.iter().map(|one| one.accelerations[place]).sum::<f64>() / n / gravity;
    curves.push(curve(CurveKind::Line, Shade::Blue, &mut mean).named("mean of the records"));
    if let Some(target) = report.scaling.to.target() {
        let mut of_target = |place: usize| target.spectrum.acceleration(periods[place]);
        curves.push(curve(CurveKind::Dashed, Shade::Ink, &mut of_target).named("target"));
    }
    let highest = curves
        .iter()
        .flat_map(|curve| &curve.points)
        .map(|point| point.1)
        .fold(0.0, f64::max);
    let own = report.scene.structures.iter();
    let mut own: Vec<(String, f64)> = own
        .filter_map(|one: &Structure| Some((fitting(one.name()), one.longest_period()?)))
        .collect();
    own.truncate(MOST);
    let note =
        |(place, (name, period)): (usize, &(String, f64))| Note::new((*period, highest * (1.05 - 0.09 * place as f64)), name.clone());
    let figure = Figure {
        height_in: 3.4,
        x: Axis::over("Natural period (s)", periods[0], periods[periods.len() - 1]).log(),
        panels: vec![Panel {
            y: Axis::over("Pseudo-acceleration (g)", 0.0, 1.15 * highest),
            curves,
            markers: own.iter().map(|(_, period)| *period).collect(),
            notes: own.iter().enumerate().map(note).collect(),
            ..Panel::default()
        }],
        ..Figure::default()
    };
    let dashed = report.scaling.to.target().map_or("", |_| "; dashed: the target");
    let asked = report.scaling.to.target().and_then(|target| target.periods);
    let axis = if asked.is_some() {
        "The axis has the periods at which they are compared"
    } else {
        "The axis goes from 0.2 times the shortest to 2 times the longest first period of the row, where EN 1998-1, 3.2.3.1.2, compares them"
    };
    let is_maximum = report.scaling.to.target().is_some_and(|target| target.maximum_direction);
    let which = if is_maximum { "Maximum-direction spectra" } else { "Spectra" };
    let caption = format!(
        "{which} for 5 % of damping of the records as they shake the row (grey) and of their mean (blue){dashed}. {axis}; \
         ASCE/SEI 7-16, 16.2.3.2, compares maximum-direction spectra with MCE_R; upright lines mark \
         the first periods of the structures, on isolators those after they yield."
    );
    Some((figure, caption))
}
