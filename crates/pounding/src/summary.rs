//! What happened in a scene, and how far each number is from the exact run, as plain text.

use pounding::solver::{Collision, ImpactRule, SimultaneousImpacts, Start, VerletImpacts, Work};
use pounding::studies::{
    Contact, Doubt, Errors, Floor, Floors, Method, Outcome, PairErrors, PairOutcome, Prepared,
    Quantity, Review, RunErrors, Scene, StructureErrors, Warning, digits,
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
        structures(prepared, outcome, measured),
        motions(prepared, outcome, measured),
        storeys(prepared.floors(), outcome, measured),
        pairs(prepared, outcome, measured),
        paragraph("Errors", &error_lines(scene, errors)),
        unusual(prepared),
        warnings(&of_run(&review.warnings)),
        paragraph("Work", &work_lines(&scene.method, outcome.work, errors)),
    ]
    .into_iter()
    .filter(|part| !part.is_empty())
    .collect::<Vec<_>>()
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

/// What looks wrong in the scene, a line each; nothing where nothing does.
fn unusual(prepared: &Prepared) -> String {
    let mut lines: Vec<String> = prepared.doubts().iter().map(Doubt::brief).collect();
    if lines.is_empty() {
        return String::new();
    }
    lines.push("`pounding check SCENE` says what is usual".into());
    paragraph("Unusual", &lines.join("\n"))
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

fn structures(prepared: &Prepared, outcome: &Outcome, errors: Option<&RunErrors>) -> String {
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
    let floors = prepared.floors().all().iter().enumerate();
    let rows = floors.flat_map(|(index, floor)| {
        let errors = errors.map(|errors| structure_errors(errors.structures[index], floor));
        let row = structure_row((prepared.scene(), floor), index, outcome);
        std::iter::once(row).chain(errors)
    });
    table(&header, &rows.collect::<Vec<_>>())
}

/// What is left of the motion at the end, and what stands on the floors felt of it; nothing of walls.
fn motions(prepared: &Prepared, outcome: &Outcome, errors: Option<&RunErrors>) -> String {
    let header = [
        ["Structure", "", ""],
        ["Residual", "at end", "[mm]"],
        ["Peak abs.", "accel.", "[g]"],
        ["at", "[s]", ""],
    ];
    let gravity = prepared.scene().record.gravity_m_per_s2;
    let floors = prepared.floors().all().iter().enumerate();
    let moving = floors.filter(|(_, floor)| !floor.is_wall());
    let rows = moving.flat_map(|(index, floor)| {
        let peak = outcome.accelerations[index];
        let row = vec![
            floor.name.clone(),
            short(1e3 * outcome.last.of(index)),
            short(peak.value / gravity),
            instant(peak.time),
        ];
        let error = |errors: &RunErrors| {
            let errors = &errors.structures[index];
            vec![
                ERROR.into(),
                percent(errors.last_displacement),
                percent(errors.acceleration),
                String::new(),
            ]
        };
        std::iter::once(row).chain(errors.map(error))
    });
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header, &rows)
}

/// To a tenth of a millisecond: the line must fit.
fn instant(time: f64) -> String {
    digits((time * 1e4).round() * 1e-4)
}

/// Drifts of the storeys of buildings, from the ground up; nothing where every structure has one storey.
fn storeys(floors: &Floors, outcome: &Outcome, errors: Option<&RunErrors>) -> String {
    let header = [
        ["Storey", ""],
        ["Peak", "drift [mm]"],
        ["at", "[s]"],
        ["Residual", "[mm]"],
        ["Drift", "ratio"],
        ["Shear", "[kN]"],
        ["Ductility", ""],
    ];
    let row = |index: usize| {
        let floor = &floors.all()[index];
        floor.storey?;
        let peaks = outcome.peaks.of(index);
        let drift = peaks.drift();
        let below = floors
            .below(index)
            .map_or(0.0, |below| outcome.last.of(below));
        let number = |value: Option<f64>| value.map_or_else(|| NONE.into(), short);
        let row = vec![
            floor.name.clone(),
            short(1e3 * drift.value),
            instant(drift.time),
            short(1e3 * (outcome.last.of(index) - below)),
            floor.drift_ratio(drift.value).map_or(NONE.into(), percent),
            short(1e-3 * peaks.restoring_force.value),
            number(floor.ductility(drift.value)),
        ];
        let errors = errors.map(|errors| drift_errors(errors.structures[index], floor));
        Some(std::iter::once(row).chain(errors))
    };
    let rows: Vec<_> = floors.by_structure().filter_map(row).flatten().collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header, &rows)
}

