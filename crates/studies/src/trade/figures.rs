//! Error against work: a line for each method.

use std::path::Path;

use super::measure::{Entrant, Race};
use super::quantities::Quantity;
use crate::StudyError;
use crate::figures::capital;
use crate::plot::{Axis, Curve, Figure, Legend, Panel, render_png};

/// Scenes with a figure of their own; all others share two.
const OWN: &str = "two structures, ";
/// Scenes of three structures.
const LAYOUTS: &str = "layout ";
/// Errors below this are rounding.
const ROUNDING: f64 = 1e-16;
/// Errors above this are worth nothing.
const WORTHLESS: f64 = 3e1;

/// Every figure with its name.
pub(super) fn all(races: &[Race], path: &Path) -> Result<Vec<(String, Vec<u8>)>, StudyError> {
    let mut figures = Vec::new();
    let (mut layouts, mut others) = (Vec::new(), Vec::new());
    for race in races {
        if race.scene.starts_with(OWN) {
            let panels = Quantity::ALL
                .map(|quantity| panel(race, quantity, quantity.words(race.compliant).into()));
            figures.push((file_name(&race.scene), figure(panels.into(), 2)));
        } else if race.scene.starts_with(LAYOUTS) {
            layouts.push(panel(race, Quantity::Momentum, capital(&race.scene)));
        } else {
            let title = format!(
                "{}: {}",
                capital(&race.scene),
                Quantity::Displacement.words(race.compliant).to_lowercase()
            );
            others.push(panel(race, Quantity::Displacement, title));
        }
    }
    figures.push((
        "layouts-transferred-momentum.png".into(),
        figure(layouts, 2),
    ));
    figures.push(("free-impact-and-uncoupled.png".into(), figure(others, 2)));
    let drawn = figures
        .into_iter()
        .filter(|(_, figure)| !figure.panels.is_empty());
    drawn
        .map(|(name, figure)| {
            let png = render_png(&figure).map_err(|source| StudyError::Plot {
                path: path.to_path_buf(),
                source,
            })?;
            Ok((name, png))
        })
        .collect()
}

fn file_name(scene: &str) -> String {
    format!("{}.png", scene.replace(", ", "-").replace(' ', "-"))
}

fn figure(panels: Vec<Panel>, columns: usize) -> Figure {
    let rows = panels.len().div_ceil(columns);
    Figure {
        height_in: 1.1 + 1.9 * rows as f64,
        columns,
        x: Axis::auto("Work: force evaluations + pieces of exact motion").log(),
        panels,
    }
}

fn panel(race: &Race, quantity: Quantity, title: String) -> Panel {
    Panel {
        title,
        y: Axis::over("Relative error", ROUNDING, WORTHLESS).log(),
        curves: race
            .entrants
            .iter()
            .filter_map(|entrant| curve(entrant, quantity))
            .collect(),
        legend: Legend::Shared,
        ..Panel::default()
    }
}

fn curve(entrant: &Entrant, quantity: Quantity) -> Option<Curve> {
    let (shade, kind, mark) = entrant.contender.line?;
    let point = |rung: &super::measure::Rung| {
        let measured = rung.outcome.as_ref().ok()?;
        let error = measured.error(quantity)?;
        (error < WORTHLESS).then_some((measured.cost() as f64, error.max(ROUNDING)))
    };
    let points = entrant.rungs.iter().filter_map(point).collect();
    Some(
        Curve::new(kind, shade, points)
            .marked(mark)
            .named(entrant.contender.label),
    )
}
