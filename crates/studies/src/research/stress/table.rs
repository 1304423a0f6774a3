//! Tables of the extreme scenes and of their counts as CSV.

use super::class::Class;
use super::measure::{Judged, JudgedRun, JudgedScene};
use crate::research::work_precision::MethodQuantity;
use crate::study::stress::ExtremeScene;
use pounding_text::{Cell, Table};

/// One row per scene and method, for the scenes that pass a test.
pub(super) fn cells(cells: &[ExtremeScene], measured: &[JudgedScene], test: impl Fn(&ExtremeScene) -> bool) -> String {
    let own = cells.iter().zip(measured).filter(|(cell, _)| test(cell));
    let rows = own.flat_map(|(cell, measured)| measured.runs.iter().map(move |run| (cell, run)));
    let mut table = Table::of(rows)
        .column("place", |(cell, _)| cell.place.clone())
        .column("scene", |(cell, _)| cell.scene.clone());
    for index in 0..2 {
        let change = move |cell: &ExtremeScene| cell.changes.get(index).copied();
        table = table
            .column(format!("axis_{}", index + 1), move |(cell, _)| {
                change(cell).map(|(axis, _)| axis.key())
            })
            .column(format!("value_{}", index + 1), move |(cell, _)| {
                change(cell).map(|(_, value)| value)
            });
    }
    table = table
        .column("method", |(_, run)| run.method)
        .column("time_step_s", |(_, run)| run.time_step);
    for (index, quantity) in MethodQuantity::ALL.into_iter().enumerate() {
        table = table
            .column(quantity.key(), move |(_, run)| run.numbers[index].class.look().key)
            .column(format!("{}_error", quantity.key()), move |(_, run)| short(run.numbers[index].error));
    }
    let warned = |run: &JudgedRun, of: Test| {
        let quantities = MethodQuantity::ALL.iter().zip(&run.numbers);
        let warned = quantities.filter(|(_, number)| of(number));
        warned.map(|(quantity, _)| quantity.key()).collect::<Vec<_>>().join(" ")
    };
    table
        .column("warned", |(_, run)| warned(run, |number| number.warned))
        .column("warned_unmeasured", |(_, run)| warned(run, |number| number.warned_unmeasured))
        .column("energy_residual", |(_, run)| short(run.residual))
        .column("reason", |(_, run)| run.reason.clone())
        .csv()
}

/// Errors get two digits: more are not reliable.
fn short(value: Option<f64>) -> Cell {
    Cell::number(value, |value| format!("{value:.1e}"))
}

/// A test of a number that is counted.
type Test = fn(&Judged) -> bool;

/// Columns of the summary with the test that each counts.
const COUNTS: [(&str, Test); 6] = [
    ("compared", Judged::is_compared),
    ("false_alarms", Judged::is_false_alarm),
    ("wrong_refusals", Judged::is_wrong_refusal),
    ("unchecked_refusals", Judged::is_unchecked_refusal),
    ("silently_wrong_unmeasured", |number| number.unmeasured == Class::SilentlyWrong),
    ("false_alarms_unmeasured", Judged::is_false_alarm_unmeasured),
];

/// Numbers of each class over all runs: by method, by quantity, and in all.
pub(super) fn summary(measured: &[JudgedScene]) -> String {
    let numbers = || {
        let runs = measured.iter().flat_map(|measured| &measured.runs);
        runs.flat_map(|run| MethodQuantity::ALL.into_iter().zip(&run.numbers).map(move |of| (run.method, of)))
    };
    let mut methods: Vec<&str> = Vec::new();
    for (method, _) in numbers() {
        if !methods.contains(&method) {
            methods.push(method);
        }
    }
    let counted = |by, name, wanted: &dyn Fn(&str, MethodQuantity) -> bool| {
        let own = numbers().filter(|(method, (quantity, _))| wanted(method, *quantity));
        (by, name, own.map(|(_, (_, number))| number).collect::<Vec<&Judged>>())
    };
    let mut rows: Vec<_> = methods
        .iter()
        .map(|method| counted("method", *method, &|other, _| other == *method))
        .collect();
    let of_quantity = |own: MethodQuantity| counted("quantity", own.key(), &|method, other| method != "exact" && other == own);
    rows.extend(MethodQuantity::ALL.map(of_quantity));
    rows.push(counted("all", "stepping methods", &|method, _| method != "exact"));
    let mut table = Table::of(rows)
        .column("by", |(by, ..)| *by)
        .column("name", |(_, name, _)| *name)
        .column("numbers", |(.., numbers)| numbers.len());
    let count = |numbers: &[&Judged], test: &dyn Fn(&Judged) -> bool| numbers.iter().filter(|number| test(number)).count();
    for class in Class::ALL {
        table = table.column(class.look().key, move |(.., numbers)| {
            count(numbers, &|number| number.class == class)
        });
    }
    for (name, test) in COUNTS {
        table = table.column(name, move |(.., numbers)| count(numbers, &test));
    }
    table.csv()
}
