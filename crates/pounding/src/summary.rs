//! What happened in a scene, and how far each number is from the exact run, as plain text.

mod brief;
pub(crate) mod direction;
mod tables;

use pounding::report::Shown;
use pounding::scene::{Errors, Implausible, Method, PairErrors, QuantityGroup, Review, RunValues, Scene, Simulation, Warning};
use pounding::solver::{SimultaneousImpacts, VerletImpacts, Work};
use pounding::text::digits;

use crate::record;
use crate::text::{self, paragraph, percent, short};

/// What looks wrong in a scene, which stands before its answer.
pub(crate) fn unusual(prepared: &Simulation) -> Option<String> {
    let doubts = prepared.doubts();
    text::unusual(&Implausible::gathered(doubts.iter().map(|one| ("", one))))
}

/// What matters of a run: a screen of it. `notices` is what to know before believing it.
pub(crate) fn brief(prepared: &Simulation, review: &Review, notices: &[String]) -> String {
    joined([
        brief::scene(prepared, review),
        brief::pairs(prepared, &review.outcome),
        tables::leaning(prepared.floors(), &review.outcome),
        brief::buildings(prepared, &review.outcome),
        warnings(&with_advice(review, notices), prepared),
        brief::more(),
    ])
}

/// Everything that is printed of a run.
pub(crate) fn details(prepared: &Simulation, review: &Review, notices: &[String]) -> String {
    let scene = prepared.scene();
    let Review { outcome, errors, .. } = review;
    let (floors, shown) = (prepared.floors(), Shown::of(prepared, review));
    joined([
        paragraph("Scene", &scene.name),
        paragraph("Record", &record::lines(prepared).join("\n")),
        paragraph("Method", &method_lines(prepared)),
        tables::structures(floors, &shown),
        tables::motions(floors, &shown),
        tables::storeys(floors, &shown),
        tables::pairs(prepared, outcome, &shown),
        paragraph("Errors", &error_lines(scene, errors)),
        warnings(&with_advice(review, notices), prepared),
        paragraph("Work", &work_lines(&scene.method, outcome.work, errors)),
    ])
}

/// Parts with a line between them, without those that are empty.
fn joined<const PARTS: usize>(parts: [String; PARTS]) -> String {
    let parts = parts.into_iter().filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join("\n")
}

/// What a user should know before believing the numbers; what is unusual was said before them.
fn warnings(found: &[String], prepared: &Simulation) -> String {
    let text = if !found.is_empty() {
        found.join("\n")
    } else if prepared.doubts().is_empty() {
        "none".into()
    } else {
        "none besides what is unusual".into()
    };
    paragraph("Warnings", &text)
}

/// What to know before using a run, and what helps.
fn with_advice(review: &Review, notices: &[String]) -> Vec<String> {
    let is_error = |one: &Warning| matches!(one, Warning::Error { .. });
    let advice = review.warnings.iter().any(is_error);
    let advice = advice.then(|| "`pounding advise SCENE --error 3%` finds a method and time step".into());
    notices.iter().cloned().chain(advice).collect()
}

/// What is said of a method that was looked for.
const SEARCHED: &str = "looking for it took the exact run and many others, so that for one run it saves nothing";

/// The method, its settings and how it was chosen.
pub(crate) fn method_lines(prepared: &Simulation) -> String {
    let scene = prepared.scene();
    let method = scene.method;
    let duration = digits(prepared.duration());
    let steps = method
        .time_step()
        .map_or(String::new(), |dt| format!(" in steps of {} s", digits(dt)));
    let chosen = prepared.advice().map_or(String::new(), |advice| {
        let goal = percent(advice.goal.error);
        let best = advice.best();
        if best.method == advice.exact.method {
            format!("\nchosen: nothing cheaper keeps all errors below {goal}; {SEARCHED}")
        } else {
            format!(
                "\nchosen: the cheapest that keeps all errors below {goal}; its largest is {} ({}); {SEARCHED}",
                percent(best.error),
                best.worst
            )
        }
    });
    format!(
        "{}{};\n{duration} s{steps}{chosen}",
        method.name().replace('_', " "),
        settings(&method)
    )
}

/// What is known of the errors.
fn error_lines(scene: &Scene, errors: &Errors) -> String {
    match errors {
        Errors::Exact => match scene.method {
            Method::Exact { tolerance, .. } if tolerance > 1e-16 => {
                format!("that of the tolerance, {tolerance:e} per piece in compliant contact")
            }
            Method::Exact { .. }
            | Method::CentralDifference { .. }
            | Method::Newmark { .. }
            | Method::Hht { .. }
            | Method::VelocityVerlet { .. }
            | Method::Rk4 { .. }
            | Method::MoreauJean { .. }
            | Method::Accuracy(_) => "none beyond rounding: the method is exact".into(),
        },
        Errors::Doubtful => "not known: the method is exact, but this run has gone wrong (see the warnings)".into(),
        Errors::NotMeasured => "not measured (--no-error)".into(),
        Errors::Unknown(reason) => format!("not known, the exact run fails: {reason}"),
        Errors::Measured(errors, _) => {
            let (largest, of) = errors.largest(QuantityGroup::All);
            let largest = match largest {
                0.0 => "there is none".into(),
                largest if largest.is_finite() => {
                    format!("the largest is {} ({of})", percent(largest))
                }
                _ if errors.pairs().iter().any(PairErrors::differ) => "the numbers of collisions differ".into(),
                _ => format!("the exact run has no {of}, or this run has none"),
            };
            format!(
                "below each number, its distance from the exact run; that of a residual below {} of the peak is relative to {0} \
                 of it;\n{largest}",
                percent(RunValues::LEAST_PART)
            )
        }
    }
}

/// What the run cost, and the exact one beside it.
fn work_lines(method: &Method, work: Work, errors: &Errors) -> String {
    let exact = |work: Work| format!("{} pieces of motion, {} events", work.segments, work.events);
    let own = if method.time_step().is_none() {
        exact(work)
    } else {
        format!(
            "{} steps, {} force evaluations,\n{} Newton iterations, {} steps in contact",
            work.steps, work.force_evaluations, work.newton_iterations, work.touching_steps
        )
    };
    match errors {
        Errors::Measured(_, work) => format!("{own};\nexact run: {}", exact(*work)),
        Errors::Exact | Errors::Doubtful | Errors::NotMeasured | Errors::Unknown(_) => own,
    }
}

/// Settings of a method in words, each after a comma.
fn settings(method: &Method) -> String {
    match *method {
        Method::CentralDifference { contact_substeps: 1, .. } | Method::Rk4 { .. } | Method::Accuracy(_) => String::new(),
        Method::CentralDifference { contact_substeps, .. } => format!(",\n{contact_substeps} sub-steps while touching"),
        Method::Newmark { beta, gamma, .. } => {
            format!(", β = {}, γ = {}", short(beta), short(gamma))
        }
        Method::Hht { alpha, .. } => format!(", α = {}", short(alpha)),
        Method::VelocityVerlet { impacts, .. } => match impacts {
            VerletImpacts::VelocityJump => ", impacts: velocity jump".into(),
            VerletImpacts::Located => ", impacts: located".into(),
        },
        Method::MoreauJean { theta, .. } => format!(", θ = {}", short(theta)),
        Method::Exact {
            tolerance,
            simultaneous_impacts,
        } => {
            let together = match simultaneous_impacts {
                SimultaneousImpacts::Together => "",
                SimultaneousImpacts::Sequential => ", simultaneous impacts: sequential",
            };
            format!(", tolerance {tolerance:e}{together}")
        }
    }
}
