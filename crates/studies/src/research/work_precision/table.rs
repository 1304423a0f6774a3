//! Tables of the runs and of the references as CSV.

use super::condition::Known;
use super::measure::{Measured, Race, Rung};
use super::quantities::MethodQuantity;
use crate::files::yes_or_no;
use pounding_scene::{ComparedMethod, MethodSetting};
use pounding_text::{Table, digits};

/// A number of the truth.
struct Reference<'a> {
    race: &'a Race,
    quantity: &'static str,
    structure: Option<usize>,
    unit: &'static str,
    value: String,
    agreed: String,
    known: Option<Known>,
}

/// Table of the references, with the value of every quantity.
pub(super) fn references(races: &[Race]) -> String {
    let mut rows = Vec::new();
    for race in races {
        for quantity in MethodQuantity::ALL {
            let values = race.truth.values(quantity);
            rows.extend(values.iter().zip(1..).map(|(value, number)| Reference {
                race,
                quantity: quantity.key(),
                structure: (values.len() > 1).then_some(number),
                unit: quantity.unit(race.compliant),
                value: format!("{value:.14e}"),
                agreed: agreed(race.digits(quantity)),
                known: race.knowledge.of(quantity),
            }));
        }
        rows.push(Reference {
            race,
            quantity: "number_of_collisions",
            structure: None,
            unit: "1",
            value: race.truth.n_collisions.to_string(),
            agreed: race.agreed_count().into(),
            known: None,
        });
    }
    let table = Table::of(rows)
        .column("scene", |one| one.race.scene.clone())
        .column("quantity", |one| one.quantity)
        .column("structure", |one| one.structure)
        .column("unit", |one| one.unit)
        .column("value", |one| one.value.clone())
        .column("agreed_digits", |one| one.agreed.clone());
    known_as(table, |one| Some((one.known?, one.race))).csv()
}

/// Table of the time and impulse of every collision, with their reliability.
pub(super) fn collisions(races: &[Race]) -> String {
    let mut rows = Vec::new();
    for race in races {
        for (pair, met) in race.pairs.iter().zip(&race.knowledge.pairs) {
            for (number, meeting) in (1_usize..).zip(met) {
                rows.extend([0, 1].map(|which| (race, pair, number, meeting, which)));
            }
        }
    }
    let table = Table::of(rows)
        .column("scene", |(race, ..)| race.scene.clone())
        .column("pair", |(_, pair, ..)| (*pair).clone())
        .column("collision", |(_, _, number, ..)| *number)
        .column("quantity", |(.., which)| ["time", "impulse"][*which])
        .column("unit", |(.., which)| ["s", "N·s"][*which])
        .column("value", |(.., meeting, which)| format!("{:.14e}", meeting.values[*which]));
    known_as(table, |(race, .., meeting, which)| Some((meeting.known[*which], race))).csv()
}

/// Adds four columns with the reliability of a result.
fn known_as<'a, Row: 'a>(table: Table<'a, Row>, known: impl Fn(&Row) -> Option<(Known, &Race)> + Copy + 'a) -> Table<'a, Row> {
    let number = move |row: &Row, of: fn(Known, &Race) -> f64| known(row).map(|(known, race)| error(Some(of(known, race))));
    table
        .column("distance_of_routes", move |row| number(row, |known, _| known.distance))
        .column("condition_number", move |row| number(row, |known, _| known.condition))
        .column("allowed_distance", move |row| {
            number(row, |known, race| known.allowed(race.compliant))
        })
        .column("within", move |row| {
            known(row).map(|(known, race)| yes_or_no(known.holds(race.compliant)))
        })
}

/// A count of a run.
type Count = fn(&Measured) -> u64;

/// Columns of counts.
const COUNTS: [(&str, Count); 7] = [
    ("work", Measured::cost),
    ("steps", |run| run.work.steps),
    ("force_evaluations", |run| run.work.force_evaluations),
    ("newton_iterations", |run| run.work.newton_iterations),
    ("touching_steps", |run| run.work.touching_steps),
    ("segments", |run| run.work.segments),
    ("events", |run| run.work.events),
];

/// A run of a method on a scene.
struct One<'a> {
    race: &'a Race,
    contender: &'static ComparedMethod,
    rung: &'a Rung,
}

impl One<'_> {
    /// The results of the run, unless it failed.
    fn found(&self) -> Option<&Measured> {
        self.rung.outcome.as_ref().ok()
    }

    fn setting(&self, is: fn(&MethodSetting) -> bool) -> Option<String> {
        is(&self.contender.knob).then(|| setting(self.contender, self.rung.setting))
    }
}

/// Table of every run with its cost and errors.
pub(super) fn runs(races: &[Race]) -> String {
    let mut rows = Vec::new();
    for race in races {
        for entrant in &race.entrants {
            let contender = entrant.contender;
            rows.extend(entrant.rungs.iter().map(|rung| One { race, contender, rung }));
        }
    }
    Table::of(rows)
        .column("scene", |one| one.race.scene.clone())
        .column("method", |one| one.contender.key)
        .column("time_step_s", |one| one.setting(|knob| matches!(knob, MethodSetting::TimeStep)))
        .column("tolerance", |one| one.setting(|knob| matches!(knob, MethodSetting::Tolerance)))
        .columns(COUNTS, |(name, _)| name.into(), |one, (_, count)| one.found().map(count))
        .column("collisions", |one| one.found().map(|run| run.n_collisions))
        .column("same_count", |one| one.found().map(|run| yes_or_no(run.same_count)))
        .columns(
            MethodQuantity::ALL,
            |quantity| format!("error_of_{}", quantity.key()),
            |one, quantity| one.found().map(|run| error(run.error(quantity))),
        )
        .column("agreed_digits", |one| one.found().map(|_| agreed(one.race.fewest_digits())))
        .column("energy_identity", |one| one.found().map(|run| error(Some(run.energy.identity))))
        .column("energy_residual", |one| one.found().map(|run| error(Some(run.energy.residual))))
        .column("energy_error", |one| one.found().map(|run| error(Some(run.energy.error))))
        .column("broken_law", |one| one.found().and_then(|run| run.energy.broken.clone()))
        .column("failed", |one| one.rung.outcome.as_ref().err().cloned())
        .csv()
}

/// A setting as text.
pub(super) fn setting(contender: &ComparedMethod, setting: f64) -> String {
    match contender.knob {
        MethodSetting::TimeStep => digits(setting),
        MethodSetting::Tolerance => format!("{setting:e}"),
    }
}

/// An error as text with three digits; empty if there is nothing to compare.
fn error(error: Option<f64>) -> String {
    match error {
        None => String::new(),
        Some(0.0) => "0".into(),
        Some(error) if error.is_finite() => format!("{error:.2e}"),
        Some(_) => "infinite".into(),
    }
}

/// Agreed digits as text.
pub(super) fn agreed(digits: Option<u32>) -> String {
    digits.map_or_else(String::new, |digits| digits.to_string())
}
