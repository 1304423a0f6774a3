//! Recorders: each keeps a single kind of result and sees only spans and impacts.

pub(crate) mod closings;
mod collisions;
mod drift_rates;
mod floor_accelerations;
mod histories;
mod last_states;
mod ledger;
mod link_peaks;
mod peaks;
pub(crate) mod recorder;
mod recorders;
mod transferred_momentum;

pub use closings::{BesideColumn, Closing, Closings, Widening};
pub use collisions::is_plastic;
pub use collisions::{Collision, Collisions};
pub use drift_rates::DriftRates;
pub use floor_accelerations::FloorAccelerations;
pub use histories::{Histories, History};
pub use last_states::LastStates;
pub use ledger::{Laws, Ledger, LedgerError, LinkTerms, PairTerms, Terms};
pub use link_peaks::{LinkPeak, LinkPeaks};
pub use peaks::{Leaning, Peak, Peaks, StructurePeaks};
pub use recorders::Recorders;
pub use transferred_momentum::TransferredMomentum;
