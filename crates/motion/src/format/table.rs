//! Rows of numbers, of which one column is a component.

use super::columns::{Largest, Numbers, decimal};
use super::time_column::TimeColumn;
use crate::line::Line;
use crate::{Place, ReadError};

/// Rows of as many numbers each.
pub(super) struct Table<'t> {
    header: Line<'t>,
    rows: Vec<(Line<'t>, Vec<&'t [u8]>)>,
}

impl<'t> Table<'t> {
    /// Cuts every line that is not blank by `fields`.
    pub(super) fn new(
        header: Line<'t>,
        lines: &[Line<'t>],
        n_columns: usize,
        fields: impl Fn(Line<'t>) -> Vec<&'t [u8]>,
    ) -> Result<Self, ReadError> {
        let mut rows = Vec::new();
        for line in lines.iter().filter(|line| !line.is_blank()) {
            let fields = fields(*line);
            if fields.len() != n_columns {
                return Err(ReadError::RowFields {
                    line: line.number,
                    found: fields.len(),
                    allowed: n_columns,
                });
            }
            rows.push((*line, fields));
        }
        Ok(Self { header, rows })
    }

    /// The numbers of a column, counted from 0.
    pub(super) fn column(&self, index: usize) -> Result<Numbers, ReadError> {
        let mut values = Vec::new();
        let mut largest = Largest::default();
        let mut end = self.header;
        for (line, fields) in &self.rows {
            let value = decimal(*line, index + 1, fields[index])?;
            largest.see(value, fields[index]);
            values.push(value);
            end = *line;
        }
        Ok(Numbers {
            values,
            end: Place::Line(end.number),
            digit: largest.digit(),
        })
    }

    /// The first column as times.
    pub(super) fn times(&self) -> Result<TimeColumn, ReadError> {
        let mut times = TimeColumn::default();
        for (line, fields) in &self.rows {
            times.push(*line, fields[0])?;
        }
        Ok(times)
    }
}

/// The fields of a row that are separated by blanks.
pub(super) fn pieces(line: Line<'_>) -> Vec<&[u8]> {
    line.pieces().collect()
}
