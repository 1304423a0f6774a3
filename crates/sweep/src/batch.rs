//! The runs of a range of numbers, with results as columns of numbers.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::Ordering;

use super::Sweep;
use super::checked::{Checked, TwoRuns};
use super::plan::Setting;
use super::renumbered::Renumbered;
use super::sampling::SamplePoint;
use pounding_scene::{Error, Extras, RunMode, Simulation};
use serde_json::Value;

/// Results of a range of runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// The runs.
    pub runs: Range<u64>,
    /// A column for each requested number, with a value for each run; NaN if a run has no such number.
    pub columns: Vec<Vec<f64>>,
    /// For every run, the reason of its failure; `None` if it succeeded.
    pub failed: Vec<Option<String>>,
    /// For every run, how the laws of mechanics were checked.
    pub checked: Vec<Checked>,
    /// Number of runs in lanes.
    pub beside: usize,
}

impl Batch {
    pub(super) fn of(runs: Range<u64>, n_columns: usize) -> Self {
        let n = usize::try_from(runs.end - runs.start).expect("a batch fits into memory");
        Self {
            runs,
            columns: vec![vec![f64::NAN; n]; n_columns],
            failed: vec![None; n],
            checked: vec![Checked::No; n],
            beside: 0,
        }
    }

    fn take(&mut self, run: u64, ran: Result<Ran<'_>, String>) {
        let place = usize::try_from(run - self.runs.start).expect("below the length of the batch");
        match ran {
            Ok(ran) => {
                for (column, number) in self.columns.iter_mut().zip(ran.numbers) {
                    column[place] = *number;
                }
                self.checked[place] = ran.checked;
                self.beside += usize::from(ran.beside);
            }
            Err(reason) => self.failed[place] = Some(reason),
        }
    }
}

/// Results of a run.
pub(super) struct Ran<'a> {
    /// Numbers in the order of the columns.
    pub(super) numbers: &'a [f64],
    /// Least scale of each number for its relative error, 0 for its own size; empty if no number of the run has one.
    pub(super) least: &'a [f64],
    pub(super) checked: Checked,
    /// Whether it ran in lanes.
    pub(super) beside: bool,
    /// Cost of a run alone, in force evaluations of equal duration.
    pub(super) price: f64,
}

/// Most samples of records in prepared scenes, except a common record: 4 MB.
const MOST_SAMPLES: usize = 1 << 19;

/// Scenes that fill the lanes of any machine. This many scenes of a motion run without waiting for scenes of another motion; mixed groups
/// would sample each motion separately.
const FILL_LANES: usize = 16;

/// Prepared scenes, each with its run.
#[derive(Default)]
struct Ready {
    scenes: Vec<(u64, Box<Simulation>)>,
    /// Number of samples of separate records.
    samples: usize,
    /// Whether all are made from the last template.
    of_template: bool,
}

/// Preparation of scenes, motion by motion.
struct Making<'a> {
    sweep: &'a Sweep,
    scene: Value,
    point: SamplePoint,
    settings: Vec<Setting>,
    motion: Option<usize>,
    /// The scene under this motion, in which numbers are set; `None` if every scene is read.
    template: Option<Renumbered>,
    /// Finished scenes of the template, whose memory is reused.
    #[expect(clippy::vec_box, reason = "boxes go from here into scenes that are ready, and back")]
    ran: Vec<Box<Simulation>>,
}

impl<'a> Making<'a> {
    fn new(sweep: &'a Sweep) -> Self {
        Self {
            sweep,
            scene: sweep.scene.clone(),
            point: SamplePoint::default(),
            settings: Vec::new(),
            motion: None,
            template: None,
            ran: Vec::new(),
        }
    }

    /// Continues with a motion. A template is prepared only for many runs.
    fn turn_to(&mut self, motion: usize, many: bool) {
        self.motion = Some(motion);
        self.template = many.then(|| self.sweep.renumbered(motion)).flatten();
        self.ran.clear();
    }

    /// The scene of a run under the motion, and whether it is made from the template. Others may have other columns, and their memory is
    /// not reused.
    fn make(&mut self, motion: usize, run: u64) -> Result<(Box<Simulation>, bool), String> {
        let (sweep, ran) = (self.sweep, self.ran.pop());
        sweep.plan.settings(run, &mut self.point, &mut self.settings);
        let template = self.template.as_mut();
        if let Some(one) = template.and_then(|one| one.prepared(&self.settings, ran)) {
            return Ok((one, true));
        }
        let prepared = sweep.prepared(motion, &self.settings, &mut self.scene);
        let prepared = prepared.map_err(|refused| refused.to_string())?;
        if sweep.row.fits(prepared.scene(), prepared.floors()) {
            Ok((Box::new(prepared), false))
        } else {
            Err("another number of floors or pairs than in the first run".into())
        }
    }
}

impl Sweep {
    /// Runs that are prepared at a time. For two structures, this is as many as a batch can use, because the record is read once for all of
    /// them. For long rows, this fills all lanes but not the memory.
    pub(super) fn at_a_time(&self) -> usize {
        const FLOORS: usize = 4096;
        let n_floors = self.row.n_floors().max(1);
        (FLOORS / n_floors).clamp(16, 256)
    }

