//! What happened in a scene, and how far each number is from the exact run, as plain text.

use pounding::solver::{Collision, ImpactRule, SimultaneousImpacts, Start, VerletImpacts, Work};
use pounding::studies::{
    Errors, Method, Outcome, PairErrors, PairOutcome, Prepared, Quantity, Review, RunErrors, Scene,
    Structure, StructureErrors, Warning, digits,
};

use crate::record;
use crate::text::{NONE, milliseconds, paragraph, percent, short, table};

/// Summary of a run.
pub(crate) fn of(prepared: &Prepared, review: &Review) -> String {
    let scene = prepared.scene();
    let Review {
        outcome, errors, ..
    } = review;
    let measured = review.measured();
    [
        paragraph("Scene", &scene.name),
        paragraph("Record", &record::lines(prepared).join("\n")),
        paragraph("Method", &method_lines(prepared)),
        structures(scene, outcome, measured),
        pairs(scene, outcome, measured),
        paragraph("Errors", &error_lines(scene, errors)),
        warnings(&of_run(&review.warnings)),
        paragraph("Work", &work_lines(&scene.method, outcome.work, errors)),
    ]
    .join("\n")
}

/// What a user should know before believing the numbers.
pub(crate) fn warnings(found: &[String]) -> String {
    if found.is_empty() {
        paragraph("Warnings", "none")
    } else {
        paragraph("Warnings", &found.join("\n"))
    }
}

/// The warnings of a run, and what helps.
fn of_run(warnings: &[Warning]) -> Vec<String> {
    let mut lines: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    let is_error = |one: &Warning| matches!(one, Warning::Error { .. });
    if warnings.iter().any(is_error) {
        lines.push("`pounding advise SCENE --error 3%` finds a method and time step".into());
    }
    lines
}

