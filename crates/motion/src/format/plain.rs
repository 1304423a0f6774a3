//! Plain text: accelerations one after the other, or columns of times and of accelerations, below any titles.
//!
//! Numbers are separated by blanks or commas. Lines that begin with `#` are comments anywhere; other text may only be above the numbers.
//! Two columns are time and acceleration. More columns are components if a title names them or the first rises like a time. They are
//! consecutive values if the last line is short, a number of values is above them, or the caller states it. The unit must be declared
//! unless a column's name or a title gives it; without times, so must the time step.

mod above;
mod clock;
mod layout;
mod names;
mod rows;

use super::numbers::{Values, is_mark};
use super::said::{Other, Said};
use super::spacing::Spacing;
use super::{Component, Draft, Format, Reader, Scale, Stated, reading, values};
use crate::line::Line;
use crate::refusals;
use crate::{FilePlace, Reading, Refused, Site};
use clock::Clock;
use layout::{Arrangement, Layout};
use names::Name;
use pounding_text::{Knob, Spot};
use rows::first_row;

pub(super) const READER: Reader = Reader {
    format: Format::Plain,
    recognises: |file| first_row(&file.lines).is_some(),
    components: |file| Ok(components(Layout::new(file)?)),
    read: |file, index| read(&Layout::new(file)?, index),
    identity: |file| {
        let titles = first_row(&file.lines).unwrap_or_default();
        Said::new(&file.lines[..titles], None).identity()
    },
};

pub(super) use rows::{cut_by_commas, may_be_cut};

/// Whether the name of a column gives the unit of an acceleration, or another quantity.
pub(super) fn tells(name: &str) -> bool {
    names::unit_at_end(name).is_some() || names::other_by_name(name).is_some()
}

/// The columns of values if there are several; else the component that a title or a name gives.
fn components(layout: Layout<'_, '_>) -> Vec<Component> {
    let of_titles = layout.said.component;
    let Arrangement::Table { columns, names, .. } = &layout.kind else {
        return of_titles.into_iter().collect();
    };
    let first = layout.rows.first().number;
    let component = |column: &usize| match names {
        Some(names) => {
            let name = &names[*column];
            let component = Component::new(&*name.text, FilePlace::Line(name.line.number));
            if name.is_below(names) {
                component.at(Site::Borehole(name.text.clone()))
            } else {
                component
            }
        }
        None => Component::new(format!("column {}", column + 1), FilePlace::Line(first)),
    };
    if let [only] = columns[..] {
        let tells = names.as_ref().is_some_and(|names| names[only].tells_direction());
        return if tells {
            vec![component(&only)]
        } else {
            of_titles.into_iter().collect()
        };
    }
    columns.iter().map(component).collect()
}

/// The contents of the rows.
struct Held {
    values: Vec<f64>,
    digit: f64,
    end: FilePlace,
    /// Number of values or rows read, without a state of rest.
    n_read: usize,
    spacing: Option<Spacing>,
    remarks: Vec<Reading>,
    scale: Scale,
}

fn read(layout: &Layout<'_, '_>, index: usize) -> Result<Draft, Refused> {
    let held = match &layout.kind {
        Arrangement::Values(name) => one_after_the_other(layout, name.as_ref())?,
        Arrangement::Table { clock, columns, names } => {
            let column = columns[index.min(columns.len() - 1)];
            let name = names.as_ref().and_then(|names| names.get(column));
            table(layout, clock.as_ref(), column, name)?
        }
        Arrangement::Unknown(reason) => return Err(unknown(layout, reason)),
    };
    let comments = layout.titles.iter().map(|line| line.text());
    let comments: Vec<String> = comments
        .map(|line| line.trim_start_matches('#').trim().to_owned())
        .filter(|line| !line.is_empty())
        .collect();
    let said = layout.said.steps.clone();
    let above = layout.above.as_ref();
    let steps = above.and_then(|above| Some(above.stated(above.step?)));
    Ok(Draft {
        count: count(layout, &held),
        values: held.values,
        end: held.end,
        digit: held.digit,
        time_step: Spacing::of(held.spacing, steps.into_iter().chain(said).collect()),
        scale: held.scale,
        peak: None,
        provenance: comments.join("\n"),
        remarks: held.remarks,
    })
}

/// The stated number of values; of several, the one that fits. A state of rest is included.
fn count(layout: &Layout<'_, '_>, held: &Held) -> Option<Stated<usize>> {
    let above = layout.above.as_ref();
    let above = above.and_then(|above| Some(above.stated(above.count?)));
    let stated = above.into_iter().chain(layout.said.counts.iter().cloned());
    let mut stated: Vec<Stated<usize>> = stated.collect();
    stated.sort_by_key(|count| count.value.abs_diff(held.n_read));
    // A number without a key may count something else, such as `8 values` per line.
    let is_of_all = |count: &Stated<usize>| count.value > held.n_read / 2;
    let count = stated.into_iter().find(is_of_all)?;
    Some(Stated {
        value: count.value + held.values.len() - held.n_read,
        ..count
    })
}

