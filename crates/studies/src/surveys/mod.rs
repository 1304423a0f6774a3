//! Surveys: one question asked of thousands of exact runs.
//!
//! Each is a study file with scenes as templates and what to vary of them; its tables and figures have a folder of their own,
//! made by `cargo xtask studies` and committed with their SHA-256. All runs are by the exact method, so that nothing in
//! a table is an error of integration.

mod cases;
mod fragility;
mod heat;
mod required_gap;
mod sensitivity;
mod spectra;
mod statistics;
mod stiffness_ratio;
mod study;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::plot::{Picture, render_png};
use crate::{StudyError, StudyFile};
use cases::Case;
pub use fragility::Fragility;
pub use required_gap::{RequiredGap, Scan};
pub use sensitivity::{Range, Sensitivity};
pub use spectra::PoundingSpectra;
pub use stiffness_ratio::{Kept, StiffnessRatio};
pub use study::SurveyStudy;

/// What a survey asks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Survey {
    /// The width of a gap against the rules for it, and what wider gaps do.
    RequiredGap(RequiredGap),
    /// Pounding forces, impulses and amplifications over both periods.
    PoundingSpectra(PoundingSpectra),
    /// Probability of touching, and of larger drifts, over gap and intensity.
    Fragility(Fragility),
    /// What pounding does to the middle of three structures, over the stiffness of the others.
    StiffnessRatio(StiffnessRatio),
    /// Which inputs matter.
    Sensitivity(Sensitivity),
}

/// Tables and figures by their names.
type Files = BTreeMap<String, Vec<u8>>;

impl Survey {
    /// Runs the survey under the motions of a list where it takes them from there.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the runs.
    fn files(&self, file: &StudyFile, cases: &[Case]) -> Result<Files, StudyError> {
        match self {
            Self::RequiredGap(settings) => required_gap::files(settings, file, cases),
            Self::PoundingSpectra(settings) => spectra::files(settings, file, cases),
            Self::Fragility(settings) => fragility::files(settings, file),
            Self::StiffnessRatio(settings) => stiffness_ratio::files(settings, file, cases),
            Self::Sensitivity(settings) => sensitivity::files(settings, file, cases),
        }
    }
}

/// A picture as PNG.
///
/// # Errors
/// [`StudyError::Plot`] for one that cannot be drawn.
fn drawn(picture: &impl Picture, file: &StudyFile) -> Result<Vec<u8>, StudyError> {
    render_png(picture).map_err(|source| StudyError::Plot {
        path: file.path.clone(),
        source,
    })
}

/// A table as CSV text.
fn csv(header: &[&str], rows: &[Vec<String>]) -> Vec<u8> {
    let header: Vec<String> = header.iter().map(ToString::to_string).collect();
    crate::tables::to_csv(&header, rows).into_bytes()
}
