//! Surveys: one question asked of thousands of exact runs.
//!
//! Each is a study file with scenes as templates and what to vary of them; its tables and figures have a folder of their own,
//! made by `cargo xtask studies` and committed with their SHA-256. All runs are by the exact method, so that nothing in
//! a table is an error of integration.
//!
//! They are no sweeps: what varies depends on other runs, such as a gap as a part of what one pair requires.

mod cases;
mod fragility;
mod heat;
mod required_gap;
mod sensitivity;
mod spectra;
mod stiffness_ratio;
mod survey_study;

use crate::study::surveys::Survey;
use crate::{StudyError, StudyFile};
use pounding_plot::{Picture, render_png};
use std::collections::BTreeMap;

use cases::Case;
pub use survey_study::SurveyStudy;

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
    pounding_text::to_csv(&header, rows).into_bytes()
}