/// The errors of a storey, for the line below it.
fn drift_errors(errors: StructureErrors, floor: &Floor) -> Vec<String> {
    // On the ground the drift is the displacement.
    let drift = percent(errors.drift.unwrap_or(errors.displacement));
    let unless = |missing: bool| {
        if missing {
            String::new()
        } else {
            drift.clone()
        }
    };
    let made_of = floor.made_of;
    vec![
        ERROR.into(),
        drift.clone(),
        String::new(),
        String::new(),
        unless(made_of.is_none_or(|made| made.height_m.is_none())),
        percent(errors.restoring_force),
        unless(!floor.can_yield()),
    ]
}

fn structure_row((scene, floor): (&Scene, &Floor), index: usize, outcome: &Outcome) -> Vec<String> {
    let momentum = short(outcome.momentum.of(index) / 1e3);
    let Some((period, damping_ratio)) = floor.oscillation(scene) else {
        let mut row = vec![floor.name.clone()];
        row.resize(7, NONE.into());
        row.push(momentum);
        return row;
    };
    let peaks = outcome.peaks.of(index);
    vec![
        floor.name.clone(),
        short(period),
        short(damping_ratio),
        short(peaks.displacement.value * 1e3),
        instant(peaks.displacement.time),
        short(peaks.restoring_force.value / 1e3),
        floor
            .ductility(peaks.drift().value)
            .map_or_else(|| NONE.into(), short),
        momentum,
    ]
}

/// The errors of a structure, for the line below it.
fn structure_errors(errors: StructureErrors, floor: &Floor) -> Vec<String> {
    let wall = floor.is_wall();
    let peak = |text: String| if wall { String::new() } else { text };
    vec![
        ERROR.into(),
        String::new(),
        String::new(),
        peak(percent(errors.displacement)),
        peak(milliseconds(errors.displacement_time)),
        peak(percent(errors.restoring_force)),
        // A ductility is a peak drift over a given one.
        if floor.can_yield() {
            percent(errors.drift.unwrap_or(errors.displacement))
        } else {
            String::new()
        },
        percent(errors.momentum),
    ]
}

/// Begins a line of errors.
const ERROR: &str = "  error";

fn pairs(prepared: &Prepared, outcome: &Outcome, errors: Option<&RunErrors>) -> String {
    let (floors, scene) = (prepared.floors(), prepared.scene());
    if floors.facing().is_empty() {
        return paragraph("Pairs", "none: no structure can touch another");
    }
    let contacts: Vec<&Contact> = scene.contacts.iter().flatten().collect();
    let header = [
        ["Pair", "", ""],
        ["Gap", "[mm]", ""],
        ["Colli-", "sions", ""],
        ["First", "[s]", ""],
        ["First", "impulse", "[kN·s]"],
        ["Largest", "impulse", "[kN·s]"],
        ["Peak", "force", "[kN]"],
        ["at", "[s]", ""],
    ];
    let rows = floors
        .facing()
        .iter()
        .enumerate()
        .flat_map(|(index, facing)| {
            let [left, right] = floors.names(index);
            let gap = contacts[facing.contact].gap_m;
            let mut row = vec![format!("{left} – {right}"), digits(gap * 1e3)];
            row.extend(pair_numbers(&outcome.of_pair(index)));
            let errors = errors.map(|errors| pair_errors(&errors.pairs[index]));
            std::iter::once(row).chain(errors)
        });
    table(&header, &rows.collect::<Vec<_>>())
}

/// Collisions of a pair: number, time and impulse of the first, largest impulse, and force with its time.
fn pair_numbers(pair: &PairOutcome) -> [String; 6] {
    let impulse = |one: Option<Collision>| one.map_or(NONE.into(), |one| short(one.impulse / 1e3));
    [
        pair.collisions.to_string(),
        pair.first.map_or(NONE.into(), |first| digits(first.start)),
        impulse(pair.first),
        impulse(pair.largest),
        match pair.peak_force {
            None if pair.collisions == 0 => NONE.into(),
            None => "impulsive".into(),
            Some(force) => short(force.value / 1e3),
        },
        pair.peak_force
            .map_or(NONE.into(), |force| instant(force.time)),
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
        String::new(),
    ]
}
