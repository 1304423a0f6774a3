//! The arrangement of the numbers in a plain text: one after the other, or in columns.

use super::super::File;
use super::super::said::{Other, Said};
use super::above::Above;
use super::clock::Clock;
use super::names::{Name, of_columns, spectrum};
use super::rows::{Rows, first_row};
use crate::line::Line;
use crate::refusals;
use crate::{FilePlace, Refused};
use pounding_text::{Knob, Spot};

/// Rows of numbers with their properties.
pub(super) struct Layout<'l, 't> {
    /// The lines above the first numbers.
    pub(super) titles: &'l [Line<'t>],
    /// The statements of the titles.
    pub(super) said: Said,
    /// Numbers of a header above the rows, if any.
    pub(super) above: Option<Above<'t>>,
    pub(super) rows: Rows<'l, 't>,
    pub(super) kind: Arrangement<'t>,
}

/// The arrangement of values in rows.
pub(super) enum Arrangement<'t> {
    /// One after the other, with any number per row, and possibly a name above.
    Values(Option<Name<'t>>),
    /// One value of each component per row, possibly with a time.
    Table {
        clock: Option<Clock>,
        /// The columns of components.
        columns: Vec<usize>,
        names: Option<Vec<Name<'t>>>,
    },
    /// Unknown, for this reason.
    Unknown(&'static str),
}

impl<'l, 't> Layout<'l, 't> {
    pub(super) fn new(file: &'l File<'t>) -> Result<Self, Refused> {
        let first = first_row(&file.lines).ok_or(refusals::empty())?;
        let (titles, lines) = file.lines.split_at(first);
        let mut rows = Rows::new(lines).ok_or(refusals::empty())?;
        rows.check_commas()?;
        let above = Above::new(&rows)?;
        if let Some(above) = &above {
            rows = rows.behind(above.n_rows).ok_or(refusals::empty())?;
        }
        let names = of_columns(titles, rows.n_columns);
        if let Some(names) = &names
            && let Some(instead) = spectrum(names)
        {
            return Err(refusals::not_acceleration(
                FilePlace::Line(names[0].line.number),
                names[0].line.excerpt(),
                instead,
            ));
        }
        let of_names = names.as_ref().map(|names| names[0].line.number);
        let said = Said::new(titles, of_names);
        let counts = said.counts.iter().map(|count| count.value);
        let counts: Vec<usize> = counts.chain(above.as_ref().and_then(|above| above.count)).collect();
        let kind = Self::kind(&rows, names, &counts, file.in_rows)?;
        Ok(Self {
            titles,
            said,
            above,
            rows,
            kind,
        })
    }

    fn kind(rows: &Rows<'_, '_>, names: Option<Vec<Name<'t>>>, counts: &[usize], in_rows: bool) -> Result<Arrangement<'t>, Refused> {
        let n_columns = rows.n_columns;
        if n_columns == 1 {
            let name = names.and_then(|mut names| names.pop());
            return Ok(if rows.is_full() {
                Arrangement::Values(name)
            } else {
                Arrangement::Unknown("the rows below have others")
            });
        }
        let not_in_rows = |line: Line<'_>| -> Refused {
            Refused::at(Spot::Line(line.number))
                .reads(line.excerpt())
                .and(": the numbers stand in columns")
                .but(", but ", Knob::InRows)
                .and(" is declared")
                .help("leave the declaration away")
        };
        if let Some(names) = names {
            if in_rows {
                return Err(not_in_rows(names[0].line));
            }
            return Ok(Self::named(rows, names));
        }
        let counted = |count: &usize| *count == rows.n_numbers || *count > rows.len;
        let clock = Clock::first(rows);
        let is_list = counts.iter().any(counted) || (n_columns > 2 && rows.is_short());
        match clock {
            Some(_) if in_rows => Err(not_in_rows(rows.first())),
            Some(_) if !rows.is_full() => Ok(Arrangement::Unknown("the rows below have others")),
            Some(clock) => Ok(Arrangement::Table {
                columns: (1..n_columns).collect(),
                clock: Some(clock),
                names: None,
            }),
            None if in_rows || is_list => Ok(Arrangement::Values(None)),
            None if n_columns == 2 && rows.is_full() && rows.mostly_rises() => Ok(Arrangement::Table {
                clock: Some(Clock::assumed(rows)),
                columns: vec![1],
                names: None,
            }),
            None => Ok(Arrangement::Unknown(if rows.touch {
                "numbers of fixed width that touch"
            } else if rows.is_full() {
                "column 1 is no time, and nothing names the columns"
            } else {
                "nothing names columns, and the rows below have others"
            })),
        }
    }

    /// Columns with names. Columns of times, sums and row numbers are not components, nor are velocities and displacements next to
    /// accelerations.
    fn named(rows: &Rows<'_, '_>, names: Vec<Name<'t>>) -> Arrangement<'t> {
        if !rows.is_full() {
            return Arrangement::Unknown("the rows below have others");
        }
        let clock = Clock::named(&names, rows);
        let is_clock = |column: usize| clock.is_some_and(|clock| clock.column == column);
        let may_be = |column: &usize| {
            let name = &names[*column];
            !is_clock(*column) && !name.is_time() && !name.is_no_component()
        };
        let is_acceleration = |column: &usize| !matches!(names[*column].other(), Some(Other::Velocity | Other::Displacement));
        let all: Vec<usize> = (0..names.len()).filter(may_be).collect();
        let mut columns: Vec<usize> = all.iter().copied().filter(is_acceleration).collect();
        if columns.is_empty() {
            columns = all;
        }
        if columns.is_empty() {
            return Arrangement::Unknown("none of the named columns is a component");
        }
        Arrangement::Table {
            clock,
            columns,
            names: Some(names),
        }
    }
}
