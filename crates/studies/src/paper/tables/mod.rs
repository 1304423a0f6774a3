//! Tables: what a study prints as CSV, and the single numbers in it.

mod pounding_forces;
mod structures;
mod summaries;

use crate::{Completed, Output, StudyError};
pub(crate) use pounding_text::to_csv;

/// One computed number with the keys that published numbers carry.
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

/// A table as text, and the numbers in it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// Column names.
    pub header: Vec<String>,
    /// Cells.
    pub rows: Vec<Vec<String>>,
    /// The numbers, to be compared with published ones.
    pub values: Vec<Value>,
}

impl Table {
    fn new(header: &[&str]) -> Self {
        Self {
            header: header.iter().map(ToString::to_string).collect(),
            ..Self::default()
        }
    }

    /// The table as CSV text.
    pub fn to_csv(&self) -> String {
        to_csv(&self.header, &self.rows)
    }

    /// The table of a study; nothing for a study that draws a figure.
    ///
    /// # Errors
    /// [`StudyError::Study`] when the scenes do not give what the table shows.
    pub fn of(completed: &Completed) -> Result<Option<Self>, StudyError> {
        match &completed.file.study.output {
            Output::StructuresTable => Ok(Some(structures::table(completed))),
            Output::PoundingForcesTable {
                n_collisions,
                label_offset_s,
            } => pounding_forces::table(completed, n_collisions.unwrap_or(usize::MAX), *label_offset_s).map(Some),
            Output::FirstCollisionTable => Ok(Some(summaries::first_collision(completed))),
            Output::TransferredMomentumTable => Ok(Some(summaries::transferred_momentum(completed))),
            Output::TextTable {
                transferred_momentum,
                peak_forces,
            } => summaries::text(completed, transferred_momentum, peak_forces).map(Some),
            Output::Claims
            | Output::Trade(_)
            | Output::Laws(_)
            | Output::Extremes(_)
            | Output::Beyond(_)
            | Output::Survey(_)
            | Output::RecordFigure
            | Output::DisplacementFigure
            | Output::PoundingFigure
            | Output::FirstCollisionFigure
            | Output::LayoutFigure
            | Output::ShearForceFigure { .. } => Ok(None),
        }
    }
}
