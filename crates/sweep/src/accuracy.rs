//! The method of a sweep from a requested error, and its measured errors.
//!
//! The errors of methods are not assumed. A sample of the runs chooses the method by exact runs of these scenes, and another sample
//! measures it. Every shard draws the same samples. A method is tried only if the whole sweep by it, including choice and measurement,
//! would cost less than by the exact method, which needs neither (`prices`).

use pounding_solver::SimultaneousImpacts;
use rand_pcg::Pcg64;
use rayon::prelude::*;
use serde_json::Value;

use super::Sweep;
use super::column_errors::{ColumnErrors, at_most, distance};
use super::output::Output;
use super::permutation::Permutation;
use super::prices::{ALONE, Counts, HALVED, Prices, mean, step};
use super::sampling::SamplePoint;
use pounding_scene::{Method, RunMode, Simulation};
use pounding_text::{Cell, Table};

/// Number of runs that choose the method, and number of runs that measure it.
const CHOOSING: usize = 64;
const MEASURING: usize = 128;
/// Number of first choosing runs, which show the cost of methods and whether any step can be short enough.
const FEW: usize = 8;
/// Runs that fill the lanes of any machine.
const TOGETHER: usize = 16;
/// If more than this part of the scenes can run in lanes, they do.
const HALF: f64 = 0.5;
/// Tolerance of the exact method in lanes, relative to the requested error.
const PART: f64 = 0.1;

/// The method chosen for a sweep, and its errors in the requested numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepAccuracy {
    /// The requested error \[–\].
    pub asked: f64,
    /// The method of all runs.
    pub method: Method,
    /// Errors of the numbers of a row, column by column.
    pub columns: Vec<ColumnErrors>,
    /// Largest error in a row.
    pub rows: ColumnErrors,
    /// Part of the measured runs in which all numbers are within the requested error \[–\].
    pub within: f64,
}

impl SweepAccuracy {
    /// Part of the choosing sample that a method must bring within the requested error.
    pub const SHARE: f64 = 0.95;

    /// Errors of all columns, and of rows, as CSV.
    pub fn csv(&self) -> String {
        let written = |errors: &ColumnErrors, error: f64| Cell::number((errors.runs > 0).then_some(error), |error| format!("{error:.3e}"));
        let quantiles = (0..).zip(["median", "p90", "p95", "p99"]);
        Table::of(self.columns.iter().chain([&self.rows]))
            .column("column", |errors| errors.name.clone())
            .column("runs", |errors| errors.runs)
            .columns(
                quantiles,
                |(_, name)| name.into(),
                |errors, (index, _): (usize, _)| written(errors, errors.quantiles[index]),
            )
            .column("largest", |errors| written(errors, errors.largest))
            .csv()
    }
}

/// The accuracy that a scene requests instead of a method.
pub(super) fn asked(scene: &Value) -> Option<f64> {
    scene.get("method")?.get("accuracy")?.as_f64()
}

impl Sweep {
    /// The chosen method with its errors, if the scene requests an accuracy.
    pub fn accuracy(&self) -> Option<&SweepAccuracy> {
        self.accuracy.as_ref()
    }

    pub(super) fn set_method(&mut self, method: &Method) {
        self.scene["method"] = serde_json::to_value(method).expect("a method has JSON");
    }

    /// Chooses the cheapest method that is within the requested error in most runs of a sample, and measures it by another sample.
    pub(super) fn choose(&mut self, asked: f64) {
        let sampled = self.sampled();
        let method = sampled
            .as_ref()
            .map_or(Method::EXACT, |sampled| self.cheapest(&sampled.chooses, &sampled.measures, asked));
        let errors = match sampled {
            Some(Sample { measures, .. }) if method != Method::EXACT => {
                self.set_method(&Method::EXACT);
                let truth = self.numbers(&measures).numbers;
                self.set_method(&method);
                errors(&truth, &self.numbers(&measures).numbers)
            }
            _ => Vec::new(),
        };
        self.set_method(&method);
        let column = |(index, output): (usize, &Output)| {
            let of_runs = errors.iter().map(|row| row[index]).collect();
            ColumnErrors::of(output.name.clone(), of_runs)
        };
        let rows = rows(&errors);
        let within = rows.iter().filter(|error| **error <= asked).count();
        self.accuracy = Some(SweepAccuracy {
            asked,
            method,
            columns: self.outputs.iter().enumerate().map(column).collect(),
            within: if rows.is_empty() { 1.0 } else { within as f64 / rows.len() as f64 },
            rows: ColumnErrors::of("largest in a row".into(), rows),
        });
    }

