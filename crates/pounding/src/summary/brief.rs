//! What matters of a run, on one screen: where it touches hardest, and the worst of every building.

use pounding::report::Blow;
use pounding::scene::{Errors, QuantityGroup, Review, RunResult, Simulation};
use pounding::text::digits;

use crate::record;
use crate::text::{NONE, paragraph, percent, short, table};

/// Pairs that are shown; the others are counted.
const SHOWN: usize = 6;

/// The scene, its record and method, and what is known of the errors, in a line each.
pub(super) fn scene(prepared: &Simulation, review: &Review) -> String {
    let scene = prepared.scene();
    let method = match scene.method.name().replace('_', " ") {
        name if name == "exact" => "the exact method".into(),
        name => name,
    };
    let steps = scene
        .method
        .time_step()
        .map_or(String::new(), |step| format!(", steps of {} s", digits(step)));
    let lines = [
        scene.name.clone(),
        record::brief(prepared),
        format!(
            "{} s by {method}{steps}, {}: {}",
            digits(prepared.duration()),
            if scene.record.reversed { "reversed" } else { "as recorded" },
            errors(&review.errors)
        ),
    ];
    paragraph("Scene", &lines.join("\n"))
}

fn errors(errors: &Errors) -> String {
    match errors {
        Errors::Exact => "no error beyond rounding".into(),
        Errors::Doubtful => "this run has gone wrong (see the warnings)".into(),
        Errors::NotMeasured => "errors not measured (--no-error)".into(),
        Errors::Unknown(_) => "errors not known, the exact run fails".into(),
        Errors::Measured(errors, _) => match errors.largest(QuantityGroup::All) {
            (largest, _) if largest <= 0.0 => "no error".into(),
            (largest, of) if largest.is_finite() => {
                format!("largest error {} ({of})", percent(largest))
            }
            (_, of) => format!("another {of} than the exact run"),
        },
    }
}

/// The pairs that touch, the hardest first.
pub(super) fn pairs(prepared: &Simulation, outcome: &RunResult) -> String {
    if prepared.floors().facing().is_empty() {
        return paragraph("Pairs", "none: no contact is modelled");
    }
    let n_pairs = prepared.pairs().len();
    let blows = Blow::all(outcome);
    if blows.is_empty() {
        return String::new();
    }
    let header = [
        ["Floors that touch,", "the hardest first"],
        ["Gap", "[mm]"],
        ["Times", ""],
        ["Approach", "[m/s]"],
        ["Impulse", "[kN·s]"],
        ["Force", "[kN]"],
    ];
    let rows = blows.iter().take(SHOWN).map(|blow| {
        let [left, right] = prepared.floors().names(blow.pair);
        vec![
            format!("{left} – {right}"),
            digits(1e3 * prepared.pairs()[blow.pair].gap()),
            outcome.of_pair(blow.pair).collisions.to_string(),
            blow.speed.map_or(NONE.into(), short),
            short(1e-3 * blow.impulse),
            blow.force.map_or("impulsive".into(), |force| short(1e-3 * force)),
        ]
    });
    let more = blows.len().saturating_sub(SHOWN);
    let apart = n_pairs - blows.len();
    let pairs = |number: usize| match number {
        1 => "1 pair".into(),
        _ => format!("{number} pairs"),
    };
    let rest = [(more, "less hard"), (apart, "never")];
    let rest = rest.into_iter().filter(|(number, _)| *number > 0);
    let rest: Vec<String> = rest.map(|(number, what)| format!("{} {what}", pairs(number))).collect();
    let rest = if rest.is_empty() {
        String::new()
    } else {
        format!("and {}\n", rest.join(", "))
    };
    format!("{}{rest}", table(&header, &rows.collect::<Vec<_>>()))
}

/// The worst of every building: largest displacement, drift, shear and ductility, each with its floor.
pub(super) fn buildings(prepared: &Simulation, outcome: &RunResult) -> String {
    let floors = prepared.floors();
    let scene = prepared.scene();
    let row = |structure: usize| {
        let own = floors.of_structure(structure).iter().copied();
        let own: Vec<usize> = own.filter(|one| !floors.all()[*one].is_wall()).collect();
        let worst = |of: &dyn Fn(usize) -> Option<f64>| {
            let known = own.iter().filter_map(|&one| Some((one, of(one)?)));
            known.reduce(|worst, next| if next.1 > worst.1 { next } else { worst })
        };
        let peaks = |one: usize| outcome.peaks.of(one);
        let ratio = |one: usize| floors.all()[one].drift_ratio(peaks(one).drift().value);
        let at = |one: usize, text: String| match floors.all()[one].storey {
            Some(storey) => format!("{text} ({storey})"),
            None => text,
        };
        let displacement = worst(&|one| Some(peaks(one).displacement.value.abs()))?;
        let drift = if let Some((one, ratio)) = worst(&ratio) {
            at(one, percent(ratio))
        } else {
            let (one, drift) = worst(&|one| Some(peaks(one).drift().value.abs()))?;
            at(one, format!("{} mm", short(1e3 * drift)))
        };
        let shear = worst(&|one| Some(peaks(one).restoring_force.value.abs()))?;
        let ductility = worst(&|one| floors.all()[one].ductility(peaks(one).drift().value));
        Some(vec![
            scene.structures[structure].name().to_string(),
            at(displacement.0, short(1e3 * displacement.1)),
            drift,
            at(shear.0, short(1e-3 * shear.1)),
            ductility.map_or(NONE.into(), |(one, value)| at(one, short(value))),
        ])
    };
    let header = [
        ["Largest, and", "at which floor"],
        ["Displ.", "[mm]"],
        ["Drift", ""],
        ["Shear", "[kN]"],
        ["Ductility", ""],
    ];
    let rows: Vec<_> = (0..scene.structures.len()).filter_map(row).collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header, &rows)
}

/// How to see the rest.
pub(super) fn more() -> String {
    paragraph(
        "More",
        "--details prints every floor, the record, errors and work; --out FOLDER writes a report; `pounding explain WORD` says what a word means",
    )
}
