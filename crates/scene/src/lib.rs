//! Scenes of structural pounding: what a user writes, read, checked, run and judged.
//!
//! A [`Scene`] is one row of structures under one record. [`Simulation`] is a checked scene, ready to run.
//!
//! Left out: integration (`pounding-solver`), record formats (`pounding-motion`).

mod accuracy;
mod assess;
mod file;
mod ground_motion;
mod judge;
mod quantity;
mod simulation;
mod spectrum;
mod suite;

pub use accuracy::errors::{
    AT_ONCE, LEAST_PART, MEASURE, PairErrors, RunErrors, ZERO, relative, relative_to,
};
pub use accuracy::ladder::{EVALUATIONS_PER_PIECE, Ladder, cost, entries, price};
pub use accuracy::methods::{
    COMPARED_METHODS, ComparedMethod, Knob, REFERENCE, RIVAL, StepMethod, is_compliant, label_of,
};
pub use accuracy::opening::Options;
pub use accuracy::search::{LONGEST_STEP, MOST_STEPS, advise};
pub use assess::FloorPeaks;
pub use assess::assessment::{
    Assessment, BUILT_IN_STEPS_OF, FloorAssessment, GapAssessment, PairAssessment, RuleAssessment,
    WORSE,
};
pub use assess::design::{DesignSpectrum, DesignSpectrumError, Eurocode8Ground};
pub use assess::distribution::Distribution;
pub use assess::effects::{Effect, Effects, FloorEffects, Known, NOTHING_TOUCHES, ROBUST};
pub use assess::run::{
    AssessedFloor, AssessedPair, AssessedRun, STIFFNESS_FACTORS, StiffnessFactors,
};
pub use assess::scaling::Scaling;
pub use assess::separation::{Rule, Separation};
pub use file::error::{Error, Vertical};
pub use file::fault::Fault;
pub use file::motion_error::MotionError;
pub use file::reading::{bytes, is_json, parse, position_in, read_file};
pub use file::scene_error::SceneError;
pub use file::schema::{scene_schema, schema_of};
pub use file::{
    BoucWen, Building, Columns, Contact, Damping, Detrend, FileUse, FilterBand, Generated, Ground,
    Jumps, Method, RecordUse, RunBudget, STANDARD_GRAVITY, ScaleTo, Scene, Sdof, SdofFile,
    SdofFileError, SetNumber, Source, Start, Stochastic, Storey, Structure, Unit, set_number,
};
pub use ground_motion::{GroundMotion, Origin, SharedMotion, hexadecimal, sha256};
pub use judge::certificate::{Certificate, CertificateError, CertificateRequest};
pub use judge::free_collision::{CollisionError, Delivered, FreeCollision};
pub use judge::implausible::{Implausible, USUAL_FACTORS};
pub use judge::limits::{ContactLimit, FreeLimit, Limits, STEPS_PER_CONTACT, STEPS_PER_PERIOD};
pub use judge::response::{
    Excess, ExcessKind, MOST_DRIFT, MOST_DUCTILITY, MOST_RESIDUAL, MOST_STABILITY,
};
pub use judge::review::{DOUBTFUL, Errors, Review};
pub use judge::warning::{Place, Warning};
pub use quantity::{FloorQuantity, PairQuantity, Quantity, QuantityGroup};
pub use simulation::floors::{Floor, FloorPair, Floors, StoreyProperties};
pub use simulation::{
    Advice, AllRecorders, Audited, Balance, Extras, Goal, OnRow, PairOutcome, Recorders, RunResult,
    Simulation, StepSizes, Trial, Values, holding, in_scene, side_by_side,
};
pub use spectrum::{
    SpectralValues, Spectrum, SpectrumError, periods_between, response_spectrum,
    response_spectrum_watched, scaled_to_sa,
};
pub use suite::{Motion, Orientation, files_in};
