//! Runs of a scene by the second route.

use std::sync::atomic::AtomicBool;

use pounding_reference::{Fineness, Response, SecondRouteError};
use pounding_scene::Simulation;
use pounding_solver::OnRow;
use pounding_solver::{Excitation, Hysteretic, Row};

/// A run of a row by the second route.
struct SecondRoute<'a> {
    stop: &'a AtomicBool,
    excitation: Excitation<'a>,
    /// Length of the run \[s\].
    duration: f64,
    fineness: Fineness,
}

impl OnRow for SecondRoute<'_> {
    type Output = Result<Response, SecondRouteError>;

    fn on<Column: Hysteretic>(self, row: &Row<Column>) -> Self::Output {
        pounding_reference::run_until(row, self.excitation, self.duration, self.fineness, self.stop)
    }
}

/// Runs a scene by the second route; the method of the scene is ignored.
///
/// # Errors
/// [`SecondRouteError`] if the run ends early.
pub fn second_route(prepared: &Simulation, fineness: Fineness) -> Result<Response, SecondRouteError> {
    second_route_until(prepared, fineness, &AtomicBool::new(false))
}

/// [`second_route`] that ends with an error once `stop` is set.
///
/// # Errors
/// As [`second_route`].
pub(crate) fn second_route_until(prepared: &Simulation, fineness: Fineness, stop: &AtomicBool) -> Result<Response, SecondRouteError> {
    let clock = prepared.clock();
    prepared.on_row(SecondRoute {
        stop,
        excitation: prepared.excitation(),
        duration: clock.time(clock.n_steps),
        fineness,
    })
}
