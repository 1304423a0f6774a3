//! The effect of each choice of the paper's program on the totals: with all choices, without each, without any, and exact.

use crate::files::{Files, drawn};
use crate::paper::converged::{Exact, Over, Quantities, STUDIES, TOTALS as TOTALS_SHOWN, find, quantities};
use crate::paper::tables::Value;
use crate::program::{Choice, Program};
use crate::{Completed, Printed, Published, StudyError};
use pounding_plot::{Axis, Figure, Mark, Panel, Shade};
use pounding_scene::parallel;
use pounding_text::Table;

/// Marks and names of the choices in the figure, each as the paper describes it.
const SHOWN_AS: [(Mark, &str); Choice::ALL.len()] = [
    (Mark::Inverted, "First step as in textbooks"),
    (Mark::Ring, "Loads not rounded"),
    (Mark::Square, "Last load used"),
    (Mark::HollowSquare, "Run ends with the loads"),
    (Mark::HollowDiamond, "No impacts when parting"),
    (Mark::HollowTriangle, "Velocities before impacts"),
    (Mark::Diamond, "Forces of pairs added"),
];

/// The paper's totals by its program, by variants of it, and by the exact method.
pub(super) struct Slips<'a> {
    published: &'a [Published],
    exact: Exact<'a>,
    printed: Quantities,
    /// Totals without each of [`Choice::ALL`].
    without: Vec<Quantities>,
    described: Quantities,
}

impl<'a> Slips<'a> {
    /// Runs the studies of the totals again, without each choice and without any.
    ///
    /// # Errors
    /// [`StudyError`] if a study's scenes do not give the contents of its table.
    pub(super) fn new(completed: &[Completed], exact: Exact<'a>, published: &'a [Published]) -> Result<Self, StudyError> {
        let changed = |change: &(dyn Fn(Program) -> Program + Sync)| {
            let of_totals = completed.iter().filter(|study| STUDIES.contains(&&*study.file.id));
            let again = of_totals.map(|study| study.by_program(change));
            quantities(&again.collect::<Result<Vec<_>, _>>()?)
        };
        let taken_back = |choice: &Choice| changed(&|program| program.with_described(*choice));
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
    /// [`StudyError::Plot`] if the figure cannot be drawn.
    pub(super) fn files(&self) -> Result<Files, StudyError> {
        Ok([
            ("paper/slips.csv".into(), self.table().into_bytes()),
            (FIGURE.into(), self.figure_png()?),
        ]
        .into())
    }

    /// The totals of a table.
    fn rows(&self, table: &str) -> impl Iterator<Item = &Value> {
        let values = self.printed.get(table).into_iter().flatten();
        values.filter(|value| TOTALS.contains(&&*value.quantity))
    }

    /// The printed number of a row; the paper prints those of two structures in its text.
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
        let rows = TABLES.into_iter().flat_map(|table| self.rows(table).map(move |row| (table, row)));
        let without = Choice::ALL.into_iter().zip(&self.without);
        let last = [
            ("as_described", &self.described),
            ("exact_of_loads", self.exact.of_loads),
            ("exact", self.exact.running_on),
        ];
        Table::of(rows)
            .column("table", |(table, _)| *table)
            .column("row", |(_, row)| row.row.clone())
            .column("quantity", |(_, row)| row.quantity.clone())
            .column("unit", |(_, row)| row.unit)
            .column("published", |(table, row)| {
                self.published(table, row).map(|printed| printed.text().to_string())
            })
            .column("papers_program", |(_, row)| row.value)
            .columns(
                without,
                |(choice, _)| described(choice).replace(' ', "_"),
                |(table, row), (_, values)| find(values, table, row),
            )
            .columns(last, |(name, _)| name.into(), |(table, row), (_, values)| find(values, table, row))
            .csv()
    }

    fn figure_png(&self) -> Result<Vec<u8>, StudyError> {
        let panels = TOTALS_SHOWN.map(|(table, title)| self.panel(table, title));
        let x = Axis::auto("Momentum over the printed one");
        drawn(&Figure::grid(4.2, 2, x, panels.into()), FIGURE.as_ref())
    }

    fn panel(&self, table: &'static str, title: &str) -> Panel {
        let rows = self.rows(table).filter_map(|row| {
            let published = self.published(table, row)?.value;
            // Rows with zero momentum are left out: nothing can be divided by them.
            let moved = |values: &Quantities| find(values, table, row).is_some_and(|value| (value / published - 1.0).abs() > SHOWN);
            let shown = self.without.iter().chain([&self.described]).any(moved);
            (published > 0.0 && shown).then_some((row, published))
        });
        let over = Over::new(table, rows);
        let mut curves = Vec::new();
        for ((mark, name), values) in SHOWN_AS.into_iter().zip(&self.without) {
            let mut curve = over.curve(values, Shade::Blue, mark, name);
            // What a choice does not move would lie under the mark of the paper's program.
            curve.points.retain(|(ratio, _)| (ratio - 1.0).abs() > SHOWN);
            curves.push(curve);
        }
        curves.push(over.curve(&self.described, Shade::Green, Mark::Disc, "All seven changes"));
        curves.push(over.curve(self.exact.running_on, Shade::Ink, Mark::Stroke, "Exact"));
        curves.push(over.curve(&self.printed, Shade::Vermilion, Mark::Cross, "The paper's program"));
        over.panel(title, curves)
    }
}

/// The words for a choice as the paper describes it.
fn described(choice: Choice) -> String {
    let [name, _, described] = choice.texts();
    format!("{} {described}", name.replace('_', " "))
}

/// Smallest change by a choice that brings a row into the figure \[–\].
const SHOWN: f64 = 0.005;
/// Tables with totals.
const TABLES: [&str; 5] = ["2", "4", "5", "6", "7"];
/// Quantities that are totals.
const TOTALS: [&str; 2] = ["transferred momentum", "impulse of first collision"];
/// Path of the figure in the results folder.
const FIGURE: &str = "figures/slips.png";
