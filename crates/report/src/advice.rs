//! The cheapest method and time step for an accuracy, for people and for programs.

use pounding_scene::{Advice, MethodTrial, QuantityGroup, RunErrors, Simulation, StepSizes};
use pounding_text::{Answer, Grid, Part, Table, Where, digits, percent, short};
use serde_json::{Value, json};

/// The recommended method, and what every method would cost; `snippet` is the method in the words of the scene's file.
pub fn advice_answer(prepared: &Simulation, advice: &Advice, snippet: String) -> Answer<'static> {
    let rungs = |rungs: &StepSizes| {
        json!({
            "chosen": rungs.chosen().map(trial_json),
            "trials": rungs.trials.iter().map(trial_json).collect::<Vec<_>>(),
        })
    };
    Answer::new()
        .say(Where::Terminal, "Use", recommended(advice).into())
        .part(Where::Terminal, Part::Markup(snippet))
        .say(Where::Terminal, "Scene", vec![prepared.scene().name.clone()])
        .table(Where::Terminal, methods(advice))
        .say(
            Where::Terminal,
            "Notes",
            notes(prepared).into_iter().chain(known(prepared, advice.goal.error)).collect(),
        )
        .fact("scene", json!(prepared.scene()))
        .fact("goal", json!({"error": advice.goal.error, "quantity": advice.goal.quantity.name()}))
        .fact("use", trial_json(advice.best()))
        .fact("exact", trial_json(&advice.exact))
        .fact("methods", advice.methods.iter().map(rungs).collect::<Vec<_>>())
}

/// A run for programs; its error is null if it failed or if the numbers of collisions differ.
fn trial_json(trial: &MethodTrial) -> Value {
    json!({
        "name": trial.name,
        "method": trial.method,
        "error": trial.error.is_finite().then_some(trial.error),
        "worst": trial.worst,
        "cost": trial.cost,
    })
}

/// The method and its time step, why it is recommended, and what it costs.
fn recommended(advice: &Advice) -> [String; 3] {
    let (best, goal) = (advice.best(), percent(advice.goal.error));
    let step = best.method.time_step();
    let step = step.map_or_else(String::new, |step| format!(", time step {} s", digits(step)));
    let (quantity, use_this) = (words(advice.goal.quantity), format!("{}{step}", best.name));
    if best.method == advice.exact.method {
        return [
            use_this,
            format!("nothing cheaper keeps {quantity} within {goal};"),
            format!("cost {}", best.cost),
        ];
    }
    let worst = if best.worst.is_empty() {
        String::new()
    } else {
        format!(" ({})", best.worst)
    };
    let (error, ratio) = (percent(best.error), best.cost as f64 / advice.exact.cost as f64);
    [
        use_this,
        format!("the cheapest that keeps {quantity} within {goal}:"),
        format!("largest error {error}{worst}, cost {}, {ratio:.2} times that of exact", best.cost),
    ]
}

/// What the record leaves open between its samples, if that is more than the accuracy asked for.
fn known(prepared: &Simulation, accuracy: f64) -> Option<String> {
    // A run that fails is told by the trials.
    let run = prepared.run(None).ok()?;
    let between = prepared.between_samples(&run)?.ok()?;
    (between.largest() > accuracy)
        .then(|| format!("Record: {between}. An accuracy below that is one of the method, and not of the earthquake."))
}

fn notes(prepared: &Simulation) -> [String; 3] {
    [
        format!(
            "Errors: the largest distance from the exact run, and in what; {}.",
            RunErrors::MEASURE
        ),
        format!(
            "Goal met: at this step and at every shorter one tried, of which there is at least one; the shortest step alone proves nothing, \
             and stands here where the goal is not met. Steps are halved from {} s while a run has at most {} steps of \
             structures.",
            Advice::LONGEST_STEP,
            Advice::MOST_STEPS
        ),
        format!(
            "Cost: force evaluations; a piece of motion of the exact method counts as {} here, which is about the time it takes.",
            prepared.evaluations_per_piece()
        ),
    ]
}

/// A row for each method: those that meet the goal by their cost, then the others.
fn methods(advice: &Advice) -> Grid {
    let tried = advice.methods.iter().filter_map(|rungs| {
        let chosen = rungs.chosen();
        Some((chosen.or(rungs.trials.last())?, chosen.is_some()))
    });
    let mut trials: Vec<(&MethodTrial, bool)> = std::iter::once((&advice.exact, true)).chain(tried).collect();
    trials.sort_by_key(|(trial, meets)| (!meets, trial.cost));
    Table::of(trials)
        .shown("Method", |(trial, _)| trial.name)
        .shown("Goal met", |(_, meets)| if *meets { "yes" } else { "no" })
        .shown_in("ms", "Step", |(trial, _)| trial.method.time_step().map(|step| short(1e3 * step)))
        .shown("Error", |(trial, _)| {
            let is_exact = trial.method == advice.exact.method;
            if is_exact { "rounding".into() } else { percent(trial.error) }
        })
        .shown("in", |(trial, _)| trial.worst)
        .shown("Cost", |(trial, _)| trial.cost.to_string())
        .grid()
}

fn words(quantity: QuantityGroup) -> &'static str {
    match quantity {
        QuantityGroup::Momentum => "transferred momenta",
        QuantityGroup::Displacement => "displacements and drifts",
        QuantityGroup::Acceleration => "peak accelerations",
        QuantityGroup::Force => "peak forces",
        QuantityGroup::Impulse => "impulses",
        QuantityGroup::Time => "times of collisions",
        QuantityGroup::All => "all numbers (see Notes)",
    }
}
