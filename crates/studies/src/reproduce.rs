//! All studies at once: tables, figures, agreement and claims.

use crate::paper::converged::{Converged, N_NOISY_RUNS};
use crate::paper::tables::Value;
use crate::program::Program;
use crate::study::output::OwnFolder;
use crate::{
    Atlas, Beyond, BeyondStudy, Claim, ClaimCounts, Comparison, Completed, Extent, Extremes, PublishedValues, StudyError, StudyFile, Table,
    Trade, agreement_csv, claims, claims_csv, figure_png, paper,
};
use pounding_scene::parallel;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The studies of a folder and the published numbers they are compared with.
#[derive(Debug)]
pub struct Studies {
    files: Vec<StudyFile>,
    published: PublishedValues,
    n_noisy_runs: usize,
    extent: Extent,
}

/// Everything that the studies give.
#[derive(Debug)]
pub struct Reproduction {
    /// Contents of the results folder by relative path.
    pub files: BTreeMap<PathBuf, Vec<u8>>,
    /// Every published number with its computed one.
    pub comparisons: Vec<Comparison>,
    /// The paper's claims, tested.
    pub claims: Vec<Claim>,
    /// Disagreements that are not listed, and listed ones that have vanished.
    pub surprises: Vec<String>,
}

impl Studies {
    /// Reads `*.json` and `published/*.csv` of a folder.
    ///
    /// # Errors
    /// [`StudyError`] naming the file and place that cannot be read.
    pub fn read(folder: &Path) -> Result<Self, StudyError> {
        Ok(Self {
            files: StudyFile::read_all(folder)?,
            published: PublishedValues::read(&folder.join("published"))?,
            n_noisy_runs: N_NOISY_RUNS,
            extent: Extent::default(),
        })
    }

    /// The same without the studies that the test refuses.
    #[must_use]
    pub fn only(mut self, test: impl Fn(&StudyFile) -> bool) -> Self {
        self.files.retain(test);
        self
    }

    /// The same with another number of noisy records for each standard deviation of the noise.
    #[must_use]
    pub fn with_noisy_runs(self, n_noisy_runs: usize) -> Self {
        Self { n_noisy_runs, ..self }
    }

    /// The same with the whole of the extremes, or the part that is usually run.
    #[must_use]
    pub fn with_extremes(self, extent: Extent) -> Self {
        Self { extent, ..self }
    }

    /// Number of times that [`Self::reproduce`] calls `done`.
    pub fn n_units(&self) -> usize {
        let units = |file: &StudyFile| {
            let scenes = &file.study.scenes;
            let runs = match file.study.output.folder() {
                Some(OwnFolder::Trade(ladder)) => Trade::n_runs(scenes, ladder),
                Some(OwnFolder::Laws(_)) => Atlas::n_runs(scenes),
                Some(OwnFolder::Extremes(edges)) => Extremes::n_runs(edges, self.extent),
                Some(OwnFolder::Beyond(settings)) => settings.n_usual_cases(),
                Some(OwnFolder::Survey) | None => 0,
            };
            1 + scenes.len() + runs
        };
        self.files.iter().map(units).sum()
    }

    /// Runs every scene and makes every table and figure; `done` is called after each scene and each study.
    ///
    /// The result does not depend on the number of threads.
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the studies.
    pub fn reproduce(self, done: &(dyn Fn() + Sync)) -> Result<Reproduction, StudyError> {
        let completed = parallel::try_each(&self.files, |file| Completed::run(file.clone(), done))?;
        let made = parallel::try_each(&completed, |study| {
            let made = RenderedStudy::of(study, self.extent, done);
            done();
            made
        })?;
        let (mut files, values) = collected(&completed, made);
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
        files.insert("agreement.csv".into(), agreement_csv(&comparisons).into_bytes());
        files.insert(
            "claims.csv".into(),
            claims_csv(&claims, &without_slips(&completed)?, converged.survivals(), &tallies).into_bytes(),
        );
        let surprises = self.published.surprises(&comparisons);
        Ok(Reproduction {
            files,
            comparisons,
            claims,
            surprises,
        })
    }
}

/// Files of all studies by their paths, and the numbers of their tables by the names of these.
fn collected(completed: &[Completed], made: Vec<RenderedStudy>) -> (BTreeMap<PathBuf, Vec<u8>>, BTreeMap<String, Vec<Value>>) {
    let (mut files, mut values) = (BTreeMap::new(), BTreeMap::new());
    for (study, made) in completed.iter().zip(made) {
        let id = &study.file.id;
        if let Some(table) = made.table {
            files.insert(Path::new("tables").join(id).with_extension("csv"), table.to_csv().into_bytes());
            let name = id.strip_prefix("table-").unwrap_or(id);
            values.insert(name.to_string(), table.values);
        }
        files.extend(made.folder);
        if let Some(png) = made.figure {
            files.insert(Path::new("figures").join(id).with_extension("png"), png);
        }
    }
    (files, values)
}

/// The claims by the method as the paper describes it.
fn without_slips(completed: &[Completed]) -> Result<Vec<Claim>, StudyError> {
    let all = completed.iter();
    let by_program: Vec<_> = all.filter(|study| study.file.study.program.is_some()).collect();
    let again = parallel::try_each(&by_program, |study| study.by_program(|_| Program::DESCRIBED));
    claims(&again?)
}

/// The scenes under other ground motions, where a study lists some.
fn beyond(completed: &[Completed], done: &(dyn Fn() + Sync)) -> Result<Option<Beyond>, StudyError> {
    let read: Vec<&StudyFile> = completed.iter().map(|study| &study.file).collect();
    let study = BeyondStudy::listed(&read)?;
    study.map(|study| study.usual().run(done)).transpose()
}

/// What one study makes.
struct RenderedStudy {
    table: Option<Table>,
    figure: Option<Vec<u8>>,
    /// Files of a study with a folder of its own, by their paths.
    folder: BTreeMap<PathBuf, Vec<u8>>,
}

impl RenderedStudy {
    fn of(study: &Completed, extent: Extent, done: &(dyn Fn() + Sync)) -> Result<Self, StudyError> {
        let folder = match study.file.study.output.folder() {
            Some(OwnFolder::Trade(ladder)) => Trade::measure(study, ladder, done)?.files()?,
            Some(OwnFolder::Laws(settings)) => Atlas::draw(study, settings, done)?.files()?,
            Some(OwnFolder::Extremes(edges)) => Extremes::measure(study, edges, extent, done)?.files()?,
            // After the studies whose claims it tests; surveys run by themselves.
            Some(OwnFolder::Beyond(_) | OwnFolder::Survey) | None => BTreeMap::new(),
        };
        Ok(Self {
            table: Table::of(study)?,
            figure: figure_png(study)?,
            folder,
        })
    }
}
