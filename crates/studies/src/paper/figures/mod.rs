//! Figures: what a study draws.

mod collisions;
mod histories;
mod layouts;

use crate::{Completed, Output, StudyError};
use pounding_plot::{PlotError, render_png};
use pounding_scene::{RunResult, Structure};
use pounding_solver::State;

/// The figure of a study as PNG; nothing for a study that prints a table.
///
/// # Errors
/// [`StudyError`] when the scenes do not give what the figure shows.
pub fn figure_png(completed: &Completed) -> Result<Option<Vec<u8>>, StudyError> {
    let png = match &completed.file.study.output {
        Output::RecordFigure => {
            let scene = &completed.file.study.scenes[0];
            render_png(&histories::record(scene, completed.prepared[0].record()))
        }
        Output::DisplacementFigure => render_png(&histories::displacements(completed)),
        Output::PoundingFigure => render_png(&collisions::pounding(completed)),
        Output::FirstCollisionFigure => render_png(&collisions::first_collisions(completed)),
        Output::LayoutFigure => render_png(&layouts::drawing(&completed.file.study.scenes)),
        Output::ShearForceFigure { structure } => render_png(&histories::shear_forces(completed, structure)?),
        Output::StructuresTable
        | Output::PoundingForcesTable { .. }
        | Output::FirstCollisionTable
        | Output::TransferredMomentumTable
        | Output::TextTable { .. }
        | Output::Trade(_)
        | Output::Laws(_)
        | Output::Extremes(_)
        | Output::Beyond(_)
        | Output::Survey(_)
        | Output::Claims => return Ok(None),
    };
    png.map(Some).map_err(|source: PlotError| StudyError::Plot {
        path: completed.file.path.clone(),
        source,
    })
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

/// A name with its first letter large.
pub(crate) fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters
        .next()
        .map(|first| first.to_uppercase().chain(letters).collect())
        .unwrap_or_default()
}

/// A quantity of one structure over time, as points.
fn points(outcome: &RunResult, index: usize, quantity: impl Fn(&State) -> f64) -> Vec<(f64, f64)> {
    let histories = outcome.histories.as_ref().expect("figures of histories ask for them");
    let states = histories.of(index).states.iter().enumerate();
    states
        .map(|(i, state)| (i as f64 * histories.interval(), quantity(state)))
        .collect()
}
