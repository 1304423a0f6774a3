//! Numbers of the converged tables, from runs by any method.

use crate::paper::tables::Value;
use crate::{Completed, Published, StudyError, StudyTable};
use std::collections::BTreeMap;

/// Longest pause between impacts of one meeting \[s\]: two time steps of the paper.
const ONE_MEETING: f64 = 0.0201;
/// Time step that divides the paper's impulses in Tables 2 and 4 \[s\].
const PRINTED_STEP: f64 = 0.01;

/// Name of the quantity that counts the meetings of a scene.
pub(super) const MEETINGS: &str = "number of meetings";

/// Numbers by the number of their table.
pub(crate) type Quantities = BTreeMap<&'static str, Vec<Value>>;

/// The number with the row and quantity of `like`; `None` if there is none.
pub(crate) fn find(values: &Quantities, table: &str, like: &Value) -> Option<f64> {
    let same = |value: &&Value| value.row == like.row && value.quantity == like.quantity;
    values.get(table)?.iter().find(same).map(|value| value.value)
}

/// The numbers of Tables 2 and 4 to 7 that these studies give.
///
/// # Errors
/// [`StudyError`] if a study's scenes do not give the contents of its table.
pub(crate) fn quantities(completed: &[Completed]) -> Result<Quantities, StudyError> {
    let mut found = Quantities::new();
    for study in completed {
        match &*study.file.id {
            "table-2" => two_structures(study, "2", "stereomechanical", &mut found),
            "table-4" => two_structures(study, "4", "viscoelastic", &mut found),
            "table-6" => drop(found.insert("6", values(study)?)),
            "table-7" => drop(found.insert("7", values(study)?)),
            _ => {}
        }
    }
    Ok(found)
}

fn values(study: &Completed) -> Result<Vec<Value>, StudyError> {
    Ok(StudyTable::of(study)?.map(|table| table.values).unwrap_or_default())
}

/// A group of impacts in quick succession, or one contact.
#[derive(Debug, Clone, Copy)]
struct Meeting {
    start: f64,
    end: f64,
    /// \[kN·s\]
    impulse: f64,
    /// Peak force \[kN\]; `None` for impacts.
    peak_force: Option<f64>,
}

/// Joins parts that follow each other within [`ONE_MEETING`].
fn joined(parts: impl Iterator<Item = Meeting>) -> Vec<Meeting> {
    let mut meetings: Vec<Meeting> = Vec::new();
    for part in parts {
        match meetings.last_mut() {
            Some(last) if part.start - last.end <= ONE_MEETING => {
                last.end = part.end;
                last.impulse += part.impulse;
                last.peak_force = last.peak_force.zip(part.peak_force).map(|(a, b)| a.max(b));
            }
            _ => meetings.push(part),
        }
    }
    meetings
}

/// Adds the first impulse (Table 5) and the meetings of two structures (Tables 2 and 4).
fn two_structures(study: &Completed, table: &'static str, law: &str, found: &mut Quantities) {
    for (scene, outcome) in study.runs() {
        let parts = outcome.collisions.all().iter().map(|collision| Meeting {
            start: collision.start,
            end: collision.end,
            impulse: collision.impulse / 1e3,
            peak_force: collision.peak_force.map(|force| force / 1e3),
        });
        let meetings = joined(parts);
        let values = found.entry(table).or_default();
        values.push(Value::new(&*scene.name, MEETINGS, "1", meetings.len() as f64));
        values.push(Value::new(
            &*scene.name,
            "transferred momentum",
            "kN·s",
            outcome.momentum.of(0) / 1e3,
        ));
        of_meetings(&scene.name, &meetings, values);
        if let Some(first) = outcome.collisions.all().first() {
            let row = format!("{law} {}", scene.name);
            let first = Value::new(row, "impulse of first collision", "kN·s", first.impulse / 1e3);
            found.entry("5").or_default().push(first);
        }
    }
}

fn of_meetings(scene: &str, meetings: &[Meeting], values: &mut Vec<Value>) {
    for (meeting, number) in meetings.iter().zip(1..) {
        let row = format!("{scene} {number}");
        values.push(Value::new(&*row, "start", "s", meeting.start));
        values.push(Value::new(&*row, "impulse", "kN·s", meeting.impulse));
        if let Some(force) = meeting.peak_force {
            values.push(Value::new(&*row, "peak force", "kN", force));
        }
    }
}

/// The printed numbers in the form of [`quantities`]. The printed forces of Tables 2 and 4 become meetings; the times of Table 2 are `late`
/// \[s\] too late.
pub(super) fn published(printed: &[Published], late: f64) -> Quantities {
    let mut found = Quantities::new();
    for (table, late, compliant) in [("2", late, false), ("4", 0.0, true)] {
        let of_table = || printed.iter().filter(|printed| printed.table == table);
        for scene in ["elastic", "nonlinear"] {
            let of = |quantity: &'static str| {
                let is_row = move |printed: &&Published| printed.row.starts_with(scene) && printed.quantity == quantity;
                of_table().filter(is_row).map(|printed| printed.published.value)
            };
            let parts = of("time").zip(of("force on stiff")).map(|(time, force)| Meeting {
                start: time - late,
                end: time - late,
                impulse: force * PRINTED_STEP,
                peak_force: compliant.then_some(force),
            });
            of_meetings(scene, &joined(parts), found.entry(table).or_default());
        }
    }
    for table in ["5", "6", "7"] {
        let of_table = printed.iter().filter(|printed| printed.table == table);
        let values = of_table.map(|printed| Value::new(&*printed.row, &*printed.quantity, "kN·s", printed.published.value));
        found.insert(table, values.collect());
    }
    found
}
