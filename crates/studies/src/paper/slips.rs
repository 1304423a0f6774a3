//! What each choice of the paper's program is worth: totals with all of them, without each, without any, and exact.

use crate::files::capital;
use crate::paper::converged::{Exact, Quantities, STUDIES, find, quantities};
use crate::paper::tables::Value;
use crate::program::{Choice, Program};
use crate::{Completed, Printed, Published, StudyError};
use pounding_plot::{Axis, Curve, Figure, Kind, Legend, Mark, Panel, Shade, render_png};
use pounding_scene::parallel;
use pounding_text::{digits, to_csv};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Marks of the choices in the figure.
const MARKS: [Mark; Choice::ALL.len()] = [
    Mark::Inverted,
    Mark::Ring,
    Mark::Square,
    Mark::HollowSquare,
    Mark::HollowDiamond,
    Mark::HollowTriangle,
    Mark::Diamond,
];

/// The numbers of the paper's totals by its program and by what it should have been.
pub(super) struct Slips<'a> {
    published: &'a [Published],
    exact: Exact<'a>,
    printed: Quantities,
    /// Without each of [`Choice::ALL`].
    without: Vec<Quantities>,
    described: Quantities,
}

impl<'a> Slips<'a> {
    /// Runs the studies of the totals again, without each choice and without any.
    ///
    /// # Errors
    /// [`StudyError`] when scenes do not give what their table shows.
    pub(super) fn new(completed: &[Completed], exact: Exact<'a>, published: &'a [Published]) -> Result<Self, StudyError> {
        let changed = |change: &(dyn Fn(Program) -> Program + Sync)| {
            let of_totals = completed.iter().filter(|study| STUDIES.contains(&&*study.file.id));
            let again = of_totals.map(|study| study.by_program(change));
            quantities(&again.collect::<Result<Vec<_>, _>>()?)
        };
        let taken_back = |choice: &Choice| changed(&|program| choice.taken_back(program));
        Ok(Self {
            published,
            exact,
            printed: changed(&|program| program)?,
            without: parallel::try_each(&Choice::ALL, taken_back)?,
            described: changed(&|_| Program::DESCRIBED)?,
        })
    }

    /// Table and figure by their paths in the results folder.
    ///
    /// # Errors
    /// [`StudyError::Plot`] when the figure cannot be drawn.
    pub(super) fn files(&self) -> Result<BTreeMap<PathBuf, Vec<u8>>, StudyError> {
        Ok([
            ("paper/slips.csv".into(), self.table().into_bytes()),
            (FIGURE.into(), self.figure_png()?),
        ]
        .into())
    }

    /// Totals of a table.
    fn rows(&self, table: &str) -> impl Iterator<Item = &Value> {
        let values = self.printed.get(table).into_iter().flatten();
        values.filter(|value| TOTALS.contains(&&*value.quantity))
    }

    /// The printed number of a row; those of two structures stand in the text.
    fn published(&self, table: &str, row: &Value) -> Option<&Printed> {
        let (table, name) = match table {
            "2" => ("text", format!("two structures stereomechanical {}", row.row)),
            "4" => ("text", format!("two structures viscoelastic {}", row.row)),
            _ => (table, row.row.clone()),
        };
        let is = |one: &&Published| one.table == table && one.row == name && one.quantity == row.quantity;
        self.published.iter().find(is).map(|one| &one.published)
    }

    fn table(&self) -> String {
        let mut header = ["table", "row", "quantity", "unit", "published", "papers_program"].to_vec();
        let columns = Choice::ALL.map(|choice| described(choice).replace(' ', "_"));
        header.extend(columns.iter().map(String::as_str));
        header.extend(["as_described", "exact_of_loads", "exact"]);
        let mut rows = Vec::new();
        for table in TABLES {
            for row in self.rows(table) {
                let mut numbers = vec![Some(row.value)];
                numbers.extend(self.without.iter().map(|values| find(values, table, row)));
                let last = [&self.described, self.exact.of_loads, self.exact.running_on];
                numbers.extend(last.map(|values| find(values, table, row)));
                let published = self.published(table, row).map_or("", Printed::text);
                let keys = [table, &row.row, &row.quantity, row.unit, published].map(String::from);
                let cell = |number: Option<f64>| number.map(digits).unwrap_or_default();
                rows.push(keys.into_iter().chain(numbers.into_iter().map(cell)).collect());
            }
        }
        to_csv(&header.iter().map(ToString::to_string).collect::<Vec<_>>(), &rows)
    }

    fn figure_png(&self) -> Result<Vec<u8>, StudyError> {
        let panels = [("6", "Table 6, stereomechanical impact"), ("7", "Table 7, viscoelastic element")];
        let figure = Figure {
            height_in: 4.2,
            columns: 2,
            x: Axis::auto("Momentum over the printed one"),
            panels: panels.map(|(table, title)| self.panel(table, title)).into(),
        };
        render_png(&figure).map_err(|source| StudyError::Plot {
            path: FIGURE.into(),
            source,
        })
    }

    fn panel(&self, table: &str, title: &str) -> Panel {
        let rows = self.rows(table).filter_map(|row| {
            let published = self.published(table, row)?.value;
            // Nothing is a multiple of what structures transfer that nothing touches.
            let moved = |values: &Quantities| find(values, table, row).is_some_and(|value| (value / published - 1.0).abs() > SHOWN);
            let shown = self.without.iter().chain([&self.described]).any(moved);
            (published > 0.0 && shown).then_some((row, published))
        });
        let rows: Vec<(&Value, f64)> = rows.collect();
        let points = |values: &Quantities| -> Vec<(f64, f64)> {
            let of_row = |(y, (row, printed)): (usize, &(&Value, f64))| Some((find(values, table, row)? / printed, y as f64));
            rows.iter().enumerate().filter_map(of_row).collect()
        };
        let curve =
            |values: &Quantities, shade, mark, words: &str| Curve::new(Kind::Points, shade, points(values)).marked(mark).named(words);
        let mut curves = Vec::new();
        for ((choice, mark), values) in Choice::ALL.into_iter().zip(MARKS).zip(&self.without) {
            curves.push(curve(values, Shade::Blue, mark, &capital(&described(choice))));
        }
        curves.push(curve(&self.described, Shade::Green, Mark::Disc, "As described"));
        curves.push(curve(self.exact.running_on, Shade::Ink, Mark::Stroke, "Exact"));
        curves.push(curve(&self.printed, Shade::Vermilion, Mark::Cross, "Paper's program"));
        let names = rows.iter().map(|(row, _)| row.row.replace("layout ", ""));
        Panel {
            title: title.into(),
            y: Axis::names(names.collect()),
            curves,
            legend: Legend::Shared,
            ..Panel::default()
        }
    }
}

/// A choice as the paper describes it, in words.
fn described(choice: Choice) -> String {
    let name = choice.name().replace('_', " ");
    format!("{name} {}", choice.words(Program::DESCRIBED))
}

/// The figure shows rows that some choice moves by more than this \[–\].
const SHOWN: f64 = 0.005;
/// Tables whose totals are asked.
const TABLES: [&str; 5] = ["2", "4", "5", "6", "7"];
/// Quantities that are totals.
const TOTALS: [&str; 2] = ["transferred momentum", "impulse of first collision"];
/// The figure, from the results folder.
const FIGURE: &str = "figures/slips.png";
