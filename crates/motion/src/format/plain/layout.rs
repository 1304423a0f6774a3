//! How the numbers of a plain text stand: one after the other, or in columns.

use super::super::spacing::Spacing;
use super::super::time_column::TimeColumn;
use super::Count;
use super::names::{Name, of_columns};
use crate::ReadError;
use crate::line::{Line, number};

/// Rows of numbers and what is known of them.
pub(super) struct Layout<'l, 't> {
    /// The lines above the first numbers.
    pub(super) titles: &'l [Line<'t>],
    /// A line with the number of values and their step, where one stands above the rows.
    pub(super) count: Option<Count<'t>>,
    /// At least one.
    pub(super) rows: Vec<Line<'t>>,
    pub(super) kind: Kind<'t>,
}

/// How values stand in rows.
pub(super) enum Kind<'t> {
    /// One after the other, any number to a row.
    Values,
    /// A time in each row, perhaps, and a value of each component.
    Table {
        has_time: bool,
        names: Option<Vec<Name<'t>>>,
    },
    /// That is not known.
    Unknown,
}

/// Index of the first line of numbers alone; above it stand titles.
pub(super) fn first_row(lines: &[Line<'_>]) -> Option<usize> {
    let is_row = |line: &Line<'_>| {
        let fields = line.fields();
        !line.is_comment()
            && !fields.is_empty()
            && fields.iter().all(|field| number(field).is_some())
    };
    lines.iter().position(is_row)
}

impl<'l, 't> Layout<'l, 't> {
    pub(super) fn new(lines: &'l [Line<'t>]) -> Result<Self, ReadError> {
        let first = first_row(lines).ok_or(ReadError::Empty)?;
        let (titles, rows) = lines.split_at(first);
        let mut rows: Vec<Line<'t>> = rows
            .iter()
            .copied()
            .filter(|line| !line.is_blank() && !line.is_comment())
            .collect();
        let count = Count::above(&rows);
        if count.is_some() {
            rows.remove(0);
        }
        let kind = kind(titles, &rows, count.as_ref());
        Ok(Self {
            titles,
            count,
            rows,
            kind,
        })
    }

    pub(super) fn n_columns(&self) -> usize {
        self.rows[0].fields().len()
    }
}

fn kind<'t>(titles: &[Line<'t>], rows: &[Line<'t>], count: Option<&Count<'t>>) -> Kind<'t> {
    let n_columns = rows[0].fields().len();
    if n_columns == 1 {
        return Kind::Values;
    }
    let is_full = |row: &Line<'_>| row.fields().len() == n_columns;
    let names = of_columns(titles, n_columns).filter(|_| rows.iter().all(is_full));
    if let Some(names) = names {
        let has_time = names[0].is_time() || (!names[0].tells_direction() && is_time(rows));
        let names = Some(names);
        return Kind::Table { has_time, names };
    }
    let (last, others) = rows.split_last().expect("at least one row");
    let n_numbers = others.len() * n_columns + last.fields().len();
    let is_counted = count.is_some_and(|count| count.n == n_numbers);
    let is_short = n_columns > 2 && last.fields().len() < n_columns && others.iter().all(is_full);
    if is_counted || is_short {
        Kind::Values
    } else if n_columns == 2 || is_time(rows) {
        Kind::Table {
            has_time: true,
            names: None,
        }
    } else {
        Kind::Unknown
    }
}

/// Whether the first column rises in equal steps.
fn is_time(rows: &[Line<'_>]) -> bool {
    let mut times = TimeColumn::default();
    let pushed = rows
        .iter()
        .try_for_each(|row| times.push(*row, row.fields()[0]));
    let step = pushed.and_then(|()| times.into_step_from_anywhere(&mut Vec::new()));
    matches!(step, Ok((Spacing::Even(_), _)))
}
