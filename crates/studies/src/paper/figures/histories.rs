//! Figures of quantities over time: the record, displacements, shear forces.

use super::{label, points};
use crate::files::capital;
use crate::{Completed, StudyError};
use pounding_motion::Record;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Note, Panel, Shade, minus};
use pounding_scene::{RunResult, Scene, Structure};

/// The axis of time of a scene.
pub(super) fn time_axis(scene: &Scene) -> Axis {
    Axis::over("Time (s)", 0.0, scene.duration())
}

/// The study's title for its first panel, an empty text for the others.
fn title(completed: &Completed, panel: usize) -> String {
    match panel {
        0 => completed.file.study.title.clone(),
        _ => String::new(),
    }
}

/// The record as in its file: in g, not reversed.
pub(super) fn record(scene: &Scene, record: &Record) -> Figure {
    let sign = if scene.record.reversed { -1.0 } else { 1.0 };
    let in_g = |acceleration: f64| sign * acceleration / (scene.record.scale * scene.record.gravity_m_per_s2);
    let shown = record.samples().iter().enumerate();
    let shown = shown.map(|(i, sample)| (i as f64 * record.time_step(), in_g(*sample)));
    let shown: Vec<_> = shown.take_while(|(time, _)| *time <= scene.duration()).collect();
    let farther = |peak: (f64, f64), point: (f64, f64)| if point.1.abs() > peak.1.abs() { point } else { peak };
    let peak = shown.iter().copied().fold((0.0, 0.0), farther);
    let text = minus(&format!("{:.3} g at {:.2} s", peak.1, peak.0));
    let curves = vec![
        Curve::new(CurveKind::Thin, Shade::Blue, shown),
        Curve::new(CurveKind::Points, Shade::Vermilion, vec![peak]),
    ];
    let panel = over_time(String::new(), "Ground acceleration (g)", curves, vec![Note::new(peak, text)]);
    Figure::grid(2.8, 1, time_axis(scene), vec![panel])
}

/// A quantity over time, with a line at zero.
fn over_time(title: String, label: &str, curves: Vec<Curve>, notes: Vec<Note>) -> Panel {
    Panel {
        title,
        y: Axis::auto(label),
        levels: vec![0.0],
        notes,
        curves,
        ..Panel::default()
    }
}

/// Displacements of separate structures, one panel each, with marks at the peaks.
pub(super) fn displacements(completed: &Completed) -> Figure {
    let (scene, outcome) = (&completed.file.study.scenes[0], &completed.outcomes[0]);
    let panel = |(index, structure)| {
        let peak = outcome.peaks.of(index).displacement;
        let at = (peak.time, 1e3 * peak.value);
        let text = minus(&format!("{:.1} mm at {:.2} s", at.1, at.0));
        let history = points(outcome, index, |state| 1e3 * state.displacement);
        let curves = vec![
            Curve::new(CurveKind::Line, Shade::nth(index), history).named(label(structure)),
            Curve::new(CurveKind::Points, Shade::nth(index), vec![at]),
        ];
        over_time(title(completed, index), "Displacement (mm)", curves, vec![Note::new(at, text)])
    };
    Figure {
        x: time_axis(scene),
        panels: scene.structures.iter().enumerate().map(panel).collect(),
        ..Figure::default()
    }
}

/// Shear force of one structure. The first scene is in the background; each further scene has its own panel.
pub(super) fn shear_forces(completed: &Completed, structure: &str) -> Result<Figure, StudyError> {
    let curve = |((scene, outcome), index): ((&Scene, &RunResult), usize)| {
        let mut names = scene.structures.iter().map(Structure::name);
        let position = names.position(|name| name == structure)?;
        let history = points(outcome, position, |state| state.restoring_force / 1e3);
        let (kind, shade) = match index {
            0 => (CurveKind::Dashed, Shade::Ink),
            _ => (CurveKind::Line, Shade::nth(index - 1)),
        };
        Some(Curve::new(kind, shade, history).named(capital(&scene.name)))
    };
    let curves: Option<Vec<_>> = completed.runs().zip(0..).map(curve).collect();
    let allowed = "the name of a structure of every scene";
    let place = "output.shear_force_figure.structure";
    let curves = curves.ok_or_else(|| completed.refuse(place, format!("\"{structure}\""), allowed))?;
    let panel = |(panel, front): (usize, &Curve)| {
        let both = vec![curves[0].clone(), front.clone()];
        over_time(title(completed, panel), "Shear force (kN)", both, Vec::new())
    };
    let panels = curves.iter().skip(1).enumerate().map(panel).collect();
    Ok(Figure::grid(5.0, 1, time_axis(&completed.file.study.scenes[0]), panels))
}
