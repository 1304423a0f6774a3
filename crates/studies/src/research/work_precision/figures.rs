//! Figures of error against work, one line per method.

use crate::StudyError;
use crate::lines::line_of;
use std::path::Path;

use super::measure::{Entrant, Race, Rung};
use super::quantities::MethodQuantity;
use crate::files::{capital, drawn};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Panel};

/// Start of the names of scenes with their own figure; all others share two figures.
const OWN: &str = "two structures, ";
/// Start of the names of scenes with three structures.
const LAYOUTS: &str = "layout ";
/// Panels in a row.
const COLUMNS: usize = 2;
/// Smaller errors are rounding \[–\].
const ROUNDING: f64 = 1e-16;
/// Larger errors are not drawn \[–\].
const WORTHLESS: f64 = 3e1;

/// Every figure with its name.
pub(super) fn all(races: &[Race], path: &Path) -> Result<Vec<(String, Vec<u8>)>, StudyError> {
    let mut figures = Vec::new();
    let (mut layouts, mut others) = (Vec::new(), Vec::new());
    for race in races {
        if race.scene.starts_with(OWN) {
            let panels = MethodQuantity::ALL.map(|quantity| {
                let title = quantity.words(race.compliant);
                panel(race, quantity, [title, "Relative error"])
            });
            figures.push((file_name(&race.scene), figure(panels.into())));
        } else if race.scene.starts_with(LAYOUTS) {
            let words = [&capital(&race.scene), "Error of momentum"];
            layouts.push(panel(race, MethodQuantity::Momentum, words));
        } else {
            let words = [&capital(&race.scene), "Error of peak displacement"];
            others.push(panel(race, MethodQuantity::Displacement, words));
        }
    }
    figures.push(("layouts-transferred-momentum.png".into(), figure(layouts)));
    figures.push(("free-impact-and-uncoupled.png".into(), figure(others)));
    let shown = figures.into_iter().filter(|(_, figure)| !figure.panels.is_empty());
    shown.map(|(name, figure)| Ok((name, drawn(&figure, path)?))).collect()
}

fn file_name(scene: &str) -> String {
    format!("{}.png", scene.replace(", ", "-").replace(' ', "-"))
}

/// Panels side by side with one y axis.
fn figure(panels: Vec<Panel>) -> Figure {
    let height_in = 1.1 + 1.9 * panels.len().div_ceil(COLUMNS) as f64;
    Figure::grid(height_in, COLUMNS, Axis::auto("Work (evaluations + pieces)").log(), panels).labelled_at_left()
}

fn panel(race: &Race, quantity: MethodQuantity, [title, error]: [&str; 2]) -> Panel {
    let mut curves: Vec<_> = race.entrants.iter().filter_map(|entrant| curve(entrant, quantity)).collect();
    // Hollow marks are drawn over solid ones, so both stay visible.
    curves.sort_by_key(|curve| curve.kind == CurveKind::Dashed);
    Panel::shared(title, Axis::over(error, ROUNDING, WORTHLESS).log(), curves)
}

fn curve(entrant: &Entrant, quantity: MethodQuantity) -> Option<Curve> {
    let (shade, kind, mark) = line_of(entrant.contender.key)?;
    let point = |rung: &Rung| {
        let measured = rung.outcome.as_ref().ok()?;
        let error = measured.error(quantity)?;
        (error < WORTHLESS).then_some((measured.cost() as f64, error.max(ROUNDING)))
    };
    let points = entrant.rungs.iter().filter_map(point).collect();
    let curve = Curve::new(kind, shade, points).marked(mark);
    Some(curve.named(entrant.contender.label))
}
