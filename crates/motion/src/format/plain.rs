//! Plain text: accelerations one after the other, or columns of times and of accelerations, below any titles.
//!
//! Numbers are separated by blanks or commas. Lines that begin with `#` are comments wherever they
//! stand; other text may stand above the numbers only. Two columns are time and acceleration. More are components, where a
//! title names the columns or the first of them rises like a time; or values line after line, where the last line is short or
//! a number of values stands above them. The unit must be declared unless a column's name has it, and without times the time
//! step.

mod layout;
mod names;

use super::columns::{Largest, is_mark};
use super::spacing::Spacing;
use super::time_column::TimeColumn;
use super::{Component, Draft, Format, Reader, Scale, Stated, reading, title};
use crate::line::{Line, number};
use crate::{Place, ReadError, Reading};
use layout::{Kind, Layout, first_row};
use names::Name;

pub(super) const READER: Reader = Reader {
    format: Format::Plain,
    recognises: |file| first_row(&file.lines).is_some(),
    components: |file| Ok(components(&Layout::new(&file.lines)?)),
    read: |file, index| read(&Layout::new(&file.lines)?, index),
};

/// A line with the number of values or rows below it and their time step, such as `11800  0.005`.
struct Count<'t> {
    line: Line<'t>,
    n: usize,
    /// Above zero \[s\].
    step: f64,
}

