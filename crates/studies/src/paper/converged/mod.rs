//! The paper's tables by the exact method, and their sensitivity to a little noise on the record.
//!
//! Inputs are the paper's: the record linear between samples, its first sample at t = 0, structures at rest, loads for 10 s. For totals the
//! runs last twice as long, as in the paper's program; for findings they last 10 s. The start of the paper's program has no counterpart,
//! because the exact method begins with the record. Numbers that depend on a time step are left out: the stereomechanical force is an
//! impulse over a time step and has no limit.

mod figure;
mod quantities;
mod scenes;
mod tables;

use crate::files::Files;
use crate::noise::Noise;
use crate::paper::claims::{Claim, Survival, survivals, verdicts};
use crate::{Completed, Output, PublishedValues, StudyError, StudyFile};
use pounding_scene::{Method, parallel};

pub(crate) use figure::{Over, TOTALS};
pub(crate) use quantities::{Quantities, find, quantities};
pub(crate) use scenes::Scenes;

/// Standard deviations of the relative noise on the samples of the record \[–\].
pub(crate) const LEVELS: [f64; 5] = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2];
/// Index of the level that the claims are tested at: 0.1 %, less than the error of instruments and processing in 1940.
pub(crate) const LEVEL: usize = 3;
/// Number of noisy runs per level in the committed results.
pub(crate) const N_NOISY_RUNS: usize = 200;
/// Time steps of the paper's program \[s\], the coarsest first.
const TIME_STEPS: [f64; 4] = [0.01, 0.005, 0.0025, 0.00125];
/// Studies with the numbers of the tables and of most claims. Table 5 uses the scenes of Tables 2 and 4.
pub(crate) const STUDIES: [&str; 4] = ["table-2", "table-4", "table-6", "table-7"];
/// Study that only the claims need.
pub(crate) const OF_CLAIMS: &str = "figure-15";

/// The paper's scenes by the exact method, by the paper's program at several time steps, and under noisy records.
#[derive(Debug)]
pub(crate) struct Converged {
    /// Numbers by the paper's program at its own time steps.
    stepped: Quantities,
    /// Tables 6 and 7 by the paper's program at each of [`TIME_STEPS`].
    finer: Vec<Quantities>,
    /// Numbers by the exact method, with runs that go on after the loads.
    exact: Quantities,
    /// Numbers by the exact method within the 10 s of the loads.
    exact_of_loads: Quantities,
    /// Numbers by the exact method under noisy records: one entry per run for each of [`LEVELS`].
    noisy: Vec<Vec<Quantities>>,
    /// Verdicts on the claims.
    survivals: Vec<Survival>,
}

/// The numbers under one record, and the verdicts on the claims if they are tested.
struct RecordCase {
    quantities: Quantities,
    verdicts: Vec<Option<Claim>>,
}

/// Numbers by the exact method.
#[derive(Clone, Copy)]
pub(crate) struct Exact<'a> {
    /// Numbers within the 10 s of the loads.
    pub of_loads: &'a Quantities,
    /// Numbers of runs that go on without loads, as those of the paper's program do.
    pub running_on: &'a Quantities,
}

impl Converged {
    /// Runs all scenes by all methods, with `n_runs` noisy records for each of [`LEVELS`].
    ///
    /// # Errors
    /// The first [`StudyError`] in the order of the runs.
    pub(crate) fn new(completed: &[Completed], n_runs: usize) -> Result<Self, StudyError> {
        let files: Vec<&StudyFile> = completed.iter().map(|study| &study.file).collect();
        let scenes = Scenes::of(&files, &STUDIES, |_| Method::EXACT)?;
        let whole = scenes.running_on()?;
        let of_claims = Scenes::of(&files, &[OF_CLAIMS], |_| Method::EXACT)?;
        let finer = parallel::try_each(&TIME_STEPS, |step| {
            let runs = Scenes::of(&files, &["table-6", "table-7"], |method| method.with_time_step(*step))?;
            quantities(&runs.run(None)?)
        })?;
        let world = |noise: Option<&Noise>, asks: bool| -> Result<RecordCase, StudyError> {
            let quantities = quantities(&whole.run(noise)?)?;
            let verdicts = if asks {
                let mut runs = scenes.run(noise)?;
                runs.extend(of_claims.run(noise)?);
                verdicts(&runs)?
            } else {
                Vec::new()
            };
            Ok(RecordCase { quantities, verdicts })
        };
        let exact = world(None, true)?;
        let mut noisy = Vec::new();
        let mut noisy_verdicts = Vec::new();
        for (level, sigma) in LEVELS.into_iter().enumerate() {
            let asks = level == LEVEL;
            let one = |run: &usize| world(Some(&Noise::new(sigma, level, *run)), asks);
            let worlds = parallel::try_each(&(0..n_runs).collect::<Vec<_>>(), one)?;
            let (values, verdicts): (Vec<_>, Vec<_>) = worlds.into_iter().map(|case| (case.quantities, case.verdicts)).unzip();
            noisy.push(values);
            if asks {
                noisy_verdicts = verdicts;
            }
        }
        Ok(Self {
            exact_of_loads: quantities(&scenes.run(None)?)?,
            stepped: quantities(completed)?,
            finer,
            exact: exact.quantities,
            noisy,
            survivals: survivals(&exact.verdicts, &noisy_verdicts),
        })
    }

    /// Numbers by the exact method.
    pub(crate) fn exact(&self) -> Exact<'_> {
        Exact {
            of_loads: &self.exact_of_loads,
            running_on: &self.exact,
        }
    }

    /// Verdicts on the claims, in their order.
    pub(crate) fn survivals(&self) -> &[Survival] {
        &self.survivals
    }
}

/// Path of the figure in the results folder.
const FIGURE: &str = "figures/converged-transferred-momentum.png";

impl Converged {
    /// Tables and figure by their paths in the results folder.
    ///
    /// # Errors
    /// [`StudyError::Plot`] if the figure cannot be drawn.
    pub(crate) fn files(&self, completed: &[Completed], published: &PublishedValues) -> Result<Files, StudyError> {
        let published = quantities::published(published.values(), late(completed));
        let name = |table: &str| format!("tables/converged-{table}.csv").into();
        let table = |table| (name(table), self.table(table, &published).into_bytes());
        let mut files: Files = ["2", "4", "5", "6", "7"].map(table).into();
        files.insert(FIGURE.into(), self.figure_png(&published)?);
        Ok(files)
    }
}

/// Delay of the times that Table 2 prints \[s\].
fn late(completed: &[Completed]) -> f64 {
    let of_table = |study: &&Completed| study.file.id == "table-2";
    match completed.iter().find(of_table).map(|study| &study.file.study.output) {
        Some(Output::PoundingForcesTable { label_offset_s, .. }) => *label_offset_s,
        _ => 0.0,
    }
}
