//! Ground motion records: read, resample, scale, reverse.
//!
//! Text goes in and numbers come out: [`read`] turns the bytes of a file into an [`Accelerogram`],
//! which becomes a [`Record`] \[m/s²\] once the caller says what one g is worth.
//!
//! ```
//! let text = "# Somewhere, north-south\ntime_s,acceleration_g\n0.00,0.0\n0.02,-0.2\n";
//! let record = pounding_motion::read(text.as_bytes())?.into_record(9.81)?;
//! assert!((record.at(0.01) + 0.981).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Left out on purpose: opening files, baseline correction, filtering, and every format but
//! two-column CSV and PEER AT2. A velocity or displacement history is refused, not differentiated.

mod accelerogram;
mod at2;
mod error;
mod format;
mod line;
mod record;
mod two_column;

pub use accelerogram::{AccelerationUnit, Accelerogram};
pub use at2::read_at2;
pub use error::{ReadError, RecordError};
pub use format::read;
pub use record::Record;
pub use two_column::read_csv;
