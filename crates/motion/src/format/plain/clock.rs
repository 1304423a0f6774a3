//! The column of times: its index and its unit.

use super::super::stamp::Stamp;
use super::super::time_column::{self, TimeColumn};
use super::names::Name;
use super::rows::{Rows, stamp};
use crate::Refused;
use crate::line::{Line, excerpt, number};
use crate::refusals;

/// A column of times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Clock {
    pub(super) column: usize,
    kind: TimeKind,
    /// Whether the unit is known.
    pub(super) labelled: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum TimeKind {
    /// Dates with a time of day.
    Stamps,
    /// Numbers in a unit with this many decimals of a second.
    Numbers { decimals: usize },
}

/// Units of times since 1970 by the size of their numbers, for years from 2001 to 2286: seconds, milliseconds, …
const SINCE_1970: [(f64, usize); 4] = [(1e9, 0), (1e12, 3), (1e15, 6), (1e18, 9)];

impl Clock {
    /// The times of columns with these names, found by name or by values.
    pub(super) fn named(names: &[Name<'_>], rows: &Rows<'_, '_>) -> Option<Self> {
        let fields: Vec<&[u8]> = rows.first().fields().take(names.len()).collect();
        let is_number = |column: &usize| number(fields[*column]).is_some();
        let times = (0..names.len()).filter(|column| names[*column].is_time());
        // A date to the second may precede the time after the first sample.
        let column = times.clone().rfind(is_number).or_else(|| times.clone().next());
        let (column, name) = match column {
            Some(column) => (column, Some(&names[column])),
            None if Self::may_be_first(&names[0]) && rows.is_time() => (0, None),
            None if stamp(fields[0]).is_some() => (0, None),
            None => return None,
        };
        let unit = name.and_then(Name::decimals_of_time);
        Some(Self::of(column, fields[column], unit))
    }

    fn may_be_first(name: &Name<'_>) -> bool {
        !name.tells_direction() && !name.says_acceleration() && name.acceleration_unit().is_none()
    }

    /// The first column, if its values are times.
    pub(super) fn first(rows: &Rows<'_, '_>) -> Option<Self> {
        let field = rows.first().fields().next()?;
        let is_time = stamp(field).is_some() || rows.is_time();
        is_time.then(|| Self::of(0, field, None))
    }

    /// The first column, whatever its values.
    pub(super) fn assumed(rows: &Rows<'_, '_>) -> Self {
        let field = rows.first().fields().next();
        Self::of(0, field.unwrap_or_default(), None)
    }

    fn of(column: usize, first: &[u8], unit: Option<usize>) -> Self {
        let value = number(first);
        let unit = unit.or_else(|| {
            let value = value?;
            let is_near = |least: f64| (least..10.0 * least).contains(&value);
            let known = SINCE_1970.iter().find(|(least, _)| is_near(*least));
            known.map(|(_, decimals)| *decimals)
        });
        let decimals = unit.unwrap_or(0);
        Self {
            column,
            kind: if value.is_some() {
                TimeKind::Numbers { decimals }
            } else {
                TimeKind::Stamps
            },
            labelled: unit.is_some() || value.is_none(),
        }
    }

    /// The times of the rows.
    pub(super) fn read(&self, rows: &Rows<'_, '_>) -> Result<TimeColumn, Refused> {
        let mut times = TimeColumn::default();
        let mut first = None;
        for row in rows.iter() {
            let field = row.fields().nth(self.column).unwrap_or_default();
            match self.kind {
                TimeKind::Stamps => {
                    let moment = stamp(field).ok_or_else(|| refusals::not_a_number(row.number, self.column + 1, excerpt(field)))?;
                    let first: &Stamp = first.get_or_insert_with(|| moment.clone());
                    times.push_time(row, moment.since(first), moment.n_decimals());
                }
                TimeKind::Numbers { decimals: 0 } => times.push(row, field)?,
                TimeKind::Numbers { decimals } => {
                    let printed = time_column::decimals(field);
                    times.push_time(row, self.scaled(row, field, decimals)?, decimals + printed);
                }
            }
        }
        Ok(times)
    }

    /// A time \[s\] that is printed in decimals of a second.
    fn scaled(&self, row: Line<'_>, field: &[u8], decimals: usize) -> Result<f64, Refused> {
        let divisor: f64 = format!("1e{decimals}").parse().expect("a number");
        Ok(row.finite(self.column + 1, field)? / divisor)
    }
}