    /// The cheapest method according to the choosing runs. Its price includes the measuring runs.
    fn cheapest(&mut self, chooses: &[u64], measures: &[u64], asked: f64) -> Method {
        self.set_method(&Method::EXACT);
        // The usual course: few runs by the exact method, by steps and in lanes, then all that choose, by several steps, and those that measure.
        self.expect(4 * FEW + 8 * CHOOSING + 2 * MEASURING);
        let few = &chooses[..chooses.len().min(FEW)];
        let truth = self.numbers(few);
        // Impacts without a tolerance run in lanes unchanged.
        let flies_already = truth.beside > HALF;
        let exact = if flies_already {
            self.without_ledger(self.price_alone(few)) / ALONE
        } else {
            truth.price
        };
        let prices = Prices {
            counts: Counts {
                all: self.n_runs() as f64,
                choosing: chooses.len() as f64,
                measuring: measures.len() as f64,
            },
            exact,
            steps: self.price_of_steps(few),
        };
        let flown = exact_within(asked * PART);
        self.set_method(&flown);
        let flights = (!flies_already).then(|| self.numbers(few));
        let flights = flights.filter(|flown| flown.beside > 0.0);
        let flights = flights.map(|flown| flown.price + flown.beside * self.without_ledger(exact) / ALONE);
        let flights = flights.filter(|price| prices.is_worth(*price, *price));
        // No step may cost more than the alternative.
        let finest = prices.halved(flights.unwrap_or(f64::INFINITY));
        let mut finest = self.that_may_hold(few, &truth.numbers, asked, finest);
        if flights.is_none() && finest.is_none() {
            return Method::EXACT;
        }
        self.set_method(&Method::EXACT);
        let steps = finest.map_or(0, |finest| usize::try_from(finest + 2).unwrap_or_default());
        self.expect((1 + usize::from(flights.is_some()) + steps) * CHOOSING + 2 * MEASURING);
        let truth = self.numbers(chooses).numbers;
        let mut otherwise = Method::EXACT;
        if flights.is_some() {
            self.set_method(&flown);
            if holds_for(&truth, &self.numbers(chooses).numbers, asked) {
                otherwise = flown;
            } else {
                finest = self.that_may_hold(few, &truth[..few.len()], asked, prices.halved(f64::INFINITY));
            }
        }
        let method = finest.and_then(|finest| self.stepping(chooses, &truth, asked, finest));
        method.unwrap_or(otherwise)
    }

    /// Notes about how many runs of samples will follow.
    fn expect(&self, runs: usize) {
        if let Some(choosing) = &self.choosing {
            choosing.expect(runs as u64);
        }
    }

    /// The finest step that is worth its cost, if it may be within the requested error in half of a few runs.
    fn that_may_hold(&mut self, runs: &[u64], truth: &[Told], asked: f64, finest: Option<i32>) -> Option<i32> {
        finest.filter(|halved| {
            self.set_method(&central_difference(*halved));
            let found = self.numbers(runs).numbers;
            at_most(&sorted(rows(&errors(truth, &found))), 0.5) <= asked
        })
    }

    /// A price of runs alone by the exact method without a ledger; runs in lanes have none.
    fn without_ledger(&self, price: f64) -> f64 {
        if self.verdict { price / RunMode::LEDGER_OF_PIECE } else { price }
    }

    /// Mean cost of some runs by the exact method alone.
    fn price_alone(&self, runs: &[u64]) -> f64 {
        let mut scene = self.scene.clone();
        let price = |run: &u64| {
            let prepared = self.prepared_run(*run, &mut scene)?;
            let ran = self.run_alone(&prepared, &mut Vec::new(), &mut Vec::new());
            ran.ok()
        };
        mean(runs.iter().filter_map(price))
    }

    /// A prepared run; `None` if it cannot be prepared.
    fn prepared_run(&self, run: u64, scene: &mut Value) -> Option<Simulation> {
        let (mut point, mut settings) = (SamplePoint::default(), Vec::new());
        self.plan.settings(run, &mut point, &mut settings);
        let motion = self.plan.motion(run).0;
        self.prepared(motion, &settings, scene).ok()
    }

    /// Mean cost of some runs by central differences with steps of a second.
    fn price_of_steps(&mut self, runs: &[u64]) -> f64 {
        self.set_method(&central_difference(HALVED / 2));
        let going = if self.numbers(runs).beside > HALF {
            RunMode::Beside
        } else if self.verdict {
            RunMode::Judged
        } else {
            RunMode::Alone
        };
        // No step refuses this method.
        self.set_method(&Method::EXACT);
        let mut scene = self.scene.clone();
        let price = |run: &u64| {
            let prepared = self.prepared_run(*run, &mut scene)?;
            Some(prepared.price_of_steps(&Method::central_difference(1.0, 1), going))
        };
        mean(runs.iter().filter_map(price))
    }

    /// Central differences with the longest step that is within the requested error in most runs. The next finer step must confirm it,
    /// because a single step may succeed by chance.
    fn stepping(&mut self, runs: &[u64], truth: &[Told], asked: f64, finest: i32) -> Option<Method> {
        let mut held = false;
        for halved in 0..=finest + 1 {
            self.set_method(&central_difference(halved));
            let holds = holds_for(truth, &self.numbers(runs).numbers, asked);
            if holds && held {
                return Some(central_difference(halved - 1));
            }
            held = holds;
        }
        None
    }

