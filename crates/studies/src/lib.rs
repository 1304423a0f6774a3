//! Scenes and studies of structural pounding: what a user writes, what the paper printed, and what comes out.
//!
//! A [`Scene`](pounding_scene::Scene) is one row of structures under one record. A [`Study`] is scenes and what to print of them; the
//! studies of the paper are data files, one per table and figure. [`Studies::reproduce`] turns a folder of them into tables,
//! figures, the agreement with the published numbers and the verdicts on the paper's claims.
//!
//! Left out: integration (`pounding-solver`), record formats (`pounding-motion`).

mod error;
mod lines;
mod noise;
mod paper;
mod program;
mod reproduce;
mod research;
mod second_route;
mod study;

pub use error::StudyError;
pub use paper::agreement::{
    CLOSE, Comparison, Published, PublishedValues, REPRODUCED, Reason, Verdict, agreement_csv,
};
pub use paper::claims::{Claim, ClaimCount, ClaimCounts, Finding, Survival, claims, claims_csv};
pub use paper::figures::figure_png;
pub use paper::printed::{NotPrinted, Printed, PrintedDigits};
pub use paper::tables::{Table, Value};
pub use program::PapersProgram;
pub use reproduce::{Reproduction, Studies};
pub use research::examples::Examples;
pub use research::floor_cost::{Condition, FloorCost, RowSize, TimedRow, floor_cost_figure};
pub use research::laws::Atlas;
pub use research::other_motions::{Beyond, BeyondStudy, Counted};
pub use research::peers::{Competitor, WorkPrecision, work_precision_figure};
pub use research::savings::{Burden, Burdened};
pub use research::stress::Extremes;
pub use research::surveys::SurveyStudy;
pub use research::verify;
pub use research::work_precision::{Timed, Trade};
pub use second_route::second_route;
pub use study::axis::Axis;
pub use study::change::Change;
pub use study::completed::Completed;
pub use study::laws::AtlasSettings;
pub use study::other_motions::{BeyondSettings, ListedMotion, Strength};
pub use study::stress::{Edges, Extent, Line, Map, Values};
pub use study::surveys::{
    Fragility, HeldConstant, PoundingSpectra, Range, RequiredGap, Scan, Sensitivity,
    StiffnessRatio, Survey,
};
pub use study::{Output, Study, StudyFile};
