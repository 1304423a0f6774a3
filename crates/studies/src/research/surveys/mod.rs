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

use crate::files::{Files, in_folder, made_by};
use crate::study::surveys::Survey;
use crate::{Output, StudyError, StudyFile};

use cases::Case;

/// A study that asks a [`Survey`], with the ground motions of the study that lists them.
#[derive(Debug)]
pub struct SurveyStudy {
    file: StudyFile,
    survey: Survey,
    cases: Vec<Case>,
}

impl SurveyStudy {
    /// The surveys among some studies, in their order.
    ///
    /// # Errors
    /// [`StudyError`] where no study lists ground motions, or one of them cannot be read.
    pub fn all(files: &[StudyFile]) -> Result<Vec<Self>, StudyError> {
        let (path, settings) = StudyFile::listing(files).ok_or_else(|| StudyError::no_scene_of("beyond"))?;
        let cases = Case::listed(settings, path)?;
        let of = |file: &StudyFile| {
            let Output::Survey(survey) = &file.study.output else {
                return None;
            };
            Some(Self {
                file: file.clone(),
                survey: survey.clone(),
                cases: cases.clone(),
            })
        };
        Ok(files.iter().filter_map(of).collect())
    }

    /// Name of the study, and of its folder of results.
    pub fn id(&self) -> &str {
        &self.file.id
    }

    /// Runs the survey: tables and figures by their path in the results folder, with the command and the hashes by which
    /// committed tables are known to be its.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the runs.
    pub fn run(&self) -> Result<Files, StudyError> {
        let (file, cases) = (&self.file, &self.cases);
        let files = match &self.survey {
            Survey::RequiredGap(settings) => required_gap::files(settings, file, cases),
            Survey::PoundingSpectra(settings) => spectra::files(settings, file, cases),
            Survey::Fragility(settings) => fragility::files(settings, file),
            Survey::StiffnessRatio(settings) => stiffness_ratio::files(settings, file, cases),
            Survey::Sensitivity(settings) => sensitivity::files(settings, file, cases),
        };
        let mut files = files.map_err(|error| error.in_file(&file.path))?;
        let made_by = made_by(&format!("cargo xtask studies {}", self.id()), &files);
        files.insert("made-by.txt".into(), made_by);
        Ok(in_folder(self.id(), files))
    }
}
