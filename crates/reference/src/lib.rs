//! A second route to the motion of a row: event-located Runge–Kutta, independent of every integrator of the solver.
//!
//! A reference is trusted to the digits on which two independent routes agree. This route shares the model data ([`Row`], [`Excitation`])
//! and the parameters of contact laws and columns with the solver. Forces, events, impacts and records are implemented again from their
//! formulas.
//!
//! ```
//! use pounding_contact::{ContactLaw, LinearSpring};
//! use pounding_reference::Fineness;
//! use pounding_solver::{Elastic, Excitation, Node, Pair, Row};
//! // 75 t on 2.056 MN/m, 30 mm from a wall that they press with a spring of 93.5 MN/m. The ground jerks to the left with 3 m/s².
//! let (mass, stiffness, spring, gap, jerk) = (75e3, 2.056e6, 93.5e6, 0.03, 3.0);
//! let law = ContactLaw::LinearSpring(LinearSpring { impact_stiffness: spring });
//! let nodes = vec![Node::structure(mass, 0.0, Elastic { stiffness }), Node::wall(Elastic { stiffness })];
//! let row = Row::new(nodes, vec![Pair::of_floors(0, 1, gap, law)])?;
//! let run = pounding_reference::run(&row, Excitation::new(0.1, &[-jerk; 5])?, 0.2, Fineness::FINE)?;
//!
//! // At the peak F the structure stands still at u = gap + F/K: the ground's work m a u is ½ k u² + ½ F²/K.
//! let force = run.collisions[0][0].peak_force.expect("a compliant law has a force");
//! let u = gap + force / spring;
//! let stored = 0.5 * (stiffness * u * u + force * force / spring);
//! assert!((stored / (mass * jerk * u) - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The method is Dormand–Prince of order 8(5,3) with error control, including free flight. No step crosses a sample of the record or an
//! event, such as a touch, yielding or a peak. A step that would cross an event is repeated with the length at which the event's function
//! vanishes. Near the first touch, where a force may start like δ^(1/4), the variable is the fourth root of the time since the touch. On
//! the way to parting it is √δ. In both variables the motion is analytic, and the method keeps its order.
//!
//! - Floors of buildings are separate bodies: a storey acts on the floors above and below it. A floor may meet any number of pairs, and a
//!   pair may meet points between floors.
//! - The deformation of a pair and its rate are unknowns, so that small bounces keep their digits. The elastic part of the drift of
//!   Bouc–Wen columns is an unknown, too. A travelling ground motion needs no double integral of the record.
//! - Stereomechanical pairs whose bounces are over rest against each other until their force fades.
//!
//! Not in this crate: recorders and speed (`pounding-solver`); scenes, and the comparison of both routes (`second_route` in
//! `pounding-studies`).
//!
//! Where to start: [`run`], [`Fineness`] and [`Response`]; then `events.rs` with all events, and `law.rs` with the contact laws.

mod arrivals;
mod block;
mod bounces;
mod dormand_prince;
mod equations;
mod error;
mod events;
mod impact;
mod law;
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
    /// It is relative to the largest displacements, velocities and momenta so far. The step itself is of order 8 and far more accurate. A
    /// factor of ten increases the number of steps by up to a half.
    pub tolerance: f64,
    /// Fewest steps between two samples of the record, ≥ 1.
    ///
    /// Zeros of functions are detected at the ends of a step, and those of velocities also in its middle. A touch that lasts for a small
    /// part of a step can be missed.
    pub steps_per_sample: u32,
}

impl Fineness {
    /// Accuracy limited by rounding: in the scenes of the paper, finer settings change totals by less than 3e-14.
    pub const FINE: Self = Self {
        tolerance: 1e-13,
        steps_per_sample: 4,
    };

    fn check(self) -> Result<(), SecondRouteError> {
        let refused = |setting, found, allowed| Err(SecondRouteError::Setting { setting, found, allowed });
        if !(1e-14..=1e-6).contains(&self.tolerance) {
            return refused("tolerance", self.tolerance, "1e-14 to 1e-6");
        }
        if self.steps_per_sample == 0 {
            return refused("steps_per_sample", 0.0, "a whole number >= 1");
        }
        Ok(())
    }
}

/// Runs a row from t = 0 for `duration` \[s\] and reports its collisions and peaks.
///
/// The ground acceleration is linear between samples and zero after the last sample; the first sample is at t = 0.
///
/// # Errors
/// [`SecondRouteError`] if a setting is out of range, the motion is no longer finite, a tolerance cannot be met, or events do not end.
pub fn run<Column: Hysteretic>(
    row: &Row<Column>,
    excitation: Excitation<'_>,
    duration: f64,
    fineness: Fineness,
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
    let model = Model::new(row);
    let arrivals: Vec<_> = model.structures.iter().map(|one| one.arrival).collect();
    let mut runner = Runner::new(model, fineness, interval);
    for segment in Segments::new(excitation, arrivals, duration) {
        runner.segment(segment)?;
    }
    Ok(runner.finish(duration))
}
