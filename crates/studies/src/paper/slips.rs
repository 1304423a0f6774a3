//! What each choice of the paper's program is worth: totals with all of them, without each, without any, and exact.

use std::collections::BTreeMap;
use std::path::PathBuf;

use rayon::prelude::*;

use super::program::{Impacts, Joined, Length, Loads, Program, Shared, Start};
use crate::cell::to_csv;
use crate::converged::{Quantities, STUDIES, find, quantities};
use crate::plot::{Axis, Curve, Figure, Kind, Legend, Mark, Panel, Shade, render_png};
use crate::tables::Value;
use crate::{Completed, Published, StudyError, digits};

/// A choice taken back.
struct TakenBack {
    column: &'static str,
    words: &'static str,
    change: fn(Program) -> Program,
    mark: Mark,
}

/// Each choice, and what stands for it where it is taken back.
const TAKEN_BACK: [TakenBack; 6] = [
    TakenBack {
        column: "loads_as_recorded",
        words: "Loads as recorded",
        change: |program| Program {
            loads: Loads::AsRecorded,
            ..program
        },
        mark: Mark::Ring,
    },
    TakenBack {
        column: "ends_with_the_loads",
        words: "Ends with the loads",
        change: |program| Program {
            length: Length::OfLoads,
            ..program
        },
        mark: Mark::HollowSquare,
    },
    TakenBack {
        column: "impacts_on_approach",
        words: "Impacts on approach",
        change: |program| Program {
            impacts: Impacts::OnApproach,
            ..program
        },
        mark: Mark::HollowDiamond,
    },
    TakenBack {
        column: "velocities_before_both",
        words: "Velocities before both",
        change: |program| Program {
            velocities: Shared::Before,
            ..program
        },
        mark: Mark::HollowTriangle,
    },
    TakenBack {
        column: "forces_added",
        words: "Forces added",
        change: |program| Program {
            forces: Joined::Added,
            ..program
        },
        mark: Mark::Diamond,
    },
    TakenBack {
        column: "consistent_start",
        words: "Consistent start",
        change: |program| Program {
            start: Start::Consistent,
            ..program
        },
        mark: Mark::Inverted,
    },
];

/// The numbers of the paper's totals by its program and by what it should have been.
pub(super) struct Slips<'a> {
    published: &'a [Published],
    exact: &'a Quantities,
    printed: Quantities,
    /// Without each of [`TAKEN_BACK`].
    without: Vec<Quantities>,
    described: Quantities,
}

impl<'a> Slips<'a> {
    /// Runs the studies of the totals again, without each choice and without any.
    ///
    /// # Errors
    /// [`StudyError`] when scenes do not give what their table shows.
    pub(super) fn new(
        completed: &[Completed],
        exact: &'a Quantities,
        published: &'a [Published],
    ) -> Result<Self, StudyError> {
        let changed = |change: fn(Program) -> Program| {
            let of_totals = completed
                .iter()
                .filter(|study| STUDIES.contains(&&*study.file.id));
            let again = of_totals.map(|study| study.by_program(change));
            quantities(&again.collect::<Result<Vec<_>, _>>()?)
        };
        let without = TAKEN_BACK.par_iter().map(|back| changed(back.change));
        Ok(Self {
            published,
            exact,
            printed: changed(|program| program)?,
            without: without
                .collect::<Vec<_>>()
                .into_iter()
                .collect::<Result<_, _>>()?,
            described: changed(|_| Program::DESCRIBED)?,
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
    fn published(&self, table: &str, row: &Value) -> Option<f64> {
        let (table, name) = match table {
            "2" => (
                "text",
                format!("two structures stereomechanical {}", row.row),
            ),
            "4" => ("text", format!("two structures viscoelastic {}", row.row)),
            _ => (table, row.row.clone()),
        };
        let is = |one: &&Published| {
            one.table == table && one.row == name && one.quantity == row.quantity
        };
        Some(self.published.iter().find(is)?.published.value)
    }

    fn table(&self) -> String {
        let mut header = [
            "table",
            "row",
            "quantity",
            "unit",
            "published",
            "papers_program",
        ]
        .to_vec();
        header.extend(TAKEN_BACK.iter().map(|back| back.column));
        header.extend(["as_described", "exact"]);
        let mut rows = Vec::new();
        for table in TABLES {
            for row in self.rows(table) {
                let mut numbers = vec![self.published(table, row), Some(row.value)];
                numbers.extend(self.without.iter().map(|values| find(values, table, row)));
                numbers
                    .extend([&self.described, self.exact].map(|values| find(values, table, row)));
                let keys = [table, &row.row, &row.quantity, row.unit].map(String::from);
                let cell = |number: Option<f64>| number.map(digits).unwrap_or_default();
                rows.push(
                    keys.into_iter()
                        .chain(numbers.into_iter().map(cell))
                        .collect(),
                );
            }
        }
        to_csv(
            &header.iter().map(ToString::to_string).collect::<Vec<_>>(),
            &rows,
        )
    }

    fn figure_png(&self) -> Result<Vec<u8>, StudyError> {
        let panels = [
            ("6", "Table 6, stereomechanical impact"),
            ("7", "Table 7, viscoelastic element"),
        ];
        let figure = Figure {
            height_in: 5.4,
            columns: 2,
            x: Axis::auto("Transferred momentum over the printed one"),
            panels: panels.map(|(table, title)| self.panel(table, title)).into(),
        };
        render_png(&figure).map_err(|source| StudyError::Plot {
            path: FIGURE.into(),
            source,
        })
    }

    fn panel(&self, table: &str, title: &str) -> Panel {
        let rows = self.rows(table).filter_map(|row| {
            let published = self.published(table, row)?;
            // Nothing is a multiple of what structures transfer that nothing touches.
            (published > 0.0).then_some((row, published))
        });
        let rows: Vec<(&Value, f64)> = rows.collect();
        let points = |values: &Quantities| -> Vec<(f64, f64)> {
            let of_row = |(y, (row, printed)): (usize, &(&Value, f64))| {
                Some((find(values, table, row)? / printed, y as f64))
            };
            rows.iter().enumerate().filter_map(of_row).collect()
        };
        let curve = |values: &Quantities, shade, mark, words: &str| {
            Curve::new(Kind::Points, shade, points(values))
                .marked(mark)
                .named(words)
        };
        let mut curves = Vec::new();
        for (back, values) in TAKEN_BACK.iter().zip(&self.without) {
            curves.push(curve(values, Shade::Blue, back.mark, back.words));
        }
        curves.push(curve(
            &self.described,
            Shade::Green,
            Mark::Disc,
            "As described",
        ));
        curves.push(curve(self.exact, Shade::Ink, Mark::Stroke, "Exact"));
        curves.push(curve(
            &self.printed,
            Shade::Vermilion,
            Mark::Cross,
            "Paper's program",
        ));
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

/// Tables whose totals are asked.
const TABLES: [&str; 5] = ["2", "4", "5", "6", "7"];
/// Quantities that are totals.
const TOTALS: [&str; 2] = ["transferred momentum", "impulse of first collision"];
/// The figure, from the results folder.
const FIGURE: &str = "figures/slips.png";
