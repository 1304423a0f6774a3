//! The runs of a range of numbers, with what came out as columns of numbers.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};

use super::Sweep;
use super::checked::{Checked, TwoRuns};
use super::sampling::Point;
use pounding_scene::{Error, Extras, Going, Simulation};

/// What came out of a range of runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// The runs.
    pub runs: Range<u64>,
    /// A column for each number that is asked for, with a value for each run; NaN where a run has no such number.
    pub columns: Vec<Vec<f64>>,
    /// Of every run why it failed; nothing where it did not.
    pub failed: Vec<Option<String>>,
    /// How every run was held to the laws of mechanics.
    pub checked: Vec<Checked>,
    /// How many runs went side by side.
    pub beside: usize,
    /// What those that did not have cost, in force evaluations that take as long.
    pub(super) price: f64,
    /// Of the last of them what each number counts as at least where its error is relative to it; 0 for its own size.
    pub(super) least: Vec<f64>,
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
            price: 0.0,
            least: Vec::with_capacity(n_columns),
        }
    }

    /// Place of a run in the columns.
    fn place(&self, run: u64) -> usize {
        usize::try_from(run - self.runs.start).expect("below the length of the batch")
    }

    fn take(&mut self, place: usize, numbers: &[f64]) {
        for (column, number) in self.columns.iter_mut().zip(numbers) {
            column[place] = *number;
        }
    }

    fn fail(&mut self, run: u64, reason: String) {
        let place = self.place(run);
        self.failed[place] = Some(reason);
    }
}

