//! Runs of a scene by the second route.

use pounding_reference::{Fineness, Response, SecondRouteError};
use pounding_scene::Simulation;
use pounding_solver::OnRow;
use pounding_solver::{Excitation, Hysteretic, Row};

/// A run of a row by the second route.
struct SecondRoute<'a> {
    excitation: Excitation<'a>,
    /// Length of the run \[s\].
    duration: f64,
    fineness: Fineness,
}

impl OnRow for SecondRoute<'_> {
    type Output = Result<Response, SecondRouteError>;

    fn on<Column: Hysteretic>(self, row: &Row<Column>) -> Self::Output {
        pounding_reference::run(row, self.excitation, self.duration, self.fineness)
    }
}

/// Runs a scene by the second route; the method of the scene is ignored.
///
/// # Errors
/// [`SecondRouteError`] if the run ends early.
pub fn second_route(prepared: &Simulation, fineness: Fineness) -> Result<Response, SecondRouteError> {
    let clock = prepared.clock();
    prepared.on_row(SecondRoute {
        excitation: prepared.excitation(),
        duration: clock.time(clock.n_steps),
        fineness,
    })
}
