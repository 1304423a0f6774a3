//! Which method and time step reach an accuracy at the least work.

use pounding_solver::{ImpactRule, Start, VerletImpacts, Work};
use rayon::prelude::*;

use crate::{Method, Outcome, Prepared, Quantity, RunErrors, StudyError};

/// Longest time step of the ladder \[s\]; each next one is half as long.
pub const LONGEST_STEP: f64 = 0.01;
/// Most force evaluations of one run of the ladder.
///
/// The time steps of a method end where the next run would cost more: at 40 µs for two structures and 20 s, 0.1 to
/// 0.5 s of computing a run.
pub const WORK_BUDGET: u64 = 2_000_000;

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
    /// Method with its step.
    pub method: Method,
    /// Largest error \[–\] of the quantity; infinite where the run ended early or the numbers of collisions differ.
    pub error: f64,
    /// What has the largest error; empty for the exact method.
    pub worst: &'static str,
    /// Force evaluations and structure-segment propagations.
    pub cost: u64,
}

/// A method on the ladder, from the longest time step to the shortest.
#[derive(Debug, Clone, PartialEq)]
pub struct Rungs {
    /// Its runs; none where no time step is both stable and within the budget.
    pub trials: Vec<Trial>,
    /// Index of the longest time step from which on every run meets the goal; the shortest only confirms.
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
    /// The run with the longest time step from which on every run meets the goal.
    pub fn chosen(&self) -> Option<&Trial> {
        self.meets.map(|index| &self.trials[index])
    }
}

/// Force evaluations and structure-segment propagations of a run.
pub fn cost(work: Work) -> u64 {
    work.force_evaluations + work.segments
}

/// Number of methods that [`advise`] tries on this scene; `done` is called once for each.
pub fn n_methods(prepared: &Prepared) -> usize {
    methods(prepared).len()
}

/// Runs a scene, whatever its method, with every method on a ladder of time steps; `done` is called after each method.
///
/// # Errors
/// [`StudyError`] where the exact method, the measure of the others, ends early.
pub fn advise(
    prepared: &Prepared,
    goal: Goal,
    done: &(impl Fn() + Sync),
) -> Result<Advice, StudyError> {
    let twin = prepared.exact()?;
    let exact = twin.run(None)?;
    let methods = methods(prepared)
        .into_par_iter()
        .map(|method| {
            let rungs = rungs(prepared, method, &exact, goal);
            done();
            rungs
        })
        .collect();
    Ok(Advice {
        goal,
        exact: Trial {
            method: twin.method(),
            error: 0.0,
            worst: "",
            cost: cost(exact.work),
        },
        methods,
    })
}

/// Runs one method on the ladder.
fn rungs(prepared: &Prepared, method: Method, exact: &Outcome, goal: Goal) -> Rungs {
    let duration = prepared.duration();
    // 0.01 s, or the next shorter step of which the duration is a whole number.
    let longest = duration / (duration / LONGEST_STEP - 1e-6).ceil().max(1.0);
    let mut trials: Vec<Trial> = Vec::new();
    let mut step = longest;
    // An implicit method may be refused or fail at long steps only; a budget ends the ladder of the others.
    while cheapest(prepared, step) <= WORK_BUDGET {
        let method = method.with_time_step(step);
        if let Ok(prepared) = prepared.with_method(method) {
            let trial = trial(&prepared, method, exact, goal);
            let over = 2 * trial.cost > WORK_BUDGET;
            trials.push(trial);
            if over {
                break;
            }
        }
        step *= 0.5;
    }
    let missed = trials.iter().rposition(|trial| trial.error > goal.error);
    let meets = missed.map_or(0, |index| index + 1);
    Rungs {
        meets: (meets + 1 < trials.len()).then_some(meets),
        trials,
    }
}

fn trial(prepared: &Prepared, method: Method, exact: &Outcome, goal: Goal) -> Trial {
    let Ok(outcome) = prepared.run(None) else {
        return Trial {
            method,
            error: f64::INFINITY,
            worst: "run ends early",
            cost: 0,
        };
    };
    let (error, worst) =
        RunErrors::between(&outcome, exact, &prepared.walls()).largest(goal.quantity);
    Trial {
        method,
        error,
        worst,
        cost: cost(outcome.work),
    }
}

/// One force evaluation a step and structure: no method costs less.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a conversion to an integer keeps to its range"
)]
fn cheapest(prepared: &Prepared, step: f64) -> u64 {
    let steps = (prepared.duration() / step).round() as u64;
    steps.saturating_mul(prepared.walls().len() as u64)
}

/// Every method with its usual settings; rules of impulsive contact only where a pair has it.
fn methods(prepared: &Prepared) -> Vec<Method> {
    let time_step_s = LONGEST_STEP;
    let central_difference = |impacts| Method::CentralDifference {
        time_step_s,
        start: Start::Consistent,
        impacts,
        contact_substeps: 1,
    };
    let verlet = |impacts| Method::VelocityVerlet {
        time_step_s,
        impacts,
    };
    let mut methods = vec![
        central_difference(ImpactRule::AsPublished),
        Method::Newmark {
            time_step_s,
            beta: 0.25,
            gamma: 0.5,
        },
        Method::Hht {
            time_step_s,
            alpha: -0.1,
        },
        verlet(VerletImpacts::VelocityJump),
        Method::Rk4 { time_step_s },
        Method::MoreauJean {
            time_step_s,
            theta: 0.5,
        },
    ];
    if prepared.has_impulsive_contact() {
        methods.insert(1, central_difference(ImpactRule::VelocityJump));
        methods.insert(5, verlet(VerletImpacts::Located));
    }
    methods
}
