//! Ground motion records: read, processed, measured, generated.
//!
//! Text goes in and numbers come out: [`read`] turns the bytes of a file into an [`Accelerogram`],
//! which becomes a [`Record`] \[m/s²\] once the caller says what one g is worth.
//!
//! ```
//! let text = "# Somewhere, north-south\ntime_s,acceleration_g\n0.00,0.0\n0.02,-0.2\n";
//! let record = pounding_motion::read(text.as_bytes())?.into_record(9.81)?;
//!
//! // Linear between samples: half of −0.2 g = −1.962 m/s² after half of the step.
//! assert!((record.at(0.01) + 0.981).abs() < 1e-12);
//!
//! // From rest the ground reaches ½ · 1.962 m/s² · 0.02 s = 0.01962 m/s.
//! assert!((record.measures().pgv - 0.01962).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A file may leave its unit, its time step or the choice of a component to the caller, who passes them to [`read_declared`]. Nothing is
//! guessed: [`Accelerogram::readings`] lists each value with the line that it comes from.
//!
//! Motions without a file are [`Harmonic`], [`RickerPulse`], [`HalfSinePulse`] and [`StochasticMotion`].
//!
//! This crate leaves out opening files, folders of records and response spectra (`pounding-scene`), and baseline correction beyond
//! [`Record::detrended`]. A velocity or displacement history is refused, not differentiated.
//!
//! Where to start:
//!
//! - [`Record`]: a motion in m/s²; its methods scale, resample, filter, integrate and measure it.
//! - [`read`], [`Format`] and [`Declared`]: formats of files, and information from the caller.
//! - [`contents`] and [`NamedFile`]: components of a file, places of sensors, and files that belong to a common record.
//! - [`Bearing`] and [`Accelerogram::rotated`]: two horizontal components, and the motion along an axis.
//! - A format is a file in `src/format`; `src/format.rs` lists all.

mod accelerogram;
mod band_limited;
mod band_pass;
mod baseline;
mod bearing;
mod butterworth;
mod contents;
mod declared;
mod detrend;
mod direction;
mod envelope;
mod format;
mod fourier;
mod ground;
mod harmonic;
mod integration;
mod layout;
mod line;
mod mean_period;
mod measures;
mod named_file;
mod pulses;
mod reading;
mod record;
mod refusals;
mod shape;
mod site;
mod stochastic;
mod unit;
mod unusual;

pub use accelerogram::Accelerogram;
pub use band_pass::{BandPass, Passes};
pub use baseline::Drift;
pub use bearing::Bearing;
pub use contents::{Channel, Contents, Identity};
pub use declared::Declared;
pub use detrend::Trend;
pub use direction::Direction;
pub use envelope::Envelope;
pub use format::{components, contents, read, read_declared, recognised};
pub use ground::GroundFilter;
pub use harmonic::Harmonic;
pub use integration::Integrated;
pub use layout::Format;
pub use measures::{Interval, Measures};
pub use named_file::NamedFile;
pub use named_file::Quantity;
pub use pounding_text::Refused;
pub use pulses::{HalfSinePulse, RickerPulse};
pub use reading::{FilePlace, Reading};
pub use record::{Record, at_rest};
pub use site::Site;
pub use stochastic::StochasticMotion;
pub use unit::AccelerationUnit;
pub use unusual::Unusual;