    /// Choosing and measuring runs; `None` if there are too few runs, so that exact runs of all cost least.
    fn sampled(&self) -> Option<Sample> {
        let n_runs = self.n_runs();
        let order = Permutation::new(n_runs, &mut Pcg64::new(17, 23));
        let all: Vec<_> = (0..n_runs).take(CHOOSING + MEASURING).map(|index| order.at(index)).collect();
        let (chooses, measures) = all.split_at_checked(CHOOSING)?;
        (measures.len() == MEASURING).then(|| Sample {
            chooses: chooses.to_vec(),
            measures: measures.to_vec(),
        })
    }

    /// Numbers of some runs (magnitudes for peaks), and their cost.
    ///
    /// If both sides are almost equally far, the sign of a peak is arbitrary: any error of integration would then count as 200 % of the
    /// signed number, although the response hardly changes.
    fn numbers(&self, runs: &[u64]) -> Sampled {
        let number = |(value, output): (&f64, &Output)| {
            if output.quantity.is_peak() { value.abs() } else { *value }
        };
        let some = |runs: &[u64]| {
            let mut told = Vec::with_capacity(runs.len());
            self.run_all(runs.iter().copied(), self.at_a_time(), |run, ran| {
                let ran = ran.map(|ran| {
                    let numbers = Numbers {
                        values: ran.numbers.iter().zip(&self.outputs).map(number).collect(),
                        least: ran.least.to_vec(),
                    };
                    (numbers, if ran.beside { 1.0 } else { 0.0 }, ran.price)
                });
                told.push((run, ran.ok()));
                if let Some(choosing) = &self.choosing {
                    choosing.step();
                }
            });
            // Refused runs are reported at once, others when enough are ready.
            let place = |run: &u64| runs.iter().position(|one| one == run);
            told.sort_by_key(|(run, _)| place(run));
            told
        };
        // As many runs as fill lanes, but several chunks for every thread.
        let together = runs.len() / (4 * rayon::current_num_threads());
        let together = together.clamp(1, TOGETHER);
        let told: Vec<_> = runs.par_chunks(together).flat_map_iter(some).collect();
        let costs = |of: fn(&(Numbers, f64, f64)) -> f64| mean(told.iter().map(|(_, ran)| ran.as_ref().map_or(0.0, of)));
        Sampled {
            beside: costs(|(_, beside, _)| *beside),
            price: costs(|(.., price)| *price),
            numbers: told.into_iter().map(|(_, ran)| Some(ran?.0)).collect(),
        }
    }
}

/// Runs by their numbers.
struct Sample {
    chooses: Vec<u64>,
    measures: Vec<u64>,
}

/// The numbers of a run and their least scales; `None` if it failed.
type Told = Option<Numbers>;

/// The numbers of a run.
#[derive(Debug, Clone)]
struct Numbers {
    values: Vec<f64>,
    /// Least scale of each number for its relative error; empty if no number of the run has one.
    least: Vec<f64>,
}

/// Results of some runs, and their cost.
struct Sampled {
    /// Numbers of every run.
    numbers: Vec<Told>,
    /// Part of the runs that ran in lanes \[–\].
    beside: f64,
    /// Cost of a run, without those in lanes.
    price: f64,
}

/// Central differences with the longest step after this many halvings.
fn central_difference(halved: i32) -> Method {
    Method::central_difference(step(halved), 1)
}

/// The exact method at the tolerance closest to this one that lanes support.
fn exact_within(tolerance: f64) -> Method {
    Method::Exact {
        tolerance: tolerance.clamp(1e-12, 1e-3),
        simultaneous_impacts: SimultaneousImpacts::Together,
    }
}

/// Whether most runs are within an error.
fn holds_for(truth: &[Told], found: &[Told], asked: f64) -> bool {
    at_most(&sorted(rows(&errors(truth, found))), SweepAccuracy::SHARE) <= asked
}

/// Errors of every number of every run that the exact method can follow; all infinite for a run that fails otherwise. A number that neither
/// run has gives no error.
fn errors(truth: &[Told], found: &[Told]) -> Vec<Vec<f64>> {
    let pairs = truth.iter().zip(found);
    let row = |(truth, found): (&Told, &Told)| {
        let Numbers { values, least } = truth.as_ref()?;
        let least = least.iter().copied().chain(std::iter::repeat(0.0));
        Some(match found {
            None => vec![f64::INFINITY; values.len()],
            Some(found) => {
                let pairs = values.iter().zip(&found.values).zip(least);
                let of = |((a, b), least): ((&f64, &f64), f64)| {
                    let is_none = a.is_nan() && b.is_nan();
                    if is_none { f64::NAN } else { distance(*a, *b, least) }
                };
                pairs.map(of).collect()
            }
        })
    };
    pairs.filter_map(row).collect()
}

/// The largest error of every run.
fn rows(errors: &[Vec<f64>]) -> Vec<f64> {
    let largest = |row: &Vec<f64>| row.iter().copied().fold(0.0, f64::max);
    errors.iter().map(largest).collect()
}

fn sorted(mut errors: Vec<f64>) -> Vec<f64> {
    errors.sort_by(f64::total_cmp);
    errors
}