impl<'t> Count<'t> {
    /// The first of these rows, where it is one: as many rows follow, or values in them.
    fn above(rows: &[Line<'t>]) -> Option<Self> {
        let (line, rows) = rows.split_first()?;
        let fields = line.fields();
        let &[count, step] = &fields[..] else {
            return None;
        };
        let count: usize = std::str::from_utf8(count).ok()?.parse().ok()?;
        let step = number(step).filter(|step| step.is_finite() && *step > 0.0)?;
        let first = rows.first()?.fields();
        let n_numbers: usize = rows.iter().map(|row| row.fields().len()).sum();
        // Were it the first row of times and values, the next time would be above the number.
        let is_time_above = first.len() == 2 && number(first[0])? > count as f64;
        let counts = count == n_numbers || (count == rows.len() && first.len() == 2);
        (counts && !is_time_above).then_some(Self {
            line: *line,
            n: count,
            step,
        })
    }

    fn stated<T>(&self, value: T) -> Stated<T> {
        Stated {
            value,
            place: Place::Line(self.line.number),
            text: self.line.excerpt(),
        }
    }
}

/// The columns of values, where there are several.
fn components(layout: &Layout<'_, '_>) -> Vec<Component> {
    let Kind::Table { has_time, names } = &layout.kind else {
        return Vec::new();
    };
    let columns = usize::from(*has_time)..layout.n_columns();
    if columns.len() < 2 {
        return Vec::new();
    }
    let component = |column: usize| match names {
        Some(names) => Component {
            name: names[column].text.clone(),
            place: Place::Line(names[column].line.number),
        },
        None => Component {
            name: format!("column {}", column + 1),
            place: Place::Line(layout.rows[0].number),
        },
    };
    columns.map(component).collect()
}

/// What the rows hold.
struct Held {
    values: Vec<f64>,
    digit: f64,
    spacing: Option<Spacing>,
    remarks: Vec<Reading>,
    scale: Scale,
}

fn read(layout: &Layout<'_, '_>, index: usize) -> Result<Draft, ReadError> {
    let Held {
        values,
        digit,
        spacing,
        remarks,
        scale,
    } = match &layout.kind {
        Kind::Values => one_after_the_other(layout)?,
        Kind::Table { has_time, names } => {
            let column = usize::from(*has_time) + index;
            let name = names.as_ref().and_then(|names| names.get(column));
            table(layout, *has_time, column, name)?
        }
        Kind::Unknown => return Err(uneven_rows(layout)),
    };
    let comments = layout.titles.iter().map(|line| line.text());
    let comments: Vec<String> = comments
        .map(|line| line.trim_start_matches('#').trim().to_owned())
        .filter(|line| !line.is_empty())
        .collect();
    let end = layout.rows[layout.rows.len() - 1];
    Ok(Draft {
        count: layout
            .count
            .as_ref()
            .map(|count| count.stated(values.len())),
        values,
        end: Place::Line(end.number),
        digit,
        time_step: spacing,
        scale,
        peak: None,
        provenance: comments.join("\n"),
        remarks,
    })
}

/// Which row has another number of columns than the first, or that there are too many.
fn uneven_rows(layout: &Layout<'_, '_>) -> ReadError {
    let n_columns = layout.n_columns();
    let mut rows = layout.rows.iter();
    let other = rows.find(|row| row.fields().len() != n_columns);
    let line = other.unwrap_or(&layout.rows[0]);
    ReadError::PlainColumns {
        line: line.number,
        found: line.fields().len(),
        allowed: other.map(|_| n_columns),
    }
}

fn one_after_the_other(layout: &Layout<'_, '_>) -> Result<Held, ReadError> {
    let n_columns = layout.n_columns();
    let mut values = Vec::new();
    let mut largest = Largest::default();
    for line in &layout.rows {
        let fields = line.fields();
        if n_columns == 1 && fields.len() != 1 {
            return Err(uneven_rows(layout));
        }
        for (index, field) in fields.iter().copied().enumerate() {
            let value = line.finite(index + 1, field)?;
            largest.see(value, field);
            values.push(value);
        }
    }
    if n_columns == 1 && layout.count.is_none() {
        check_first(layout.rows[0], &values)?;
    }
    let found = match n_columns {
        1 => "1".to_owned(),
        several => format!("{several}, values line after line"),
    };
    let place = Place::Line(layout.rows[0].number);
    Ok(Held {
        values,
        digit: largest.digit(),
        spacing: layout
            .count
            .as_ref()
            .map(|count| count.stated(count.step).into()),
        remarks: vec![reading("columns", Some(place), &found)],
        scale: Scale::Unknown,
    })
}

fn table(
    layout: &Layout<'_, '_>,
    has_time: bool,
    column: usize,
    name: Option<&Name<'_>>,
) -> Result<Held, ReadError> {
    let n_columns = layout.n_columns();
    let mut times = TimeColumn::default();
    let mut values = Vec::new();
    let mut largest = Largest::default();
    for line in &layout.rows {
        let fields = line.fields();
        if fields.len() != n_columns {
            return Err(uneven_rows(layout));
        }
        if has_time {
            times.push(*line, fields[0])?;
        }
        let value = line.finite(column + 1, fields[column])?;
        largest.see(value, fields[column]);
        values.push(value);
    }
    let found = match (has_time, n_columns) {
        (true, 2) => "2, time and acceleration".to_owned(),
        (true, several) => format!("{several}, time and components"),
        (false, several) => format!("{several} components"),
    };
    let place = Place::Line(layout.rows[0].number);
    let mut remarks = vec![reading("columns", Some(place), &found)];
    let mut spacing = layout
        .count
        .as_ref()
        .map(|count| count.stated(count.step).into());
    if has_time {
        let (found, rest) = times.into_step_from_anywhere(&mut values)?;
        if let (Some(count), Spacing::Even(step)) = (&layout.count, &found)
            && (count.step - step.value).abs() > 1e-6 * step.value
        {
            return Err(ReadError::Header {
                place: Place::Line(count.line.number),
                found: count.line.excerpt(),
                allowed: "the time step of the times below",
            });
        }
        remarks.extend(rest);
        spacing = Some(found);
    }
    Ok(Held {
        values,
        digit: largest.digit(),
        spacing,
        remarks,
        scale: name.map_or(Scale::Unknown, scale),
    })
}

/// What the name of a column tells of its values.
fn scale(name: &Name<'_>) -> Scale {
    let place = Place::Line(name.line.number);
    let text = format!("{} ({})", name.text, name.unit);
    if let Some((value, _)) = title::unit_in(&name.unit) {
        return Scale::Unit(Stated { value, place, text });
    }
    let word = name.text.to_ascii_uppercase();
    let is_velocity = word.starts_with("VEL") || word.starts_with("DIS");
    if is_velocity || ["cm/s", "m/s", "cm", "m", "mm"].contains(&name.unit.as_str()) {
        return Scale::Velocity(Stated {
            value: (),
            place,
            text,
        });
    }
    Scale::Unknown
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
