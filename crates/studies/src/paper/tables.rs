//! Tables that studies print as CSV, and the numbers in them.

use crate::{Completed, Output, StudyError};
use pounding_scene::{RunResult, Scene, Structure};
use pounding_solver::{Collision, Histories};
use pounding_text::Table;

/// One computed number with the keys that published numbers have.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// Row of the table, for example `layout A elastic left`.
    pub row: String,
    /// Quantity, for example `transferred momentum`.
    pub quantity: String,
    /// Unit as printed, for example `kN·s`.
    pub unit: &'static str,
    /// The number in that unit.
    pub value: f64,
}

impl Value {
    pub(crate) fn new(row: impl Into<String>, quantity: impl Into<String>, unit: &'static str, value: f64) -> Self {
        Self {
            row: row.into(),
            quantity: quantity.into(),
            unit,
            value,
        }
    }
}

/// A table as text, and the numbers in it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StudyTable {
    text: String,
    /// The numbers, for the comparison with published ones.
    pub values: Vec<Value>,
}

impl StudyTable {
    fn new(text: &Table<'_, impl Sized>, values: Vec<Value>) -> Self {
        Self { text: text.csv(), values }
    }

    /// The table as CSV text.
    pub fn to_csv(&self) -> String {
        self.text.clone()
    }

    /// The table of a study; `None` if the study draws a figure.
    ///
    /// # Errors
    /// [`StudyError::Study`] if the scenes do not give the contents of the table.
    pub fn of(completed: &Completed) -> Result<Option<Self>, StudyError> {
        let output = &completed.file.study.output;
        let table = if let Output::StructuresTable = output {
            structures(completed)
        } else if let Output::PoundingForcesTable {
            n_collisions,
            label_offset_s,
        } = output
        {
            pounding_forces(completed, n_collisions.unwrap_or(usize::MAX), *label_offset_s)?
        } else if let Output::FirstCollisionTable = output {
            first_collision(completed)
        } else if let Output::TransferredMomentumTable = output {
            transferred_momentum(completed)
        } else if let Output::TextTable {
            transferred_momentum,
            peak_forces,
        } = output
        {
            running_text(completed, transferred_momentum, peak_forces)?
        } else {
            return Ok(None);
        };
        Ok(Some(table))
    }
}

/// Dynamic characteristics of structures (the paper's Table 1).
fn structures(completed: &Completed) -> StudyTable {
    let structures = completed.file.study.scenes[0].structures.iter();
    let of_one_storey = structures.filter_map(|structure| match structure {
        Structure::Sdof(sdof) => Some(sdof),
        Structure::Building(_) | Structure::Wall => None,
    });
    let text = Table::of(of_one_storey)
        .column("structure", |one| one.name.clone())
        .column("mass_kg", |one| one.mass_kg)
        .column("stiffness_kn_per_m", |one| one.stiffness_n_per_m / 1e3)
        .column("period_s", |one| one.period())
        .column("damping_ratio", |one| one.damping_ratio())
        .column("yield_force_kn", |one| one.yield_force_n.map(|force| force / 1e3))
        .column("yield_displacement_m", |one| {
            one.yield_force_n.map(|force| force / one.stiffness_n_per_m)
        });
    StudyTable::new(&text, Vec::new())
}

/// Impulse of the first collision of every scene (Table 5).
fn first_collision(completed: &Completed) -> StudyTable {
    let value = |(scene, outcome): (&Scene, &RunResult)| {
        let impulse = outcome.collisions.all().first().map_or(0.0, |first| first.impulse / 1e3);
        Value::new(&*scene.name, "impulse of first collision", "kN·s", impulse)
    };
    let values: Vec<_> = completed.runs().map(value).collect();
    let text = Table::of(&values)
        .column("scene", |one| one.row.clone())
        .column("impulse_of_first_collision_kns", |one| one.value);
    StudyTable::new(&text, values.clone())
}

/// Transferred momentum of every structure of every scene (Tables 6 and 7).
fn transferred_momentum<'a>(completed: &'a Completed) -> StudyTable {
    let of_scene = |(scene, outcome): (&'a Scene, &'a RunResult)| {
        let n = scene.structures.len();
        (0..n).map(move |index| (scene, index, position(index, n), outcome.momentum.of(index) / 1e3))
    };
    let rows: Vec<_> = completed.runs().flat_map(of_scene).collect();
    let value = |(scene, _, position, momentum): &(&Scene, usize, String, f64)| {
        Value::new(format!("{} {position}", scene.name), "transferred momentum", "kN·s", *momentum)
    };
    let values = rows.iter().map(value).collect();
    let text = Table::of(rows)
        .column("scene", |(scene, ..)| scene.name.clone())
        .column("time_step_s", |(scene, ..)| scene.method.time_step())
        .column("position", |(_, _, position, _)| position.clone())
        .column("structure", |(scene, index, ..)| scene.structures[*index].name().to_string())
        .column("transferred_momentum_kns", |(.., momentum)| *momentum);
    StudyTable::new(&text, values)
}

