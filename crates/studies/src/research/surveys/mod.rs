//! Surveys: each asks one question of thousands of exact runs.
//!
//! A survey is a study file whose scenes are templates, with ranges to vary. Its tables and figures have a separate folder.
//! `cargo xtask studies` makes it, and it is committed with SHA-256 hashes. All runs are by the exact method, so no table contains
//! integration errors.
//!
//! Sweeps cannot replace surveys, because the varied values depend on other runs: a gap, for example, is a part of the gap that a pair
//! needs.

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

/// A study with a [`Survey`], and the ground motions of the study that lists them.
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
    /// [`StudyError`] if no study lists ground motions, or if a motion cannot be read.
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

    /// Name of the study and of its results folder.
    pub fn id(&self) -> &str {
        &self.file.id
    }

    /// Runs the survey. Returns tables and figures by their paths in the results folder, with a text of the command and of the tables'
    /// hashes.
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
