//! Plain text: one column of accelerations, or two of time and acceleration, below any titles.
//!
//! Numbers are separated by blanks or commas. Lines that begin with `#` are comments wherever they
//! stand; other text may stand above the numbers only. The unit must be declared, and for one column
//! the time step.

use super::columns::{Largest, is_mark};
use super::time_column::TimeColumn;
use super::{Draft, File, Format, Reader, Scale, one_component, reading};
use crate::line::{Line, number};
use crate::{Place, ReadError};

pub(super) const READER: Reader = Reader {
    format: Format::Plain,
    recognises: |file| first_row(file).is_some(),
    components: one_component,
    read: |file, _| read(file),
};

/// Index of the first line of numbers alone; above it stand titles.
fn first_row(file: &File<'_>) -> Option<usize> {
    let is_row = |line: &Line<'_>| {
        let fields = line.fields();
        !line.is_comment()
            && !fields.is_empty()
            && fields.iter().all(|field| number(field).is_some())
    };
    file.lines.iter().position(is_row)
}

fn read(file: &File<'_>) -> Result<Draft, ReadError> {
    let first = first_row(file).ok_or(ReadError::Empty)?;
    let (titles, rows) = file.lines.split_at(first);
    let rows: Vec<Line<'_>> = rows
        .iter()
        .copied()
        .filter(|line| !line.is_blank() && !line.is_comment())
        .collect();
    let n_columns = rows[0].fields().len();
    let mut times = TimeColumn::default();
    let mut values = Vec::new();
    let mut largest = Largest::default();
    let mut end = rows[0];
    for line in &rows {
        let fields = line.fields();
        if fields.len() != n_columns || n_columns > 2 {
            return Err(ReadError::PlainColumns {
                line: line.number,
                found: fields.len(),
                allowed: if n_columns > 2 { None } else { Some(n_columns) },
            });
        }
        if n_columns == 2 {
            times.push(*line, fields[0])?;
        }
        let field = fields[n_columns - 1];
        let value = line.finite(n_columns, field)?;
        largest.see(value, field);
        values.push(value);
        end = *line;
    }
    let found = if n_columns == 1 {
        "1"
    } else {
        "2, time and acceleration"
    };
    let mut remarks = vec![reading("columns", Some(Place::Line(rows[0].number)), found)];
    let mut time_step = None;
    if n_columns == 2 {
        let (step, rest) = times.into_step(&mut values)?;
        remarks.extend(rest);
        time_step = Some(step);
    } else {
        check_first(rows[0], &values)?;
    }
    let comments = titles.iter().map(|line| line.text());
    let comments: Vec<String> = comments
        .map(|line| line.trim_start_matches('#').trim().to_owned())
        .filter(|line| !line.is_empty())
        .collect();
    Ok(Draft {
        values,
        end: Place::Line(end.number),
        digit: largest.digit(),
        count: None,
        time_step,
        scale: Scale::Unknown,
        peak: None,
        provenance: comments.join("\n"),
        remarks,
    })
}

/// Refuses a number of values that stands above them like one of them.
fn check_first(line: Line<'_>, values: &[f64]) -> Result<(), ReadError> {
    if values.len() > 2 && is_mark(values[0], (values.len() - 1) as f64) {
        return Err(ReadError::CountAsValue {
            line: line.number,
            found: line.excerpt(),
        });
    }
    Ok(())
}