/// Position of a structure in its row, in words.
fn position(index: usize, n_structures: usize) -> String {
    match index {
        0 => "left".into(),
        _ if index + 1 == n_structures => "right".into(),
        _ if n_structures == 3 => "middle".into(),
        _ => format!("number {}", index + 1),
    }
}

/// Single numbers of the running text.
fn running_text(completed: &Completed, transferred_momentum: &[String], peak_forces: &[String]) -> Result<StudyTable, StudyError> {
    let run = |name: &String| {
        let allowed = "names of scenes of the study";
        let found = completed.of(name).map(|(_, outcome)| outcome);
        found.ok_or_else(|| completed.refuse("output.text_table", format!("\"{name}\""), allowed))
    };
    let mut values = Vec::new();
    for name in transferred_momentum {
        values.push(Value::new(name, "transferred momentum", "kN·s", run(name)?.momentum.of(0) / 1e3));
    }
    for name in peak_forces {
        for (collision, number) in run(name)?.collisions.all().iter().take(2).zip(1..) {
            let force = collision.peak_force.ok_or_else(|| {
                let place = "output.text_table.peak_forces";
                completed.refuse(place, format!("\"{name}\""), "scenes with a compliant contact law")
            })?;
            values.push(Value::new(format!("{name} {number}"), "peak force", "kN", force / 1e3));
        }
    }
    let text = Table::of(&values)
        .column("scene", |one| one.row.clone())
        .column("quantity", |one| one.quantity.clone())
        .column("unit", |one| one.unit)
        .column("value", |one| one.value);
    Ok(StudyTable::new(&text, values.clone()))
}

/// One printed line: an impact, or one step of a collision.
struct PrintedLine {
    /// `3` for the third impact, `3.2` for the second step of the third collision.
    label: String,
    time: f64,
    /// Force on the right structure \[N\]; the force on the left one is its negative.
    force: f64,
}

/// Time and pounding force of every impact, or of every step in contact (Tables 2 and 4).
fn pounding_forces(completed: &Completed, n_collisions: usize, label_offset: f64) -> Result<StudyTable, StudyError> {
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for (scene, outcome) in completed.runs() {
        let [left, right] = &scene.structures[..] else {
            let found = format!("{} structures in \"{}\"", scene.structures.len(), scene.name);
            return Err(completed.refuse("scenes", found, "two structures per scene"));
        };
        for line in lines(scene, outcome, n_collisions) {
            let row = format!("{} {}", scene.name, line.label);
            let force = |on: &Structure, force| Value::new(&*row, format!("force on {}", on.name()), "kN", force);
            values.push(Value::new(&*row, "time", "s", line.time + label_offset));
            values.extend([force(left, -line.force / 1e3), force(right, line.force / 1e3)]);
            rows.push((scene, line));
        }
        let count = outcome.collisions.all().len() as f64;
        values.push(Value::new(&*scene.name, "number of collisions", "1", count));
    }
    let names = [0, 1].map(|index| completed.file.study.scenes[0].structures[index].name());
    let text = Table::of(rows)
        .column("scene", |(scene, _)| scene.name.clone())
        .column("collision", |(_, line)| line.label.clone())
        .column("time_s", |(_, line)| line.time)
        .column("label_s", |(_, line)| line.time + label_offset)
        .column(format!("force_on_{}_kn", names[0]), |(_, line)| -line.force / 1e3)
        .column(format!("force_on_{}_kn", names[1]), |(_, line)| line.force / 1e3);
    Ok(StudyTable::new(&text, values))
}

fn lines(scene: &Scene, outcome: &RunResult, n_collisions: usize) -> Vec<PrintedLine> {
    let collisions = outcome.collisions.all().iter().take(n_collisions).zip(1..);
    let mut lines = Vec::new();
    for (collision, number) in collisions {
        if collision.peak_force.is_none() {
            // The paper's pounding force of an impact is its impulse over the time step.
            let force = collision.impulse / scene.method.step();
            lines.push(PrintedLine {
                label: format!("{number}"),
                time: collision.start,
                force,
            });
        } else {
            let histories = outcome.histories.as_ref().expect("this table asks for histories");
            for ((time, force), step) in steps(collision, histories).zip(1..) {
                lines.push(PrintedLine {
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
