//! Cells and their counts as CSV.

use super::class::Class;
use super::measure::{Judged, Measured, Run};
use crate::research::work_precision::MethodQuantity;
use crate::study::stress::Cell;
use pounding_text::digits;
use pounding_text::to_csv;

/// A row per scene and method, of the scenes that pass the test.
pub(super) fn cells(cells: &[Cell], measured: &[Measured], test: impl Fn(&Cell) -> bool) -> String {
    let mut header: Vec<String> = ["place", "scene", "axis_1", "value_1", "axis_2", "value_2", "method", "time_step_s"]
        .map(String::from)
        .to_vec();
    for quantity in MethodQuantity::ALL {
        header.push(quantity.key().into());
        header.push(format!("{}_error", quantity.key()));
    }
    header.extend(["warned", "warned_unmeasured", "energy_residual", "reason"].map(String::from));
    let mut rows = Vec::new();
    for (cell, measured) in cells.iter().zip(measured).filter(|(cell, _)| test(cell)) {
        rows.extend(measured.runs.iter().map(|run| row(cell, run)));
    }
    to_csv(&header, &rows)
}

fn row(cell: &Cell, run: &Run) -> Vec<String> {
    let mut row = vec![cell.place.clone(), cell.scene.1.clone()];
    for index in 0..2 {
        let change = cell.changes.get(index);
        row.push(change.map_or(String::new(), |(axis, _)| axis.key().into()));
        row.push(change.map_or(String::new(), |(_, value)| digits(*value)));
    }
    row.push(run.method.into());
    row.push(run.time_step.map_or(String::new(), digits));
    for number in &run.numbers {
        row.push(number.class.key().into());
        row.push(number.error.map_or(String::new(), short));
    }
    let warned = |of: fn(&Judged) -> bool| {
        let quantities = MethodQuantity::ALL.iter().zip(&run.numbers);
        let warned = quantities.filter(|(_, number)| of(number));
        let keys: Vec<_> = warned.map(|(quantity, _)| quantity.key()).collect();
        keys.join(" ")
    };
    row.push(warned(|number| number.warned));
    row.push(warned(|number| number.warned_unmeasured));
    row.push(run.residual.map_or(String::new(), short));
    row.push(run.reason.clone());
    row
}

/// Two digits: what an error is worth.
fn short(value: f64) -> String {
    format!("{value:.1e}")
}

/// How many numbers of all runs are of each class: by method, by quantity, and in all.
pub(super) fn summary(measured: &[Measured]) -> String {
    let mut header: Vec<String> = ["by", "name", "numbers"].map(String::from).to_vec();
    header.extend(Class::ALL.map(|class| class.key().to_string()));
    header.extend(
        [
            "compared",
            "false_alarms",
            "wrong_refusals",
            "unchecked_refusals",
            "silently_wrong_unmeasured",
            "false_alarms_unmeasured",
        ]
        .map(String::from),
    );
    let numbers = || {
        let runs = measured.iter().flat_map(|measured| &measured.runs);
        runs.flat_map(|run| {
            let numbers = MethodQuantity::ALL.into_iter().zip(&run.numbers);
            numbers.map(|(quantity, number)| (run.method, quantity, number))
        })
    };
    let mut methods: Vec<&str> = Vec::new();
    for (method, ..) in numbers() {
        if !methods.contains(&method) {
            methods.push(method);
        }
    }
    let mut rows = Vec::new();
    for method in methods {
        let own = numbers().filter(|(other, ..)| *other == method);
        rows.push(counts(["method", method], &own.map(|(.., number)| number).collect::<Vec<_>>()));
    }
    let stepping = || numbers().filter(|(method, ..)| *method != "exact");
    for quantity in MethodQuantity::ALL {
        let own = stepping().filter(|(_, other, _)| *other == quantity);
        rows.push(counts(
            ["quantity", quantity.key()],
            &own.map(|(.., number)| number).collect::<Vec<_>>(),
        ));
    }
    rows.push(counts(
        ["all", "stepping methods"],
        &stepping().map(|(.., number)| number).collect::<Vec<_>>(),
    ));
    to_csv(&header, &rows)
}

fn counts(names: [&str; 2], numbers: &[&Judged]) -> Vec<String> {
    let count = |test: &dyn Fn(&Judged) -> bool| numbers.iter().filter(|number| test(number)).count().to_string();
    let mut row = names.map(String::from).to_vec();
    row.push(numbers.len().to_string());
    row.extend(Class::ALL.map(|class| count(&|number| number.class == class)));
    row.push(count(&Judged::is_compared));
    row.push(count(&Judged::is_false_alarm));
    row.push(count(&Judged::is_wrong_refusal));
    row.push(count(&Judged::is_unchecked_refusal));
    row.push(count(&|number| number.unmeasured == Class::SilentlyWrong));
    row.push(count(&Judged::is_false_alarm_unmeasured));
    row
}
