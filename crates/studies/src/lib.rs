//! Scenes and studies of structural pounding: what a user writes, what the paper printed, and what comes out.
//!
//! A [`Scene`] is one row of structures under one record. A [`Study`] is scenes and what to print of them; the
//! studies of the paper are data files, one per table and figure. [`Studies::reproduce`] turns a folder of them into tables,
//! figures, the agreement with the published numbers and the verdicts on the paper's claims.
//!
//! Left out: integration (`pounding-solver`), record formats (`pounding-motion`).

mod advice;
mod agreement;
mod beyond;
mod cell;
mod certificate;
mod check;
mod claims;
mod comparison;
mod completed;
mod contenders;
mod converged;
mod doubt;
mod effects;
mod error;
mod examples;
mod extremes;
mod fault;
mod figures;
mod file;
mod floor_cost;
mod floors;
mod free_collision;
mod ground_motion;
mod ladder;
mod laws;
mod limits;
mod motion_error;
mod noise;
mod paper;
mod plot;
mod position;
mod prepared;
mod price;
mod printed;
mod processed;
mod report;
mod reproduce;
mod review;
mod savings;
mod scene;
mod scene_error;
mod schema;
pub mod second_route;
mod separation;
mod spectrum;
mod study;
mod suite;
mod surveys;
mod sweep;
mod tables;
mod trade;
mod unneeded;
pub mod verify;
mod warning;
mod work_precision;

pub use advice::{Advice, Goal, LONGEST_STEP, MOST_STEPS, Rungs, Trial, advise};
pub use agreement::{
    CLOSE, Comparison, Published, PublishedValues, REPRODUCED, Reason, Verdict, agreement_csv,
};
pub use beyond::{Beyond, BeyondSettings, BeyondStudy, Change, Counted, ListedMotion, Strength};
pub use cell::{Cell, csv_text, json_text};
pub use certificate::{Certificate, CertificateError, Wanted};
pub use claims::{Claim, Finding, Survival, Tallies, Tally, claims, claims_csv};
pub use comparison::{
    LEAST_PART, MEASURE, Number, PairErrors, Quantity, RunErrors, StructureErrors,
};
pub use completed::Completed;
pub use contenders::StepMethod;
pub use doubt::Doubt;
pub use effects::{Effect, Effects, FloorEffects, Known, NOTHING_TOUCHES, ROBUST};
pub use error::StudyError;
pub use examples::Examples;
pub use extremes::{Axis, Edges, Extent, Extremes, Line, Map, Values};
pub use fault::Fault;
pub use figures::figure_png;
pub use file::is_json;
pub use floor_cost::{Condition, FloorCost, RowSize, TimedRow, floor_cost_figure};
pub use floors::{Facing, Floor, Floors, Made};
pub use free_collision::{CollisionError, Delivered, FreeCollision};
pub use ground_motion::{GroundMotion, Origin};
pub use ladder::{EVALUATIONS_PER_PIECE, Ladder};
pub use laws::{Atlas, AtlasSettings};
pub use limits::{ContactLimit, FreeLimit, Limits, STEPS_PER_CONTACT};
pub use motion_error::MotionError;
pub use paper::PapersProgram;
pub use plot::PlotError;
pub use pounding_text::{digits, milliseconds, percent, plain, rounded_down, rounded_up, short};
pub use prepared::{Balance, Outcome, PairOutcome, Prepared};
pub use printed::{NotPrinted, Printed, PrintedDigits};
pub use report::{
    CollisionSummary, LedgerSummary, MethodSummary, PairErrorSummary, PairSummary, ReadingSummary,
    RecordSummary, Report, StructureErrorSummary, StructureSummary, Summary, WorkSummary,
};
pub use reproduce::{Reproduction, Studies};
pub use review::{DOUBTFUL, Errors, Review, STEPS_PER_PERIOD};
pub use savings::{Burden, Burdened};
pub use scene::{
    BoucWen, Building, Columns, Contact, Damping, Detrend, FileUse, FilterBand, Generated, Ground,
    Jumps, Method, RecordUse, RunBudget, STANDARD_GRAVITY, ScaleTo, Scene, Sdof, Source, Start,
    Stochastic, Storey, Structure, Unit,
};
pub use scene_error::SceneError;
pub use schema::{scene_schema, sweep_schema};
pub use separation::{Rule, Separation};
pub use spectrum::{
    Shown, SpectralValues, Spectrum, SpectrumError, periods_between, response_spectrum,
    response_spectrum_watched, scaled_to_sa, spectra_figure,
};
pub use study::{Output, Study, StudyFile};
pub use suite::{Motion, Orientation, Vertical, files_in};
pub use surveys::{
    Fragility, Kept, PoundingSpectra, Range, RequiredGap, Scan, Sensitivity, StiffnessRatio,
    Survey, SurveyStudy,
};
pub use sweep::{
    Batch, Between, ColumnErrors, Directions, Grid, Joined, LogNormal, Normal, Outputs,
    PairQuantity, Parts, PlaceError, Records, RefusedScene, SampleMethod, Samples, SceneOf, Shard,
    Spacing, Spread, StructureQuantity, Sweep, SweepAccuracy, SweepError, SweepFile, Vary,
    compresses, merge,
};
pub use tables::{Table, Value};
pub use trade::{Timed, Trade};
pub use warning::{Place, Warning};
pub use work_precision::{Competitor, WorkPrecision, work_precision_figure};
