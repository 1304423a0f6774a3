//! Rows of numbers in which a column is a component.

use super::columns::decimal;
use super::numbers::{Numbers, Values};
use super::time_column::TimeColumn;
use crate::Refused;
use crate::line::Line;
use pounding_text::Spot;

/// Rows with equal numbers of fields.
pub(super) struct ComponentTable<'l, 't, F> {
    header: Line<'t>,
    lines: &'l [Line<'t>],
    fields: F,
}

impl<'l, 't, I, F> ComponentTable<'l, 't, F>
where
    I: Iterator<Item = &'t [u8]>,
    F: Fn(Line<'t>) -> I,
{
    /// Every line that is not blank, cut by `fields`.
    pub(super) fn new(header: Line<'t>, lines: &'l [Line<'t>], n_columns: usize, fields: F) -> Result<Self, Refused> {
        for line in lines.iter().filter(|line| !line.is_blank()) {
            let found = fields(*line).count();
            if found != n_columns {
                return Err(Refused::at(Spot::Line(line.number))
                    .goes_on(format!("has {found} field(s)"))
                    .allowed_are(n_columns.to_string())
                    .help("fetch the file again"));
            }
        }
        Ok(Self { header, lines, fields })
    }

    /// The rows with their field in a column, counted from 0.
    fn fields_of(&self, index: usize) -> impl Iterator<Item = (Line<'t>, &'t [u8])> {
        let rows = self.lines.iter().filter(|line| !line.is_blank());
        rows.filter_map(move |line| Some((*line, (self.fields)(*line).nth(index)?)))
    }

    /// The numbers of a column, counted from 0.
    pub(super) fn column(&self, index: usize) -> Result<Numbers, Refused> {
        let mut values = Values::default();
        for (line, field) in self.fields_of(index) {
            values.push(line, decimal(line, index + 1, field)?, field)?;
        }
        Ok(values.finish(self.header))
    }

    /// The first column as times.
    pub(super) fn times(&self) -> Result<TimeColumn, Refused> {
        let mut times = TimeColumn::default();
        for (line, field) in self.fields_of(0) {
            times.push(line, field)?;
        }
        Ok(times)
    }
}
