//! The answer of `pounding advise`, as plain text.

use pounding::studies::{Advice, Method, Prepared, Quantity, Trial, WORK_BUDGET, digits};

use crate::text::{NONE, paragraph, percent, table};

/// The recommended method, the line for the scene, and what every method would cost.
pub(crate) fn of(prepared: &Prepared, advice: &Advice) -> String {
    let best = advice.best();
    let is_exact = best.method == advice.exact.method;
    let goal = percent(advice.goal.error);
    let step = best.method.time_step().map_or(String::new(), |step| {
        format!(", time step {} s", digits(step))
    });
    let why = if is_exact {
        format!(
            "nothing cheaper keeps {} within {goal}",
            words(advice.goal.quantity)
        )
    } else {
        format!(
            "the cheapest that keeps {} within {goal}:\nlargest error {}, work {}, {} times that of exact",
            words(advice.goal.quantity),
            of_trial(best),
            best.cost,
            ratio(best, advice)
        )
    };
    let snippet = serde_json::to_string_pretty(&best.method).expect("a method is plain data");
    [
        paragraph("Use", &format!("{}{step}\n{why}", name(&best.method))),
        format!("  \"method\": {}\n", snippet.replace('\n', "\n  ")),
        paragraph("Scene", &prepared.scene().name),
        methods(advice),
        paragraph(
            "Notes",
            &format!(
                "Errors are distances from the exact run. A method meets an error at a step when it does so at every \
                 shorter step tried too, at least one; else its shortest step stands here. Steps are halved from \
                 0.01 s up to a work of {WORK_BUDGET} a run.\nWork: force evaluations and pieces of motion of \
                 a structure."
            ),
        ),
    ]
    .join("\n")
}

fn methods(advice: &Advice) -> String {
    let header = [
        ["Method", "", ""],
        ["Meets", "", ""],
        ["Step", "[s]", ""],
        ["Error", "", ""],
        ["Work", "", ""],
        ["Times", "exact", ""],
    ];
    let row = |trial: &Trial, meets: bool| {
        vec![
            name(&trial.method),
            if meets { "yes" } else { "no" }.into(),
            trial.method.time_step().map_or(NONE.into(), digits),
            of_trial(trial),
            trial.cost.to_string(),
            ratio(trial, advice),
        ]
    };
    let mut rows = vec![row(&advice.exact, true)];
    rows.extend(advice.methods.iter().filter_map(|rungs| {
        let chosen = rungs.chosen();
        Some(row(chosen.or(rungs.trials.last())?, chosen.is_some()))
    }));
    table(&header, &rows)
}

/// Error of a run and where it is largest.
fn of_trial(trial: &Trial) -> String {
    if trial.worst.is_empty() {
        "rounding".into()
    } else if trial.error.is_finite() {
        format!("{} ({})", percent(trial.error), trial.worst)
    } else {
        trial.worst.into()
    }
}

/// Work relative to the exact run's.
fn ratio(trial: &Trial, advice: &Advice) -> String {
    #[expect(clippy::cast_precision_loss, reason = "two digits are shown")]
    let ratio = trial.cost as f64 / advice.exact.cost as f64;
    if ratio < 10.0 {
        format!("{ratio:.2}")
    } else {
        format!("{ratio:.0}")
    }
}

/// Name of a method with the rule that tells it from its like.
fn name(method: &Method) -> String {
    let name = method.name().replace('_', " ");
    match *method {
        Method::CentralDifference { impacts, .. } if impacts != Default::default() => {
            format!("{name}, jump")
        }
        Method::VelocityVerlet { impacts, .. } if impacts != Default::default() => {
            format!("{name}, located")
        }
        Method::CentralDifference { .. }
        | Method::Newmark { .. }
        | Method::Hht { .. }
        | Method::VelocityVerlet { .. }
        | Method::Rk4 { .. }
        | Method::MoreauJean { .. }
        | Method::Exact { .. }
        | Method::Accuracy(_) => name,
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
