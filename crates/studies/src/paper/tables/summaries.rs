//! Sums and peaks of runs (the paper's Tables 5, 6 and 7 and the numbers of its text).

use super::{Table, Value};
use crate::{Completed, StudyError};
use pounding_text::digits;

/// Impulse of the first collision of every scene.
pub(super) fn first_collision(completed: &Completed) -> Table {
    let mut table = Table::new(&["scene", "impulse_of_first_collision_kns"]);
    for (scene, outcome) in completed.runs() {
        let impulse = outcome.collisions.all().first().map_or(0.0, |first| first.impulse / 1e3);
        table.rows.push(vec![scene.name.clone(), digits(impulse)]);
        table.values.push(Value {
            row: scene.name.clone(),
            quantity: "impulse of first collision".into(),
            unit: "kN·s",
            value: impulse,
        });
    }
    table
}

/// Transferred momentum of every structure of every scene.
pub(super) fn transferred_momentum(completed: &Completed) -> Table {
    let mut table = Table::new(&["scene", "time_step_s", "position", "structure", "transferred_momentum_kns"]);
    for (scene, outcome) in completed.runs() {
        let n = scene.structures.len();
        for (index, structure) in scene.structures.iter().enumerate() {
            let position = position(index, n);
            let momentum = outcome.momentum.of(index) / 1e3;
            table.rows.push(vec![
                scene.name.clone(),
                scene.method.time_step().map(digits).unwrap_or_default(),
                position.clone(),
                structure.name().to_string(),
                digits(momentum),
            ]);
            table.values.push(Value {
                row: format!("{} {position}", scene.name),
                quantity: "transferred momentum".into(),
                unit: "kN·s",
                value: momentum,
            });
        }
    }
    table
}

/// Place of a structure in its row in words.
fn position(index: usize, n_structures: usize) -> String {
    match index {
        0 => "left".into(),
        _ if index + 1 == n_structures => "right".into(),
        _ if n_structures == 3 => "middle".into(),
        _ => format!("number {}", index + 1),
    }
}

/// Single numbers of the running text.
pub(super) fn text(completed: &Completed, transferred_momentum: &[String], peak_forces: &[String]) -> Result<Table, StudyError> {
    let mut table = Table::new(&["scene", "quantity", "unit", "value"]);
    let run = |name: &String| {
        completed
            .of(name)
            .ok_or_else(|| completed.refuse("output.text_table", format!("\"{name}\""), "names of scenes of the study"))
    };
    let mut push = |row: String, quantity: &str, unit, value| {
        table
            .rows
            .push(vec![row.clone(), quantity.into(), String::from(unit), digits(value)]);
        table.values.push(Value {
            row,
            quantity: quantity.into(),
            unit,
            value,
        });
    };
    for name in transferred_momentum {
        let (_, outcome) = run(name)?;
        push(name.clone(), "transferred momentum", "kN·s", outcome.momentum.of(0) / 1e3);
    }
    for name in peak_forces {
        let (_, outcome) = run(name)?;
        for (collision, number) in outcome.collisions.all().iter().take(2).zip(1..) {
            let force = collision.peak_force.ok_or_else(|| {
                completed.refuse(
                    "output.text_table.peak_forces",
                    format!("\"{name}\""),
                    "scenes with a compliant contact law",
                )
            })?;
            push(format!("{name} {number}"), "peak force", "kN", force / 1e3);
        }
    }
    Ok(table)
}
