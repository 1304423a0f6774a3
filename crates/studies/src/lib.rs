//! Studies of structural pounding: the paper's numbers, the computed numbers, and questions beyond the paper.
//!
//! A [`Study`] holds scenes and the output to print of them. The studies of the paper are data files in `studies/`, one per table and
//! figure. [`Studies::reproduce`] runs the whole folder. It gives tables, figures, the agreement with the published numbers and the
//! verdicts on the paper's claims.
//!
//! ```
//! use pounding_studies::{Completed, StudyFile, StudyTable};
//!
//! // Table 4 of the paper: two structures, 30 mm apart, with the nonlinear viscoelastic element under El Centro.
//! let study = StudyFile::read("../../studies/table-4.json".as_ref())?;
//! let table = StudyTable::of(&Completed::run(study, &|| ())?)?.expect("the study prints a table");
//! let force = |quantity| {
//!     let mut values = table.values.iter();
//!     values.find(|one| (&*one.row, &*one.quantity) == ("elastic 1.2", quantity)).map(|one| one.value)
//! };
//!
//! // The paper prints −921.945 kN and 921.9447 kN; both forces of a pair are equal and opposite.
//! let (weak, stiff) = (force("force on weak").expect("a row"), force("force on stiff").expect("a row"));
//! assert!((weak + 921.945).abs() < 5e-4 && (stiff - 921.9447).abs() < 5e-5);
//! assert_eq!(weak, -stiff);
//! # Ok::<(), pounding_studies::StudyError>(())
//! ```
//!
//! This crate leaves out everything that users of the library run. Scenes are in `pounding-scene`, sweeps in `pounding-sweep`, methods in
//! `pounding-solver`, record formats in `pounding-motion`. `cargo xtask` writes the resulting files.
//!
//! Where to start:
//!
//! - [`Study`] and [`Output`] (`study/`): the contents of a study file.
//! - [`Studies`], [`Comparison`] and [`Claim`] (`paper/`): tables, figures, agreement, claims.
//! - [`PapersProgram`] (`program/`): the program that gave the published numbers, with its slips.
//! - [`Survey`], [`Beyond`], [`Trade`] and [`verify`] (`research/`): surveys, other motions, error against work, random scenes.

mod drivers;
mod error;
mod files;
mod lines;
mod listed;
mod noise;
mod paper;
mod program;
mod reproduce;
mod research;
mod second_route;
mod statistics;
mod study;

pub use error::StudyError;
pub use paper::agreement::{CLOSE, Comparison, Published, PublishedValues, REPRODUCED, Reason, Verdict, agreement_csv};
pub use paper::claims::{Claim, ClaimCount, ClaimCounts, Finding, Survival, claims, claims_csv};
pub use paper::figures::figure_png;
pub use paper::printed::{NotPrinted, Printed, PrintedDigits};
pub use paper::tables::{StudyTable, Value};
pub use program::PapersProgram;
pub use reproduce::{Reproduction, Studies};
pub use research::examples::Examples;
pub use research::laws::Atlas;
pub use research::other_motions::{Beyond, BeyondStudy, Counted};
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
pub use study::stress::{ChangeSeries, Edges, Extent, Map, Values};
pub use study::surveys::{Fragility, HeldConstant, PoundingSpectra, Range, RequiredGap, Scan, Sensitivity, StiffnessRatio, Survey};
pub use study::{Output, Study, StudyFile};