/// Runs, how many of them are made ready at a time, and who ends them.
type Many = (Range<u64>, usize, Option<&'static AtomicBool>);

fn is_set(stop: Option<&'static AtomicBool>) -> bool {
    stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
}

/// Scenes that are made ready before they run: of two structures as many as a batch has use for (the record is read once for all of
/// them), of long rows what fills all lanes and not the memory.
fn beside(n_floors: usize) -> usize {
    const FLOORS: usize = 4096;
    (FLOORS / n_floors.max(1)).clamp(16, 256)
}

impl Sweep {
    /// Number of the numbers that are asked for of every run.
    pub(super) fn n_columns(&self) -> usize {
        self.outputs.structures.len() * self.row.floors.len()
            + self.outputs.pairs.len() * self.row.pairs.len()
    }

    /// Runs a range of runs, below [`Self::n_runs`].
    pub fn batch(&self, runs: Range<u64>) -> Batch {
        self.batch_of(runs, beside(self.row.floors.len()), None)
    }

    /// The same; nothing where somebody sets `stop` before they are done.
    pub(super) fn batch_until(&self, runs: Range<u64>, stop: &'static AtomicBool) -> Option<Batch> {
        let batch = self.batch_of(runs, beside(self.row.floors.len()), Some(stop));
        (!is_set(Some(stop))).then_some(batch)
    }

    /// Runs a range of runs, so many of which are made ready at a time; some fail where somebody sets `stop`.
    pub(super) fn batch_of(
        &self,
        runs: Range<u64>,
        beside: usize,
        stop: Option<&'static AtomicBool>,
    ) -> Batch {
        let mut batch = Batch::of(runs.clone(), self.n_columns());
        let mut run = runs.start;
        while run < runs.end {
            let (motion, next) = self.plan.motion(run);
            let end = next.min(runs.end);
            self.run_under(motion, (run..end, beside, stop), &mut batch);
            run = end;
        }
        batch
    }

    /// Runs a range of runs under one motion.
    fn run_under(&self, motion: usize, (runs, beside, stop): Many, batch: &mut Batch) {
        let mut scene = self.scene.clone();
        let (mut point, mut settings) = (Point::default(), Vec::new());
        // What is made ready for the numbers of many runs is of no use to one.
        let many = runs.end - runs.start > 1;
        let mut renumbered = many.then(|| self.renumbered(motion)).flatten();
        let (mut ready, mut ran) = (Vec::new(), Vec::new());
        let mut next = runs.start;
        while next < runs.end && !is_set(stop) {
            // Those that are read anew may be of other columns, in whose memory no numbers are set.
            let mut all_set = renumbered.is_some();
            for run in (next..runs.end).take(beside) {
                self.plan.settings(run, &mut point, &mut settings);
                let prepared = caught(|| {
                    let one = renumbered.as_mut();
                    if let Some(one) = one.and_then(|one| one.prepared(&settings, ran.pop())) {
                        return Ok(one);
                    }
                    all_set = false;
                    let prepared = self.prepared(motion, &settings, &mut scene);
                    let prepared = prepared.map_err(|refused| refused.to_string())?;
                    if self.row.fits(prepared.floors()) {
                        Ok(Box::new(prepared))
                    } else {
                        Err("another number of floors or pairs than in the first run".into())
                    }
                });
                match prepared {
                    Ok(mut prepared) => {
                        prepared.set_stop(stop);
                        ready.push((batch.place(run), prepared));
                    }
                    Err(reason) => batch.fail(run, reason),
                }
                next = run + 1;
            }
            self.run_ready(&ready, batch);
            ran.clear();
            let done = ready.drain(..).map(|(_, prepared)| prepared);
            ran.extend(done.filter(|_| all_set));
        }
    }

    /// Runs scenes that are ready, each with its place in the batch: side by side where they can, else one after the other.
    fn run_ready(&self, ready: &[(usize, Box<Simulation>)], batch: &mut Batch) {
        let tallies = self.beside(ready);
        let mut numbers = Vec::with_capacity(self.n_columns());
        for (scene, (place, prepared)) in ready.iter().enumerate() {
            numbers.clear();
            let told = tallies
                .as_ref()
                .is_some_and(|tallies| self.tell(prepared, tallies, scene, &mut numbers));
            // A fault of the program in one run is no reason to lose the others.
            let ran = if told {
                batch.beside += 1;
                let run = batch.runs.start + *place as u64;
                let sampled = self.verdict && self.is_sampled(run);
                let both = || self.run_both(prepared, &numbers).map(|()| Checked::Both);
                let checked = if sampled {
                    caught(both)
                } else {
                    Ok(Checked::Beside)
                };
                checked.map(|checked| (checked, 0.0))
            } else {
                let price = caught(|| self.run_alone(prepared, &mut numbers, &mut batch.least));
                price.map(|price| (Checked::Ledger, price))
            };
            match ran {
                Ok((checked, price)) => {
                    batch.take(*place, &numbers);
                    batch.price += price;
                    if self.verdict {
                        batch.checked[*place] = checked;
                    }
                }
                Err(reason) => batch.failed[*place] = Some(reason),
            }
        }
    }

    /// Runs a scene that went side by side alone, too, and holds its numbers to each other.
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

    /// One run; its numbers in the order of the columns, what they count as at least, and its price.
    pub(super) fn run_alone(
        &self,
        prepared: &Simulation,
        numbers: &mut Vec<f64>,
        least: &mut Vec<f64>,
    ) -> Result<f64, String> {
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
        let none = f64::NAN;
        for floor in 0..self.row.floors.len() {
            for quantity in &self.outputs.structures {
                least.push(values.least(*quantity, floor));
                numbers.push(values.of(*quantity, floor).unwrap_or(none));
            }
        }
        for pair in 0..self.row.pairs.len() {
            for quantity in &self.outputs.pairs {
                least.push(values.least(*quantity, pair));
                numbers.push(values.of(*quantity, pair).unwrap_or(none));
            }
        }
        let going = if self.verdict {
            Going::Judged
        } else {
            Going::Alone
        };
        Ok(prepared.price(outcome.work, going))
    }
}

/// What a run gives, or why it fails; a panic is such a reason.
fn caught<T>(run: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|_| {
        Err(
            "the program panicked, which is a fault of its own; `pounding run` of this scene shows where"
                .into(),
        )
    })
}
