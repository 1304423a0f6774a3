//! The second route: computes the motion of a row of structures a second time, independently of the solver. It uses a Runge–Kutta method
//! whose steps end at events.
//!
//! We trust only the digits of a result on which two independent programs agree. This crate shares the model data ([`Row`], [`Excitation`])
//! and the parameters of contact laws and columns with the solver. It has its own code for forces, events, impacts and the recording of
//! results.
//!
//! ```
//! use pounding_contact::{ContactLaw, LinearSpring};
//! use pounding_reference::Fineness;
//! use pounding_solver::{Elastic, Excitation, Node, Pair, Row};
//! // A mass of 75 t stands on columns of 2.056 MN/m, 30 mm from a wall. The contact between them is a spring of 93.5 MN/m. The ground
//! // accelerates to the left with a constant 3 m/s².
//! let (mass, stiffness, spring, gap, jerk) = (75e3, 2.056e6, 93.5e6, 0.03, 3.0);
//! let law = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: spring });
//! let nodes = vec![Node::structure(mass, 0.0, Elastic { stiffness }), Node::wall(Elastic { stiffness })];
//! let row = Row::new(nodes, vec![Pair::of_floors(0, 1, gap, law)])?;
//! let run = pounding_reference::run(&row, Excitation::new(0.1, &[-jerk; 5])?, 0.2, Fineness::FINE)?;
//!
//! // At the peak force F the structure is at rest at u = gap + F/K, with the contact stiffness K. The work of the inertia force, m a u,
//! // then equals the stored energy ½ k u² + ½ F²/K.
//! let force = run.collisions[0][0].peak_force.expect("a compliant law has a force");
//! let u = gap + force / spring;
//! let stored = 0.5 * (stiffness * u * u + force * force / spring);
//! assert!((stored / (mass * jerk * u) - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The method is that of Dormand and Prince of order 8. It controls its error by the embedded method of order 5, also while no pair
//! touches. No step crosses a sample of the record or an event, such as a touch, yielding or a peak. Each event has a function that becomes
//! zero when it happens. A step that would cross an event is repeated with a length that ends there.
//!
//! From the touch of a pair until its largest deformation, the variable of integration is the fourth root of the time since the touch,
//! because a force may start like δ^(1/4). Once a pair is certain to part, the variable is √δ. In both variables the motion is analytic,
//! and the method keeps its order.
//!
//! - Floors of buildings are separate bodies: a storey acts on the floors above and below it. A floor may belong to any number of pairs,
//!   and a pair may touch a building between two floors.
//! - The deformation of a pair and its rate are unknowns of their own. Small bounces therefore stay accurate. The elastic part of the drift
//!   of Bouc–Wen columns is an unknown, too. For a travelling ground motion the record is integrated exactly to the velocities and
//!   displacements of the grounds.
//! - The force of a damper with a brace is an unknown. All other links have a force by their deformation, its rate and their branch.
//! - A floor that friction holds is a wall on its own ground. The friction follows from its balance, and lets go at its limit.
//! - When the bounces of a stereomechanical pair have ended, its floors stay in contact until their contact force falls to 0.
//!
//! This crate is not fast and has no recorders; `pounding-solver` is and does. Scenes are in `pounding-scene`. `second_route` in
//! `pounding-studies` compares the results of both programs.
//!
//! Where to start: [`run`], [`Fineness`] and [`Response`]; then `events.rs` with all events, and `law.rs` with the contact laws.

mod arrivals;
mod block;
mod bounces;
mod dormand_prince;
mod ends;
mod equations;
mod error;
mod events;
mod friction;
mod impact;
mod law;
mod link_motion;
mod links;
mod model;
mod phases;
mod plan;
mod record;
mod rest;
mod runner;
mod scales;
mod state;
mod storey;
mod variable;

use std::sync::atomic::AtomicBool;

use pounding_solver::{Excitation, Hysteretic, Row};

pub use error::SecondRouteError;
pub use record::{Collision, Peak, Response, StructureResponse};

use arrivals::Segments;
use model::Model;
use runner::Runner;

/// Accuracy of the second route.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// Largest error of the embedded method of order 5 in a step, 1e-14 ..= 1e-6.
    ///
    /// It is relative to the largest displacements, velocities and momenta so far. The step itself has order 8 and is far more accurate. A
    /// tolerance ten times smaller needs up to 50 % more steps.
    pub tolerance: f64,
    /// Fewest steps between two samples of the record, ≥ 1.
    ///
    /// An event is detected if its function has changed sign at the end of a step. Sign changes of velocities are also checked in the
    /// middle of a step. A touch that lasts for a small part of a step can be missed.
    pub steps_per_sample: u32,
    /// Bounces that would end within this time are over \[s\], 1e-14 ..= 1e-9. A cascade of bounces of several pairs has an impulse that is
    /// uncertain by about the pressing force over this time.
    pub shortest: f64,
}

impl Fineness {
    /// With this setting only rounding limits the accuracy. In the scenes of Tables 6 and 7 of the paper, finer settings change the
    /// transferred momenta by less than 3e-14 of their value.
    pub const FINE: Self = Self {
        tolerance: 1e-13,
        steps_per_sample: 4,
        shortest: impact::SHORTEST,
    };

    fn check(self) -> Result<(), SecondRouteError> {
        let refused = |setting, found, allowed| Err(SecondRouteError::Setting { setting, found, allowed });
        if !(1e-14..=1e-6).contains(&self.tolerance) {
            return refused("tolerance", self.tolerance, "1e-14 to 1e-6");
        }
        if !(1e-14..=1e-9).contains(&self.shortest) {
            return refused("shortest", self.shortest, "1e-14 to 1e-9 s");
        }
        if self.steps_per_sample == 0 {
            return refused("steps_per_sample", 0.0, "a whole number >= 1");
        }
        Ok(())
    }
}

/// Runs a row from t = 0 for `duration` \[s\] and reports its collisions and peaks.
///
/// The ground acceleration is linear between samples and zero after the last one. The first sample reaches a structure at its arrival time,
/// by default at t = 0.
///
/// # Errors
/// Returns [`SecondRouteError`] if a setting is out of range, the motion is no longer finite, no step meets the tolerance, a segment has
/// too many events, too many impulsive pairs touch at once, or a link is a viscous damper without a brace.
pub fn run<Column: Hysteretic>(
    row: &Row<Column>,
    excitation: Excitation<'_>,
    duration: f64,
    fineness: Fineness,
) -> Result<Response, SecondRouteError> {
    run_until(row, excitation, duration, fineness, &AtomicBool::new(false))
}

/// [`run`] that ends with [`SecondRouteError::Stopped`] once `stop` is set.
///
/// # Errors
/// As [`run`].
pub fn run_until<Column: Hysteretic>(
    row: &Row<Column>,
    excitation: Excitation<'_>,
    duration: f64,
    fineness: Fineness,
    stop: &AtomicBool,
) -> Result<Response, SecondRouteError> {
    fineness.check()?;
    if !(duration.is_finite() && duration > 0.0) {
        return Err(SecondRouteError::Setting {
            setting: "duration",
            found: duration,
            allowed: "a finite number > 0",
        });
    }
    let interval = excitation.time_step();
    let model = Model::new(row)?;
    let arrivals: Vec<_> = model.structures.iter().map(|one| one.arrival).collect();
    let mut runner = Runner::new(model, fineness, interval);
    for segment in Segments::new(excitation, arrivals, duration) {
        runner.segment(segment, stop)?;
    }
    Ok(runner.finish(duration))
}
