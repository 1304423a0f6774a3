//! Which method and time step reach an accuracy at the least cost.

use rayon::prelude::*;

use crate::contenders::{CONTENDERS, Contender, Knob};
use crate::ladder::{Ladder, entries, holding};
use crate::{Method, Outcome, Prepared, Quantity, RunErrors, StudyError};

/// Longest time step of the ladder \[s\]; each next one is half as long.
pub const LONGEST_STEP: f64 = 0.01;
/// Most steps of structures in one run of the ladder: two structures and 20 s come to 80 µs.
///
/// The exact method does with some thousand pieces what a stepping method would need the finer steps for.
pub const MOST_STEPS: u32 = 500_000;

/// The accuracy asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Goal {
    /// Largest relative error \[–\], > 0 and < 1.
    pub error: f64,
    /// Of what.
    pub quantity: Quantity,
}

/// A run of the ladder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// Name of the method, as in figures.
    pub name: &'static str,
    /// Method with its step.
    pub method: Method,
    /// Largest error \[–\] of the quantity; infinite where the run failed or the numbers of collisions differ.
    pub error: f64,
    /// What has the largest error; empty for the exact method.
    pub worst: &'static str,
    /// Force evaluations of a step of the central difference method that take as long; a piece of the exact method counts as
    /// [`Prepared::evaluations_per_piece`] of them.
    pub cost: u64,
}

/// A method on the ladder, from the longest time step to the shortest.
#[derive(Debug, Clone, PartialEq)]
pub struct Rungs {
    /// Its runs; none where no time step is stable.
    pub trials: Vec<Trial>,
    /// Index of the cheapest run that meets the goal, as all runs at shorter steps do; the shortest only confirms.
    pub meets: Option<usize>,
}

/// What every method of the ladder costs and how far it is from the exact one.
#[derive(Debug, Clone, PartialEq)]
pub struct Advice {
    /// What was asked for.
    pub goal: Goal,
    /// The exact method, the measure of the others; its own error is about rounding.
    pub exact: Trial,
    /// Every method with time steps.
    pub methods: Vec<Rungs>,
}

impl Advice {
    /// The cheapest run that meets the goal; the exact method when no cheaper one does.
    pub fn best(&self) -> &Trial {
        let meeting = self.methods.iter().filter_map(Rungs::chosen);
        meeting.fold(
            &self.exact,
            |best, next| {
                if next.cost < best.cost { next } else { best }
            },
        )
    }
}

impl Rungs {
    fn new(trials: Vec<Trial>, goal: Goal) -> Self {
        let holding = holding(&trials, |trial| trial.error <= goal.error);
        let first = trials.len() - holding.len();
        let confirmed = first..trials.len().saturating_sub(1);
        Self {
            meets: confirmed.min_by_key(|index| trials[*index].cost),
            trials,
        }
    }

    /// The cheapest run that meets the goal, as all runs at shorter steps do.
    pub fn chosen(&self) -> Option<&Trial> {
        self.meets.map(|index| &self.trials[index])
    }
}

/// Runs a scene, whatever its method, with every method of the trade on a ladder of time steps; `done` is called after
/// each run with the number of runs.
///
/// # Errors
/// [`StudyError::NoReference`] where the exact method, the measure of the others, fails.
pub fn advise(
    prepared: &Prepared,
    goal: Goal,
    done: &(dyn Fn(usize) + Sync),
) -> Result<Advice, StudyError> {
    let twin = prepared.exact()?;
    let exact = twin
        .run_compared()
        .map_err(|error| StudyError::NoReference(error.into()))?;
    let ladder = Ladder::halved(prepared.scene(), LONGEST_STEP, MOST_STEPS.into());
    let runs: Vec<_> = entries(prepared.scene(), &ladder)
        .filter(|(contender, _)| contender.knob == Knob::TimeStep)
        .collect();
    let trials: Vec<_> = runs
        .par_iter()
        .map(|&(contender, step)| {
            let trial = trial(prepared, (contender, step), &exact, goal.quantity);
            done(runs.len());
            Some((contender.key, trial?))
        })
        .collect();
    let rungs = |contender: &Contender| {
        let own = trials
            .iter()
            .flatten()
            .filter(|(key, _)| *key == contender.key);
        Rungs::new(own.map(|(_, trial)| *trial).collect(), goal)
    };
    let methods = CONTENDERS.iter().map(rungs);
    Ok(Advice {
        goal,
        exact: Trial {
            name: "Exact",
            method: twin.method(),
            error: 0.0,
            worst: "",
            cost: whole(twin.price(exact.work)),
        },
        methods: methods.filter(|rungs| !rungs.trials.is_empty()).collect(),
    })
}

/// A price, rounded.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "of a count of work, ≥ 0"
)]
fn whole(price: f64) -> u64 {
    price.round() as u64
}

/// One run of the ladder; nothing where the scene refuses the step, such as one beyond a limit of stability.
fn trial(
    prepared: &Prepared,
    (contender, step): (&Contender, f64),
    exact: &Outcome,
    quantity: Quantity,
) -> Option<Trial> {
    let method = (contender.method)(step);
    let prepared = prepared.with_method(method).ok()?;
    let (error, worst, cost) = match prepared.run_compared() {
        Ok(outcome) => {
            let errors = RunErrors::between(&outcome, exact, &prepared);
            let (error, worst) = errors.largest(quantity);
            (error, worst, whole(prepared.price(outcome.work)))
        }
        Err(_) => (f64::INFINITY, "run fails", 0),
    };
    Some(Trial {
        name: contender.label,
        method,
        error,
        worst,
        cost,
    })
}
