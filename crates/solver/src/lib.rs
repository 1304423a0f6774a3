//! Time integration of rows of adjacent structures that may collide.
//!
//! An [`Integrator`] integrates a [`Row`] (the model: structures of one storey, or buildings of several) under an [`Excitation`] on a
//! [`Clock`]. A [`Recorder`] receives the motion as [`Span`]s and [`Impact`]s and keeps the results for which it is made. [`Work`] counts
//! the cost of the run.
//!
//! ```
//! use pounding_contact::{ContactLaw, Stereomechanical};
//! use pounding_solver::{Clock, Collisions, Elastic, Exact, Excitation, Integrator, Node, Pair, Row};
//!
//! // 75 t on 2.056 MN/m stand 30 mm from a wall. The ground jerks to the left with 3 m/s², so that they lean to the right.
//! let (mass, stiffness, gap, jerk) = (75e3, 2.056e6, 0.03, 3.0);
//! let law = ContactLaw::Stereomechanical(Stereomechanical { restitution: 0.65 });
//! let nodes = vec![Node::structure(mass, 0.0, Elastic { stiffness }), Node::wall(Elastic { stiffness })];
//! let row = Row::new(nodes, vec![Pair::of_floors(0, 1, gap, law)])?;
//! let (ground, clock) = ([-jerk; 5], Clock { time_step: 0.2, n_steps: 1 });
//! let mut collisions = Collisions::new(row.nodes().len(), row.pairs());
//! Integrator::Exact(Exact::default()).run(&row, Excitation::new(0.1, &ground)?, clock, &mut collisions)?;
//!
//! // Undamped, from rest: u̇² = 2 a u − (k/m) u². At the gap that is (0.3941 m/s)²; the impulse is (1+e) m u̇ = 48 772 N·s.
//! let speed = (2.0 * jerk * gap - stiffness / mass * gap * gap).sqrt();
//! assert!((collisions.all()[0].impulse / (1.65 * mass * speed) - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Signs: displacements are relative to the ground and positive to the right; structures are numbered from left to right; the load on a
//! structure is p = −m·`a_g`. Units are SI. A step uses only + − × ÷ √, so that every machine gives the same bits.
//!
//! Not in this crate: files, printing and the choice of a method (`pounding-scene`), units other than SI, contact search (the caller names
//! the pairs that can touch).
//!
//! Where to start:
//!
//! - [`Node`], [`Pair`] and [`Row`]: the model. [`Levels`] numbers the floors of buildings of several storeys, and
//!   [`Point::between`] is a point of columns between two of them.
//! - [`Integrator`]: the methods. Read `explicit/verlet.rs` beside `explicit/rk4.rs`, then `exact/mod.rs`.
//! - [`Recorder`]: [`Peaks`], [`Collisions`], [`Histories`] and [`Ledger`] are recorders; a tuple of recorders is a recorder.

mod any_row;
mod budget;
mod error;
mod exact;
mod explicit;
mod impact;
mod implicit;
mod integrator;
mod link_forces;
mod march;
mod model;
mod pushes;
mod quadrature;
mod record;
mod roots;
mod span;
mod stability;
mod sum;
mod turning;

/// Parts of steps and events, for crates that compute with other number types, such as lanes of many scenes.
///
/// Each item is generic over [`Number`](pounding_contact::Number), or computes data that all scenes share.
pub mod formulas {
    pub use crate::error::require;
    pub use crate::exact::{BURST, CHATTER, LONGEST_LEAP, ROUNDING_OF_COEFFICIENTS, bounces_are_over, in_flight};
    pub use crate::explicit::central_difference::building::{FloorCoefficients, Floors, solve};
    pub use crate::explicit::central_difference::coefficients::Coefficients;
    pub use crate::explicit::central_difference::{first_increment, increment_before};
    pub use crate::impact::any_rounds::{Closed, Jumps};
    pub use crate::impact::chain::Link;
    pub use crate::impact::rounds::{ROUNDING, Rounds, Touching};
    pub use crate::model::balance::{Below, Dashpot, damping_force};
    pub use crate::model::buildings::Buildings;
    pub use crate::model::column::returned;
    pub use crate::model::dashpots::DampingRates;
    pub use crate::record::closings::cubic::{Cubic, Node as CubicNode, controls};
    pub use crate::record::is_plastic;
    pub use crate::roots::{CAPACITY, quick_first_root, shift, value_and_slope};
    pub use crate::span::{Expansion, value};
}

pub use any_row::{AnyRow, OnRow};
pub use budget::{Budget, Clock, Course, Work};
pub use error::{ModelError, PointFault, RunError};
pub use exact::{Exact, SimultaneousImpacts};
pub use explicit::central_difference::CentralDifference;
pub use explicit::rk4::Rk4;
pub use explicit::verlet::{Verlet, VerletImpacts};
pub use implicit::hht::Hht;
pub use implicit::moreau_jean::MoreauJean;
pub use implicit::newmark::Newmark;
pub use integrator::Integrator;
pub use model::bilinear::Bilinear;
pub use model::bouc_wen::{Bent, BoucWen};
pub use model::column::{Elastic, Hysteresis, Hysteretic, Knee, Response, RestoringForce, Smoothness};
pub use model::damping::Damping;
pub use model::excitation::Excitation;
pub use model::levels::{Levels, Storey};
pub use model::link::{Braced, Link, LinkFault, LinkLaw, Restrainer, Spring, Viscous};
pub use model::mixed::Mixed;
pub use model::modes::{Mode, Oscillation, modes};
pub use model::node::{Floor, Node, Support};
pub use model::relation::{Pair, Point, Relation, Share};
pub use model::row::Row;
pub use model::sliding::Sliding;
pub use model::travel::{Opening, Travel};
pub use record::recorder::{Impact, Recorder, Struck, Touch, Velocities};
pub use record::{
    BesideColumn, Closing, Closings, Collision, Collisions, DriftRates, FloorAccelerations, Histories, History, LastStates, Laws, Leaning,
    Ledger, LedgerError, LinkPeak, LinkPeaks, LinkTerms, PairTerms, Peak, Peaks, Recorders, StructurePeaks, Terms, TransferredMomentum,
    Widening,
};
pub use span::{Flight, Motion, Path, Push, Series, Span, State, Weighed};
