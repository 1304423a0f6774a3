//! A survey and what it needs of other studies.

use super::Survey;
use super::cases::Case;
use crate::{Output, StudyError, StudyFile};
use pounding_scene::sha256;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

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
        let lists = |file: &StudyFile| Some((file.path.clone(), file.study.output.beyond()?.clone()));
        let Some((path, settings)) = files.iter().find_map(lists) else {
            return Err(StudyError::MissingScene {
                study: "beyond".into(),
                scene: "any".into(),
            });
        };
        let cases = Case::listed(&settings, &path)?;
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
    pub fn run(&self) -> Result<BTreeMap<PathBuf, Vec<u8>>, StudyError> {
        let files = self.survey.files(&self.file, &self.cases);
        let mut files = files.map_err(|error| error.in_file(&self.file.path))?;
        let mut made_by = format!("cargo xtask studies {}\n", self.id());
        let is_table = |name: &str| Path::new(name).extension().is_some_and(|ending| ending == "csv");
        for (name, bytes) in files.iter().filter(|(name, _)| is_table(name)) {
            writeln!(made_by, "SHA-256 of {name}: {}", sha256(bytes)).expect("a string takes all");
        }
        files.insert("made-by.txt".into(), made_by.into_bytes());
        let in_folder = |(name, bytes)| (Path::new(self.id()).join::<String>(name), bytes);
        Ok(files.into_iter().map(in_folder).collect())
    }
}
