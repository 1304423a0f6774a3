//! Figures that studies draw.

mod collisions;
mod histories;
mod layouts;

use crate::files::{capital, drawn};
use crate::{Completed, Output, StudyError};
use pounding_scene::{RunResult, Structure};
use pounding_solver::State;

/// The figure of a study as PNG; `None` if the study prints a table.
///
/// # Errors
/// [`StudyError`] if the scenes do not give the contents of the figure.
pub fn figure_png(completed: &Completed) -> Result<Option<Vec<u8>>, StudyError> {
    let (output, scenes) = (&completed.file.study.output, &completed.file.study.scenes);
    let figure = if let Output::RecordFigure = output {
        histories::record(&scenes[0], completed.prepared[0].record())
    } else if let Output::DisplacementFigure = output {
        histories::displacements(completed)
    } else if let Output::PoundingFigure = output {
        collisions::pounding(completed)
    } else if let Output::FirstCollisionFigure = output {
        collisions::first_collisions(completed)
    } else if let Output::ShearForceFigure { structure } = output {
        histories::shear_forces(completed, structure)?
    } else if let Output::LayoutFigure = output {
        return drawn(&layouts::drawing(scenes), &completed.file.path).map(Some);
    } else {
        return Ok(None);
    };
    drawn(&figure, &completed.file.path).map(Some)
}

/// Name of a structure with its period, for a legend.
fn label(structure: &Structure) -> String {
    match structure {
        Structure::Sdof(_) | Structure::Building(_) => {
            let period = structure.period().unwrap_or(0.0);
            format!("{} (T = {period:.1} s)", capital(structure.name()))
        }
        Structure::Wall => "Wall".into(),
    }
}

/// A quantity of one structure over time, as points.
fn points(outcome: &RunResult, index: usize, quantity: impl Fn(&State) -> f64) -> Vec<(f64, f64)> {
    let histories = outcome.histories.as_ref().expect("figures of histories ask for them");
    let states = histories.of(index).states.iter().enumerate();
    states
        .map(|(i, state)| (i as f64 * histories.interval(), quantity(state)))
        .collect()
}