    /// Whether the stop flag is set.
    pub fn is_stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }

    /// Runs a range of runs, below [`Self::n_runs`]. After a stop some of them fail.
    pub fn batch(&self, runs: Range<u64>) -> Batch {
        self.batch_of(runs, self.at_a_time())
    }

    /// Runs a range of runs; `None` if stopped before the end.
    pub(super) fn batch_unless_stopped(&self, runs: Range<u64>) -> Option<Batch> {
        let batch = self.batch(runs);
        (!self.is_stopped()).then_some(batch)
    }

    /// Runs a range of runs, `at_a_time` at a time.
    pub(super) fn batch_of(&self, runs: Range<u64>, at_a_time: usize) -> Batch {
        let mut batch = Batch::of(runs.clone(), self.outputs.len());
        self.run_all(runs, at_a_time, |run, ran| batch.take(run, ran));
        batch
    }

    /// Prepares and runs these runs, some at a time, under any motions; reports the results of each.
    pub(super) fn run_all(
        &self,
        runs: impl IntoIterator<Item = u64>,
        at_a_time: usize,
        mut tell: impl FnMut(u64, Result<Ran<'_>, String>),
    ) {
        let mut runs = runs.into_iter().peekable();
        let (mut making, mut ready) = (Making::new(self), Ready::default());
        while let Some(run) = runs.next() {
            let motion = self.plan.motion(run).0;
            if making.motion != Some(motion) {
                let next = runs.peek().map(|next| self.plan.motion(*next).0);
                making.turn_to(motion, next == Some(motion));
                ready.of_template = false;
                if !self.motions.differ() && ready.scenes.len() >= FILL_LANES {
                    self.run_ready(&ready.scenes, &mut tell);
                    ready = Ready::default();
                }
            }
            match caught(|| making.make(motion, run)) {
                Ok((mut prepared, of_template)) => {
                    prepared.set_stop(self.stop);
                    ready.of_template = of_template && (ready.of_template || ready.scenes.is_empty());
                    if self.motions.differ() {
                        ready.samples += prepared.record().samples().len();
                    }
                    ready.scenes.push((run, prepared));
                }
                Err(reason) => tell(run, Err(reason)),
            }
            let full = ready.scenes.len() >= at_a_time || ready.samples >= MOST_SAMPLES;
            if full || runs.peek().is_none() {
                self.run_ready(&ready.scenes, &mut tell);
                if self.is_stopped() {
                    return;
                }
                let Ready { scenes, of_template, .. } = std::mem::take(&mut ready);
                let done = scenes.into_iter().filter(|_| of_template);
                making.ran = done.map(|(_, prepared)| prepared).collect();
            }
        }
    }

    /// Runs prepared scenes: in lanes if possible, else in sequence.
    fn run_ready(&self, ready: &[(u64, Box<Simulation>)], tell: &mut impl FnMut(u64, Result<Ran<'_>, String>)) {
        let together = self.beside(ready);
        let mut numbers = Vec::with_capacity(self.outputs.len());
        let mut least = Vec::new();
        for (scene, (run, prepared)) in ready.iter().enumerate() {
            numbers.clear();
            least.clear();
            let beside = together
                .as_ref()
                .is_some_and(|sums| self.tell(prepared, sums, scene, &mut numbers, &mut least));
            // A fault of the program in one run must not lose the others.
            let ran = if !beside {
                let price = caught(|| self.run_alone(prepared, &mut numbers, &mut least));
                price.map(|price| (Checked::Ledger, price))
            } else if self.verdict && self.is_sampled(*run) {
                caught(|| self.run_both(prepared, &numbers)).map(|()| (Checked::Both, 0.0))
            } else {
                Ok((Checked::Beside, 0.0))
            };
            let ran = ran.map(|(checked, price)| Ran {
                numbers: &numbers,
                least: &least,
                checked: if self.verdict { checked } else { Checked::No },
                beside,
                price,
            });
            tell(*run, ran);
        }
    }

    /// Also runs a scene from lanes alone, and compares its numbers.
    fn run_both(&self, prepared: &Simulation, beside: &[f64]) -> Result<(), String> {
        let (mut alone, mut least) = (Vec::new(), Vec::new());
        self.run_alone(prepared, &mut alone, &mut least)?;
        let runs = TwoRuns {
            beside,
            alone: &alone,
            least: &least,
        };
        self.compare(prepared, &runs)
    }

    /// Runs a single run; fills its numbers in the order of the columns and their least scales, and returns its price.
    pub(super) fn run_alone(&self, prepared: &Simulation, numbers: &mut Vec<f64>, least: &mut Vec<f64>) -> Result<f64, String> {
        let reason = |error: Error| error.reason();
        numbers.clear();
        least.clear();
        let asked = Extras {
            interval: None,
            closings: self.closings,
            ..Extras::default()
        };
        let outcome = if self.verdict {
            prepared.run_with(asked)
        } else {
            prepared.run_unjudged(asked)
        }
        .map_err(reason)?;
        let values = outcome.values(prepared);
        for output in &self.outputs {
            let of = |place: usize| {
                let quantity = output.asked_of(prepared.floors(), place);
                let number = values.of(quantity, place).unwrap_or(f64::NAN);
                (number, values.least(quantity, place))
            };
            let (number, counts_as) = output.severest(of);
            numbers.push(number);
            least.push(counts_as);
        }
        let going = if self.verdict { RunMode::Judged } else { RunMode::Alone };
        Ok(prepared.price(outcome.work, going))
    }
}

/// The result of a run or the reason of its failure; a panic counts as a failure.
fn caught<T>(run: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run))
        .unwrap_or_else(|_| Err("the program panicked, which is a fault of its own; `pounding run` of this scene shows where".into()))
}
