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

mod budget;
mod clock;
mod ensemble;
mod error;
mod exact;
mod explicit;
mod impact;
mod implicit;
mod integrator;
mod model;
mod quadrature;
mod record;
mod span;
mod stability;
mod turning;
mod work;

pub use budget::{Budget, Course};
pub use clock::Clock;
pub use ensemble::{ExactSideBySide, PairSums, RowsOf, SceneSums, SideBySide, Stepping};
pub use error::{ModelError, RunError};
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
pub use model::column::{
    Elastic, ElastoPlastic, Hysteresis, Hysteretic, Knee, Response, RestoringForce, Smoothness,
};
pub use model::damping::Damping;
pub use model::excitation::Excitation;
pub use model::levels::{Levels, Storey};
pub use model::modes::{Mode, modes};
pub use model::node::{Node, Pair};
pub use model::oscillation::Oscillation;
pub use model::row::Row;
pub use model::support::{Floor, Support};
pub use model::travel::{Opening, Travel};
pub use record::recorder::{Impact, Recorder, Touch, Velocities};
pub use record::{
    Closing, Closings, Collision, Collisions, FloorAccelerations, Histories, History,
    LastDisplacements, Laws, Ledger, LedgerError, PairTerms, Peak, Peaks, StructurePeaks, Terms,
    TransferredMomentum,
};
pub use span::{Flight, Motion, Path, Series, Span, State, Weighed};
pub use work::Work;
