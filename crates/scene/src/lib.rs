//! Scenes of structural pounding: what a user writes, read, checked, run and judged.
//!
//! A [`Scene`] is one row of structures under one record, from a TOML or JSON file. [`Simulation`] is a checked scene, ready to run.
//!
//! ```
//! use pounding_scene::{Scene, Simulation};
//!
//! let text = r#"
//!     name = "a tower beside a wall, shaken by half a sine of half the tower's period"
//!     record.generated.half_sine = { amplitude_m_per_s2 = -4.0, duration_s = 0.5, time_step_s = 0.001 }
//!     structures = [{ sdof = { name = "tower", mass_kg = 1e5, period_s = 1.0, damping.ratio = 0 } }, { wall = {} }]
//!     contacts = [{ gap_m = 0.05066059, law.stereomechanical.restitution = 0.65 }]
//! "#;
//! let scene = Scene::parse(text.as_bytes(), "tower.toml".as_ref())?;
//! let run = Simulation::new(&scene, "")?.run(None)?;
//!
//! // u = A/(2ω²) (sin ωt − ωt cos ωt). At T/4 it is A/(2ω²), this gap, and u̇ = A T/8 = 0.5 m/s: (1+e) m u̇ = 82.5 kN·s.
//! let first = run.of_pair(0).first.expect("the gap closes");
//! assert!((first.start - 0.25).abs() < 1e-5);
//! assert!((first.impulse / 82.5e3 - 1.0).abs() < 1e-5);
//! # Ok::<(), pounding_scene::Error>(())
//! ```
//!
//! Errors name the place, what was found, what is allowed and what to change. A warning names the numbers of a run that it concerns.
//!
//! Left out: integration (`pounding-solver`), record formats (`pounding-motion`), many records (`pounding-assess`), many values of one
//! field (`pounding-sweep`), pages and figures (`pounding-report`).
//!
//! Where to start:
//!
//! - [`Scene`] and its fields: the words of a file. [`file`](mod@file) has all of them, and reads other files of this form.
//! - [`Simulation`]: [`Simulation::new`], [`Simulation::run`] for numbers, [`Simulation::review`] for numbers with errors and warnings.
//! - [`Advice::of`]: a method and its step for an accuracy.
//! - [`parallel`]: work on many scenes by all threads.

mod accuracy;
mod ductility_spectrum;
pub mod file;
mod ground_motion;
mod judge;
mod outline;
mod pair_spectrum;
pub mod parallel;
mod quantity;
mod row_words;
mod settings;
mod simulation;
mod spectrum;

pub use accuracy::errors::{PairErrors, RunErrors};
pub use accuracy::ladder::Ladder;
pub use accuracy::methods::{ComparedMethod, MethodSetting, StepMethod};
pub use accuracy::opening::SimulationOptions;
pub use accuracy::price::RunMode;
pub use ductility_spectrum::{DuctilitySpectrum, DuctilityValues, ductility_spectra};
pub use file::error::Error;
pub use file::{
    Building, Capacities, ColumnShape, Columns, Contact, DampedStiffness, Damping, FileUse, FloorHeights, Generated, Link, Method, PDelta,
    Property, RecordUse, STANDARD_GRAVITY, Scene, Sdof, Source, Standing, Storey, Structure,
};
pub use ground_motion::PairAngles;
pub use ground_motion::{GroundMotion, Origin, SharedMotion, hexadecimal, sha256};
pub use judge::between_samples::BetweenSamples;
pub use judge::certificate::{Certificate, CertificateRequest};
pub use judge::certified::{CertificateFact, CertificateValue, DeliveredBy, DeliveredNumber};
pub use judge::excess_kind::ExcessKind;
pub use judge::free_collision::{DeliveredRestitution, FreeCollision};
pub use judge::implausible::Implausible;
pub use judge::limits::{ContactLimit, FreeLimit, MethodLimits};
pub use judge::response::{Excess, Often};
pub use judge::review::{Errors, Review};
pub use judge::warning::{Warning, WarningPlace};
pub use pair_spectrum::{PairSpectrum, PairValues, pair_spectra};
pub use pounding_text::Refused;
pub use quantity::{FloorQuantity, LinkQuantity, PairQuantity, Quantity, QuantityEntry, QuantityKind, RunValues};
pub use row_words::RowWords;
pub use simulation::dampers::MassDamping;
pub use simulation::floors::{ColumnBeside, Floor, FloorPair, Floors, StoreyProperties, UnwatchedFloor};
pub use simulation::{
    Advice, AuditedRun, Collapse, EnergyBalance, Extras, Goal, MethodTrial, PairOutcome, QuantityGroup, RunResult, Simulation, StepSizes,
};
pub use spectrum::{SpectralValues, Spectrum, SpectrumIntensities, periods_between, response_spectra, response_spectrum, scaled_to_sa};
