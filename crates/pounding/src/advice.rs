//! The answer of `pounding advise`, as plain text.

use pounding::studies::{
    Advice, EVALUATIONS_PER_PIECE, LONGEST_STEP, MOST_STEPS, Prepared, Quantity, Trial, digits,
};

use crate::text::{NONE, paragraph, percent, short, table};

/// The recommended method, the line for the scene, and what every method would cost.
pub(crate) fn of(prepared: &Prepared, advice: &Advice) -> String {
    let best = advice.best();
    let goal = percent(advice.goal.error);
    let step = best.method.time_step().map_or(String::new(), |step| {
        format!(", time step {} s", digits(step))
    });
    let quantity = words(advice.goal.quantity);
    let why = if best.method == advice.exact.method {
        format!(
            "nothing cheaper keeps {quantity} within {goal};\ncost {}",
            best.cost
        )
    } else {
        let (error, ratio) = (of_trial(best), best.cost as f64 / advice.exact.cost as f64);
        format!(
            "the cheapest that keeps {quantity} within {goal}:\nlargest error {error}, cost {}, {ratio:.2} times that of \
             exact",
            best.cost
        )
    };
    let snippet = serde_json::to_string_pretty(&best.method).expect("a method is plain data");
    [
        paragraph("Use", &format!("{}{step}\n{why}", best.name)),
        format!("  \"method\": {}\n", snippet.replace('\n', "\n  ")),
        paragraph("Scene", &prepared.scene().name),
        methods(advice),
        paragraph("Notes", &notes()),
    ]
    .join("\n")
}

fn notes() -> String {
    format!(
        "Errors: the largest distance from the exact run, and in what.\nGoal met: at this step and at every shorter one \
         tried, of which there is at least one; the shortest step alone proves nothing, and stands here where the goal is \
         not met. Steps are halved from {LONGEST_STEP} s while a run has at most {MOST_STEPS} steps of \
         structures.\nCost: force evaluations; a piece of motion of the exact method counts as {EVALUATIONS_PER_PIECE}, which \
         is about the time it takes."
    )
}

/// A line per method: those that meet the goal by their cost, then the others.
fn methods(advice: &Advice) -> String {
    let header = [
        ["Method", ""],
        ["Goal", "met"],
        ["Step", "[ms]"],
        ["Error", ""],
        ["in", ""],
        ["Cost", ""],
    ];
    let mut trials = vec![(&advice.exact, true)];
    trials.extend(advice.methods.iter().filter_map(|rungs| {
        let chosen = rungs.chosen();
        Some((chosen.or(rungs.trials.last())?, chosen.is_some()))
    }));
    trials.sort_by_key(|(trial, meets)| (!meets, trial.cost));
    let row = |(trial, meets): &(&Trial, bool)| {
        let step = trial.method.time_step();
        vec![
            trial.name.into(),
            if *meets { "yes" } else { "no" }.into(),
            step.map_or(NONE.into(), |step| short(1e3 * step)),
            if trial.method == advice.exact.method {
                "rounding".into()
            } else {
                percent(trial.error)
            },
            trial.worst.into(),
            trial.cost.to_string(),
        ]
    };
    table(&header, &trials.iter().map(row).collect::<Vec<_>>())
}

/// Error of a run and in what it is largest.
fn of_trial(trial: &Trial) -> String {
    let error = percent(trial.error);
    if trial.worst.is_empty() {
        error
    } else {
        format!("{error} ({})", trial.worst)
    }
}

fn words(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Momentum => "transferred momenta",
        Quantity::Displacement => "peak displacements",
        Quantity::Force => "peak forces",
        Quantity::Impulse => "impulses",
        Quantity::Time => "times of first collisions",
        Quantity::All => "all printed numbers",
    }
}
