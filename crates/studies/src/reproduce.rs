//! All studies together: tables, figures, agreement and claims.

use crate::files::Files;
use crate::paper::converged::{Converged, N_NOISY_RUNS};
use crate::paper::tables::Value;
use crate::program::Program;
use crate::{
    Atlas, Beyond, BeyondSettings, BeyondStudy, Claim, ClaimCounts, Comparison, Completed, Extent, Extremes, Output, PublishedValues,
    StudyError, StudyFile, StudyTable, Trade, agreement_csv, claims, claims_csv, figure_png, paper,
};
use pounding_scene::parallel;
use std::collections::BTreeMap;
use std::path::Path;

/// The studies of a folder, and the published numbers for the comparison.
#[derive(Debug)]
pub struct Studies {
    files: Vec<StudyFile>,
    published: PublishedValues,
    n_noisy_runs: usize,
    extent: Extent,
    /// Is told what was done for which study.
    told: fn(&str),
}

/// The results of all studies.
#[derive(Debug)]
pub struct Reproduction {
    /// Contents of the results folder by relative path.
    pub files: Files,
    /// Comparison of every published number with its computed one.
    pub comparisons: Vec<Comparison>,
    /// The paper's claims with their verdicts.
    pub claims: Vec<Claim>,
    /// Disagreements that are not listed, and listed ones that have vanished.
    pub surprises: Vec<String>,
}

impl Studies {
    /// Reads `*.json` and `published/*.csv` of a folder.
    ///
    /// # Errors
    /// [`StudyError`] with the file and the place that cannot be read.
    pub fn read(folder: &Path) -> Result<Self, StudyError> {
        Ok(Self {
            files: StudyFile::read_all(folder)?,
            published: PublishedValues::read(&folder.join("published"))?,
            n_noisy_runs: N_NOISY_RUNS,
            extent: Extent::default(),
            told: |_| {},
        })
    }

    /// Keeps only the studies that pass a test.
    #[must_use]
    pub fn only(mut self, test: impl Fn(&StudyFile) -> bool) -> Self {
        self.files.retain(test);
        self
    }

    /// Sets the number of noisy records per standard deviation of the noise.
    #[must_use]
    pub fn with_noisy_runs(self, n_noisy_runs: usize) -> Self {
        Self { n_noisy_runs, ..self }
    }

    /// Sets whether all extremes run, or only the usual part.
    #[must_use]
    pub fn with_extremes(self, extent: Extent) -> Self {
        Self { extent, ..self }
    }

    /// Sets what is told what was done for which study.
    #[must_use]
    pub fn telling(self, told: fn(&str)) -> Self {
        Self { told, ..self }
    }

    /// Number of calls of `done` by [`Self::reproduce`].
    pub fn n_units(&self) -> usize {
        let units = |file: &StudyFile| {
            let scenes = &file.study.scenes;
            let output = &file.study.output;
            let runs = if let Output::Trade(ladder) = output {
                Trade::n_runs(scenes, ladder)
            } else if let Output::Laws(_) = output {
                Atlas::n_runs(scenes)
            } else if let Output::Extremes(edges) = output {
                edges.cells(self.extent).len()
            } else {
                output.beyond().map_or(0, BeyondSettings::n_usual_cases)
            };
            1 + scenes.len() + runs
        };
        self.files.iter().map(units).sum()
    }

    /// Runs every scene and makes every table and figure. Calls `done` after each scene and after each study.
    ///
    /// The result does not depend on the number of threads.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the studies.
    pub fn reproduce(self, done: &(dyn Fn() + Sync)) -> Result<Reproduction, StudyError> {
        let completed = parallel::try_each(&self.files, |file| {
            let completed = Completed::run(file.clone(), done);
            (self.told)(&format!("{}: its scenes have run", file.id));
            completed
        })?;
        let made = parallel::try_each(&completed, |study| {
            let made = rendered(study, self.extent, done);
            (self.told)(&format!("{}: its tables and figures are made", study.file.id));
            made
        })?;
        let (mut files, mut values) = (Files::new(), BTreeMap::new());
        for (study, (of_table, made)) in completed.iter().zip(made) {
            let id = &study.file.id;
            values.insert(id.strip_prefix("table-").unwrap_or(id).to_string(), of_table);
            files.extend(made);
        }
        let comparisons = self.published.compare(&values);
        let claims = claims(&completed)?;
        let converged = Converged::new(&completed, self.n_noisy_runs)?;
        files.extend(converged.files(&completed, &self.published)?);
        files.extend(paper::files(&completed, &self.published, converged.exact())?);
        let beyond = beyond(&completed, done)?;
        let tallies = beyond.as_ref().map_or_else(|| vec![ClaimCounts::default()], Beyond::tallies);
        if let Some(beyond) = beyond {
            files.extend(beyond.files()?);
        }
        let of_claims = claims_csv(&claims, &without_slips(&completed)?, converged.survivals(), &tallies);
        files.insert("agreement.csv".into(), agreement_csv(&comparisons).into_bytes());
        files.insert("claims.csv".into(), of_claims.into_bytes());
        let surprises = self.published.surprises(&comparisons);
        Ok(Reproduction {
            files,
            comparisons,
            claims,
            surprises,
        })
    }
}

/// The claims tested on the method as the paper describes it.
fn without_slips(completed: &[Completed]) -> Result<Vec<Claim>, StudyError> {
    let all = completed.iter();
    let by_program: Vec<_> = all.filter(|study| study.file.study.program.is_some()).collect();
    let again = parallel::try_each(&by_program, |study| study.by_program(|_| Program::DESCRIBED));
    claims(&again?)
}

/// The scenes under other ground motions; `None` if no study lists any.
fn beyond(completed: &[Completed], done: &(dyn Fn() + Sync)) -> Result<Option<Beyond>, StudyError> {
    let read: Vec<&StudyFile> = completed.iter().map(|study| &study.file).collect();
    let study = BeyondStudy::listed(&read)?;
    study.map(|study| study.usual().run(done)).transpose()
}

/// The results of one study: the numbers of its table, and its files by path.
fn rendered(study: &Completed, extent: Extent, done: &(dyn Fn() + Sync)) -> Result<(Vec<Value>, Files), StudyError> {
    let output = &study.file.study.output;
    // Other motions follow after the studies whose claims they test; `SurveyStudy` makes surveys separately.
    let mut files = if let Output::Trade(ladder) = output {
        Trade::measure(study, ladder, done)?.files()?
    } else if let Output::Laws(settings) = output {
        Atlas::draw(study, settings, done)?.files()?
    } else if let Output::Extremes(edges) = output {
        Extremes::measure(study, edges, extent, done)?.files()?
    } else {
        Files::new()
    };
    let (id, table) = (&study.file.id, StudyTable::of(study)?);
    if let Some(table) = &table {
        files.insert(Path::new("tables").join(id).with_extension("csv"), table.to_csv().into_bytes());
    }
    if let Some(png) = figure_png(study)? {
        files.insert(Path::new("figures").join(id).with_extension("png"), png);
    }
    done();
    Ok((table.unwrap_or_default().values, files))
}