/// The method, its settings and how it was chosen.
pub(crate) fn method_lines(prepared: &Prepared) -> String {
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
            format!("\nchosen: nothing cheaper keeps all errors below {goal}")
        } else {
            format!(
                "\nchosen: the cheapest that keeps all errors below {goal}; its largest is {} ({})",
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
        Errors::NotMeasured => "not measured (--no-error)".into(),
        Errors::Unknown(reason) => format!("not known, the exact run fails: {reason}"),
        Errors::Measured(errors, _) => {
            let (largest, of) = errors.largest(Quantity::All);
            let largest = match largest {
                0.0 => "there is none".into(),
                largest if largest.is_finite() => {
                    format!("the largest is {} ({of})", percent(largest))
                }
                _ if errors.pairs.iter().any(PairErrors::differ) => {
                    "the numbers of collisions differ".into()
                }
                _ => format!("the exact run has no {of}, or this run has none"),
            };
            format!("below each number, its distance from the exact run;\n{largest}")
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
        Errors::Exact | Errors::NotMeasured | Errors::Unknown(_) => own,
    }
}

/// Settings of a method in words, each after a comma.
fn settings(method: &Method) -> String {
    match *method {
        Method::CentralDifference {
            start,
            impacts,
            contact_substeps,
            ..
        } => {
            let impacts = match impacts {
                ImpactRule::AsPublished => "",
                ImpactRule::VelocityJump => ", impacts: velocity jump",
            };
            let substeps = match contact_substeps {
                1 => String::new(),
                n => format!(",\n{n} sub-steps while touching"),
            };
            format!(", start: {}{impacts}{substeps}", words(start))
        }
        Method::Newmark { beta, gamma, .. } => {
            format!(", β = {}, γ = {}", short(beta), short(gamma))
        }
        Method::Hht { alpha, .. } => format!(", α = {}", short(alpha)),
        Method::VelocityVerlet { impacts, .. } => match impacts {
            VerletImpacts::VelocityJump => ", impacts: velocity jump".into(),
            VerletImpacts::Located => ", impacts: located".into(),
        },
        Method::Rk4 { .. } | Method::Accuracy(_) => String::new(),
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

/// How a run of the central difference method begins, in words.
fn words(start: Start) -> &'static str {
    match start {
        Start::Consistent => "consistent",
        Start::FirstLoadUsed => "first load used",
        Start::FirstLoadSkipped => "first load skipped",
    }
}

fn structures(scene: &Scene, outcome: &Outcome, errors: Option<&RunErrors>) -> String {
    let header = [
        ["Structure", "", ""],
        ["Period", "[s]", ""],
        ["Damping", "ratio", ""],
        ["Peak", "displ.", "[mm]"],
        ["at", "[s]", ""],
        ["Peak", "shear", "[kN]"],
        ["Ductility", "", ""],
        ["Transf.", "momentum", "[kN·s]"],
    ];
    let rows = scene
        .structures
        .iter()
        .enumerate()
        .flat_map(|(index, structure)| {
            let errors = errors.map(|errors| structure_errors(errors.structures[index], structure));
            std::iter::once(structure_row(structure, index, outcome)).chain(errors)
        });
    table(&header, &rows.collect::<Vec<_>>())
}

fn structure_row(structure: &Structure, index: usize, outcome: &Outcome) -> Vec<String> {
    let momentum = short(outcome.momentum.of(index) / 1e3);
    let Structure::Sdof(sdof) = structure else {
        let mut row = vec![structure.name().to_string()];
        row.resize(7, NONE.into());
        row.push(momentum);
        return row;
    };
    let peaks = outcome.peaks.of(index);
    vec![
        sdof.name.clone(),
        short(sdof.period()),
        short(sdof.damping_ratio()),
        short(peaks.displacement.value * 1e3),
        // To a tenth of a millisecond: the line must fit.
        digits((peaks.displacement.time * 1e4).round() * 1e-4),
        short(peaks.restoring_force.value / 1e3),
        sdof.ductility(peaks.displacement.value)
            .map_or_else(|| NONE.into(), short),
        momentum,
    ]
}

/// The errors of a structure, for the line below it.
fn structure_errors(errors: StructureErrors, structure: &Structure) -> Vec<String> {
    let wall = matches!(structure, Structure::Wall);
    let peak = |text: String| if wall { String::new() } else { text };
    let yields = matches!(structure, Structure::Sdof(sdof) if sdof.yield_force_n.is_some());
    vec![
        ERROR.into(),
        String::new(),
        String::new(),
        peak(percent(errors.displacement)),
        peak(milliseconds(errors.displacement_time)),
        peak(percent(errors.restoring_force)),
        // A ductility is a peak displacement over a given one.
        if yields {
            percent(errors.displacement)
        } else {
            String::new()
        },
        percent(errors.momentum),
    ]
}

/// Begins a line of errors.
const ERROR: &str = "  error";

fn pairs(scene: &Scene, outcome: &Outcome, errors: Option<&RunErrors>) -> String {
    let Some(contacts) = scene
        .contacts
        .as_ref()
        .filter(|contacts| !contacts.is_empty())
    else {
        return paragraph("Pairs", "none: no structure can touch another");
    };
    let header = [
        ["Pair", "", ""],
        ["Gap", "[mm]", ""],
        ["Collisions", "", ""],
        ["First", "[s]", ""],
        ["First", "impulse", "[kN·s]"],
        ["Largest", "impulse", "[kN·s]"],
        ["Peak", "force", "[kN]"],
    ];
    let rows = contacts.iter().enumerate().flat_map(|(index, contact)| {
        let [left, right] = [index, index + 1].map(|index| scene.structures[index].name());
        let mut row = vec![format!("{left} – {right}"), digits(contact.gap_m * 1e3)];
        row.extend(pair_numbers(&outcome.of_pair(index)));
        let errors = errors.map(|errors| pair_errors(&errors.pairs[index]));
        std::iter::once(row).chain(errors)
    });
    table(&header, &rows.collect::<Vec<_>>())
}

/// Collisions of a pair: number, time and impulse of the first, largest impulse and force.
fn pair_numbers(pair: &PairOutcome) -> [String; 5] {
    let impulse = |one: Option<Collision>| one.map_or(NONE.into(), |one| short(one.impulse / 1e3));
    [
        pair.collisions.to_string(),
        pair.first.map_or(NONE.into(), |first| digits(first.start)),
        impulse(pair.first),
        impulse(pair.largest),
        match pair.peak_force {
            None if pair.collisions == 0 => NONE.into(),
            None => "impulsive".into(),
            Some(force) => short(force / 1e3),
        },
    ]
}

/// The errors of a pair, for the line below it.
fn pair_errors(errors: &PairErrors) -> Vec<String> {
    let relative = |error: Option<f64>| error.map_or(String::new(), percent);
    vec![
        ERROR.into(),
        String::new(),
        if errors.rests {
            "rests".into()
        } else if errors.differ() {
            format!("exact {}", errors.collisions.1)
        } else {
            "equal".into()
        },
        errors.first_time.map_or(String::new(), milliseconds),
        relative(errors.first_impulse),
        relative(errors.largest_impulse),
        relative(errors.peak_force),
    ]
}
