//! The search for the cheapest method and time step that reach an accuracy.

use crate::accuracy::ladder::Ladder;
use crate::accuracy::methods::{ComparedMethod, MethodSetting};
use crate::accuracy::price::RunMode;
use crate::{Advice, Error, Extras, Goal, MethodTrial, QuantityGroup, RunErrors, RunResult, Simulation, StepSizes, parallel};
use pounding_text::Refused;

/// Error if the exact run, the reference for all methods, fails.
fn no_reference(error: Error) -> Error {
    error.said(|refused| {
        let fails = Refused::that("the exact run, by which every method is measured, fails: ").and(&refused);
        fails.kind(refused.own_kind())
    })
}

impl Advice {
    /// Longest time step of the ladder \[s\]; each step is half as long as the one before.
    pub const LONGEST_STEP: f64 = 0.01;

    /// Largest number of steps of structures in one run of the ladder: for two structures and 20 s down to 80 µs.
    ///
    /// Below such steps the exact method is cheaper: it needs some thousand pieces.
    pub const MOST_STEPS: u32 = 500_000;

    /// Runs a scene with every method of the list on a ladder of time steps, whatever its own method. Calls `done` after each run with the
    /// number of all runs.
    ///
    /// # Errors
    /// Fails if the exact run, the reference for all methods, fails.
    pub fn of(prepared: &Simulation, goal: Goal, done: &(dyn Fn(usize) + Sync)) -> Result<Self, Error> {
        let twin = prepared.exact()?;
        let exact = twin.run_with(Extras::COMPARED).map_err(no_reference)?;
        let ladder = Ladder::halved(prepared.scene(), Self::LONGEST_STEP, Self::MOST_STEPS.into());
        let runs: Vec<_> = ladder
            .entries(prepared.scene())
            .filter(|(contender, _)| contender.knob == MethodSetting::TimeStep)
            .collect();
        let trials = parallel::each(&runs, |&(contender, step)| {
            let trial = trial(prepared, contender, step, &exact, goal.quantity);
            done(runs.len());
            Some((contender.key, trial?))
        });
        let rungs = |contender: &ComparedMethod| {
            let own = trials.iter().flatten().filter(|(key, _)| *key == contender.key);
            StepSizes::new(own.map(|(_, trial)| *trial).collect(), goal)
        };
        let methods = ComparedMethod::ALL.iter().map(rungs);
        Ok(Self {
            goal,
            exact: MethodTrial {
                name: "Exact",
                method: twin.method(),
                error: 0.0,
                worst: "",
                cost: whole(twin.price(exact.work, RunMode::Alone)),
            },
            methods: methods.filter(|rungs| !rungs.trials.is_empty()).collect(),
        })
    }
}

/// Rounds a cost.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "of a count of work, ≥ 0")]
fn whole(price: f64) -> u64 {
    price.round() as u64
}

/// Makes one run of the ladder; `None` if the scene refuses the step, such as a step beyond a limit of stability.
fn trial(prepared: &Simulation, contender: &ComparedMethod, step: f64, exact: &RunResult, quantity: QuantityGroup) -> Option<MethodTrial> {
    let method = (contender.method)(step);
    let prepared = prepared.with_method(method).ok()?;
    let (error, worst, cost) = match prepared.run_with(Extras::COMPARED) {
        Ok(outcome) => {
            let errors = RunErrors::between(&outcome, exact, &prepared);
            let (error, worst) = errors.largest(quantity);
            (error, worst, whole(prepared.price(outcome.work, RunMode::Alone)))
        }
        Err(_) => (f64::INFINITY, "run fails", 0),
    };
    Some(MethodTrial {
        name: contender.label,
        method,
        error,
        worst,
        cost,
    })
}
