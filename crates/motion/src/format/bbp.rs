//! SCEC Broadband Platform: comments after `#` name four columns, time and three components, on one line or one line each.
//!
//! The comments give the unit `cm/s` for velocities and, in some files, also for accelerations. Such files count as velocities unless the
//! caller states otherwise, and need a declared unit.

use super::said::Said;
use super::table::ComponentTable;
use super::title::{self, needed};
use super::{Component, Draft, File, Format, Reader, Scale, Stated};
use crate::line::Line;
use crate::refusals;
use crate::{FilePlace, Refused};

/// Time and three components.
const COLUMNS: usize = 4;

/// Words for the components, in capitals, and their names.
const WORDS: [(&str, &str); 9] = [
    ("NORTH-SOUTH", "NS"),
    ("EAST-WEST", "EW"),
    ("UP-DOWN", "UD"),
    ("N-S", "NS"),
    ("E-W", "EW"),
    ("U-D", "UD"),
    ("NS (", "NS"),
    ("EW (", "EW"),
    ("UD (", "UD"),
];

pub(super) const READER: Reader = Reader {
    format: Format::Bbp,
    recognises: |file| columns(file).is_some(),
    components: |file| Ok(components(file)),
    read,
    identity: |file| Said::new(comments(file), None).identity(),
};

/// One of the three components.
struct ComponentColumn<'t> {
    name: &'static str,
    line: Line<'t>,
    /// Text of the line about it.
    text: String,
}

fn comments<'l, 't>(file: &'l File<'t>) -> &'l [Line<'t>] {
    let comments = file.lines.iter().take_while(|line| line.is_comment());
    &file.lines[..comments.count()]
}

/// The three components named by the comments.
fn columns<'t>(file: &File<'t>) -> Option<Vec<ComponentColumn<'t>>> {
    let comments = comments(file);
    let together = comments
        .iter()
        .filter(|line| title::holds(**line, "TIME"))
        .map(|line| named_in(*line))
        .find(|columns| columns.len() == COLUMNS - 1);
    together.or_else(|| {
        let mut apart = Vec::new();
        for number in 1..=COLUMNS {
            let line = title::line_with(comments, &format!("COLUMN {number}:"))?;
            let mut named = named_in(line);
            match (number, named.pop()) {
                (1, None) if title::holds(line, "TIME") => {}
                (2.., Some(column)) if named.is_empty() => apart.push(column),
                _ => return None,
            }
        }
        Some(apart)
    })
}

/// The components that a line names, in the order of the line.
fn named_in(line: Line<'_>) -> Vec<ComponentColumn<'_>> {
    let text = line.text().to_ascii_uppercase();
    let mut found: Vec<(usize, &'static str)> = Vec::new();
    for (word, name) in WORDS {
        let is_new = found.iter().all(|(_, other)| *other != name);
        found.extend(text.find(word).filter(|_| is_new).map(|at| (at, name)));
    }
    found.sort_unstable();
    let ends = found.iter().skip(1).map(|(at, _)| *at);
    let ends: Vec<usize> = ends.chain([text.len()]).collect();
    let column = |(&(at, name), end): (&(usize, &'static str), usize)| ComponentColumn {
        name,
        line,
        text: text[at..end].to_owned(),
    };
    found.iter().zip(ends).map(column).collect()
}

fn components(file: &File<'_>) -> Vec<Component> {
    let component = |column: ComponentColumn<'_>| Component::new(column.name.to_owned(), FilePlace::Line(column.line.number));
    let columns = columns(file).unwrap_or_default();
    columns.into_iter().map(component).collect()
}

fn read(file: &File<'_>, index: usize) -> Result<Draft, Refused> {
    let comments = comments(file);
    let columns = columns(file).unwrap_or_default();
    let column = needed(columns.get(index), None, "names of its columns")?;
    let table = ComponentTable::new(column.line, &file.lines[comments.len()..], COLUMNS, Line::fields)?;
    let numbers = table.column(index + 1)?;
    let mut values = numbers.values;
    let (spacing, remark) = table.times()?.into_step_from_anywhere(&mut values)?;
    Ok(Draft {
        values,
        end: numbers.end,
        digit: numbers.digit,
        count: None,
        time_step: Some(spacing),
        scale: scale(column)?,
        peak: None,
        provenance: title::provenance(comments),
        remarks: remark.into_iter().collect(),
    })
}

fn scale(column: &ComponentColumn<'_>) -> Result<Scale, Refused> {
    let ComponentColumn { line, text, .. } = column;
    let place = FilePlace::Line(line.number);
    if title::unit_in(text).is_some() {
        return Ok(Scale::Unit(title::stated_unit(*line, text)?));
    }
    let unit: String = text.chars().filter(|letter| *letter != ' ').collect();
    if unit.contains("(CM)") || unit.contains("(M)") {
        return Err(refusals::not_acceleration(place, line.excerpt(), "the .acc.bbp file of the record"));
    }
    if unit.contains("CM/S") || unit.contains("M/S") || unit.contains("VELOCITY") {
        return Ok(Scale::Velocity(Stated {
            value: (),
            place,
            text: line.excerpt(),
        }));
    }
    Ok(if unit.contains("ACCELERATION") {
        Scale::Acceleration
    } else {
        Scale::Unknown
    })
}
