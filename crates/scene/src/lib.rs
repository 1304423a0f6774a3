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
//! Left out: integration (`pounding-solver`), record formats (`pounding-motion`), many values of one field (`pounding-sweep`), pages and
//! figures (`pounding-report`).
//!
//! Where to start:
//!
//! - [`Scene`] and its fields: the words of a file. Its folder in the source is `file/`.
//! - [`Simulation`]: [`Simulation::new`], [`Simulation::run`] for numbers, [`Simulation::review`] for numbers with errors and warnings.
//! - [`Assessment`]: a row under many records; [`Effects`] and [`Separation`] are what pounding does and which gap avoids it.
//! - [`advise`]: a method and its step for an accuracy.

mod accuracy;
mod assess;
mod file;
mod ground_motion;
mod judge;
pub mod parallel;
mod quantity;
mod settings;
mod simulation;
mod spectrum;
mod statistics;
mod suite;

pub use accuracy::errors::{MEASURE, PairErrors, RunErrors, relative, relative_to};
pub use accuracy::ladder::{EVALUATIONS_PER_PIECE, Ladder, cost, entries, price};
pub use accuracy::methods::{COMPARED_METHODS, ComparedMethod, Knob, REFERENCE, RIVAL, StepMethod, is_compliant, label_of};
pub use accuracy::opening::Options;
pub use accuracy::price::{Going, LEDGER_OF_PIECE};
pub use accuracy::search::{LONGEST_STEP, MOST_STEPS, advise};
pub use assess::FloorPeaks;
pub use assess::alone::Alone;
pub use assess::assessment::{
    Assessment, BUILT_IN_STEPS_OF, FloorAssessment, GapAssessment, PairAssessment, RequiredGap, RuleAssessment, RunOfCase, StiffnessEffect,
    WORSE,
};
pub use assess::bumper::{Bumper, BumperPair, BumperRun, COMPRESSION, THICKNESS};
pub use assess::bumper_effect::{BumperEffect, FloorBumperEffect, PairBumperEffect};
pub use assess::design::{DesignSpectrum, Eurocode8Ground, acceleration_in_g};
pub use assess::distribution::Distribution;
pub use assess::effects::{Effect, Effects, FloorEffects, Known, NOTHING_TOUCHES, ROBUST};
pub use assess::run::{AssessedFloor, AssessedPair, AssessedRun, STIFFNESS_FACTORS, StiffnessFactors};
pub use assess::scaling::{MotionSpectrum, Scaling};
pub use assess::separation::{Rule, Separation};
pub use assess::target_fit::{LEAST_SHARE, TargetFit};
pub use file::error::{Error, ended};
pub use file::reading::{bytes, bytes_of, in_file, is_json, parse, read_file, record_bytes};
pub use file::schema::{scene_schema, schema_of};
pub use file::{
    BoucWen, Building, Columns, Contact, Damping, Detrend, DrawnNeighbour, FileUse, FilterBand, Generated, Ground, Jumps, Method,
    Neighbour, RecordUse, RunBudget, STANDARD_GRAVITY, ScaleTo, Scene, Sdof, SdofFile, SetNumber, Source, Start, Stochastic, Storey,
    Structure, Unit, UnknownNeighbour, direction, set_number,
};
pub use ground_motion::{GroundMotion, Origin, SharedMotion, hexadecimal, opened, sha256};
pub use judge::certificate::{Certificate, CertificateRequest};
pub use judge::certified::{CertificateFact, DeliveredBy, Said, usual_stiffness};
pub use judge::free_collision::{Delivered, FreeCollision, no_step};
pub use judge::implausible::{Implausible, USUAL_FACTORS};
pub use judge::limits::{ContactLimit, FreeLimit, Limits, STEPS_PER_CONTACT, STEPS_PER_PERIOD};
pub use judge::response::{Excess, ExcessKind, MOST_DRIFT, MOST_DUCTILITY, MOST_RESIDUAL, MOST_STABILITY};
pub use judge::review::{DOUBTFUL, Errors, Review};
pub use judge::warning::{Place, Warning};
pub use pounding_text::Refused;
pub use quantity::{AT_ONCE, About, FloorQuantity, LEAST_PART, PairQuantity, Quantity, QuantityKind, Values, ZERO};
pub use simulation::floors::{Floor, FloorPair, Floors, StoreyProperties, Unwatched};
pub use simulation::{
    Advice, Audited, Balance, Extras, Goal, PairOutcome, QuantityGroup, RunResult, Simulation, StepSizes, Trial, holding, in_scene,
    least_opening,
};
pub use spectrum::{SpectralValues, Spectrum, periods_between, response_spectra, response_spectrum, scaled_to_sa};
pub use statistics::wilson;
pub use suite::lines;
pub use suite::{LeftOut, Motion, Reason, ReasonKind, Suite, files_in};
