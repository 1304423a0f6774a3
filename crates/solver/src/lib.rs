//! Time integration of rows of adjacent structures that may collide.
//!
//! A [`Row`] (the model: structures of one storey, or buildings of several) is integrated under an [`Excitation`] on a [`Clock`] by an [`Integrator`]; a [`Recorder`]
//! sees the motion as [`Span`]s and [`Impact`]s and keeps what it was made for; [`Work`] counts what the run cost.
//!
//! ```
//! use pounding_solver::{
//!     CentralDifference, Clock, Elastic, Excitation, Integrator, Node, Peaks, Row,
//! };
//!
//! let row = Row::new(vec![Node::structure(75e3, 23e3, Elastic { stiffness: 2.056e6 })], vec![])?;
//! let ground = [0.0, 1.0, -1.0, 0.0];
//! let excitation = Excitation::new(0.1, &ground)?;
//! let method = Integrator::CentralDifference(CentralDifference::default());
//! let mut peaks = Peaks::new(row.nodes().len());
//! method.run(&row, excitation, Clock { time_step: 0.01, n_steps: 100 }, &mut peaks)?;
//! assert!(peaks.of(0).displacement.value.abs() > 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Signs: displacements are relative to the ground and positive to the right; structures stand left to right; the
//! load on a structure is p = −m·`a_g`. Units are SI. In a step only + − × ÷ √ are used, so that every machine gives
//! the same bits.
//!
//! Left out: files, printing, units other than SI, contact search (neighbours are known).

mod approach;
mod bilinear;
mod bouc_wen;
mod budget;
mod buildings;
mod central_difference;
mod clock;
mod cluster;
mod clusters;
mod column;
mod complementarity;
mod critical;
mod damping;
mod dashpots;
mod equilibrium;
mod error;
mod exact;
mod excitation;
mod ground;
mod hht;
mod impacts;
mod integrator;
mod joint;
mod lanes;
mod levels;
mod modes;
mod moreau_jean;
mod newmark;
mod newton;
mod profile;
mod quadrature;
mod recorder;
mod recorders;
mod rk4;
mod rounds;
mod row;
mod span;
mod support;
mod together;
mod travel;
mod trial;
mod turning;
mod verlet;
mod work;

pub use bilinear::Bilinear;
pub use bouc_wen::{Bent, BoucWen};
pub use budget::{Budget, Course};
pub use central_difference::CentralDifference;
pub use clock::Clock;
pub use column::{
    Elastic, ElastoPlastic, Hysteresis, Hysteretic, Knee, Response, RestoringForce, Smoothness,
};
pub use critical::Oscillation;
pub use damping::Damping;
pub use error::{ModelError, RunError};
pub use exact::{Exact, SimultaneousImpacts};
pub use excitation::Excitation;
pub use hht::Hht;
pub use integrator::Integrator;
pub use lanes::{ExactSideBySide, PairTally, RowsOf, SideBySide, Stepping, Tallies};
pub use levels::{Levels, Storey};
pub use modes::{Mode, modes};
pub use moreau_jean::MoreauJean;
pub use newmark::Newmark;
pub use recorder::{Impact, Recorder, Touch, Velocities};
pub use recorders::{
    Closing, Closings, Collision, Collisions, FloorAccelerations, Histories, History,
    LastDisplacements, Laws, Ledger, LedgerError, PairTerms, Peak, Peaks, StructurePeaks, Terms,
    TransferredMomentum,
};
pub use rk4::Rk4;
pub use row::{Node, Pair, Row};
pub use span::{Flight, Motion, Path, Series, Span, State, Weighed};
pub use support::{Floor, Support};
pub use travel::{Opening, Travel};
pub use verlet::{Verlet, VerletImpacts};
pub use work::Work;
