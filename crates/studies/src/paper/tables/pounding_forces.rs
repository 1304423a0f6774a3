//! Time and pounding force of every impact, or of every step in contact (the paper's Tables 2 and 4).

use super::{Table, Value};
use crate::{Completed, StudyError};
use pounding_scene::{RunResult, Scene};
use pounding_solver::{Collision, Histories};
use pounding_text::digits;

/// One printed line: an impact, or one step of a collision.
struct Line {
    /// `3` for the third impact, `3.2` for the second step of the third collision.
    label: String,
    time: f64,
    /// Force on the right structure \[N\]; the left one gets its negative.
    force: f64,
}

pub(super) fn table(completed: &Completed, n_collisions: usize, label_offset: f64) -> Result<Table, StudyError> {
    let mut table = Table::default();
    for (scene, outcome) in completed.runs() {
        let [left, right] = &scene.structures[..] else {
            return Err(completed.refuse(
                "scenes",
                format!("{} structures in \"{}\"", scene.structures.len(), scene.name),
                "two structures per scene",
            ));
        };
        let (left, right) = (left.name(), right.name());
        if table.header.is_empty() {
            table.header = ["scene", "collision", "time_s", "label_s"].map(String::from).to_vec();
            table.header.extend([left, right].map(|name| format!("force_on_{name}_kn")));
        }
        for line in lines(scene, outcome, n_collisions) {
            let row = format!("{} {}", scene.name, line.label);
            let label = line.time + label_offset;
            table.rows.push(vec![
                scene.name.clone(),
                line.label,
                digits(line.time),
                digits(label),
                digits(-line.force / 1e3),
                digits(line.force / 1e3),
            ]);
            let value = |quantity: String, unit, value| Value {
                row: row.clone(),
                quantity,
                unit,
                value,
            };
            table.values.push(value("time".into(), "s", label));
            table.values.push(value(format!("force on {left}"), "kN", -line.force / 1e3));
            table.values.push(value(format!("force on {right}"), "kN", line.force / 1e3));
        }
        table.values.push(Value {
            row: scene.name.clone(),
            quantity: "number of collisions".into(),
            unit: "1",
            value: outcome.collisions.all().len() as f64,
        });
    }
    Ok(table)
}

fn lines(scene: &Scene, outcome: &RunResult, n_collisions: usize) -> Vec<Line> {
    let collisions = outcome.collisions.all().iter().take(n_collisions).zip(1..);
    let mut lines = Vec::new();
    for (collision, number) in collisions {
        if collision.peak_force.is_none() {
            // The paper's pounding force of an impact is its impulse over the time step.
            let force = collision.impulse / scene.method.step();
            lines.push(Line {
                label: format!("{number}"),
                time: collision.start,
                force,
            });
        } else {
            let histories = outcome.histories.as_ref().expect("this table asks for histories");
            for ((time, force), step) in steps(collision, histories).zip(1..) {
                lines.push(Line {
                    label: format!("{number}.{step}"),
                    time,
                    force,
                });
            }
        }
    }
    lines
}

/// Time and force on the right structure at the nodes of a collision, first to last.
fn steps<'a>(collision: &Collision, histories: &'a Histories) -> impl Iterator<Item = (f64, f64)> + 'a {
    let interval = histories.interval();
    let (start, end) = (collision.start - 0.5 * interval, collision.end + 0.5 * interval);
    let states = histories.of(0).states.iter().enumerate();
    states
        .map(move |(index, state)| (index as f64 * interval, -state.force_from_right))
        .filter(move |(time, _)| start < *time && *time < end)
}
