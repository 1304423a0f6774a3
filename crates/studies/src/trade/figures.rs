//! Error against work.

use std::path::Path;

use super::measure::Race;
use super::quantities::Quantity;
use crate::StudyError;
use crate::plot::{Axis, Curve, Figure, Legend, Panel, render_png};

/// Every figure with its name.
pub(super) fn all(races: &[Race], path: &Path) -> Result<Vec<(String, Vec<u8>)>, StudyError> {
    races
        .iter()
        .take(4)
        .map(|race| {
            let png = render_png(&figure(race)).map_err(|source| StudyError::Plot {
                path: path.to_path_buf(),
                source,
            })?;
            Ok((
                format!("{}.png", race.scene.replace(", ", "-").replace(' ', "-")),
                png,
            ))
        })
        .collect()
}

fn figure(race: &Race) -> Figure {
    let panels = Quantity::ALL.map(|quantity| Panel {
        title: quantity.words(race.compliant).into(),
        y: Axis::over("Error", 1e-16, 1e1).log(),
        curves: race
            .entrants
            .iter()
            .map(|entrant| {
                let points = entrant.rungs.iter().filter_map(|rung| {
                    let measured = rung.outcome.as_ref().ok()?;
                    let error = measured.error(quantity).filter(|error| error.is_finite())?;
                    Some((measured.cost() as f64, error.max(1e-16)))
                });
                Curve::distinct(entrant.contender.line, points.collect())
                    .named(entrant.contender.label)
            })
            .collect(),
        legend: Legend::Shared,
        ..Panel::default()
    });
    Figure {
        height_in: 7.0,
        columns: 2,
        x: Axis::auto("Work").log(),
        panels: panels.into(),
    }
}