/// The refusal of numbers in an unknown arrangement.
fn unknown(layout: &Layout<'_, '_>, reason: &'static str) -> Refused {
    let rows = &layout.rows;
    match rows.other {
        Some(other) if !rows.touch && (rows.n_columns < 3 || !rows.is_short()) => {
            let found = Refused::at(Spot::Line(other.number)).goes_on(format!("has {} column(s)", other.fields().count()));
            found
                .allowed_are(format!("{} as in the first line of numbers", rows.n_columns))
                .help("write time and acceleration alone, or one acceleration to a line")
        }
        _ => {
            let found = rows.n_columns;
            let names = ["NS", "EW", "UD"].get(..found).unwrap_or(&["NS", "EW", "UD", "…"]);
            Refused::at(Spot::Line(rows.first().number))
                .goes_on(format!("has {found} numbers: {reason}"))
                .help("if they follow one another, declare ")
                .and(Knob::InRows)
                .and(format!(
                    "; if they are columns, write their names above, such as `{}` or `time {}`",
                    names.join(" "),
                    names[..names.len().max(2) - 1].join(" ")
                ))
                .wants(Knob::InRows)
        }
    }
}

fn one_after_the_other(layout: &Layout<'_, '_>, name: Option<&Name<'_>>) -> Result<Held, Refused> {
    let rows = &layout.rows;
    let first = rows.first();
    let numbers = if rows.iter().any(|row| row.bytes.contains(&b',')) {
        let mut values = Values::default();
        for row in rows.iter() {
            for (index, field) in row.fields().enumerate() {
                values.push(row, row.finite(index + 1, field)?, field)?;
            }
        }
        values.finish(first)
    } else {
        values::of_lines(first, || rows.iter())?
    };
    let n_read = numbers.values.len();
    if rows.n_columns == 1 && layout.above.is_none() {
        check_first(first, &numbers.values)?;
    }
    let found = match rows.n_columns {
        1 => "1".to_owned(),
        several => format!("{several}, values line after line"),
    };
    Ok(Held {
        values: numbers.values,
        digit: numbers.digit,
        end: numbers.end,
        n_read,
        spacing: None,
        remarks: vec![reading("columns", Some(FilePlace::Line(first.number)), &found)],
        scale: scale(name, &layout.said),
    })
}

fn table(layout: &Layout<'_, '_>, clock: Option<&Clock>, column: usize, name: Option<&Name<'_>>) -> Result<Held, Refused> {
    let rows = &layout.rows;
    let mut values = Values::default();
    for row in rows.iter() {
        let field = row.fields().nth(column).unwrap_or_default();
        values.push(row, row.finite(column + 1, field)?, field)?;
    }
    let numbers = values.finish(rows.first());
    let found = match (clock, rows.n_columns) {
        (Some(_), 2) => "2, time and acceleration".to_owned(),
        (Some(_), several) => format!("{several}, time and components"),
        (None, several) => format!("{several} components"),
    };
    let place = FilePlace::Line(rows.first().number);
    let mut held = Held {
        n_read: numbers.values.len(),
        values: numbers.values,
        digit: numbers.digit,
        end: numbers.end,
        spacing: None,
        remarks: vec![reading("columns", Some(place), &found)],
        scale: scale(name, &layout.said),
    };
    if let Some(clock) = clock {
        let found = clock.read(rows)?.into_step_from_anywhere(&mut held.values);
        let (spacing, rest) = found.map_err(|error| header_above(layout).unwrap_or(error))?;
        held.remarks.extend(rest);
        held.spacing = Some(if clock.labelled { spacing } else { spacing.unlabelled() });
    }
    Ok(held)
}

/// The refusal of header numbers in the form of a row above rows of times and values.
fn header_above(layout: &Layout<'_, '_>) -> Option<Refused> {
    let rows = &layout.rows;
    let n_rows = (1..=2).find(|n_rows| rows.behind(*n_rows).is_some_and(|rows| rows.len > 2 && rows.is_time()))?;
    let head: Vec<Line<'_>> = rows.iter().take(n_rows).collect();
    let found: Vec<String> = head.iter().map(|line| line.excerpt()).collect();
    Some(refusals::header_numbers(
        [head[0].number, head[n_rows - 1].number],
        found.join("; "),
        "no pairs of time and value",
    ))
}

/// Quantity and unit of the values, from the name of their column and from titles.
fn scale(name: Option<&Name<'_>>, said: &Said) -> Scale {
    let of_name = name.map(|name| {
        let place = FilePlace::Line(name.line.number);
        let text = if name.unit.is_empty() {
            name.text.clone()
        } else {
            format!("{} ({})", name.text, name.unit)
        };
        (name, place, text)
    });
    let mut units = Vec::new();
    if let Some((name, place, text)) = of_name {
        let stated = Stated {
            value: (),
            place,
            text: text.clone(),
        };
        match (name.acceleration_unit(), name.other()) {
            (Some(value), _) => units.push(Stated { value, place, text }),
            (None, Some(Other::Displacement)) => return Scale::Displacement(stated),
            (None, Some(Other::Velocity)) => return Scale::Velocity(stated),
            _ => {}
        }
    }
    let scale = said.scale_with(units);
    if matches!(scale, Scale::Unknown) && name.is_some_and(Name::says_acceleration) {
        Scale::Acceleration
    } else {
        scale
    }
}

/// Refuses a number of values that is above them in the form of a value.
fn check_first(line: Line<'_>, values: &[f64]) -> Result<(), Refused> {
    if values.len() > 2 && is_mark(values[0], (values.len() - 1) as f64) {
        return Err(Refused::at(Spot::Line(line.number))
            .reads(line.excerpt())
            .and(", which is how many values follow")
            .help("put # before it, or it would be taken for the first"));
    }
    Ok(())
}
