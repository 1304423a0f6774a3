//! Random plausible scenes by the exact method and by the second route: do they agree, and does every run end?
//!
//! A [`Campaign`] makes scenes from a seed: rows of one to five buildings of one to twelve storeys, all columns, all contact laws, walls,
//! arrivals, gaps from 0, restitutions from 0 to 1, records, random shaking and pulses. Each is run by both routes, and every
//! peak, momentum, last displacement and touch of theirs compared. They may differ by 1e-12, or by 1e-15 times the condition number of
//! the result, as in the trade of error against work; instants by as many seconds. The exact run's ledger may leave 1e-11.

mod campaign;
mod check;
mod class;
mod compared;
mod condition;
mod contacts;
mod generator;
mod meeting;
mod numbers;
mod random;
mod table;
mod written;

pub use campaign::Campaign;
pub use check::{Checked, Disagreement, Failure, RESIDUAL, Verdict};
pub use class::Class;
pub use compared::{ALLOWED, Compared, Place, Stage, Two};
pub use table::{KnownLimit, LIMITS, Summary};
