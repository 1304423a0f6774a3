//! Random plausible scenes by the exact method and by the second route, to test whether they agree and every run ends.
//!
//! A [`Campaign`] makes scenes from a seed. A row has one to five buildings of one to twelve storeys. Columns, contact laws, walls,
//! arrivals, gaps from 0 and restitutions from 0 to 1 vary, and links between floors. The ground motion is a record, random shaking or a
//! pulse. Each scene runs by both routes; every peak, momentum, last displacement and touch is compared. The numbers may differ by 1e-12, or
//! by 1e-15 times their condition number as in the trade of error against work; instants by as many seconds. The ledger of the exact run may
//! leave a residual of 1e-11.

mod campaign;
mod check;
mod class;
mod compared;
mod condition;
mod contacts;
mod generator;
mod links;
mod numbers;
mod random;
mod table;
mod touch;
mod written;

pub use campaign::Campaign;
pub use check::{Checked, Disagreement, Failure, RESIDUAL, Verdict};
pub use class::Class;
pub use compared::{ALLOWED, Compared, NumberPlace, Stage, Two};
pub use table::{KnownLimit, LIMITS, Summary};
