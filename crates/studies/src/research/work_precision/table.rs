//! The runs and the references as CSV.

use super::condition::Known;
use super::measure::{Race, Rung};
use super::quantities::MethodQuantity;
use pounding_scene::{ComparedMethod, Knob};
use pounding_text::digits;
use pounding_text::to_csv;

/// The value of every quantity.
pub(super) fn references(races: &[Race]) -> String {
    let header = [
        "scene",
        "quantity",
        "structure",
        "unit",
        "value",
        "agreed_digits",
        "distance_of_routes",
        "condition_number",
        "allowed_distance",
        "within",
    ];
    let mut rows = Vec::new();
    for race in races {
        for quantity in MethodQuantity::ALL {
            let values = race.truth.values(quantity);
            for (value, number) in values.iter().zip(1..) {
                let structure = if values.len() == 1 { String::new() } else { format!("{number}") };
                let mut row = vec![
                    race.scene.clone(),
                    quantity.key().into(),
                    structure,
                    quantity.unit(race.compliant).into(),
                    format!("{value:.14e}"),
                    agreed(race.digits(quantity)),
                ];
                let known = race.knowledge.of(quantity);
                row.extend(known.into_iter().flat_map(|known| known_as(known, race)));
                rows.push(row);
            }
        }
        let mut row = vec![
            race.scene.clone(),
            "number_of_collisions".into(),
            String::new(),
            "1".into(),
            race.truth.n_collisions.to_string(),
            race.agreed_count().into(),
        ];
        row.resize(header.len(), String::new());
        rows.push(row);
    }
    to_csv(&header.map(String::from), &rows)
}

/// Time and impulse of every collision, and how well they are known.
pub(super) fn collisions(races: &[Race]) -> String {
    let header = [
        "scene",
        "pair",
        "collision",
        "quantity",
        "unit",
        "value",
        "distance_of_routes",
        "condition_number",
        "allowed_distance",
        "within",
    ];
    let quantities = [("time", "s"), ("impulse", "N·s")];
    let mut rows = Vec::new();
    for race in races {
        for (pair, met) in race.pairs.iter().zip(&race.knowledge.pairs) {
            for (number, meeting) in (1..).zip(met) {
                for (which, (name, unit)) in quantities.iter().enumerate() {
                    let mut row = vec![
                        race.scene.clone(),
                        pair.clone(),
                        format!("{number}"),
                        (*name).into(),
                        (*unit).into(),
                        format!("{:.14e}", meeting.values[which]),
                    ];
                    row.extend(known_as(meeting.known[which], race));
                    rows.push(row);
                }
            }
        }
    }
    to_csv(&header.map(String::from), &rows)
}

/// How well a result is known, as four columns.
fn known_as(known: Known, race: &Race) -> [String; 4] {
    [
        error(Some(known.distance)),
        error(Some(known.condition)),
        error(Some(known.allowed(race.compliant))),
        if known.holds(race.compliant) { "yes" } else { "no" }.into(),
    ]
}

/// Every run: what it cost and how far off it is.
pub(super) fn runs(races: &[Race]) -> String {
    let errors = MethodQuantity::ALL.map(|quantity| format!("error_of_{}", quantity.key()));
    let mut header: Vec<_> = BEFORE.into_iter().map(String::from).collect();
    header.extend(errors);
    header.extend(AFTER.map(String::from));
    let mut rows = Vec::new();
    for race in races {
        for entrant in &race.entrants {
            let row = |rung| {
                let mut row = row(race, entrant.contender, rung);
                if let Err(reason) = &rung.outcome {
                    row.resize(header.len() - 1, String::new());
                    row.push(reason.clone());
                }
                row
            };
            rows.extend(entrant.rungs.iter().map(row));
        }
    }
    to_csv(&header, &rows)
}

/// Columns before the errors of the quantities.
const BEFORE: [&str; 13] = [
    "scene",
    "method",
    "time_step_s",
    "tolerance",
    "work",
    "steps",
    "force_evaluations",
    "newton_iterations",
    "touching_steps",
    "segments",
    "events",
    "collisions",
    "same_count",
];
/// Columns after them.
const AFTER: [&str; 6] = [
    "agreed_digits",
    "energy_identity",
    "energy_residual",
    "energy_error",
    "broken_law",
    "failed",
];

/// A run, up to where it failed.
fn row(race: &Race, contender: &ComparedMethod, rung: &Rung) -> Vec<String> {
    let mut row = vec![race.scene.clone(), contender.key.into()];
    row.extend(match contender.knob {
        Knob::TimeStep => [setting(contender, rung.setting), String::new()],
        Knob::Tolerance => [String::new(), setting(contender, rung.setting)],
    });
    if let Ok(measured) = &rung.outcome {
        let work = measured.work;
        let counts = [
            measured.cost(),
            work.steps,
            work.force_evaluations,
            work.newton_iterations,
            work.touching_steps,
            work.segments,
            work.events,
        ];
        row.extend(counts.map(|count| count.to_string()));
        row.push(measured.n_collisions.to_string());
        row.push(if measured.same_count { "yes" } else { "no" }.into());
        row.extend(MethodQuantity::ALL.map(|quantity| error(measured.error(quantity))));
        row.push(agreed(race.fewest_digits()));
        let energy = &measured.energy;
        row.extend([energy.identity, energy.residual, energy.error].map(|part| error(Some(part))));
        row.extend([energy.broken.clone().unwrap_or_default(), String::new()]);
    }
    row
}

/// A setting as it is printed.
pub(super) fn setting(contender: &ComparedMethod, setting: f64) -> String {
    match contender.knob {
        Knob::TimeStep => digits(setting),
        Knob::Tolerance => format!("{setting:e}"),
    }
}

/// An error as it is printed: three digits, nothing where there is nothing to compare.
pub(super) fn error(error: Option<f64>) -> String {
    match error {
        None => String::new(),
        Some(0.0) => "0".into(),
        Some(error) if error.is_finite() => format!("{error:.2e}"),
        Some(_) => "infinite".into(),
    }
}

/// Agreed digits as they are printed.
pub(super) fn agreed(digits: Option<u32>) -> String {
    digits.map_or_else(String::new, |digits| digits.to_string())
}
