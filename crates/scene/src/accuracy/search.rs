//! The search for the method and time step that reach an accuracy at the least cost.

use crate::accuracy::ladder::{Ladder, entries};
use crate::accuracy::methods::{COMPARED_METHODS, ComparedMethod, Knob};
use crate::accuracy::price::Going;
use crate::{Advice, Error, Extras, Goal, QuantityGroup, RunErrors, RunResult, Simulation, StepSizes, Trial, parallel};
use pounding_text::Refused;

/// Longest time step of the ladder \[s\]; each next one is half as long.
pub const LONGEST_STEP: f64 = 0.01;
/// Most steps of structures in one run of the ladder: two structures and 20 s come to 80 µs.
///
/// The exact method does with some thousand pieces what a stepping method would need the finer steps for.
pub const MOST_STEPS: u32 = 500_000;

/// The exact run failed, by which others were to be measured.
fn no_reference(error: Error) -> Error {
    error.said(|refused| {
        let fails = Refused::that("the exact run, by which every method is measured, fails: ").and(&refused);
        fails.kind(refused.own_kind())
    })
}

/// Runs a scene, whatever its method, with every method of the trade on a ladder of time steps; `done` is called after
/// each run with the number of runs.
///
/// # Errors
/// Says so where the exact method, the measure of the others, fails.
pub fn advise(prepared: &Simulation, goal: Goal, done: &(dyn Fn(usize) + Sync)) -> Result<Advice, Error> {
    let twin = prepared.exact()?;
    let exact = twin.run_with(Extras::COMPARED).map_err(no_reference)?;
    let ladder = Ladder::halved(prepared.scene(), LONGEST_STEP, MOST_STEPS.into());
    let runs: Vec<_> = entries(prepared.scene(), &ladder)
        .filter(|(contender, _)| contender.knob == Knob::TimeStep)
        .collect();
    let trials = parallel::each(&runs, |&(contender, step)| {
        let trial = trial(prepared, (contender, step), &exact, goal.quantity);
        done(runs.len());
        Some((contender.key, trial?))
    });
    let rungs = |contender: &ComparedMethod| {
        let own = trials.iter().flatten().filter(|(key, _)| *key == contender.key);
        StepSizes::new(own.map(|(_, trial)| *trial).collect(), goal)
    };
    let methods = COMPARED_METHODS.iter().map(rungs);
    Ok(Advice {
        goal,
        exact: Trial {
            name: "Exact",
            method: twin.method(),
            error: 0.0,
            worst: "",
            cost: whole(twin.price(exact.work, Going::Alone)),
        },
        methods: methods.filter(|rungs| !rungs.trials.is_empty()).collect(),
    })
}

/// A price, rounded.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "of a count of work, ≥ 0")]
fn whole(price: f64) -> u64 {
    price.round() as u64
}

/// One run of the ladder; nothing where the scene refuses the step, such as one beyond a limit of stability.
fn trial(prepared: &Simulation, (contender, step): (&ComparedMethod, f64), exact: &RunResult, quantity: QuantityGroup) -> Option<Trial> {
    let method = (contender.method)(step);
    let prepared = prepared.with_method(method).ok()?;
    let (error, worst, cost) = match prepared.run_with(Extras::COMPARED) {
        Ok(outcome) => {
            let errors = RunErrors::between(&outcome, exact, &prepared);
            let (error, worst) = errors.largest(quantity);
            (error, worst, whole(prepared.price(outcome.work, Going::Alone)))
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
